// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Figures 6 and 7 of the paper: L-BFGS and the AVV iteration from the same random
// interior of a cube, on the same engine, in process CPU time.
//
//   minimize_in_cube [number of seeds, default 5 [number of vertices, default 18083 [directory for rows and pictures]]]
//
// With 18,083 vertices, 3,752 are a grid on the surface that stays.

#include "flat_mesh_outcome.h"
#include "methods/Averaging.h"
#include "methods/Quasi_newton.h"
#include "paper_record.h"
#include "random_points.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <numeric>
#include <string>
#include <vector>

using namespace CGAL::Global_odt_mesh_3::internal;

// The energies that a method has come to, and its time.
struct Minima
{
  std::vector<double> energies;
  double time = 0;

  double mean() const { return std::accumulate(energies.begin(), energies.end(), 0.) / double(energies.size()); }
  double lowest() const { return *std::min_element(energies.begin(), energies.end()); }
  double highest() const { return *std::max_element(energies.begin(), energies.end()); }
};

// Runs a method on the mesh; iterations go to `trace`, if it is open: number, time, energy, gradient and flips.
static Run trace_run(Method& method, Moving_triangulation_3& mesh, int iterations, std::ofstream& trace, Minima& minima)
{
  std::size_t flips = mesh.statistics().flips;
  const Run r = run(method, mesh, 0, iterations, [&](const Run& r)
  {
    if(!trace.is_open())
      return;
    trace << r.iterations << ' ' << r.time << ' ' << text("%.10e", method.energy()) << ' ' << method.gradient() << ' '
          << mesh.statistics().flips - flips << '\n';
    flips = mesh.statistics().flips;
  });
  if(trace.is_open())
    trace << "\n\n";
  minima.energies.push_back(method.energy());
  minima.time += r.time;
  return r;
}

static void draw_figures(const Paper_record& record, double reference)
{
  const std::string percents = text("(100*($3/%.12e-1))", reference);
  const std::vector<std::string> titles = { "L-BFGS", "AVV" };
  record.draw("figure_6", "set multiplot layout 1,3\nset xtics 100\nset xlabel 'iterations'\n"
              "set title 'energy over that of AVV, %'\nset yrange [-1:3]\n" + Paper_record::plot("1:" + percents, titles)
              + "set yrange [*:*]\nset logscale y\nset title 'gradient'\n" + Paper_record::plot("1:4", titles)
              + "set xtics 40\nset title 'flips in an iteration'\n" + Paper_record::plot("1:5", { titles[0] })
              + "unset multiplot\n");
  record.draw("figure_7", "set xlabel 'seed'\nset ylabel 'energy over the mean of AVV, %'\n"
              "plot data using 1:2 with points pt 7 title 'L-BFGS', data using 1:3 with points pt 6 title 'AVV'\n", 800);
}

int main(int argc, char* argv[])
{
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 5;
  const std::size_t vertices = argc > 2 ? std::atoi(argv[2]) : 18083;
  Paper_record record(argc > 3 ? argv[3] : "");
  Minima ours, avv;
  int wins = 0;
  std::printf("seed  L-BFGS: its  |g|       E           AVV: its  |g|       E           E %%\n");
  for(int seed = 1; seed <= seeds; ++seed)
  {
    Moving_triangulation_3 mesh = random_cube(seed, vertices), copy = mesh;
    std::ofstream trace;
    if(seed == 1 && record.has_directory())
      trace = record.data("figure_6");
    Quasi_newton minimizer(Energy::ODT);
    const Run r = trace_run(minimizer, mesh, 400, trace, ours);
    Averaging averaging(Energy::ODT);
    const Run s = trace_run(averaging, copy, 499, trace, avv);
    wins += minimizer.energy() < averaging.energy();
    std::printf("%4d  %11d  %.2e  %.5e %9d  %.2e  %.5e %+.3f\n", seed, r.iterations, minimizer.gradient(),
                minimizer.energy(), s.iterations, averaging.gradient(), averaging.energy(),
                100 * (minimizer.energy() / averaging.energy() - 1));
    std::fflush(stdout);
    if(seed == 1)
    {
      record.rows("6", "iterations", { { "L-BFGS", "122", text("%d", r.iterations) }, { "AVV", "499", text("%d", s.iterations) } });
      record.draw_histograms("figure_6_histograms", { { "L-BFGS", outcome(mesh, 0) }, { "AVV", outcome(copy, 0) } });
    }
  }
  const double mean = avv.mean();
  record.row("7", "mean energy of L-BFGS over that of AVV", "-0.32 %", percent(100 * (ours.mean() / mean - 1)));
  record.row("7", "range of L-BFGS over the mean of AVV", "-",
             text("%+.2f to %+.2f %%", 100 * (ours.lowest() / mean - 1), 100 * (ours.highest() / mean - 1)));
  record.row("7", "range of AVV over its mean", "-0.20 to +0.03 %",
             text("%+.2f to %+.2f %%", 100 * (avv.lowest() / mean - 1), 100 * (avv.highest() / mean - 1)));
  record.row("7", "L-BFGS is lower", "200 of 200", text("%d of %d", wins, seeds));
  record.row("6", "time of AVV over that of L-BFGS", "3.3", text("%.2f", avv.time / ours.time));
  record.claim("7", wins == seeds, "L-BFGS is lower from every start");
  record.claim("6", avv.time > ours.time, "L-BFGS is faster");
  if(record.has_directory())
  {
    std::ofstream out = record.data("figure_7");
    for(int n = 0; n < seeds; ++n)
      out << n + 1 << ' ' << 100 * (ours.energies[n] / mean - 1) << ' ' << 100 * (avv.energies[n] / mean - 1) << '\n';
    out.close();
    draw_figures(record, avv.energies[0]);
  }
  return record.result();
}
