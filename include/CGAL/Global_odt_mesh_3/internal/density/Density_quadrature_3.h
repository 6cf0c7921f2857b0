// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_DENSITY_QUADRATURE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_DENSITY_QUADRATURE_3_H

#include <CGAL/Global_odt_mesh_3/internal/density/Density_moments_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <functional>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// A way to integrate the density over cells more accurately than by its values at the vertices.
class Density_quadrature_3
{
public:
  // The density at a point of a cell around a vertex, given the number of that vertex.
  typedef std::function<double(int, const Site&)> Density;

  virtual ~Density_quadrature_3() {}

  // The moments on a cell, given the numbers of its vertices, into `sites`. The number of the
  // cell is for what is kept of it.
  virtual Density_moments_3 moments(int cell, const int* vertices, const Site* sites) = 0;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_DENSITY_QUADRATURE_3_H
