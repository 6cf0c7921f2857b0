// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ROUND_PLAN_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ROUND_PLAN_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Odt_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Global_search.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace CGAL::Global_odt_mesh_3::internal {

// Plans the number and kind of the rounds ahead, and their iterations.
class Round_plan
{
public:
  // REMESH: surface vertices go toward a restricted CVT while the interior follows. SEARCH: all vertices search globally. MINIMIZE:
  // all vertices go to the minimum of the combined energy of cells and surfaces.
  enum Stage { REMESH, SEARCH, MINIMIZE };

  static constexpr int iterations_on_surface = 20;      // of the CVT, in a round of remeshing

  Round_plan(Odt_task task, const Odt_parameters& p, bool boundary_moves)
    : task_(task)
    , search_(usual_rounds(p.annealing_schedule))
    , iterations_{{ iterations_inside_while_remeshing, search_.iterations, 0 }}
  {
    if(task == Odt_task::REMESH_BOUNDARY)
      plan_remeshing(boundary_moves);
    else if(task == Odt_task::REMOVE_SLIVERS)
      rounds_ = {{ 0, 0, 0 }};
    else
      plan_optimization(p, boundary_moves);
    search_rounds_ = rounds_[SEARCH];
  }

  bool is_done() const { return rounds_[REMESH] + rounds_[SEARCH] + rounds_[MINIMIZE] <= 0; }
  Stage stage() const { return rounds_[REMESH] > 0 ? REMESH : rounds_[SEARCH] > 0 ? SEARCH : MINIMIZE; }
  int iterations() const { return iterations_[stage()]; }
  // Rounds of a search need not lower the energy, and the last rounds are few.
  bool stops_without_gain() const { return task_ == Odt_task::REMESH_BOUNDARY && stage() == REMESH; }

  // Whether the interior is minimized after the rounds, and whether slivers are removed then.
  bool optimizes() const { return task_ == Odt_task::OPTIMIZE; }
  bool removes_slivers() const { return task_ != Odt_task::REMESH_BOUNDARY; }

  void advance() { --rounds_[stage()]; }
  void skip(Stage s) { rounds_[s] = 0; }

  // The fraction of the time for iterations, if limited, after which no round of the stage begins.
  double end_of_time(Stage s) const
  {
    if(!optimizes())
      return (std::numeric_limits<double>::infinity)();
    return s == REMESH ? 0.25 : s == SEARCH ? 0.7 : 1;
  }

  // The fraction of the search that is done at iteration n of the round.
  double search_progress(double n) const
  {
    return (search_rounds_ - rounds_[SEARCH] + n / iterations_[SEARCH]) / search_rounds_;
  }

  // The approximate number of iterations of all rounds; a plan without rounds keeps the usual number.
  int number_of_iterations() const { return planned_iterations_; }

  // The most iterations if the user sets no limit: CGAL's optimizers have such a limit, too.
  int usual_most_iterations() const { return iterations_beyond_plan + planned_iterations_; }

private:
  static constexpr std::size_t most_rounds = 1000000;
  static constexpr int iterations_beyond_plan = 1000;
  static constexpr int rounds_of_remeshing = 4;
  static constexpr int iterations_inside_while_remeshing = 10;
  static constexpr int rounds_of_minimizer = 2;
  static constexpr int iterations_of_minimizer = 20;
  // If the user limits the number of iterations, most are left for the other stages.
  static constexpr int iterations_per_round_of_remeshing = 60;
  static constexpr double share_of_search = 0.7;

  void plan_remeshing(bool boundary_moves)
  {
    rounds_ = {{ boundary_moves ? rounds_of_remeshing + rounds_of_minimizer : 0, 0, boundary_moves ? 0 : 1 }};
    planned_iterations_ = planned_iterations();
  }

  void plan_optimization(const Odt_parameters& p, bool boundary_moves)
  {
    const int search_rounds = p.number_of_rounds == Odt_parameters::usual_number_of_rounds
                                ? search_.number
                                : static_cast<int>((std::min)(p.number_of_rounds, most_rounds));
    if(search_rounds > 0)
      rounds_ = {{ 0, search_rounds, 1 }};
    else
      rounds_ = {{ boundary_moves ? rounds_of_remeshing : 0, 0, boundary_moves ? rounds_of_minimizer : 1 }};
    if(boundary_moves)
      iterations_[MINIMIZE] = search_rounds > 0 ? search_.final_iterations : iterations_of_minimizer;
    planned_iterations_ = planned_iterations();
    if(p.max_iteration_number > 0)
      shorten(static_cast<int>((std::min)(p.max_iteration_number, std::size_t(planned_iterations_))));
  }

  // The number the caller wants may exceed the range of int.
  int planned_iterations() const
  {
    const double sum = 1. + double(rounds_[REMESH]) * (iterations_[REMESH] + iterations_on_surface)
                       + double(rounds_[SEARCH]) * iterations_[SEARCH]
                       + double((std::min)(rounds_[MINIMIZE], 2)) * iterations_[MINIMIZE];
    return static_cast<int>((std::min)(sum, double((std::numeric_limits<int>::max)() - iterations_beyond_plan)));
  }

  void shorten(int most)
  {
    rounds_[REMESH] = (std::min)(rounds_[REMESH], most / iterations_per_round_of_remeshing);
    const int left = most - rounds_[REMESH] * (iterations_[REMESH] + iterations_on_surface);
    const int search = static_cast<int>(share_of_search * left);
    if(double(rounds_[SEARCH]) * iterations_[SEARCH] > search)
    {
      rounds_[SEARCH] = static_cast<int>(double(search) / iterations_[SEARCH] + 0.5);
      if(rounds_[SEARCH] > 0)
        iterations_[SEARCH] = (std::min)(iterations_[SEARCH], search / rounds_[SEARCH]);
    }
    planned_iterations_ = planned_iterations();
  }

  Odt_task task_;
  Search_rounds search_;
  std::array<int, 3> iterations_, rounds_;
  int search_rounds_ = 0, planned_iterations_ = 200;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ROUND_PLAN_H
