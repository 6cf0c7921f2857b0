// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_REPORT_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_REPORT_3_H

#include <Eigen/Core>

#include <map>
#include <set>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// What a check finds wrong with a candidate: the offending vertices, which are to go back toward
// where they were, and others that are to be pushed somewhere else.
template <class Candidate>
class Restricted_report_3
{
public:
  typedef Eigen::Vector3d Vector;

  explicit Restricted_report_3(const Candidate& candidate)
    : candidate_(candidate)
  {}

  // Whether nothing is wrong, not even something that no vertex can undo by going back.
  bool is_clean() const { return offending_vertices_.empty() && pushes_.empty() && !is_beyond_repair_; }
  bool is_beyond_repair() const { return is_beyond_repair_; }

  const std::set<int>& offending_vertices() const { return offending_vertices_; }
  const std::map<int, Vector>& pushes() const { return pushes_; }

  // Sends back those of the vertices that have moved; whether there are any.
  template <class Vertices>
  bool send_back_moved(const Vertices& vertices)
  {
    bool found = false;
    for(int v : vertices)
      if(candidate_.numbering.is_movable(v) && !candidate_.is_home(v))
      {
        offending_vertices_.insert(v);
        found = true;
      }
    return found;
  }

  // Sends back those of the vertices that have moved or, if there are none, those around them; there have to be some.
  template <class Vertices>
  void send_back(const Vertices& vertices)
  {
    if(!send_back_around(vertices))
      give_up();
  }

  // The same; whether there are any. Numbers below zero, of the infinite vertex, do not matter.
  template <class Vertices>
  bool send_back_around(const Vertices& vertices)
  {
    std::set<int> region(vertices.begin(), vertices.end());
    region.erase(-1);
    for(int ring = 0; ring < most_rings; ++ring)
    {
      if(send_back_moved(region))
        return true;
      candidate_.numbered->grow(region);
    }
    return false;
  }

  // Of several pushes, the longest.
  void push(int v, const Vector& by)
  {
    const auto p = pushes_.emplace(v, by);
    if(!p.second && by.squaredNorm() > p.first->second.squaredNorm())
      p.first->second = by;
  }

  void give_up() { is_beyond_repair_ = true; }

private:
  // Farther from where something is wrong, no vertex can have caused it.
  static constexpr int most_rings = 6;

  const Candidate& candidate_;
  std::set<int> offending_vertices_;
  std::map<int, Vector> pushes_;
  bool is_beyond_repair_ = false;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_REPORT_3_H
