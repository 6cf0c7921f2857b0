// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_EDGE_SPLITTING_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_EDGE_SPLITTING_3_H

#include <CGAL/Global_odt_mesh_3/internal/complex/Vertex_edits_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Working_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <algorithm>
#include <optional>
#include <queue>
#include <utility>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Splits the edges of a complex that are longer than wanted, those first that are so most, inside and on surfaces, but not on
// features, nor where surfaces meet.
class Edge_splitting_3
{
public:
  explicit Edge_splitting_3(Vertex_edits_3& edits)
    : edits_(edits)
    , complex_(edits.complex())
  {}

  // `wanted(u, v)` is what the length of an edge should be; `wanted.add(site, u, v)` tells of a vertex that has been inserted into
  // it, as the last one.
  template <class Wanted, class Predicate>
  void run(Wanted& wanted, const Predicate& may_go_on)
  {
    const auto push = [&](int u, int v)
    {
      const double length = (position(complex_.sites[v]) - position(complex_.sites[u])).norm(), ratio = length / wanted(u, v);
      if(ratio > longest)
        edges_.push({ ratio, length, (std::min)(u, v), (std::max)(u, v) });
    };
    for(const auto& e : complex_.triangulation().finite_edges())
      push(Working_triangulation_3::number(e.first->vertex(e.second)), Working_triangulation_3::number(e.first->vertex(e.third)));
    while(!edges_.empty() && may_go_on())
    {
      const Edge e = edges_.top();
      edges_.pop();
      const int v = edits_.number_of_vertices();
      if(!split(e))
        continue;
      wanted.add(complex_.sites[v], e.u, e.v);
      for(int w : complex_.working.neighbors(v))
        push(v, w);
    }
  }

private:
  // Over what is wanted: the longest edge that stays, and the least distance of a new vertex from others.
  static constexpr double longest = 1.7, nearest = 0.75;

  struct Edge
  {
    double ratio, length;
    int u, v;

    bool operator<(const Edge& o) const
    { return ratio != o.ratio ? ratio < o.ratio : std::make_pair(u, v) > std::make_pair(o.u, o.v); }
  };

  bool split(const Edge& e)
  {
    const Working_triangulation_3& working = complex_.working;
    Cell_handle c;
    int i, j;
    if(!complex_.triangulation().is_edge(working.vertex(e.u), working.vertex(e.v), c, i, j))
      return false;
    const std::optional<New_vertex_3> v = middle_of_edge(complex_, e.u, e.v, c);
    return v && edits_.insert(*v, nearest * e.length / e.ratio, c);
  }

  Vertex_edits_3& edits_;
  const Editable_complex_3& complex_;
  std::priority_queue<Edge> edges_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_EDGE_SPLITTING_3_H
