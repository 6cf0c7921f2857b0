// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What it gives to move vertices on surfaces, and in which way, beside CGAL's own optimizer, on the
// same meshes in one run, in process CPU time:
//   - the boundary fixed,
//   - the boundary remeshed by restricted CVT, then the interior with the boundary fixed
//     (the way of the paper, section 5.1),
//   - some remeshing, then all vertices together,
//   - the same after the boundary has been remeshed to the end,
//   - the same with rounds of global search.
// Slivers are not removed.
//
//   move_boundary [rounds of search, default 10] [iterations of CGAL's optimizer without freezing, default 0]
//
// Environment: CGAL_DATA_DIR, the directory of CGAL's data.

#include "benchmark_inputs.h"
#include "cpu_seconds.h"
#include "odt_of_mesh_3.h"

#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>

using namespace inputs;
namespace odt = CGAL::Global_odt_mesh_3::internal;

static int search_rounds = 10, cgal_iterations = 0;

struct Cost
{
  double seconds = 0;
  std::size_t questions = 0, projections = 0, surface_vertices = 0;
};

template <class C3t3>
void print(const char* what, const C3t3& c3t3, double input_volume, const Cost& cost)
{
  const CGAL::Mesh_quality_report_3 r = CGAL::mesh_quality_report_3(c3t3, { 10, 20 });
  std::printf("  %-22s %.4f  %6.2f - %6.2f  %4zu %5zu  %+.3f %%  %6.2f s", what, r.mean_radius_ratio, r.smallest_angle,
              r.largest_angle, r.cells_below[0].second, r.cells_below[1].second,
              100 * (r.total().volume / input_volume - 1), cost.seconds);
  if(cost.surface_vertices > 0)
    std::printf("  %6.2f %6.2f", cost.questions / double(cost.surface_vertices),
                cost.projections / double(cost.surface_vertices));
  std::printf("\n");
  std::fflush(stdout);
}

template <class C3t3, class Domain>
void run(C3t3& c3t3, const Domain& domain, const odt::Odt_parameters& parameters, Cost& cost,
         odt::Odt_task task = odt::Odt_task::OPTIMIZE)
{
  typedef CGAL::Mesh_3::Null_global_optimizer_visitor<C3t3> Visitor;
  Visitor visitor;
  odt::Odt_mesh_optimizer_3<C3t3, Domain, Visitor> optimizer(c3t3, domain, task, parameters, visitor);
  cost.seconds += seconds([&] { optimizer(); });
  const odt::Oracle_statistics& s = optimizer.oracle_statistics();
  cost.questions += s.locations + s.intersections;
  cost.projections += s.projections;
  const auto& tr = c3t3.triangulation();
  cost.surface_vertices = std::count_if(tr.finite_vertices_begin(), tr.finite_vertices_end(),
                                        [](const auto& v) { return v.in_dimension() == 2; });
}

template <class C3t3, class Domain>
void compare(const char* name, const C3t3& input, const Domain& domain)
{
  const double volume = CGAL::mesh_quality_report_3(input, { 10 }).total().volume;
  std::printf("\n%s: %zu vertices\n", name, std::size_t(input.triangulation().number_of_vertices()));
  std::printf("  %-22s %-7s %-16s %4s %5s  %-9s %8s  %s\n", "", "3r/R", "dihedral", "<10", "<20", "volume", "CPU",
              "questions and projections per surface vertex");
  print("input", input, volume, Cost());
  {
    C3t3 c3t3(input);
    Cost cost;
    cost.seconds = seconds([&] { odt_of_mesh_3(c3t3, domain); });
    print("CGAL, default", c3t3, volume, cost);
  }
  if(cgal_iterations > 0)
  {
    C3t3 c3t3(input);
    Cost cost;
    cost.seconds = seconds([&] { odt_of_mesh_3(c3t3, domain, cgal_iterations); });
    print(("CGAL, " + std::to_string(cgal_iterations) + " iterations").c_str(), c3t3, volume, cost);
  }
  odt::Odt_parameters together;
  together.number_of_rounds = 0;
  together.do_remove_slivers = false;
  odt::Odt_parameters fixed = together, searching = together;
  fixed.optimize_boundary = false;
  searching.number_of_rounds = search_rounds;
  // Goes on from `c3t3`, at that cost, and prints the result.
  const auto measure = [&](const std::string& what, C3t3 c3t3, const odt::Odt_parameters& parameters, Cost cost = Cost())
  {
    run(c3t3, domain, parameters, cost);
    print(what.c_str(), c3t3, volume, cost);
  };
  measure("boundary fixed", input, fixed);
  {
    C3t3 remeshed(input);
    Cost cost;
    run(remeshed, domain, together, cost, odt::Odt_task::REMESH_BOUNDARY);
    print("remeshed", remeshed, volume, cost);
    measure("remeshed, then fixed", remeshed, fixed, cost);
    measure("remeshed, then together", remeshed, together, cost);
  }
  measure("together", input, together);
  measure("search, " + std::to_string(search_rounds) + " rounds", input, searching);
}

int main(int argc, char* argv[])
{
  search_rounds = argc > 1 ? std::atoi(argv[1]) : search_rounds;
  cgal_iterations = argc > 2 ? std::atoi(argv[2]) : cgal_iterations;
  for_each_input([](const char* name, const auto& input, const auto& domain) { compare(name, input, domain); });
  return EXIT_SUCCESS;
}
