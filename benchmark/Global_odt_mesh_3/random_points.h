// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_RANDOM_POINTS_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_RANDOM_POINTS_H


#include "load_triangulation_3.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

// Points of the surface of the unit cube that stay: a grid of squares, which give right-angled
// facets, or rows shifted by half a step, which give nearly equilateral ones.
enum class Cube_surface { SQUARES, SHIFTED_ROWS };

typedef std::array<double, 3> Coordinates;

inline std::vector<Coordinates> squares_on_cube(int grid)
{
  std::vector<Coordinates> points;
  for(int i = 0; i <= grid; ++i)
    for(int j = 0; j <= grid; ++j)
      for(int k = 0; k <= grid; ++k)
        if(i % grid == 0 || j % grid == 0 || k % grid == 0)
          points.push_back({{ double(i) / grid, double(j) / grid, double(k) / grid }});
  return points;
}

inline std::vector<Coordinates> shifted_rows_on_cube(int grid)
{
  std::vector<Coordinates> points;
  for(int axis = 0; axis < 3; ++axis)
  {
    const auto add = [&](double x, double y, double z)
    {
      Coordinates p;
      p[axis] = x;
      p[(axis + 1) % 3] = y;
      p[(axis + 2) % 3] = z;
      points.push_back(p);
    };
    // The corners go with the edges of the first axis.
    const int first = axis == 0 ? 0 : 1;
    for(int y : { 0, 1 })
      for(int z : { 0, 1 })
        for(int k = first; k <= grid - first; ++k)
          add(double(k) / grid, y, z);
    const int rows = static_cast<int>(std::lround(2 * grid / std::sqrt(3.)));
    for(int x : { 0, 1 })
      for(int row = 1; row < rows; ++row)
        for(int k = 1; k <= grid - 1 + row % 2; ++k)
          add(x, double(row) / rows, (k - 0.5 * (row % 2)) / grid);
  }
  return points;
}

// The Delaunay triangulation of points, of which those on the convex hull stay.
inline CGAL::Global_odt_mesh_3::internal::Moving_triangulation_3 triangulate(const std::vector<Coordinates>& points)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef CGAL::Regular_triangulation_3<Kernel> Regular;
  std::vector<Regular::Weighted_point> weighted;
  for(const Coordinates& p : points)
    weighted.emplace_back(Kernel::Point_3(p[0], p[1], p[2]), 0);
  const Regular tr(weighted.begin(), weighted.end());
  return CGAL::Global_odt_mesh_3::internal::load_triangulation_3(tr);
}

// Adds points of the cube [-1, 1]^3 with probability `density`, which is one at most, until there are so many.
template <class Density>
void add_random_points(unsigned int seed, std::size_t number, const Density& density, std::vector<Coordinates>& points)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(-1, 1), probability(0, 1);
  while(points.size() < number)
  {
    Coordinates p;
    for(double& x : p)
      x = u(random);
    if(probability(random) < density(p))
      points.push_back(p);
  }
}

// The unit cube with this number of vertices, random in the interior, but not closer to the surface than that part of
// an edge on it. With 18,083 vertices, there are 3,752 on a surface of squares, 3,782 on one of shifted rows.
inline CGAL::Global_odt_mesh_3::internal::Moving_triangulation_3
random_cube(unsigned int seed, std::size_t number_of_vertices = 18083, Cube_surface surface = Cube_surface::SQUARES,
            double least_distance = 0)
{
  const double growth = std::cbrt(static_cast<double>(number_of_vertices) / 18083);
  const int grid = static_cast<int>(std::lround((surface == Cube_surface::SQUARES ? 25 : 23) * growth));
  std::vector<Coordinates> points = surface == Cube_surface::SQUARES ? squares_on_cube(grid) : shifted_rows_on_cube(grid);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(least_distance / grid, 1 - least_distance / grid);
  while(points.size() < number_of_vertices)
  {
    const double x = u(random), y = u(random), z = u(random);
    points.push_back({{ x, y, z }});
  }
  return triangulate(points);
}

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_RANDOM_POINTS_H
