// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_DENSITY_QUADRATURE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_DENSITY_QUADRATURE_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// All that energy and gradient of a cell t know of the density: its integrals against the
// barycentric coordinates and their products, over the volume,
//   m_i  = 1/|t| int_t rho lambda_i,
//   m_ij = 1/|t| int_t rho lambda_i lambda_j.
struct Density_moments_3
{
  std::array<double, 4> first;      // m_i
  std::array<double, 6> mixed;      // m_ij of the edges below

  static constexpr std::array<std::array<int, 2>, 6> edges
    = {{ {{0, 1}}, {{0, 2}}, {{0, 3}}, {{1, 2}}, {{2, 3}}, {{3, 1}} }};
};

// The moments of a density that is interpolated linearly between the values `rho` at the vertices (Theorems 4.1 and
// 4.2): m_i = (R + rho_i)/20 and m_ij = (R + rho_i + rho_j)/120, where R is the sum of the values.
inline Density_moments_3 linear_density_moments(const std::array<double, 4>& rho)
{
  const double R = rho[0] + rho[1] + rho[2] + rho[3];
  Density_moments_3 m;
  for(int i = 0; i < 4; ++i)
    m.first[i] = (R + rho[i]) / 20;
  for(int e = 0; e < 6; ++e)
    m.mixed[e] = (R + rho[Density_moments_3::edges[e][0]] + rho[Density_moments_3::edges[e][1]]) / 120;
  return m;
}

// For a quadratic density sum_kl b_kl lambda_k lambda_l, given b_kk at the vertices and b_kl = b_lk on
// the edges, exactly. With B the sum of all b_kl, T its part where k = l, and B_k its rows,
//   m_i  = (B + T + 2 B_i + 2 b_ii)/120,
//   m_ij = (B + T + 2 (B_i + B_j + b_ii + b_jj + b_ij))/840,
// as the mean of a product of barycentric coordinates of degree d is 6/(d+3)! times the number of permutations
// of its factors that leave it the same.
inline Density_moments_3 quadratic_density_moments(const std::array<double, 4>& vertices,
                                                   const std::array<double, 6>& edges)
{
  std::array<double, 4> row = vertices;
  for(int e = 0; e < 6; ++e)
    for(int i : Density_moments_3::edges[e])
      row[i] += edges[e];
  const double T = vertices[0] + vertices[1] + vertices[2] + vertices[3];
  const double all = row[0] + row[1] + row[2] + row[3] + T;
  Density_moments_3 m;
  for(int i = 0; i < 4; ++i)
    m.first[i] = (all + 2 * (row[i] + vertices[i])) / 120;
  for(int e = 0; e < 6; ++e)
  {
    const int i = Density_moments_3::edges[e][0], j = Density_moments_3::edges[e][1];
    m.mixed[e] = (all + 2 * (row[i] + row[j] + vertices[i] + vertices[j] + edges[e])) / 840;
  }
  return m;
}

// A way to integrate the density over cells.
class Density_quadrature_3
{
public:
  // The density at a point of a cell around a vertex, given the number of that vertex.
  typedef std::function<double(int, const Site&)> Density;

  virtual ~Density_quadrature_3() {}

  // The moments on a cell, given the numbers of its vertices, into `sites`. The number of the
  // cell is for what is kept of it.
  virtual Density_moments_3 moments(int cell, const int* vertices, const Site* sites) = 0;

  // This has to be called when vertices have moved, up to that number; those beyond never move.
  virtual void update(const std::vector<Site>&, int /* number_of_movable_vertices */, const Thread_policy&) {}

  // The same for a part of the mesh with some of its vertices, given by their numbers, which stay where they are. While the
  // values are those of the last update, parts may be made, and used, by several threads if the density permits.
  virtual std::unique_ptr<Density_quadrature_3> part(const std::vector<int>& vertices) const = 0;

  // Remembers what update() will change, or goes back to it.
  virtual void keep() {}
  virtual void restore() {}

  // The relative rise of the energy that a step of the minimizer may have: little more than rounding errors, unless the
  // gradient is not its derivative.
  virtual double energy_tolerance() const { return 1e-9; }

protected:
  static Density renumbered(const Density& density, const std::vector<int>& vertices)
  {
    return [density, vertices](int v, const Site& s) { return density(vertices[v], s); };
  }

  // The tolerance for moments with which (4.6) is not the derivative of the energy, which therefore need not fall.
  static constexpr double tolerance_of_rough_moments = 1e-3;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_DENSITY_QUADRATURE_3_H
