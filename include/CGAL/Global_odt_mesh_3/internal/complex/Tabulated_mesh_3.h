// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_TABULATED_MESH_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_TABULATED_MESH_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// A mesh that is a table: that of the user between the stages of an optimization which inserts vertices.
class Tabulated_mesh_3
  : public Mesh_view_3
{
public:
  struct State
  {
    Mesh_table_3 table;
    bool is_changed = false;                // since it was read
  };

  Tabulated_mesh_3(User_mesh_view_3& input, const Thread_policy& threads)
    : input_(input)
  {
    set_state({ input.read(threads) });
    feature_edges_ = input.feature_edges();
    number_of_input_vertices_ = static_cast<int>(table().sites.size());
  }

  const Mesh_table_3& table() const { return state_.table; }
  const State& state() const { return state_; }
  const std::vector<std::array<int, 2> >& feature_edges() const { return feature_edges_; }
  bool is_changed() const { return state_.is_changed; }

  // To what it was once.
  void return_to(State state) { set_state(std::move(state)); }

  Mesh_table_3 read(const Thread_policy&) override { return table(); }

  int patch(int v) const override
  { return v < number_of_input_vertices_ ? input_.patch(v) : table().inserted[v - number_of_input_vertices_]; }

  bool is_cell(const Quadruple& q) const override { return cells_.find(sorted(q)) != nullptr; }

  // The places of those that have been inserted before stay.
  void write(const Mesh_table_3& table) override
  {
    Mesh_table_3 next = table;
    next.inserted.insert(next.inserted.begin(), state_.table.inserted.begin(), state_.table.inserted.end());
    next.facets.clear();
    for(const Mesh_table_3::Facet& f : table.facets)
    {
      Mesh_table_3::Facet mirror = f;
      mirror.cell = table.cells[f.cell].neighbors[f.index];
      mirror.index = table.mirror_index(f.cell, f.index);
      for(const Mesh_table_3::Facet& side : { f, mirror })
      {
        next.cells[side.cell].facets |= 1 << side.index;
        next.facets.push_back(side);
      }
    }
    std::sort(next.facets.begin(), next.facets.end(), [](const Mesh_table_3::Facet& a, const Mesh_table_3::Facet& b)
              { return std::make_pair(a.cell, a.index) < std::make_pair(b.cell, b.index); });
    set_state({ std::move(next), true });
  }

private:
  void set_state(State state)
  {
    state_ = std::move(state);
    cells_ = Tuple_table<Quadruple, int>();
    cells_.reserve(table().cells.size());
    for(const Mesh_table_3::Cell& c : table().cells)
      cells_.insert(sorted(c.vertices), c.label);
  }

  User_mesh_view_3& input_;
  State state_;
  std::vector<std::array<int, 2> > feature_edges_;
  int number_of_input_vertices_ = 0;
  Tuple_table<Quadruple, int> cells_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_TABULATED_MESH_3_H
