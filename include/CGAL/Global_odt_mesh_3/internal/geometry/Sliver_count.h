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

// Of some cells: what they lack at a step, the smallest of the angles that lack something, and how many cells are below
// each step before.
struct Sliver_count
{
  double deficit = 0, smallest = 90;        // square degrees, degrees
  std::array<int, Sliver_steps::number> below = {};

  bool is_not_worse_than(const Sliver_count& other, int step) const
  {
    return smallest >= other.smallest
           && std::equal(below.begin(), below.begin() + step, other.below.begin(), std::less_equal<int>());
  }

  void add(const std::array<Site, 4>& cell, const Angle_deficit_3& angle_deficit, int step)
  {
    double most = 0;
    angle_deficit.for_each_lack(cell, [&](double lack)
    {
      deficit += lack * lack;
      most = (std::max)(most, lack);
    });
    if(!(most > 0))
      return;
    const double angle = angle_deficit.bound() - most;
    smallest = (std::min)(smallest, angle);
    for(int n = 0; n < step; ++n)
      below[n] += angle < Sliver_steps::angles[n];
  }
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_SLIVER_COUNT_H
