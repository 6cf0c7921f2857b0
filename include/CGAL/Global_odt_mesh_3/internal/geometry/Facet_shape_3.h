// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_FACET_SHAPE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_FACET_SHAPE_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// In degrees.
inline double smallest_angle_of_facet(const std::array<Site, 3>& s)
{
  double smallest = 180;
  for(std::size_t i = 0; i < 3; ++i)
  {
    const Eigen::Vector3d a = position(s[(i + 1) % 3]) - position(s[i]);
    const Eigen::Vector3d b = position(s[(i + 2) % 3]) - position(s[i]);
    smallest = (std::min)(smallest, std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / CGAL_PI);
  }
  return smallest;
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_FACET_SHAPE_3_H
