// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_TABULATED_MESH_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_TABULATED_MESH_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// A mesh that is a table: that of the user between the stages of an optimization which inserts vertices.
class Tabulated_mesh_3
  : public Mesh_view_3
{
public:
  Tabulated_mesh_3(Mesh_view_3& input, const Thread_policy& threads)
    : input_(input)
  {
    set_table(input.read(threads));
    number_of_input_vertices_ = static_cast<int>(table_.sites.size());
  }

  const Mesh_table_3& table() const { return table_; }
  bool is_changed() const { return is_changed_; }

  // To what it was once.
  void return_to(Mesh_table_3 table) { set_table(std::move(table)); }

  Mesh_table_3 read(const Thread_policy&) override { return table_; }

  int patch(int v) const override
  { return v < number_of_input_vertices_ ? input_.patch(v) : table_.inserted[v - number_of_input_vertices_]; }

  bool is_cell(const Quadruple& q) const override { return cells_.find(sorted(q)) != nullptr; }

  std::size_t number_of_slivers(double bound) const override
  {
    const Angle_deficit_3 deficit(bound);
    const auto site = [this](int v) { return table_.sites[v]; };
    return std::count_if(table_.cells.begin(), table_.cells.end(), [&](const Mesh_table_3::Cell& c)
    {
      const Quadruple& q = c.vertices;
      return c.label != Domain_view_3::outside && deficit({{ site(q[0]), site(q[1]), site(q[2]), site(q[3]) }}) > 0;
    });
  }

  // What vertices are on, and feature edges, stays.
  void write(const Mesh_table_3& table) override
  {
    Mesh_table_3 next = table;
    next.inserted.insert(next.inserted.begin(), table_.inserted.begin(), table_.inserted.end());
    next.feature_edges = table_.feature_edges;
    next.facets.clear();
    for(const Mesh_table_3::Facet& f : table.facets)
    {
      const int d = table.cells[f.cell].neighbors[f.index];
      const Quadruple& back = table.cells[d].neighbors;
      Mesh_table_3::Facet mirror = f;
      mirror.cell = d;
      mirror.index = static_cast<int>(std::find(back.begin(), back.end(), f.cell) - back.begin());
      for(const Mesh_table_3::Facet& side : { f, mirror })
      {
        next.cells[side.cell].facets |= 1 << side.index;
        next.facets.push_back(side);
      }
    }
    std::sort(next.facets.begin(), next.facets.end(), [](const Mesh_table_3::Facet& a, const Mesh_table_3::Facet& b)
              { return std::make_pair(a.cell, a.index) < std::make_pair(b.cell, b.index); });
    set_table(std::move(next));
    is_changed_ = true;
  }

private:
  void set_table(Mesh_table_3 table)
  {
    table_ = std::move(table);
    cells_ = Tuple_table<Quadruple, int>();
    cells_.reserve(table_.cells.size());
    for(const Mesh_table_3::Cell& c : table_.cells)
      cells_.insert(sorted(c.vertices), c.label);
  }

  Mesh_view_3& input_;
  Mesh_table_3 table_;
  int number_of_input_vertices_ = 0;
  bool is_changed_ = false;                 // what has been written stays written even if it is returned from
  Tuple_table<Quadruple, int> cells_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_TABULATED_MESH_3_H
