// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_FIELD_DENSITY_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_FIELD_DENSITY_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Parameter_check.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Quadratic_polynomial_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/User_field_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The density of E^rho and that of the restricted CVT of surfaces.
//
// The minimizer of E^rho equidistributes the integral of rho^(3/5), that is, rho = 1/size^5
// (section 5.2 of the paper). On surfaces, in two dimensions, that is 1/size^4.
class Density_3
{
public:
  static double volume_density(double size) { return 1 / (size * size * size * size * size); }
  static double size_of_density(double volume_density) { return std::pow(volume_density, -1 / 5.); }
  static double surface_density(double size) { return 1 / (size * size * size * size); }

  virtual ~Density_3() {}

  // Whether it is one everywhere.
  virtual bool is_uniform() const = 0;

  // Whether several threads may ask at the same time, for different vertices.
  virtual bool is_safe_for_threads() const { return false; }

  // The density at the position of a vertex, given its number. The scale is such that the median of the vertices has a
  // density of about one.
  virtual double in_volume(int v, const Site& s) = 0;
  virtual double on_surface(int v, const Site& s) = 0;

  // The density at a point of a cell around the vertex.
  virtual double in_cell(int v, const Site& s) { return in_volume(v, s); }

  // The density in the volume if it is a polynomial, which can be integrated exactly, or null.
  virtual const Quadratic_polynomial_3* polynomial() const { return nullptr; }
};

// The density that the user gives, or that of the sizes that the user gives.
class Field_density_3
  : public Density_3
{
public:
  // Whether the field gives sizes or densities.
  typedef User_field_3::Meaning Meaning;
  static constexpr Meaning SIZE = User_field_3::SIZE, DENSITY = User_field_3::DENSITY;

  typedef std::function<double(int, const Site&)> Field;         // at the position of a vertex, given its number

  // `sites` are those of the vertices where the field is measured. A density that is a
  // polynomial may be zero at points: its integrals are not.
  Field_density_3(Meaning meaning, Field field, const std::vector<Site>& sites,
                  const std::optional<Quadratic_polynomial_3>& polynomial = std::nullopt)
    : meaning_(meaning)
    , field_(std::move(field))
    , polynomial_(polynomial)
  {
    std::vector<double> values;
    values.reserve(sites.size());
    for(std::size_t v = 0; v < sites.size(); ++v)
      values.push_back(value(static_cast<int>(v), sites[v]));
    if(values.empty())
      return;
    const auto median = values.begin() + values.size() / 2;
    std::nth_element(values.begin(), median, values.end());
    unit_ = *median;
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(unit_ > 0, "density must not be zero at half of the vertices");
    if(polynomial_)
      *polynomial_ *= 1 / unit_;
    is_uniform_ = std::all_of(values.begin(), values.end(), [this](double x) { return x == unit_; });
  }

  // What a field may say at a point.
  static void check(Meaning meaning, bool may_be_zero, const Site& s, double value)
  {
    const bool is_good = std::isfinite(value) && (value > 0 || (may_be_zero && value == 0));
    if(is_good)
      return;
    std::ostringstream message;
    message << (meaning == SIZE ? "sizing_field" : "density") << " must be positive and finite: at (" << s.x << ", " << s.y << ", " << s.z
            << ") it is " << value;
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(is_good, message.str().c_str());
  }

  bool is_uniform() const override { return is_uniform_; }

  // The density, as the field means it, that is called one.
  double unit_density() const { return meaning_ == SIZE ? volume_density(unit_) : unit_; }

  double in_volume(int v, const Site& s) override
  {
    const double x = value(v, s) / unit_;
    return meaning_ == SIZE ? volume_density(x) : x;
  }

  double on_surface(int v, const Site& s) override
  {
    // The size that a density stands for is its power of -1/5.
    const double x = value(v, s) / unit_;
    return meaning_ == SIZE ? surface_density(x) : std::pow(x, 4. / 5);
  }

  const Quadratic_polynomial_3* polynomial() const override { return polynomial_ ? &*polynomial_ : nullptr; }

private:
  double value(int v, const Site& s) const
  {
    const double x = field_(v, s);
    check(meaning_, polynomial_.has_value(), s, x);
    return x;
  }

  Meaning meaning_;
  Field field_;
  std::optional<Quadratic_polynomial_3> polynomial_;
  double unit_ = 1;
  bool is_uniform_ = true;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_FIELD_DENSITY_3_H
