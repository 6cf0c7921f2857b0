// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_MINIMIZER_PARAMETERS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_MINIMIZER_PARAMETERS_H

#include <CGAL/Global_odt_mesh_3/internal/density/Density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// How the energy with that quadrature of the density, or without any, is minimized.
inline Limited_memory_bfgs_parameters minimizer_parameters(const Density_quadrature_3* quadrature)
{
  Limited_memory_bfgs_parameters p;
  if(quadrature != nullptr)
  {
    p.memory = 15;      // graded meshes take more iterations
    p.energy_tolerance = quadrature->energy_tolerance();
  }
  return p;
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_MINIMIZER_PARAMETERS_H
