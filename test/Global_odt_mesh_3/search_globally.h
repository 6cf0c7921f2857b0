// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_TEST_SEARCH_GLOBALLY_H
#define GLOBAL_ODT_MESH_3_TEST_SEARCH_GLOBALLY_H

#include <CGAL/Global_odt_mesh_3/internal/optimization/Annealing.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Global_search.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Cell_order.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

namespace CGAL::Global_odt_mesh_3::internal {

// The rounds of a global search and the iterations of the minimizer after them, as odt_optimize_mesh_3() makes them on
// meshes whose boundary stays. `f` is the objective of the mesh.
inline void search_globally(Moving_triangulation_3& mesh, Odt_objective_3& f, const Annealing_schedule& schedule,
                            unsigned int seed, int rounds)
{
  const Limited_memory_bfgs_parameters parameters;
  Global_search search(schedule, seed, parameters, mesh.threads());
  Cell_order order(mesh);
  const int iterations = usual_rounds(schedule).iterations;
  for(int round = 0; round < rounds; ++round)
    search.make_round(f, iterations, [&](int n) { return (round + double(n) / iterations) / rounds; },
                      [] { return true; }, [&] { order.maintain(mesh); });
  Limited_memory_bfgs minimizer(parameters, mesh.threads());
  for(int n = usual_rounds(schedule).final_iterations; n > 0; --n)
  {
    if(minimizer.iterate(f) == Limited_memory_bfgs::NO_STEP_FOUND)
      return;
    order.maintain(mesh);
  }
}

inline void search_globally(Moving_triangulation_3& mesh, Odt_objective_3& f, const Annealing_schedule& schedule,
                            unsigned int seed)
{
  search_globally(mesh, f, schedule, seed, usual_rounds(schedule).number);
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // GLOBAL_ODT_MESH_3_TEST_SEARCH_GLOBALLY_H
