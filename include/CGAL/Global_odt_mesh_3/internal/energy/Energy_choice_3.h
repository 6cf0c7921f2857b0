// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ENERGY_ENERGY_CHOICE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ENERGY_ENERGY_CHOICE_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/density/Density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Polynomial_density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/energy/Cvt_energy_3.h>
#include <CGAL/Global_odt_mesh_3/internal/energy/Odt_cell_energies_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Which energy the cells of a mesh have: that of the optimal Delaunay triangulation, with a density or without, or that of
// the centroidal Voronoi tessellation, which is for uniform density, sites without weights, and vertices of the interior alone.
class Energy_choice_3
{
public:
  // Null stands for the density 1.
  void set_quadrature(Density_quadrature_3* quadrature)
  {
    quadrature_ = quadrature;
    linear_quadrature_ = dynamic_cast<Linear_density_quadrature_3*>(quadrature);
  }

  Density_quadrature_3* quadrature() const { return quadrature_; }

  void set_voronoi(bool is_voronoi) { is_voronoi_ = is_voronoi; }

  // Whether cells may be flat and their energy taken off again.
  bool is_polynomial() const { return !is_voronoi_; }

  // Others may ask the user.
  bool is_safe_for_threads() const { return quadrature_ == nullptr || linear_quadrature_ != nullptr; }

  // Calls f(energy), where energy(t, cell, v, s) is that of a cell, by its type as far as that is faster.
  template <class F>
  void visit(const F& f) const
  {
    if(is_voronoi_)
      f(Cvt_energy_3());
    else if(quadrature_ == nullptr)
      f(Uniform_odt_energy_3());
    else if(linear_quadrature_ != nullptr)
      f(Weighted_odt_energy_3<Linear_density_quadrature_3::View>{ linear_quadrature_->view() });
    else
      f(Weighted_odt_energy_3<Density_quadrature_3*>{ quadrature_ });
  }

  // What a quadrature has to be told.
  void update(const std::vector<Site>& sites, int number_of_movable_vertices, const Thread_policy& threads)
  {
    if(quadrature_ != nullptr)
      quadrature_->update(sites, number_of_movable_vertices, threads);
  }

  void keep()
  {
    if(quadrature_ != nullptr)
      quadrature_->keep();
  }

  void restore()
  {
    if(quadrature_ != nullptr)
      quadrature_->restore();
  }

private:
  Density_quadrature_3* quadrature_ = nullptr;
  Linear_density_quadrature_3* linear_quadrature_ = nullptr;    // the same, if it is one
  bool is_voronoi_ = false;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ENERGY_ENERGY_CHOICE_3_H
