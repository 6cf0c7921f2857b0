// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_BOUNDARY_TOPOLOGY_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_BOUNDARY_TOPOLOGY_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Whether two boundary complexes on the same vertices have the same topology, and where they have not.
//
// They have if they have the same junctions with as many facets, as many umbrellas at each vertex, and as many
// facets and components of each patch: then the patches have the same boundary, Euler
// characteristic and number of components, and do not touch where they have not.

inline std::vector<std::array<int, 3> > sorted_facets(const Boundary_complex_3& boundary)
{
  std::vector<std::array<int, 3> > triples;
  triples.reserve(boundary.facets().size());
  for(const Boundary_facet& f : boundary.facets())
    triples.push_back(sorted(f.vertices));
  std::sort(triples.begin(), triples.end());
  return triples;
}

// The facets that one complex has and the other does not, as sorted vertices.
inline std::vector<std::array<int, 3> > exchanged_facets(const Boundary_complex_3& before, const Boundary_complex_3& after)
{
  const std::vector<std::array<int, 3> > a = sorted_facets(before), b = sorted_facets(after);
  std::vector<std::array<int, 3> > only;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(only));
  return only;
}

// The ends of edges after that were, before, neither neighbors nor had a common one, as they do where an
// edge is flipped: such edges cross to another sheet of the surface.
inline std::set<int> vertices_of_long_edges(const Boundary_complex_3& before, const Boundary_complex_3& after)
{
  std::vector<std::set<int> > neighbors(before.number_of_vertices());
  for(const Boundary_facet& f : before.facets())
    for(int k = 0; k < 3; ++k)
      neighbors[f.vertices[k]].insert({ f.vertices[(k + 1) % 3], f.vertices[(k + 2) % 3] });
  std::set<int> result;
  for(const Boundary_facet& f : after.facets())
    for(int k = 0; k < 3; ++k)
    {
      const int u = f.vertices[k], v = f.vertices[(k + 1) % 3];
      const bool is_near = neighbors[u].count(v) > 0
                           || std::any_of(neighbors[u].begin(), neighbors[u].end(),
                                          [&](int w) { return neighbors[v].count(w) > 0; });
      if(!is_near)
        result.insert({ u, v });
    }
  return result;
}

// The vertices where the topology has changed.
inline std::set<int> topology_changes(const Boundary_complex_3& before, const Boundary_complex_3& after)
{
  CGAL_assertion(before.number_of_vertices() == after.number_of_vertices());
  std::set<int> result;
  std::vector<Boundary_complex_3::Junction> junctions;
  std::set_symmetric_difference(before.junctions().begin(), before.junctions().end(), after.junctions().begin(),
                                after.junctions().end(), std::back_inserter(junctions));
  for(const Boundary_complex_3::Junction& j : junctions)
    result.insert({ j.first.first, j.first.second });
  for(int v = 0; v < before.number_of_vertices(); ++v)
    if(before.number_of_umbrellas(v) != after.number_of_umbrellas(v))
      result.insert(v);
  if(!result.empty() || before.facets_and_components() == after.facets_and_components())
    return result;
  result = vertices_of_long_edges(before, after);
  if(result.empty())
    for(const std::array<int, 3>& t : exchanged_facets(before, after))
      result.insert(t.begin(), t.end());
  return result;
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_BOUNDARY_TOPOLOGY_3_H
