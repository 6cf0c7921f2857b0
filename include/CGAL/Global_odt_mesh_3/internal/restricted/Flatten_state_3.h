// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_FLATTEN_STATE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_FLATTEN_STATE_3_H

#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_state_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/All_cells.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flat_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flatten_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

template <class Triangulation>
using Constrained_facets = std::vector<Constrained_facet<Triangulation> >;

// Loads those of all cells that are in the complex into flat arrays, in canonical order, vertices being named by
// `number`; the boundary facets are constrained.
template <class Triangulation, class Number>
Constrained_facets<Triangulation> flatten_complex_3(const Triangulation& tr,
                                                    const std::vector<typename Triangulation::Cell_handle>& cells,
                                                    const Number& number, const Thread_policy& threads,
                                                    Flat_triangulation_3& flat)
{
  typedef typename Triangulation::Cell_handle Cell_handle;
  return flatten_triangulation_3(tr, cells, number, [](Cell_handle c) { return c->subdomain_index(); },
                                 [](Cell_handle c, int i) { return c->is_facet_on_surface(i); }, threads, flat);
}

// Completes a mesh whose topology is that of the state.
template <class Triangulation>
void load_positions(const Restricted_state_3<Triangulation>& state, const Constrained_facets<Triangulation>& facets,
                    Moving_triangulation_3& mesh)
{
  mesh.sites = state.sites;
  mesh.number_of_interior_vertices = state.numbering->number_of_interior_vertices;
  mesh.number_of_movable_vertices = state.numbering->number_of_movable_vertices;
  mesh.surface_heights.clear();
  for(const Constrained_facet<Triangulation>& f : facets)
    mesh.surface_heights.push_back(state.height(f.vertices));
}

// Loads the state into a mesh.
template <class Triangulation>
void flatten_state_3(const Restricted_state_3<Triangulation>& state, const Thread_policy& threads,
                     Moving_triangulation_3& mesh)
{
  const auto number = [&state](typename Triangulation::Vertex_handle v) { return state.number(v); };
  const Triangulation& tr = state.triangulation();
  load_positions(state, state.is_input ? flatten_complex_3(tr, all_cells(tr), number, threads, mesh.topology)
                                       : flatten_complex_3(tr, state.own->cells(), number, threads, mesh.topology), mesh);
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_FLATTEN_STATE_3_H
