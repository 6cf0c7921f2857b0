// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_READ_PARAMETERS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_READ_PARAMETERS_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Odt_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/Parameter_check.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Named_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <type_traits>

namespace CGAL::Global_odt_mesh_3::internal {

// Negative numbers would become large ones.
template <class Tag, class Arguments>
void read_count(const Arguments& arguments, std::size_t& count, const char* message)
{
  if constexpr (Arguments::template has<Tag>)
  {
    double number = 0;
    arguments.template read<Tag>(number);
    // What is the largest number becomes the one after it.
    typedef decltype(arguments.template get<Tag>()) Given;
    constexpr bool is_integral = std::is_integral<std::decay_t<Given> >::value;
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(
      number >= 0 && (is_integral || number < double((std::numeric_limits<std::size_t>::max)())), message);
    if constexpr (may_be<Given, double>)
      arguments.template read<Tag>(count);
  }
}

template <class Arguments>
Odt_parameters read_parameters(const Arguments& arguments)
{
  Odt_parameters p;
  arguments.template read<tags::time_limit>(p.time_limit);
  read_count<tags::max_iteration_number>(arguments, p.max_iteration_number, "max_iteration_number must be a number, not negative");
  arguments.template read<tags::convergence>(p.convergence);
  arguments.template read<tags::freeze_bound>(p.freeze_bound);
  arguments.template read<tags::do_freeze>(p.do_freeze);
  arguments.template read<internal_np::optimize_boundary_t>(p.optimize_boundary);
  if constexpr (Arguments::template has<internal_np::quadrature_t>)
    p.make_quadrature = quadrature_maker(arguments.template get<internal_np::quadrature_t>());
  arguments.template read<internal_np::annealing_schedule_t>(p.annealing_schedule);
  read_count<internal_np::number_of_rounds_t>(arguments, p.number_of_rounds, "number_of_rounds must be a number, not negative");
  arguments.template read<internal_np::surface_weight_t>(p.surface_weight);
  arguments.template read<tags::facet_distance>(p.facet_distance);
  arguments.template read<tags::sliver_bound>(p.sliver_bound);
  arguments.template read<internal_np::do_remove_slivers_t>(p.do_remove_slivers);
  arguments.template read<internal_np::do_insert_vertices_t>(p.do_insert_vertices);
  arguments.template read<internal_np::do_remove_vertices_t>(p.do_remove_vertices);
  if constexpr (Arguments::template has<internal_np::number_of_vertices_t>)
  {
    read_count<internal_np::number_of_vertices_t>(arguments, p.number_of_vertices, "number_of_vertices must be a number, not negative");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(p.number_of_vertices > 0, "number_of_vertices must be positive");
  }
  arguments.template read<internal_np::domain_is_thread_safe_t>(p.domain_is_thread_safe);
  arguments.template read<internal_np::random_seed_t>(p.random_seed);
  if constexpr (Arguments::template has<internal_np::callback_t>)
  {
    constexpr bool is_callback = may_be<decltype(arguments.template get<internal_np::callback_t>()), std::function<bool(double)> >;
    static_assert(is_callback, "callback must be called as f(x), x being the fraction done, and return bool");
    if constexpr (is_callback)
      arguments.template read<internal_np::callback_t>(p.callback);
  }
  return p;
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_READ_PARAMETERS_H
