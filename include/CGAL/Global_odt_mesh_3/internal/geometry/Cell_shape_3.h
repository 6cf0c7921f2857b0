// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_CELL_SHAPE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_CELL_SHAPE_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_products_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The six dihedral angles, in degrees, and 3 r / R of a tetrahedron.
struct Cell_shape_3
{
  std::array<double, 6> angles;     // between the facets opposite to vertices 01, 02, 03, 12, 13, 23
  double radius_ratio;

  Cell_shape_3(const Site& s0, const Site& s1, const Site& s2, const Site& s3)
  {
    const std::array<Eigen::Vector3d, 4> s = {{ position(s0), position(s1), position(s2), position(s3) }};
    // Inward normals of the facets opposite to each vertex; their lengths are
    // twice the areas.
    std::array<Eigen::Vector3d, 4> normal;
    double area = 0;
    for(int i = 0; i < 4; ++i)
    {
      const Eigen::Vector3d& a = s[(i + 1) % 4];
      normal[i] = (i % 2 == 0 ? -1. : 1.) * (s[(i + 2) % 4] - a).cross(s[(i + 3) % 4] - a);
      area += normal[i].norm() / 2;
    }
    int n = 0;
    for(int i = 0; i < 3; ++i)
      for(int j = i + 1; j < 4; ++j)
        // The angle between the facets is the supplement of that of the normals.
        angles[n++] = std::atan2(normal[i].cross(normal[j]).norm(), -normal[i].dot(normal[j])) * 180 / CGAL_PI;
    // r = 3 V / area; R = |N| / (2 det) of the unweighted sites.
    const auto unweighted = [](Site p) { p.weight = 0; return p; };
    const Cell_products t(unweighted(s0), unweighted(s1), unweighted(s2), unweighted(s3));
    const double numerator = std::sqrt(t.nx * t.nx + t.ny * t.ny + t.nz * t.nz);
    radius_ratio = numerator > 0 && area > 0
                 ? (std::min)(1., 3 * t.determinant * t.determinant / (area * numerator)) : 0.;
  }
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_CELL_SHAPE_3_H
