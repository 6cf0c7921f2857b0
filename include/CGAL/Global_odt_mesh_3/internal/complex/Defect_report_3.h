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

// Some vertices of a triangulation, by number, then their neighbors, and so on, ring by ring.
class Vertex_rings_3
{
public:
  // Negative numbers, which stand for the infinite vertex, are ignored.
  template <class Vertices>
  Vertex_rings_3(const Labelled_triangulation_3& triangulation, const Vertices& vertices)
    : triangulation_(triangulation)
  {
    for(int v : vertices)
      if(v >= 0)
        add(v);
  }

  // All vertices; the last ring comes last.
  const std::vector<int>& vertices() const { return vertices_; }
  std::size_t begin_of_last_ring() const { return begin_; }

  // Adds the neighbors of the last ring as a new ring.
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

// What a check finds wrong with a candidate: above all the offending vertices, which go back toward where they were.
class Defect_report_3
{
public:
  explicit Defect_report_3(const Complex_candidate_3& candidate)
    : candidate_(candidate)
  {}

  // Whether nothing is wrong, not even something that no vertex can mend by going back.
  bool is_clean() const { return offending_vertices_.empty() && retreats_.empty() && weights_.empty() && !is_beyond_repair_; }
  bool is_beyond_repair() const { return is_beyond_repair_; }

  const std::set<int>& offending_vertices() const { return offending_vertices_; }

  // Reverts those of the vertices that have not reverted yet or, if there are none, those around them. If these have all reverted,
  // too, the defect was there in the snapshot, of which less was asked; then vertices that are not where they were in the input
  // revert to it, of which nothing more can be asked.
  template <class Vertices>
  void revert(const Vertices& vertices)
  {
    // If much cannot be mended, the causes of further defects are not searched for.
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

  // Deals with vertices that are too close to a point: as long as vertices may retreat, interior ones move away from it, by a share
  // of their distance or, since the dual point of a flat cell may be far away, of the distance to the farthest of the others. If
  // none can retreat, vertices revert.
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

  // Adds weight to vertices that stay.
  void add_weights(const std::map<int, double>& weights) { weights_.insert(weights.begin(), weights.end()); }
  const std::map<int, double>& weights() const { return weights_; }

  // Reverts those of the vertices that have not reverted yet, or else those around them; whether there are any. Negative numbers,
  // which stand for the infinite vertex, are ignored.
  template <class Vertices>
  bool revert_around(const Vertices& vertices)
  {
    return revert_nearest(vertices, most_rings, [this](int v) { return !candidate_.is_reverted(v); });
  }

  void give_up() { is_beyond_repair_ = true; }

  // The vertices of defects that cannot be mended.
  const std::set<int>& obstacles() const { return obstacles_; }

  // A later defect may result from an earlier one, so it counts as beyond repair only if all else is well.
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
  // A new cell or facet is due to the move of one of its vertices or of one nearby; vertices farther away cannot be the cause.
  static constexpr int most_rings = 3;
  static constexpr std::size_t most_obstacles = 100;
  // The input as a whole may be valid where a mixture of its positions and others is not.
  static constexpr int most_rings_to_input = 6;

  // Keeps the longest retreat, whatever the order of calls.
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

  // Reverts the movable vertices that satisfy the predicate, in the nearest ring that has any.
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
  std::map<int, double> weights_;           // added to the vertices
  bool is_beyond_repair_ = false;
};

// Moves a vertex of a candidate onto its surface; false if there is no such point nearby.
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

// Puts all vertices that have moved on surfaces back onto them; a vertex for which that fails goes back.
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
