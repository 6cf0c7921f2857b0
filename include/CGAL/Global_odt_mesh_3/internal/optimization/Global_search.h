// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_GLOBAL_SEARCH_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_GLOBAL_SEARCH_H

#include <CGAL/Global_odt_mesh_3/internal/optimization/Annealing_schedule.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Metropolis_annealing.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Momentum_annealing.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>

#include <variant>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Either of the global searches in rounds, between which the triangulation may become another.
class Global_search
{
public:
  Global_search(const Annealing_schedule& schedule, unsigned int seed,
                const Limited_memory_bfgs_parameters& minimizer_parameters)
    : schedule_(schedule)
    , momentum_(seed, is_metropolis() ? Momentum_annealing_schedule()
                                      : std::get<Momentum_annealing_schedule>(schedule))
    , metropolis_(seed, is_metropolis() ? std::get<Metropolis_annealing_schedule>(schedule)
                                        : Metropolis_annealing_schedule())
    , minimizer_(minimizer_parameters)
  {}

  static int usual_rounds(const Annealing_schedule& schedule)
  {
    return std::holds_alternative<Metropolis_annealing_schedule>(schedule) ? int(Metropolis_annealing::usual_rounds)
                                                                           : usual_rounds_of_momentum;
  }

  // Facets on surfaces follow the vertices only between rounds.
  static int iterations_in_round(const Annealing_schedule& schedule, bool boundary_moves)
  {
    const auto* metropolis = std::get_if<Metropolis_annealing_schedule>(&schedule);
    return metropolis != nullptr ? metropolis->iterations_in_round
                                 : boundary_moves ? iterations_in_round_on_surfaces : iterations_in_round_of_momentum;
  }

  // Those of the minimizer that follow the search.
  static int final_iterations(const Annealing_schedule& schedule)
  {
    const auto* metropolis = std::get_if<Metropolis_annealing_schedule>(&schedule);
    return metropolis != nullptr ? metropolis->final_iterations : final_iterations_of_momentum;
  }

  void begin_round(Odt_objective_3& f)
  {
    energy_ = f.value();
    if(!is_metropolis())
      momentum_.start(f);
    else
    {
      minimizer_.reset();
      metropolis_.perturb(f);
    }
  }

  // One iteration when the fraction `done` of the search is behind; false if the round has
  // come to its end.
  bool iterate(Odt_objective_3& f, double done)
  {
    if(!is_metropolis())
    {
      momentum_.iterate(f, done);
      return true;
    }
    return minimizer_.iterate(f) == Limited_memory_bfgs::STEP_TAKEN;
  }

  // Whether the round is to be kept, or what was before it.
  bool accepts(const Odt_objective_3& f)
  {
    return !is_metropolis() || metropolis_.accepts(f.value(), energy_);
  }

private:
  static constexpr int usual_rounds_of_momentum = 4;
  static constexpr int iterations_in_round_of_momentum = 50, iterations_in_round_on_surfaces = 30;
  static constexpr int final_iterations_of_momentum = 20;

  bool is_metropolis() const { return std::holds_alternative<Metropolis_annealing_schedule>(schedule_); }

  Annealing_schedule schedule_;
  Momentum_annealing momentum_;
  Metropolis_annealing metropolis_;
  Limited_memory_bfgs minimizer_;
  double energy_ = 0;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_GLOBAL_SEARCH_H
