// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_CANONICAL_ORDER_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_CANONICAL_ORDER_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flat_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Slot.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Lays the cells out by the numbers of their vertices, and the vertices of each cell in ascending order, but for the last two
// where orientation asks for it: rounding errors of sums then do not depend on where cells have come from.
class Canonical_order
{
public:
  explicit Canonical_order(const Flat_triangulation_3& t)
    : t_(t)
    , place_(t.number_of_cell_slots(), -1)
  {
    for(int c = 0; c < t.number_of_cell_slots(); ++c)
      if(t.is_alive(c))
        cells_.push_back({ in_canonical_order(t.cell(c)), c });
    sort_cells();
    for(std::size_t n = 0; n < cells_.size(); ++n)
      place_[cells_[n].number] = static_cast<int>(n);
  }

  void apply(Flat_triangulation_3& t) const
  {
    std::vector<int> vertices, neighbors;
    vertices.reserve(4 * cells_.size());
    neighbors.reserve(4 * cells_.size());
    for(const Cell& c : cells_)
      for(int v : c.vertices)
      {
        const Slot across = t_.neighbor(t_.slot(c.number, v));
        vertices.push_back(v);
        neighbors.push_back(across.is_side() ? across.id() : slot_in_order(across).id());
      }
    t.assign(std::move(vertices), std::move(neighbors), t_.number_of_vertices(), t_.number_of_sides());
  }

private:
  struct Cell
  {
    std::array<int, 4> vertices;
    int number;

    bool operator<(const Cell& o) const { return vertices < o.vertices; }
  };

  // Distributed by the first vertex, which leaves a few to be sorted.
  void sort_cells()
  {
    std::vector<std::size_t> first(t_.number_of_vertices() + 1, 0);
    for(const Cell& c : cells_)
      ++first[c.vertices[0] + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::size_t> next = first;
    std::vector<Cell> sorted(cells_.size());
    for(const Cell& c : cells_)
      sorted[next[c.vertices[0]]++] = c;
    for(std::size_t v = 0; v + 1 < first.size(); ++v)
      std::sort(sorted.begin() + first[v], sorted.begin() + first[v + 1]);
    cells_.swap(sorted);
  }

  Slot slot_in_order(Slot s) const
  {
    const int place = place_[s.cell()];
    const std::array<int, 4>& v = cells_[place].vertices;
    return Slot(place, static_cast<int>(std::find(v.begin(), v.end(), t_.vertex(s)) - v.begin()));
  }

  const Flat_triangulation_3& t_;
  std::vector<Cell> cells_;       // in order
  std::vector<int> place_;        // of each cell there
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_CANONICAL_ORDER_H
