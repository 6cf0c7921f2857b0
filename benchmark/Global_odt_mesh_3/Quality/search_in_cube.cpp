// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Section 4.3 of the paper: how far below the minima of local searches the global ones go from
// the random interior of a cube, what this costs in process CPU time on the same engine, and
// what shape the cells have.
//
//   search_in_cube [number of seeds, default 3 [factor of the length of searches, default 1
//                  [number of vertices to compare the cost per vertex with, default none
//                  [squares]]]]
//
// The surface, which stays, has nearly equilateral facets, or right-angled ones with "squares",
// whose cells cannot come near 3r/R = 1 and lower its mean by .004.
// Energies are relative to the mean of those that the AVV iteration reaches over all seeds.

#include "averaging_iteration.h"
#include "cpu_seconds.h"
#include "flat_mesh_outcome.h"
#include "random_points.h"
#include "search_globally.h"

#include <CGAL/Annealing_schedules_3.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Annealing_schedule.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Global_search.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Sliver_removal_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Cell_order.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

using namespace CGAL::Global_odt_mesh_3::internal;

static const std::size_t vertices_of_paper = 18083;

// Runs a method on the mesh and keeps the cells in memory order.
class Runner
{
public:
  explicit Runner(Moving_triangulation_3& mesh) : mesh_(mesh), objective_(mesh), order_(mesh) {}

  void average(int iterations)
  {
    Averaging_iteration averaging;
    repeat(iterations, [&](int) { return averaging.iterate(objective_); });
  }

  void minimize(int iterations)
  {
    Limited_memory_bfgs minimizer;
    repeat(iterations, [&](int)
    {
      return objective_.gradient().norm() > 1e-9 && minimizer.iterate(objective_) == Limited_memory_bfgs::STEP_TAKEN;
    });
  }

  // With so many times the usual number of rounds.
  void search(const Annealing_schedule& schedule, unsigned int seed, int factor)
  {
    search_globally(mesh_, objective_, schedule, seed, factor * Global_search::usual_rounds(schedule));
  }

private:
  void repeat(int times, const std::function<bool(int)>& iterate)
  {
    for(int n = 0; n < times && iterate(n); ++n)
      order_.maintain(mesh_);
  }

  Moving_triangulation_3& mesh_;
  Odt_objective_3 objective_;
  Cell_order order_;
};

struct Method
{
  std::string name;
  std::function<void(Moving_triangulation_3&, unsigned int seed)> run;
};

// The default bound of odt_optimize_mesh_3().
static void remove_slivers(Moving_triangulation_3& mesh, unsigned int seed)
{
  Sliver_removal_3(mesh, 20, seed).run();
  mesh.evaluate();
}

static std::vector<Method> methods(int factor)
{
  return {
    { "AVV, 499 iterations", [](Moving_triangulation_3& mesh, unsigned int) { Runner(mesh).average(499); } },
    { "L-BFGS", [](Moving_triangulation_3& mesh, unsigned int) { Runner(mesh).minimize(400); } },
    { "Algorithm 2", [=](Moving_triangulation_3& mesh, unsigned int seed)
      {
        Runner(mesh).search(CGAL::Metropolis_annealing_schedule(), seed, factor);
      } },
    { "momentum annealing", [=](Moving_triangulation_3& mesh, unsigned int seed)
      {
        Runner(mesh).search(CGAL::Momentum_annealing_schedule(), seed, factor);
        remove_slivers(mesh, seed);
      } }
  };
}

// Outcomes[method][seed].
static std::vector<std::vector<Outcome> > outcomes(const std::vector<Method>& methods, int seeds,
                                                   std::size_t number_of_vertices, Cube_surface surface)
{
  std::vector<std::vector<Outcome> > all(methods.size());
  for(int seed = 1; seed <= seeds; ++seed)
  {
    const Moving_triangulation_3 cube = random_cube(seed, number_of_vertices, surface);
    for(std::size_t m = 0; m < methods.size(); ++m)
    {
      Moving_triangulation_3 mesh = cube;
      const double time = seconds([&] { methods[m].run(mesh, seed); });
      all[m].push_back(outcome(mesh, time));
    }
  }
  return all;
}

static double mean(const std::vector<Outcome>& outcomes, double Outcome::* what)
{
  double sum = 0;
  for(const Outcome& o : outcomes)
    sum += o.*what;
  return sum / outcomes.size();
}

static void print(const std::vector<Method>& methods, const std::vector<std::vector<Outcome> >& all)
{
  const double energy = mean(all[0], &Outcome::energy), time = mean(all[0], &Outcome::time);
  std::printf("seed  %-20s %8s %8s %6s %7s  %-13s %s\n", "method", "E %", "CPU s", "/ AVV", "3r/R", "angles",
              "cells below 10, 13, 15, 20");
  for(std::size_t m = 0; m < methods.size(); ++m)
  {
    for(std::size_t n = 0; n < all[m].size(); ++n)
    {
      const Outcome& o = all[m][n];
      std::printf("%4d  %-20s %+8.3f %8.2f %6.2f %7.4f  %5.1f - %5.1f %5d %5d %5d %5d\n", int(n + 1),
                  methods[m].name.c_str(), 100 * (o.energy / energy - 1), o.time, o.time / time, o.mean_radius_ratio,
                  o.smallest_angle, o.largest_angle, o.cells_below[0], o.cells_below[1], o.cells_below[2],
                  o.cells_below[3]);
    }
    std::printf("mean  %-20s %+8.3f %8.2f %6.2f %7.4f\n", methods[m].name.c_str(),
                100 * (mean(all[m], &Outcome::energy) / energy - 1), mean(all[m], &Outcome::time),
                mean(all[m], &Outcome::time) / time, mean(all[m], &Outcome::mean_radius_ratio));
  }
  std::fflush(stdout);
}

int main(int argc, char* argv[])
{
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 3;
  const int factor = argc > 2 ? std::atoi(argv[2]) : 1;
  const std::size_t many_vertices = argc > 3 ? std::atoi(argv[3]) : 0;
  const Cube_surface surface
    = argc > 4 && std::string(argv[4]) == "squares" ? Cube_surface::SQUARES : Cube_surface::SHIFTED_ROWS;
  const std::vector<Method> all = methods(factor);
  const std::vector<std::vector<Outcome> > usual = outcomes(all, seeds, vertices_of_paper, surface);
  print(all, usual);
  if(many_vertices > 0)
  {
    const std::vector<Method> last = { all.back() };
    const std::vector<std::vector<Outcome> > many = outcomes(last, 1, many_vertices, surface);
    print(last, many);
    std::printf("cost per vertex with %zu vertices over that with %zu: %.2f\n", many_vertices, vertices_of_paper,
                many[0][0].time / many_vertices / (mean(usual.back(), &Outcome::time) / vertices_of_paper));
  }
  return EXIT_SUCCESS;
}
