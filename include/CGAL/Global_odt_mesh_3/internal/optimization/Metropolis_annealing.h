// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_METROPOLIS_ANNEALING_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_METROPOLIS_ANNEALING_H

#include <CGAL/Annealing_schedules_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Vertex_noise.h>

#include <Eigen/Core>

#include <cmath>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// What Algorithm 2 of the paper, the global ODT method, does between minimizations: it perturbs all vertices, and
// accepts the minimum to which they go then if it is lower than the one before or, with the
// probability of Metropolis, a little higher. The temperature is relative to the energy, so that
// the scale of the mesh does not matter. The function is Odt_objective_3 or what offers the same.
class Metropolis_annealing
{
public:
  static constexpr int usual_rounds = 20;

  explicit Metropolis_annealing(unsigned int seed,
                                const Metropolis_annealing_schedule& schedule = Metropolis_annealing_schedule())
    : schedule_(schedule)
    , temperature_(schedule.temperature)
    , random_(seed)
    , noise_(seed)
  {}

  const Metropolis_annealing_schedule& schedule() const { return schedule_; }
  double temperature() const { return temperature_; }

  // Step (1): whether the current point is close to a minimum, that is, what an AVV move (2.3) gains in first order
  // is little against the rises that are accepted.
  template <class Function>
  bool is_near_minimum(const Function& f) const
  {
    const double gain = (f.gradient().array().square() / f.diagonal().array()).sum();
    return gain <= small_part * temperature_ * f.value();
  }

  // Step (3): the perturbed point becomes the current one. Noise that breaks the triangulation
  // is halved and, if that does not help, left.
  template <class Function>
  void perturb(Function& f)
  {
    noise_.measure_edges(f);
    noise_.draw();
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
    if(std::exp(-rise / temperature_) > random_.uniform())
      return true;
    temperature_ *= schedule_.cooling;
    return false;
  }

private:
  static constexpr int max_halvings = 8;
  static constexpr double small_part = 1e-2;

  Metropolis_annealing_schedule schedule_;
  double temperature_;
  Random_source random_;
  Vertex_noise noise_;
  Eigen::VectorXd start_, perturbation_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_METROPOLIS_ANNEALING_H
