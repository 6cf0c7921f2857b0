// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_TRIANGULATION_TABLE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_TRIANGULATION_TABLE_3_H

#include <CGAL/Global_odt_mesh_3/internal/parallel/For_each_in_chunks.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Which vertices and neighbors the cells of a triangulation of dimension three have, in numbers: what is between two
// triangulations of different types.
class Triangulation_table_3
{
public:
  // `cells` are all of the triangulation, `place(c)` tells where a cell is among them, and `number(v)` numbers finite
  // vertices from 0 on.
  template <class Triangulation, class Number, class Place>
  Triangulation_table_3(const Triangulation& tr, const std::vector<typename Triangulation::Cell_handle>& cells,
                        const Number& number, const Place& place, const Thread_policy& threads)
    : rows_(cells.size())
  {
    CGAL_precondition(tr.dimension() == 3);
    for_each_in_chunks(static_cast<int>(cells.size()), threads, [&](int n)
    {
      for(int i = 0; i < 4; ++i)
      {
        const typename Triangulation::Vertex_handle v = cells[n]->vertex(i);
        rows_[n].vertices[i] = tr.is_infinite(v) ? int(infinite) : number(v);
        rows_[n].neighbors[i] = place(cells[n]->neighbor(i));
      }
    });
  }

  std::size_t number_of_cells() const { return rows_.size(); }

  // Makes `tr` the triangulation of the table. Its infinite vertex, these finite ones, by their numbers, and these cells,
  // by their places, are there already. With one thread, nothing throws.
  template <class Triangulation>
  void connect(const std::vector<typename Triangulation::Vertex_handle>& vertices,
               const std::vector<typename Triangulation::Cell_handle>& cells, const Thread_policy& threads, Triangulation& tr) const
  {
    CGAL_precondition(cells.size() == rows_.size());
    const auto vertex = [&](int v) { return v == infinite ? tr.infinite_vertex() : vertices[v]; };
    for(std::size_t n = 0; n < rows_.size(); ++n)
      for(int v : rows_[n].vertices)
        vertex(v)->set_cell(cells[n]);
    for_each_in_chunks(static_cast<int>(rows_.size()), threads, [&](int n)
    {
      for(int i = 0; i < 4; ++i)
      {
        cells[n]->set_vertex(i, vertex(rows_[n].vertices[i]));
        cells[n]->set_neighbor(i, cells[rows_[n].neighbors[i]]);
      }
    });
    CGAL_expensive_assertion(tr.tds().is_valid());
  }

private:
  static constexpr int infinite = -1;

  struct Row
  {
    std::array<int, 4> vertices, neighbors;
  };

  std::vector<Row> rows_;       // of cells
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_TRIANGULATION_TABLE_3_H
