// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_SURFACE_CVT_OBJECTIVE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_SURFACE_CVT_OBJECTIVE_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/energy/Odt_cell_energies_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Surface_triangulation_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The contribution of one facet to the energy of the centroidal Voronoi tessellation
//
//   E = sum_i  integral over V_i of  rho(x) (|x - x_i|^2 - w_i)
//
// with the Voronoi cells V_i of its three vertices restricted to the facet's plane.
//
// The feet of the edges' bisectors and the circumcenter cut the cell of a corner into two right triangles. Their areas have signs,
// so that the sum over an obtuse facet and its neighbors is right although the circumcenter lies outside. The density is linear on
// the facet. Since the boundaries between cells do not matter in first order, the gradient is dE/dx_i = -2 integral of rho(x) (x -
// x_i).
struct Surface_cvt_contribution_3
{
  double energy = 0;
  std::array<Vector_3, 3> gradient;
  std::array<double, 3> mass = {{ 0, 0, 0 }};       // of the corners' parts

  // The contribution of a facet without area.
  Surface_cvt_contribution_3() {}

  // The density is one, and no vertex has a weight. The part at each end of an edge of length l is a right triangle
  // with legs l/2 and l/2 cot(a), where a is the angle opposite to the edge. Both have the area A b/2, where b is the
  // circumcenter's barycentric coordinate at that angle, and A the area of the facet.
  Surface_cvt_contribution_3(const std::array<int, 3>& facet, const std::vector<Site>& sites)
  {
    std::array<Vector_3, 3> edge;            // opposite to the corners
    for(int k = 0; k < 3; ++k)
      edge[k] = position(sites[facet[(k + 2) % 3]]) - position(sites[facet[(k + 1) % 3]]);
    const double twice_area = edge[0].cross(edge[1]).length(), inverse = 1 / twice_area;
    std::array<double, 3> part;                     // A b / 4
    for(int k = 0; k < 3; ++k)
    {
      const double squared_length = edge[k].squared_length();
      const double cotangent = -edge[(k + 1) % 3].dot(edge[(k + 2) % 3]) * inverse;
      part[k] = squared_length * cotangent * 0.125;
      energy += 0.25 * part[k] * squared_length * (1 + third * cotangent * cotangent);
    }
    for(int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      mass[i] = part[j] + part[k];
      const Vector_3 center = 4 * inverse * (part[j] * edge[k] - part[k] * edge[j]);     // from corner i
      gradient[i] = -third * (part[k] * edge[k] - part[j] * edge[j] + 2 * mass[i] * center);
    }
  }

  // The density is given at the corners.
  Surface_cvt_contribution_3(const std::array<int, 3>& facet, const std::vector<Site>& sites,
                             const std::array<double, 3>& density)
  {
    // Coordinates in the plane run along the first edge and across.
    const Vector_3 a = position(sites[facet[1]]) - position(sites[facet[0]]);
    const Vector_3 b = position(sites[facet[2]]) - position(sites[facet[0]]);
    const double length = a.length();
    const Vector_3 along = a / length;
    const double offset = b.dot(along);
    const Vector_3 height = b - offset * along;
    const double width = height.length();
    const std::array<Vector_3, 3> x = {{ { 0, 0, 0 }, { length, 0, 0 }, { offset, width, 0 } }};
    const std::array<double, 3> w = {{ sites[facet[0]].weight, sites[facet[1]].weight, sites[facet[2]].weight }};
    Vector_3 slope((density[1] - density[0]) / length, 0, 0);
    slope[1] = (density[2] - density[0] - slope[0] * offset) / width;
    Vector_3 center((length * length + w[0] - w[1]) / (2 * length), 0, 0);
    center[1] = (x[2].squared_length() + w[0] - w[2] - 2 * center[0] * offset) / (2 * width);
    for(int i = 0; i < 3; ++i)
    {
      const Vector_3 q = center - x[i];
      Vector_3 g(0, 0, 0);
      for(int side = 1; side < 3; ++side)
      {
        const int j = (i + side) % 3;
        const Vector_3 edge = x[j] - x[i];
        const Vector_3 p = (w[i] == w[j] ? 0.5 : 0.5 + (w[i] - w[j]) / (2 * edge.squared_length())) * edge;
        const double area = (p[0] * q[1] - p[1] * q[0]) * (side == 1 ? 0.5 : -0.5);
        g += add_piece(i, w[i], area, p, q, {{ density[i], density[i] + slope.dot(p), density[i] + slope.dot(q) }});
      }
      gradient[i] = g[0] * along + g[1] / width * height;
    }
  }

private:
  static constexpr double third = 1. / 3;         // a constant independent of the rounding mode

  // Adds the piece with corners i, i + p and i + q, where the density is r; returns its gradient.
  Vector_3 add_piece(int i, double weight, double area, const Vector_3& p, const Vector_3& q,
                            const std::array<double, 3>& r)
  {
    const double sum = r[0] + r[1] + r[2];
    const double m = third * area * sum;
    mass[i] += m;
    energy += third * area * 0.1 * (p.squared_length() * (sum + 2 * r[1]) + p.dot(q) * (sum + r[1] + r[2])
                                    + q.squared_length() * (sum + 2 * r[2])) - weight * m;
    return -0.5 * third * area * ((sum + r[1]) * p + (sum + r[2]) * q);
  }
};

// The density at a vertex, given its number and position; empty if it is one everywhere.
typedef std::function<double(int, const Site&)> Surface_density;

// The density at the vertices of the facets; empty if it is one everywhere.
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

// The energy of all facets, summed over chunks that do not depend on the number of threads.
class Surface_cvt_energy_3
{
public:
  explicit Surface_cvt_energy_3(const Thread_policy& threads = Thread_policy()) : threads_(threads) {}

  // Computes the energy with its gradient and diagonal, which is twice the masses, for the vertices from number `first` on; the
  // size of the vectors gives their number. Without densities, the density is one.
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
      set_vector(gradient, n, { g.x, g.y, g.z });
      set_vector(diagonal, n, { g.diagonal, g.diagonal, g.diagonal });
    });
    return std::accumulate(energies.begin(), energies.end(), 0.);
  }

private:
  typedef Chunked_sums<Site_gradient> Sums;

  // A chunk must be worth the overhead of a thread.
  static constexpr int least_facets = 2000, most_chunks = 8;

  // Facets whose vertices are collinear up to rounding do not count, as the formulas divide by the area.
  static Surface_cvt_contribution_3 contribution(const std::array<int, 3>& t, const std::vector<Site>& sites,
                                                 const std::vector<double>& densities)
  {
    const Surface_cvt_contribution_3 c = contribution_of_triangle(t, sites, densities);
    const double sum = c.energy + (c.gradient[0] + c.gradient[1] + c.gradient[2]).squared_length() + c.mass[0] + c.mass[1] + c.mass[2];
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

// The energy of the restricted CVT of the surfaces as a term of another energy, that of the cells.
//
// Both densities are such that the ratio of the Hessians' diagonals does not depend on the local size. The factor on the term is
// fixed and the same for all vertices: where the term is first evaluated, it makes the ratio of the diagonals, summed over the
// vertices, equal to `weight`. So the fewer vertices the interior has compared with the surfaces, the less the term pulls at each.
class Surface_cvt_term_3
{
public:
  // The vertices from number `first` on, `number` of them, move on the surfaces.
  Surface_cvt_term_3(int first, int number, double weight, Surface_density density,
                     const Thread_policy& threads = Thread_policy())
    : first_(first)
    , number_(number)
    , weight_(weight)
    , density_(std::move(density))
    , threads_(threads)
    , energy_(threads)
    , gradient_(3 * number)
    , diagonal_(3 * number)
  {}

  // From now on, the surfaces have these facets.
  void follow(const Boundary_complex_3& boundary, const std::vector<Site>& sites)
  {
    delaunay_ = surface_ = Surface_triangulation_3(boundary);
    densities_ = surface_densities(surface_, sites, density_);
  }

  // The term for a part of the mesh, once the scale is known. `vertices` are the numbers of the part's vertices in the mesh;
  // `number_of_moving` of them, from `first` on, move on the surfaces; `number` gives the numbers in the part. The facets are those
  // of the mesh, whatever evaluations came before.
  template <class Number>
  Surface_cvt_term_3 part(const std::vector<int>& vertices, int first, int number_of_moving, const Number& number) const
  {
    const auto begin = vertices.begin() + first;
    Surface_density density;
    if(density_)
      density = [density = density_, vertices](int v, const Site& s) { return density(vertices[v], s); };
    Surface_cvt_term_3 part(first, number_of_moving, weight_, density);
    part.factor_ = factor_;
    part.delaunay_ = surface_.part(std::vector<int>(begin, begin + number_of_moving), corner_of_vertex_, number);
    for(int v : vertices)
      if(density_)
        part.densities_.push_back(densities_[v]);
    return part;
  }

  // Whether the factor on the term is known, which is set at the first evaluation.
  bool has_scale() const { return factor_ >= 0; }

  // To be called before parts are made for these sites.
  void prepare_parts(const std::vector<Site>& sites)
  {
    update_densities(sites);
    corner_of_vertex_ = surface_.corners_of_vertices(sites.size());
  }

  // Adds gradient and diagonal to those of all vertices, and returns the energy.
  double operator()(const std::vector<Site>& sites, Eigen::VectorXd& gradient, Eigen::VectorXd& diagonal)
  {
    update_densities(sites);
    delaunay_.make_delaunay(sites, threads_);
    const double energy = energy_.compute(delaunay_, sites, densities_, first_, gradient_, diagonal_);
    // Voronoi cells may be empty where weights are large.
    diagonal_ = diagonal_.cwiseMax(0);
    if(factor_ < 0)
    {
      const double sum = diagonal_.sum();
      factor_ = sum > 0 ? weight_ * diagonal.sum() / sum : 0;
    }
    gradient.segment(3 * first_, 3 * number_) += factor_ * gradient_;
    diagonal.segment(3 * first_, 3 * number_) += factor_ * diagonal_;
    return factor_ * energy;
  }

private:
  void update_densities(const std::vector<Site>& sites)
  {
    for(int v = first_; density_ && v < first_ + number_; ++v)
      densities_[v] = density_(v, sites[v]);
  }

  int first_, number_;
  double weight_, factor_ = -1;     // not known yet
  Surface_density density_;
  Thread_policy threads_;
  Surface_cvt_energy_3 energy_;
  Surface_triangulation_3 surface_, delaunay_;      // original, and with edges flipped at the last evaluation
  std::vector<double> densities_;
  std::vector<int> corner_of_vertex_;
  Eigen::VectorXd gradient_, diagonal_;
};

// The energy of the centroidal Voronoi tessellation restricted to the surfaces, as a function of the coordinates of the vertices
// that move on them, in the form the minimizer requires.
//
// Section 5.1 of the paper restricts Voronoi cells to the input surface. Here, they are restricted to the surfaces of the complex,
// which follow the vertices: their tangential planes touch the input surface in second order, and cells need not be clipped.
//
// As in Odt_objective_3, a point is either the current one or on trial.
class Surface_cvt_objective_3
{
public:
  typedef Surface_density Density;

  // `motions` are those of the vertices from number `first` on.
  Surface_cvt_objective_3(const Boundary_complex_3& boundary, std::vector<Site>& sites, int first,
                          std::vector<Tangential_motion> motions, Density density = Density(),
                          const Thread_policy& threads = Thread_policy())
    : sites_(sites)
    , first_(first)
    , motions_(std::move(motions))
    , density_(std::move(density))
    , threads_(threads)
    , energy_(threads)
    , current_(boundary, motions_.size())
    , other_(current_)
  {
    densities_ = surface_densities(surface(), sites, density_);
    compute();
  }

  double value() const { return current_.value; }
  const Eigen::VectorXd& point() const { return current_.point; }
  const Eigen::VectorXd& gradient() const { return current_.gradient; }
  const Eigen::VectorXd& diagonal() const { return current_.diagonal; }
  const Surface_triangulation_3& surface() const { return current_.surface; }

  bool evaluate(const Eigen::VectorXd& x)
  {
    for(std::size_t n = 0; n < motions_.size(); ++n)
    {
      if(motions_[n].is_at_rest())
        continue;
      const int v = first_ + static_cast<int>(n);
      Site& s = sites_[v];
      s = { x[3 * n], x[3 * n + 1], x[3 * n + 2], s.weight };
      motions_[n].hold_in_disk(s);
      if(density_)
        densities_[v] = density_(v, s);
    }
    std::swap(current_, other_);
    current_.surface = other_.surface;
    compute();
    return std::isfinite(value());
  }

  // The trial is the current point already.
  void accept() {}

  void reject()
  {
    std::swap(current_, other_);
    for(std::size_t n = 0; n < motions_.size(); ++n)
    {
      Site& s = sites_[first_ + n];
      s = { point()[3 * n], point()[3 * n + 1], point()[3 * n + 2], s.weight };
    }
  }

private:
  struct Evaluation
  {
    Surface_triangulation_3 surface;
    double value = 0;
    Eigen::VectorXd point, gradient, diagonal;

    Evaluation(const Boundary_complex_3& boundary, std::size_t vertices)
      : surface(boundary)
      , point(3 * vertices)
      , gradient(3 * vertices)
      , diagonal(3 * vertices)
    {}
  };

  void compute()
  {
    Evaluation& e = current_;
    e.surface.make_delaunay(sites_, threads_);
    e.value = energy_.compute(e.surface, sites_, densities_, first_, e.gradient, e.diagonal);
    for(std::size_t n = 0; n < motions_.size(); ++n)
    {
      const Site& s = sites_[first_ + n];
      set_vector(e.point, n, position(s));
      set_vector(e.gradient, n, motions_[n].is_at_rest() ? Vector_3() : motions_[n].tangential_part(vector_at(e.gradient, n)));
      // Voronoi cells may be empty where weights are large.
      if(!(e.diagonal[3 * n] > 0))
        set_vector(e.diagonal, n, (std::numeric_limits<double>::max)() * Vector_3(1, 1, 1));
    }
  }

  std::vector<Site>& sites_;
  int first_;
  std::vector<Tangential_motion> motions_;
  Density density_;
  Thread_policy threads_;
  Surface_cvt_energy_3 energy_;
  std::vector<double> densities_;
  Evaluation current_, other_;    // on trial, `other_` is that of the accepted point
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_SURFACE_CVT_OBJECTIVE_3_H
