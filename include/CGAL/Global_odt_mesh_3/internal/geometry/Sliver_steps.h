// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_SLIVER_STEPS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_SLIVER_STEPS_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <algorithm>
#include <array>
#include <functional>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The dihedral angles, in degrees, that the removal of slivers goes for one after the other. As they do not depend
// on the bound that is wanted, a higher bound goes the way of a lower one, and then on.
struct Sliver_steps
{
  static constexpr int number = 10;
  static constexpr std::array<double, number> angles = {{ 10, 20, 30, 35, 40, 45, 50, 55, 60, 70.5 }};

  // The first that is not below 20 degrees nor the bound; that of 0, which stands for as much as can be had, is the
  // last of all.
  static int last(double bound)
  {
    int n = 1;
    while(n + 1 < number && (!(bound > 0) || angles[n] < bound))
      ++n;
    return n;
  }
};

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

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_SLIVER_STEPS_H
