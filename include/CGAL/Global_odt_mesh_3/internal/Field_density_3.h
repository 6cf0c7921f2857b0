// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_FIELD_DENSITY_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_FIELD_DENSITY_3_H

#include <CGAL/Global_odt_mesh_3/internal/Density_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Odt_energy_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The density that the user gives, or that of the sizes that the user gives.
class Field_density_3
  : public Density_3
{
public:
  enum Meaning { SIZE, DENSITY };

  // At the position of a vertex, given its number.
  typedef std::function<double(int, const Site&)> Field;

  // `sites` are those of the vertices where the field is measured.
  Field_density_3(Meaning meaning, Field field, const std::vector<Site>& sites)
    : meaning_(meaning)
    , field_(std::move(field))
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
    is_uniform_ = std::all_of(values.begin(), values.end(), [this](double x) { return x == unit_; });
  }

  bool is_uniform() const override { return is_uniform_; }

  double in_volume(int v, const Site& s) override
  {
    const double x = value(v, s) / unit_;
    return meaning_ == SIZE ? std::pow(x, -exponent) : x;
  }

  double on_surface(int v, const Site& s) override
  {
    return std::pow(value(v, s) / unit_, meaning_ == SIZE ? -surface_exponent : surface_exponent / exponent);
  }

private:
  double value(int v, const Site& s) const
  {
    const double x = field_(v, s);
    CGAL_precondition_msg(x > 0 && std::isfinite(x), meaning_ == SIZE ? "sizing_field must be positive and finite"
                                                                      : "density must be positive and finite");
    return x;
  }

  Meaning meaning_;
  Field field_;
  double unit_ = 1;
  bool is_uniform_ = true;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_FIELD_DENSITY_3_H
