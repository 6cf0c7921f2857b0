// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_REMOVAL_PARAMETERS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_REMOVAL_PARAMETERS_H

#include <cstddef>
#include <limits>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Of Sliver_removal_3 and Sliver_improvement_3.
struct Sliver_removal_parameters
{
  double margin = 0.5;              // degrees by which cells should exceed the bound: surfaces may take some away
  int tries_per_vertex = 8;
  double farthest = 0.35, nearest = 0.12;   // the longest tries, over the mean incident edge length, near ones first
  int most_failures = 3;            // for the same cell
  int most_passes = 12;
  double joint_farthest = 0.2;                // the longest of a vertex, over the same
  int joint_tries_per_sliver = 2, most_joint_tries = 20, passes_after_joint_try = 5;
  int vertices_of_part = 5000, partitions = 3;    // how large parts are, and how often others are made
  int free_cells_of_part = 500;                   // by which it may get larger
  std::size_t most_tries = (std::numeric_limits<std::size_t>::max)();     // of single vertices, which are what takes time
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_REMOVAL_PARAMETERS_H
