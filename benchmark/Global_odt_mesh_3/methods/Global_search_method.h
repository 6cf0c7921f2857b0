// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_METHODS_GLOBAL_SEARCH_METHOD_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_METHODS_GLOBAL_SEARCH_METHOD_H

#include "methods/Method.h"

#include <CGAL/Global_odt_mesh_3/internal/optimization/Annealing.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Global_search.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>

#include <memory>
#include <string>
#include <variant>

// Algorithm 2 of the paper or momentum annealing. An iteration is a round of the search, and the last one the
// iterations of L-BFGS that follow it.
class Global_search_method
  : public Method
{
public:
  typedef CGAL::Global_odt_mesh_3::internal::Annealing_schedule Schedule;

  Global_search_method(Energy e, const Schedule& schedule, int rounds) : Method(e), schedule_(schedule), rounds_(rounds) {}
  Global_search_method(Energy e, const Schedule& schedule)
    : Global_search_method(e, schedule, CGAL::Global_odt_mesh_3::internal::usual_rounds(schedule).number)
  {}

  std::string name() const override
  {
    const bool is_paper = std::holds_alternative<CGAL::Metropolis_annealing_schedule>(schedule_);
    return (is_paper ? "Algorithm 2, " : "momentum, ") + name_of(energy_choice());
  }

private:
  typedef CGAL::Global_odt_mesh_3::internal::Global_search Search;
  typedef CGAL::Global_odt_mesh_3::internal::Limited_memory_bfgs Minimizer;

  void start(unsigned int seed) override
  {
    search_ = std::make_unique<Search>(schedule_, seed, CGAL::Global_odt_mesh_3::internal::Limited_memory_bfgs_parameters());
    round_ = 0;
  }

  bool step() override
  {
    if(round_ > rounds_)
      return false;
    if(round_ == rounds_)
      minimize();
    else
    {
      const int iterations = CGAL::Global_odt_mesh_3::internal::usual_rounds(schedule_).iterations;
      search_->make_round(objective(), iterations, [&](int n) { return (round_ + double(n) / iterations) / rounds_; },
                          [] { return true; }, [&] { order().maintain(mesh()); });
    }
    ++round_;
    return true;
  }

  void minimize()
  {
    Minimizer minimizer;
    for(int n = CGAL::Global_odt_mesh_3::internal::usual_rounds(schedule_).final_iterations; n > 0 && minimizer.iterate(objective()) == Minimizer::STEP_TAKEN; --n)
      order().maintain(mesh());
  }

  Schedule schedule_;
  int rounds_, round_ = 0;
  std::unique_ptr<Search> search_;
};

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_METHODS_GLOBAL_SEARCH_METHOD_H
