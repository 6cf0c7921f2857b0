// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_MAKE_DENSITY_QUADRATURE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_MAKE_DENSITY_QUADRATURE_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/density/Adaptive_cubature_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Field_density_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Point_rule_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Polynomial_density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <CGAL/Density_quadratures_3.h>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Keeps the moments of cells whose vertices have not moved since they were last asked for.
class Density_moment_cache_3
  : public Density_quadrature_3
{
public:
  explicit Density_moment_cache_3(std::unique_ptr<Density_quadrature_3> quadrature)
    : quadrature_(std::move(quadrature))
  {}

  Density_moments_3 moments(int cell, const int* vertices, const Site* sites) override
  {
    if(kept_.size() <= static_cast<std::size_t>(cell))
      kept_.resize(cell + 1 + cell / 8);
    std::optional<Kept>& kept = kept_[cell];
    std::array<Vector_3, 4> points;
    for(int i = 0; i < 4; ++i)
      points[i] = position(sites[vertices[i]]);
    if(!kept || kept->points != points)
      kept = Kept{ points, quadrature_->moments(cell, vertices, sites) };
    return kept->moments;
  }

  std::unique_ptr<Density_quadrature_3> part(const std::vector<int>& vertices) const override
  {
    return std::make_unique<Density_moment_cache_3>(quadrature_->part(vertices));
  }

  double energy_tolerance() const override { return quadrature_->energy_tolerance(); }

private:
  struct Kept
  {
    std::array<Vector_3, 4> points;
    Density_moments_3 moments;
  };

  std::unique_ptr<Density_quadrature_3> quadrature_;
  std::vector<std::optional<Kept> > kept_;
};

// Makes a quadrature of a density for a mesh with vertices there; null if that is to say that the density is one. It refers to
// the density. As each rule has a maker of its own, programs that do not name a rule do not compile it.
typedef std::function<std::unique_ptr<Density_quadrature_3>(Density_3&, const std::vector<Site>&)> Quadrature_maker;

inline std::unique_ptr<Density_quadrature_3> make_linear_quadrature(Density_3& rho, const std::vector<Site>& sites)
{
  if(rho.is_uniform())
    return nullptr;
  return std::make_unique<Linear_density_quadrature_3>([&rho](int v, const Site& s) { return rho.in_volume(v, s); }, sites,
                                                       rho.is_safe_for_threads());
}

// The quadrature if the caller names none: the linear rule, or exact integrals if the density allows them.
inline std::unique_ptr<Density_quadrature_3> make_usual_quadrature(Density_3& rho, const std::vector<Site>& sites)
{
  if(rho.polynomial() != nullptr)
    return std::make_unique<Quadratic_density_quadrature_3>(*rho.polynomial());
  return make_linear_quadrature(rho, sites);
}

// Makes the quadrature of a rule that asks for the density at points of cells.
template <class Quadrature, class... Rule>
Quadrature_maker maker_with_cache(const Rule&... rule)
{
  return [=](Density_3& rho, const std::vector<Site>&)
  {
    const auto density = [&rho](int v, const Site& s) { return rho.in_cell(v, s); };
    return std::make_unique<Density_moment_cache_3>(std::make_unique<Quadrature>(density, rule...));
  };
}

inline Quadrature_maker quadrature_maker(const Linear_density_rule_3&) { return make_linear_quadrature; }

inline Quadrature_maker quadrature_maker(const Four_point_rule_3&)
{
  return maker_with_cache<Point_rule_quadrature_3>(Point_rule_quadrature_3::four_points());
}

inline Quadrature_maker quadrature_maker(const Fifteen_point_rule_3&)
{
  return maker_with_cache<Point_rule_quadrature_3>(Point_rule_quadrature_3::fifteen_points());
}

inline Quadrature_maker quadrature_maker(const Adaptive_cubature_3& cubature)
{
  cubature.check();
  return maker_with_cache<Adaptive_cubature_quadrature_3>(cubature.tolerance, cubature.most_regions);
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_MAKE_DENSITY_QUADRATURE_3_H
