// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_SURFACE_TRIANGULATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_SURFACE_TRIANGULATION_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The surfaces of a complex as a triangulation whose edges, except junctions, can be flipped. Corner 3 f + k is vertex k of facet
// f, and opposite to one of its edges.
class Surface_triangulation_3
{
public:
  static constexpr int no_corner = -1;

  Surface_triangulation_3() {}

  explicit Surface_triangulation_3(const Boundary_complex_3& boundary)
    : is_queued_(3 * boundary.facets().size(), false)
  {
    const std::vector<Boundary_facet>& facets = boundary.facets();
    vertices_.reserve(facets.size());
    for(const Boundary_facet& f : facets)
    {
      vertices_.push_back(f.vertices);
      if(f.labels[0] > f.labels[1])
        std::swap(vertices_.back()[1], vertices_.back()[2]);
    }
    orient(boundary);
    opposite_.assign(3 * facets.size(), no_corner);
    for(std::size_t n = 0; n < facets.size(); ++n)
      for(int k = 0; k < 3; ++k)
      {
        const int v = facets[n].vertices[k];
        const int beyond = boundary.facet_beyond(static_cast<int>(3 * n) + k);
        if(beyond < 0 || has_common_direction(static_cast<int>(n), beyond))
          continue;
        const int corner = static_cast<int>(3 * n) + index(static_cast<int>(n), v);
        for(int m = 0; m < 3; ++m)
          if(index(static_cast<int>(n), vertices_[beyond][m]) < 0)
            opposite_[corner] = 3 * beyond + m;
      }
  }

  // The facets around some vertices that are on no junction, with the numbers of vertices given by `number`. Edges on the border of
  // the part are not flipped.
  template <class Number>
  Surface_triangulation_3 part(const std::vector<int>& vertices, const std::vector<int>& corner_of_vertex,
                               const Number& number) const
  {
    std::vector<int> facets;
    for(int v : vertices)
    {
      int c = corner_of_vertex[v];
      do
      {
        facets.push_back(c / 3);
        c = next(opposite_[next(c)]);
      }
      while(c != corner_of_vertex[v]);
    }
    std::sort(facets.begin(), facets.end());
    facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
    Surface_triangulation_3 part;
    for(int f : facets)
    {
      part.vertices_.push_back({{ number(vertices_[f][0]), number(vertices_[f][1]), number(vertices_[f][2]) }});
      for(int k = 0; k < 3; ++k)
      {
        const int across = opposite_[3 * f + k];
        const auto it = std::lower_bound(facets.begin(), facets.end(), across / 3);
        const bool is_there = across != no_corner && it != facets.end() && *it == across / 3;
        part.opposite_.push_back(is_there ? 3 * int(it - facets.begin()) + across % 3 : int(no_corner));
      }
    }
    part.is_queued_.assign(part.opposite_.size(), false);
    return part;
  }

  // A corner at each vertex that has one.
  std::vector<int> corners_of_vertices(std::size_t number_of_vertices) const
  {
    std::vector<int> corner(number_of_vertices, no_corner);
    for(int c = 0; c < static_cast<int>(opposite_.size()); ++c)
      corner[vertex(c)] = c;
    return corner;
  }

  int number_of_facets() const { return static_cast<int>(vertices_.size()); }
  const std::array<int, 3>& vertices(int facet) const { return vertices_[facet]; }

  // Flips edges until the two angles opposite to each edge sum up to at most 180 degrees: the surface is then Delaunay, and its
  // circumcenters are in the order of the cells.
  void make_delaunay(const std::vector<Site>& sites, const Thread_policy& threads = Thread_policy())
  {
    std::vector<int> queue = flippable_corners(sites, threads);
    for(int c : queue)
      is_queued_[c] = true;
    std::size_t flips_left = 10 * vertices_.size();
    while(!queue.empty())
    {
      const int c = queue.back();
      queue.pop_back();
      is_queued_[c] = false;
      if(flips_left == 0 || opposite_[c] == no_corner || !is_flippable(c, sites))
        continue;
      --flips_left;
      const int d = opposite_[c];
      flip(c);
      for(int f : { c / 3, d / 3 })
        for(int k = 0; k < 3; ++k)
          if(!is_queued_[3 * f + k])
          {
            queue.push_back(3 * f + k);
            is_queued_[3 * f + k] = true;
          }
    }
  }

private:
  // The sum of the angles must exceed 180 degrees by more than rounding.
  static constexpr double least_sine = 1e-9;

  // The corners opposite to edges that can be flipped, one for each edge.
  std::vector<int> flippable_corners(const std::vector<Site>& sites, const Thread_policy& threads) const
  {
    return collect_in_chunks(static_cast<int>(opposite_.size()), threads, [&](int c, std::vector<int>& found)
    {
      if(opposite_[c] > c && is_flippable(c, sites))
        found.push_back(c);
    });
  }

  static int next(int c) { return c % 3 == 2 ? c - 2 : c + 1; }
  static int previous(int c) { return c % 3 == 0 ? c + 2 : c - 1; }
  int vertex(int c) const { return vertices_[c / 3][c % 3]; }

  int index(int facet, int v) const
  {
    const std::array<int, 3>& t = vertices_[facet];
    return t[0] == v ? 0 : t[1] == v ? 1 : t[2] == v ? 2 : -1;
  }

  static Vector_3 edge(const Site& a, const Site& b) { return Vector_3(b.x - a.x, b.y - a.y, b.z - a.z); }

  // Whether the edge opposite to c is not Delaunay and the other diagonal may replace it.
  bool is_flippable(int c, const std::vector<Site>& sites) const
  {
    const int d = opposite_[c];
    const Site& p = sites[vertex(c)];
    const Site& q = sites[vertex(next(c))];
    const Site& r = sites[vertex(previous(c))];
    const Site& s = sites[vertex(d)];
    if(p.weight != 0 || q.weight != 0 || r.weight != 0 || s.weight != 0)
      return false;
    const Vector_3 pq = edge(p, q), pr = edge(p, r), sq = edge(s, q), sr = edge(s, r);
    const double cosine_p = pq.dot(pr), cosine_s = sq.dot(sr);
    if(cosine_p >= 0 && cosine_s >= 0)
      return false;
    const Vector_3 above = pq.cross(pr), below = sr.cross(sq);
    const double sine_p = above.length(), sine_s = below.length();
    if(!(sine_p * cosine_s + cosine_p * sine_s < -least_sine * pq.length() * pr.length() * sq.length() * sr.length()))
      return false;
    const Vector_3 ps = edge(p, s), normal = (above + below).normalized();
    const Vector_3 first = pq.cross(ps), second = ps.cross(pr);
    // A flip must not bend the surface more than a smooth umbrella.
    constexpr double cosine = Boundary_geometry_3::smallest_cosine;
    return first.dot(normal) > cosine * first.length() && second.dot(normal) > cosine * second.length()
           && !is_edge(c, vertex(d));
  }

  // Whether there is an edge from the vertex of c to w.
  bool is_edge(int c, int w) const
  {
    // The search goes around the vertex in one direction and, from a junction, in the other.
    int e = c;
    do
    {
      if(vertex(next(e)) == w || vertex(previous(e)) == w)
        return true;
      const int across = opposite_[next(e)];
      e = across == no_corner ? int(no_corner) : next(across);
    }
    while(e != c && e != no_corner);
    if(e == c)
      return false;
    for(e = c; e != no_corner; )
    {
      if(vertex(next(e)) == w || vertex(previous(e)) == w)
        return true;
      const int across = opposite_[previous(e)];
      e = across == no_corner ? int(no_corner) : previous(across);
    }
    return false;
  }

  // Orients all facets of a surface alike; the labels do so already for facets between two subdomains. On a one-sided surface
  // inside a subdomain, some edges remain between facets oriented differently.
  void orient(const Boundary_complex_3& boundary)
  {
    std::vector<char> is_reached(vertices_.size(), false);
    std::vector<int> stack;
    for(int n = 0; n < number_of_facets(); ++n)
      for(stack.push_back(n); !stack.empty(); )
      {
        const int f = stack.back();
        stack.pop_back();
        is_reached[f] = true;
        for(int corner = 3 * f; corner < 3 * f + 3; ++corner)
        {
          const int beyond = boundary.facet_beyond(corner);
          if(beyond < 0 || std::exchange(is_reached[beyond], true))
            continue;
          if(has_common_direction(f, beyond))
            std::swap(vertices_[beyond][1], vertices_[beyond][2]);
          stack.push_back(beyond);
        }
      }
  }

  // Whether both facets traverse their common edge in the same direction.
  bool has_common_direction(int f, int g) const
  {
    for(int c = 3 * f; c < 3 * f + 3; ++c)
      if(const int k = index(g, vertex(c)); k >= 0 && vertex(next(3 * g + k)) == vertex(next(c)))
        return true;
    return false;
  }

  void glue(int c, int d)
  {
    opposite_[c] = d;
    if(d != no_corner)
      opposite_[d] = c;
  }

  // (p, q, r) and (s, r, q) become (p, q, s) and (s, r, p).
  void flip(int c)
  {
    const int d = opposite_[c];
    const int beyond_pr = opposite_[next(c)], beyond_sq = opposite_[next(d)];
    const int p = vertex(c), s = vertex(d);
    vertices_[c / 3][previous(c) % 3] = s;
    vertices_[d / 3][previous(d) % 3] = p;
    glue(c, beyond_sq);
    glue(d, beyond_pr);
    glue(next(c), next(d));
  }

  std::vector<std::array<int, 3> > vertices_;
  std::vector<int> opposite_;       // the corner on the other side of the edge, or no_corner
  std::vector<char> is_queued_;
};

// The motions of vertices on surfaces: each may move in the plane normal to its umbrella, as far as `farthest` times its shortest
// edge there. Vertices where the surface bends sharply stay.
inline std::vector<Tangential_motion> tangential_motions(const Constrained_triangulation_3& mesh,
                                                         const Boundary_geometry_3& boundary, double farthest)
{
  std::vector<Tangential_motion> motions;
  for(int v = mesh.number_of_interior_vertices; v < mesh.number_of_movable_vertices; ++v)
  {
    const Umbrella_shape& shape = boundary.shape(v, 0);
    motions.push_back({ shape.normal, shape.is_smooth ? farthest * shape.shortest_edge : 0., mesh.sites[v] });
  }
  return motions;
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_SURFACE_TRIANGULATION_3_H
