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

#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Surface_cvt_energy_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Surface_triangulation_3.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The energy of the restricted CVT of the surfaces as a term of another energy, that of the cells.
//
// The densities of both are such that the ratio of their Hessians' diagonals does not depend on the local
// size. The factor on the term is one for all vertices and for good: with it, the diagonals are, summed up over all
// vertices where the term is evaluated first, in the ratio of `weight`. So the fewer vertices the interior has to
// make up for it, the less the term pulls at each.
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

  // The same for a part of the mesh, when the scale is known. The part has some of the vertices, named by their
  // numbers, of which as many from `first` on move on the surfaces; `number` gives the numbers in the part. Its facets
  // are those of the mesh, whatever the energy has been asked for before.
  template <class Number>
  Surface_cvt_term_3 part(const std::vector<int>& vertices, int first, int number_of_moving, const Number& number) const
  {
    const auto begin = vertices.begin() + first;
    Surface_density density;
    if(density_)
      density = [this, &vertices](int v, const Site& s) { return density_(vertices[v], s); };
    Surface_cvt_term_3 part(first, number_of_moving, weight_, density);
    part.factor_ = factor_;
    part.delaunay_ = surface_.part(std::vector<int>(begin, begin + number_of_moving), corner_of_vertex_, number);
    for(int v : vertices)
      if(density_)
        part.densities_.push_back(densities_[v]);
    return part;
  }

  // Whether it is known how much the term weighs, which depends on where the energy is asked for first.
  bool has_scale() const { return factor_ >= 0; }

  // To be called before parts are made for these sites.
  void prepare_parts(const std::vector<Site>& sites)
  {
    update_densities(sites);
    corner_of_vertex_ = surface_.corners_of_vertices(sites.size());
  }

  // Adds gradient and diagonal to those of all vertices, and gives the energy.
  double operator()(const std::vector<Site>& sites, Eigen::VectorXd& gradient, Eigen::VectorXd& diagonal)
  {
    update_densities(sites);
    delaunay_.make_delaunay(sites, threads_);
    const double energy = energy_.compute(delaunay_, sites, densities_, first_, gradient_, diagonal_);
    // Cells may be empty where weights are large.
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
  Surface_triangulation_3 surface_, delaunay_;      // as they are, and with edges flipped to where the energy is asked for
  std::vector<double> densities_;
  std::vector<int> corner_of_vertex_;
  Eigen::VectorXd gradient_, diagonal_;
};

// The energy of the centroidal Voronoi tessellation restricted to the surfaces, as a function
// of the coordinates of the vertices that move on them, in the form that the minimizer wants.
//
// Section 5.1 of the paper restricts Voronoi cells to the input surface. Here it is to the
// surfaces of the complex, which follow the vertices: their tangential planes
// touch the input surface in second order, and cells need not be clipped.
//
// Points are current or on trial as those of Odt_objective_3 are.
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
      e.point.segment<3>(3 * n) << s.x, s.y, s.z;
      if(motions_[n].is_at_rest())
        e.gradient.segment<3>(3 * n).setZero();
      else
        e.gradient.segment<3>(3 * n) = motions_[n].tangential_part(e.gradient.segment<3>(3 * n));
      // Cells may be empty where weights are large.
      if(!(e.diagonal[3 * n] > 0))
        e.diagonal.segment<3>(3 * n).setConstant((std::numeric_limits<double>::max)());
    }
  }

  std::vector<Site>& sites_;
  int first_;
  std::vector<Tangential_motion> motions_;
  Density density_;
  Thread_policy threads_;
  Surface_cvt_energy_3 energy_;
  std::vector<double> densities_;
  Evaluation current_, other_;    // that of the current point is the other one on trial
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_SURFACE_CVT_OBJECTIVE_3_H
