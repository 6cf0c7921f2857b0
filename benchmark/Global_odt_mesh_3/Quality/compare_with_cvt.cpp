// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Figures 19 and 20 of the paper: centroidal Voronoi tessellations beside optimal Delaunay triangulations from the same random
// interior of a cube, by the same minimizers and searches on either energy; and the ODT methods begun where the CVT ones end.
// The surface, which stays, has nearly equilateral facets. No slivers are removed afterwards.
//
//   compare_with_cvt [number of seeds, default 3 [number of vertices, default 10000 [directory for rows and pictures]]]
//
// Energies are relative to those of the local minima from the same start, in process CPU time.

#include "flat_mesh_outcome.h"
#include "methods/Averaging.h"
#include "methods/Global_search_method.h"
#include "methods/Quasi_newton.h"
#include "paper_record.h"
#include "random_points.h"

#include <CGAL/Annealing_schedules_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

using namespace CGAL::Global_odt_mesh_3::internal;

typedef std::function<std::unique_ptr<Method>()> Maker;

// Methods that follow each other.
struct Way
{
  std::string name;
  std::vector<Maker> methods;
};

// What comes of it, with both energies.
struct Result
{
  Outcome outcome;
  double voronoi_energy;
};

template <class M, class... Arguments>
Maker make(const Arguments&... arguments)
{
  return [=] { return std::make_unique<M>(arguments...); };
}

enum { LLOYD, LOCAL_CVT, GLOBAL_CVT, MOMENTUM_CVT, LOCAL_ODT, GLOBAL_ODT, MOMENTUM_ODT, CVT_LOCAL_ODT, GLOBAL_CVT_LOCAL_ODT,
       CVT_MOMENTUM_ODT };

static std::vector<Way> ways()
{
  const CGAL::Metropolis_annealing_schedule algorithm_2;
  const CGAL::Momentum_annealing_schedule momentum;
  const Maker lloyd = make<Averaging>(Energy::CVT), cvt = make<Quasi_newton>(Energy::CVT), odt = make<Quasi_newton>(Energy::ODT);
  const Maker global_cvt = make<Global_search_method>(Energy::CVT, algorithm_2);
  const Maker momentum_odt = make<Global_search_method>(Energy::ODT, momentum);
  return { { "Lloyd, 300 iterations", { lloyd } },
           { "local CVT", { cvt } },
           { "global CVT (Algorithm 2)", { global_cvt } },
           { "global CVT (momentum)", { make<Global_search_method>(Energy::CVT, momentum) } },
           { "local ODT", { odt } },
           { "global ODT (Algorithm 2)", { make<Global_search_method>(Energy::ODT, algorithm_2) } },
           { "global ODT (momentum)", { momentum_odt } },
           { "local CVT, local ODT", { cvt, odt } },
           { "global CVT, local ODT", { global_cvt, odt } },
           { "local CVT, global ODT (momentum)", { cvt, momentum_odt } } };
}

static Result result(const Way& way, Moving_triangulation_3 mesh, unsigned int seed)
{
  double time = 0;
  for(const Maker& m : way.methods)
    time += run(*m(), mesh, seed, 300).time;
  return { outcome(mesh, time), voronoi_energy(mesh) };
}

// Results[way][seed].
typedef std::vector<std::vector<Result> > Results;

static double mean(const std::vector<Result>& results, const std::function<double(const Result&)>& what)
{
  double sum = 0;
  for(const Result& r : results)
    sum += what(r);
  return sum / double(results.size());
}

static double radius_ratio(const Result& r) { return r.outcome.mean_radius_ratio; }
static double slivers(const Result& r) { return double(r.outcome.cells_below[0].second); }

static void print(const std::vector<Way>& all, const Results& results)
{
  std::printf("%-34s %9s %9s %7s %6s %6s %7s\n", "", "E_CVT %", "E_ODT %", "3r/R", "<10", "<20", "CPU s");
  for(std::size_t w = 0; w < all.size(); ++w)
  {
    const auto gain = [&](std::size_t reference, const auto& energy)
    {
      return 100 * (mean(results[w], energy) / mean(results[reference], energy) - 1);
    };
    std::printf("%-34s %+9.3f %+9.3f %7.4f %6.1f %6.1f %7.2f\n", all[w].name.c_str(),
                gain(LOCAL_CVT, [](const Result& r) { return r.voronoi_energy; }),
                gain(LOCAL_ODT, [](const Result& r) { return r.outcome.energy; }), mean(results[w], radius_ratio),
                mean(results[w], slivers), mean(results[w], [](const Result& r) { return double(r.outcome.cells_below[3].second); }),
                mean(results[w], [](const Result& r) { return r.outcome.time; }));
  }
}

static void record_figures(Paper_record& record, const std::vector<Way>& all, const Results& results)
{
  const auto record_way = [&](const std::string& figure, int w, const char* slivers_of_paper, const char* ratio_of_paper)
  {
    record.rows(figure, all[w].name, { { "cells below 10 degrees", slivers_of_paper, text("%.0f", mean(results[w], slivers)) },
                                       { "mean 3r/R", ratio_of_paper, text("%.4f", mean(results[w], radius_ratio)) } });
  };
  for(int w : { LLOYD, LOCAL_CVT, GLOBAL_CVT, MOMENTUM_CVT, LOCAL_ODT, GLOBAL_ODT, MOMENTUM_ODT })
    record_way("19", w, "-", "-");
  record_way("20", LOCAL_CVT, "195", "0.8930");
  record_way("20", CVT_LOCAL_ODT, "16", "0.9085");
  record_way("20", GLOBAL_CVT, "-", "-");
  record_way("20", GLOBAL_CVT_LOCAL_ODT, "-", "-");
  const auto energy = [&](int w) { return mean(results[w], [](const Result& r) { return r.outcome.energy; }); };
  record.row("20", "energy of momentum annealing begun at CVT over that from random vertices", "-",
             text("%+.3f %%", 100 * (energy(CVT_MOMENTUM_ODT) / energy(MOMENTUM_ODT) - 1)));
  const auto always = [&](int a, int b, const std::function<bool(const Result&, const Result&)>& holds)
  {
    bool all_hold = true;
    for(std::size_t n = 0; n < results[a].size(); ++n)
      all_hold = all_hold && holds(results[a][n], results[b][n]);
    return all_hold;
  };
  const auto has_lower_voronoi_energy = [](const Result& a, const Result& b) { return a.voronoi_energy < b.voronoi_energy; };
  const auto has_fewer_slivers = [](const Result& a, const Result& b) { return slivers(a) < slivers(b); };
  const auto is_better = [](const Result& a, const Result& b)
  {
    return radius_ratio(a) > radius_ratio(b) && slivers(a) < slivers(b);
  };
  record.claim("19", always(LOCAL_CVT, LLOYD, has_lower_voronoi_energy), "L-BFGS is below Lloyd's method");
  record.claim("19", always(GLOBAL_CVT, LOCAL_CVT, has_lower_voronoi_energy), "global CVT is below local CVT");
  record.claim("19", always(LOCAL_ODT, LOCAL_CVT, has_fewer_slivers) && always(GLOBAL_ODT, GLOBAL_CVT, has_fewer_slivers),
               "ODT has fewer slivers than CVT, local and global");
  record.claim("20", always(CVT_LOCAL_ODT, LOCAL_CVT, is_better) && always(GLOBAL_CVT_LOCAL_ODT, GLOBAL_CVT, is_better),
               "ODT after CVT raises the mean 3r/R and removes slivers");
  const auto picture = [&](const char* name, std::initializer_list<int> which)
  {
    std::vector<std::pair<std::string, CGAL::Mesh_quality_report_3> > meshes;
    for(int w : which)
      meshes.emplace_back(all[w].name, results[w][0].outcome);
    record.draw_histograms(name, meshes);
  };
  picture("figure_19", { LOCAL_CVT, GLOBAL_CVT, LOCAL_ODT, GLOBAL_ODT });
  picture("figure_20", { LOCAL_CVT, CVT_LOCAL_ODT, GLOBAL_CVT, GLOBAL_CVT_LOCAL_ODT });
}

int main(int argc, char* argv[])
{
  const unsigned int seeds = argc > 1 ? std::atoi(argv[1]) : 3;
  const std::size_t vertices = argc > 2 ? std::atoi(argv[2]) : 10000;
  Paper_record record(argc > 3 ? argv[3] : "");
  const std::vector<Way> all = ways();
  Results results(all.size());
  for(unsigned int seed = 1; seed <= seeds; ++seed)
  {
    // Far enough from the surface for its facets to see all Voronoi cells that it cuts.
    Moving_triangulation_3 cube = random_cube(seed, vertices, Cube_surface::SHIFTED_ROWS, 0.62);
    for(std::size_t w = 0; w < all.size(); ++w)
      results[w].push_back(result(all[w], cube, seed));
    std::fprintf(stderr, "seed %u of %u\n", seed, seeds);
  }
  print(all, results);
  record_figures(record, all, results);
  return record.result();
}
