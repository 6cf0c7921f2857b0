// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_TEST_LOAD_TRIANGULATION_3_H
#define GLOBAL_ODT_MESH_3_TEST_LOAD_TRIANGULATION_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Spatial_order.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Index_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <CGAL/Time_stamper.h>
#include <CGAL/Unique_hash_map.h>

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
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef CGAL::Hash_handles_with_or_without_timestamps Hash;
  Moving_triangulation_3 mesh;
  CGAL::Unique_hash_map<Vertex_handle, int, Hash> number;
  std::vector<Site> sites;
  for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
  {
    number[v] = static_cast<int>(sites.size());
    sites.push_back(weighted_site(tr.point(v)));
  }
  const auto constrained_facets = index_triangulation_3(
    tr, all_cells(tr), [&number](Vertex_handle v) { return number[v]; },
    [](typename Triangulation::Cell_handle) { return 1; },
    [](typename Triangulation::Cell_handle, int) { return false; }, Thread_policy(), mesh.topology);

  std::vector<char> moves(sites.size());
  for(std::size_t v = 0; v < sites.size(); ++v)
    moves[v] = sites[v].weight == 0;
  for(const auto& w : constrained_facets)
    for(int v : w.vertices)
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
