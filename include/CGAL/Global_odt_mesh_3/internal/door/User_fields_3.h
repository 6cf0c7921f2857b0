// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_USER_FIELDS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_USER_FIELDS_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Parameter_check.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Named_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Quadratic_polynomial_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/User_field_3.h>
#include <CGAL/Quadratic_density_3.h>

#include <CGAL/number_utils.h>

#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL::Global_odt_mesh_3::internal {

// What gives a number when it is called with these arguments.
template <class Void, class Field, class... Arguments>
struct Is_field : std::false_type {};

template <class Field, class... Arguments>
struct Is_field<std::void_t<decltype(CGAL::to_double(std::declval<const Field&>()(std::declval<Arguments>()...)))>, Field, Arguments...>
  : std::is_convertible<decltype(CGAL::to_double(std::declval<const Field&>()(std::declval<Arguments>()...))), double> {};

// What the caller of odt_optimize_mesh_3() says of the sizes or of the density, if anything.
template <class C3t3>
struct User_fields_3
{
  typedef typename C3t3::Triangulation::Bare_point Bare_point;
  typedef typename C3t3::Index Index;

  std::function<double(const Bare_point&, int, const Index&)> sizing_field;
  std::function<double(const Bare_point&)> density;
  std::optional<Quadratic_polynomial_3> quadratic_density;    // if `density` is one

  // Whether there is any.
  explicit operator bool() const { return sizing_field || density; }

  // The same for a mesh of which `vertex(v)` is the one with that number, and `index(s)` that of other vertices.
  template <class Vertex, class Index_of_stratum>
  User_field_3 of_mesh(const Vertex& vertex, const Index_of_stratum& index) const
  {
    const auto point = [](const Site& s) { return Bare_point(s.x, s.y, s.z); };
    User_field_3 field;
    if(sizing_field)
      field.value = [size = sizing_field, point, vertex, index](const Vertex_stratum& v, const Site& s)
                    { return size(point(s), v.dimension, v.number < 0 ? index(v) : vertex(v.number)->index()); };
    if(density)
      field = { User_field_3::DENSITY, [density = density, point](const Vertex_stratum&, const Site& s) { return density(point(s)); },
                quadratic_density };
    return field;
  }

  void check() const
  {
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(!sizing_field || !density, "sizing_field and density exclude each other");
  }

  template <class Arguments>
  void read(const Arguments& arguments)
  {
    if constexpr (Arguments::template has<tags::sizing_field>)
      set_sizing_field(arguments.template get<tags::sizing_field>());
    if constexpr (Arguments::template has<internal_np::density_t>)
      set_density(arguments.template get<internal_np::density_t>());
  }

private:
  template <class Field>
  void set_density(const Field& field)
  {
    constexpr bool is_field = Is_field<void, Field, const Bare_point&>::value;
    static_assert(is_field, "density must be called as f(p) and return a number");
    if constexpr (is_field)
    {
      density = [field](const Bare_point& p) { return CGAL::to_double(field(p)); };
      quadratic_density = polynomial(field);
    }
  }

  template <class Field>
  static std::nullopt_t polynomial(const Field&) { return std::nullopt; }

  template <class Field>
  static decltype(auto) polynomial(const std::reference_wrapper<Field>& field) { return polynomial(field.get()); }

  template <class Kernel>
  static const Quadratic_polynomial_3& polynomial(const Quadratic_density_3<Kernel>& field) { return field.polynomial(); }

  template <class Field>
  void set_sizing_field(const Field& field)
  {
    if constexpr (std::is_arithmetic<Field>::value)
      sizing_field = [field](const Bare_point&, int, const Index&) { return static_cast<double>(field); };
    else
    {
      constexpr bool is_field = Is_field<void, Field, const Bare_point&, int&, const Index&>::value;
      static_assert(is_field, "sizing_field must be a number, or be called as f(p, dimension, index) and return one");
      if constexpr (is_field)
        sizing_field = [field](const Bare_point& p, int dimension, const Index& index)
                       { return CGAL::to_double(field(p, dimension, index)); };
    }
  }
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_USER_FIELDS_3_H
