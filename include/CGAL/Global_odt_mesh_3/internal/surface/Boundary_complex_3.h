// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_BOUNDARY_COMPLEX_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_BOUNDARY_COMPLEX_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

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
  std::array<double, 3> normal;     // of unit length, from labels[0] to labels[1]
  std::array<double, 3> toward;     // from the vertex into the umbrella
  std::array<int, 2> labels;
  int patch;
  bool is_smooth;                   // closed, oriented, of one patch, not bent too much
  double shortest_edge;             // from the vertex
  double bend;                      // the largest sine between facets and normal
};

// The surfaces of a complex as triangles on numbered vertices: the junctions
// where they meet, the umbrellas at each vertex, and whether another complex has
// the same topology.
//
// Junctions are the edges that do not have just two facets of one patch between
// the same subdomains. Two complexes on the same vertices have the same topology
// if they have the same junctions, as many umbrellas at each vertex, and as many
// facets and components of each patch: then the patches have the same boundary,
// Euler characteristic and number of components.
class Boundary_complex_3
{
public:
  typedef Boundary_facet Facet;
  typedef Boundary_umbrella Umbrella;
  typedef std::array<int, 3> Triple;
  typedef std::pair<int, int> Edge;

  // The cosine between a facet of a smooth umbrella and the umbrella's normal: 60 degrees.
  static constexpr double smallest_cosine = 0.5;

  static constexpr int no_label = -1;

  Boundary_complex_3() {}

  Boundary_complex_3(std::vector<Facet> facets, std::size_t number_of_vertices)
    : facets_(std::move(facets))
  {
    find_junctions(number_of_vertices);
    find_umbrellas(number_of_vertices);
    count_components();
  }

  const std::vector<Facet>& facets() const { return facets_; }
  const std::vector<Edge>& junctions() const { return junctions_; }
  // The facet beyond the edge opposite to vertex k of facet n, for corner 3 n + k, or -1 for a junction.
  int facet_beyond(int corner) const { return beyond_[corner]; }
  bool has_facets(int v) const { return first_facet_[v] != first_facet_[v + 1]; }
  int number_of_umbrellas(int v) const { return first_umbrella_[v + 1] - first_umbrella_[v]; }
  const Umbrella& umbrella(int v, int n) const { return umbrellas_[first_umbrella_[v] + n]; }
  Umbrella& umbrella(int v, int n) { return umbrellas_[first_umbrella_[v] + n]; }
  // Whether umbrella n of v runs all around it, between two subdomains.
  bool is_disk(int v, int n) const { return is_disk_[first_umbrella_[v] + n]; }
  const std::map<int, std::pair<std::size_t, std::size_t> >& facets_and_components() const { return counts_; }

  // Whether both pairs are the same subdomains, on whichever side.
  static bool same_labels(const std::array<int, 2>& a, const std::array<int, 2>& b)
  {
    return (a[0] == b[0] && a[1] == b[1]) || (a[0] == b[1] && a[1] == b[0]);
  }

  // Normals, shortest edges and smoothness of the umbrellas for these positions.
  void measure_umbrellas(const std::vector<Site>& sites)
  {
    for(Umbrella& f : umbrellas_)
    {
      f.normal = f.toward = {{ 0, 0, 0 }};
      f.bend = 0;
      f.shortest_edge = (std::numeric_limits<double>::max)();
    }
    std::vector<std::array<double, 3> > area(facets_.size());
    for(std::size_t n = 0; n < facets_.size(); ++n)
    {
      area[n] = area_vector(facets_[n].vertices, sites);
      for(int k = 0; k < 3; ++k)
      {
        const int v = facets_[n].vertices[k];
        Umbrella& f = umbrellas_[umbrella_of_corner_[3 * n + k]];
        const double sign = facets_[n].labels[0] == f.labels[0] ? 1 : -1;
        for(int i = 0; i < 3; ++i)
          f.normal[i] += sign * area[n][i];
        for(int m = 1; m < 3; ++m)
        {
          const Site& s = sites[facets_[n].vertices[(k + m) % 3]];
          f.toward[0] += s.x - sites[v].x;
          f.toward[1] += s.y - sites[v].y;
          f.toward[2] += s.z - sites[v].z;
          f.shortest_edge = (std::min)(f.shortest_edge, distance(sites[v], s));
        }
      }
    }
    for(std::size_t n = 0; n < umbrellas_.size(); ++n)
    {
      normalize(umbrellas_[n].normal);
      umbrellas_[n].is_smooth = is_disk_[n];
    }
    for(std::size_t n = 0; n < facets_.size(); ++n)
    {
      normalize(area[n]);
      for(int k = 0; k < 3; ++k)
      {
        Umbrella& f = umbrellas_[umbrella_of_corner_[3 * n + k]];
        const double sign = facets_[n].labels[0] == f.labels[0] ? 1 : -1;
        const double cosine = sign * dot(area[n], f.normal);
        if(!(cosine >= smallest_cosine))
          f.is_smooth = false;
        f.bend = (std::max)(f.bend, std::sqrt((std::max)(0., 1 - cosine * cosine)));
      }
    }
    creases_.assign(first_umbrella_.size(), UNCLEAR);
    for(std::size_t v = 0; v + 1 < first_umbrella_.size(); ++v)
      creases_[v] = crease(static_cast<int>(v));
  }

  // The subdomain that lies in direction d from the vertex, as the planes of its
  // umbrellas tell; no_label if d is closer to tangential than the sine `margin`, or if
  // the surfaces are not those of a smooth point, a convex or a reflex edge or corner.
  int label_toward(int v, const std::array<double, 3>& d, double margin) const
  {
    if(creases_[v] == UNCLEAR)
      return no_label;
    const double clear = margin * std::sqrt(dot(d, d));
    bool any_above = false, any_below = false, all_above = true, all_below = true;
    for(int n = 0; n < number_of_umbrellas(v); ++n)
    {
      const double side = dot(umbrella(v, n).normal, d);
      any_above = any_above || side >= clear;
      any_below = any_below || side <= -clear;
      all_above = all_above && side >= clear;
      all_below = all_below && side <= -clear;
    }
    const std::array<int, 2>& labels = umbrella(v, 0).labels;
    if(creases_[v] == CONVEX)
      return any_above ? labels[1] : all_below ? labels[0] : int(no_label);
    return any_below ? labels[0] : all_above ? labels[1] : int(no_label);
  }

  // The vertices where the topology of `other`, on the same vertices, differs.
  std::set<int> difference(const Boundary_complex_3& other) const
  {
    std::set<int> result;
    std::vector<Edge> edges;
    std::set_symmetric_difference(junctions_.begin(), junctions_.end(), other.junctions_.begin(),
                                  other.junctions_.end(), std::back_inserter(edges));
    for(const Edge& e : edges)
    {
      result.insert(e.first);
      result.insert(e.second);
    }
    for(int v = 0; v + 1 < static_cast<int>(first_umbrella_.size()); ++v)
      if(number_of_umbrellas(v) != other.number_of_umbrellas(v))
        result.insert(v);
    if(!result.empty() || counts_ == other.counts_)
      return result;
    result = vertices_of_long_edges(other);
    if(result.empty())
      for(const Triple& t : other_facets(other))
        result.insert(t.begin(), t.end());
    return result;
  }

  // The facets that one complex has and the other does not, as sorted vertices.
  std::vector<Triple> other_facets(const Boundary_complex_3& other) const
  {
    const std::vector<Triple> a = triples(), b = other.triples();
    std::vector<Triple> only;
    std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(only));
    return only;
  }

private:
  // The ends of edges of `other` whose ends are here neither neighbors nor have a
  // common one, as they do where an edge is flipped: such edges cross to another
  // sheet of the surface.
  std::set<int> vertices_of_long_edges(const Boundary_complex_3& other) const
  {
    std::vector<std::set<int> > neighbors(first_umbrella_.size());
    for(const Facet& f : facets_)
      for(int k = 0; k < 3; ++k)
        neighbors[f.vertices[k]].insert({ f.vertices[(k + 1) % 3], f.vertices[(k + 2) % 3] });
    std::set<int> result;
    for(const Facet& f : other.facets_)
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

  struct Edge_of_facet
  {
    Edge edge;
    int corner;                     // 3 * facet + k, the edge being opposite to corner k
    bool operator<(const Edge_of_facet& o) const
    { return edge != o.edge ? edge < o.edge : corner < o.corner; }
  };

  // How the umbrellas at a vertex meet, seen from labels[0].
  enum Crease { UNCLEAR, CONVEX, REFLEX };

  Crease crease(int v) const
  {
    if(number_of_umbrellas(v) == 0)
      return UNCLEAR;
    bool convex = true, reflex = true;
    for(int n = 0; n < number_of_umbrellas(v); ++n)
    {
      if(umbrella(v, n).labels != umbrella(v, 0).labels || umbrella(v, n).labels[0] == umbrella(v, n).labels[1])
        return UNCLEAR;
      for(int m = 0; m < number_of_umbrellas(v); ++m)
        if(m != n)
        {
          const double above = dot(umbrella(v, n).normal, umbrella(v, m).toward);
          convex = convex && above <= 0;
          reflex = reflex && above >= 0;
        }
    }
    return convex ? CONVEX : reflex ? REFLEX : UNCLEAR;
  }

  static double dot(const std::array<double, 3>& a, const std::array<double, 3>& b)
  {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  static double distance(const Site& a, const Site& b)
  {
    return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
  }

  // Twice the area, pointing to side 1.
  static std::array<double, 3> area_vector(const Triple& t, const std::vector<Site>& s)
  {
    const double ax = s[t[1]].x - s[t[0]].x, ay = s[t[1]].y - s[t[0]].y, az = s[t[1]].z - s[t[0]].z;
    const double bx = s[t[2]].x - s[t[0]].x, by = s[t[2]].y - s[t[0]].y, bz = s[t[2]].z - s[t[0]].z;
    return {{ ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx }};
  }

  static void normalize(std::array<double, 3>& n)
  {
    const double length = std::sqrt(dot(n, n));
    if(length > 0)
      for(double& x : n)
        x /= length;
  }

  static bool same_surface(const Facet& a, const Facet& b)
  {
    return a.patch != Facet::no_patch && a.patch == b.patch && a.labels[0] != a.labels[1]
           && same_labels(a.labels, b.labels);
  }

  std::vector<Triple> triples() const
  {
    std::vector<Triple> t;
    t.reserve(facets_.size());
    for(const Facet& f : facets_)
      t.push_back(sorted(f.vertices));
    std::sort(t.begin(), t.end());
    return t;
  }

  // Also finds, for each edge of a facet, the facet beyond, unless it is a junction.
  void find_junctions(std::size_t number_of_vertices)
  {
    // Sorted by the first vertex, whose edges are few, and then by the second.
    const auto edge = [this](int corner)
    {
      const Triple& t = facets_[corner / 3].vertices;
      const int u = t[(corner + 1) % 3], v = t[(corner + 2) % 3];
      return Edge((std::min)(u, v), (std::max)(u, v));
    };
    std::vector<int> first(number_of_vertices + 1, 0);
    const int corners = 3 * static_cast<int>(facets_.size());
    for(int corner = 0; corner < corners; ++corner)
      ++first[edge(corner).first + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Edge_of_facet> edges(corners);
    std::vector<int> next(first.begin(), first.end() - 1);
    for(int corner = 0; corner < corners; ++corner)
    {
      const Edge e = edge(corner);
      edges[next[e.first]++] = { e, corner };
    }
    for(std::size_t v = 0; v < number_of_vertices; ++v)
      std::sort(edges.begin() + first[v], edges.begin() + first[v + 1]);
    beyond_.assign(edges.size(), -1);
    for(std::size_t n = 0, m; n < edges.size(); n = m)
    {
      m = n + 1;
      while(m < edges.size() && edges[m].edge == edges[n].edge)
        ++m;
      if(m == n + 2 && same_surface(facets_[edges[n].corner / 3], facets_[edges[n + 1].corner / 3]))
      {
        beyond_[edges[n].corner] = edges[n + 1].corner / 3;
        beyond_[edges[n + 1].corner] = edges[n].corner / 3;
      }
      else
        junctions_.push_back(edges[n].edge);
    }
  }

  int index(int facet, int v) const
  {
    const Triple& t = facets_[facet].vertices;
    return t[0] == v ? 0 : t[1] == v ? 1 : 2;
  }

  void find_umbrellas(std::size_t number_of_vertices)
  {
    first_facet_.assign(number_of_vertices + 1, 0);
    for(const Facet& f : facets_)
      for(int v : f.vertices)
        ++first_facet_[v + 1];
    std::partial_sum(first_facet_.begin(), first_facet_.end(), first_facet_.begin());
    std::vector<int> corners(3 * facets_.size()), next(first_facet_.begin(), first_facet_.end() - 1);
    for(int corner = 0; corner < static_cast<int>(corners.size()); ++corner)
      corners[next[facets_[corner / 3].vertices[corner % 3]]++] = corner;

    umbrella_of_corner_.assign(corners.size(), -1);
    first_umbrella_.assign(number_of_vertices + 1, 0);
    std::vector<int> stack;
    for(std::size_t v = 0; v < number_of_vertices; ++v)
    {
      first_umbrella_[v] = static_cast<int>(umbrellas_.size());
      for(int n = first_facet_[v]; n < first_facet_[v + 1]; ++n)
      {
        if(umbrella_of_corner_[corners[n]] >= 0)
          continue;
        const Facet& f = facets_[corners[n] / 3];
        const int umbrella = static_cast<int>(umbrellas_.size());
        // All umbrellas between the same two subdomains look to the same side.
        std::array<int, 2> labels = f.labels;
        if(umbrella > first_umbrella_[v] && labels[1] == umbrellas_[first_umbrella_[v]].labels[0])
          std::swap(labels[0], labels[1]);
        umbrellas_.push_back({ {{ 0, 0, 0 }}, {{ 0, 0, 0 }}, labels, f.patch, false, 0, 0 });
        bool closed = f.patch != Facet::no_patch && f.labels[0] != f.labels[1];
        umbrella_of_corner_[corners[n]] = umbrella;
        stack.assign(1, corners[n]);
        while(!stack.empty())
        {
          const int corner = stack.back();
          stack.pop_back();
          for(int m = 1; m < 3; ++m)
          {
            const int b = beyond_[corner - corner % 3 + (corner % 3 + m) % 3];
            if(b < 0)
            {
              closed = false;
              continue;
            }
            const int other = 3 * b + index(b, static_cast<int>(v));
            if(umbrella_of_corner_[other] < 0)
            {
              umbrella_of_corner_[other] = umbrella;
              stack.push_back(other);
            }
          }
        }
        is_disk_.push_back(closed);
      }
    }
    first_umbrella_[number_of_vertices] = static_cast<int>(umbrellas_.size());
  }

  void count_components()
  {
    std::vector<char> seen(facets_.size(), false);
    std::vector<int> stack;
    for(std::size_t n = 0; n < facets_.size(); ++n)
    {
      auto& count = counts_[facets_[n].patch];
      ++count.first;
      if(seen[n])
        continue;
      ++count.second;
      seen[n] = true;
      stack.assign(1, static_cast<int>(n));
      while(!stack.empty())
      {
        const int f = stack.back();
        stack.pop_back();
        for(int k = 0; k < 3; ++k)
        {
          const int b = beyond_[3 * f + k];
          if(b >= 0 && !seen[b])
          {
            seen[b] = true;
            stack.push_back(b);
          }
        }
      }
    }
  }

  std::vector<Facet> facets_;
  std::vector<Edge> junctions_;
  std::vector<int> beyond_;         // each corner's facet beyond the opposite edge, or -1
  std::vector<int> first_facet_, first_umbrella_, umbrella_of_corner_;
  std::vector<Umbrella> umbrellas_;
  std::vector<char> is_disk_;
  std::vector<Crease> creases_;
  std::map<int, std::pair<std::size_t, std::size_t> > counts_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_BOUNDARY_COMPLEX_3_H
