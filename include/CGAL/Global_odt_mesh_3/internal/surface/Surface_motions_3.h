// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_SURFACE_MOTIONS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_SURFACE_MOTIONS_3_H

#include <CGAL/Global_odt_mesh_3/internal/optimization/Tangential_motion.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>

#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// How the vertices on surfaces may move from where they are: in the plane normal to their umbrella, as far as
// `farthest`, over the shortest edge there. Those where the surface bends sharply stay.
inline std::vector<Tangential_motion> tangential_motions(const Constrained_triangulation_3& mesh,
                                                         const Boundary_geometry_3& boundary, double farthest)
{
  std::vector<Tangential_motion> motions;
  for(int v = mesh.number_of_interior_vertices; v < mesh.number_of_movable_vertices; ++v)
  {
    const Umbrella_shape& shape = boundary.shape(v, 0);
    motions.push_back({ shape.normal, shape.is_smooth ? farthest * shape.shortest_edge : 0., mesh.sites[v] });
  }
  return motions;
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_SURFACE_MOTIONS_3_H
