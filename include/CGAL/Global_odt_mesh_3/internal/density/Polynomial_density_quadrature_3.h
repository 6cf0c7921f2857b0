// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_POLYNOMIAL_DENSITY_QUADRATURE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_POLYNOMIAL_DENSITY_QUADRATURE_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Parameter_check.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Quadratic_polynomial_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The moments of the density that is interpolated linearly between the vertices, where it is asked once for
// each position.
class Linear_density_quadrature_3 final
  : public Density_quadrature_3
{
public:
  // The density may be asked for several vertices at once if it is safe for threads.
  Linear_density_quadrature_3(Density density, const std::vector<Site>& sites, bool is_safe_for_threads = false)
    : density_(std::move(density))
    , is_safe_for_threads_(is_safe_for_threads)
  {
    values_.reserve(sites.size());
    for(std::size_t v = 0; v < sites.size(); ++v)
      values_.push_back(density_(static_cast<int>(v), sites[v]));
    kept_values_ = values_;
  }

  // Takes the values at vertices.
  Linear_density_quadrature_3(Density density, std::vector<double> values)
    : density_(std::move(density))
    , values_(std::move(values))
    , kept_values_(values_)
  {}

  // The values at vertices.
  const std::vector<double>& values() const { return values_; }

  // The same for loops over cells: the compiler need not fear that what they write alters where the values are.
  class View
  {
  public:
    explicit View(const double* values) : values_(values) {}

    const View* operator->() const { return this; }

    Density_moments_3 moments(int, const int* v, const Site*) const
    {
      return linear_density_moments({{ values_[v[0]], values_[v[1]], values_[v[2]], values_[v[3]] }});
    }

  private:
    const double* values_;
  };

  View view() const { return View(values_.data()); }

  Density_moments_3 moments(int cell, const int* v, const Site* s) override { return view().moments(cell, v, s); }

  void update(const std::vector<Site>& sites, int number_of_movable_vertices, const Thread_policy& threads) override
  {
    CGAL_assertion(sites.size() == values_.size());
    for_each_in_chunks(number_of_movable_vertices, is_safe_for_threads_ ? threads : Thread_policy(),
                       [&](int v) { values_[v] = density_(v, sites[v]); });
  }

  std::unique_ptr<Density_quadrature_3> part(const std::vector<int>& vertices) const override
  {
    std::vector<double> values;
    for(int v : vertices)
      values.push_back(values_[v]);
    return std::make_unique<Linear_density_quadrature_3>(renumbered(density_, vertices), std::move(values));
  }

  void keep() override { kept_values_ = values_; }
  void restore() override { values_ = kept_values_; }

  double energy_tolerance() const override { return tolerance_of_rough_moments; }

private:
  Density density_;
  bool is_safe_for_threads_ = false;
  std::vector<double> values_, kept_values_;
};

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

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_POLYNOMIAL_DENSITY_QUADRATURE_3_H
