// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_QUADRATIC_DENSITY_3_H
#define CGAL_QUADRATIC_DENSITY_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Requirements.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Quadratic_polynomial_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <CGAL/Origin.h>
#include <CGAL/number_utils.h>

#include <array>
#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgGlobalOdtMesh3Fields

The class `Quadratic_density_3` is a polynomial of degree two or less. As `density` of `odt_optimize_mesh_3()` or `odt_energy_3()`,
it is integrated over cells exactly, up to rounding, unless the named parameter `quadrature` selects a rule. The energy then is that
of equation (2.5) of \cgalCite{cgal:cwlls-rodt-14}, and the gradient that of equation (3.1). Unlike other densities, it may be zero
at points.

With \f$ \mathbf d = \mathbf x - \mathbf c \f$, it is
\f$ \rho(\mathbf x) = a + \mathbf b \cdot \mathbf d + q_{xx} d_x^2 + q_{yy} d_y^2 + q_{zz} d_z^2
+ q_{yz} d_y d_z + q_{zx} d_z d_x + q_{xy} d_x d_y \f$.

\tparam Kernel a model of `Kernel`

\cgalModels{MeshDensity_3}

\sa `odt_energy_3()`
\sa `odt_optimize_mesh_3()`
*/
template <class Kernel>
class Quadratic_density_3
{
public:
  typedef typename Kernel::FT FT;               ///< number type
  typedef typename Kernel::Point_3 Point_3;     ///< point type
  typedef typename Kernel::Vector_3 Vector_3;   ///< vector type

  /// constructs the polynomial with \f$ a \f$ = `constant`, \f$ \mathbf b \f$ = `linear`, and the `quadratic`
  /// coefficients of xx, yy, zz, yz, zx and xy.
  Quadratic_density_3(const FT& constant, const Vector_3& linear, const std::array<FT, 6>& quadratic,
                      const Point_3& center = Point_3(CGAL::ORIGIN))
  {
    polynomial_.center = Global_odt_mesh_3::internal::coordinates(center);
    polynomial_.constant = to_double(constant);
    polynomial_.linear = Global_odt_mesh_3::internal::coordinates(linear);
    for(std::size_t n = 0; n < quadratic.size(); ++n)
      polynomial_.quadratic[n] = to_double(quadratic[n]);
  }

  /// returns the squared distance from `center`, the density of Figure 9 of \cgalCite{cgal:cwlls-rodt-14}.
  static Quadratic_density_3 squared_distance(const Point_3& center = Point_3(CGAL::ORIGIN))
  {
    return Quadratic_density_3(0, Vector_3(0, 0, 0), {{ 1, 1, 1, 0, 0, 0 }}, center);
  }

  /// returns the density at a point.
  FT operator()(const Point_3& p) const
  {
    return polynomial_(Global_odt_mesh_3::internal::site_at(Global_odt_mesh_3::internal::coordinates(p), 0));
  }

#ifndef DOXYGEN_RUNNING
  const Global_odt_mesh_3::internal::Quadratic_polynomial_3& polynomial() const { return polynomial_; }
#endif

private:
  Global_odt_mesh_3::internal::Quadratic_polynomial_3 polynomial_;
};

} // namespace CGAL

#endif // CGAL_QUADRATIC_DENSITY_3_H
