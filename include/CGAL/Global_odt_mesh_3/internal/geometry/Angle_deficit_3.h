// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_ANGLE_DEFICIT_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_ANGLE_DEFICIT_3_H

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
    const Eigen::Vector3d a = position(s1) - position(s0), b = position(s2) - position(s0), c = position(s3) - position(s0);
    const Eigen::Vector3d n1 = c.cross(b), n2 = a.cross(c), n3 = b.cross(a);
    const std::array<Eigen::Vector3d, 4> normal = {{ -(n1 + n2 + n3), n1, n2, n3 }};   // outward
    std::array<double, 4> area;
    for(int i = 0; i < 4; ++i)
      area[i] = normal[i].norm();
    double deficit = 0;
    for(int i = 0; i < 3; ++i)
      for(int j = i + 1; j < 4; ++j)
      {
        const double scale = area[i] * area[j], cosine = -normal[i].dot(normal[j]);
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
