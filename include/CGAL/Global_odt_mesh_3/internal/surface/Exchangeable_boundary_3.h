// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_EXCHANGEABLE_BOUNDARY_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_EXCHANGEABLE_BOUNDARY_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The facets of a boundary complex, some of which may be exchanged for others as long as that keeps the topology.
class Exchangeable_boundary_3
{
public:
  struct Facet
  {
    Triple vertices;                // sorted
    std::array<int, 2> labels;      // sorted
    int patch;
  };

  explicit Exchangeable_boundary_3(const Boundary_complex_3& complex)
    : around_(complex.number_of_vertices())
  {
    for(const Boundary_facet& f : complex.facets())
      add({ sorted(f.vertices), sorted(f.labels), f.patch });
  }

  // Adds a vertex, which has no facets at first.
  void add_vertex() { around_.emplace_back(); }
  void remove_last_vertex() { around_.pop_back(); }

  const Facet& facet(int n) const { return facets_[n]; }

  // The numbers of the facets at a vertex.
  const std::vector<int>& around(int v) const { return around_[v]; }

  // The facets at an edge.
  std::vector<Facet> around(int v, int w) const
  {
    std::vector<Facet> result;
    for(int n : around_[v])
      if(has_vertex(facets_[n], w))
        result.push_back(facets_[n]);
    return result;
  }

  // Whether one surface goes all around the vertex, or several meet in one line through it; false if a surface ends there.
  bool has_room_to_move(int v) const
  {
    const Pattern p = pattern(v, facets_around(v));
    if(p.junctions.empty())
      return p.umbrellas == 1;
    return p.junctions.size() == 2
           && std::all_of(p.junctions.begin(), p.junctions.end(), [](const auto& j) { return j.second > 1; });
  }

  // The number of the facet with these vertices, which are sorted, or -1.
  int find(const Triple& t) const
  {
    for(int n : around_[t[0]])
      if(facets_[n].vertices == t)
        return n;
    return -1;
  }

  // All facets of the boundary.
  std::vector<Facet> facets() const
  {
    std::vector<Facet> result;
    for(std::size_t v = 0; v < around_.size(); ++v)
      for(int n : around_[v])
        if(facets_[n].vertices[0] == static_cast<int>(v))
          result.push_back(facets_[n]);
    return result;
  }

  // A vertex that an exchange inserts or removes, on a patch or inside.
  struct Vertex_change
  {
    int vertex = -1;                // if there is one
    bool is_inserted = false;
    int patch = Boundary_facet::no_patch;
  };

  // Whether after an exchange, each patch has as many facets, each vertex has as many umbrellas, and the junctions are the same.
  // Around a vertex inserted on a patch or removed from it, there must be a disk of that patch, which has two facets more than
  // without the vertex.
  bool keeps_topology(const std::vector<int>& removed, const std::vector<Facet>& added, const Vertex_change& change) const
  {
    std::vector<int> patches_before, patches_after, vertices;
    if(change.patch != Boundary_facet::no_patch)
    {
      std::vector<int>& fewer = change.is_inserted ? patches_before : patches_after;
      fewer.insert(fewer.end(), 2, change.patch);
    }
    for(int n : removed)
    {
      patches_before.push_back(facets_[n].patch);
      vertices.insert(vertices.end(), facets_[n].vertices.begin(), facets_[n].vertices.end());
    }
    for(const Facet& f : added)
    {
      patches_after.push_back(f.patch);
      vertices.insert(vertices.end(), f.vertices.begin(), f.vertices.end());
    }
    std::sort(patches_before.begin(), patches_before.end());
    std::sort(patches_after.begin(), patches_after.end());
    if(patches_before != patches_after)
      return false;
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return std::all_of(vertices.begin(), vertices.end(), [&](int v)
                       { return v == change.vertex ? is_disk(v, change.is_inserted, added) : keeps_topology_at(v, removed, added); });
  }

  // Whether an exchange keeps the topology if no vertex is inserted or removed.
  bool keeps_topology(const std::vector<int>& removed, const std::vector<Facet>& added) const
  { return keeps_topology(removed, added, Vertex_change()); }

  void exchange(const std::vector<int>& removed, const std::vector<Facet>& added)
  {
    for(int n : removed)
    {
      for(int v : facets_[n].vertices)
        around_[v].erase(std::find(around_[v].begin(), around_[v].end(), n));
      unused_.push_back(n);
    }
    for(const Facet& f : added)
      add(f);
  }

private:
  // The arrangement of facets around a vertex: the number of umbrellas, and the junctions between them.
  struct Pattern
  {
    int umbrellas;
    std::vector<std::pair<int, int> > junctions;      // the other ends, and how many facets they have
    bool operator==(const Pattern& o) const { return umbrellas == o.umbrellas && junctions == o.junctions; }
  };

  void add(const Facet& f)
  {
    int n = static_cast<int>(facets_.size());
    if(unused_.empty())
      facets_.push_back(f);
    else
    {
      n = unused_.back();
      unused_.pop_back();
      facets_[n] = f;
    }
    for(int v : f.vertices)
      around_[v].push_back(n);
  }

  static bool has_vertex(const Facet& f, int v) { return std::find(f.vertices.begin(), f.vertices.end(), v) != f.vertices.end(); }

  std::vector<Facet> facets_around(int v) const
  {
    std::vector<Facet> result;
    for(int n : around_[v])
      result.push_back(facets_[n]);
    return result;
  }

  bool keeps_topology_at(int v, const std::vector<int>& removed, const std::vector<Facet>& added) const
  {
    std::vector<Facet> after;
    for(int n : around_[v])
      if(std::find(removed.begin(), removed.end(), n) == removed.end())
        after.push_back(facets_[n]);
    for(const Facet& f : added)
      if(has_vertex(f, v))
        after.push_back(f);
    return pattern(v, facets_around(v)) == pattern(v, after);
  }

  // Whether the facets at the vertex are a disk, including the added ones if the vertex is inserted.
  bool is_disk(int v, bool is_inserted, const std::vector<Facet>& added) const
  {
    std::vector<Facet> facets = facets_around(v);
    for(const Facet& f : added)
      if(is_inserted && has_vertex(f, v))
        facets.push_back(f);
    return pattern(v, facets) == Pattern{ 1, {} };
  }

  static bool same_surface(const Facet& a, const Facet& b)
  {
    return a.patch != Boundary_facet::no_patch && a.patch == b.patch && a.labels == b.labels;
  }

  // The pattern of the facets around v.
  static Pattern pattern(int v, const std::vector<Facet>& facets)
  {
    std::vector<std::pair<int, int> > edges;
    std::vector<int> umbrella(facets.size());
    std::iota(umbrella.begin(), umbrella.end(), 0);
    for(std::size_t n = 0; n < facets.size(); ++n)
      for(int w : facets[n].vertices)
        if(w != v)
          edges.emplace_back(w, static_cast<int>(n));
    std::sort(edges.begin(), edges.end());
    Pattern result = { static_cast<int>(facets.size()), {} };
    for(std::size_t n = 0, m; n < edges.size(); n = m)
    {
      m = n + 1;
      while(m < edges.size() && edges[m].first == edges[n].first)
        ++m;
      const int f = edges[n].second, g = edges[m - 1].second;
      if(m == n + 2 && same_surface(facets[f], facets[g]))
        result.umbrellas -= join(umbrella, f, g);
      else
        result.junctions.emplace_back(edges[n].first, static_cast<int>(m - n));
    }
    return result;
  }

  // Joins the umbrellas of two facets; whether these were different ones.
  static bool join(std::vector<int>& umbrella, int f, int g)
  {
    const int a = umbrella[f], b = umbrella[g];
    std::replace(umbrella.begin(), umbrella.end(), a, b);
    return a != b;
  }

  std::vector<Facet> facets_;
  std::vector<int> unused_;                   // unused places in `facets_`
  std::vector<std::vector<int> > around_;     // by vertex
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_EXCHANGEABLE_BOUNDARY_3_H
