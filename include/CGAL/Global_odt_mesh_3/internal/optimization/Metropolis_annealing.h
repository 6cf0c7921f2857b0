// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_METROPOLIS_ANNEALING_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_METROPOLIS_ANNEALING_H

#include <CGAL/Annealing_schedules_3.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Vertex_noise.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Cell_order.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <Eigen/Core>

#include <cmath>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Algorithm 2 of the paper, the global ODT method: rounds that perturb all vertices and go to a
// minimum nearby, which replaces that of the rounds before if it is lower or, with the
// probability of Metropolis, a little higher. The temperature is relative to the energy, so that
// the scale of the mesh does not matter.
class Metropolis_annealing
{
public:
  static constexpr int usual_rounds = 20;

  explicit Metropolis_annealing(unsigned int seed,
                                const Metropolis_annealing_schedule& schedule = Metropolis_annealing_schedule())
    : schedule_(schedule)
    , temperature_(schedule.temperature)
    , noise_(seed)
  {}

  const Metropolis_annealing_schedule& schedule() const { return schedule_; }
  double temperature() const { return temperature_; }

  // Step (3): the perturbed point becomes the current one. Noise that breaks the triangulation
  // is halved and, if that does not help, left.
  void perturb(Odt_objective_3& f)
  {
    noise_.measure_edges(f);
    start_ = f.point();
    perturbation_.resize(start_.size());
    for(int v = 0; v < f.number_of_vertices(); ++v)
      perturbation_.segment<3>(3 * v)
        = noise_.displacement(f, v, schedule_.perturbation, schedule_.perturbation);
    for(int n = 0; n < max_halvings; ++n, perturbation_ /= 2)
    {
      if(f.evaluate(start_ + perturbation_))
      {
        f.keep();
        return;
      }
      f.reject();
    }
  }

  // Step (6). Where the answer is no, the caller goes back to the state before the round.
  bool accepts(double energy_after, double energy_before)
  {
    if(energy_after <= energy_before)
      return true;
    const double rise = (energy_after - energy_before) / energy_before;
    if(std::exp(-rise / temperature_) > noise_.random().uniform())
      return true;
    temperature_ *= schedule_.cooling;
    return false;
  }

  // All of Algorithm 2, M rounds, from the current point, which should be a minimum, on the
  // objective of this mesh.
  void run(Moving_triangulation_3& mesh, Odt_objective_3& f, int number_of_rounds = usual_rounds)
  {
    Limited_memory_bfgs minimizer;
    Cell_order order(mesh);
    for(int round = 0; round < number_of_rounds; ++round)
    {
      const double energy = f.value();
      order.maintain(mesh);
      const Moving_triangulation_3 before = mesh;
      perturb(f);
      minimize(minimizer, f, schedule_.iterations_in_round);
      if(!accepts(f.value(), energy))
      {
        mesh = before;
        f.start();
      }
    }
    minimize(minimizer, f, schedule_.final_iterations);
  }

private:
  static constexpr int max_halvings = 8;

  static void minimize(Limited_memory_bfgs& minimizer, Odt_objective_3& f, int iterations)
  {
    minimizer.reset();
    for(int n = 0; n < iterations; ++n)
      if(minimizer.iterate(f) == Limited_memory_bfgs::NO_STEP_FOUND)
        return;
  }

  Metropolis_annealing_schedule schedule_;
  double temperature_;
  Vertex_noise noise_;
  Eigen::VectorXd start_, perturbation_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_METROPOLIS_ANNEALING_H
