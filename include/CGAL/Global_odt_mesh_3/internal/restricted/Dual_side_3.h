// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_DUAL_SIDE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_DUAL_SIDE_3_H

#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_report_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The direction away from the boundary into the subdomain, as the normals at the vertices of a cell
// tell, and the longest of the shortest edges there.
inline Eigen::Vector3d inward(const Restricted_candidate_3& candidate, const Quadruple& q, int label, double& edge)
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  edge = 0;
  const Boundary_geometry_3& boundary = candidate.measured_boundary;
  for(int w : q)
    for(int n = 0; n < boundary.complex().number_of_umbrellas(w); ++n)
    {
      const std::array<int, 2>& labels = boundary.complex().umbrella(w, n).labels;
      const Umbrella_shape& shape = boundary.shape(w, n);
      const double sign = labels[0] == label ? -1 : labels[1] == label ? 1 : 0;
      sum += sign * shape.normal;
      edge = (std::max)(edge, shape.shortest_edge);
    }
  return sum;
}

// Of a cell of the subdomain `label` whose dual point is beyond the surface: its vertices have come too close to
// the boundary, or else its vertex of the interior is to move away from it.
inline void report_cell_beyond_surface(const Restricted_candidate_3& candidate, const Quadruple& q, int label,
                                Restricted_report_3& report)
{
  constexpr double step_from_boundary = 0.05;       // over an edge on the boundary
  constexpr int most_pushes = 5, most_returns = 2;
  const auto may_go_back = [&](int v)
  {
    return candidate.numbering.is_movable(v) && !candidate.is_home(v) && candidate.times_sent_back(v) < most_returns;
  };
  const auto v = std::find_if(q.begin(), q.end(), [&](int w) { return candidate.numbering.is_interior(w); });
  double edge = 0;
  Eigen::Vector3d by = Eigen::Vector3d::Zero();
  if(v != q.end() && std::none_of(q.begin(), q.end(), may_go_back) && candidate.times_pushed(*v) < most_pushes)
    by = inward(candidate, q, label, edge);
  const double length = by.norm();
  if(!(length > 0))
  {
    report.send_back(q);
    return;
  }
  // The more often, the farther.
  const double step = step_from_boundary * edge * (1 + candidate.times_pushed(*v));
  report.push(*v, step / length * by);
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_DUAL_SIDE_3_H
