// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_FACET_TABLE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_FACET_TABLE_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flat_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Slot.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Facets of cells of a flat triangulation, by their vertices.
class Facet_table_3
{
public:
  static constexpr int none = -1;

  Facet_table_3(const Flat_triangulation_3& flat, const std::vector<Slot>& facets, std::size_t number_of_vertices)
    : has_facets_(number_of_vertices, false)
  {
    while(places_.size() < 2 * facets.size())
      places_.resize(2 * places_.size(), int(none));
    for(std::size_t n = 0; n < facets.size(); ++n)
    {
      facets_.push_back(flat.facet(facets[n]));
      for(int v : facets_.back())
        has_facets_[v] = true;
      std::size_t p = first_place(facets_.back());
      while(places_[p] != none)
        p = next_place(p);
      places_[p] = static_cast<int>(n);
    }
  }

  // The place among the facets of the one that has these vertices, in this order up to rotation, or `none`.
  int find(const std::array<int, 3>& facet) const
  {
    for(int v : facet)
      if(v < 0 || !has_facets_[v])
        return none;
    for(std::size_t p = first_place(facet); places_[p] != none; p = next_place(p))
      if(rotated(facets_[places_[p]]) == rotated(facet))
        return places_[p];
    return none;
  }

private:
  std::size_t first_place(const std::array<int, 3>& facet) const
  {
    std::uint64_t hash = 0;
    for(int v : sorted(facet))
      hash = (hash ^ static_cast<std::uint64_t>(v)) * 0x9e3779b97f4a7c15u;
    return static_cast<std::size_t>(hash >> 32) & (places_.size() - 1);
  }

  std::size_t next_place(std::size_t p) const { return (p + 1) & (places_.size() - 1); }

  std::vector<char> has_facets_;                    // of vertices
  std::vector<std::array<int, 3> > facets_;
  std::vector<int> places_ = std::vector<int>(16, none);
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_FACET_TABLE_3_H
