// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_SURFACE_CVT_ENERGY_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_SURFACE_CVT_ENERGY_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_dual_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// What one facet adds to the energy of the centroidal Voronoi tessellation
//
//   E = sum_i  integral over V_i of  rho(x) (|x - x_i|^2 - w_i)
//
// that its three vertices see of their Voronoi cells V_i on the plane of the facet.
//
// The foot of the edge's bisector and the circumcenter cut the cell of a corner into two
// right triangles, whose areas have signs, so that the sum over an obtuse facet and its
// neighbors is right although the circumcenter lies beyond. The density is linear on
// the facet. As the boundaries between cells do not matter in first order,
// the gradient is dE/dx_i = -2 integral of rho(x) (x - x_i).
struct Surface_cvt_contribution_3
{
  double energy = 0;
  std::array<Eigen::Vector3d, 3> gradient;
  std::array<double, 3> mass = {{ 0, 0, 0 }};       // of the corners' parts

  Surface_cvt_contribution_3(const std::array<int, 3>& facet, const std::vector<Site>& sites,
                             const std::array<double, 3>& density)
  {
    gradient.fill(Eigen::Vector3d::Zero());
    std::array<Eigen::Vector3d, 3> x;
    for(int k = 0; k < 3; ++k)
      x[k] = Eigen::Vector3d(sites[facet[k]].x, sites[facet[k]].y, sites[facet[k]].z);
    const Eigen::Vector3d a = x[1] - x[0], b = x[2] - x[0], n = a.cross(b);
    const Eigen::Vector3d slope = ((density[1] - density[0]) * b.cross(n) + (density[2] - density[0]) * n.cross(a))
                                  / n.squaredNorm();
    const Eigen::Vector3d unit = n.normalized();
    const Facet_dual_3 dual(facet, sites);
    const Eigen::Vector3d& center = dual.center;
    for(int i = 0; i < 3; ++i)
    {
      const double weight = sites[facet[i]].weight;
      const Eigen::Vector3d q = center - x[i];
      for(int side = 1; side < 3; ++side)
      {
        const int j = (i + side) % 3;
        const Eigen::Vector3d edge = x[j] - x[i];
        const double t = (1 + (weight - sites[facet[j]].weight) / edge.squaredNorm()) / 2;
        const Eigen::Vector3d p = t * edge;
        const double area = unit.dot(p.cross(q)) * (side == 1 ? 0.5 : -0.5);
        add_piece(i, weight, area, p, q, {{ density[i], density[i] + slope.dot(p), density[i] + slope.dot(q) }});
      }
    }
  }

private:
  // The piece is the triangle of corner i, i + p and i + q, with the density at these points.
  void add_piece(int i, double weight, double area, const Eigen::Vector3d& p, const Eigen::Vector3d& q,
                 const std::array<double, 3>& r)
  {
    const double sum = r[0] + r[1] + r[2];
    const double m = area * sum / 3;
    mass[i] += m;
    gradient[i] -= area / 6 * ((sum + r[1]) * p + (sum + r[2]) * q);
    energy += area * (p.squaredNorm() * (sum + 2 * r[1]) + p.dot(q) * (sum + r[1] + r[2])
                      + q.squaredNorm() * (sum + 2 * r[2])) / 30 - weight * m;
  }
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_SURFACE_CVT_ENERGY_3_H
