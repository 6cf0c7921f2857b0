// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_FLIPS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_FLIPS_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The cells around an edge of degree three: cell after cell, the slot of the vertex that the next cell does not have.
typedef std::array<Half_facet, 3> Edge_ring_3;

// The index of a vertex in a triangle that has it.
inline int index_in(const std::array<int, 3>& triangle, int v)
{
  CGAL_assertion(v == triangle[0] || v == triangle[1] || v == triangle[2]);
  return v == triangle[0] ? 0 : v == triangle[1] ? 1 : 2;
}

// The ring of the edge between vertices i and j of `cell`, if it has degree three.
inline std::optional<Edge_ring_3> ring_of_degree_3(const Indexed_triangulation_3& t, int cell, int i, int j)
{
  int leave = 0;
  while(leave == i || leave == j)
    ++leave;
  Edge_ring_3 ring;
  Half_facet s(cell, leave);
  int kept = t.vertex(Half_facet(cell, 6 - i - j - leave));
  for(int n = 0; n < 3; ++n)
  {
    ring[n] = s;
    const Half_facet across = t.neighbor(s);
    if(across.is_side())
      return std::nullopt;
    // The next cell has the kept vertex and is left by the facet opposite to it.
    s = t.slot(across.cell(), kept);
    kept = t.vertex(across);
  }
  if(s.cell() != cell)
    return std::nullopt;
  return ring;
}

// The ends a, b of the edge of a ring, such that (a, b, p0, p1) is oriented as the first cell, p0 and p1 being the
// vertices of the first two slots.
inline std::array<int, 2> edge_of_ring(const Indexed_triangulation_3& t, const Edge_ring_3& ring)
{
  const std::array<int, 3> f = t.facet(ring[0]);
  const int m = index_in(f, t.vertex(ring[1]));
  return {{ f[(m + 1) % 3], f[(m + 2) % 3] }};
}

// The facets of each cell that a flip makes, except those between two such cells.
inline constexpr std::array<int, 2> outer_facets_2_3 = {{ 0, 1 }};
inline constexpr std::array<int, 3> outer_facets_3_2 = {{ 1, 2, 3 }};

// Replaces the two cells at a facet by the three around the edge between the two apices.
inline std::array<int, 3> flip_2_3(Indexed_triangulation_3& t, Half_facet s)
{
  const Half_facet other = t.neighbor(s);
  CGAL_assertion(!other.is_side());
  const int a = t.vertex(s), b = t.vertex(other);
  const std::array<int, 3> p = t.facet(s);
  std::array<Half_facet, 3> above, below;   // what lies beyond the facets of the two cells opposite to p
  for(int k = 0; k < 3; ++k)
  {
    above[k] = t.neighbor(s.in_cell(facet_indices(s.index())[k]));
    const Half_facet q = other.in_cell(facet_indices(other.index())[k]);
    below[index_in(p, t.vertex(q))] = t.neighbor(q);
  }
  const int first = s.cell(), second = other.cell();
  t.set_cell(first, a, b, p[1], p[2]);
  t.set_cell(second, a, b, p[2], p[0]);
  const std::array<int, 3> cells = {{ first, second, t.add_cell(a, b, p[0], p[1]) }};
  for(int k = 0; k < 3; ++k)
  {
    t.set_neighbors(Half_facet(cells[k], 0), below[k]);
    t.set_neighbors(Half_facet(cells[k], 1), above[k]);
    t.set_neighbors(Half_facet(cells[k], 2), Half_facet(cells[(k + 1) % 3], 3));
  }
  return cells;
}

// Replaces the three cells around an edge by the two on either side of the triangle of the other vertices.
inline std::array<int, 2> flip_3_2(Indexed_triangulation_3& t, const Edge_ring_3& ring)
{
  // The n-th cell has the vertices p[n] and p[n+1] of the triangle.
  const std::array<int, 3> p = {{ t.vertex(ring[0]), t.vertex(ring[1]), t.vertex(ring[2]) }};
  const std::array<int, 2> edge = edge_of_ring(t, ring);
  std::array<Half_facet, 3> above, below;   // beyond the facets opposite to the second end and to the first
  for(int n = 0; n < 3; ++n)
  {
    const int k = (n + 2) % 3;        // the vertex of the triangle that this cell lacks
    above[k] = t.neighbor(t.slot(ring[n].cell(), edge[1]));
    below[k] = t.neighbor(t.slot(ring[n].cell(), edge[0]));
  }
  const int c = ring[0].cell(), d = ring[1].cell();
  t.remove_cell(ring[2].cell());
  t.set_cell(c, edge[0], p[0], p[1], p[2]);
  t.set_cell(d, edge[1], p[0], p[2], p[1]);
  t.set_neighbors(Half_facet(c, 0), Half_facet(d, 0));
  for(int k = 0; k < 3; ++k)
  {
    t.set_neighbors(Half_facet(c, 1 + k), above[k]);
    t.set_neighbors(Half_facet(d, 1 + (3 - k) % 3), below[k]);
  }
  return {{ c, d }};
}

// Lawson's algorithm: makes a constrained triangulation regular, from the facets in
// `irregular` on, which is empty in the end. Facets that no flip can remove wait until flips
// nearby have changed their surroundings.
//
// `flips` makes the flips in the triangulation, as the functions of Flips_3.h do, and keeps the
// books that its owner wants.
template <class Flips>
class Lawson_flips_3
{
public:
  Lawson_flips_3(const Constrained_triangulation_3& mesh, Flips& flips, std::vector<Half_facet>& irregular)
    : mesh_(mesh)
    , flips_(flips)
    , irregular_(irregular)
  {}

  // False if facets are left because there were too many flips: each lowers the lifted surface, so that only rounding can
  // make them go on.
  bool make_regular()
  {
    std::size_t budget = 1000 + 40 * irregular_.size();
    std::vector<Half_facet> waiting;
    for(bool has_flipped = true; has_flipped; irregular_.swap(waiting))
    {
      has_flipped = false;
      for( ; !irregular_.empty(); --budget)
      {
        if(budget == 0)
        {
          irregular_.clear();
          return false;
        }
        const Half_facet s = irregular_.back();
        irregular_.pop_back();
        if(!is_irregular(s))
          continue;
        if(remove_facet(s))
          has_flipped = true;
        else
          waiting.push_back(s);
      }
    }
    irregular_.clear();
    return true;
  }

private:
  bool is_irregular(Half_facet s)
  {
    const int c = s.cell();
    if(!mesh_.topology.is_alive(c))
      return false;
    const Half_facet across = mesh_.topology.neighbor(s);
    if(across.is_side())
      return false;
    const int origin = mesh_.topology.vertex(Half_facet(c, 0)), q = mesh_.topology.vertex(across);
    const Cell_products t = mesh_.products(c);
    determinant_ = t.determinant;
    return mesh_.is_irregular(t.power(mesh_.sites[origin], mesh_.sites[q]), mesh_.squared_distance(origin, q));
  }

  // Removes the facet by a flip, if there is one. The facets between the cells that it makes are regular.
  bool remove_facet(Half_facet s)
  {
    const double volume = determinant_ + mesh_.products(mesh_.topology.neighbor(s).cell()).determinant;
    const std::array<double, 3> after = mesh_.volumes_after_2_3(s);
    const double flat = 1e-12 * volume;
    const int k = static_cast<int>(std::min_element(after.begin(), after.end()) - after.begin());
    if(after[k] > flat)
    {
      for(int c : flips_.flip_2_3(s))
        for(int i : outer_facets_2_3)
          mesh_.push_facet(Half_facet(c, i), irregular_);
      return true;
    }
    // The edge across from the k-th vertex of the facet is reflex.
    if(after[(k + 1) % 3] <= flat || after[(k + 2) % 3] <= flat)
      return false;
    const std::array<int, 3>& f = facet_indices(s.index());
    const std::optional<Edge_ring_3> ring
      = ring_of_degree_3(mesh_.topology, s.cell(), f[(k + 1) % 3], f[(k + 2) % 3]);
    if(!ring)
      return false;
    for(int c : flips_.flip_3_2(*ring))
      for(int i : outer_facets_3_2)
        mesh_.push_facet(Half_facet(c, i), irregular_);
    return true;
  }

  const Constrained_triangulation_3& mesh_;
  Flips& flips_;
  std::vector<Half_facet>& irregular_;
  double determinant_ = 0;        // of the cell of the facet that was last looked at
};

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

  // `tangled` gets the cells that no flip improves, and those that are left after too many flips.
  void run(std::vector<int>& tangled)
  {
    std::size_t budget = 100 + 8 * inverted_.size();
    tangled.clear();
    for( ; !inverted_.empty() && budget > 0; --budget)
    {
      const int c = inverted_.back();
      inverted_.pop_back();
      if(mesh_.is_inverted(c) && !flip_best(c))
        tangled.push_back(c);
    }
    tangled.insert(tangled.end(), inverted_.begin(), inverted_.end());
    inverted_.clear();
    // Other flips may have improved some since.
    tangled.erase(std::remove_if(tangled.begin(), tangled.end(), [this](int c) { return !mesh_.is_inverted(c); }), tangled.end());
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

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_FLIPS_3_H
