// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_SURFACE_ROUGHNESS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_SURFACE_ROUGHNESS_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_state_3.h>

#include <Eigen/Core>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Whether a bit along the tangential plane of a vertex the surface is far off.
inline bool is_off_surface_after_step(const Restricted_state_3& state, const Domain_view_3& domain, int v)
{
  constexpr double step_length = 0.2, most_tolerated = 0.05;      // over the shortest edge
  const Umbrella_shape& shape = state.boundary.shape(v, 0);
  const double step = step_length * shape.shortest_edge, tolerance = most_tolerated * shape.shortest_edge;
  const Eigen::Vector3d tangent = shape.toward - shape.normal.dot(shape.toward) * shape.normal;
  const Eigen::Vector3d from = position(state.sites[v]) + step * tangent.normalized();
  Eigen::Vector3d p = from;
  const int patch = state.boundary.complex().umbrella(v, 0).patch;
  const bool found = domain.project(p, shape.normal, 4 * tolerance, patch);
  return !found || (p - from).norm() > tolerance;
}

// Whether the surface is rough compared with the mesh, as that of an image is: so it is at many
// of some vertices.
inline bool is_surface_rough(const Restricted_state_3& state, const Domain_view_3& domain)
{
  constexpr int probes = 200;
  constexpr double most_off = 0.1;
  const int first = state.numbering->number_of_interior_vertices, last = state.numbering->number_of_movable_vertices;
  const int stride = 1 + (last - first) / probes;
  int probed = 0, off = 0;
  for(int v = first; v < last; v += stride, ++probed)
    off += is_off_surface_after_step(state, domain, v);
  return off > most_off * probed;
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_SURFACE_ROUGHNESS_3_H
