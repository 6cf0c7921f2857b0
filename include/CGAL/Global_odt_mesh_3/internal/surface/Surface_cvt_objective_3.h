// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_SURFACE_CVT_OBJECTIVE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_SURFACE_CVT_OBJECTIVE_3_H

#include <CGAL/Global_odt_mesh_3/internal/optimization/Tangential_motion.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Surface_cvt_energy_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Surface_triangulation_3.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The energy of the centroidal Voronoi tessellation restricted to the surfaces, as a function
// of the coordinates of the vertices that move on them, in the form that the minimizer wants.
//
// Section 5.1 of the paper restricts Voronoi cells to the input surface. Here it is to the
// surfaces of the complex, which follow the vertices: their tangential planes
// touch the input surface in second order, and cells need not be clipped.
class Surface_cvt_objective_3
{
public:
  // The density at a vertex, given its number and position; none: one.
  typedef std::function<double(int, const Site&)> Density;

  // `motions` are those of the vertices from number `first` on.
  Surface_cvt_objective_3(const Boundary_complex_3& boundary, std::vector<Site>& sites, int first,
                          std::vector<Tangential_motion> motions, Density density = Density())
    : surface_(boundary)
    , sites_(sites)
    , first_(first)
    , motions_(std::move(motions))
    , density_(std::move(density))
    , densities_(sites.size(), 1)
    , point_(3 * motions_.size())
    , gradient_(point_.size())
    , diagonal_(point_.size())
  {
    if(density_)
      for(int f = 0; f < surface_.number_of_facets(); ++f)
        for(int v : surface_.vertices(f))
          densities_[v] = density_(v, sites_[v]);
    compute();
    accept();
  }

  double value() const { return energy_; }
  const Eigen::VectorXd& point() const { return point_; }
  const Eigen::VectorXd& gradient() const { return gradient_; }
  const Eigen::VectorXd& diagonal() const { return diagonal_; }
  const Surface_triangulation_3& surface() const { return surface_; }

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
    compute();
    return std::isfinite(energy_);
  }

  void accept()
  {
    kept_.surface = surface_;
    kept_.energy = energy_;
    kept_.point = point_;
    kept_.gradient = gradient_;
    kept_.diagonal = diagonal_;
  }

  void reject()
  {
    surface_ = kept_.surface;
    energy_ = kept_.energy;
    point_ = kept_.point;
    gradient_ = kept_.gradient;
    diagonal_ = kept_.diagonal;
    for(std::size_t n = 0; n < motions_.size(); ++n)
    {
      Site& s = sites_[first_ + n];
      s = { point_[3 * n], point_[3 * n + 1], point_[3 * n + 2], s.weight };
    }
  }

private:
  void compute()
  {
    surface_.make_delaunay(sites_);
    energy_ = 0;
    gradient_.setZero();
    diagonal_.setZero();
    const int last = first_ + static_cast<int>(motions_.size());
    for(int f = 0; f < surface_.number_of_facets(); ++f)
    {
      const std::array<int, 3>& t = surface_.vertices(f);
      const Surface_cvt_contribution_3 c(t, sites_, {{ densities_[t[0]], densities_[t[1]], densities_[t[2]] }});
      energy_ += c.energy;
      for(int k = 0; k < 3; ++k)
        if(t[k] >= first_ && t[k] < last)
        {
          gradient_.segment<3>(3 * (t[k] - first_)) += c.gradient[k];
          diagonal_.segment<3>(3 * (t[k] - first_)).array() += 2 * c.mass[k];
        }
    }
    for(std::size_t n = 0; n < motions_.size(); ++n)
    {
      const Site& s = sites_[first_ + n];
      point_.segment<3>(3 * n) << s.x, s.y, s.z;
      if(motions_[n].is_at_rest())
        gradient_.segment<3>(3 * n).setZero();
      else
        gradient_.segment<3>(3 * n) = motions_[n].tangential_part(gradient_.segment<3>(3 * n));
      // Cells may be empty where weights are large.
      if(!(diagonal_[3 * n] > 0))
        diagonal_.segment<3>(3 * n).setConstant((std::numeric_limits<double>::max)());
    }
  }

  struct State
  {
    Surface_triangulation_3 surface;
    double energy = 0;
    Eigen::VectorXd point, gradient, diagonal;
  };

  Surface_triangulation_3 surface_;
  std::vector<Site>& sites_;
  int first_;
  std::vector<Tangential_motion> motions_;
  Density density_;
  std::vector<double> densities_;
  double energy_ = 0;
  Eigen::VectorXd point_, gradient_, diagonal_;
  State kept_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_SURFACE_CVT_OBJECTIVE_3_H
