// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_GLOBAL_SEARCH_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_GLOBAL_SEARCH_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/optimization/Annealing.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <optional>
#include <utility>
#include <variant>

namespace CGAL::Global_odt_mesh_3::internal {

// How many rounds a search has unless the user says otherwise, of how many iterations, as facets on surfaces follow the vertices
// only between rounds, and how many of the minimizer follow.
struct Search_rounds
{
  int number, iterations, final_iterations;
};

inline Search_rounds usual_rounds(const Annealing_schedule& schedule)
{
  const auto* metropolis = std::get_if<Metropolis_annealing_schedule>(&schedule);
  // More rounds lead to better cells and take longer. CONTRIBUTING.md has measurements.
  return metropolis == nullptr ? Search_rounds{ 4, 50, 20 }
                               : Search_rounds{ 20, metropolis->iterations_in_round, metropolis->final_iterations };
}

// Either of the global searches in rounds, between which the triangulation may become another.
class Global_search
{
public:
  Global_search(const Annealing_schedule& schedule, unsigned int seed,
                const Limited_memory_bfgs_parameters& minimizer_parameters, const Thread_policy& threads = Thread_policy())
    : schedule_(schedule)
    , momentum_(seed, is_metropolis() ? Momentum_annealing_schedule()
                                      : std::get<Momentum_annealing_schedule>(schedule))
    , metropolis_(seed, is_metropolis() ? std::get<Metropolis_annealing_schedule>(schedule)
                                        : Metropolis_annealing_schedule())
    , minimizer_(minimizer_parameters, threads)
  {}

  // One round, before which Algorithm 2 goes to a minimum if it is the first. `progress(n)` is the
  // fraction of the search that is behind at iteration n; `begin_iteration()`, asked before each, says whether there may
  // be one, which ends with `end_iteration()`.
  template <class Progress, class Begin_iteration, class End_iteration>
  void make_round(Odt_objective_3& f, int iterations, const Progress& progress, const Begin_iteration& begin_iteration,
                  const End_iteration& end_iteration)
  {
    const auto minimize = [&] { return minimizer_.iterate(f) == Limited_memory_bfgs::STEP_TAKEN; };
    if(is_metropolis() && !std::exchange(has_begun_, true))
      for(int n = 0; n < most_initial_iterations && !metropolis_.is_near_minimum(f) && begin_iteration() && minimize(); ++n)
        end_iteration();
    begin_round(f);
    for(int n = 0; n < iterations; ++n, end_iteration())
    {
      const double done = progress(n);
      if(done >= 1 || !begin_iteration())
        break;
      if(!is_metropolis())
        momentum_.iterate(f, done);
      else if(!minimize())
        break;
    }
    end_round(f);
  }

private:
  static constexpr int most_initial_iterations = 200;

  bool is_metropolis() const { return std::holds_alternative<Metropolis_annealing_schedule>(schedule_); }

  void begin_round(Odt_objective_3& f)
  {
    if(!is_metropolis())
      return momentum_.start(f);
    before_ = f.state();
    minimizer_.reset();
    metropolis_.perturb(f);
  }

  void end_round(Odt_objective_3& f)
  {
    if(is_metropolis() && !metropolis_.accepts(f.value(), before_->evaluation.value))
      f.go_back(*before_);
    before_.reset();
  }

  Annealing_schedule schedule_;
  Momentum_annealing momentum_;
  Metropolis_annealing metropolis_;
  Limited_memory_bfgs minimizer_;
  bool has_begun_ = false;
  std::optional<Odt_objective_3::State> before_;    // the round, if it may be in vain
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_GLOBAL_SEARCH_H
