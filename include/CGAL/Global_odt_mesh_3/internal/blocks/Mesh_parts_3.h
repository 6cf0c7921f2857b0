// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_BLOCKS_MESH_PARTS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_BLOCKS_MESH_PARTS_3_H

#include <CGAL/Global_odt_mesh_3/internal/blocks/Space_partition_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/For_each_in_chunks.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The vertices of a mesh in parts that threads may change at the same time, where they are. Cells with all vertices in one
// part belong to it; the others belong to none and stay, and with them their vertices. So no part sees anything of
// another that changes.
class Mesh_parts_3
{
public:
  static constexpr int none = -1;

  Mesh_parts_3(const Constrained_triangulation_3& mesh, int number_of_parts, Random_source random, const Thread_policy& threads)
    : part_of_vertex_(mesh.sites.size())
  {
    const Space_partition_3 space(mesh, number_of_parts, random);
    for_each_in_chunks(static_cast<int>(mesh.sites.size()), threads,
                       [&](int v) { part_of_vertex_[v] = space.block(position(mesh.sites[v])); });
  }

  // Of a cell with these vertices.
  int part(const std::array<int, 4>& cell) const
  {
    const int first = part_of_vertex_[cell[0]];
    return std::all_of(cell.begin() + 1, cell.end(), [&](int v) { return part_of_vertex_[v] == first; }) ? first : int(none);
  }

private:
  std::vector<int> part_of_vertex_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_BLOCKS_MESH_PARTS_3_H
