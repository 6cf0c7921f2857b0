// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_FLATTEN_STATE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_FLATTEN_STATE_3_H

#include <CGAL/Global_odt_mesh_3/internal/parallel/For_each_in_chunks.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Numbered_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_state_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flatten_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Completes a mesh whose topology is that of the state, the constrained facets being these.
inline void load_positions(const Restricted_state_3& state, const Constrained_facets& facets, const Thread_policy& threads,
                           Moving_triangulation_3& mesh)
{
  mesh.sites = state.sites;
  mesh.number_of_interior_vertices = state.numbering->number_of_interior_vertices;
  mesh.number_of_movable_vertices = state.numbering->number_of_movable_vertices;
  mesh.surface_heights.resize(facets.size());
  for_each_in_chunks(static_cast<int>(facets.size()), threads,
                     [&](int n) { mesh.surface_heights[n] = state.height(facets[n].vertices); });
}

// Loads the state, whose triangulation is given, into a mesh: all cells that are in the complex, in canonical order; the boundary facets are constrained.
inline void flatten_state_3(const Restricted_state_3& state, const Numbered_triangulation_3& numbered, const Thread_policy& threads,
                            Moving_triangulation_3& mesh)
{
  const auto number = [](Vertex_handle v) { return Numbered_triangulation_3::number(v); };
  const auto label = [](Cell_handle c) { return c->label(); };
  const auto is_in_complex = [](Cell_handle c, int i) { return c->is_facet_in_complex(i); };
  const Constrained_facets facets = flatten_triangulation_3(numbered.triangulation(), numbered.cells(), number, label,
                                                            is_in_complex, threads, mesh.topology);
  load_positions(state, facets, threads, mesh);
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_FLATTEN_STATE_3_H
