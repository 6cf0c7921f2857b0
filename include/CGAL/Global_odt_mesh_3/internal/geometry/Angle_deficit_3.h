// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_ANGLE_DEFICIT_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_ANGLE_DEFICIT_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// How much the dihedral angles of a cell fall short of a bound: the sum of the squares
// of what is missing, in degrees. Only cosines are computed for cells that lack nothing.
class Angle_deficit_3
{
public:
  explicit Angle_deficit_3(double bound)
    : bound_(bound)
    , cosine_(std::cos(bound * CGAL_PI / 180))
  {}

  double operator()(const Site& s0, const Site& s1, const Site& s2, const Site& s3) const
  {
    typedef std::array<double, 3> Vector;
    const auto minus = [](const Site& a, const Site& b) { return Vector{{ a.x - b.x, a.y - b.y, a.z - b.z }}; };
    const auto cross = [](const Vector& a, const Vector& b)
    { return Vector{{ a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] }}; };
    const auto dot = [](const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };

    const Vector a = minus(s1, s0), b = minus(s2, s0), c = minus(s3, s0);
    std::array<Vector, 4> normal = {{ {}, cross(c, b), cross(a, c), cross(b, a) }};   // outward
    std::array<double, 4> area;
    for(int i = 0; i < 3; ++i)
      normal[0][i] = -(normal[1][i] + normal[2][i] + normal[3][i]);
    for(int i = 0; i < 4; ++i)
      area[i] = std::sqrt(dot(normal[i], normal[i]));
    double deficit = 0;
    for(int i = 0; i < 3; ++i)
      for(int j = i + 1; j < 4; ++j)
      {
        const double scale = area[i] * area[j], cosine = -dot(normal[i], normal[j]);
        if(scale > 0 && cosine <= cosine_ * scale)
          continue;
        const double angle = scale > 0 ? std::acos((std::min)(1., cosine / scale)) * 180 / CGAL_PI : 0.;
        deficit += (bound_ - angle) * (bound_ - angle);
      }
    return deficit;
  }

private:
  double bound_, cosine_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_ANGLE_DEFICIT_3_H
