// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_FACET_GEOMETRY_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_FACET_GEOMETRY_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The dual line of a facet: through the weighted circumcenter, along the normal,
// which points to side 1.
struct Facet_dual_3
{
  Eigen::Vector3d center, normal;
  double radius;

  // With the edges a, b from s0, their lifted heights h_a, h_b and n = a x b, the
  // center is s0 + (h_a (b x n) + h_b (n x a)) / (2 |n|^2).
  Facet_dual_3(const Triple& t, const std::vector<Site>& sites)
    : Facet_dual_3(std::array<Site, 3>{{ sites[t[0]], sites[t[1]], sites[t[2]] }})
  {}

  explicit Facet_dual_3(const std::array<Site, 3>& s)
  {
    const Site &s0 = s[0], &s1 = s[1], &s2 = s[2];
    const Eigen::Vector3d a = position(s1) - position(s0), b = position(s2) - position(s0), n = a.cross(b);
    const double ha = a.squaredNorm() - s1.weight + s0.weight;
    const double hb = b.squaredNorm() - s2.weight + s0.weight;
    const Eigen::Vector3d d = (ha * b.cross(n) + hb * n.cross(a)) / (2 * n.squaredNorm());
    center = position(s0) + d;
    normal = n / n.norm();
    radius = d.norm();
  }

  // The signed height of a point over the plane of the facet, positive on side 1.
  double height(const Eigen::Vector3d& p) const { return normal.dot(p - center); }

  Eigen::Vector3d point_at(double height) const { return center + height * normal; }
};

inline Eigen::Vector3d centroid(const std::array<Site, 3>& s) { return (position(s[0]) + position(s[1]) + position(s[2])) / 3; }

inline Eigen::Vector3d centroid(const Triple& t, const std::vector<Site>& s)
{ return centroid(std::array<Site, 3>{{ s[t[0]], s[t[1]], s[t[2]] }}); }

inline double squared_distance(const Site& s, const Eigen::Vector3d& p) { return (position(s) - p).squaredNorm(); }

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

inline double smallest_angle_of_facet(const Triple& t, const std::vector<Site>& sites)
{
  return smallest_angle_of_facet({{ sites[t[0]], sites[t[1]], sites[t[2]] }});
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_FACET_GEOMETRY_3_H
