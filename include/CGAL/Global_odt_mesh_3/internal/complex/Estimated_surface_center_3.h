// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_ESTIMATED_SURFACE_CENTER_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_ESTIMATED_SURFACE_CENTER_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Where the dual line meets the surface of which the normals at the vertices are
// known: on a sphere, and so in second order, half as high over the facet as the
// tangential planes at the vertices.
inline Eigen::Vector3d estimated_surface_center(const std::array<int, 3>& t, const Boundary_geometry_3& boundary,
                                                const std::vector<Site>& sites)
{
  const Facet_dual_3 dual(t, sites);
  double height = 0;
  int count = 0;
  for(int v : t)
  {
    if(boundary.complex().number_of_umbrellas(v) != 1)
      continue;
    const Eigen::Vector3d& n = boundary.shape(v, 0).normal;
    const double cosine = n.dot(dual.normal);
    if(std::abs(cosine) < Boundary_geometry_3::smallest_cosine)
      continue;
    height += n.dot(position(sites[v]) - dual.center) / (2 * cosine);
    ++count;
  }
  if(count > 0)
    height /= count;
  return dual.point_at((std::max)(-dual.radius, (std::min)(dual.radius, height)));
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_ESTIMATED_SURFACE_CENTER_3_H
