// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SIZE_ADAPTATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SIZE_ADAPTATION_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Labelled_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Vertex_edits_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/sizing/Wanted_length_3.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The permitted lengths of edges, relative to the wanted lengths, and angles of new facets, relative to the bound. The middle of an
// edge halves angles at worst; vertices on the surface move apart later.
struct Size_tolerance
{
  double longest = (std::numeric_limits<double>::infinity)(), shortest = 0;
  double share_of_facet_angles = 1;
  bool wants_number = false;      // the number of vertices must be reached, whatever the edge lengths
};

// Removes vertices at short edges of a complex and inserts vertices into long ones, the shortest or longest first. That happens
// inside and on surfaces, but neither on features nor where surfaces meet. Edges on surfaces that are too long come before all
// others: vertices inside that are close to them would be in the way, and coarse facets beside fine cells make slivers.
class Size_adaptation_3
{
public:
  Size_adaptation_3(Vertex_edits_3& edits, Wanted_length_3& wanted, const Size_tolerance& tolerance)
    : edits_(edits)
    , complex_(edits.complex())
    , wanted_(wanted)
    , tolerance_(tolerance)
  {}

  template <class Predicate>
  void remove_vertices(const Predicate& may_go_on)
  {
    Edges edges;
    for(const std::array<int, 2>& e : edges_of_complex())
      push(e[0], e[1], -1, edges);
    while(!edges.empty() && may_go_on())
    {
      const Edge e = edges.top();
      edges.pop();
      if(!(-e.rank < tolerance_.shortest) && !(tolerance_.wants_number && edits_.has_too_many_vertices()))
        return;
      if(!complex_.triangulation.is_visible(e.u) || !complex_.triangulation.is_visible(e.v))
        continue;
      for(int v : edits_.trial().movable_vertices(std::array<int, 2>{{ e.u, e.v }}))
        if(edits_.remove(v))
        {
          for(const auto& edge : edits_.new_edges())
            push(edge[0], edge[1], -1, edges);
          break;
        }
    }
  }

  template <class Predicate>
  void insert_vertices(const Predicate& may_go_on)
  {
    Edges edges;
    for(const std::array<int, 2>& e : edges_of_complex())
      push(e[0], e[1], 1, edges);
    while(!edges.empty() && may_go_on())
    {
      const Edge e = edges.top();
      edges.pop();
      if(edits_.is_full() || !(tolerance_.wants_number || e.rank > tolerance_.longest))
        return;
      const int v = edits_.number_of_vertices();
      if(!split(e))
        continue;
      wanted_.add(edits_.stratum_of_last(), complex_.sites[v], e.u, e.v);
      for(int w : complex_.triangulation.neighbors(v))
        push(v, w, 1, edges);
    }
  }

private:
  // The least distance of a new vertex from others, relative to the wanted length or to that of the edge, whichever gives less.
  static constexpr double nearest = 0.75, nearest_over_edge = 0.44;

  // The edge of the highest rank comes first, on surfaces that need vertices and then elsewhere.
  struct Edge
  {
    bool needs_vertex_on_surface;
    double rank, length;
    int u, v;

    bool operator<(const Edge& o) const
    { return std::tie(needs_vertex_on_surface, rank, o.u, o.v) < std::tie(o.needs_vertex_on_surface, o.rank, u, v); }
  };
  typedef std::priority_queue<Edge> Edges;

  std::vector<std::array<int, 2> > edges_of_complex() const
  {
    std::vector<Quadruple> cells;
    for(int c : complex_.triangulation.cells())
      if(complex_.is_inside(c))
        cells.push_back(complex_.triangulation.vertices(c));
    return edges_of(cells);
  }

  void push(int u, int v, double sign, Edges& edges) const
  {
    const double length = (position(complex_.sites[v]) - position(complex_.sites[u])).length(), rank = sign * length / wanted_(u, v);
    edges.push({ rank > tolerance_.longest && !complex_.boundary.around(u, v).empty(), rank, length, (std::min)(u, v), (std::max)(u, v) });
  }

  bool split(const Edge& e)
  {
    const int c = complex_.triangulation.find_cell(std::array<int, 2>{{ e.u, e.v }});
    if(c < 0)
      return false;
    const std::optional<New_vertex_3> v = middle_of_edge(complex_, e.u, e.v, c);
    return v && edits_.insert(*v, (std::min)(nearest * e.length / e.rank, nearest_over_edge * e.length), c);
  }

  Vertex_edits_3& edits_;
  const Editable_complex_3& complex_;
  Wanted_length_3& wanted_;
  Size_tolerance tolerance_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SIZE_ADAPTATION_3_H
