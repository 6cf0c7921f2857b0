// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_DENSITY_SAMPLES_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_DENSITY_SAMPLES_3_H

#include <CGAL/Global_odt_mesh_3/internal/density/Density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <algorithm>
#include <array>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Adds up moments from values of the density at points of a cell.
class Density_samples_3
{
public:
  typedef std::array<double, 4> Barycentric_coordinates;

  // The products of coordinates in the order of Density_moments_3, then the squares.
  typedef std::array<double, 10> Products;

  // The densities are asked as of the vertex with the lowest number: that of the highest dimension.
  Density_samples_3(const Density_quadrature_3::Density& density, const int* vertices, const Site* sites)
    : density_(density)
    , vertex_((std::min)((std::min)(vertices[0], vertices[1]), (std::min)(vertices[2], vertices[3])))
    , sites_{{ sites[vertices[0]], sites[vertices[1]], sites[vertices[2]], sites[vertices[3]] }}
  {}

  double density(const Barycentric_coordinates& l) const
  {
    Site s = { 0, 0, 0, 0 };
    for(int i = 0; i < 4; ++i)
    {
      s.x += l[i] * sites_[i].x;
      s.y += l[i] * sites_[i].y;
      s.z += l[i] * sites_[i].z;
    }
    return density_(vertex_, s);
  }

  // Adds rho times the products at a point of a rule, and its weight.
  void add(const Barycentric_coordinates& l, double weight, Products& sum) const
  {
    const double rho = weight * density(l);
    for(int e = 0; e < 6; ++e)
      sum[e] += rho * l[Density_moments_3::edges[e][0]] * l[Density_moments_3::edges[e][1]];
    for(int i = 0; i < 4; ++i)
      sum[6 + i] += rho * l[i] * l[i];
  }

  // The coordinates add up to one, so that m_i is the sum of all m_ij.
  static Density_moments_3 moments(const Products& p)
  {
    Density_moments_3 m;
    for(int i = 0; i < 4; ++i)
      m.first[i] = p[6 + i];
    for(int e = 0; e < 6; ++e)
    {
      m.mixed[e] = p[e];
      for(int i : Density_moments_3::edges[e])
        m.first[i] += p[e];
    }
    return m;
  }

private:
  const Density_quadrature_3::Density& density_;
  int vertex_;
  std::array<Site, 4> sites_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_DENSITY_SAMPLES_3_H
