// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_ANGLE_STEP_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_ANGLE_STEP_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <array>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The displacement of a vertex that would give the cells around it what their angles lack, in first order and as far
// as one vertex can: the step of Gauss and Newton, damped.
class Angle_step_3
{
public:
  // Unless the normal is zero, the vertex moves in the plane normal to it.
  explicit Angle_step_3(const Angle_deficit_3& deficit, const Eigen::Vector3d& normal = Eigen::Vector3d::Zero())
    : deficit_(deficit)
    , normal_(normal)
  {}

  // Adds a cell, of which the vertex is number m.
  void add(const std::array<Site, 4>& cell, int m)
  {
    deficit_.for_each_gradient(cell, m, [this](double lack, const Eigen::Vector3d& gradient)
    {
      const Eigen::Vector3d g = gradient - normal_.dot(gradient) * normal_;
      normal_equations_ += g * g.transpose();
      right_side_ += lack * g;
    });
  }

  // At most of this length.
  Eigen::Vector3d displacement(double longest) const
  {
    Eigen::Matrix3d damped = normal_equations_;
    damped.diagonal().array() += damping * normal_equations_.trace();
    const Eigen::Vector3d step = damped.ldlt().solve(right_side_);
    if(!step.allFinite())
      return Eigen::Vector3d::Zero();
    const double length = step.norm();
    return length > longest ? Eigen::Vector3d(longest / length * step) : step;
  }

private:
  static constexpr double damping = 1e-2;

  const Angle_deficit_3& deficit_;
  Eigen::Vector3d normal_;
  Eigen::Matrix3d normal_equations_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_side_ = Eigen::Vector3d::Zero();
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_ANGLE_STEP_3_H
