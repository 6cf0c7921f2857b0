// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_PLACES_ON_SURFACE_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_PLACES_ON_SURFACE_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Where the domain has put vertices on their surfaces. As it knows these only up to an error, it would put a vertex elsewhere
// if it was asked again, and slivers that have just been removed would come back.
//
// Threads may keep places of different vertices at the same time.
class Places_on_surface
{
public:
  explicit Places_on_surface(int first_vertex = 0, int number_of_vertices = 0)
    : first_vertex_(first_vertex)
    , places_(number_of_vertices)
  {}

  void keep(int v, const Site& s) { places_[v - first_vertex_].push_back(s); }

  bool has(int v, const Site& s) const
  {
    const std::vector<Site>& places = places_[v - first_vertex_];
    return std::any_of(places.begin(), places.end(), [&s](const Site& place) { return same_place(place, s); });
  }

  void forget()
  {
    for(std::vector<Site>& places : places_)
      places.clear();
  }

private:
  int first_vertex_;
  std::vector<std::vector<Site> > places_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_PLACES_ON_SURFACE_H
