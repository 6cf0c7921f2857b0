// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_REGULARITY_FILTER_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_REGULARITY_FILTER_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_products_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// What rounded numbers prove of a cell: "no" means that exact ones have to be asked. Weights are
// left to those.
//
// With m the largest difference of coordinates, the determinant is a sum of 6 products of 3 differences, each rounded
// at most 8 times, and the power one of 72 products of 5 differences, each rounded at most 17 times. A rounding
// changes a product by at most 2^-52, in whatever direction numbers are rounded: that makes 6 * 8 * 2^-52 m^3
// and 72 * 17 * 2^-52 m^5, and the bounds leave something for terms of higher order.
class Regularity_filter_3
{
public:
  Regularity_filter_3(const Site& s0, const Site& s1, const Site& s2, const Site& s3)
    : origin_(s0)
    , products_(s0, s1, s2, s3)
    , is_weighted_(s0.weight != 0 || s1.weight != 0 || s2.weight != 0 || s3.weight != 0)
    , length_((std::max)({ largest(products_.ax, products_.ay, products_.az),
                           largest(products_.bx, products_.by, products_.bz),
                           largest(products_.cx, products_.cy, products_.cz) }))
  {}

  // Whether the cell is surely positive.
  bool is_positive() const
  {
    return is_in_range(length_) && products_.determinant > 1.1e-14 * length_ * length_ * length_;
  }

  // Whether the vertex is surely outside of the sphere of the cell, if that is positive.
  bool is_outside(const Site& s) const
  {
    const double m = (std::max)(length_, largest(s.x - origin_.x, s.y - origin_.y, s.z - origin_.z)), mm = m * m;
    return !is_weighted_ && s.weight == 0 && is_in_range(m) && products_.power(origin_, s) > 3e-13 * mm * mm * m;
  }

private:
  static double largest(double x, double y, double z)
  {
    return (std::max)({ std::abs(x), std::abs(y), std::abs(z) });
  }

  // Where nothing that matters is too small or too large for a double.
  static bool is_in_range(double length) { return 1e-50 < length && length < 1e50; }

  Site origin_;
  Cell_products products_;
  bool is_weighted_;
  double length_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_REGULARITY_FILTER_3_H
