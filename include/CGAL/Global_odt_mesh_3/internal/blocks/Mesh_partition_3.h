// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_BLOCKS_MESH_PARTITION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_BLOCKS_MESH_PARTITION_3_H

#include <CGAL/Global_odt_mesh_3/internal/blocks/Space_partition_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Buckets.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/For_each_in_chunks.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The cells of a mesh in the blocks of a partition of space, by their centroids.
class Mesh_partition_3
{
public:
  Mesh_partition_3(const Constrained_triangulation_3& mesh, int number_of_blocks, Random_source random,
                   const Thread_policy& threads)
  {
    const Space_partition_3 space(mesh, number_of_blocks, random);
    const int cells = mesh.topology.number_of_cell_slots();
    std::vector<int> block(cells), place(mesh.sites.size());
    for_each_in_chunks(static_cast<int>(place.size()), threads, [&](int v) { place[v] = space.block(position(mesh.sites[v])); });
    // 0 for no block yet.
    std::vector<std::atomic<int> > block_of_vertex(mesh.sites.size());
    for_each_in_chunks(cells, threads, [&](int c)
    {
      block[c] = mesh.topology.is_alive(c) ? block_of_cell(mesh, c, space, place) : int(no_block);
      for(int i = 0; i < 4 && block[c] >= 0; ++i)
        join(block_of_vertex[mesh.topology.vertices(c)[i]], block[c] + 1);
    });
    cells_ = Buckets(cells, number_of_blocks, [&block](int c) { return block[c]; }, threads);
    vertices_ = Buckets(static_cast<int>(mesh.sites.size()), number_of_blocks,
                        [&](int v) { return block_of_vertex[v].load(std::memory_order_relaxed) - 1; }, threads);
  }

  int number_of_blocks() const { return cells_.number_of_buckets(); }
  const Buckets& cells() const { return cells_; }
  // Those with all their cells in one block.
  const Buckets& vertices() const { return vertices_; }

  // The blocks, so that threads that take one after the other end at about the same time.
  std::vector<int> largest_first() const
  {
    std::vector<int> order(number_of_blocks());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [this](int a, int b) { return cells_.size(a) > cells_.size(b); });
    return order;
  }

private:
  static constexpr int no_block = -1, several_blocks = -1;

  // Blocks are convex, so that a cell with all vertices in one has its centroid there.
  static int block_of_cell(const Constrained_triangulation_3& mesh, int cell, const Space_partition_3& space,
                           const std::vector<int>& place_of_vertex)
  {
    const int* const v = mesh.topology.vertices(cell);
    const int first = place_of_vertex[v[0]];
    return std::all_of(v + 1, v + 4, [&](int w) { return place_of_vertex[w] == first; }) ? first
                                                                                         : space.block(centroid(mesh, cell));
  }

  static Eigen::Vector3d centroid(const Constrained_triangulation_3& mesh, int cell)
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for(int v : mesh.topology.cell(cell))
      sum += position(mesh.sites[v]);
    return 0.25 * sum;
  }

  // In whatever order cells come, the result is the same.
  static void join(std::atomic<int>& of_vertex, int block)
  {
    int before = of_vertex.load(std::memory_order_relaxed);
    if(before == block || before == several_blocks)
      return;
    before = 0;
    if(!of_vertex.compare_exchange_strong(before, block, std::memory_order_relaxed) && before != block)
      of_vertex.store(several_blocks, std::memory_order_relaxed);
  }

  Buckets cells_, vertices_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_BLOCKS_MESH_PARTITION_3_H
