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
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Labelled_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Some vertices of a triangulation, by their numbers, then their neighbors, and so on, ring by ring.
class Vertex_rings_3
{
public:
  // Numbers below zero, of the infinite vertex, do not matter.
  template <class Vertices>
  Vertex_rings_3(const Labelled_triangulation_3& triangulation, const Vertices& vertices)
    : triangulation_(triangulation)
  {
    for(int v : vertices)
      if(v >= 0)
        add(v);
  }

  // All vertices; those of the last ring are the last ones.
  const std::vector<int>& vertices() const { return vertices_; }
  std::size_t begin_of_last_ring() const { return begin_; }

  // Adds the neighbors of those that have been added last.
  void grow()
  {
    const std::size_t begin = std::exchange(begin_, vertices_.size());
    for(std::size_t n = begin; n < begin_; ++n)
      for(int w : triangulation_.neighbors(vertices_[n]))
        add(w);
  }

private:
  void add(int v)
  {
    if(known_.insert(v).second)
      vertices_.push_back(v);
  }

  const Labelled_triangulation_3& triangulation_;
  std::vector<int> vertices_;
  std::size_t begin_ = 0;               // of the last ring
  std::unordered_set<int> known_;
};

// What a check finds wrong with a candidate: the offending vertices, which are to go back toward where they were.
class Defect_report_3
{
public:
  explicit Defect_report_3(const Complex_candidate_3& candidate)
    : candidate_(candidate)
  {}

  // Whether nothing is wrong, not even something that no vertex can undo by going back.
  bool is_clean() const { return offending_vertices_.empty() && retreats_.empty() && weights_.empty() && !is_beyond_repair_; }
  bool is_beyond_repair() const { return is_beyond_repair_; }

  const std::set<int>& offending_vertices() const { return offending_vertices_; }

  // Reverts those of the vertices that have not reverted or, if there are none, those around them. If there are none
  // either, what is wrong was so before, where less was asked for; then those revert to the input that are elsewhere than
  // there, of which nothing more can be asked.
  template <class Vertices>
  void revert(const Vertices& vertices)
  {
    // Where much cannot be mended, the rest need not be searched for what could have caused it.
    const bool is_in_vain = !candidate_.has_way_back || obstacles_.size() > most_obstacles;
    if(is_in_vain && candidate_.has_way_back && revert_nearest(vertices, 1, [this](int v) { return !candidate_.is_reverted(v); }))
      return;
    if(is_in_vain
       || (!revert_around(vertices)
           && !revert_nearest(vertices, most_rings_to_input, [this](int v) { return !candidate_.is_at_input(v); })))
    {
      obstacles_.insert(vertices.begin(), vertices.end());
      give_up();
    }
  }

  // The same for vertices that are too close to a point. As long as they may, those of the interior retreat from it instead, by a
  // share of the way between or, if a flat cell has its dual point far away, of the way to the farthest of the others.
  template <class Vertices>
  void revert_or_retreat(const Vertices& vertices, const Vector_3& from)
  {
    constexpr double share = 0.1;
    bool is_found = false;
    for(int v : vertices)
      if(candidate_.may_retreat && v >= 0 && candidate_.numbering.is_interior(v))
      {
        const Vector_3 way = position(candidate_.sites[v]) - from;
        const double length = way.length(), longest = (std::min)(length, farthest(vertices, v));
        if(length > 0)
          add_retreat(v, share * longest / length * way);
        is_found = true;
      }
    if(!is_found)
      revert(vertices);
  }

  // The displacements of the vertices that retreat.
  const std::map<int, Vector_3>& retreats() const { return retreats_; }

  // For vertices that stay.
  void add_weights(const std::map<int, double>& weights) { weights_.insert(weights.begin(), weights.end()); }
  const std::map<int, double>& weights() const { return weights_; }

  // Those only that have not reverted, or else those around them; whether there are any. Numbers below zero, of the infinite
  // vertex, do not matter.
  template <class Vertices>
  bool revert_around(const Vertices& vertices)
  {
    return revert_nearest(vertices, most_rings, [this](int v) { return !candidate_.is_reverted(v); });
  }

  void give_up() { is_beyond_repair_ = true; }

  // The vertices of what is wrong and cannot be mended.
  const std::set<int>& obstacles() const { return obstacles_; }

  // What is found later may come of what is wrong already; so it is not beyond repair unless all else is well.
  void add(const Defect_report_3& later)
  {
    is_beyond_repair_ = is_beyond_repair_ || (is_clean() && later.is_beyond_repair_);
    obstacles_.insert(later.obstacles_.begin(), later.obstacles_.end());
    offending_vertices_.insert(later.offending_vertices_.begin(), later.offending_vertices_.end());
    for(const auto& r : later.retreats_)
      add_retreat(r.first, r.second);
    add_weights(later.weights_);
  }

private:
  // A cell or facet comes where a vertex that it has, or one beside it, has moved; farther away, none can be the cause.
  static constexpr int most_rings = 3;
  static constexpr std::size_t most_obstacles = 100;
  // Positions of the input among others may be wrong where the input as a whole is not.
  static constexpr int most_rings_to_input = 6;

  // The longest counts, in whatever order they come.
  void add_retreat(int v, const Vector_3& way)
  {
    const auto key = [](const Vector_3& w) { return std::make_tuple(w.squared_length(), w[0], w[1], w[2]); };
    Vector_3& longest = retreats_[v];
    if(key(longest) < key(way))
      longest = way;
  }

  template <class Vertices>
  double farthest(const Vertices& vertices, int v) const
  {
    double squared = 0;
    for(int w : vertices)
      if(w >= 0)
        squared = (std::max)(squared, squared_distance(candidate_.sites[w], position(candidate_.sites[v])));
    return squared > 0 ? std::sqrt(squared) : (std::numeric_limits<double>::max)();
  }

  // Reverts those movable vertices that satisfy the predicate in the first ring around some that has any.
  template <class Vertices, class Predicate>
  bool revert_nearest(const Vertices& vertices, int rings, const Predicate& goes_back)
  {
    Vertex_rings_3 region(candidate_.triangulation, vertices);
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
  std::set<int> offending_vertices_, obstacles_;
  std::map<int, Vector_3> retreats_;
  std::map<int, double> weights_;           // that are added
  bool is_beyond_repair_ = false;
};

// Moves a vertex of a candidate to the surface that it moves on; false if there is no such point nearby.
inline bool put_on_surface(Complex_candidate_3& candidate, const Domain_view_3& domain, int v)
{
  constexpr double farthest_projection = 1;       // over the shortest edge
  const Boundary_geometry_3& boundary = candidate.measured_boundary;
  const Umbrella_shape& shape = boundary.shape(v, 0);
  Site& s = candidate.sites[v];
  Vector_3 p = position(s);
  if(!domain.project(p, shape.normal, farthest_projection * shape.shortest_edge, boundary.complex().umbrella(v, 0).patch))
    return false;
  s = site_at(p, s.weight);
  return true;
}

// The same for all vertices that have moved on surfaces; those for which that fails go back.
inline void put_on_surfaces(Complex_candidate_3& candidate, const Domain_view_3& domain)
{
  domain.for_each(candidate.numbering.number_of_surface_vertices(), [&](int n)
  {
    const int v = candidate.numbering.number_of_interior_vertices + n;
    if(!candidate.is_reverted(v) && !put_on_surface(candidate, domain, v))
      candidate.sites[v] = candidate.revert_sites[v];
  });
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_DEFECT_REPORT_3_H
