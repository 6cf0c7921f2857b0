// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_QUADRATIC_DENSITY_QUADRATURE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_QUADRATIC_DENSITY_QUADRATURE_3_H

#include <CGAL/Global_odt_mesh_3/internal/Parameter_check.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Quadratic_polynomial_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>


#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The exact moments of a quadratic density, which in barycentric coordinates is the sum of
// p(x_k, x_l) lambda_k lambda_l, p being its polar form.
class Quadratic_density_quadrature_3
  : public Density_quadrature_3
{
public:
  explicit Quadratic_density_quadrature_3(const Quadratic_polynomial_3& density)
    : density_(density)
  {}

  Density_moments_3 moments(int, const int* v, const Site* s) override
  {
    std::array<double, 4> vertices;
    for(int i = 0; i < 4; ++i)
      vertices[i] = density_(s[v[i]]);
    std::array<double, 6> edges;
    for(int e = 0; e < 6; ++e)
      edges[e] = density_.polar(s[v[Density_moments_3::edges[e][0]]], s[v[Density_moments_3::edges[e][1]]]);
    const Density_moments_3 m = quadratic_density_moments(vertices, edges);
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(*std::min_element(m.first.begin(), m.first.end()) > 0, "density must be positive");
    return m;
  }

  std::unique_ptr<Density_quadrature_3> part(const std::vector<int>&) const override
  {
    return std::make_unique<Quadratic_density_quadrature_3>(density_);
  }

private:
  Quadratic_polynomial_3 density_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_QUADRATIC_DENSITY_QUADRATURE_3_H
