// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The global searches: noise is distributed as it should be, rounds begin from minima, are accepted with the
// probability of Metropolis or leave no trace, and both searches end below the minimum of L-BFGS.

#include "check.h"
#include "random_cube_triangulation.h"
#include "search_globally.h"

#include <CGAL/Global_odt_mesh_3/internal/Round_plan.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Annealing.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Global_search.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <random>
#include <vector>

using namespace CGAL::Global_odt_mesh_3::internal;

static Moving_triangulation_3 small_cube()
{
  std::mt19937 random(5);
  return random_cube(6, 700, 0, false, random);
}

static void minimize(Odt_objective_3& f, int iterations)
{
  Limited_memory_bfgs minimizer;
  while(iterations-- > 0 && minimizer.iterate(f) == Limited_memory_bfgs::STEP_TAKEN)
    ;
}

// The standard gives the 10,000th number of the engine. Directions have no mean and the same
// variance along all axes.
static void random_numbers()
{
  Random_source pinned(std::mt19937_64::default_seed);
  double last = 0;
  for(int n = 0; n < 10000; ++n)
    last = pinned.uniform();
  check::that(last == std::ldexp(static_cast<double>(UINT64_C(9981545732273789042) >> 11), -53),
              "the numbers are not those of the engine");

  Random_source random(1);
  const int draws = 100000;
  Vector_3 mean;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  check::Largest worst_length;
  for(int n = 0; n < draws; ++n)
  {
    const Vector_3 d = random.direction();
    mean += d / draws;
    const Eigen::Vector3d e(d[0], d[1], d[2]);
    covariance += e * e.transpose() / draws;
    worst_length.add(std::abs(d.length() - 1));
  }
  check::that(worst_length < 1e-14, "directions are off the sphere by ", worst_length);
  check::that(mean.length() < 0.015, "directions have a mean");
  check::that((covariance - Eigen::Matrix3d::Identity() / 3).cwiseAbs().maxCoeff() < 0.005,
              "directions prefer an axis");
}

// A perturbation is as long as it should be, in the plane of vertices on surfaces, and none
// where vertices are frozen.
static void perturbation()
{
  Moving_triangulation_3 mesh = small_cube();
  const int on_surface = 50;
  mesh.number_of_interior_vertices -= on_surface;
  std::vector<Tangential_motion> motions;
  for(int n = 0; n < on_surface; ++n)
    motions.push_back({ Vector_3(0.6, 0, 0.8), 1, mesh.sites[mesh.number_of_interior_vertices + n] });
  Odt_objective_3 f(mesh, motions);
  f.freeze(3);

  Vertex_noise noise(2);
  noise.measure_edges(f);
  const int draws = 200;
  const double amplitude = 0.2;
  double mean = 0;
  check::Largest longest, out_of_plane, of_frozen;
  for(int n = 0; n < draws; ++n)
  {
    noise.draw();
    for(int v = 0; v < mesh.number_of_movable_vertices; ++v)
    {
      const Vector_3 moved = noise.displacement(f, v, amplitude, amplitude);
      const double length = moved.length() / noise.mean_edge_length(v);
      longest.add(length);
      if(v >= mesh.number_of_interior_vertices)
        out_of_plane.add(std::abs(moved.dot(Vector_3(0.6, 0, 0.8))));
      else if(f.is_frozen(v))
        of_frozen.add(length);
      else
        mean += length / draws / (mesh.number_of_interior_vertices - 1);
    }
  }
  check::that(std::abs(mean - amplitude / 2) < 0.002, "the mean perturbation is ", mean, " edges");
  check::that(longest < amplitude && longest > 0.99 * amplitude, "the longest perturbation is ", longest, " edges");
  check::that(out_of_plane < 1e-15, "surface vertices leave their plane by ", out_of_plane);
  check::that(of_frozen == 0, "a frozen vertex moves");

  const Eigen::VectorXd before = f.point();
  Metropolis_annealing(2).perturb(f);
  check::that((f.point() - before).norm() > 0, "nothing is perturbed");
  check::that(mesh.is_regular(), "the perturbed triangulation is not regular");
}

// At its minimum.
struct Negative_energy
{
  double value() const { return -1; }
  Eigen::VectorXd gradient() const { return Eigen::VectorXd::Constant(3, 1e-9); }
  Eigen::VectorXd diagonal() const { return Eigen::VectorXd::Ones(3); }
};

// Acceptance depends on the relative rise over the temperature alone, which falls at rejections.
static void acceptance()
{
  for(double rise : { 0.1, 0.5, 2. })
  {
    CGAL::Metropolis_annealing_schedule constant;
    constant.cooling = 1;
    Metropolis_annealing annealing(3, constant);
    const int draws = 40000;
    const double energy = 17, p = std::exp(-rise);
    int accepted = 0;
    for(int n = 0; n < draws; ++n)
      accepted += annealing.accepts(energy * (1 + rise * constant.temperature), energy);
    check::that(std::abs(accepted - p * draws) < 4 * std::sqrt(p * (1 - p) * draws), accepted, " of ", draws,
                " rises by ", rise, " T accepted");
  }

  Metropolis_annealing annealing(4);
  double expected = annealing.schedule().temperature;
  int rejections = 0;
  for(int n = 0; n < 100; ++n)
  {
    check::that(annealing.accepts(1, 1) && annealing.accepts(1 - 1e-9, 1), "a lower energy is rejected");
    check::that(annealing.temperature() == expected, "acceptance cools");
    if(!annealing.accepts(1 + expected, 1))
    {
      expected *= 0.9;
      ++rejections;
    }
    check::that(annealing.temperature() == expected, "the temperature is ", annealing.temperature(), " for ", expected);
  }
  check::that(rejections > 40 && rejections < 85, rejections, " of 100 rises by T rejected");

  Metropolis_annealing negative(6);
  check::that(!negative.accepts(-1, -2), "a negative energy that rises far is accepted");
  const Negative_energy at_minimum;
  check::that(negative.is_near_minimum(at_minimum), "a negative energy has no minimum");

  Metropolis_annealing small(5), large(5);
  for(int n = 0; n < 100; ++n)
    check::that(small.accepts(1 + 1e-4, 1) == large.accepts(1024 * (1 + 1e-4), 1024), "the scale matters");
}

// A round that is rejected leaves no trace: energy, point and gradient are bit by bit those of the minimum before.
static void rejection()
{
  Moving_triangulation_3 mesh = small_cube();
  Odt_objective_3 f(mesh);
  CGAL::Metropolis_annealing_schedule schedule;
  schedule.iterations_in_round = 1;
  schedule.final_iterations = 0;
  Global_search search(schedule, 6, Limited_memory_bfgs_parameters());
  int iterations = 0;
  const auto make_round = [&]
  {
    search.make_round(f, schedule.iterations_in_round, [](int) { return 0.5; }, [] { return true; }, [&] { ++iterations; });
  };
  make_round();
  const double energy = f.value();
  const Eigen::VectorXd point = f.point(), gradient = f.gradient();
  for(int n = 1; n <= 5; ++n)
  {
    iterations = 0;
    make_round();
    check::that(iterations == schedule.iterations_in_round, "round ", n, " has ", iterations, " iterations");
    check::that(f.value() == energy && f.point() == point && f.gradient() == gradient, "a rejected round leaves a trace");
    check::that(mesh.energy() == energy && mesh.is_regular(), "a rejected round leaves a trace in the mesh");
  }
}

// Algorithm 2 begins from a minimum: before the first round, and only then, random vertices go there.
static void first_round()
{
  Moving_triangulation_3 mesh = small_cube(), copy = mesh;
  Odt_objective_3 local(copy), f(mesh);
  minimize(local, 300);
  CGAL::Metropolis_annealing_schedule schedule;
  schedule.iterations_in_round = 1;
  Global_search search(schedule, 6, Limited_memory_bfgs_parameters());
  int iterations = 0;
  search.make_round(f, 1, [](int) { return 0.5; }, [] { return true; }, [&] { ++iterations; });
  std::cout << "before the first round: " << iterations - 1 << " iterations, E " << f.value() << ", minimum "
            << local.value() << std::endl;
  check::that(iterations > 10, "only ", iterations, " iterations lead from random points to a minimum");
  check::that(Metropolis_annealing(6).is_near_minimum(f) && std::abs(f.value() / local.value() - 1) < 5e-3,
              "the first round does not begin from a minimum");

  // Time that has run out, or a user who says so, ends that, too.
  Moving_triangulation_3 other = small_cube();
  Odt_objective_3 g(other);
  Global_search(schedule, 6, Limited_memory_bfgs_parameters())
    .make_round(g, 1, [](int) { return 0.5; }, [] { return false; }, [] { check::that(false, "an iteration that may not be"); });
  check::that(other.is_regular(), "a round without iterations leaves no regular triangulation");
}

static double searched(const char* name, const Annealing_schedule& schedule,
                       double highest, Moving_triangulation_3 mesh, unsigned int seed)
{
  Moving_triangulation_3 copy = mesh;
  Odt_objective_3 local(copy);
  minimize(local, 300);
  Odt_objective_3 f(mesh);
  search_globally(mesh, f, schedule, seed);
  std::cout << name << ", seed " << seed << ": E is lower by " << 100 * (1 - f.value() / local.value()) << " %" << std::endl;
  check::that(f.value() < highest * local.value(), name, " does not end far below L-BFGS");
  check::that(mesh.topology.is_valid() && difference_to_exact(mesh) <= 4, name, ": the triangulation is not CGAL's");
  check::that(mesh.is_regular(), name, ": the triangulation is not regular");
  return mesh.energy();
}

static void searches()
{
  const Moving_triangulation_3 cube = small_cube();
  const auto compare = [&cube](const char* name, const Annealing_schedule& schedule, double highest)
  {
    const double energy = searched(name, schedule, highest, cube, 1);
    check::that(searched(name, schedule, highest, cube, 1) == energy, name, ": the same seed leads elsewhere");
    check::that(searched(name, schedule, highest, cube, 2) != energy, name, ": another seed leads to the same end");
  };
  compare("Algorithm 2", CGAL::Metropolis_annealing_schedule(), 0.995);
  compare("Momentum annealing", CGAL::Momentum_annealing_schedule(), 0.99);
}

// A plan of as many rounds and iterations as can be asked for counts them, as far as a number does.
static void long_plans()
{
  constexpr int most = (std::numeric_limits<int>::max)();
  CGAL::Metropolis_annealing_schedule schedule;
  schedule.iterations_in_round = schedule.final_iterations = most;
  Odt_parameters parameters;
  parameters.annealing_schedule = schedule;
  parameters.number_of_rounds = std::size_t(-1) - 1;
  for(std::size_t wanted : { std::size_t(0), std::size_t(1), std::size_t(100), std::size_t(most), std::size_t(-1) })
  {
    parameters.max_iteration_number = wanted;
    Round_plan plan(Odt_task::OPTIMIZE, parameters, true);
    check::that(plan.number_of_iterations() > 0 && plan.usual_most_iterations() > plan.number_of_iterations(),
                plan.number_of_iterations(), " iterations are planned, and ", plan.usual_most_iterations(), " made at most");
    double before = 0;
    for(int round = 0; round < 5 && !plan.is_done(); ++round, plan.advance())
    {
      check::that(plan.iterations() >= 0, "a round of ", plan.iterations(), " iterations");
      if(plan.stage() != Round_plan::SEARCH)
        continue;
      const double begin = plan.search_progress(0), end = plan.search_progress(plan.iterations());
      check::that(before <= begin && begin < end && end <= 1, "a round of the search goes from ", begin, " to ", end);
      before = end;
    }
  }
}

int main()
{
  long_plans();
  random_numbers();
  perturbation();
  acceptance();
  rejection();
  first_round();
  searches();
  return check::result();
}
