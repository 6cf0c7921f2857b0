// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The global searches: noise is distributed as it should be, rounds are accepted with the
// probability of Metropolis, and both searches end below the minimum of L-BFGS.

#include "check.h"
#include "random_cube_triangulation.h"

#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Metropolis_annealing.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Momentum_annealing.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
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
  f.start();
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
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double worst_length = 0;
  for(int n = 0; n < draws; ++n)
  {
    const Eigen::Vector3d d = random.direction();
    mean += d / draws;
    covariance += d * d.transpose() / draws;
    worst_length = (std::max)(worst_length, std::abs(d.norm() - 1));
  }
  check::that(worst_length < 1e-14, "directions are off the sphere by ", worst_length);
  check::that(mean.cwiseAbs().maxCoeff() < 0.01, "directions have a mean");
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
    motions.push_back({ {{ 0.6, 0, 0.8 }}, 1, mesh.sites[mesh.number_of_interior_vertices + n] });
  Odt_objective_3 f(mesh, Odt_objective_3::Density(), motions);
  f.freeze(3);

  Vertex_noise noise(2);
  noise.measure_edges(f);
  const int draws = 200;
  const double amplitude = 0.2;
  double mean = 0, longest = 0, out_of_plane = 0, of_frozen = 0;
  for(int n = 0; n < draws; ++n)
  {
    for(int v = 0; v < mesh.number_of_movable_vertices; ++v)
    {
      const Eigen::Vector3d moved = noise.displacement(f, v, amplitude, amplitude);
      const double length = moved.norm() / noise.mean_edge_length(v);
      longest = (std::max)(longest, length);
      if(v >= mesh.number_of_interior_vertices)
        out_of_plane = (std::max)(out_of_plane, std::abs(moved.dot(Eigen::Vector3d(0.6, 0, 0.8))));
      else if(f.is_frozen(v))
        of_frozen = (std::max)(of_frozen, length);
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

  Metropolis_annealing small(5), large(5);
  for(int n = 0; n < 100; ++n)
    check::that(small.accepts(1 + 1e-4, 1) == large.accepts(1024 * (1 + 1e-4), 1024), "the scale matters");
}

// A round that is rejected leaves no trace but the temperature.
static void rejection()
{
  Moving_triangulation_3 mesh = small_cube();
  Odt_objective_3 f(mesh);
  minimize(f, 300);
  const double energy = f.value();
  const Eigen::VectorXd point = f.point();
  CGAL::Metropolis_annealing_schedule schedule;
  schedule.iterations_in_round = 1;
  schedule.final_iterations = 0;
  Metropolis_annealing annealing(6, schedule);
  annealing.run(mesh, f, 1);
  check::that(annealing.temperature() == 0.9 * schedule.temperature, "a bad round is accepted");
  check::that(f.point() == point, "a rejected round moves vertices");
  check::that(std::abs(f.value() - energy) <= 1e-12 * energy, "a rejected round changes the energy");
}

static double searched_as_printed(Moving_triangulation_3 mesh, unsigned int seed)
{
  Odt_objective_3 f(mesh);
  minimize(f, 300);
  const double local = f.value();
  Metropolis_annealing(seed).run(mesh, f);
  std::cout << "Algorithm 2, seed " << seed << ": E falls by " << 100 * (1 - f.value() / local) << " %" << std::endl;
  check::that(f.value() <= local, "Algorithm 2 ends above L-BFGS");
  check::that(mesh.topology.is_valid() && difference_to_exact(mesh) <= 4, "Algorithm 2's triangulation is not CGAL's");
  check::that(mesh.is_regular(), "Algorithm 2's triangulation is not regular");
  return mesh.energy();
}

static double searched_with_momentum(Moving_triangulation_3 mesh, unsigned int seed)
{
  Moving_triangulation_3 copy = mesh;
  Odt_objective_3 local(copy);
  minimize(local, 300);
  Odt_objective_3 f(mesh);
  Momentum_annealing annealing(seed);
  annealing.start(f);
  for(int n = 0; n < 200; ++n)
    annealing.iterate(f, n / 200.);
  minimize(f, 30);
  std::cout << "Momentum annealing, seed " << seed << ": E is lower by " << 100 * (1 - f.value() / local.value())
            << " %" << std::endl;
  check::that(f.value() < 0.99 * local.value(), "momentum annealing does not end far below L-BFGS");
  check::that(mesh.topology.is_valid() && difference_to_exact(mesh) <= 4, "the annealed triangulation is not CGAL's");
  check::that(mesh.is_regular(), "the annealed triangulation is not regular");
  return mesh.energy();
}

static void searches()
{
  const Moving_triangulation_3 cube = small_cube();
  for(double (*search)(Moving_triangulation_3, unsigned int) : { searched_as_printed, searched_with_momentum })
  {
    const double energy = search(cube, 1);
    check::that(search(cube, 1) == energy, "the same seed leads elsewhere");
    check::that(search(cube, 2) != energy, "another seed leads to the same end");
  }
}

int main()
{
  random_numbers();
  perturbation();
  acceptance();
  rejection();
  searches();
  return check::result();
}
