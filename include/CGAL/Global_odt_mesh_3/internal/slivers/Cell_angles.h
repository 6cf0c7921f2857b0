// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_CELL_ANGLES_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_CELL_ANGLES_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Sliver_steps.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// How many cells of a mesh have a dihedral angle below each step that the removal of slivers climbs, up to a last one:
// angles above that are not looked at.
struct Cell_angles
{
  int last_step = -1;
  double smallest = 90;                                      // or something above the last step
  std::array<std::size_t, Sliver_steps::number> below = {};
  std::array<double, Sliver_steps::number> deficit = {};     // square degrees

  Cell_angles() {}

  Cell_angles(const Constrained_triangulation_3& mesh, int last, const Thread_policy& threads)
    : last_step(last)
  {
    const Chunks cells(mesh.topology.number_of_cell_slots(), 10000, 64);
    std::vector<Cell_angles> parts(cells.number(), *this);
    const Angle_deficit_3 highest(Sliver_steps::angles[last]);
    threads.for_each_chunk(cells.number(), [&](int n)
    {
      for(int c = cells.begin(n); c < cells.end(n); ++c)
        if(mesh.topology.is_alive(c))
          parts[n].add(mesh.cell_sites(c), highest);
    });
    for(const Cell_angles& part : parts)
      add(part);
  }

  // Whether more of what the step, which both know, asks for is reached, and no less of what the steps before do.
  bool is_better_than(const Cell_angles& other, int step) const
  {
    if(smallest < other.smallest || !(deficit[step] < other.deficit[step]))
      return false;
    for(int s = 0; s < step; ++s)
      if(below[s] > other.below[s])
        return false;
    return true;
  }

private:
  void add(const Cell_angles& other)
  {
    smallest = (std::min)(smallest, other.smallest);
    for(int s = 0; s < Sliver_steps::number; ++s)
    {
      below[s] += other.below[s];
      deficit[s] += other.deficit[s];
    }
  }

  void add(const std::array<Site, 4>& cell, const Angle_deficit_3& highest)
  {
    double angle = 90;
    highest.for_each_lack(cell, [&](double lack)
    {
      const double a = highest.bound() - lack;
      angle = (std::min)(angle, a);
      for(int s = 0; s <= last_step; ++s)
        if(a < Sliver_steps::angles[s])
          deficit[s] += (Sliver_steps::angles[s] - a) * (Sliver_steps::angles[s] - a);
    });
    smallest = (std::min)(smallest, angle);
    for(int s = 0; s <= last_step; ++s)
      below[s] += angle < Sliver_steps::angles[s];
  }
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_CELL_ANGLES_H
