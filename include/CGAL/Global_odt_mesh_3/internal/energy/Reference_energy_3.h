// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ENERGY_REFERENCE_ENERGY_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ENERGY_REFERENCE_ENERGY_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Density_quadratures_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Adaptive_cubature_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Field_density_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Point_rule_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/energy/Odt_cell_energies_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

typedef std::array<int, 4> Cell_vertices;

inline double cell_energy(const std::vector<Site>& sites, const Cell_vertices& v, const Density_moments_3& moments)
{
  const Site* const s = sites.data();
  const Site &s0 = s[v[0]], &s1 = s[v[1]], &s2 = s[v[2]], &s3 = s[v[3]];
  return odt_energy(Cell_products(s0, s1, s2, s3), s0, s1, s2, s3, moments).energy;
}

// The energy of all cells to a tolerance, relative to the whole, so that cells of hardly any energy
// need no accuracy of their own.
inline double reference_energy(const std::vector<Site>& sites, const std::vector<Cell_vertices>& cells, Density_3& density,
                               const Adaptive_cubature_3& cubature)
{
  const Density_quadrature_3::Density rho = [&density](int v, const Site& s) { return density.in_cell(v, s); };
  Point_rule_quadrature_3 estimate(rho, Point_rule_quadrature_3::fifteen_points());
  Adaptive_cubature_quadrature_3 reference(rho, cubature.tolerance, cubature.most_regions);
  std::vector<double> estimates;
  double mean = 0;
  for(const Cell_vertices& v : cells)
  {
    estimates.push_back(std::abs(cell_energy(sites, v, estimate.moments(0, v.data(), sites.data()))));
    mean += estimates.back() / double(cells.size());
  }
  double energy = 0;
  for(std::size_t c = 0; c < cells.size(); ++c)
  {
    reference.set_tolerance(cubature.tolerance * (std::max)(1., mean / estimates[c]));
    energy += cell_energy(sites, cells[c], reference.moments(0, cells[c].data(), sites.data()));
  }
  return energy;
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ENERGY_REFERENCE_ENERGY_3_H
