// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_VERTEX_MOVES_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_VERTEX_MOVES_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Labelled_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Trial_predicates_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Vertex_cavity_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Moves single vertices of a triangulation over any distance.
class Vertex_moves_3
{
public:
  explicit Vertex_moves_3(Labelled_triangulation_3& triangulation)
    : triangulation_(triangulation)
    , cavity_(triangulation)
  {}

  // False if the vertex has too many neighbors or would be hidden; it may be out of the triangulation then.
  bool move(int v, const Site& s)
  {
    if(!cavity_.start(v))
      return false;
    if(!cavity_.find_cells(s))
    {
      if(!cavity_.find_cells_without())
        return false;
      cavity_.replace(triangulation_);
      const int nearby = cell_at(s, cavity_.new_cells().front()->number);
      triangulation_.set_site(v, s);
      cavity_.start_new(v, nearby);
      if(!cavity_.find_cells(s))
        return false;
    }
    cavity_.replace(triangulation_);
    return true;
  }

private:
  // Walks from a cell to the one that contains the site.
  int cell_at(const Site& s, int c) const
  {
    for(int i = 0; i < 4 && !triangulation_.is_infinite(c); ++i)
    {
      if(!is_beyond(s, triangulation_.vertices(c), i))
        continue;
      c = triangulation_.neighbor(c, i);
      i = -1;
    }
    return c;
  }

  bool is_beyond(const Site& s, const Quadruple& q, int i) const
  {
    const Triple t = facet_vertices(q, i);
    const auto point = [this](int v) { return weighted_point(triangulation_.sites()[v]).point(); };
    return CGAL::orientation(point(t[0]), point(t[1]), point(t[2]), weighted_point(s).point()) == POSITIVE;
  }

  Labelled_triangulation_3& triangulation_;
  Vertex_cavity_3 cavity_;
};

// Takes a triangulation to these sites by moving vertices. False if too many vertices move, since building it anew is faster then,
// or if a move fails; the triangulation is then of no use.
inline bool move_vertices(const std::vector<Site>& sites, Labelled_triangulation_3& triangulation)
{
  constexpr double most_moved_one_by_one = 1 / 4.;
  if(sites.size() != triangulation.sites().size() || !triangulation.is_complete())
    return false;
  std::vector<int> moved;
  for(std::size_t v = 0; v < sites.size(); ++v)
    if(!same_place(sites[v], triangulation.sites()[v]))
      moved.push_back(static_cast<int>(v));
  if(double(moved.size()) > most_moved_one_by_one * double(sites.size()))
    return false;
  Vertex_moves_3 moves(triangulation);
  return std::all_of(moved.begin(), moved.end(), [&](int v) { return moves.move(v, sites[v]); }) && triangulation.is_complete();
}

// Whether a triangulation is regular; if a sphere passes through five vertices, any of the possible triangulations counts. One that
// is read need not be regular, or may not be the one CGAL would build, and then moving its vertices is of no use.
inline bool is_regular(const Labelled_triangulation_3& triangulation, const Thread_policy& threads)
{
  const Trial_predicates_3 predicates(triangulation.sites());
  const std::vector<int>& cells = triangulation.cells();
  const auto is_everywhere = [&](const auto& holds)
  {
    return collect_in_chunks(static_cast<int>(cells.size()), threads, [&](int n, std::vector<int>& wrong)
    {
      if(!holds(cells[n]))
        wrong.push_back(n);
    }).empty();
  };
  const auto is_locally_regular = [&](int c)
  {
    const auto sphere = predicates.sphere(triangulation.vertices(c));
    for(int i = 0; i < 4; ++i)
      if(const Half_facet f(c, i); triangulation.is_first_side(f))
        if(const int v = triangulation.vertex(triangulation.mirror(f)); v >= 0 && predicates.is_in_conflict(sphere, v, false))
          return false;
    return true;
  };
  // Only positive cells have spheres.
  return is_everywhere([&](int c) { return predicates.is_positive(triangulation.vertices(c)); }) && is_everywhere(is_locally_regular)
         && are_connected(cells, [&](int c) { return triangulation.vertices(c); }, [&](int c, int i) { return triangulation.neighbor(c, i); });
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_VERTEX_MOVES_3_H
