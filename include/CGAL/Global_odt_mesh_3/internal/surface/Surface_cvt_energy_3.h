// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_SURFACE_CVT_ENERGY_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_SURFACE_CVT_ENERGY_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/energy/Odt_cell_energies_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Surface_triangulation_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
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
  std::array<Eigen::Vector3d, 3> gradient = {{ Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero() }};
  std::array<double, 3> mass = {{ 0, 0, 0 }};       // of the corners' parts

  // Of a facet without area.
  Surface_cvt_contribution_3() {}

  // The density is one, and no vertex has a weight. The part at each end of an edge of length l is a right triangle
  // with legs l/2 and l/2 cot(a), where a is the angle opposite to the edge. Both have the area A b/2, where b is the
  // circumcenter's barycentric coordinate at that angle, and A the area of the facet.
  Surface_cvt_contribution_3(const std::array<int, 3>& facet, const std::vector<Site>& sites)
  {
    std::array<Eigen::Vector3d, 3> edge;            // opposite to the corners
    for(int k = 0; k < 3; ++k)
      edge[k] = position(sites[facet[(k + 2) % 3]]) - position(sites[facet[(k + 1) % 3]]);
    const double twice_area = edge[0].cross(edge[1]).norm(), inverse = 1 / twice_area;
    std::array<double, 3> part;                     // A b / 4
    for(int k = 0; k < 3; ++k)
    {
      const double squared_length = edge[k].squaredNorm();
      const double cotangent = -edge[(k + 1) % 3].dot(edge[(k + 2) % 3]) * inverse;
      part[k] = squared_length * cotangent * 0.125;
      energy += 0.25 * part[k] * squared_length * (1 + third * cotangent * cotangent);
    }
    for(int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      mass[i] = part[j] + part[k];
      const Eigen::Vector3d center = 4 * inverse * (part[j] * edge[k] - part[k] * edge[j]);     // from corner i
      gradient[i] = -third * (part[k] * edge[k] - part[j] * edge[j] + 2 * mass[i] * center);
    }
  }

  // The density is given at the corners.
  Surface_cvt_contribution_3(const std::array<int, 3>& facet, const std::vector<Site>& sites,
                             const std::array<double, 3>& density)
  {
    // In coordinates on the plane, along the first edge and across.
    const Eigen::Vector3d a = position(sites[facet[1]]) - position(sites[facet[0]]);
    const Eigen::Vector3d b = position(sites[facet[2]]) - position(sites[facet[0]]);
    const double length = a.norm();
    const Eigen::Vector3d along = a / length;
    const double offset = b.dot(along);
    const Eigen::Vector3d height = b - offset * along;
    const double width = height.norm();
    const std::array<Eigen::Vector2d, 3> x = {{ { 0, 0 }, { length, 0 }, { offset, width } }};
    const std::array<double, 3> w = {{ sites[facet[0]].weight, sites[facet[1]].weight, sites[facet[2]].weight }};
    Eigen::Vector2d slope((density[1] - density[0]) / length, 0);
    slope[1] = (density[2] - density[0] - slope[0] * offset) / width;
    Eigen::Vector2d center((length * length + w[0] - w[1]) / (2 * length), 0);
    center[1] = (x[2].squaredNorm() + w[0] - w[2] - 2 * center[0] * offset) / (2 * width);
    for(int i = 0; i < 3; ++i)
    {
      const Eigen::Vector2d q = center - x[i];
      Eigen::Vector2d g(0, 0);
      for(int side = 1; side < 3; ++side)
      {
        const int j = (i + side) % 3;
        const Eigen::Vector2d edge = x[j] - x[i];
        const Eigen::Vector2d p = (w[i] == w[j] ? 0.5 : 0.5 + (w[i] - w[j]) / (2 * edge.squaredNorm())) * edge;
        const double area = (p[0] * q[1] - p[1] * q[0]) * (side == 1 ? 0.5 : -0.5);
        g += add_piece(i, w[i], area, p, q, {{ density[i], density[i] + slope.dot(p), density[i] + slope.dot(q) }});
      }
      gradient[i] = g[0] * along + g[1] / width * height;
    }
  }

private:
  static constexpr double third = 1. / 3;         // a constant whatever the rounding mode

  // The piece is the triangle of corner i, i + p and i + q, with the density at these points. Gives its gradient.
  Eigen::Vector2d add_piece(int i, double weight, double area, const Eigen::Vector2d& p, const Eigen::Vector2d& q,
                            const std::array<double, 3>& r)
  {
    const double sum = r[0] + r[1] + r[2];
    const double m = third * area * sum;
    mass[i] += m;
    energy += third * area * 0.1 * (p.squaredNorm() * (sum + 2 * r[1]) + p.dot(q) * (sum + r[1] + r[2])
                                    + q.squaredNorm() * (sum + 2 * r[2])) - weight * m;
    return -0.5 * third * area * ((sum + r[1]) * p + (sum + r[2]) * q);
  }
};

// The density at a vertex, given its number and position; none: one everywhere.
typedef std::function<double(int, const Site&)> Surface_density;

// That at the vertices of the facets; empty if it is one everywhere.
inline std::vector<double> surface_densities(const Surface_triangulation_3& surface, const std::vector<Site>& sites,
                                             const Surface_density& density)
{
  std::vector<double> densities;
  if(!density)
    return densities;
  densities.resize(sites.size());
  for(int f = 0; f < surface.number_of_facets(); ++f)
    for(int v : surface.vertices(f))
      densities[v] = density(v, sites[v]);
  return densities;
}

// The energy of all facets, as sums of chunks that do not depend on the number of threads.
class Surface_cvt_energy_3
{
public:
  explicit Surface_cvt_energy_3(const Thread_policy& threads = Thread_policy()) : threads_(threads) {}

  // Gradient and diagonal, twice the masses, are those of the vertices from number `first` on, of which
  // there are as many as the vectors have room for. If there are no densities, they are one.
  double compute(const Surface_triangulation_3& surface, const std::vector<Site>& sites,
                 const std::vector<double>& densities, int first, Eigen::VectorXd& gradient, Eigen::VectorXd& diagonal)
  {
    const int number = static_cast<int>(gradient.size() / 3);
    const Chunks facets(surface.number_of_facets(), least_facets, most_chunks);
    std::vector<double> energies(facets.number());
    sums_.resize(number, facets.number());
    threads_.for_each_chunk(facets.number(), [&](int n)
    {
      sums_.clear(n);
      const Sums::Part part = sums_.part(n);
      double energy = 0;
      for(int f = facets.begin(n); f < facets.end(n); ++f)
      {
        const std::array<int, 3>& t = surface.vertices(f);
        const Surface_cvt_contribution_3 c = contribution(t, sites, densities);
        energy += c.energy;
        for(int k = 0; k < 3; ++k)
          if(t[k] >= first && t[k] < first + number)
            part.add(t[k] - first, { c.gradient[k].x(), c.gradient[k].y(), c.gradient[k].z(), 2 * c.mass[k] });
      }
      energies[n] = energy;
    });
    sums_.for_each_sum(0, sums_.number_of_blocks(), [&](int n, const Site_gradient& g)
    {
      gradient.segment<3>(3 * n) << g.x, g.y, g.z;
      diagonal.segment<3>(3 * n).setConstant(g.diagonal);
    });
    return std::accumulate(energies.begin(), energies.end(), 0.);
  }

private:
  typedef Chunked_sums<Site_gradient> Sums;

  // A chunk is to be worth the trouble of a thread.
  static constexpr int least_facets = 2000, most_chunks = 8;

  // Facets whose vertices are on one line, up to rounding, count for nothing, as formulas divide by the area.
  static Surface_cvt_contribution_3 contribution(const std::array<int, 3>& t, const std::vector<Site>& sites,
                                                 const std::vector<double>& densities)
  {
    const Surface_cvt_contribution_3 c = contribution_of_triangle(t, sites, densities);
    const double sum = c.energy + c.gradient[0].sum() + c.gradient[1].sum() + c.gradient[2].sum() + c.mass[0] + c.mass[1] + c.mass[2];
    return std::isfinite(sum) ? c : Surface_cvt_contribution_3();
  }

  static Surface_cvt_contribution_3 contribution_of_triangle(const std::array<int, 3>& t, const std::vector<Site>& sites,
                                                             const std::vector<double>& densities)
  {
    if(!densities.empty())
      return Surface_cvt_contribution_3(t, sites, {{ densities[t[0]], densities[t[1]], densities[t[2]] }});
    if(std::any_of(t.begin(), t.end(), [&](int v) { return sites[v].weight != 0; }))
      return Surface_cvt_contribution_3(t, sites, {{ 1, 1, 1 }});
    return Surface_cvt_contribution_3(t, sites);
  }

  Thread_policy threads_;
  Sums sums_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_SURFACE_CVT_ENERGY_3_H
