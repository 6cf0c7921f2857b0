// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_STATE_TRIANGULATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_STATE_TRIANGULATION_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Numbered_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_state_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Vertex_numbering_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Working_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flatten_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The label that a state gives a cell with these vertices.
inline int label_of_cell(const Restricted_state_3& state, const Quadruple& q)
{
  if(*std::min_element(q.begin(), q.end()) < 0)
    return Domain_view_3::outside;
  for(int v : q)
    if(!state.numbering->is_on_boundary(v))
      return state.numbering->subdomain[v];
  const int label = state.label_of_boundary_cell(q);
  CGAL_assertion(label != Restricted_state_3::no_subdomain);
  return label;
}

// The boundary facets of a state, by their numbers and on side 0, in its triangulation.
inline std::vector<Facet> find_boundary_facets(const Restricted_state_3& state, const Numbered_triangulation_3& numbered,
                                               const Thread_policy& threads)
{
  const std::vector<Boundary_facet>& boundary = state.boundary.complex().facets();
  std::vector<Facet> facets(boundary.size());
  const auto is_off_boundary = [&](int v) { return v < 0 || !state.numbering->is_on_boundary(v); };
  const std::vector<Cell_handle>& cells = numbered.cells();
  for_each_in_chunks(static_cast<int>(cells.size()), threads, [&](int c)
  {
    const Quadruple q = Numbered_triangulation_3::numbers(cells[c]);
    const auto off_boundary = std::count_if(q.begin(), q.end(), is_off_boundary);
    for(int i = 0; i < 4 && off_boundary <= 1; ++i)
    {
      if(off_boundary == 1 && !is_off_boundary(q[i]))
        continue;
      const Triple t = numbered.vertices(Facet(cells[c], i));
      const int n = state.facet_number(t);
      if(n >= 0 && rotated(boundary[n].vertices) == t)
        facets[n] = Facet(cells[c], i);
    }
  });
  return facets;
}

// Makes the triangulation that of a state, whatever has become of it. Symbolic perturbation makes
// the regular triangulation of weighted points unique; its cells are labelled, and boundary facets found, by their vertices.
inline void restore_triangulation(const Restricted_state_3& state, const Thread_policy& threads, Numbered_triangulation_3& numbered)
{
  // The input is what it is, be it regular or not.
  const Vertex_numbering_3& numbering = *state.numbering;
  if(state.is_input && !numbered.is_at(state.sites))
    numbered.copy(numbering.input->read(threads), numbering.input_numbers, threads);
  else if(!state.is_input && !numbered.go_to(state.sites))
    numbered.build(state.sites);
  CGAL_assertion(numbered.is_complete());
  const std::vector<Cell_handle>& cells = numbered.cells();
  for_each_in_chunks(static_cast<int>(cells.size()), threads, [&](int n)
  {
    forget(cells[n]);
    cells[n]->forget_facets();
    cells[n]->set_label(label_of_cell(state, Numbered_triangulation_3::numbers(cells[n])));
  });
  const std::vector<Facet> facets = find_boundary_facets(state, numbered, threads);
  for(std::size_t n = 0; n < facets.size(); ++n)
    mark_facet(state.boundary.complex().facets()[n], facets[n], numbered);
}

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

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_STATE_TRIANGULATION_3_H
