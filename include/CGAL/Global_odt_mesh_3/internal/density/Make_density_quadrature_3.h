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
#include <limits>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

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
    Kept& kept = kept_[cell];
    bool is_known = true;
    for(int i = 0; i < 4; ++i)
    {
      const Site& s = sites[vertices[i]];
      std::array<double, 3>& p = kept.points[i];
      // NaN, at first, is not equal to anything.
      is_known = is_known && p[0] == s.x && p[1] == s.y && p[2] == s.z;
      p = {{ s.x, s.y, s.z }};
    }
    if(!is_known)
    {
      // Not to be believed if the density throws.
      kept.points[0][0] = std::numeric_limits<double>::quiet_NaN();
      kept.moments = quadrature_->moments(cell, vertices, sites);
      kept.points[0][0] = sites[vertices[0]].x;
      ++number_of_quadratures_;
    }
    return kept.moments;
  }

  std::unique_ptr<Density_quadrature_3> part(const std::vector<int>& vertices) const override
  {
    return std::make_unique<Density_moment_cache_3>(quadrature_->part(vertices));
  }

  double energy_tolerance() const override { return quadrature_->energy_tolerance(); }

  std::size_t number_of_quadratures() const { return number_of_quadratures_; }

private:
  struct Kept
  {
    std::array<std::array<double, 3>, 4> points
      = {{ {{ std::numeric_limits<double>::quiet_NaN(), 0, 0 }}, {}, {}, {} }};
    Density_moments_3 moments;
  };

  std::unique_ptr<Density_quadrature_3> quadrature_;
  std::vector<Kept> kept_;
  std::size_t number_of_quadratures_ = 0;
};

// Without a word of the caller, the linear rule, or exact integrals where the density allows them.
typedef std::variant<std::monostate, Linear_density_rule_3, Four_point_rule_3, Fifteen_point_rule_3, Adaptive_cubature_3>
  Quadrature_choice;

inline void check(const Quadrature_choice& choice)
{
  if(const auto* cubature = std::get_if<Adaptive_cubature_3>(&choice))
    cubature->check();
}

// The quadrature that the caller has chosen, for a mesh with vertices there; null if that is to say that the
// density is one. It refers to the density.
inline std::unique_ptr<Density_quadrature_3> make_density_quadrature_3(const Quadrature_choice& choice, Density_3& rho,
                                                                       const std::vector<Site>& sites)
{
  if(std::holds_alternative<std::monostate>(choice) && rho.polynomial() != nullptr)
    return std::make_unique<Quadratic_density_quadrature_3>(*rho.polynomial());
  const Density_quadrature_3::Density density = [&rho](int v, const Site& s) { return rho.in_cell(v, s); };
  std::unique_ptr<Density_quadrature_3> quadrature;
  if(std::holds_alternative<Four_point_rule_3>(choice))
    quadrature = std::make_unique<Point_rule_quadrature_3>(Point_rule_quadrature_3::four_points(), density);
  else if(std::holds_alternative<Fifteen_point_rule_3>(choice))
    quadrature = std::make_unique<Point_rule_quadrature_3>(Point_rule_quadrature_3::fifteen_points(), density);
  else if(const auto* cubature = std::get_if<Adaptive_cubature_3>(&choice))
    quadrature = std::make_unique<Adaptive_cubature_quadrature_3>(density, cubature->tolerance,
                                                                  cubature->most_regions);
  if(quadrature != nullptr)
    return std::make_unique<Density_moment_cache_3>(std::move(quadrature));
  if(rho.is_uniform())
    return nullptr;
  return std::make_unique<Linear_density_quadrature_3>([&rho](int v, const Site& s) { return rho.in_volume(v, s); }, sites,
                                                       rho.is_safe_for_threads());
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_MAKE_DENSITY_QUADRATURE_3_H
