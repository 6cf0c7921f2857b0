// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// odt_optimize_mesh_3() beside CGAL's own optimizer, Mesh_global_optimizer with
// Odt_move, on the same meshes in one run, in process CPU time.
//
//   compare_with_mesh_3 [iterations of CGAL's optimizer, default 100]
//
// No vertex is frozen (freeze_bound 0) by either where iterations
// are compared. Environment: CGAL_DATA_DIR, the directory of CGAL's data.

#include "benchmark_inputs.h"
#include "cpu_seconds.h"
#include "odt_of_mesh_3.h"

#include <CGAL/Global_odt_mesh_3/internal/complex/Candidate_checks_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_updater_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Snapshot_reader_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Snapshot_tabulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/door/C3t3_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Mesh_domain_view_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Timer.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

using namespace inputs;

static int cgal_iterations = 100;

// The time from the first direction to the end of the last iteration.
struct Iteration_timer
{
  CGAL::Timer timer;
  int iterations = 0;
  double total = 0;
  void after_compute_moves() { if(!timer.is_running()) timer.start(); }
  void after_move_points() {}
  void after_rebuild_restricted_delaunay() {}
  void end_of_iteration(int)
  {
    ++iterations;
    total = timer.time();
  }
};

template <class C3t3>
void print_quality(const char* what, const C3t3& c3t3)
{
  const CGAL::Mesh_quality_report_3 r = CGAL::mesh_quality_report_3(c3t3, { 10, 20 });
  std::printf("  %-28s mean 3r/R %.4f  angles %6.2f - %6.2f  cells <10: %5zu  <20: %5zu  volume %.8g\n", what,
              r.mean_radius_ratio, r.smallest_angle, r.largest_angle, r.cells_below[0].second, r.cells_below[1].second,
              r.total().volume);
}

template <class C3t3, class Domain>
void compare(const char* name, const C3t3& input, const Domain& domain)
{
  typedef typename C3t3::Triangulation Triangulation;
  namespace odt = CGAL::Global_odt_mesh_3::internal;
  std::printf("\n%s: %zu vertices\n", name, std::size_t(input.triangulation().number_of_vertices()));
  print_quality("input", input);

  // Exact rebuild, import and export, the best of five each.
  double rebuild = 1e300, bridge = 1e300;
  std::vector<typename Triangulation::Weighted_point> points;
  for(auto v = input.triangulation().finite_vertices_begin(); v != input.triangulation().finite_vertices_end(); ++v)
    points.push_back(input.triangulation().point(v));
  C3t3 moved(input);
  CGAL::odt_optimize_mesh_3(moved, domain);
  for(int n = 0; n < 5; ++n)
  {
    rebuild = (std::min)(rebuild, seconds([&]
    {
      Triangulation tr;
      tr.insert(points.begin(), points.end());
    }));
    C3t3 copy(moved);
    bridge = (std::min)(bridge, seconds([&]
    {
      odt::Mesh_domain_view_3<Domain> domain_view(domain);
      odt::C3t3_view_3<C3t3, Domain> view(copy, domain_view);
      odt::Facet_bounds_3 bounds(domain_view);
      odt::Complex_updater_3 complex(domain_view, bounds, false);
      odt::Moving_triangulation_3 mesh;
      complex.start(odt::Snapshot_reader_3(view).read(mesh, false));
      if(complex.advance(mesh, true))
        view.write(odt::Snapshot_tabulation_3(complex.snapshot(), complex.triangulation(), odt::Thread_policy())());
    }));
  }
  std::printf("  exact rebuild %.1f ms; import and export %.1f ms, %.2f rebuilds\n",
              1e3 * rebuild, 1e3 * bridge, bridge / rebuild);

  C3t3 ours(input);
  const double default_time = seconds([&] { CGAL::odt_optimize_mesh_3(ours, domain); });
  print_quality("ours, default call", ours);

  C3t3 hundred(input);
  Iteration_timer timer;
  const double hundred_time = seconds([&]
  {
    CGAL::odt_optimize_mesh_3(hundred, domain, params::do_freeze = false, params::convergence = 0,
                              params::max_iteration_number = 100, params::number_of_rounds = 0,
                              params::do_remove_slivers = false, params::visitor(std::ref(timer)));
  });
  print_quality("ours, 100 iterations", hundred);

  C3t3 cgal(input);
  const double cgal_time = seconds([&] { odt_of_mesh_3(cgal, domain, cgal_iterations); });
  print_quality(("CGAL, " + std::to_string(cgal_iterations) + " iterations").c_str(), cgal);

  const double iteration = timer.total / timer.iterations, cgal_iteration = cgal_time / cgal_iterations;
  std::printf("  an iteration: ours %.2f ms, CGAL's %.1f ms: %.0f times faster\n", 1e3 * iteration, 1e3 * cgal_iteration,
              cgal_iteration / iteration);
  std::printf("  the call: default %.3f s, 100 iterations %.3f s; 100 of CGAL's %.1f s%s: %.0f and %.0f times faster\n",
              default_time, hundred_time, 100 * cgal_iteration, cgal_iterations == 100 ? "" : " (extrapolated)",
              100 * cgal_iteration / default_time, 100 * cgal_iteration / hundred_time);
  std::fflush(stdout);
}

int main(int argc, char* argv[])
{
  if(argc > 1)
    cgal_iterations = (std::max)(1, std::atoi(argv[1]));
  for_each_input([](const char* name, const auto& input, const auto& domain) { compare(name, input, domain); });
  return EXIT_SUCCESS;
}
