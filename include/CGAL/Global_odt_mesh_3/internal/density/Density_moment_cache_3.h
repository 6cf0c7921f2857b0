// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_DENSITY_MOMENT_CACHE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_DENSITY_MOMENT_CACHE_3_H

#include <CGAL/Global_odt_mesh_3/internal/density/Density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
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

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_DENSITY_MOMENT_CACHE_3_H
