// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_NAMED_PARAMETERS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_NAMED_PARAMETERS_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR < 1050600000
// The latter has the keyword sizing_field.
#  include <CGAL/boost/parameter.h>
#  include <CGAL/Mesh_criteria_3.h>
#  include <boost/parameter.hpp>
#endif

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace CGAL {

// In a branch of CGAL whose parameters_interface.h has the named parameters of this package, that file defines the macro.
#ifndef CGAL_NAMED_PARAMETERS_OF_GLOBAL_ODT_MESH_3

namespace internal_np {

// The tags of the named parameters of this package's own.
template <class Name>
struct Global_odt_tag {};

typedef Global_odt_tag<struct Annealing_schedule_name> annealing_schedule_t;
typedef Global_odt_tag<struct Density_name> density_t;
typedef Global_odt_tag<struct Do_insert_vertices_name> do_insert_vertices_t;
typedef Global_odt_tag<struct Do_remove_slivers_name> do_remove_slivers_t;
typedef Global_odt_tag<struct Do_remove_vertices_name> do_remove_vertices_t;
typedef Global_odt_tag<struct Domain_is_thread_safe_name> domain_is_thread_safe_t;
typedef Global_odt_tag<struct Number_of_rounds_name> number_of_rounds_t;
typedef Global_odt_tag<struct Number_of_vertices_name> number_of_vertices_t;
typedef Global_odt_tag<struct Optimization_report_name> optimization_report_t;
typedef Global_odt_tag<struct Optimize_boundary_name> optimize_boundary_t;
typedef Global_odt_tag<struct Quadrature_name> quadrature_t;
typedef Global_odt_tag<struct Surface_weight_name> surface_weight_t;
#if CGAL_VERSION_NR >= 1050600000
typedef Global_odt_tag<struct Sizing_field_name> sizing_field_t;
#endif

// Functions of CGAL, such as parameters::odt(), look up what they know in a sequence of named parameters and
// ignore the rest. They come here if one of this package is among them.
template <class Tag>
struct Refuse_global_odt_parameter
{
  static_assert(std::is_void<Tag>::value,
                "this named parameter is read by odt_optimize_mesh_3(), remesh_boundary_mesh_3(), "
                "remove_slivers_mesh_3() or odt_energy_3() alone; "
                "instead of odt() with it, give no_odt() to make_mesh_3() and call odt_optimize_mesh_3() afterwards");
  typedef Param_not_found type;
  typedef Param_not_found reference;
};

template <class T, class Name, class Query_tag>
struct Get_param<Named_params_impl<T, Global_odt_tag<Name>, No_property>, Query_tag>
  : Refuse_global_odt_parameter<Global_odt_tag<Name> >
{};

template <class T, class Name, class Base, class Query_tag>
struct Get_param<Named_params_impl<T, Global_odt_tag<Name>, Base>, Query_tag>
  : Refuse_global_odt_parameter<Global_odt_tag<Name> >
{};

} // namespace internal_np

namespace parameters {

#if CGAL_VERSION_NR < 1050600000
// The functions of CGAL 5.5 would take it for a number without name.
template <class K, class Tag>
struct Global_odt_named_value : Named_function_parameters<K, Tag>
{
  using Named_function_parameters<K, Tag>::Named_function_parameters;

  template <class Number, class = std::enable_if_t<std::is_arithmetic<Number>::value> >
  operator Number() const
  {
    typename internal_np::Refuse_global_odt_parameter<std::pair<Tag, Number> >::type();
    return Number();
  }
};

template <class T>
struct Is_global_odt_named_value : std::false_type {};

template <class K, class Tag>
struct Is_global_odt_named_value<Global_odt_named_value<K, Tag> > : std::true_type {};

// After a value with a name of CGAL's, there is no function odt() that would take it.
template <class... Arguments, class = std::enable_if_t<(Is_global_odt_named_value<Arguments>::value || ...)> >
void odt(const Arguments&...)
{
  typename internal_np::Refuse_global_odt_parameter<std::tuple<Arguments...> >::type();
}
#else
template <class K, class Tag>
using Global_odt_named_value = Named_function_parameters<K, Tag>;
#endif

// A named parameter of this package's own, spelled `name = value` or `name(value)`
// whatever the version of CGAL.
template <class Tag>
struct Global_odt_parameter
{
  template <class K>
  Global_odt_named_value<K, Tag> operator()(const K& k) const
  {
    return Global_odt_named_value<K, Tag>(k);
  }

  template <class K>
  Global_odt_named_value<K, Tag> operator=(const K& k) const
  {
    return (*this)(k);
  }
};

inline constexpr Global_odt_parameter<internal_np::annealing_schedule_t> annealing_schedule{};
inline constexpr Global_odt_parameter<internal_np::density_t> density{};
inline constexpr Global_odt_parameter<internal_np::do_insert_vertices_t> do_insert_vertices{};
inline constexpr Global_odt_parameter<internal_np::do_remove_slivers_t> do_remove_slivers{};
inline constexpr Global_odt_parameter<internal_np::do_remove_vertices_t> do_remove_vertices{};
inline constexpr Global_odt_parameter<internal_np::domain_is_thread_safe_t> domain_is_thread_safe{};
inline constexpr Global_odt_parameter<internal_np::number_of_rounds_t> number_of_rounds{};
inline constexpr Global_odt_parameter<internal_np::number_of_vertices_t> number_of_vertices{};
inline constexpr Global_odt_parameter<internal_np::optimization_report_t> optimization_report{};
inline constexpr Global_odt_parameter<internal_np::optimize_boundary_t> optimize_boundary{};
inline constexpr Global_odt_parameter<internal_np::quadrature_t> quadrature{};
inline constexpr Global_odt_parameter<internal_np::surface_weight_t> surface_weight{};
#if CGAL_VERSION_NR >= 1050600000
inline constexpr Global_odt_parameter<internal_np::sizing_field_t> sizing_field{};
#endif

} // namespace parameters

#endif // CGAL_NAMED_PARAMETERS_OF_GLOBAL_ODT_MESH_3

namespace Global_odt_mesh_3::internal {

// The parameters that CGAL spells differently in its versions.
namespace tags {
#if CGAL_VERSION_NR < 1050600000
typedef parameters::tag::time_limit_ time_limit;
typedef parameters::tag::max_iteration_number_ max_iteration_number;
typedef parameters::tag::convergence_ convergence;
typedef parameters::tag::freeze_bound_ freeze_bound;
typedef parameters::tag::do_freeze_ do_freeze;
typedef parameters::tag::sliver_bound_ sliver_bound;
typedef parameters::tag::facet_distance_ facet_distance;
typedef parameters::tag::sizing_field_ sizing_field;
#else
typedef internal_np::maximum_running_time_t time_limit;
typedef internal_np::number_of_iterations_t max_iteration_number;
typedef internal_np::convergence_ratio_t convergence;
typedef internal_np::vertex_freeze_bound_t freeze_bound;
typedef internal_np::freeze_t do_freeze;
typedef internal_np::lower_sliver_bound_t sliver_bound;
typedef internal_np::facet_distance_param_t facet_distance;
typedef internal_np::sizing_field_t sizing_field;
#endif
} // namespace tags

// When an assertion fails, compilers name the instance, which begins with the parameter. There is one for each call, so
// that none passes because another one has failed.
template <class Tag, bool is_read, int times, class Call>
struct Check_parameter
{
  static_assert(is_read, "the named parameter in Check_parameter<...> is none of those that this function reads (some are not read"
                         " for periodic meshes)");
  static_assert(!is_read || times == 1, "the named parameter in Check_parameter<...> is given twice");
  static constexpr bool value = is_read && times == 1;
};

template <class... Tags>
struct Parameter_list
{
  template <class Tag>
  static constexpr int count = (int(std::is_same<Tags, Tag>::value) + ... + 0);

  // Whether each is in the list, and occurs once.
  template <class List, class Call>
  using Check = std::bool_constant<(Check_parameter<Tags, List::template count<Tags> != 0, count<Tags>, Call>::value && ...)>;
};

template <class... Tags, class... Others>
Parameter_list<Tags..., Others...> operator+(Parameter_list<Tags...>, Parameter_list<Others...>);

// An argument of another kind is no parameter.
template <class Argument, class = void>
struct Argument_traits
{
  static constexpr bool is_parameter = false;
  typedef Parameter_list<> Tags;
};

template <class T, class Own_tag, class Base>
struct Argument_traits<Named_function_parameters<T, Own_tag, Base> >
{
  typedef Named_function_parameters<T, Own_tag, Base> Chain;
  static constexpr bool is_parameter = true;

  // The parameters that have an effect.
  typedef std::conditional_t<std::is_same<Own_tag, internal_np::all_default_t>::value, Parameter_list<>, Parameter_list<Own_tag> > Own_tags;
  typedef decltype(Own_tags() + typename Argument_traits<Base>::Tags()) Tags;

  // The value as it was given: a copy, or the wrapper of a reference.
  template <class Tag>
  static const auto& get(const Chain& chain)
  {
    if constexpr (std::is_same<Own_tag, Tag>::value)
      return chain.v;
    else
      return Argument_traits<Base>::template get<Tag>(chain);
  }
};

#if CGAL_VERSION_NR < 1050600000
template <class K, class Tag>
struct Argument_traits<parameters::Global_odt_named_value<K, Tag> >
  : Argument_traits<Named_function_parameters<K, Tag> >
{};

// What Boost.Parameter makes of `name = value`.
template <class Argument>
struct Argument_traits<Argument, std::enable_if_t<boost::parameter::aux::is_tagged_argument<Argument>::value> >
{
  static constexpr bool is_parameter = true;
  typedef Parameter_list<typename Argument::key_type> Tags;

  template <class Tag>
  static const auto& get(const Argument& argument) { return argument[boost::parameter::keyword<Tag>::instance]; }
};
#endif

// Values without name, which Boost.Parameter allows in CGAL 5.5, are named by their position.
template <std::size_t position, class Argument>
decltype(auto) with_name(const Argument& argument)
{
#if CGAL_VERSION_NR < 1050600000
  typedef std::tuple<tags::time_limit, tags::max_iteration_number, tags::convergence, tags::freeze_bound, tags::do_freeze>
    Positions;
  if constexpr (std::is_arithmetic<Argument>::value && position < std::tuple_size<Positions>::value)
    return boost::parameter::keyword<std::tuple_element_t<position, Positions> >::instance = argument;
  else
#endif
    return (argument);
}

template <std::size_t... positions, class... Arguments>
auto with_names(std::index_sequence<positions...>, const Arguments&... arguments)
{
  return std::tuple<decltype(with_name<positions>(arguments))...>(with_name<positions>(arguments)...);
}

template <class Argument, bool is_parameter, class Call>
struct Check_argument
{
  static_assert(is_parameter, "the argument in Check_argument<...> is no named parameter: write parameters::name = value");
  static constexpr bool value = is_parameter;
};

template <class Arguments>
struct Argument_list;

template <class... Arguments>
struct Argument_list<std::tuple<Arguments...> >
{
  template <class Argument>
  using Traits = Argument_traits<std::decay_t<Argument> >;

  typedef decltype((Parameter_list<>() + ... + typename Traits<Arguments>::Tags())) Tags;

  template <class Call>
  using Check = std::bool_constant<(Check_argument<Arguments, Traits<Arguments>::is_parameter, Call>::value && ...)>;
};

// Whether a value can become one of that type. That the address of a string is not null tells nothing.
template <class Given, class Value>
constexpr bool may_be = std::is_constructible<Value, Given>::value
                        && !(std::is_arithmetic<Value>::value && std::is_convertible<Given, const void*>::value);

// The arguments of a function that reads the parameters of that list.
template <class List, class... Arguments>
class Named_arguments
{
  typedef decltype(with_names(std::index_sequence_for<Arguments...>(), std::declval<const Arguments&>()...)) Tuple;
  typedef typename Argument_list<Tuple>::Tags Tags;

  // A type, so that arguments are checked in any case.
  typedef std::bool_constant<Argument_list<Tuple>::template Check<Named_arguments>::value
                             && Tags::template Check<List, Named_arguments>::value> Are_valid;

public:
  static constexpr bool are_valid = Are_valid::value;

  explicit Named_arguments(const Arguments&... arguments)
    : arguments_(with_names(std::index_sequence_for<Arguments...>(), arguments...))
  {}

  template <class Tag>
  static constexpr bool has = are_valid && Tags::template count<Tag> != 0;

  // The argument as it was given.
  template <class Tag, std::size_t n = 0>
  const auto& get() const
  {
    typedef Argument_traits<std::decay_t<std::tuple_element_t<n, Tuple> > > Traits;
    if constexpr (Traits::Tags::template count<Tag> != 0)
      return Traits::template get<Tag>(std::get<n>(arguments_));
    else
      return get<Tag, n + 1>();
  }

  template <class Tag, class Value>
  void read(Value& value) const
  {
    if constexpr (has<Tag>)
    {
      typedef decltype(get<Tag>()) Given;
      static_assert(may_be<Given, Value>, "the named parameter of this Tag cannot have a value of this type");
      if constexpr (may_be<Given, Value>)
        value = static_cast<Value>(get<Tag>());
    }
  }

private:
  Tuple arguments_;
};

} // namespace Global_odt_mesh_3::internal
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_NAMED_PARAMETERS_H
