// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_FLAT_MESH_OUTCOME_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_FLAT_MESH_OUTCOME_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_shape_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cstddef>

constexpr std::array<double, 4> angles_counted = {{ 10, 13, 15, 20 }};

// What a method has made of a mesh, and in which time.
struct Outcome
{
  double energy, time, mean_radius_ratio = 0, smallest_angle = 180, largest_angle = 0;
  std::array<int, 4> cells_below = {{ 0, 0, 0, 0 }};
};

inline Outcome outcome(const CGAL::Global_odt_mesh_3::internal::Moving_triangulation_3& mesh, double time)
{
  Outcome o;
  o.energy = mesh.energy();
  o.time = time;
  for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
  {
    if(!mesh.topology.is_alive(c))
      continue;
    const int* const v = mesh.topology.vertices(c);
    const CGAL::Global_odt_mesh_3::internal::Cell_shape_3 shape(mesh.sites[v[0]], mesh.sites[v[1]], mesh.sites[v[2]], mesh.sites[v[3]]);
    const auto angles = std::minmax_element(shape.angles.begin(), shape.angles.end());
    o.mean_radius_ratio += shape.radius_ratio / mesh.topology.number_of_cells();
    o.smallest_angle = (std::min)(o.smallest_angle, *angles.first);
    o.largest_angle = (std::max)(o.largest_angle, *angles.second);
    for(std::size_t n = 0; n < angles_counted.size(); ++n)
      o.cells_below[n] += *angles.first < angles_counted[n];
  }
  return o;
}

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_FLAT_MESH_OUTCOME_H
