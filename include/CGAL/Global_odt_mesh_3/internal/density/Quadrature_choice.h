// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_QUADRATURE_CHOICE_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_QUADRATURE_CHOICE_H

#include <CGAL/Density_quadratures_3.h>

#include <variant>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Without a word of the caller, the linear rule, or exact integrals where the density allows them.
typedef std::variant<std::monostate, Linear_density_rule_3, Four_point_rule_3, Fifteen_point_rule_3, Adaptive_cubature_3>
  Quadrature_choice;

inline void check(const Quadrature_choice& choice)
{
  if(const auto* cubature = std::get_if<Adaptive_cubature_3>(&choice))
    cubature->check();
}


} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_QUADRATURE_CHOICE_H
