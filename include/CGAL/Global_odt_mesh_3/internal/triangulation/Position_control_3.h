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
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

struct Position_parameters_3
{
  // More cells than this that flips do not untangle come from long steps, where a jump of the energy
  // does no harm: a vertex of each jumps to where its cells are positive, if there is such a place. Fewer come from
  // the short steps near a minimum: all their vertices are held back.
  std::size_t most_cells_held_back = 16;

  // A vertex is held back to a half of its step, to half of that and so on; at this time it stays.
  int times_to_standstill = 4;

  // Where the vertices of the stuck cells stand still, those around them follow, and then those around these. Farther
  // away there is no reason why a step should not be feasible.
  int rings_held_back = 3;

  // Holding back is given up when that many cells more are stuck than were inverted at first, since the step was much
  // too long.
  std::size_t cells_out_of_reach = 20;

  // The parts of the step that are tried where a vertex pushes dual points through the surface; the last
  // is where it came from.
  std::array<double, 3> parts_before_surface = {{ 0.5, 0.25, 0 }};
};

// A vertex on a surface is held in a disk about where it came from: its tangential plane says little of the surface farther
// away.
inline void hold_in_disk(const Site& center, double radius, Site& s)
{
  const double x = s.x - center.x, y = s.y - center.y, z = s.z - center.z;
  const double d = std::sqrt(x * x + y * y + z * z);
  if(d <= radius)
    return;
  const double f = radius / d;
  s = { center.x + f * x, center.y + f * y, center.z + f * z, s.weight };
}

// The other ways of altering the position of a vertex that was asked for, in a mesh that is on its way from the state that it
// keeps, a Moving_triangulation_3: the vertex jumps into the kernel of its star, is held back, or retreats from
// a surface.
template <class Mesh>
class Position_control_3
{
public:
  explicit Position_control_3(Mesh& mesh, const Position_parameters_3& parameters = Position_parameters_3())
    : mesh_(mesh)
    , parameters_(parameters)
  {}

  // Moves a vertex into the kernel of its star for each of the stuck cells, as far as may be, if they are many.
  void jump_into_kernels(std::vector<int>& stuck)
  {
    const bool may_jump = stuck.size() > parameters_.most_cells_held_back;
    const auto is_free = [&](int c) { return !mesh_.is_inverted(c) || (may_jump && jump_into_kernel(c)); };
    stuck.erase(std::remove_if(stuck.begin(), stuck.end(), is_free), stuck.end());
    // A jump may have freed cells before.
    stuck.erase(std::remove_if(stuck.begin(), stuck.end(), [&](int c) { return !mesh_.is_inverted(c); }), stuck.end());
  }

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
          mesh_.add_retreated(t.first);
      return true;
    }
    return false;
  }

  // A vertex that has pushed the dual point of its cell beyond a constrained facet goes back toward where it was.
  void retreat_from_surface(int v)
  {
    const Site to = mesh_.sites[v];
    mesh_.topology.star(v, star_);
    const auto is_beyond = [this](Half_facet s) { return mesh_.is_beyond_surface(s); };
    if(std::none_of(star_.begin(), star_.end(), is_beyond))       // any more, after flips
      return;
    for(double part : parameters_.parts_before_surface)
      if(mesh_.relocate(v, star_, on_the_way(v, to, part)) && std::none_of(star_.begin(), star_.end(), is_beyond))
        break;
    mesh_.add_retreated(v);
  }

private:
  bool jump_into_kernel(int cell)
  {
    for(int i = 0; i < 4; ++i)
    {
      const int v = mesh_.topology.vertex(Half_facet(cell, i));
      if(v >= mesh_.number_of_interior_vertices)
        continue;
      mesh_.topology.star(v, star_);
      if(mesh_.relocate(v, star_, centroid_of_link(v)))
        return true;
    }
    return false;
  }

  // A vertex of the link counts once for each of its cells.
  Site centroid_of_link(int v) const
  {
    Site centroid = { 0, 0, 0, mesh_.sites[v].weight };
    for(Half_facet s : star_)
      for(int j = 0; j < 4; ++j)
        if(j != s.index())
        {
          const Site& p = mesh_.sites[mesh_.topology.vertex(s.in_cell(j))];
          centroid.x += p.x; centroid.y += p.y; centroid.z += p.z;
        }
    const double n = 3. * static_cast<double>(star_.size());
    centroid.x /= n; centroid.y /= n; centroid.z /= n;
    return centroid;
  }

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
