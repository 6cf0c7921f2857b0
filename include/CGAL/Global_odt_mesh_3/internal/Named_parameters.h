// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_NAMED_PARAMETERS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_NAMED_PARAMETERS_H

#include <CGAL/Global_odt_mesh_3/internal/Odt_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR < 1050600000
// The latter has the keyword sizing_field.
#  include <CGAL/boost/parameter.h>
#  include <CGAL/Mesh_criteria_3.h>
#  include <boost/parameter.hpp>
#endif

#include <cstddef>
#include <functional>
#include <type_traits>

namespace CGAL {

namespace internal_np {

enum annealing_schedule_t { annealing_schedule };
enum density_t { density };
enum number_of_rounds_t { number_of_rounds };
enum optimize_boundary_t { optimize_boundary };
enum quadrature_t { quadrature };
#if CGAL_VERSION_NR >= 1050600000
enum sizing_field_t { sizing_field };
#endif

} // namespace internal_np

namespace parameters {

// A named parameter of this package's own, spelled `name = value` or `name(value)`
// whatever the version of CGAL.
template <class Tag>
struct Global_odt_parameter
{
  template <class K>
  Named_function_parameters<K, Tag> operator()(const K& k) const
  {
    return Named_function_parameters<K, Tag>(k);
  }

  template <class K>
  Named_function_parameters<K, Tag> operator=(const K& k) const
  {
    return (*this)(k);
  }
};

inline constexpr Global_odt_parameter<internal_np::annealing_schedule_t> annealing_schedule{};
inline constexpr Global_odt_parameter<internal_np::density_t> density{};
inline constexpr Global_odt_parameter<internal_np::number_of_rounds_t> number_of_rounds{};
inline constexpr Global_odt_parameter<internal_np::optimize_boundary_t> optimize_boundary{};
inline constexpr Global_odt_parameter<internal_np::quadrature_t> quadrature{};
#if CGAL_VERSION_NR >= 1050600000
inline constexpr Global_odt_parameter<internal_np::sizing_field_t> sizing_field{};
#endif

} // namespace parameters

namespace Global_odt_mesh_3 {
namespace internal {

template <class T>
struct Is_named_function_parameters : std::false_type {};

template <class T, class Tag, class Base>
struct Is_named_function_parameters<Named_function_parameters<T, Tag, Base> > : std::true_type {};

template <class Named_parameters, class Tag>
constexpr bool has_parameter
  = !std::is_same<typename internal_np::Get_param<typename Named_parameters::base, Tag>::type,
                  internal_np::Param_not_found>::value;

// Reads one parameter if the chain `np` has it.
template <class Tag, class Named_parameters, class Value>
void read_parameter(const Named_parameters& np, Tag tag, Value& value)
{
  if constexpr (has_parameter<Named_parameters, Tag>)
    value = static_cast<Value>(parameters::get_parameter(np, tag));
}

// Reads what one argument, in either of CGAL's styles, says.
template <class Argument>
void read_argument(const Argument& argument, Odt_parameters& p)
{
  if constexpr (Is_named_function_parameters<Argument>::value)
  {
    read_parameter(argument, internal_np::annealing_schedule, p.annealing_schedule);
    read_parameter(argument, internal_np::number_of_rounds, p.number_of_rounds);
    read_parameter(argument, internal_np::optimize_boundary, p.optimize_boundary);
    read_parameter(argument, internal_np::quadrature, p.quadrature);
    read_parameter(argument, internal_np::random_seed, p.random_seed);
    read_parameter(argument, internal_np::callback, p.callback);
#if CGAL_VERSION_NR >= 1050600000
    read_parameter(argument, internal_np::maximum_running_time, p.time_limit);
    read_parameter(argument, internal_np::number_of_iterations, p.max_iteration_number);
    read_parameter(argument, internal_np::convergence_ratio, p.convergence);
    read_parameter(argument, internal_np::vertex_freeze_bound, p.freeze_bound);
    read_parameter(argument, internal_np::freeze, p.do_freeze);
    read_parameter(argument, internal_np::lower_sliver_bound, p.sliver_bound);
#endif
  }
#if CGAL_VERSION_NR < 1050600000
  else
  {
    p.time_limit = argument[parameters::time_limit | p.time_limit];
    p.max_iteration_number = argument[parameters::max_iteration_number | p.max_iteration_number];
    p.convergence = argument[parameters::convergence | p.convergence];
    p.freeze_bound = argument[parameters::freeze_bound | p.freeze_bound];
    p.do_freeze = argument[parameters::do_freeze | p.do_freeze];
    p.sliver_bound = argument[parameters::sliver_bound | p.sliver_bound];
  }
#endif
}

#if CGAL_VERSION_NR < 1050600000
// Boost.Parameter also allows values without name, in this order.
template <class Value>
void read_positional(std::size_t position, const Value& value, Odt_parameters& p)
{
  if constexpr (std::is_arithmetic<Value>::value)
    switch(position)
    {
    case 0: p.time_limit = static_cast<double>(value); break;
    case 1: p.max_iteration_number = static_cast<std::size_t>(value); break;
    case 2: p.convergence = static_cast<double>(value); break;
    case 3: p.freeze_bound = static_cast<double>(value); break;
    default: p.do_freeze = value != Value(0);
    }
}
#endif

inline void read_arguments(Odt_parameters&, std::size_t) {}

template <class First, class... Rest>
void read_arguments(Odt_parameters& p, std::size_t position, const First& first, const Rest&... rest)
{
#if CGAL_VERSION_NR < 1050600000
  if constexpr (std::is_arithmetic<First>::value)
    read_positional(position, first, p);
  else
#endif
    read_argument(first, p);
  read_arguments(p, position + 1, rest...);
}

// The visitor among the arguments, a copy or what a reference wrapper refers to,
// or else `default_visitor`.
template <class Default>
Default find_visitor(const Default& default_visitor) { return default_visitor; }

template <class Default, class First, class... Rest>
auto find_visitor(const Default& default_visitor, const First& first, const Rest&... rest)
{
  if constexpr (Is_named_function_parameters<First>::value)
  {
    if constexpr (has_parameter<First, internal_np::visitor_t>)
      return parameters::get_parameter(first, internal_np::visitor);
    else
      return find_visitor(default_visitor, rest...);
  }
  else
    return find_visitor(default_visitor, rest...);
}

template <class T>
T& unwrap(T& t) { return t; }

template <class T>
T& unwrap(std::reference_wrapper<T>& t) { return t.get(); }

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_NAMED_PARAMETERS_H
