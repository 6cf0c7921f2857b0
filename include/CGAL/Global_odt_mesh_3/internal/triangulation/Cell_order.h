// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_CELL_ORDER_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_CELL_ORDER_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Lays cells out by the numbers of their vertices: rounding errors of sums then do not depend on where cells have come from.
class Canonical_order
{
public:
  // The vertices of each cell are in their canonical order; cells whose first one is negative are left out.
  Canonical_order(std::vector<Quadruple> cells, int number_of_vertices, const Thread_policy& threads)
    : by_first_vertex_(static_cast<int>(cells.size()), number_of_vertices, [&cells](int n) { return cells[n][0]; }, threads)
    , numbers_(by_first_vertex_.numbers().size())
    , vertices_(4 * numbers_.size())
  {
    const Chunks chunks(number_of_vertices, least_vertices, most_chunks);
    threads.for_each_chunk(chunks.number(), [&](int chunk)
    {
      std::vector<std::pair<Quadruple, int> > around;
      for(int v = chunks.begin(chunk); v < chunks.end(chunk); ++v)
        sort_around(v, cells, around);
    });
  }

  int number_of_cells() const { return static_cast<int>(numbers_.size()); }

  // The cell at that place.
  int number(int place) const { return numbers_[place]; }

  // The vertices, in the order of slots.
  const std::vector<int>& vertices() const { return vertices_; }
  std::vector<int> take_vertices() { return std::move(vertices_); }

private:
  // A chunk is to be worth the trouble of a thread.
  static constexpr int least_vertices = 1000, most_chunks = 64;

  // Cells that have the first vertex in common.
  void sort_around(int v, const std::vector<Quadruple>& cells, std::vector<std::pair<Quadruple, int> >& around)
  {
    around.clear();
    for(int p = by_first_vertex_.begin(v); p < by_first_vertex_.end(v); ++p)
    {
      const int n = by_first_vertex_.numbers()[p];
      around.emplace_back(cells[n], n);
    }
    std::sort(around.begin(), around.end());
    int place = by_first_vertex_.begin(v);
    for(const auto& c : around)
    {
      numbers_[place] = c.second;
      std::copy(c.first.begin(), c.first.end(), vertices_.begin() + Half_facet(place++, 0).id());
    }
  }

  Buckets by_first_vertex_;
  std::vector<int> numbers_;    // of the cells, in order
  std::vector<int> vertices_;   // of the slots
};

// Flips scatter the cells over memory, which makes evaluations of large meshes slower. Lays
// them out anew, at a current point, when there has been a flip for eight cells.
class Cell_order
{
public:
  explicit Cell_order(const Moving_triangulation_3& mesh) : flips_(mesh.statistics().flips) {}

  void maintain(Moving_triangulation_3& mesh)
  {
    const std::size_t flips = mesh.statistics().flips;
    if(flips - flips_ < static_cast<std::size_t>(mesh.topology.number_of_cells()) / 8)
      return;
    mesh.compact();
    flips_ = flips;
  }

private:
  std::size_t flips_;   // when the order was last good
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_CELL_ORDER_H
