// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_POSITION_CONTROL_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_POSITION_CONTROL_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Half_facet.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

struct Position_parameters_3
{
  // A vertex is held back to a half of its step, to half of that and so on; at this time it stays.
  int times_to_standstill = 4;

  // Where the vertices of the stuck cells stand still, those around them follow, and then those around these. Farther
  // away there is no reason why a step should not be feasible.
  int rings_held_back = 3;

  // Holding back is given up when that many cells more are stuck than were inverted at first, since the step was much
  // too long.
  std::size_t cells_out_of_reach = 20;
};

// Holds vertices back on their way from the state that their mesh keeps, a Moving_triangulation_3.
template <class Mesh>
class Position_control_3
{
public:
  explicit Position_control_3(Mesh& mesh, const Position_parameters_3& parameters = Position_parameters_3())
    : mesh_(mesh)
    , parameters_(parameters)
  {}

  // Starts again from the kept state, with shorter steps for the vertices of stuck cells and, once these do not
  // move at all, of the vertices around. False if no such steps are found.
  bool hold_back(std::size_t number_of_inverted_cells)
  {
    if(mesh_.stuck_cells().size() > parameters_.cells_out_of_reach + number_of_inverted_cells)
      return false;
    std::map<int, int> times;
    for(int n = 0; n < parameters_.rings_held_back * parameters_.times_to_standstill; ++n)
    {
      const std::vector<int> held = vertices_to_hold_back(n / parameters_.times_to_standstill);
      for(int v : held)
        if(v < mesh_.number_of_movable_vertices)
          times[v] = (std::min)(times[v] + 1, parameters_.times_to_standstill);
      std::map<int, Site> sites;
      for(const auto& t : times)
        sites.emplace(t.first, on_the_way(t.first, mesh_.site_asked_for(t.first), part_of_step(t.second)));
      if(!mesh_.untangle_anew(sites))
        continue;
      for(const auto& t : times)
        if(t.second == parameters_.times_to_standstill)
          mesh_.add_stopped(t.first);
      return true;
    }
    return false;
  }

private:
  // Those of the stuck cells and of so many rings around. Leads back to the kept topology.
  std::vector<int> vertices_to_hold_back(int rings)
  {
    std::vector<int> vertices;
    for(int c : mesh_.stuck_cells())
      vertices.insert(vertices.end(), mesh_.topology.vertices(c), mesh_.topology.vertices(c) + 4);
    mesh_.topology.undo_trial();
    for(int ring = 0; ring < rings; ++ring)
      add_neighbors(vertices);
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }

  // Appends the neighbors of the movable vertices in `vertices`.
  void add_neighbors(std::vector<int>& vertices)
  {
    for(std::size_t n = 0, end = vertices.size(); n < end; ++n)
    {
      if(vertices[n] >= mesh_.number_of_movable_vertices)
        continue;
      mesh_.topology.star(vertices[n], star_);
      for(Half_facet s : star_)
        vertices.insert(vertices.end(), mesh_.topology.vertices(s.cell()), mesh_.topology.vertices(s.cell()) + 4);
    }
  }

  double part_of_step(int times) const
  {
    return times == parameters_.times_to_standstill ? 0 : std::ldexp(1., -times);
  }

  // Between the kept position and another one.
  Site on_the_way(int v, const Site& to, double part) const
  {
    const Site& from = mesh_.kept_site(v);
    return { from.x + part * (to.x - from.x), from.y + part * (to.y - from.y), from.z + part * (to.z - from.z), to.weight };
  }

  Mesh& mesh_;
  Position_parameters_3 parameters_;
  std::vector<Half_facet> star_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_POSITION_CONTROL_3_H
