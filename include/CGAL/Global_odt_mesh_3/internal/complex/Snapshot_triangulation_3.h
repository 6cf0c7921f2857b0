// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SNAPSHOT_TRIANGULATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SNAPSHOT_TRIANGULATION_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Exact_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Working_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Index_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The label that a snapshot gives a cell with these vertices.
inline int label_of_cell(const Complex_snapshot_3& snapshot, const Quadruple& q)
{
  if(*std::min_element(q.begin(), q.end()) < 0)
    return Domain_view_3::outside;
  for(int v : q)
    if(!snapshot.numbering->is_on_boundary(v))
      return snapshot.numbering->subdomain[v];
  const int label = snapshot.label_of_boundary_cell(q);
  CGAL_assertion(label != Complex_snapshot_3::no_subdomain);
  return label;
}

// The boundary facets of a snapshot, by their numbers and on side 0, in its triangulation.
inline std::vector<Facet> find_boundary_facets(const Complex_snapshot_3& snapshot, const Working_triangulation_3& working,
                                               const Thread_policy& threads)
{
  const std::vector<Boundary_facet>& boundary = snapshot.boundary.complex().facets();
  std::vector<Facet> facets(boundary.size());
  const std::vector<Cell_handle>& cells = working.cells();
  for_each_in_chunks(static_cast<int>(cells.size()), threads, [&](int c)
  {
    snapshot.numbering->for_each_facet_on_boundary(Working_triangulation_3::numbers(cells[c]), [&](int i)
    {
      const Triple t = working.vertices(Facet(cells[c], i));
      const int n = snapshot.facet_number(t);
      if(n >= 0 && rotated(boundary[n].vertices) == t)
        facets[n] = Facet(cells[c], i);
    });
  });
  return facets;
}

// Makes the triangulation that of a snapshot, whatever has become of it. Symbolic perturbation makes
// the regular triangulation of weighted points unique; its cells are labelled, and boundary facets found, by their vertices.
inline void restore_triangulation(const Complex_snapshot_3& snapshot, const Thread_policy& threads,
                                  Working_triangulation_3& working)
{
  // The input is what it is, be it regular or not, so that its positions do not tell its cells.
  const Vertex_numbering_3& numbering = *snapshot.numbering;
  if(snapshot.is_input)
    working.copy(numbering.input->read(threads), numbering.input_numbers, threads);
  else if(!working.go_to(snapshot.sites))
    working.build(snapshot.sites);
  CGAL_assertion(working.is_complete());
  const std::vector<Cell_handle>& cells = working.cells();
  for_each_in_chunks(static_cast<int>(cells.size()), threads, [&](int n)
  {
    cells[n]->clear_flags();
    cells[n]->clear_facets();
    cells[n]->set_label(label_of_cell(snapshot, Working_triangulation_3::numbers(cells[n])));
  });
  const std::vector<Facet> facets = find_boundary_facets(snapshot, working, threads);
  for(std::size_t n = 0; n < facets.size(); ++n)
    mark_facet(snapshot.boundary.complex().facets()[n], facets[n], working);
}

// Completes a mesh whose topology is that of the snapshot.
inline void load_positions(const Complex_snapshot_3& snapshot, Moving_triangulation_3& mesh)
{
  mesh.sites = snapshot.sites;
  mesh.number_of_interior_vertices = snapshot.numbering->number_of_interior_vertices;
  mesh.number_of_movable_vertices = snapshot.numbering->number_of_movable_vertices;
}

// Loads the snapshot, whose triangulation is given, into a mesh: all cells that are in the complex, in canonical order; the
// boundary facets are constrained.
inline void index_snapshot(const Complex_snapshot_3& snapshot, const Working_triangulation_3& working,
                           const Thread_policy& threads, Moving_triangulation_3& mesh)
{
  const auto number = [](Vertex_handle v) { return Working_triangulation_3::number(v); };
  const auto label = [](Cell_handle c) { return c->label(); };
  const auto is_in_complex = [](Cell_handle c, int i) { return c->is_facet_in_complex(i); };
  index_triangulation_3(working.triangulation(), working.cells(), number, label, is_in_complex, threads, mesh.topology);
  load_positions(snapshot, mesh);
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SNAPSHOT_TRIANGULATION_3_H
