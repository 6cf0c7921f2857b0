// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_SLIVER_STEPS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_SLIVER_STEPS_H

#include <array>

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

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_SLIVER_STEPS_H
