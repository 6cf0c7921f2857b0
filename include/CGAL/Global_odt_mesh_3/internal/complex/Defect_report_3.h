// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_DEFECT_REPORT_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_DEFECT_REPORT_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Working_triangulation_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// What a check finds wrong with a candidate: the offending vertices, which are to go back toward
// where they were, and others that are to be pushed somewhere else.
class Defect_report_3
{
public:
  explicit Defect_report_3(const Complex_candidate_3& candidate)
    : candidate_(candidate)
  {}

  // Whether nothing is wrong, not even something that no vertex can undo by going back.
  bool is_clean() const { return offending_vertices_.empty() && pushes_.empty() && !is_beyond_repair_; }
  bool is_beyond_repair() const { return is_beyond_repair_; }

  const std::set<int>& offending_vertices() const { return offending_vertices_; }
  const std::map<int, Eigen::Vector3d>& pushes() const { return pushes_; }

  // Sends back those of the vertices that have not reverted or, if there are none, those around them. If there are none
  // either, what is wrong was so before, where less was asked for; then those revert to the input that are elsewhere than
  // there, of which nothing more can be asked.
  template <class Vertices>
  void send_back(const Vertices& vertices)
  {
    if(!send_back_around(vertices)
       && !send_back_nearest(vertices, most_rings_to_input, [this](int v) { return !candidate_.is_at_input(v); }))
      give_up();
  }

  // Those only that have not reverted, or else those around them; whether there are any. Numbers below zero, of the infinite
  // vertex, do not matter.
  template <class Vertices>
  bool send_back_around(const Vertices& vertices)
  {
    return send_back_nearest(vertices, most_rings, [this](int v) { return !candidate_.is_reverted(v); });
  }

  // Of several pushes, the longest.
  void push(int v, const Eigen::Vector3d& by)
  {
    const auto p = pushes_.emplace(v, by);
    if(!p.second && by.squaredNorm() > p.first->second.squaredNorm())
      p.first->second = by;
  }

  void give_up() { is_beyond_repair_ = true; }

  // What is found later may come of what is wrong already; so it is not beyond repair unless all else is well.
  void add(const Defect_report_3& later)
  {
    is_beyond_repair_ = is_beyond_repair_ || (is_clean() && later.is_beyond_repair_);
    offending_vertices_.insert(later.offending_vertices_.begin(), later.offending_vertices_.end());
    for(const auto& p : later.pushes_)
      push(p.first, p.second);
  }

private:
  // A cell or facet comes where a vertex that it has, or one beside it, has moved; farther away, none can be the cause.
  static constexpr int most_rings = 3;
  // Positions of the input among others may be wrong where the input as a whole is not.
  static constexpr int most_rings_to_input = 6;

  // Sends back those movable vertices that satisfy the predicate in the first ring around some that has any.
  template <class Vertices, class Predicate>
  bool send_back_nearest(const Vertices& vertices, int rings, const Predicate& goes_back)
  {
    Vertex_rings_3 region(candidate_.working, vertices);
    for(int ring = 0; ring < rings; ++ring, region.grow())
    {
      bool found = false;
      for(std::size_t n = region.begin_of_last_ring(); n < region.vertices().size(); ++n)
      {
        const int v = region.vertices()[n];
        if(!candidate_.numbering.is_movable(v) || !goes_back(v))
          continue;
        offending_vertices_.insert(v);
        found = true;
      }
      if(found)
        return true;
    }
    return false;
  }

  const Complex_candidate_3& candidate_;
  std::set<int> offending_vertices_;
  std::map<int, Eigen::Vector3d> pushes_;
  bool is_beyond_repair_ = false;
};

// The direction away from the boundary into the subdomain, as the normals at the vertices of a cell
// tell, and the longest of the shortest edges there.
inline Eigen::Vector3d inward(const Complex_candidate_3& candidate, const Quadruple& q, int label, double& edge)
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
inline void report_cell_beyond_surface(const Complex_candidate_3& candidate, const Quadruple& q, int label,
                                       Defect_report_3& report)
{
  constexpr double step_from_boundary = 0.05;       // over an edge on the boundary
  constexpr int most_pushes = 5, most_returns = 2;
  const auto may_go_back = [&](int v)
  {
    return candidate.numbering.is_movable(v) && !candidate.is_reverted(v) && candidate.times_sent_back(v) < most_returns;
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

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_DEFECT_REPORT_3_H
