// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_BOUNDARY_COMPLEX_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_BOUNDARY_COMPLEX_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// A facet of the boundary between two subdomains, or of a surface patch. Labels
// and patches are numbers.
struct Boundary_facet
{
  static constexpr int no_patch = -1;     // for a facet that is not in the complex

  std::array<int, 3> vertices;      // clockwise seen from side 0
  std::array<int, 2> labels;        // the subdomains on side 0 and side 1
  int patch;
};

// The boundary facets around a vertex between two junctions.
struct Boundary_umbrella
{
  std::array<int, 2> labels;
  int patch;
  bool is_disk;                     // runs all around the vertex, between two subdomains
};

// The surfaces of a complex as triangles on numbered vertices: the junctions where they meet and the umbrellas at each vertex,
// independent of the positions of the vertices.
//
// Junctions are all edges except those with exactly two facets, of one patch and between the same subdomains.
class Boundary_complex_3
{
public:
  typedef Boundary_facet Facet;
  typedef Boundary_umbrella Umbrella;
  typedef std::pair<int, int> Edge;
  typedef std::pair<Edge, int> Junction;      // with the number of its facets

  Boundary_complex_3() {}

  Boundary_complex_3(std::vector<Facet> facets, std::size_t number_of_vertices, const Thread_policy& threads = Thread_policy())
    : facets_(std::move(facets))
  {
    find_junctions(sorted_edges(number_of_vertices, threads));
    find_umbrellas(number_of_vertices, threads);
    count_components();
  }

  const std::vector<Facet>& facets() const { return facets_; }
  const std::vector<Junction>& junctions() const { return junctions_; }
  bool is_junction(int u, int v) const
  {
    const auto j = std::lower_bound(junctions_.begin(), junctions_.end(), Junction(Edge(u, v), 0));
    return j != junctions_.end() && j->first == Edge(u, v);
  }
  // The facet beyond the edge opposite to vertex k of facet n, for corner 3 n + k, or -1 for a junction.
  int facet_beyond(int corner) const { return beyond_[corner]; }
  int number_of_vertices() const { return static_cast<int>(first_umbrella_.size()) - 1; }
  bool has_facets(int v) const { return number_of_umbrellas(v) > 0; }

  int number_of_umbrellas() const { return static_cast<int>(umbrellas_.size()); }
  int number_of_umbrellas(int v) const { return first_umbrella_[v + 1] - first_umbrella_[v]; }
  const Umbrella& umbrella(int v, int n) const { return umbrellas_[umbrella_number(v, n)]; }
  // The number, among all umbrellas, of the n-th one at v.
  int umbrella_number(int v, int n) const
  {
    CGAL_assertion(0 <= n && n < number_of_umbrellas(v));
    return first_umbrella_[v] + n;
  }
  const Umbrella& umbrella(int number) const { return umbrellas_[number]; }
  int umbrella_of_corner(int corner) const { return umbrella_of_corner_[corner]; }

  // The numbers of facets and components of each patch.
  const std::map<int, std::pair<std::size_t, std::size_t> >& facets_and_components() const { return counts_; }

  // Whether both pairs are the same subdomains, in either order.
  static bool same_labels(const std::array<int, 2>& a, const std::array<int, 2>& b)
  {
    return (a[0] == b[0] && a[1] == b[1]) || (a[0] == b[1] && a[1] == b[0]);
  }

private:
  struct Edge_of_facet
  {
    Edge edge;
    int corner;                     // 3 * facet + k, the edge being opposite to corner k
    bool operator<(const Edge_of_facet& o) const
    { return edge != o.edge ? edge < o.edge : corner < o.corner; }
  };

  static bool same_surface(const Facet& a, const Facet& b)
  {
    return a.patch != Facet::no_patch && a.patch == b.patch && same_labels(a.labels, b.labels);
  }

  Edge edge(int corner) const
  {
    const Triple& t = facets_[corner / 3].vertices;
    const int u = t[(corner + 1) % 3], v = t[(corner + 2) % 3];
    return Edge((std::min)(u, v), (std::max)(u, v));
  }

  int number_of_corners() const { return 3 * static_cast<int>(facets_.size()); }

  // Edges are distributed by their first vertex, which has few edges, and then sorted by the second.
  std::vector<Edge_of_facet> sorted_edges(std::size_t number_of_vertices, const Thread_policy& threads) const
  {
    std::vector<int> first(number_of_vertices + 1, 0);
    for(int corner = 0; corner < number_of_corners(); ++corner)
      ++first[edge(corner).first + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Edge_of_facet> edges(number_of_corners());
    std::vector<int> next(first.begin(), first.end() - 1);
    for(int corner = 0; corner < number_of_corners(); ++corner)
    {
      const Edge e = edge(corner);
      edges[next[e.first]++] = { e, corner };
    }
    for_each_in_chunks(static_cast<int>(number_of_vertices), threads,
                       [&](int v) { std::sort(edges.begin() + first[v], edges.begin() + first[v + 1]); });
    return edges;
  }

  // Finds the junctions and, for each other edge of a facet, the facet beyond.
  void find_junctions(const std::vector<Edge_of_facet>& edges)
  {
    beyond_.assign(edges.size(), -1);
    for(std::size_t n = 0, m; n < edges.size(); n = m)
    {
      m = n + 1;
      while(m < edges.size() && edges[m].edge == edges[n].edge)
        ++m;
      const int f = edges[n].corner / 3, g = edges[m - 1].corner / 3;
      if(m == n + 2 && same_surface(facets_[f], facets_[g]))
      {
        beyond_[edges[n].corner] = g;
        beyond_[edges[n + 1].corner] = f;
      }
      else
        junctions_.emplace_back(edges[n].edge, static_cast<int>(m - n));
    }
  }

  // The corner of the facet that is at the vertex.
  int corner(int facet, int v) const
  {
    const Triple& t = facets_[facet].vertices;
    CGAL_assertion(t[0] == v || t[1] == v || t[2] == v);
    return 3 * facet + (t[0] == v ? 0 : t[1] == v ? 1 : 2);
  }

  void find_umbrellas(std::size_t number_of_vertices, const Thread_policy& threads)
  {
    std::vector<int> first(number_of_vertices + 1, 0);
    for(const Facet& f : facets_)
      for(int v : f.vertices)
        ++first[v + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<int> corners(number_of_corners()), next(first.begin(), first.end() - 1);
    for(int c = 0; c < number_of_corners(); ++c)
      corners[next[facets_[c / 3].vertices[c % 3]]++] = c;

    umbrella_of_corner_.assign(corners.size(), -1);
    first_umbrella_.assign(number_of_vertices + 1, 0);
    umbrellas_ = collect_in_chunks<Umbrella>(static_cast<int>(number_of_vertices), threads, [&](int v, std::vector<Umbrella>& some)
    {
      const std::size_t begin = some.size();
      for(int n = first[v]; n < first[v + 1]; ++n)
        if(umbrella_of_corner_[corners[n]] < 0)
          add_umbrella(v, corners[n], begin, some);
      first_umbrella_[v + 1] = static_cast<int>(some.size() - begin);
    });
    std::partial_sum(first_umbrella_.begin(), first_umbrella_.end(), first_umbrella_.begin());
    for(int c = 0; c < number_of_corners(); ++c)
      umbrella_of_corner_[c] += first_umbrella_[facets_[c / 3].vertices[c % 3]];
  }

  // Adds the umbrella to which a corner of the vertex belongs. Umbrellas of the vertex start at `begin` and are numbered from
  // there.
  void add_umbrella(int v, int first_corner, std::size_t begin, std::vector<Umbrella>& umbrellas)
  {
    const Facet& f = facets_[first_corner / 3];
    const int number = static_cast<int>(umbrellas.size() - begin);
    // All umbrellas between the same two subdomains have the same side 0.
    std::array<int, 2> labels = f.labels;
    if(number > 0 && labels[1] == umbrellas[begin].labels[0])
      std::swap(labels[0], labels[1]);
    bool is_closed = f.patch != Facet::no_patch && f.labels[0] != f.labels[1];
    umbrella_of_corner_[first_corner] = number;
    for(std::vector<int> stack(1, first_corner); !stack.empty(); )
    {
      const int c = stack.back();
      stack.pop_back();
      for(int m = 1; m < 3; ++m)
      {
        const int beyond = beyond_[c - c % 3 + (c % 3 + m) % 3];
        if(beyond < 0)
        {
          is_closed = false;
          continue;
        }
        const int other = corner(beyond, v);
        if(umbrella_of_corner_[other] >= 0)
          continue;
        umbrella_of_corner_[other] = number;
        stack.push_back(other);
      }
    }
    umbrellas.push_back({ labels, f.patch, is_closed });
  }

  // Facets of one component are connected across edges that are not junctions.
  void count_components()
  {
    std::vector<char> is_reached(facets_.size(), false);
    std::vector<int> stack;
    for(int n = 0; n < static_cast<int>(facets_.size()); ++n)
    {
      auto& count = counts_[facets_[n].patch];
      ++count.first;
      if(is_reached[n])
        continue;
      ++count.second;
      is_reached[n] = true;
      for(stack.push_back(n); !stack.empty(); )
      {
        const int f = stack.back();
        stack.pop_back();
        for(int corner = 3 * f; corner < 3 * f + 3; ++corner)
          if(beyond_[corner] >= 0 && !std::exchange(is_reached[beyond_[corner]], true))
            stack.push_back(beyond_[corner]);
      }
    }
  }

  std::vector<Facet> facets_;
  std::vector<Junction> junctions_;
  std::vector<int> beyond_;         // each corner's facet beyond the opposite edge, or -1
  std::vector<int> first_umbrella_, umbrella_of_corner_;
  std::vector<Umbrella> umbrellas_;
  std::map<int, std::pair<std::size_t, std::size_t> > counts_;
};

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

// The ends of new edges whose vertices had no common neighbor before, nor were neighbors, as they are where an edge is flipped:
// such edges lead to another sheet of the surface.
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

// The vertices where the topology of a boundary complex differs from that of another one on the same vertices.
//
// The topology is the same if both have the same junctions with as many facets, as many umbrellas at each vertex, and as many
// facets and components of each patch: then the patches have the same boundary, Euler
// characteristic and number of components, and touch at the same places.
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

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_BOUNDARY_COMPLEX_3_H
