// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_CELL_SHAPE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_CELL_SHAPE_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_products_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <CGAL/number_utils.h>

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
    const std::array<const Site*, 4> s = {{ &s0, &s1, &s2, &s3 }};
    typedef std::array<double, 3> Vector;
    const auto minus = [](const Site& a, const Site& b) { return Vector{{ a.x - b.x, a.y - b.y, a.z - b.z }}; };
    const auto cross = [](const Vector& a, const Vector& b)
    { return Vector{{ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] }}; };
    const auto dot = [](const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };

    // Inward normals of the facets opposite to each vertex; their lengths are
    // twice the areas.
    std::array<Vector, 4> normal;
    double area = 0;
    for(int i = 0; i < 4; ++i)
    {
      const Site& a = *s[(i + 1) % 4];
      normal[i] = cross(minus(*s[(i + 2) % 4], a), minus(*s[(i + 3) % 4], a));
      if(i % 2 == 0)
        for(double& x : normal[i])
          x = -x;
      area += std::sqrt(dot(normal[i], normal[i])) / 2;
    }
    int n = 0;
    for(int i = 0; i < 3; ++i)
      for(int j = i + 1; j < 4; ++j)
      {
        const Vector c = cross(normal[i], normal[j]);
        // The angle between the facets is the supplement of that of the normals.
        angles[n++] = std::atan2(std::sqrt(dot(c, c)), -dot(normal[i], normal[j])) * 180 / CGAL_PI;
      }
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
