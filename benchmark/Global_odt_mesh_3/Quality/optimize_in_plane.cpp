// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the paper shows in two dimensions, on CGAL's constrained Delaunay triangulation:
//   3       the energies of eight vertices, one of which moves along a line
//   10, 18  random vertices in a square with evenly spaced ones on its boundary, which stay: AVV, L-BFGS and Algorithm 2, and
//           the same on the energy of the centroidal Voronoi tessellation, with the minimizer and the perturbations that serve
//           in space; beside CGAL's lloyd_optimize_mesh_2()
//
//   optimize_in_plane [number of seeds, default 3 [number of vertices, default 1000 [rounds of Algorithm 2, default 100
//                     [directory for rows and pictures]]]]

#include "Planar_energies.h"
#include "Planar_objective.h"
#include "averaging_iteration.h"
#include "cpu_seconds.h"
#include "paper_record.h"

#include <CGAL/Global_odt_mesh_3/internal/optimization/Annealing.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>

#include <CGAL/lloyd_optimize_mesh_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

using namespace CGAL::Global_odt_mesh_3::internal;

typedef Planar_kernel::Point_2 Point;

// The angles of a triangulation, and its energy.
struct Planar_outcome
{
  std::array<std::size_t, 60> histogram{};      // of three degrees each
  std::size_t number_of_angles = 0;
  double mean_smallest_angle = 0, smallest_angle = 180, energy = 0, time = 0;

  Planar_outcome(const Planar_triangulation& tr, double time) : time(time)
  {
    double sum = 0;
    for(auto f = tr.finite_faces_begin(); f != tr.finite_faces_end(); ++f)
    {
      double smallest = 180;
      const double area = std::abs(CGAL::area(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point()));
      for(int i = 0; i < 3; ++i)
      {
        const Planar_kernel::Vector_2 a = f->vertex((i + 1) % 3)->point() - f->vertex(i)->point();
        const Planar_kernel::Vector_2 b = f->vertex((i + 2) % 3)->point() - f->vertex(i)->point();
        const double angle = std::atan2(2 * area, a * b) * 180 / 3.14159265358979324;
        ++histogram[(std::min)(static_cast<int>(angle / 3), 59)];
        ++number_of_angles;
        smallest = (std::min)(smallest, angle);
        energy += area / 12 * a.squared_length();
      }
      sum += smallest;
      smallest_angle = (std::min)(smallest_angle, smallest);
    }
    mean_smallest_angle = 3 * sum / double(number_of_angles);
  }
};

// A start that all methods share.
struct Planar_input
{
  std::vector<Point> inside, boundary;

  Planar_input(unsigned int seed, int vertices)
  {
    // As far from each other as vertices inside will be in equilateral triangles.
    const int side = static_cast<int>(std::lround(1 / std::sqrt(2 / (std::sqrt(3.) * vertices))));
    const auto at = [side](int n) { return double(n) / side; };
    for(int n = 0; n < side; ++n) boundary.emplace_back(at(n), 0);
    for(int n = 0; n < side; ++n) boundary.emplace_back(1, at(n));
    for(int n = side; n > 0; --n) boundary.emplace_back(at(n), 1);
    for(int n = side; n > 0; --n) boundary.emplace_back(0, at(n));
    std::mt19937 random(seed);
    // Far enough from the boundary for its edges to see all Voronoi cells that it cuts.
    std::uniform_real_distribution<double> u(0.62 / side, 1 - 0.62 / side);
    while(static_cast<int>(inside.size() + boundary.size()) < vertices)
    {
      const double x = u(random), y = u(random);
      inside.emplace_back(x, y);
    }
  }
};

static void minimize(Planar_objective& f, int iterations)
{
  Limited_memory_bfgs minimizer;
  for(int n = 0; n < iterations && f.gradient().norm() > 1e-10; ++n)
    if(minimizer.iterate(f) == Limited_memory_bfgs::NO_STEP_FOUND)
      break;
}

// Algorithm 2 of the paper; gives the energies after each round.
static std::vector<double> search(Planar_objective& f, unsigned int seed, int rounds)
{
  const CGAL::Metropolis_annealing_schedule schedule;
  Metropolis_annealing annealing(seed, schedule);
  minimize(f, 300);
  std::vector<double> energies = { f.value() };
  for(int n = 0; n < rounds; ++n)
  {
    const Eigen::VectorXd before = f.point();
    const double energy = f.value();
    annealing.perturb(f);
    minimize(f, schedule.iterations_in_round);
    if(!annealing.accepts(f.value(), energy) && f.evaluate(before))
      f.keep();
    energies.push_back(f.value());
  }
  minimize(f, schedule.final_iterations);
  return energies;
}

static const std::array<const char*, 7> ways
  = {{ "AVV", "local ODT", "global ODT", "Lloyd", "local CVT", "global CVT", "lloyd_optimize_mesh_2 of CGAL" }};
enum { AVV, LOCAL_ODT, GLOBAL_ODT, LLOYD, LOCAL_CVT, GLOBAL_CVT, LLOYD_OF_MESH_2 };

// Outcomes[way][seed].
typedef std::array<std::vector<Planar_outcome>, 7> Planar_outcomes;

// Gives the energies of the rounds of global ODT.
static std::vector<double> run_all(const Planar_input& input, unsigned int seed, int rounds, Planar_outcomes& outcomes)
{
  std::vector<double> energies;
  for(int way = 0; way < LLOYD_OF_MESH_2; ++way)
  {
    Planar_objective f(way < LLOYD ? Energy::ODT : Energy::CVT, input.inside, input.boundary);
    const double time = seconds([&]
    {
      if(way == AVV || way == LLOYD)
      {
        Averaging_iteration averaging;
        for(int n = 0; n < 900 && averaging.iterate(f); ++n) {}
      }
      else if(way == LOCAL_ODT || way == LOCAL_CVT)
        minimize(f, 500);
      else
      {
        const std::vector<double> e = search(f, seed, rounds);
        if(way == GLOBAL_ODT)
          energies = e;
      }
    });
    outcomes[way].emplace_back(f.triangulation(), time);
  }
  Planar_triangulation tr = Planar_objective(Energy::CVT, input.inside, input.boundary).triangulation();
  const double time = seconds([&]
  {
    CGAL::lloyd_optimize_mesh_2(tr, CGAL::parameters::max_iteration_number = 900, CGAL::parameters::convergence = 0,
                                CGAL::parameters::freeze_bound = 0);
  });
  outcomes[LLOYD_OF_MESH_2].emplace_back(tr, time);
  return energies;
}

static double mean(const std::vector<Planar_outcome>& outcomes, double Planar_outcome::* what)
{
  double sum = 0;
  for(const Planar_outcome& o : outcomes)
    sum += o.*what;
  return sum / double(outcomes.size());
}

static void figures_10_and_18(Paper_record& record, unsigned int seeds, int vertices, int rounds)
{
  Planar_outcomes outcomes;
  std::vector<double> energies;
  for(unsigned int seed = 1; seed <= seeds; ++seed)
    energies = run_all(Planar_input(seed, vertices), seed, rounds, outcomes);
  const double avv = mean(outcomes[AVV], &Planar_outcome::energy);
  const auto gain = [&](int way) { return 100 * (mean(outcomes[way], &Planar_outcome::energy) / avv - 1); };
  record.row("10", "energy of L-BFGS over that of AVV", "-", percent(gain(LOCAL_ODT)));
  record.row("10", text("energy of %d rounds of global ODT over that of AVV", rounds), "-4.68 % (100 rounds)",
             percent(gain(GLOBAL_ODT)));
  record.row("10", "time of global ODT over that of AVV", "2.2",
             text("%.1f", mean(outcomes[GLOBAL_ODT], &Planar_outcome::time) / mean(outcomes[AVV], &Planar_outcome::time)));
  for(int way = 0; way < 7; ++way)
    record.rows("18", std::string(ways[way]) + ", in the plane",
                { { "mean of the smallest angles of triangles (degrees)", "-",
                    text("%.2f", mean(outcomes[way], &Planar_outcome::mean_smallest_angle)) },
                  { "smallest angle (degrees)", "-", text("%.1f", mean(outcomes[way], &Planar_outcome::smallest_angle)) },
                  { "CPU time (s)", "-", text("%.2f", mean(outcomes[way], &Planar_outcome::time)) } });
  record.claim("10", gain(GLOBAL_ODT) < gain(LOCAL_ODT) && gain(GLOBAL_ODT) < 0, "AVV and L-BFGS are above global ODT");
  record.claim("18", mean(outcomes[LOCAL_CVT], &Planar_outcome::mean_smallest_angle)
                     > mean(outcomes[LOCAL_ODT], &Planar_outcome::mean_smallest_angle) - 0.5,
               "ODT has no advantage over CVT in the plane: local ones, mean of the smallest angles");
  if(!record.has_directory())
    return;
  {
    std::ofstream out = record.data("figure_10");
    for(std::size_t n = 0; n < energies.size(); ++n)
      out << n << ' ' << energies[n] << '\n';
    std::ofstream histograms = record.data("figure_18");
    for(const auto& o : outcomes)
    {
      for(std::size_t n = 0; n < o[0].histogram.size(); ++n)
        histograms << 3 * double(n) + 1.5 << ' ' << double(o[0].histogram[n]) / double(o[0].number_of_angles) << '\n';
      histograms << "\n\n";
    }
  }
  record.draw("figure_10", "set xlabel 'round of global ODT'\nset ylabel 'energy'\nplot data with lines lw 2 notitle\n", 700);
  record.draw("figure_18", "set xlabel 'angle of a triangle (degrees)'\nset ylabel 'share of angles'\nset xrange [0:140]\n"
              "set yrange [0:*]\nset key outside right\n"
              + Paper_record::plot("1:2", std::vector<std::string>(ways.begin(), ways.end()), "histeps lw 2"), 1000);
}

// At these positions of the vertex that moves.
static Planar_energies energies_at(double t)
{
  const std::vector<Point> points = { { -1, -0.2 }, { -0.4, -0.9 }, { 0.6, -0.85 }, { 1.05, 0.1 }, { 0.5, 0.95 }, { -0.55, 0.8 },
                                      { 0.35, -0.3 }, { -0.55 + t, 0.1 + 0.15 * t } };
  return Planar_energies(points, [](const Point& p) { return 2 + 1.5 * p.x(); });
}

// One-sided limits and slopes, at the parameter where the triangulation changes between two others.
struct Crossing
{
  double at, jump_of_discrete, jump_of_continuous, kink_of_continuous, kink_of_cvt;
};

static Crossing crossing(double low, double high)
{
  const auto edges = energies_at(low).edges;
  for(int n = 0; n < 60; ++n)
  {
    const double middle = (low + high) / 2;
    (energies_at(middle).edges == edges ? low : high) = middle;
  }
  const auto jump = [&](double Planar_energies::* e) { return std::abs(energies_at(high).*e / (energies_at(low).*e) - 1); };
  const auto kink = [&](double Planar_energies::* e)
  {
    const double step = 1e-5;
    const double left = (energies_at(low).*e - energies_at(low - step).*e) / step;
    const double right = (energies_at(high + step).*e - energies_at(high).*e) / step;
    return std::abs(right - left);
  };
  return { low, jump(&Planar_energies::discrete), jump(&Planar_energies::continuous), kink(&Planar_energies::continuous),
           kink(&Planar_energies::cvt) };
}

static void figure_3(Paper_record& record)
{
  const int steps = 400;
  const auto at = [](int n) { return double(n) / steps; };
  int crossings = 0;
  Crossing largest = { 0, 0, 0, 0, 0 };
  std::ofstream out;
  if(record.has_directory())
    out = record.data("figure_3");
  for(int n = 0; n <= steps; ++n)
  {
    const Planar_energies e = energies_at(at(n));
    if(out.is_open())
      out << at(n) << ' ' << e.cvt << ' ' << e.discrete << ' ' << e.continuous << '\n';
    if(n == 0 || energies_at(at(n - 1)).edges == e.edges)
      continue;
    const Crossing c = crossing(at(n - 1), at(n));
    ++crossings;
    largest.jump_of_discrete = (std::max)(largest.jump_of_discrete, c.jump_of_discrete);
    largest.jump_of_continuous = (std::max)(largest.jump_of_continuous, c.jump_of_continuous);
    largest.kink_of_continuous = (std::max)(largest.kink_of_continuous, c.kink_of_continuous);
    largest.kink_of_cvt = (std::max)(largest.kink_of_cvt, c.kink_of_cvt);
  }
  out.close();
  record.row("3", "changes of the triangulation on the way", "-", text("%d", crossings));
  record.rows("3", "largest jump, relative to the energy", { { "(2.4)", "some", text("%.1e", largest.jump_of_discrete) },
                                                             { "(2.5)", "none", text("%.1e", largest.jump_of_continuous) } });
  record.rows("3", "largest change of the slope", { { "(2.5)", "some", text("%.1e", largest.kink_of_continuous) },
                                                    { "CVT energy", "none", text("%.1e", largest.kink_of_cvt) } });
  record.claim("3", crossings > 0 && largest.jump_of_discrete > 1e-4 && largest.jump_of_continuous < 1e-9
                    && largest.kink_of_continuous > 1e-2 && largest.kink_of_cvt < 1e-3,
               "(2.4) jumps, (2.5) is continuous with a kink, the CVT energy is smooth");
  std::string commands = "set multiplot layout 1,3\nset xlabel 't'\nunset key\n";
  int column = 1;
  for(const char* title : { "CVT", "(2.4)", "(2.5)" })
    commands += text("set title '%s'\n", title) + Paper_record::plot(text("1:%d", ++column), { title });
  record.draw("figure_3", commands + "unset multiplot\n");
}

int main(int argc, char* argv[])
{
  const unsigned int seeds = argc > 1 ? std::atoi(argv[1]) : 3;
  const int vertices = argc > 2 ? std::atoi(argv[2]) : 1000;
  const int rounds = argc > 3 ? std::atoi(argv[3]) : 100;
  Paper_record record(argc > 4 ? argv[4] : "");
  figure_3(record);
  figures_10_and_18(record, seeds, vertices, rounds);
  return record.result();
}
