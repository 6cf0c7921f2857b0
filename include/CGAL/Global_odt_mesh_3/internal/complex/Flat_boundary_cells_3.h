// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_FLAT_BOUNDARY_CELLS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_FLAT_BOUNDARY_CELLS_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Boundary_extraction_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Candidate_checks_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Exact_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Surface_centers_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Flat cells on the boundary that may as well be on its other side.
//
// A sliver with two facets on the boundary stems from four vertices in nearly one plane and on one circle. Its two other
// facets could take the place of those if they are good, and if their dual lines meet the surface.
class Flat_boundary_cells_3
{
public:
  static constexpr int no_subdomain = Complex_snapshot_3::no_subdomain;

  Flat_boundary_cells_3(Complex_candidate_3& candidate, const Domain_view_3& domain, const Facet_bounds_3& bounds)
    : candidate_(candidate)
    , bounds_(bounds)
    , centers_(candidate, domain)
  {}

  // The label beyond both boundary facets of such a cell, or no_subdomain if it is none.
  int label_beyond(Cell_handle c, int label)
  {
    if(label == Domain_view_3::outside)
      return no_subdomain;
    std::array<int, 4> facet;
    int count = 0;
    for(int i = 0; i < 4; ++i)
      if(c->neighbor(i)->label() != c->label())
        facet[count++] = i;
    if(count != 2 || c->neighbor(facet[0])->label() != c->neighbor(facet[1])->label())
      return no_subdomain;
    const Quadruple q = candidate_.numbers(c);
    const Cell_shape_3 shape(candidate_.sites[q[0]], candidate_.sites[q[1]], candidate_.sites[q[2]], candidate_.sites[q[3]]);
    const double between = shape.angles[facet[0] == 0 ? facet[1] - 1 : facet[0] + facet[1]];
    if(between < 180 - flat_angle || *std::min_element(shape.angles.begin(), shape.angles.end()) > sliver_angle)
      return no_subdomain;
    for(int i = 0; i < 4; ++i)
    {
      const std::array<int, 3> t = {{ q[(i + 1) % 4], q[(i + 2) % 4], q[(i + 3) % 4] }};
      if(i == facet[0] || i == facet[1])
        continue;
      if(!bounds_.permit(candidate_, t) || !has_surface_center(Facet(c, i)))
        return no_subdomain;
    }
    return c->neighbor(facet[0])->label();
  }

  // Spares the boundary facets of these cells the checks of facets.
  void exempt()
  {
    candidate_.exempt_facets.clear();
    for(const auto& c : candidate_.boundary_cells)
      if(label_beyond(c.first, c.second) != no_subdomain)
        for(int i = 0; i < 4; ++i)
          if(c.first->neighbor(i)->label() != c.first->label())
            candidate_.exempt_facets.insert(sorted(candidate_.working.vertices(Facet(c.first, i))));
  }

private:
  static constexpr double sliver_angle = 20, flat_angle = 35; // degrees

  bool has_surface_center(Facet f)
  {
    if(!candidate_.working.is_first_side(f))
      f = candidate_.triangulation().mirror_facet(f);
    const std::array<int, 3> t = candidate_.working.vertices(f);
    Complex_candidate_3::Surface_center center;
    center.point = estimated_surface_center(t, candidate_.measured_boundary, candidate_.sites);
    return centers_.find_center(f, t, center);
  }

  Complex_candidate_3& candidate_;
  const Facet_bounds_3& bounds_;
  Candidate_center_search_3 centers_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_FLAT_BOUNDARY_CELLS_3_H
