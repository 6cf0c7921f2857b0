// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_POINT_COORDINATES_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_POINT_COORDINATES_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// CGAL's points in double coordinates.
template <class Point>
Eigen::Vector3d coordinates(const Point& p)
{
  return Eigen::Vector3d(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

template <class Weighted_point>
Site weighted_site(const Weighted_point& p)
{
  return { CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()), CGAL::to_double(p.weight()) };
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_POINT_COORDINATES_H
