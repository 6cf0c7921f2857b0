// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_DENSITY_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_DENSITY_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Quadratic_polynomial_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <cmath>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The density of E^rho and that of the restricted CVT of surfaces.
//
// The minimizer of E^rho equidistributes the integral of rho^(3/5), that is, rho = 1/size^5
// (section 5.2 of the paper). On surfaces, in two dimensions, that is 1/size^4.
class Density_3
{
public:
  static double volume_density(double size) { return 1 / (size * size * size * size * size); }
  static double size_of_density(double volume_density) { return std::pow(volume_density, -1 / 5.); }
  static double surface_density(double size) { return 1 / (size * size * size * size); }

  virtual ~Density_3() {}

  // Whether it is one everywhere.
  virtual bool is_uniform() const = 0;

  // Whether several threads may ask at the same time, for different vertices.
  virtual bool is_safe_for_threads() const { return false; }

  // At the position of a vertex, given its number. The scale is such that the median of the
  // vertices has a density of about one.
  virtual double in_volume(int v, const Site& s) = 0;
  virtual double on_surface(int v, const Site& s) = 0;

  // At a point of a cell around the vertex.
  virtual double in_cell(int v, const Site& s) { return in_volume(v, s); }

  // The density in the volume if it is a polynomial, which can be integrated exactly, or null.
  virtual const Quadratic_polynomial_3* polynomial() const { return nullptr; }
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_DENSITY_3_H
