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
inline constexpr Global_odt_parameter<internal_np::optimize_boundary_t> optimize_boundary{};
inline constexpr Global_odt_parameter<internal_np::quadrature_t> quadrature{};
inline constexpr Global_odt_parameter<internal_np::surface_weight_t> surface_weight{};
#if CGAL_VERSION_NR >= 1050600000
inline constexpr Global_odt_parameter<internal_np::sizing_field_t> sizing_field{};
#endif

} // namespace parameters

#endif // CGAL_NAMED_PARAMETERS_OF_GLOBAL_ODT_MESH_3

namespace Global_odt_mesh_3 {
namespace internal {

// The parameters that CGAL spells differently in its versions.
namespace tags {
#if CGAL_VERSION_NR < 1050600000
typedef parameters::tag::time_limit_ time_limit;
typedef parameters::tag::max_iteration_number_ max_iteration_number;
typedef parameters::tag::convergence_ convergence;
typedef parameters::tag::freeze_bound_ freeze_bound;
typedef parameters::tag::do_freeze_ do_freeze;
typedef parameters::tag::sliver_bound_ sliver_bound;
typedef parameters::tag::sizing_field_ sizing_field;
#else
typedef internal_np::maximum_running_time_t time_limit;
typedef internal_np::number_of_iterations_t max_iteration_number;
typedef internal_np::convergence_ratio_t convergence;
typedef internal_np::vertex_freeze_bound_t freeze_bound;
typedef internal_np::freeze_t do_freeze;
typedef internal_np::lower_sliver_bound_t sliver_bound;
typedef internal_np::sizing_field_t sizing_field;
#endif
} // namespace tags

template <class... Tags>
struct Parameter_list {};

// An argument of another kind is no parameter. `number` is how many parameters it is that have an effect.
template <class Argument, class = void>
struct Argument_traits
{
  static constexpr bool is_parameter = false;
};

template <class T, class Own_tag, class Base>
struct Argument_traits<Named_function_parameters<T, Own_tag, Base> >
{
  typedef Named_function_parameters<T, Own_tag, Base> Chain;
  static constexpr bool is_parameter = true;
  static constexpr bool has_next = !std::is_same<Base, internal_np::No_property>::value;
  static constexpr int is_default = std::is_same<Own_tag, internal_np::all_default_t>::value ? 1 : 0;

  static constexpr int number()
  {
    if constexpr (has_next)
      return 1 - is_default + Argument_traits<Base>::number();
    else
      return 1 - is_default;
  }

  // How often it is among them.
  template <class Tag>
  static constexpr int count()
  {
    constexpr int here = std::is_same<Own_tag, Tag>::value ? 1 : 0;
    if constexpr (has_next)
      return here + Argument_traits<Base>::template count<Tag>();
    else
      return here;
  }

  // As it was given: a copy, or the wrapper of a reference.
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

// The tags of Boost.Parameter, unlike others.
template <class Tag, class = void>
struct Is_keyword_tag : std::false_type {};

template <class Tag>
struct Is_keyword_tag<Tag, std::void_t<typename Tag::qualifier> > : std::true_type {};

// What Boost.Parameter makes of `name = value`.
template <class Argument>
struct Argument_traits<Argument, std::enable_if_t<boost::parameter::aux::is_tagged_argument<Argument>::value> >
{
  struct None {};
  static constexpr bool is_parameter = true;

  static constexpr int number() { return 1; }

  template <class Tag>
  static constexpr int count()
  {
    if constexpr (Is_keyword_tag<Tag>::value)
    {
      typedef boost::parameter::keyword<Tag> Keyword;
      typedef decltype(std::declval<const Argument&>()[std::declval<const Keyword&>() | std::declval<const None&>()]) Found;
      return std::is_same<std::decay_t<Found>, None>::value ? 0 : 1;
    }
    else
      return 0;
  }

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

// The arguments of a function that reads the parameters of that list.
template <class List, class... Arguments>
class Named_arguments;

template <class... Tags, class... Arguments>
class Named_arguments<Parameter_list<Tags...>, Arguments...>
{
  template <class Argument>
  struct Check
  {
    static constexpr bool is_read()
    {
      if constexpr (Argument_traits<Argument>::is_parameter)
        return ((Argument_traits<Argument>::template count<Tags>() > 0 ? 1 : 0) + ... + 0)
               == Argument_traits<Argument>::number();
      else
        return true;
    }
    static_assert(Argument_traits<Argument>::is_parameter,
                  "an argument is no named parameter: write parameters::name = value");
    static_assert(is_read(), "a named parameter is none of those that this function reads, or is given twice");
    static constexpr bool value = Argument_traits<Argument>::is_parameter && is_read();
  };
  static constexpr bool are_read = (Check<std::decay_t<Arguments> >::value && ...);

  template <class Tag>
  static constexpr int count()
  {
    if constexpr (are_read)
      return (Argument_traits<std::decay_t<Arguments> >::template count<Tag>() + ... + 0);
    else
      return 0;
  }
  static_assert(((count<Tags>() <= 1) && ...), "a named parameter is given twice");

public:
  explicit Named_arguments(Arguments... arguments) : arguments_(arguments...) {}

  template <class Tag>
  static constexpr bool has = count<Tag>() > 0;

  // As it was given.
  template <class Tag, std::size_t n = 0>
  const auto& get() const
  {
    typedef Argument_traits<std::decay_t<std::tuple_element_t<n, std::tuple<Arguments...> > > > Traits;
    if constexpr (Traits::template count<Tag>() > 0)
      return Traits::template get<Tag>(std::get<n>(arguments_));
    else
      return get<Tag, n + 1>();
  }

  template <class Tag, class Value>
  void read(Value& value) const
  {
    if constexpr (has<Tag>)
      value = static_cast<Value>(get<Tag>());
  }

private:
  std::tuple<Arguments...> arguments_;
};

template <class List, std::size_t... positions, class... Arguments>
auto named_arguments(std::index_sequence<positions...>, const Arguments&... arguments)
{
  return Named_arguments<List, decltype(with_name<positions>(arguments))...>(with_name<positions>(arguments)...);
}

template <class List, class... Arguments>
auto named_arguments(const Arguments&... arguments)
{
  return named_arguments<List>(std::index_sequence_for<Arguments...>(), arguments...);
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_NAMED_PARAMETERS_H
