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

// What a cell lacks of a goal, in square degrees, and its smallest angle or, if all are above goal and steps, something above these.
struct Cell_lack
{
  double deficit = 0, smallest = 90;
};

// The same of some cells, and how many of them are below each of some steps.
struct Sliver_count
{
  double deficit = 0, smallest = 90;
  std::array<int, Sliver_steps::number> below = {};

  bool is_not_worse_than(const Sliver_count& other, int steps) const
  {
    return smallest >= other.smallest
           && std::equal(below.begin(), below.begin() + steps, other.below.begin(), std::less_equal<int>());
  }

  void add(const Cell_lack& cell, int steps)
  {
    deficit += cell.deficit;
    smallest = (std::min)(smallest, cell.smallest);
    for(int n = 0; n < steps; ++n)
      below[n] += cell.smallest < Sliver_steps::angles[n];
  }
};

// The dihedral angle, in degrees, that cells should reach, and the number of steps of which none may get more cells below it.
class Sliver_goal
{
public:
  Sliver_goal(double bound, int steps)
    : steps_(steps)
    , wanted_(bound + margin)
    , highest_((std::max)(bound + margin, steps > 0 ? Sliver_steps::angles[steps - 1] : 0.))
  {}

  int steps() const { return steps_; }
  const Angle_deficit_3& wanted() const { return wanted_; }

  Cell_lack lack(const std::array<Site, 4>& cell) const
  {
    Cell_lack result;
    highest_.for_each_lack(cell, [&](double below_highest)
    {
      const double angle = highest_.bound() - below_highest, missing = (std::max)(0., wanted_.bound() - angle);
      result.deficit += missing * missing;
      result.smallest = (std::min)(result.smallest, angle);
    });
    return result;
  }

private:
  static constexpr double margin = 2;           // by which steps are to be exceeded: cells just below a step hold each other there

  int steps_;
  Angle_deficit_3 wanted_, highest_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_SLIVER_STEPS_H
