// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_VERTEX_NUMBERING_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_VERTEX_NUMBERING_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Point_coordinates.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Tuple_table.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>

#include <CGAL/Time_stamper.h>
#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The vertices of a complex, numbered along space filling curves: first those of the interior that
// move, then those that move on surfaces, then the others. It is the same in all states of the complex. Input is the
// triangulation of the c3t3.
template <class Input>
struct Vertex_numbering_3
{
  typedef typename Input::Vertex_handle Vertex_handle;
  typedef typename Input::Cell_handle Cell_handle;

  static constexpr int no_subdomain = -1;

  const Input* input = nullptr;
  std::vector<Vertex_handle> input_vertices;
  CGAL::Unique_hash_map<Vertex_handle, int, CGAL::Hash_handles_with_or_without_timestamps> input_number;
  // A vertex that no boundary facet touches belongs to one subdomain for good, and so
  // do the cells around it.
  std::vector<int> subdomain;               // its label, or no_subdomain on the boundary
  Tuple_table<std::array<int, 4>, Cell_handle> input_boundary_cells;      // with all vertices on the boundary
  int number_of_interior_vertices = 0;
  int number_of_movable_vertices = 0;

  int number_of_vertices() const { return static_cast<int>(input_vertices.size()); }
  int number_of_surface_vertices() const { return number_of_movable_vertices - number_of_interior_vertices; }
  bool is_movable(int v) const { return v < number_of_movable_vertices; }
  bool is_interior(int v) const { return v < number_of_interior_vertices; }
  bool is_on_boundary(int v) const { return subdomain[v] == no_subdomain; }
  Site input_site(int v) const { return weighted_site(input_vertices[v]->point()); }
  // Whether the site is that of the vertex in the input.
  bool is_input_site(int v, const Site& s) const { return same_place(s, input_site(v)); }

  // Whether the vertices are where they were in the input.
  bool are_at_input(const std::array<int, 4>& q, const std::vector<Site>& sites) const
  {
    return std::all_of(q.begin(), q.end(), [&](int v) { return is_input_site(v, sites[v]); });
  }

  // The cell of the input that has these vertices, all on the boundary, at their sites, if any.
  Cell_handle input_cell(const std::array<int, 4>& q, const std::vector<Site>& sites) const
  {
    const Cell_handle* const c = input_boundary_cells.find(sorted(q));
    return c != nullptr && are_at_input(q, sites) ? *c : Cell_handle();
  }

  // Whether there is one, on the boundary or not. CGAL marks cells while it looks, so that threads must not ask.
  bool is_input_cell(const std::array<int, 4>& q, const std::vector<Site>& sites) const
  {
    const std::vector<Vertex_handle>& v = input_vertices;
    Cell_handle c;
    return are_at_input(q, sites) && input->is_cell(v[q[0]], v[q[1]], v[q[2]], v[q[3]], c);
  }
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_VERTEX_NUMBERING_3_H
