// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SURFACE_PROJECTION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SURFACE_PROJECTION_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Moves a vertex of a candidate to the surface that it moves on; false if there is no such point nearby.
inline bool put_on_surface(Complex_candidate_3& candidate, const Domain_view_3& domain, int v)
{
  constexpr double farthest_projection = 1;       // over the shortest edge
  const Boundary_geometry_3& boundary = candidate.measured_boundary;
  const Umbrella_shape& shape = boundary.shape(v, 0);
  Site& s = candidate.sites[v];
  Eigen::Vector3d p = position(s);
  if(!domain.project(p, shape.normal, farthest_projection * shape.shortest_edge, boundary.complex().umbrella(v, 0).patch))
    return false;
  s = site_at(p, s.weight);
  return true;
}

// The same for all vertices that have moved on surfaces; those for which that fails go back.
inline void put_on_surfaces(Complex_candidate_3& candidate, const Domain_view_3& domain)
{
  domain.for_each(candidate.numbering.number_of_surface_vertices(), [&](int n)
  {
    const int v = candidate.numbering.number_of_interior_vertices + n;
    if(!candidate.is_reverted(v) && !put_on_surface(candidate, domain, v))
      candidate.sites[v] = candidate.revert_sites[v];
  });
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SURFACE_PROJECTION_3_H
