// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_DENSITY_QUADRATURES_3_H
#define CGAL_DENSITY_QUADRATURES_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Requirements.h>

#include <CGAL/Global_odt_mesh_3/internal/Parameter_check.h>

#include <cmath>

namespace CGAL {

/*!
\ingroup PkgGlobalOdtMesh3Fields

The class `Linear_density_rule_3` is the default type of the named parameter `quadrature`: the density is interpolated
linearly between the vertices of a cell (Theorems 4.1 and 4.2 of \cgalCite{cgal:cwlls-rodt-14}). It is evaluated once
for each vertex. The error of the gradient falls with the square of the cell size.

\sa `Four_point_rule_3`
\sa `Fifteen_point_rule_3`
\sa `Adaptive_cubature_3`
*/
struct Linear_density_rule_3
{};

/*!
\ingroup PkgGlobalOdtMesh3Fields

The class `Four_point_rule_3` is a type of the named parameter `quadrature`: integrals over a cell are weighted sums of
the integrand at four points, exact up to degree 2 (rule T3:2-1 of \cgalCite{cgal:s-acmi-71}). The density is evaluated
about 20 times for each vertex.

\sa `Linear_density_rule_3`
\sa `Fifteen_point_rule_3`
\sa `Adaptive_cubature_3`
*/
struct Four_point_rule_3
{};

/*!
\ingroup PkgGlobalOdtMesh3Fields

The class `Fifteen_point_rule_3` is a type of the named parameter `quadrature`: integrals over a cell are weighted sums
of the integrand at fifteen points, exact up to degree 5 (rule T3:5-1 of \cgalCite{cgal:s-acmi-71}). Energy and
gradient are exact for densities of degree 3 or less. The density is evaluated about 80 times for each vertex.

\sa `Linear_density_rule_3`
\sa `Four_point_rule_3`
\sa `Adaptive_cubature_3`
*/
struct Fifteen_point_rule_3
{};

/*!
\ingroup PkgGlobalOdtMesh3Fields

The class `Adaptive_cubature_3` is a type of the named parameter `quadrature`: integrals over a cell are computed to a
tolerance, by rules of degree 7, 5, and 3 and adaptive bisection of the cell, as proposed by Genz and Cools
\cgalCite{cgal:gc-aanc-03}. It is the reference for the other rules. The density is evaluated at least 190 times for
each vertex.

\sa `Linear_density_rule_3`
\sa `Four_point_rule_3`
\sa `Fifteen_point_rule_3`
*/
struct Adaptive_cubature_3
{
  /// the error of the integrals over a cell, relative to the integral of the density over it; positive and finite. More is
  /// allowed in cells with less energy than the mean where only the energy of the whole mesh is wanted
  double tolerance = 1e-6;
  /// the largest number of parts into which a cell is divided; positive
  int most_regions = 500;

  /// checks the values of all members. A value out of range violates a precondition that names it.
  void check() const
  {
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(tolerance > 0 && std::isfinite(tolerance),
                                           "quadrature: tolerance must be positive and finite");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(most_regions > 0, "quadrature: most_regions must be positive");
  }
};

} // namespace CGAL

#endif // CGAL_DENSITY_QUADRATURES_3_H
