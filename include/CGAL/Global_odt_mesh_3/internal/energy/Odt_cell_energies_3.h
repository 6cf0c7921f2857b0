// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ENERGY_ODT_CELL_ENERGIES_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ENERGY_ODT_CELL_ENERGIES_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/density/Density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Polynomial_density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <array>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// What the cells around a vertex add up to: the gradient of the energy and the
// diagonal D of equation (4.6), for which x - g/D is the AVV update (2.3).
struct Site_gradient
{
  double x, y, z;
  double diagonal;

  Site_gradient& operator+=(const Site_gradient& o)
  {
    x += o.x; y += o.y; z += o.z; diagonal += o.diagonal;
    return *this;
  }
};

struct Cell_energy
{
  double energy;
  std::array<Site_gradient, 4> gradient;
};

// Energy (4.1) and gradient (4.6) of a cell for uniform density 1, without the moments:
//   E   = |t|/20 sum_{i<j} l_ij^2 - |t|/4 sum_i w_i,
//   g_i = |t|/2 (x_i - c_t).
inline Cell_energy uniform_odt_energy(const Cell_products& t,
                                      const Site& s0, const Site& s1,
                                      const Site& s2, const Site& s3)
{
  Cell_energy r;
  // The squared edge lengths add up to 3 (aa + bb + cc) - 2 (ab + bc + ca),
  // that is 4 (aa + bb + cc) - |a + b + c|^2.
  const double sx = t.ax + t.bx + t.cx, sy = t.ay + t.by + t.cy, sz = t.az + t.bz + t.cz;
  const double squared_edges = 4 * (t.aa + t.bb + t.cc) - (sx * sx + sy * sy + sz * sz);
  const double weights = s0.weight + s1.weight + s2.weight + s3.weight;
  r.energy = t.determinant * (squared_edges / 120 - weights / 24);

  const double f = 1. / 24, d = t.determinant / 12, diagonal = t.determinant / 12;
  const double mx = f * t.nx, my = f * t.ny, mz = f * t.nz;
  r.gradient[0] = { -mx, -my, -mz, diagonal };
  r.gradient[1] = { d * t.ax - mx, d * t.ay - my, d * t.az - mz, diagonal };
  r.gradient[2] = { d * t.bx - mx, d * t.by - my, d * t.bz - mz, diagonal };
  r.gradient[3] = { d * t.cx - mx, d * t.cy - my, d * t.cz - mz, diagonal };
  return r;
}

// The same for the density of which the moments are given:
//   E   = |t| (sum_{i<j} l_ij^2 m_ij - sum_i w_i m_i),
//   g_i = 2 |t| (x_i - c_t) m_i,   that is, (3.1).
// With moments of an approximate density, the gradient is not exactly the derivative of E, but approximates the
// gradient for the true density, which is what is wanted: the minimum of an interpolated E has too few vertices where
// the density is high.
inline Cell_energy odt_energy(const Cell_products& t,
                              const Site& s0, const Site& s1,
                              const Site& s2, const Site& s3,
                              const Density_moments_3& m)
{
  Cell_energy r;
  const double abx = t.ax - t.bx, aby = t.ay - t.by, abz = t.az - t.bz;
  const double bcx = t.bx - t.cx, bcy = t.by - t.cy, bcz = t.bz - t.cz;
  const double cax = t.cx - t.ax, cay = t.cy - t.ay, caz = t.cz - t.az;
  const double edges = t.aa * m.mixed[0] + t.bb * m.mixed[1] + t.cc * m.mixed[2]
                     + (abx * abx + aby * aby + abz * abz) * m.mixed[3]
                     + (bcx * bcx + bcy * bcy + bcz * bcz) * m.mixed[4]
                     + (cax * cax + cay * cay + caz * caz) * m.mixed[5];
  const double weights = s0.weight * m.first[0] + s1.weight * m.first[1]
                       + s2.weight * m.first[2] + s3.weight * m.first[3];
  r.energy = t.determinant / 6 * (edges - weights);

  const double d = 2 * t.determinant;
  const std::array<double, 4> f = { m.first[0] / 6, m.first[1] / 6, m.first[2] / 6, m.first[3] / 6 };
  r.gradient[0] = { -f[0] * t.nx, -f[0] * t.ny, -f[0] * t.nz, f[0] * d };
  r.gradient[1] = { f[1] * (d * t.ax - t.nx), f[1] * (d * t.ay - t.ny), f[1] * (d * t.az - t.nz), f[1] * d };
  r.gradient[2] = { f[2] * (d * t.bx - t.nx), f[2] * (d * t.by - t.ny), f[2] * (d * t.bz - t.nz), f[2] * d };
  r.gradient[3] = { f[3] * (d * t.cx - t.nx), f[3] * (d * t.cy - t.ny), f[3] * (d * t.cz - t.nz), f[3] * d };
  return r;
}

// The energy that the cells of a mesh have: with a density or without.
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

  // Others may ask the user.
  bool is_safe_for_threads() const { return quadrature_ == nullptr || linear_quadrature_ != nullptr; }

  // Calls f(energy), where energy(t, cell, v, s) is that of a cell, its number and those of its vertices, into `s`, by its type as
  // far as that is faster. Energies are polynomials in the coordinates, so that that of a cell may be taken off again, whatever its
  // shape.
  template <class F>
  void visit(const F& f) const
  {
    // The quadrature is a pointer, or what behaves like one.
    const auto with = [](auto quadrature)
    {
      return [quadrature](const Cell_products& t, int cell, const int* v, const Site* s)
             { return odt_energy(t, s[v[0]], s[v[1]], s[v[2]], s[v[3]], quadrature->moments(cell, v, s)); };
    };
    if(quadrature_ == nullptr)
      f([](const Cell_products& t, int, const int* v, const Site* s)
        { return uniform_odt_energy(t, s[v[0]], s[v[1]], s[v[2]], s[v[3]]); });
    else if(linear_quadrature_ != nullptr)
      f(with(linear_quadrature_->view()));
    else
      f(with(quadrature_));
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
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ENERGY_ODT_CELL_ENERGIES_3_H
