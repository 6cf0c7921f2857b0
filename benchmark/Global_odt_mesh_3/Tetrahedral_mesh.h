// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_TETRAHEDRAL_MESH_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_TETRAHEDRAL_MESH_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

// Points and positively oriented cells, whichever program has made them.
struct Tetrahedral_mesh
{
  std::vector<Eigen::Vector3d> points;
  std::vector<std::array<int, 4> > cells;

  // For a mesh of the cube [-1, 1]^3.
  bool is_on_boundary(std::size_t v) const { return points[v].cwiseAbs().maxCoeff() > 1 - 1e-9; }

  std::size_t number_of_boundary_vertices() const
  {
    std::size_t number = 0;
    for(std::size_t v = 0; v < points.size(); ++v)
      number += is_on_boundary(v);
    return number;
  }

  double determinant(const std::array<int, 4>& c) const
  {
    const Eigen::Vector3d& o = points[c[0]];
    return (points[c[1]] - o).cross(points[c[2]] - o).dot(points[c[3]] - o);
  }

  void orient()
  {
    for(std::array<int, 4>& c : cells)
      if(determinant(c) < 0)
        std::swap(c[2], c[3]);
  }

  double volume() const
  {
    double sum = 0;
    for(const std::array<int, 4>& c : cells)
      sum += determinant(c) / 6;
    return sum;
  }

  double mean_radius_ratio() const
  {
    using namespace CGAL::Global_odt_mesh_3::internal;
    double sum = 0;
    const auto site = [this](int v) { return site_at(coordinates(points[v]), 0); };
    for(const std::array<int, 4>& c : cells)
      sum += Cell_shape_3(site(c[0]), site(c[1]), site(c[2]), site(c[3])).radius_ratio;
    return sum / double(cells.size());
  }
};

// That of the unit cube, blown up.
inline Tetrahedral_mesh tetrahedral_mesh(const CGAL::Global_odt_mesh_3::internal::Moving_triangulation_3& unit_cube)
{
  Tetrahedral_mesh mesh;
  for(const auto& s : unit_cube.sites)
    mesh.points.emplace_back(2 * s.x - 1, 2 * s.y - 1, 2 * s.z - 1);
  for(int c = 0; c < unit_cube.topology.number_of_cell_slots(); ++c)
    if(unit_cube.topology.is_alive(c))
      mesh.cells.push_back(unit_cube.topology.cell(c));
  mesh.orient();
  return mesh;
}

// A grid of so many cubes along an edge, each of six cells around the same diagonal.
inline Tetrahedral_mesh structured_mesh(int grid)
{
  Tetrahedral_mesh mesh;
  const auto number = [grid](int i, int j, int k) { return (i * (grid + 1) + j) * (grid + 1) + k; };
  for(int i = 0; i <= grid; ++i)
    for(int j = 0; j <= grid; ++j)
      for(int k = 0; k <= grid; ++k)
        mesh.points.emplace_back(2. * i / grid - 1, 2. * j / grid - 1, 2. * k / grid - 1);
  for(int i = 0; i < grid; ++i)
    for(int j = 0; j < grid; ++j)
      for(int k = 0; k < grid; ++k)
      {
        std::array<int, 3> axes = {{ 0, 1, 2 }};
        do
        {
          std::array<int, 3> p = {{ i, j, k }};
          std::array<int, 4> cell = {{ number(i, j, k), 0, 0, 0 }};
          for(int n = 0; n < 3; ++n)
          {
            ++p[axes[n]];
            cell[n + 1] = number(p[0], p[1], p[2]);
          }
          mesh.cells.push_back(cell);
        } while(std::next_permutation(axes.begin(), axes.end()));
      }
  mesh.orient();
  return mesh;
}

// Reads the vertices and tetrahedra of a file in the format of Medit; there are none if it cannot be read. Vertices of no
// cell are left out.
inline Tetrahedral_mesh read_medit(const std::string& file)
{
  Tetrahedral_mesh mesh;
  std::ifstream in(file);
  std::vector<Eigen::Vector3d> points;
  for(std::string word; in >> word; )
  {
    std::size_t number = 0;
    double reference = 0;
    if(word[0] == '#')
      std::getline(in, word);
    else if(word == "Vertices" && in >> number)
    {
      points.resize(number);
      for(Eigen::Vector3d& p : points)
        in >> p[0] >> p[1] >> p[2] >> reference;
    }
    else if(word == "Tetrahedra" && in >> number)
    {
      mesh.cells.resize(number);
      for(std::array<int, 4>& c : mesh.cells)
      {
        in >> c[0] >> c[1] >> c[2] >> c[3] >> reference;
        for(int& v : c)
          --v;
      }
    }
  }
  std::vector<int> renumbered(points.size(), -1);
  for(std::array<int, 4>& c : mesh.cells)
    for(int& v : c)
    {
      if(renumbered[v] < 0)
      {
        renumbered[v] = static_cast<int>(mesh.points.size());
        mesh.points.push_back(points[v]);
      }
      v = renumbered[v];
    }
  mesh.orient();
  return mesh;
}

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_TETRAHEDRAL_MESH_H
