// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_TEST_VORONOI_ENERGY_H
#define GLOBAL_ODT_MESH_3_TEST_VORONOI_ENERGY_H

#include <CGAL/Global_odt_mesh_3/internal/energy/Odt_cell_energies_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// What one cell adds to the energy of the centroidal Voronoi tessellation of density 1,
//
//   E = sum_i  integral over V_i of  |x - x_i|^2,
//
// the gradient g_i = 2 m_i (x_i - z_i) and the diagonal 2 m_i, where m_i and z_i are volume and centroid of V_i, so that
// x - g/D is the step of Lloyd. No vertex has a weight.
//
// For each facet of the cell and each edge of that, the middle of the edge, the circumcenter of the facet and that of the
// cell make an orthoscheme with each end of the edge. Its legs a, b and h are orthogonal, its volume is a b h / 6, and its
// second moment about that end a b h / 60 (6 a^2 + 3 b^2 + h^2). Volumes have signs, so that the sum over a cell and its
// neighbors is right although circumcenters lie beyond facets. At the boundary it is that of Voronoi cells which are cut off
// there, provided that no circumcenter lies beyond it: a mesh of which this is minimized is to know where its surface is.
inline Cell_energy cvt_energy(const Cell_products& t)
{
  // An edge and the third vertex of a facet which, seen from the fourth vertex, is counterclockwise.
  static constexpr int flags[12][3] = { { 0, 1, 2 }, { 1, 2, 0 }, { 2, 0, 1 }, { 0, 3, 1 }, { 3, 1, 0 }, { 1, 0, 3 },
                                        { 0, 2, 3 }, { 2, 3, 0 }, { 3, 0, 2 }, { 1, 3, 2 }, { 3, 2, 1 }, { 2, 1, 3 } };
  const std::array<Vector_3, 4> x = {{ Vector_3(), Vector_3(t.ax, t.ay, t.az),
                                              Vector_3(t.bx, t.by, t.bz), Vector_3(t.cx, t.cy, t.cz) }};
  const Vector_3 center = t.to_dual();
  std::array<Vector_3, 4> gradient;
  gradient.fill(Vector_3());
  std::array<double, 4> mass = {{ 0, 0, 0, 0 }};
  Cell_energy r;
  r.energy = 0;
  Vector_3 height(0, 0, 0);            // of the center above the facet
  for(int n = 0; n < 12; ++n)
  {
    const int i = flags[n][0], j = flags[n][1], k = flags[n][2];
    if(n % 3 == 0)
    {
      const Vector_3 normal = (x[j] - x[i]).cross(x[k] - x[i]);
      height = (center - x[i]).dot(normal) / normal.squared_length() * normal;
    }
    const Vector_3 leg = (x[j] - x[i]) / 2, middle = (x[i] + x[j]) / 2;
    const Vector_3 foot = center - height, width = foot - middle;
    const double volume = leg.dot(width.cross(height)) / 6;
    r.energy += volume / 5 * (6 * leg.squared_length() + 3 * width.squared_length() + height.squared_length());
    const Vector_3 corners = middle + foot + center;
    gradient[i] += volume / 2 * (3 * x[i] - corners);
    gradient[j] += volume / 2 * (3 * x[j] - corners);
    mass[i] += volume;
    mass[j] += volume;
  }
  for(int i = 0; i < 4; ++i)
    r.gradient[i] = { gradient[i].x(), gradient[i].y(), gradient[i].z(), 2 * mass[i] };
  return r;
}

// The sum over a regular mesh. Calls f(v, gradient) for the vertices of each cell, with what it adds to theirs.
template <class F>
double voronoi_energy(const Moving_triangulation_3& mesh, const F& f)
{
  double sum = 0;
  for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
    if(mesh.topology.is_alive(c))
    {
      const Cell_energy e = cvt_energy(mesh.products(c));
      sum += e.energy;
      for(int i = 0; i < 4; ++i)
        f(mesh.topology.vertices(c)[i], e.gradient[i]);
    }
  return sum;
}

inline double voronoi_energy(const Moving_triangulation_3& mesh)
{
  return voronoi_energy(mesh, [](int, const Site_gradient&) {});
}

// As a term of Odt_objective_3, it takes the place of the energy of the mesh, to which it refers.
class Voronoi_term
{
public:
  explicit Voronoi_term(const Moving_triangulation_3& mesh) : mesh_(mesh) {}

  double operator()(const std::vector<Site>&, Eigen::VectorXd& gradient, Eigen::VectorXd& diagonal) const
  {
    std::vector<Site_gradient> sums(mesh_.sites.size(), Site_gradient{ 0, 0, 0, 0 });
    const double energy = voronoi_energy(mesh_, [&](int v, const Site_gradient& g) { sums[v] += g; });
    for(int v = 0; v < mesh_.number_of_movable_vertices; ++v)
    {
      const Site_gradient& g = sums[v];
      set_vector(diagonal, v, { g.diagonal, g.diagonal, g.diagonal });
      // That of frozen vertices stays zero.
      if(vector_at(gradient, v) != Vector_3())
        set_vector(gradient, v, { g.x, g.y, g.z });
    }
    return energy - mesh_.energy();
  }

private:
  const Moving_triangulation_3& mesh_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // GLOBAL_ODT_MESH_3_TEST_VORONOI_ENERGY_H
