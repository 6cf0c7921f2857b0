// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_FACET_DUAL_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_FACET_DUAL_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The dual line of a facet: through the weighted circumcenter, along the normal,
// which points to side 1.
struct Facet_dual_3
{
  typedef std::array<double, 3> Vector;
  typedef std::array<int, 3> Triple;

  Vector center, normal;
  double radius;

  // With the edges a, b from s0, their lifted heights h_a, h_b and n = a x b, the
  // center is s0 + (h_a (b x n) + h_b (n x a)) / (2 |n|^2).
  Facet_dual_3(const Triple& t, const std::vector<Site>& sites)
  {
    const Site& s0 = sites[t[0]];
    const Site& s1 = sites[t[1]];
    const Site& s2 = sites[t[2]];
    const double ax = s1.x - s0.x, ay = s1.y - s0.y, az = s1.z - s0.z;
    const double bx = s2.x - s0.x, by = s2.y - s0.y, bz = s2.z - s0.z;
    const double nx = ay * bz - az * by, ny = az * bx - ax * bz, nz = ax * by - ay * bx;
    const double ha = ax * ax + ay * ay + az * az - s1.weight + s0.weight;
    const double hb = bx * bx + by * by + bz * bz - s2.weight + s0.weight;
    const double nn = nx * nx + ny * ny + nz * nz, length = std::sqrt(nn);
    const Vector d = {{ (ha * (by * nz - bz * ny) + hb * (ny * az - nz * ay)) / (2 * nn),
                        (ha * (bz * nx - bx * nz) + hb * (nz * ax - nx * az)) / (2 * nn),
                        (ha * (bx * ny - by * nx) + hb * (nx * ay - ny * ax)) / (2 * nn) }};
    center = {{ s0.x + d[0], s0.y + d[1], s0.z + d[2] }};
    normal = {{ nx / length, ny / length, nz / length }};
    radius = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  }

  // The signed height of a point over the plane of the facet, positive on side 1.
  double height(const Vector& p) const
  {
    return normal[0] * (p[0] - center[0]) + normal[1] * (p[1] - center[1]) + normal[2] * (p[2] - center[2]);
  }

  Vector point_at(double height) const
  {
    return {{ center[0] + height * normal[0], center[1] + height * normal[1], center[2] + height * normal[2] }};
  }
};

inline std::array<double, 3> centroid(const std::array<int, 3>& t, const std::vector<Site>& s)
{
  return {{ (s[t[0]].x + s[t[1]].x + s[t[2]].x) / 3, (s[t[0]].y + s[t[1]].y + s[t[2]].y) / 3,
            (s[t[0]].z + s[t[1]].z + s[t[2]].z) / 3 }};
}

inline double squared_distance(const Site& s, const std::array<double, 3>& p)
{
  return (s.x - p[0]) * (s.x - p[0]) + (s.y - p[1]) * (s.y - p[1]) + (s.z - p[2]) * (s.z - p[2]);
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_FACET_DUAL_3_H
