// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_INDEX_CELLS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_INDEX_CELLS_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Labelled_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Cell_order.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Replaces the neighbors of these slots by sides of constrained facets; returns the number of facets.
inline std::size_t number_constrained_facets(const std::vector<int>& slots, std::vector<int>& neighbors)
{
  int number = 0;
  for(int s : slots)
  {
    const Half_facet across(neighbors[s]);
    if(!across.is_none() && across.id() < s)
      continue;
    neighbors[s] = Half_facet::side(number, 0).id();
    if(!across.is_none())
      neighbors[across.id()] = Half_facet::side(number, 1).id();
    ++number;
  }
  return number;
}

// Lays out the cells inside subdomains in an order that depends only on their vertices. Facets between two labels are constrained,
// and so are those for which `stay(f)` holds for either side.
template <class Stay>
void index_cells(const Labelled_triangulation_3& tr, const Stay& stay, const Thread_policy& threads, Indexed_triangulation_3& indexed)
{
  const std::vector<int>& cells = tr.cells();
  std::vector<Quadruple> vertices(cells.size());
  for_each_in_chunks(static_cast<int>(cells.size()), threads, [&](int n)
  {
    if(tr.label(cells[n]) != Domain_view_3::outside)
      vertices[n] = in_canonical_order(tr.vertices(cells[n]));
    else
      vertices[n][0] = Indexed_triangulation_3::no_vertex;
  });
  const int number_of_vertices = static_cast<int>(tr.sites().size());
  Canonical_order order(std::move(vertices), number_of_vertices, threads);
  std::vector<int> place(cells.empty() ? 0 : cells.back() + 1, -1);
  for(int n = 0; n < order.number_of_cells(); ++n)
    place[cells[order.number(n)]] = n;
  const auto slot_of = [&](int n, int v)
  {
    int i = 0;
    while(order.vertices()[4 * n + i] != v)
      ++i;
    return Half_facet(n, i);
  };
  std::vector<int> neighbors(order.vertices().size());
  const std::vector<int> constrained = collect_in_chunks(order.number_of_cells(), threads, [&](int n, std::vector<int>& found)
  {
    const int c = cells[order.number(n)];
    for(int k = 0; k < 4; ++k)
    {
      const Half_facet f(c, k), across = tr.mirror(f), slot = slot_of(n, tr.vertex(f));
      const int beyond = place[across.cell()];
      neighbors[slot.id()] = beyond < 0 ? Half_facet().id() : slot_of(beyond, tr.vertex(across)).id();
      if(beyond < 0 || tr.label(c) != tr.label(across.cell()) || stay(f) || stay(across))
        found.push_back(slot.id());
    }
  });
  const std::size_t facets = number_constrained_facets(constrained, neighbors);
  indexed = Indexed_triangulation_3();
  indexed.assign(order.take_vertices(), std::move(neighbors), tr.sites().size(), 2 * facets);
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_INDEX_CELLS_3_H
