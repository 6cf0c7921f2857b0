// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_TANGENTIAL_MOTION_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_TANGENTIAL_MOTION_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <Eigen/Core>

#include <array>
#include <cmath>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// How a vertex moves on a surface: in the tangential plane through where it is
// when the motion begins, within a disk. Without radius, it stays.
struct Tangential_motion
{
  std::array<double, 3> normal;
  double radius;
  Site center;

  bool is_at_rest() const { return !(radius > 0); }

  void hold_in_disk(Site& s) const
  {
    const double x = s.x - center.x, y = s.y - center.y, z = s.z - center.z;
    const double d = std::sqrt(x * x + y * y + z * z);
    if(d <= radius)
      return;
    const double f = radius / d;
    s = { center.x + f * x, center.y + f * y, center.z + f * z, s.weight };
  }

  Eigen::Vector3d tangential_part(const Eigen::Vector3d& g) const
  {
    const Eigen::Map<const Eigen::Vector3d> n(normal.data());
    return g - n.dot(g) * n;
  }
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_TANGENTIAL_MOTION_H
