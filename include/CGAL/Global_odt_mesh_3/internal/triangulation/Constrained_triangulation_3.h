// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_CONSTRAINED_TRIANGULATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_CONSTRAINED_TRIANGULATION_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// A triangulation of weighted sites whose constrained facets stay.
//
// The vertices [0, number_of_interior_vertices) move in space, and no constrained facet touches
// them; those up to number_of_movable_vertices move along with their constrained facets.
struct Constrained_triangulation_3
{
  Indexed_triangulation_3 topology;
  std::vector<Site> sites;
  int number_of_interior_vertices = 0;
  int number_of_movable_vertices = 0;

  int number_of_surface_vertices() const { return number_of_movable_vertices - number_of_interior_vertices; }

  Cell_products products(int cell) const
  {
    CGAL_assertion(topology.is_alive(cell));
    const int* const v = topology.vertices(cell);
    return products(v[0], v[1], v[2], v[3]);
  }

  Cell_products products(int a, int b, int c, int d) const
  {
    return Cell_products(sites[a], sites[b], sites[c], sites[d]);
  }

  bool is_inverted(int cell) const { return topology.is_alive(cell) && is_inverted(products(cell)); }

  // The cell is inverted by more than rounding errors. A cell that is so flat may have vertices that stay, as in structured meshes,
  // and then nothing would ever untangle it.
  static bool is_inverted(const Cell_products& t)
  {
    return !(t.determinant > 0) && !(t.determinant > -1e-14 * t.cubed_length());
  }

  double determinant(int a, int b, int c, int d) const { return products(a, b, c, d).determinant; }

  std::array<Site, 4> cell_sites(int cell) const
  {
    const int* const v = topology.vertices(cell);
    return {{ sites[v[0]], sites[v[1]], sites[v[2]], sites[v[3]] }};
  }

  // Six times the volumes of the cells that flip_2_3() would make.
  std::array<double, 3> volumes_after_2_3(Half_facet s) const
  {
    const int a = topology.vertex(s), b = topology.vertex(topology.neighbor(s));
    const std::array<int, 3> f = topology.facet(s);
    return {{ determinant(a, b, f[1], f[2]), determinant(a, b, f[2], f[0]), determinant(a, b, f[0], f[1]) }};
  }

  double squared_distance(int u, int v) const { return squared_distance(sites[u], sites[v]); }

  static double squared_distance(const Site& a, const Site& b)
  {
    const double x = a.x - b.x, y = a.y - b.y, z = a.z - b.z;
    return x * x + y * y + z * z;
  }

  // Flips must gain more than rounding can feign, or they would cycle: the
  // power is compared with a length to the fifth around the tested vertex.
  static bool is_irregular(double power, double squared_length)
  {
    return power < 0 && power < -1e-11 * squared_length * squared_length * std::sqrt(squared_length);
  }

  // Appends the facet if flips may remove it.
  void push_facet(Half_facet s, std::vector<Half_facet>& facets) const
  {
    if(!topology.neighbor(s).is_side())
      facets.push_back(s);
  }

  // The same for those of a cell.
  void push_facets(int cell, std::vector<Half_facet>& facets) const
  {
    for(int i = 0; i < 4; ++i)
      push_facet(Half_facet(cell, i), facets);
  }

  // The mean length of the edges of each movable vertex; an edge counts once for
  // each of its cells.
  void mean_edge_lengths(std::vector<double>& length) const { mean_edge_lengths(number_of_movable_vertices, length); }

  // The same of the first vertices, or 0 if they have no cell.
  void mean_edge_lengths(int number_of_vertices, std::vector<double>& length) const
  {
    length.assign(number_of_vertices, 0);
    std::vector<int> count(number_of_vertices, 0);
    for_each_edge([&](int u, int v, double squared_length)
    {
      for(int w : { u, v })
        if(w < number_of_vertices)
        {
          length[w] += std::sqrt(squared_length);
          ++count[w];
        }
    });
    for(int v = 0; v < number_of_vertices; ++v)
      length[v] /= (std::max)(1, count[v]);
  }

  // The shortest edge of each movable vertex.
  void shortest_edges(std::vector<double>& length) const
  {
    length.assign(number_of_movable_vertices, (std::numeric_limits<double>::max)());
    for_each_edge([&](int u, int v, double squared_length)
    {
      for(int w : { u, v })
        if(w < number_of_movable_vertices && squared_length < length[w])
          length[w] = squared_length;
    });
    for(double& l : length)
      l = std::sqrt(l);
  }

  // Calls f(u, v, squared length) for the edges of all cells.
  template <class F>
  void for_each_edge(const F& f) const
  {
    for(int c = 0; c < topology.number_of_cell_slots(); ++c)
      for(int i = 0; i < 3 && topology.is_alive(c); ++i)
        for(int j = i + 1; j < 4; ++j)
        {
          const int u = topology.vertices(c)[i], v = topology.vertices(c)[j];
          f(u, v, squared_distance(sites[u], sites[v]));
        }
  }
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_CONSTRAINED_TRIANGULATION_3_H
