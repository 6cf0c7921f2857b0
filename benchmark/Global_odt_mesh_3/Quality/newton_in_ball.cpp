// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Figure 9 of the paper: a ball with the density x^2, random points with the density as probability. 50 iterations of L-BFGS with the
// exact gradient beside 50 of the approximate Newton method of Chen and Holst, with the full step and with the shorter one that
// serves it best: exact energy, and process CPU time of an iteration.
//
//   newton_in_ball [number of seeds, default 3 [number of iterations, default 50 [directory for rows and pictures]]]

#include "Approximate_newton.h"
#include "graded_runs.h"
#include "paper_record.h"
#include "random_points.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Polynomial_density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>
#include <CGAL/Quadratic_density_3.h>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <vector>

using namespace CGAL::Global_odt_mesh_3::internal;

typedef CGAL::Quadratic_density_3<CGAL::Exact_predicates_inexact_constructions_kernel> Quadratic_density;

// About as far from each other there as those near it inside.
static const std::size_t number_on_sphere = 2200, number_in_ball = 8000;

static std::vector<Coordinates> points_on_sphere(std::size_t number)
{
  const double golden_angle = 3.14159265358979324 * (3 - std::sqrt(5.));
  std::vector<Coordinates> points;
  for(std::size_t n = 0; n < number; ++n)
  {
    const double z = 1 - (2 * double(n) + 1) / double(number), r = std::sqrt(1 - z * z);
    points.push_back({{ r * std::cos(golden_angle * double(n)), r * std::sin(golden_angle * double(n)), z }});
  }
  return points;
}

static double exact_energy(Moving_triangulation_3 mesh, Density_quadrature_3& quadrature)
{
  mesh.set_quadrature(&quadrature);
  mesh.is_regular();
  return mesh.energy();
}

int main(int argc, char* argv[])
{
  const unsigned int seeds = argc > 1 ? std::atoi(argv[1]) : 3;
  const int iterations = argc > 2 ? std::atoi(argv[2]) : 50;
  const Quadratic_polynomial_3 polynomial = Quadratic_density::squared_distance().polynomial();
  Function_density_3 density([&polynomial](const Site& s) { return polynomial(s); });
  Quadratic_density_quadrature_3 exact(polynomial);
  Paper_record record(argc > 3 ? argv[3] : "");
  // Of L-BFGS, and of the approximate Newton method with full and with shorter steps.
  std::vector<double> gains(3, 0), times(3, 0);
  bool is_lower = true;
  std::printf("seed  %-20s %12s %12s %6s %9s %6s %16s\n", "method", "E at first", "E at last", "its", "gradient", "rises",
              "CPU ms/iteration");
  for(unsigned int seed = 1; seed <= seeds; ++seed)
  {
    std::vector<Coordinates> points = points_on_sphere(number_on_sphere);
    add_random_points(seed, number_on_sphere + number_in_ball, [](const Coordinates& p)
    {
      const double rho = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
      // Not outside of the facets.
      return rho < 0.98 ? rho : 0;
    }, points);
    const Moving_triangulation_3 ball = triangulate(points);
    std::ofstream traces;
    if(seed == 1 && record.has_directory())
      traces = record.data("figure_9");
    std::size_t method = 0;
    double lowest = 0;
    const auto print = [&](const char* name, Graded_run& run, const Energy_trace& trace)
    {
      if(method == 0)
        lowest = trace.last();
      is_lower = is_lower && lowest <= trace.last();
      gains[method] += 100 * (trace.last() / exact_energy(ball, exact) - 1) / seeds;
      times[method] += 1e3 * run.time() / run.iterations() / seeds;
      ++method;
      if(traces.is_open())
        write_trace(trace, traces);
      std::printf("%4u  %-20s %12.8f %12.8f %6d %9.1e %6d %16.2f\n", seed, name, exact_energy(ball, exact), trace.last(),
                  run.iterations(), run.objective().gradient().norm(), trace.rises(), 1e3 * run.time() / run.iterations());
      std::fflush(stdout);
    };
    {
      Graded_run run(ball, std::make_unique<Quadratic_density_quadrature_3>(polynomial));
      Limited_memory_bfgs minimizer;
      Energy_trace trace;
      run.repeat(iterations, [&](int) { return minimizer.iterate(run.objective()) == Limited_memory_bfgs::STEP_TAKEN; },
                 [&] { trace.add(exact_energy(run.mesh(), exact), run); });
      print("L-BFGS", run, trace);
    }
    for(double step_length : { 1., 0.7 })
    {
      Graded_run run(ball, one_point_quadrature(density));
      Approximate_newton newton(step_length);
      Energy_trace trace;
      run.repeat(iterations, [&](int) { return newton.iterate(run.mesh(), run.objective()); },
                 [&] { trace.add(exact_energy(run.mesh(), exact), run); });
      char name[40];
      std::snprintf(name, sizeof name, "Newton, steps x %.2f", step_length);
      print(name, run, trace);
    }
  }
  record.rows("9", text("energy after %d iterations over that at first", iterations),
              { { "L-BFGS", "lower", percent(gains[0]) }, { "approximate Newton", "-", percent(gains[1]) },
                { "approximate Newton, 0.7 of the steps", "-", percent(gains[2]) } });
  record.rows("9", "time of an iteration over that of L-BFGS",
              { { "approximate Newton", "2", text("%.1f", times[1] / times[0]) },
                { "approximate Newton, 0.7 of the steps", "2", text("%.1f", times[2] / times[0]) } });
  record.claim("9", is_lower, "L-BFGS is lower after as many iterations");
  const std::vector<std::string> titles = { "L-BFGS", "Newton, full steps", "Newton, steps x 0.7" };
  record.draw("figure_9", "set multiplot layout 1,2\nset xlabel 'CPU s'\nset title 'energy'\nset logscale x\n"
              + Paper_record::plot("2:3", titles) + "set title 'gradient'\nset logscale y\n" + Paper_record::plot("2:4", titles)
              + "unset multiplot\n");
  return record.result();
}
