// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_PERIODIC_COMPLEX_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_PERIODIC_COMPLEX_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// A number of periods in each direction.
typedef std::array<int, 3> Periods;

inline Periods operator+(const Periods& a, const Periods& b) { return {{ a[0] + b[0], a[1] + b[1], a[2] + b[2] }}; }
inline Periods operator-(const Periods& a, const Periods& b) { return {{ a[0] - b[0], a[1] - b[1], a[2] - b[2] }}; }

// The cube that is repeated.
struct Periodic_cube_3
{
  Vector_3 corner;
  double period;

  // How many periods lead from `p` into the cube at some corner.
  Periods periods_into(const Vector_3& p, const Vector_3& from) const
  {
    Periods n;
    for(int i = 0; i < 3; ++i)
      n[i] = -static_cast<int>(std::floor((p[i] - from[i]) / period));
    return n;
  }

  Vector_3 translated(const Vector_3& p, const Periods& n) const { return p + period * Vector_3(n[0], n[1], n[2]); }

  // If rounding leads out of the cube, the opposite side is as good.
  Vector_3 canonical(const Vector_3& p) const
  {
    Vector_3 q = translated(p, periods_into(p, corner));
    for(int i = 0; i < 3; ++i)
      if(!(q[i] >= corner[i] && q[i] < corner[i] + period))
        q[i] = corner[i];
    return q;
  }
};

// A complex in a periodic triangulation of one sheet, in numbers. As the triangulation is a simplicial complex, the vertices
// of a cell or facet say which it is.
struct Periodic_complex_3
{
  struct Cell
  {
    Quadruple vertices, neighbors;
    std::array<Periods, 4> offsets;       // from the vertices to those of the cell
    int label;
  };

  // A facet in the complex.
  struct Facet
  {
    int cell, index;
    int patch;
    Vector_3 center;
  };

  Periodic_cube_3 cube;
  std::vector<Site> sites;                // in the cube
  std::vector<int> dimensions, patches;   // a patch for those of dimension 2
  std::vector<Cell> cells;
  std::vector<Facet> facets;              // from one side

  bool is_inside(const Cell& c) const { return c.label != Domain_view_3::outside; }

  std::array<Site, 4> cell_sites(const Cell& c) const
  {
    std::array<Site, 4> s;
    for(int i = 0; i < 4; ++i)
    {
      const Site& v = sites[c.vertices[i]];
      s[i] = site_at(cube.translated(position(v), c.offsets[i]), v.weight);
    }
    return s;
  }

  Triple facet_vertices(const Facet& f) const
  {
    const Quadruple& v = cells[f.cell].vertices;
    return {{ v[(f.index + 1) & 3], v[(f.index + 2) & 3], v[(f.index + 3) & 3] }};
  }

  // The labels on the two sides, sorted.
  std::array<int, 2> labels(const Facet& f) const
  {
    const Cell& c = cells[f.cell];
    return sorted(std::array<int, 2>{{ c.label, cells[c.neighbors[f.index]].label }});
  }

  // Chooses those, too, that have a cell in common with a chosen one. False if there are none.
  bool add_neighbors(std::vector<char>& is_chosen) const
  {
    const std::vector<char> before = is_chosen;
    for(const Cell& c : cells)
      if(std::any_of(c.vertices.begin(), c.vertices.end(), [&](int v) { return before[v]; }))
        for(int v : c.vertices)
          is_chosen[v] = true;
    return is_chosen != before;
  }

  // The length of the shortest edge at vertices that are inside of a subdomain, not on a surface and without a weight; 0 for all others.
  std::vector<double> freedom_of_interior() const
  {
    constexpr double none = (std::numeric_limits<double>::max)();
    std::vector<double> result(sites.size(), none);
    for(const Cell& c : cells)
    {
      const std::array<Site, 4> s = cell_sites(c);
      for(int i = 0; i < 4; ++i)
        for(int j = 0; j < 4; ++j)
          if(i != j)
            result[c.vertices[i]] = (std::min)(result[c.vertices[i]], is_inside(c) ? (position(s[i]) - position(s[j])).length() : 0.);
    }
    for(const Facet& f : facets)
      for(int v : facet_vertices(f))
        result[v] = 0;
    for(std::size_t v = 0; v < sites.size(); ++v)
      if((dimensions[v] >= 0 && dimensions[v] < 3) || sites[v].weight != 0)
        result[v] = 0;
    return result;
  }

  // Over all subdomains.
  Sliver_census_3 slivers() const
  {
    Sliver_census_3 census;
    for(const Cell& c : cells)
      if(is_inside(c))
        census.add(cell_sites(c), c.label);
    return census;
  }

  // Below an angle.
  std::size_t number_of_slivers(double angle) const
  {
    const Angle_deficit_3 deficit(angle);
    return static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), [&](const Cell& c)
                                                  { return is_inside(c) && deficit(cell_sites(c)) > 0; }));
  }

  // The sum of what is missing of an angle in all cells, in square degrees.
  double deficit(double angle) const
  {
    const Angle_deficit_3 deficit(angle);
    return std::accumulate(cells.begin(), cells.end(), 0., [&](double sum, const Cell& c)
                           { return is_inside(c) ? sum + deficit(cell_sites(c)) : sum; });
  }

  // Six times those of the subdomains.
  std::map<int, double> volumes() const
  {
    std::map<int, double> volume;
    for(const Cell& c : cells)
    {
      const std::array<Site, 4> s = cell_sites(c);
      volume[c.label] += Cell_products(s[0], s[1], s[2], s[3]).determinant;
    }
    return volume;
  }

  // For each patch, the Euler characteristic, and how many edges have one facet of it, and more than two.
  std::map<int, std::array<long, 3> > topology_of_patches() const
  {
    std::map<int, std::vector<Triple> > facets_of_patch;
    for(const Facet& f : facets)
      facets_of_patch[f.patch].push_back(facet_vertices(f));
    std::map<int, std::array<long, 3> > result;
    for(const auto& p : facets_of_patch)
      result[p.first] = topology(p.second);
    return result;
  }

private:
  static std::array<long, 3> topology(const std::vector<Triple>& triangles)
  {
    std::map<std::array<int, 2>, int> facets_at_edge;
    std::vector<int> vertices;
    for(const Triple& t : triangles)
      for(int i = 0; i < 3; ++i)
      {
        vertices.push_back(t[i]);
        ++facets_at_edge[sorted(std::array<int, 2>{{ t[i], t[(i + 1) % 3] }})];
      }
    std::sort(vertices.begin(), vertices.end());
    const long number = std::unique(vertices.begin(), vertices.end()) - vertices.begin();
    std::array<long, 3> result = {{ number - long(facets_at_edge.size()) + long(triangles.size()), 0, 0 }};
    for(const auto& e : facets_at_edge)
      if(e.second != 2)
        ++result[e.second == 1 ? 1 : 2];
    return result;
  }
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_PERIODIC_COMPLEX_3_H
