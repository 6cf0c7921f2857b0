// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ODT_MESH_OPTIMIZER_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ODT_MESH_OPTIMIZER_3_H

#include <CGAL/Global_odt_mesh_3/internal/C3t3_bridge_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Input_density_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Limited_memory_bfgs.h>
#include <CGAL/Global_odt_mesh_3/internal/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Odt_parameters.h>

#include <CGAL/Mesh_optimization_return_code.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Algorithm 1 of the paper on a c3t3: load, minimize, store.
template <class C3t3, class Mesh_domain, class Visitor>
class Odt_mesh_optimizer_3
{
public:
  Odt_mesh_optimizer_3(C3t3& c3t3, const Mesh_domain& domain,
                       const Odt_parameters& parameters, Visitor& visitor)
    : bridge_(c3t3, domain)
    , parameters_(parameters)
    , visitor_(visitor)
  {}

  Mesh_optimization_return_code operator()()
  {
    timer_.start();
    bridge_.load(mesh_);
    if(mesh_.number_of_movable_vertices == 0)
      return parameters_.do_freeze ? ALL_VERTICES_FROZEN : CONVERGENCE_REACHED;

    Input_density_3 input_density(mesh_);
    Odt_objective_3::Density density;
    if(!input_density.is_uniform())
    {
      mesh_.density.resize(mesh_.sites.size());
      for(std::size_t v = 0; v < mesh_.sites.size(); ++v)
        mesh_.density[v] = input_density.density(input_density.sizes()[v]);
      density = [&input_density](int v, const Site& s)
                { return input_density.density(input_density.size(v, s)); };
    }
    Odt_objective_3 objective(mesh_, density);
    if(!objective.is_feasible())
      return CANT_IMPROVE_ANYMORE;

    const Mesh_optimization_return_code code = minimize(objective, !input_density.is_uniform());
    if(number_of_iterations_ > 0 && !bridge_.store(mesh_))
      return CANT_IMPROVE_ANYMORE;
    visitor_.after_rebuild_restricted_delaunay();
    return code;
  }

private:
  // As CGAL's optimizers, which bound the number of iterations even if the user
  // does not.
  static constexpr std::size_t most_iterations = 1000;
  static constexpr std::size_t iterations_between_compactions = 50;
  static constexpr int iterations_to_freeze = 6;

  Mesh_optimization_return_code minimize(Odt_objective_3& objective, bool is_graded)
  {
    Limited_memory_bfgs_parameters p;
    if(is_graded)
    {
      // (4.6) is not the derivative of the interpolated energy (4.1), so that
      // (4.1) cannot be asked to fall.
      p.memory = 15;
      p.energy_tolerance = 1e-3;
    }
    Limited_memory_bfgs minimizer(p);
    const std::size_t limit = parameters_.max_iteration_number == 0 ? most_iterations
                                                                    : parameters_.max_iteration_number;
    for(;;)
    {
      if(is_time_limit_reached())
        return TIME_LIMIT_REACHED;
      const double displacement = compute_displacements(objective);
      if(parameters_.do_freeze && objective.number_of_frozen_vertices() == mesh_.number_of_movable_vertices)
        return ALL_VERTICES_FROZEN;
      if(displacement < parameters_.convergence)
        return CONVERGENCE_REACHED;
      if(number_of_iterations_ == limit)
        return MAX_ITERATION_NUMBER_REACHED;
      if(!report_progress(displacement, limit))
        return TIME_LIMIT_REACHED;
      visitor_.after_compute_moves();

      if(minimizer.iterate(objective) == Limited_memory_bfgs::NO_STEP_FOUND)
        return CANT_IMPROVE_ANYMORE;
      visitor_.after_move_points();
      visitor_.end_of_iteration(static_cast<int>(number_of_iterations_));
      ++number_of_iterations_;
      if(number_of_iterations_ % iterations_between_compactions == 0)
      {
        mesh_.topology.compact();
        mesh_.keep();
      }
    }
  }

  bool is_time_limit_reached() const
  {
    return parameters_.time_limit > 0 && timer_.time() > parameters_.time_limit;
  }

  // The displacement of a vertex is the length of the AVV move (2.3), |g|/D,
  // over its shortest edge. Freezes the vertices that are below freeze_bound for
  // some iterations and returns the mean of the largest displacements, one in five hundred.
  double compute_displacements(Odt_objective_3& objective)
  {
    const int n = mesh_.number_of_movable_vertices;
    mesh_.shortest_edges(shortest_edge_);
    displacement_.resize(n);
    still_.resize(n, 0);
    const Eigen::VectorXd& g = objective.gradient();
    const Eigen::VectorXd& d = objective.diagonal();
    for(int v = 0; v < n; ++v)
    {
      displacement_[v] = g.segment<3>(3 * v).norm() / (d[3 * v] * shortest_edge_[v]);
      // A vertex may come to rest for a moment while those around it still move.
      still_[v] = displacement_[v] < parameters_.freeze_bound ? still_[v] + 1 : 0;
      if(parameters_.do_freeze && still_[v] == iterations_to_freeze)
        objective.freeze(v);
    }
    const std::size_t count = (std::max)(std::size_t(1), static_cast<std::size_t>(n) / 500);
    std::nth_element(displacement_.begin(), displacement_.begin() + (count - 1), displacement_.end(),
                     std::greater<double>());
    return std::accumulate(displacement_.begin(), displacement_.begin() + count, 0.) / double(count);
  }

  // The fraction done is the largest of those of time, iterations, and orders of
  // magnitude of displacement.
  bool report_progress(double displacement, std::size_t limit)
  {
    if(!parameters_.callback)
      return true;
    if(number_of_iterations_ == 0)
      first_displacement_ = displacement;
    double fraction = double(number_of_iterations_) / double(limit);
    if(parameters_.time_limit > 0)
      fraction = (std::max)(fraction, timer_.time() / parameters_.time_limit);
    if(parameters_.convergence > 0 && first_displacement_ > parameters_.convergence && displacement > 0)
      fraction = (std::max)(fraction, std::log(first_displacement_ / displacement)
                                      / std::log(first_displacement_ / parameters_.convergence));
    fraction_ = (std::max)(fraction_, (std::min)(1., fraction));
    return parameters_.callback(fraction_);
  }

  C3t3_bridge_3<C3t3, Mesh_domain> bridge_;
  const Odt_parameters& parameters_;
  Visitor& visitor_;
  Real_timer timer_;
  Moving_triangulation_3 mesh_;
  std::vector<double> displacement_, shortest_edge_;
  std::vector<int> still_;
  std::size_t number_of_iterations_ = 0;
  double first_displacement_ = 0;
  double fraction_ = 0;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ODT_MESH_OPTIMIZER_3_H
