// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_SLIVER_COUNT_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_SLIVER_COUNT_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Sliver_steps.h>

#include <algorithm>
#include <array>
#include <functional>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Of some cells: what they lack at a bound, the smallest of their angles, and how many cells are below each of some
// steps.
struct Sliver_count
{
  double deficit = 0, smallest = 90;        // square degrees, degrees
  std::array<int, Sliver_steps::number> below = {};

  bool is_not_worse_than(const Sliver_count& other, int steps) const
  {
    return smallest >= other.smallest
           && std::equal(below.begin(), below.begin() + steps, other.below.begin(), std::less_equal<int>());
  }

  // `highest` has the highest of the bound and the steps; the angles above it do not count.
  void add(const std::array<Site, 4>& cell, const Angle_deficit_3& highest, double bound, int steps)
  {
    double angle = highest.bound();
    highest.for_each_lack(cell, [&](double lack)
    {
      const double a = highest.bound() - lack, missing = (std::max)(0., bound - a);
      deficit += missing * missing;
      angle = (std::min)(angle, a);
    });
    smallest = (std::min)(smallest, angle);
    for(int n = 0; n < steps; ++n)
      below[n] += angle < Sliver_steps::angles[n];
  }
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_SLIVER_COUNT_H
