// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_QUADRATIC_POLYNOMIAL_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_QUADRATIC_POLYNOMIAL_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <array>

namespace CGAL::Global_odt_mesh_3::internal {

// A polynomial of degree two about a center, so that the distance to the origin does not matter.
struct Quadratic_polynomial_3
{
  Vector_3 center;
  double constant;
  Vector_3 linear;       // of x, y, z
  std::array<double, 6> quadratic;    // of xx, yy, zz, yz, zx, xy

  double operator()(const Site& s) const { return polar(s, s); }

  Quadratic_polynomial_3& operator*=(double factor)
  {
    constant *= factor;
    linear *= factor;
    for(double& x : quadratic)
      x *= factor;
    return *this;
  }

  // Its polar form: symmetric, affine in either argument, and its value where both are the same.
  double polar(const Site& p, const Site& q) const
  {
    const double px = p.x - center[0], py = p.y - center[1], pz = p.z - center[2];
    const double qx = q.x - center[0], qy = q.y - center[1], qz = q.z - center[2];
    return constant + (linear[0] * (px + qx) + linear[1] * (py + qy) + linear[2] * (pz + qz)
                       + quadratic[3] * (py * qz + pz * qy) + quadratic[4] * (pz * qx + px * qz)
                       + quadratic[5] * (px * qy + py * qx)) / 2
           + quadratic[0] * px * qx + quadratic[1] * py * qy + quadratic[2] * pz * qz;
  }
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_QUADRATIC_POLYNOMIAL_3_H
