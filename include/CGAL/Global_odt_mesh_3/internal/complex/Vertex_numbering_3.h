// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_VERTEX_NUMBERING_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_VERTEX_NUMBERING_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The vertices of a complex, numbered along space filling curves: first those of the interior that
// move, then those that move on surfaces, then the others. It is the same in all snapshots of the complex.
struct Vertex_numbering_3
{
  static constexpr int no_subdomain = -1;

  // A cell of the input with all vertices on the boundary.
  struct Input_cell
  {
    Quadruple vertices;                     // in their order there
    int label;
  };

  Mesh_view_3* input = nullptr;
  std::vector<int> input_numbers;           // of vertices, in the table of the input
  std::vector<Site> input_sites;
  std::vector<int> dimensions;
  // A vertex that no boundary facet touches belongs to one subdomain for good, and so
  // do the cells around it.
  std::vector<int> subdomain;               // its label, or no_subdomain on the boundary
  Tuple_table<Quadruple, Input_cell> input_boundary_cells;
  int number_of_interior_vertices = 0;
  int number_of_movable_vertices = 0;

  int number_of_vertices() const { return static_cast<int>(input_sites.size()); }
  int number_of_surface_vertices() const { return number_of_movable_vertices - number_of_interior_vertices; }
  bool is_movable(int v) const { return v < number_of_movable_vertices; }
  bool is_interior(int v) const { return v < number_of_interior_vertices; }
  bool is_on_boundary(int v) const { return subdomain[v] == no_subdomain; }
  // The patch of a vertex of dimension 2 in the input.
  int input_patch(int v) const { return input->patch(input_numbers[v]); }

  // Calls f(i) for the facets of a cell that have all vertices on the boundary; whether the cell has, too.
  template <class F>
  bool for_each_facet_on_boundary(const Quadruple& q, const F& f) const
  {
    const auto is_off_boundary = [this](int v) { return v < 0 || !is_on_boundary(v); };
    const auto off_boundary = std::count_if(q.begin(), q.end(), is_off_boundary);
    for(int i = 0; i < 4 && off_boundary <= 1; ++i)
      if(off_boundary == 0 || is_off_boundary(q[i]))
        f(i);
    return off_boundary == 0;
  }

  // Whether the site is that of the vertex in the input.
  bool is_input_site(int v, const Site& s) const { return same_place(s, input_sites[v]); }

  // Whether the vertices are where they were in the input.
  bool are_at_input(const Quadruple& q, const std::vector<Site>& sites) const
  {
    return std::all_of(q.begin(), q.end(), [&](int v) { return is_input_site(v, sites[v]); });
  }

  // The cell of the input that has these vertices, all on the boundary, at their sites, or null.
  const Input_cell* input_cell(const Quadruple& q, const std::vector<Site>& sites) const
  {
    const Input_cell* const c = input_boundary_cells.find(sorted(q));
    return c != nullptr && are_at_input(q, sites) ? c : nullptr;
  }

  // Whether there is one, on the boundary or not. Threads must not ask.
  bool is_input_cell(const Quadruple& q, const std::vector<Site>& sites) const
  {
    return are_at_input(q, sites)
           && input->is_cell({{ input_numbers[q[0]], input_numbers[q[1]], input_numbers[q[2]], input_numbers[q[3]] }});
  }
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_VERTEX_NUMBERING_3_H
