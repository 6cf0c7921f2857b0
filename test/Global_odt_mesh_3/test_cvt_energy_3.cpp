// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The energy of the centroidal Voronoi tessellation is what it is by definition, its gradient the derivative of it, also
// where the triangulation changes; and the same minimizers go down on it.

#include "averaging_iteration.h"
#include "check.h"
#include "random_cube_triangulation.h"
#include "voronoi_energy.h"

#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>
#include <vector>

using namespace CGAL::Global_odt_mesh_3::internal;

// The interior vertices are drawn together, so that none has a Voronoi cell that the facets around it do not see.
static Moving_triangulation_3 cube(std::mt19937& random)
{
  Moving_triangulation_3 mesh = random_cube(6, 120, 0, false, random);
  mesh.keep();
  mesh.move([](int, Site& s)
  {
    s.x = 0.5 + 0.7 * (s.x - 0.5);
    s.y = 0.5 + 0.7 * (s.y - 0.5);
    s.z = 0.5 + 0.7 * (s.z - 0.5);
  });
  check::that(mesh.evaluate(), "the triangulation of the cube breaks");
  return mesh;
}

static Odt_objective_3 objective(Moving_triangulation_3& mesh)
{
  return Odt_objective_3(mesh, {}, Voronoi_term(mesh));
}

// The integral of the squared distance to the nearest site, by the midpoint rule.
static double energy_by_definition(const std::vector<Site>& sites, int grid)
{
  double sum = 0;
  const auto at = [grid](int n) { return (n + 0.5) / grid; };
  for(int i = 0; i < grid; ++i)
    for(int j = 0; j < grid; ++j)
      for(int k = 0; k < grid; ++k)
      {
        const Vector_3 p(at(i), at(j), at(k));
        double nearest = (std::numeric_limits<double>::max)();
        for(const Site& s : sites)
          nearest = (std::min)(nearest, (position(s) - p).squared_length());
        sum += nearest;
      }
  return sum / grid / grid / grid;
}

static void definition(std::mt19937& random)
{
  Moving_triangulation_3 mesh = cube(random);
  double mass = 0;
  const double energy = voronoi_energy(mesh, [&](int, const Site_gradient& g) { mass += g.diagonal / 2; });
  // The error of the rule is of second order.
  const double wanted = (4 * energy_by_definition(mesh.sites, 80) - energy_by_definition(mesh.sites, 40)) / 3;
  check::that(std::abs(energy / wanted - 1) < 1e-3, "the energy is ", energy, " and not ", wanted);
  check::that(std::abs(mass - 1) < 1e-12, "the Voronoi cells fill ", mass, " of the cube");
}

// Central differences, in steps that flip facets now and then.
static void derivative(std::mt19937& random)
{
  Moving_triangulation_3 mesh = cube(random);
  Odt_objective_3 f = objective(mesh);
  const Eigen::VectorXd x = f.point(), g = f.gradient();
  std::normal_distribution<double> normal;
  check::Largest error;
  for(int n = 0; n < 20; ++n)
  {
    Eigen::VectorXd direction(x.size());
    for(double& d : direction)
      d = normal(random);
    const double step = 1e-5;
    double difference = 0;
    for(int sign : { 1, -1 })
    {
      check::that(f.evaluate(x + sign * step * direction), "a short step breaks the triangulation");
      difference += sign * f.value() / (2 * step);
      f.reject();
    }
    error.add(std::abs(difference - direction.dot(g)) / (direction.norm() * g.norm()));
  }
  check::that(error < 1e-6, "the gradient is off by ", error);
  std::cout << "gradient off by " << error << std::endl;
}

// Repairs lead to the same energy as a triangulation from scratch.
static void repairs(std::mt19937& random)
{
  Moving_triangulation_3 mesh = cube(random);
  Odt_objective_3 f = objective(mesh);
  std::uniform_real_distribution<double> u(-0.02, 0.02);
  for(int n = 0; n < 10; ++n)
  {
    Eigen::VectorXd x = f.point();
    for(double& t : x)
      t += u(random);
    if(!f.evaluate(x))
    {
      f.reject();
      continue;
    }
    f.accept();
    const double energy = f.value();
    check::that(mesh.is_regular(), "not the Delaunay triangulation");
    check::that(std::abs(voronoi_energy(mesh) / energy - 1) < 1e-12, "the energy is not that of the cells");
  }
  check::that(mesh.statistics().flips > 200, "hardly a flip");
}

// The step of Lloyd never raises the energy; L-BFGS finds a lower one, where the gradient vanishes.
static void minimization(std::mt19937& random)
{
  Moving_triangulation_3 mesh = cube(random), copy = mesh;
  Odt_objective_3 lloyd = objective(copy);
  Averaging_iteration averaging;
  double last = lloyd.value();
  int rises = 0;
  for(int n = 0; n < 60 && averaging.iterate(lloyd); ++n)
  {
    rises += lloyd.value() > last * (1 + 1e-12);
    last = lloyd.value();
  }
  check::that(rises == 0, "Lloyd's iteration raises the energy ", rises, " times");
  Odt_objective_3 f = objective(mesh);
  const double first_gradient = f.gradient().norm();
  Limited_memory_bfgs minimizer;
  for(int n = 0; n < 300 && f.gradient().norm() > 1e-9 * first_gradient; ++n)
    if(minimizer.iterate(f) == Limited_memory_bfgs::NO_STEP_FOUND)
      break;
  check::that(f.gradient().norm() < 1e-6 * first_gradient, "the gradient stays at ", f.gradient().norm() / first_gradient);
  check::that(f.value() < 1.002 * last, "L-BFGS ends at ", f.value(), ", Lloyd's iteration at ", last);
  check::that(mesh.is_regular(), "not the Delaunay triangulation");
}

int main()
{
  const unsigned int seed = 7;
  std::cout << "seed " << seed << std::endl;
  std::mt19937 random(seed);
  definition(random);
  derivative(random);
  repairs(random);
  minimization(random);
  return check::result();
}
