// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_UNTANGLING_FLIPS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_UNTANGLING_FLIPS_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flips_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Half_facet.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Gives inverted cells positive volume by flips that lower the sum of the negative volumes around them.
//
// `flips` makes the flips as for Lawson_flips_3. `inverted` are the inverted cells, none in the end;
// the facets of cells that flips make are added to `irregular`.
template <class Flips>
class Untangling_flips_3
{
public:
  Untangling_flips_3(const Constrained_triangulation_3& mesh, Flips& flips, std::vector<int>& inverted,
                     std::vector<Half_facet>& irregular)
    : mesh_(mesh)
    , flips_(flips)
    , inverted_(inverted)
    , irregular_(irregular)
  {}

  // `stuck` gets the cells that no flip improves, and those that are left after too many flips.
  void run(std::vector<int>& stuck)
  {
    std::size_t budget = 100 + 8 * inverted_.size();
    stuck.clear();
    for( ; !inverted_.empty() && budget > 0; --budget)
    {
      const int c = inverted_.back();
      inverted_.pop_back();
      if(mesh_.is_inverted(c) && !flip_best(c))
        stuck.push_back(c);
    }
    stuck.insert(stuck.end(), inverted_.begin(), inverted_.end());
    inverted_.clear();
    // Other flips may have improved some since.
    stuck.erase(std::remove_if(stuck.begin(), stuck.end(), [this](int c) { return !mesh_.is_inverted(c); }), stuck.end());
  }

private:
  // Flips that gain less than this part of the negative volume go on forever.
  static constexpr double least_gain = 0.1;

  bool flip_best(int c)
  {
    best_gain_ = least_gain * negative_part(mesh_.products(c).determinant);
    best_facet_.reset();
    best_ring_.reset();
    for(int i = 0; i < 4; ++i)
      consider_2_3(Half_facet(c, i));
    for(int i = 0; i < 3; ++i)
      for(int j = i + 1; j < 4; ++j)
        if(const std::optional<Edge_ring_3> ring = ring_of_degree_3(mesh_.topology, c, i, j))
          consider_3_2(*ring);
    if(best_ring_)
      collect(flips_.flip_3_2(*best_ring_));
    else if(best_facet_)
      collect(flips_.flip_2_3(*best_facet_));
    return best_ring_ || best_facet_;
  }

  void consider_2_3(Half_facet s)
  {
    const Half_facet across = mesh_.topology.neighbor(s);
    if(across.is_side() || mesh_.topology.vertex(across) == mesh_.topology.vertex(s))
      return;
    const std::array<double, 3> after = mesh_.volumes_after_2_3(s);
    const double gain = negative_part(mesh_.products(s.cell()).determinant)
                      + negative_part(mesh_.products(across.cell()).determinant)
                      - negative_part(after[0]) - negative_part(after[1]) - negative_part(after[2]);
    if(gain <= best_gain_)
      return;
    best_gain_ = gain;
    best_facet_ = s;
  }

  void consider_3_2(const Edge_ring_3& ring)
  {
    double gain = 0;
    for(Half_facet s : ring)
      gain += negative_part(mesh_.products(s.cell()).determinant);
    const int p0 = mesh_.topology.vertex(ring[0]), p1 = mesh_.topology.vertex(ring[1]), p2 = mesh_.topology.vertex(ring[2]);
    if(p0 == p2 || p1 == p2)
      return;
    const std::array<int, 2> edge = edge_of_ring(mesh_.topology, ring);
    gain = gain - negative_part(mesh_.determinant(edge[0], p0, p1, p2)) - negative_part(mesh_.determinant(edge[1], p0, p2, p1));
    if(gain <= best_gain_)
      return;
    best_gain_ = gain;
    best_ring_ = ring;
  }

  template <class Cells>
  void collect(const Cells& cells)
  {
    for(int c : cells)
    {
      if(mesh_.is_inverted(c))
        inverted_.push_back(c);
      mesh_.push_facets(c, irregular_);
    }
  }

  static double negative_part(double volume) { return (std::max)(0., -volume); }

  const Constrained_triangulation_3& mesh_;
  Flips& flips_;
  std::vector<int>& inverted_;
  std::vector<Half_facet>& irregular_;
  double best_gain_ = 0;
  std::optional<Half_facet> best_facet_;
  std::optional<Edge_ring_3> best_ring_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_UNTANGLING_FLIPS_3_H
