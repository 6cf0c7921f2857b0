// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVER_REMOVAL_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVER_REMOVAL_3_H

#include <CGAL/Global_odt_mesh_3/internal/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Constrained_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/Vertex_trial_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

struct Sliver_removal_parameters
{
  double margin = 2;                // degrees by which cells should exceed the bound: surfaces may take some away
  int tries_per_vertex = 16;
  double far = 0.35, near = 0.12;   // the longest tries, over the mean incident edge length, in turn
  int most_failures = 3;            // for the same cell
  int most_passes = 12;
};

// Removes the cells with dihedral angles below a bound by moving single vertices: each vertex of
// such a cell tries random positions around it, and the one that lowers the deficit of the angles
// most is taken. That disturbs few vertices, so that the energy hardly rises.
class Sliver_removal_3
{
public:
  // Moves a site for a vertex to where that vertex may be; false if it has to stay.
  typedef std::function<bool(int, Site&)> Motion;

  // Without a motion, vertices of the interior go anywhere, and those on surfaces stay.
  Sliver_removal_3(Constrained_triangulation_3& mesh, double bound, unsigned int seed,
                   Motion motion = Motion(),
                   const Sliver_removal_parameters& parameters = Sliver_removal_parameters())
    : mesh_(mesh)
    , parameters_(parameters)
    , trial_(mesh, bound + parameters.margin)
    , motion_(std::move(motion))
    , random_(seed)
  {
    mesh.mean_edge_lengths(edge_length_);
  }

  std::size_t number_of_moves() const { return number_of_moves_; }
  std::size_t number_of_surface_moves() const { return number_of_surface_moves_; }

  // Until there are no such cells, nothing improves them any more, or `may_go_on()`, asked before
  // each of them, says no.
  template <class Predicate>
  void run(const Predicate& may_go_on)
  {
    for(int n = 0; n < parameters_.most_passes && pass(may_go_on); ++n) {}
  }

  void run() { run([] { return true; }); }

private:
  // Whether something has been improved. The worst cells come first.
  template <class Predicate>
  bool pass(const Predicate& may_go_on)
  {
    std::vector<std::pair<double, int> > slivers;
    for(int c = 0; c < mesh_.topology.number_of_cell_slots(); ++c)
      if(trial_.deficit(c) > 0)
        slivers.emplace_back(-trial_.deficit(c), c);
    std::sort(slivers.begin(), slivers.end());
    bool improved = false;
    for(const auto& s : slivers)
    {
      if(!may_go_on())
        return false;
      if(trial_.deficit(s.second) > 0 && improve(s.second))
        improved = true;
    }
    return improved;
  }

  bool improve(int cell)
  {
    if(failures_.size() <= static_cast<std::size_t>(cell))
      failures_.resize(mesh_.topology.number_of_cell_slots());
    Failures& failures = failures_[cell];
    if(failures.deficit != trial_.deficit(cell))
      failures = { trial_.deficit(cell), 0 };
    if(failures.number == parameters_.most_failures)
      return false;
    std::array<int, 4> vertices;
    std::copy_n(mesh_.topology.cell_vertices() + 4 * cell, 4, vertices.begin());
    // Those of the interior come first: that needs no question to the domain.
    std::sort(vertices.begin(), vertices.end());
    best_change_ = -least_improvement;
    best_vertex_ = -1;
    for(int v : vertices)
      if(v < mesh_.number_of_movable_vertices && try_positions(v))
        return true;
    if(best_vertex_ < 0)
    {
      ++failures.number;
      return false;
    }
    trial_.move(best_vertex_, best_site_);
    accept(best_vertex_);
    return true;
  }

  // Whether one was found, and accepted, that leaves no deficit.
  bool try_positions(int v)
  {
    for(int n = 0; n < parameters_.tries_per_vertex; ++n)
    {
      Site s = mesh_.sites[v];
      const Eigen::Vector3d d = edge_length_[v] * random_.uniform()
                                * (n % 2 == 0 ? parameters_.far : parameters_.near) * random_.direction();
      s = { s.x + d[0], s.y + d[1], s.z + d[2], s.weight };
      if(motion_ ? !motion_(v, s) : is_on_surface(v))
        return false;
      const double change = trial_.move(v, s);
      if(change < -least_improvement && trial_.deficit_after() == 0)
      {
        accept(v);
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

  void accept(int v)
  {
    trial_.accept();
    ++number_of_moves_;
    number_of_surface_moves_ += is_on_surface(v);
  }

  bool is_on_surface(int v) const { return v >= mesh_.number_of_interior_vertices; }

  // How often a cell has been tried in vain.
  struct Failures
  {
    double deficit = 0;
    int number = 0;
  };

  static constexpr double least_improvement = 1e-6;     // square degrees

  Constrained_triangulation_3& mesh_;
  Sliver_removal_parameters parameters_;
  Vertex_trial_3 trial_;
  Motion motion_;
  Random_source random_;
  std::vector<double> edge_length_;
  std::vector<Failures> failures_;
  double best_change_ = 0;
  int best_vertex_ = -1;
  Site best_site_ = { 0, 0, 0, 0 };
  std::size_t number_of_moves_ = 0, number_of_surface_moves_ = 0;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVER_REMOVAL_3_H
