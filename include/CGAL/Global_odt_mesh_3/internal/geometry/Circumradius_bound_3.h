// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_CIRCUMRADIUS_BOUND_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_CIRCUMRADIUS_BOUND_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The square of the circumradius of a cell, infinite or not a number if it is flat. Weights do not count, as they do not for
// CGAL's criterion.
inline double squared_circumradius(const std::array<Site, 4>& s)
{
  const Eigen::Vector3d a = position(s[1]) - position(s[0]), b = position(s[2]) - position(s[0]), c = position(s[3]) - position(s[0]);
  const Eigen::Vector3d bc = b.cross(c);
  const double twice_determinant = 2 * a.dot(bc);
  const Eigen::Vector3d center = a.squaredNorm() * bc + b.squaredNorm() * c.cross(a) + c.squaredNorm() * a.cross(b);
  return center.squaredNorm() / (twice_determinant * twice_determinant);
}

// How large cells may be around each vertex, if there is a bound at all. A cell has the least bound of its vertices.
class Circumradius_bound_3
{
public:
  Circumradius_bound_3() {}
  explicit Circumradius_bound_3(std::vector<double> squared_radii) : squared_radii_(std::move(squared_radii)) {}

  // What a cell is too large by, to be added to what its angles lack, hence in square degrees.
  double deficit(const int* vertices, const std::array<Site, 4>& cell) const
  {
    if(squared_radii_.empty())
      return 0;
    double most = squared_radii_[vertices[0]];
    for(int i = 1; i < 4; ++i)
      most = (std::min)(most, squared_radii_[vertices[i]]);
    const double squared_radius = squared_circumradius(cell);
    if(!(squared_radius > most))
      return 0;
    const double excess = (std::min)(degrees * (std::sqrt(squared_radius / most) - 1), most_degrees);
    return excess * excess;
  }

private:
  // What a circumradius of twice the bound would count for. With 60, the largest cells are closer to the bound by one or two
  // percent, but more angles stay below 30 degrees; with 15, twice as many cells stay too large.
  static constexpr double degrees = 30;
  static constexpr double most_degrees = 10;    // flat cells lack angles already

  std::vector<double> squared_radii_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_CIRCUMRADIUS_BOUND_3_H
