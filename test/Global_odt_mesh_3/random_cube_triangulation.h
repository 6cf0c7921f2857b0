// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_TEST_RANDOM_CUBE_TRIANGULATION_H
#define GLOBAL_ODT_MESH_3_TEST_RANDOM_CUBE_TRIANGULATION_H


#include "load_triangulation_3.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <vector>

// Random points in the unit cube, whose surface carries a regular grid, all
// displaced by `shift`; some vertices weighted on request.
inline CGAL::Global_odt_mesh_3::internal::Moving_triangulation_3
random_cube(int grid, int interior, double shift, bool weighted, std::mt19937& random)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef CGAL::Regular_triangulation_3<Kernel> Regular;
  std::uniform_real_distribution<double> u(0, 1);
  std::vector<Regular::Weighted_point> points;
  const auto add = [&](double x, double y, double z, double w)
  { points.emplace_back(Kernel::Point_3(x + shift, y + shift, z + shift), w); };
  for(int i = 0; i <= grid; ++i)
    for(int j = 0; j <= grid; ++j)
      for(int k = 0; k <= grid; ++k)
        if(i % grid == 0 || j % grid == 0 || k % grid == 0)
          add(i / double(grid), j / double(grid), k / double(grid), 0);
  const double size = std::pow(1. / interior, 1. / 3);
  for(int n = 0; n < interior; ++n)
  {
    const double w = weighted && n % 10 == 0 ? 0.05 * size * size : 0;
    add(u(random), u(random), u(random), w);
  }
  Regular tr(points.begin(), points.end());
  return CGAL::Global_odt_mesh_3::internal::load_triangulation_3(tr);
}

// The number of cells by which the flat and CGAL's exact triangulation of the
// same points differ.
inline std::size_t difference_to_exact(const CGAL::Global_odt_mesh_3::internal::Moving_triangulation_3& mesh)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef CGAL::Regular_triangulation_3<Kernel> Regular;
  typedef std::array<int, 4> Cell;
  std::set<Cell> flat, exact;
  for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
    if(mesh.topology.is_alive(c))
    {
      Cell v = mesh.topology.cell(c);
      std::sort(v.begin(), v.end());
      flat.insert(v);
    }
  Regular tr;
  std::map<Regular::Vertex_handle, int> number;
  for(std::size_t v = 0; v < mesh.sites.size(); ++v)
  {
    const CGAL::Global_odt_mesh_3::internal::Site& s = mesh.sites[v];
    number[tr.insert(Regular::Weighted_point(Kernel::Point_3(s.x, s.y, s.z), s.weight))] = static_cast<int>(v);
  }
  for(auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
  {
    Cell v;
    for(int i = 0; i < 4; ++i)
      v[i] = number[c->vertex(i)];
    std::sort(v.begin(), v.end());
    exact.insert(v);
  }
  std::vector<Cell> only;
  std::set_symmetric_difference(flat.begin(), flat.end(), exact.begin(), exact.end(), std::back_inserter(only));
  return only.size();
}

#endif // GLOBAL_ODT_MESH_3_TEST_RANDOM_CUBE_TRIANGULATION_H
