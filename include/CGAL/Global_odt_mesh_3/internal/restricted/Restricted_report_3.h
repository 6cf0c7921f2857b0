// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_REPORT_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_REPORT_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Split_mix_engine.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
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

  // Sends back those of the vertices that have moved or, if there are none, those around them. If there are none
  // either, what is wrong was so before, where less was asked for: then the vertices are nudged.
  template <class Vertices>
  void send_back(const Vertices& vertices)
  {
    if(!send_back_around(vertices) && !nudge_around(vertices))
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
  static constexpr double length_of_nudge = 0.1;        // over the shortest edge
  static constexpr int most_nudges = 6;

  // Nudges the movable ones among the vertices or, if there are none, around them; whether there are any that may still be.
  template <class Vertices>
  bool nudge_around(const Vertices& vertices)
  {
    std::set<int> region(vertices.begin(), vertices.end());
    region.erase(-1);
    for(int ring = 0; ring < most_rings; ++ring)
    {
      bool found = false;
      for(int v : region)
        if(candidate_.numbering.is_movable(v) && candidate_.numbered->is_visible(v)
           && candidate_.times_pushed(v) < most_nudges)
        {
          nudge(v);
          found = true;
        }
      if(found)
        return true;
      candidate_.numbered->grow(region);
    }
    return false;
  }

  // Pushes a vertex in a random direction, another one each time.
  void nudge(int v)
  {
    std::set<int> neighbors = { v };
    candidate_.numbered->grow(neighbors);
    neighbors.erase(v);
    double shortest = (std::numeric_limits<double>::max)();
    for(int w : neighbors)
      shortest = (std::min)(shortest, (position(candidate_.sites[w]) - position(candidate_.sites[v])).squaredNorm());
    const int times = candidate_.times_pushed(v);
    Random_numbers<Split_mix_engine> random(Split_mix_engine(static_cast<std::uint64_t>(v), times));
    push(v, length_of_nudge * std::sqrt(shortest) * random.direction());
  }

  const Candidate& candidate_;
  std::set<int> offending_vertices_;
  std::map<int, Vector> pushes_;
  bool is_beyond_repair_ = false;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_REPORT_3_H
