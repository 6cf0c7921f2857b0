// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_CELL_ANGLES_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_CELL_ANGLES_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// How many cells of a mesh have a dihedral angle below each step that the removal of slivers climbs.
struct Cell_angles
{
  static constexpr int number_of_steps = 10;
  static constexpr std::array<double, number_of_steps> steps = {{ 20, 30, 35, 40, 45, 50, 55, 60, 65, 70.5 }};

  double smallest = 90;
  std::array<std::size_t, number_of_steps> below = {};
  std::array<double, number_of_steps> deficit = {};     // square degrees

  Cell_angles() {}

  explicit Cell_angles(const Constrained_triangulation_3& mesh)
  {
    const Angle_deficit_3 highest(steps.back());
    for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
      if(mesh.topology.is_alive(c))
        add(mesh.cell_sites(c), highest);
  }

  // Whether more of what the step asks for is reached, and no less of what the steps before do.
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
  void add(const std::array<Site, 4>& cell, const Angle_deficit_3& highest)
  {
    double angle = steps.back();
    highest.for_each_lack(cell, [&](double lack)
    {
      const double a = steps.back() - lack;
      angle = (std::min)(angle, a);
      for(int s = 0; s < number_of_steps; ++s)
        if(a < steps[s])
          deficit[s] += (steps[s] - a) * (steps[s] - a);
    });
    smallest = (std::min)(smallest, angle);
    for(int s = 0; s < number_of_steps; ++s)
      below[s] += angle < steps[s];
  }
};

// The smallest dihedral angle around each vertex.
inline std::vector<double> smallest_angles_at_vertices(const Constrained_triangulation_3& mesh)
{
  const double most = Cell_angles::steps.back();
  const Angle_deficit_3 angle_deficit(most);
  std::vector<double> smallest(mesh.sites.size(), most);
  for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
    if(mesh.topology.is_alive(c))
      angle_deficit.for_each_lack(mesh.cell_sites(c), [&](double lack)
      {
        for(int i = 0; i < 4; ++i)
        {
          double& angle = smallest[mesh.topology.vertices(c)[i]];
          angle = (std::min)(angle, most - lack);
        }
      });
  return smallest;
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_CELL_ANGLES_H
