// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ODT_PARAMETERS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ODT_PARAMETERS_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Parameter_check.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Make_density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Annealing.h>

#include <CGAL/Mesh_3/parameters_defaults.h>
#include <CGAL/Named_function_parameters.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <variant>

namespace CGAL::Global_odt_mesh_3::internal {

// What the caller wants: a mesh with better cells, surface vertices spaced by the restricted CVT, or only the removal of slivers.
enum class Odt_task { OPTIMIZE, REMESH_BOUNDARY, REMOVE_SLIVERS };

// The parameters of odt_optimize_mesh_3().
struct Odt_parameters
{
  static constexpr std::size_t usual_number_of_rounds = static_cast<std::size_t>(-1);
  static constexpr std::size_t most_vertices = std::size_t(1) << 25;           // whose cells can still be numbered

  double time_limit = 0;
  std::size_t max_iteration_number = 0;
  double convergence = parameters::default_values_for_mesh_3::odt_convergence_ratio;
  double freeze_bound = parameters::default_values_for_mesh_3::odt_freeze_ratio;
  bool do_freeze = true;
  bool optimize_boundary = true;
  Quadrature_maker make_quadrature = make_usual_quadrature;
  Annealing_schedule annealing_schedule;
  std::size_t number_of_rounds = usual_number_of_rounds;    // of the schedule
  double surface_weight = 1.2;
  double facet_distance = 0;                                // 0: as far as facets of the input
  double sliver_bound = 0;                                  // in degrees; 0: as large as possible
  bool do_remove_slivers = true;
  bool do_insert_vertices = false, do_remove_vertices = false;
  std::size_t number_of_vertices = 0;                       // wanted in the mesh; 0: any
  bool domain_is_thread_safe = false;
  unsigned int random_seed = 0;
  std::function<bool(double)> callback;

  // The angle that rounds of sliver removal aim for: the bound or, without one, 30 degrees.
  double wanted_angle() const { return sliver_bound > 0 ? sliver_bound : 30; }

  void check() const
  {
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(time_limit >= 0, "time_limit must be a number of seconds, not negative");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(convergence >= 0 && convergence <= 1, "convergence must be in [0, 1]");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(freeze_bound >= 0 && freeze_bound <= 1, "freeze_bound must be in [0, 1]");
    std::visit([](const auto& schedule) { schedule.check(); }, annealing_schedule);
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(surface_weight >= 0 && std::isfinite(surface_weight),
                                           "surface_weight must be finite, not negative");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(number_of_vertices == 0 || (do_insert_vertices && do_remove_vertices),
                                           "number_of_vertices needs do_insert_vertices and do_remove_vertices");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(number_of_vertices <= most_vertices, "number_of_vertices must be at most 2^25");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(facet_distance >= 0 && std::isfinite(facet_distance),
                                           "facet_distance must be finite, not negative");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(sliver_bound >= 0 && sliver_bound <= 70.5,
                                           "sliver_bound must be in [0, 70.5] degrees");
  }
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ODT_PARAMETERS_H
