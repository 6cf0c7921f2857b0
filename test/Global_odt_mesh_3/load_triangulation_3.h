// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_TEST_LOAD_TRIANGULATION_3_H
#define GLOBAL_ODT_MESH_3_TEST_LOAD_TRIANGULATION_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Index_cells_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Labelled_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Spatial_order.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Loads all finite cells of a regular triangulation. Vertices move unless they carry
// weight or lie on the convex hull, whose facets are constrained facets that repel nothing.
template <class Triangulation>
Moving_triangulation_3 load_triangulation_3(const Triangulation& tr)
{
  std::vector<Site> sites;
  for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
    sites.push_back(weighted_site(tr.point(v)));
  Labelled_triangulation_3 labelled;
  labelled.build(sites);
  for(int c : labelled.cells())
    labelled.set_label(c, labelled.is_infinite(c) ? 0 : 1);
  Moving_triangulation_3 mesh;
  index_cells(labelled, [](Half_facet) { return false; }, Thread_policy(), mesh.topology);

  std::vector<char> moves(sites.size());
  for(std::size_t v = 0; v < sites.size(); ++v)
    moves[v] = sites[v].weight == 0;
  for(int n = 0; n < mesh.topology.number_of_constrained_facets(); ++n)
    for(int v : mesh.topology.facet(mesh.topology.constrained_half_facet(n, 0)))
      moves[v] = false;
  std::vector<std::size_t> order = hilbert_order(sites);
  const auto first_fixed = std::stable_partition(order.begin(), order.end(), [&](std::size_t v) { return moves[v]; });
  mesh.number_of_movable_vertices = mesh.number_of_interior_vertices = static_cast<int>(first_fixed - order.begin());
  std::vector<int> place(order.size());
  for(std::size_t n = 0; n < order.size(); ++n)
  {
    place[order[n]] = static_cast<int>(n);
    mesh.sites.push_back(sites[order[n]]);
  }
  mesh.topology.renumber_vertices(place);
  mesh.topology.compact();
  return mesh;
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // GLOBAL_ODT_MESH_3_TEST_LOAD_TRIANGULATION_3_H
