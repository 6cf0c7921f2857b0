// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Figures 6 and 7 of the paper: L-BFGS and the AVV iteration from the same random
// interior of a cube, on the same engine, in process CPU time.
//
//   minimize_in_cube [number of seeds, default 5]
//
// The cube has 18,083 vertices, of which 3,752 are a grid on its surface that
// stays.

#include "averaging_iteration.h"
#include "random_points.h"

#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>

#include <CGAL/Timer.h>

#include <cstdio>
#include <cstdlib>

using namespace CGAL::Global_odt_mesh_3::internal;

static void compact_now_and_then(Moving_triangulation_3& mesh, int iteration)
{
  if(iteration % 50 == 0)
    mesh.compact();
}

int main(int argc, char* argv[])
{
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 5;
  std::printf("seed  L-BFGS: its  CPU s  |g|       E           AVV: its  CPU s  |g|       E           E %%     time\n");
  for(int seed = 1; seed <= seeds; ++seed)
  {
    Moving_triangulation_3 mesh = random_cube(seed), copy = mesh;

    CGAL::Timer timer;
    timer.start();
    Odt_objective_3 objective(mesh);
    Limited_memory_bfgs minimizer;
    int n = 0;
    while(n < 400 && objective.gradient().norm() > 1e-9
          && minimizer.iterate(objective) == Limited_memory_bfgs::STEP_TAKEN)
      compact_now_and_then(mesh, ++n);
    const double time = timer.time();

    timer.reset();
    Odt_objective_3 avv(copy);
    Averaging_iteration averaging;
    int m = 0;
    while(m < 499 && averaging.iterate(avv))
      compact_now_and_then(copy, ++m);
    const double avv_time = timer.time();
    std::printf("%4d  %11d %6.2f  %.2e  %.5e %9d %6.2f  %.2e  %.5e %+.3f  %.2f\n", seed, n, time,
                objective.gradient().norm(), objective.value(), m, avv_time, avv.gradient().norm(), avv.value(),
                100 * (objective.value() / avv.value() - 1), avv_time / time);
    std::fflush(stdout);
  }
  return EXIT_SUCCESS;
}
