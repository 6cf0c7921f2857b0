// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_FLATTEN_TRIANGULATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_FLATTEN_TRIANGULATION_3_H

#include <CGAL/Global_odt_mesh_3/internal/Moving_triangulation_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Time_stamper.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// A facet that must stay, as it was found in the triangulation.
template <class Triangulation>
struct Wall
{
  typename Triangulation::Facet facet;
  std::array<int, 3> vertices;      // counterclockwise seen from facet.first
};

// Which vertex of the triangulation is which site, the walls, and what cannot
// change.
template <class Triangulation>
struct Flattening
{
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef CGAL::Unique_hash_map<Vertex_handle, int, CGAL::Hash_handles_with_or_without_timestamps> Site_map;
  std::vector<Vertex_handle> vertices;
  Site_map site;
  std::vector<Wall<Triangulation> > walls;
  // The cells, inside and outside, all of whose vertices stay, as sorted sites.
  std::vector<std::array<int, 4> > fixed_cells;
};

// Loads the cells of `tr` for which `is_inside` holds into flat arrays. Facets
// for which `is_wall` holds, and those between inside and outside, become walls.
// A vertex moves if `may_move` holds, it carries no weight, all its cells are
// inside and none of its facets is a wall. Vertices are numbered along Hilbert
// curves, movable ones first.
template <class Triangulation, class Is_inside, class Is_wall, class May_move, class Make_ball>
Flattening<Triangulation>
flatten_triangulation_3(const Triangulation& tr,
                        const Is_inside& is_inside,
                        const Is_wall& is_wall,
                        const May_move& may_move,
                        const Make_ball& make_ball,
                        Moving_triangulation_3& mesh)
{
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Cell_handle Cell_handle;
  typedef typename Triangulation::Facet Facet;
  typedef CGAL::Hash_handles_with_or_without_timestamps Hash;
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;

  Flattening<Triangulation> flat;
  mesh = Moving_triangulation_3();

  std::vector<Vertex_handle> handles;
  std::vector<Site> sites;
  auto& number = flat.site;
  std::vector<char> moves;
  for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
  {
    const auto& p = tr.point(v);
    number[v] = static_cast<int>(handles.size());
    handles.push_back(v);
    sites.push_back({ CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()),
                      CGAL::to_double(p.weight()) });
    moves.push_back(sites.back().weight == 0 && may_move(v));
  }

  std::vector<Cell_handle> cells;
  std::vector<std::array<int, 4> > inside_cells, outside_cells;
  std::vector<Wall<Triangulation> > outside_walls;
  CGAL::Unique_hash_map<Cell_handle, int, Hash> cell_number(-1, 2 * tr.number_of_vertices());
  std::vector<char> has_cell(handles.size(), false);
  for(auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
  {
    const bool infinite = tr.is_infinite(c);
    const bool inside = !infinite && is_inside(c);
    std::array<int, 4> v;
    for(int i = 0; i < 4; ++i)
    {
      v[i] = tr.is_infinite(c->vertex(i)) ? -1 : number[c->vertex(i)];
      if(v[i] >= 0)
        (inside ? has_cell : moves)[v[i]] = inside;
    }
    if(inside)
    {
      cell_number[c] = static_cast<int>(cells.size());
      cells.push_back(c);
      inside_cells.push_back(v);
    }
    else if(!infinite)
    {
      outside_cells.push_back(v);
      // Facets of the complex without any cell of the complex, as occur where
      // the surface folds, are no walls of the flat cells but have to stay, too.
      for(int i = 0; i < 4; ++i)
      {
        const Cell_handle d = c->neighbor(i);
        const bool second_visit = !tr.is_infinite(d) && d < Cell_handle(c);
        if(!second_visit && (tr.is_infinite(d) || !is_inside(d)) && is_wall(Facet(c, i)))
        {
          const auto& f = Flat_triangulation_3::facet_vertices(i);
          outside_walls.push_back({ Facet(c, i), {{ v[f[0]], v[f[1]], v[f[2]] }} });
        }
      }
    }
  }
  // The cell beyond each facet, or -1, and whether the facet is a wall.
  std::vector<int> beyond(4 * cells.size());
  std::vector<char> separates(beyond.size());
  for(std::size_t n = 0; n < cells.size(); ++n)
    for(int i = 0; i < 4; ++i)
    {
      beyond[4 * n + i] = cell_number[cells[n]->neighbor(i)];
      separates[4 * n + i] = beyond[4 * n + i] < 0 || is_wall(Facet(cells[n], i));
      if(separates[4 * n + i])
        for(int j : Flat_triangulation_3::facet_vertices(i))
          moves[inside_cells[n][j]] = false;
    }

  // Movable vertices first, both groups along a Hilbert curve.
  std::vector<Kernel::Point_3> points;
  points.reserve(sites.size());
  for(const Site& s : sites)
    points.emplace_back(s.x, s.y, s.z);
  std::vector<std::size_t> order(handles.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  typedef CGAL::Pointer_property_map<Kernel::Point_3>::type Point_map;
  CGAL::hilbert_sort(order.begin(), order.end(),
                     CGAL::Spatial_sort_traits_adapter_3<Kernel, Point_map>(CGAL::make_property_map(points)));
  const auto first_fixed = std::stable_partition(order.begin(), order.end(), [&](std::size_t n)
                                                 { return moves[n] && has_cell[n]; });
  mesh.number_of_movable_vertices = static_cast<int>(first_fixed - order.begin());
  std::vector<int> place(handles.size());
  for(std::size_t n = 0; n < order.size(); ++n)
  {
    place[order[n]] = static_cast<int>(n);
    flat.vertices.push_back(handles[order[n]]);
    number[handles[order[n]]] = static_cast<int>(n);
    mesh.sites.push_back(sites[order[n]]);
  }

  for(auto* group : { &inside_cells, &outside_cells })
    for(std::array<int, 4>& v : *group)
    {
      for(int& k : v)
        k = place[k];
      if(*std::min_element(v.begin(), v.end()) < mesh.number_of_movable_vertices)
        continue;
      flat.fixed_cells.push_back(v);
      std::sort(flat.fixed_cells.back().begin(), flat.fixed_cells.back().end());
    }

  // Cells, neighbors and walls. CGAL orders the vertices of a cell as we do.
  mesh.topology.reserve(handles.size(), cells.size());
  for(const std::array<int, 4>& v : inside_cells)
    mesh.topology.add_cell(v[0], v[1], v[2], v[3]);
  for(std::size_t n = 0; n < cells.size(); ++n)
    for(int i = 0; i < 4; ++i)
    {
      const Cell_handle c = cells[n], d = c->neighbor(i);
      const int slot = static_cast<int>(4 * n) + i;
      const int other = beyond[slot];
      const int mirror = other < 0 ? -1 : 4 * other + d->index(c);
      if(!separates[slot])
      {
        if(slot < mirror)
          mesh.topology.set_neighbors(slot, mirror);
        continue;
      }
      if(mirror >= 0 && mirror < slot)
        continue;
      const int wall = static_cast<int>(flat.walls.size());
      const auto& f = Flat_triangulation_3::facet_vertices(i);
      flat.walls.push_back({ Facet(c, i), {{ mesh.topology.vertex(slot - i + f[0]),
                                             mesh.topology.vertex(slot - i + f[1]),
                                             mesh.topology.vertex(slot - i + f[2]) }} });
      mesh.wall_balls.push_back(make_ball(Facet(c, i)));
      mesh.topology.set_neighbors(slot, ~wall);
      if(mirror >= 0)
        mesh.topology.set_neighbors(mirror, ~wall);
    }
  for(Wall<Triangulation>& wall : outside_walls)
  {
    for(int& v : wall.vertices)
      v = place[v];
    flat.walls.push_back(wall);
    mesh.wall_balls.push_back(make_ball(wall.facet));
  }
  mesh.topology.compact();
  return flat;
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_FLATTEN_TRIANGULATION_3_H
