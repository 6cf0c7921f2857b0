// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVER_REMOVAL_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVER_REMOVAL_3_H

#include <CGAL/Global_odt_mesh_3/internal/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Constrained_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Vertex_trial_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <random>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

struct Sliver_removal_parameters
{
  int tries = 16;                   // of a vertex
  double far = 0.35, near = 0.12;   // the lengths of tries, over the mean incident edge length, in turn
  int passes = 12;
  int failures = 3;
};

class Sliver_removal_3
{
public:
  // Puts a vertex on the surface; false if it is not to be moved there.
  typedef std::function<bool(int, Site&)> Projection;

  Sliver_removal_3(Constrained_triangulation_3& mesh, double bound, unsigned int seed, Projection projection = Projection(),
                   const Sliver_removal_parameters& parameters = Sliver_removal_parameters())
    : mesh_(mesh)
    , parameters_(parameters)
    , angle_deficit_(bound)
    , trial_(mesh, angle_deficit_)
    , projection_(std::move(projection))
    , random_(seed)
  {
    mesh.mean_edge_lengths(edge_length_);
  }

  std::size_t trials = 0, moves = 0, attempts = 0;

  // One pass; gives the number of improvements.
  std::size_t pass()
  {
    std::vector<std::pair<double, int> > slivers;
    for(int c = 0; c < mesh_.topology.number_of_cell_slots(); ++c)
      if(mesh_.topology.is_alive(c) && trial_.deficit(c) > 0)
        slivers.emplace_back(-trial_.deficit(c), c);
    std::sort(slivers.begin(), slivers.end());
    failures_.resize(2 * mesh_.topology.number_of_cell_slots());
    std::size_t improved = 0;
    for(const auto& s : slivers)
      if(mesh_.topology.is_alive(s.second) && trial_.deficit(s.second) > 0)
        improved += improve(s.second);
    return improved;
  }

  double total() const
  {
    double t = 0;
    for(int c = 0; c < mesh_.topology.number_of_cell_slots(); ++c)
      if(mesh_.topology.is_alive(c))
        t += trial_.deficit(c);
    return t;
  }

private:
  bool improve(int cell)
  {
    Failures& failures = failures_[cell];
    if(failures.deficit != trial_.deficit(cell))
      failures = { trial_.deficit(cell), 0 };
    if(failures.number == parameters_.failures)
      return false;
    std::array<int, 4> vertices;
    for(int i = 0; i < 4; ++i)
      vertices[i] = mesh_.topology.vertex(4 * cell + i);
    // Those of the interior first.
    std::sort(vertices.begin(), vertices.end());
    ++attempts;
    best_change_ = -1e-9;
    best_vertex_ = -1;
    for(int v : vertices)
    {
      if(v < mesh_.number_of_movable_vertices && try_positions(v))
        return true;
    }
    if(best_vertex_ < 0)
    {
      ++failures.number;
      return false;
    }
    trial_.move(best_vertex_, best_site_);
    trial_.accept();
    ++moves;
    return true;
  }

  // Whether one was found, and accepted, that leaves no deficit.
  bool try_positions(int v)
  {
    for(int n = 0; n < parameters_.tries; ++n)
    {
      Site s = mesh_.sites[v];
      if(!displace(v, (n % 2 == 0 ? parameters_.far : parameters_.near) * edge_length_[v], s))
        return false;
      ++trials;
      const double change = trial_.move(v, s);
      if(change < best_change_ && trial_.deficit_after() == 0)
      {
        trial_.accept();
        ++moves;
        return true;
      }
      trial_.reject();
      if(change < best_change_)
      {
        best_change_ = change;
        best_vertex_ = v;
        best_site_ = s;
      }
    }
    return false;
  }

  bool displace(int v, double length, Site& s)
  {
    double x, y, z, d;
    do
    {
      x = 2 * uniform() - 1;
      y = 2 * uniform() - 1;
      z = 2 * uniform() - 1;
      d = x * x + y * y + z * z;
    }
    while(d > 1);
    s.x += length * x;
    s.y += length * y;
    s.z += length * z;
    return v < mesh_.number_of_interior_vertices || (projection_ && projection_(v, s));
  }

  double uniform() { return std::ldexp(double(random_()), -32); }

  // How often a cell could not be improved in vain.
  struct Failures
  {
    double deficit = 0;
    int number = 0;
  };

  Constrained_triangulation_3& mesh_;
  Sliver_removal_parameters parameters_;
  Angle_deficit_3 angle_deficit_;
  Vertex_trial_3 trial_;
  Projection projection_;
  std::mt19937 random_;
  std::vector<double> edge_length_;
  std::vector<Failures> failures_;
  double best_change_;
  int best_vertex_;
  Site best_site_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVER_REMOVAL_3_H
