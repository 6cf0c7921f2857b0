// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_RANDOM_CUBE_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_RANDOM_CUBE_H

#include <CGAL/Global_odt_mesh_3/internal/Load_triangulation_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

// The unit cube with this number of vertices, of which a grid on the surface stays; the
// interior is random. With 18,083 vertices, the grid has 3,752.
inline CGAL::Global_odt_mesh_3::internal::Moving_triangulation_3
random_cube(unsigned int seed, std::size_t number_of_vertices = 18083)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef CGAL::Regular_triangulation_3<Kernel> Regular;
  const int grid = static_cast<int>(std::lround(25 * std::cbrt(static_cast<double>(number_of_vertices) / 18083)));
  std::vector<Regular::Weighted_point> points;
  for(int i = 0; i <= grid; ++i)
    for(int j = 0; j <= grid; ++j)
      for(int k = 0; k <= grid; ++k)
        if(i % grid == 0 || j % grid == 0 || k % grid == 0)
          points.emplace_back(Kernel::Point_3(double(i) / grid, double(j) / grid, double(k) / grid), 0);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(0, 1);
  while(points.size() < number_of_vertices)
  {
    const double x = u(random), y = u(random), z = u(random);
    points.emplace_back(Kernel::Point_3(x, y, z), 0);
  }
  const Regular tr(points.begin(), points.end());
  return CGAL::Global_odt_mesh_3::internal::load_triangulation_3(tr);
}

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_RANDOM_CUBE_H
