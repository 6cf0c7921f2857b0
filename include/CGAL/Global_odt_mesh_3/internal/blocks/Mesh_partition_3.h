// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_BLOCKS_MESH_PARTITION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_BLOCKS_MESH_PARTITION_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Space in blocks with about as many vertices of a mesh each: a kd-tree in a random frame with random cuts, so that the
// seams of one partition are not those of another. It depends on the mesh and the random numbers alone.
class Space_partition_3
{
public:
  Space_partition_3(const Constrained_triangulation_3& mesh, int number_of_blocks, Random_source random)
  {
    choose_frame(random);
    std::vector<Vector_3> samples = sample(mesh, std::size_t(number_of_blocks) * samples_of_block);
    root_ = split(samples.begin(), samples.end(), number_of_blocks, random);
  }

  // The block of a point.
  int block(const Vector_3& point) const
  {
    const Vector_3 p = in_frame(point);
    int node = root_;
    while(node >= 0)
      node = nodes_[node].child[p[nodes_[node].axis] >= nodes_[node].cut];
    return ~node;
  }

private:
  static constexpr int samples_of_block = 200;
  static constexpr double spread_of_cuts = 0.1;     // around where the blocks would be of one size

  struct Node
  {
    int axis;
    double cut;
    std::array<int, 2> child;       // or ~block
  };

  typedef std::vector<Vector_3>::iterator Sample;

  void choose_frame(Random_source& random)
  {
    frame_[0] = random.direction();
    frame_[1] = frame_[0].cross(random.direction()).normalized();
    frame_[2] = frame_[0].cross(frame_[1]);
  }

  std::vector<Vector_3> sample(const Constrained_triangulation_3& mesh, std::size_t number) const
  {
    const std::size_t step = 1 + mesh.sites.size() / number;
    std::vector<Vector_3> points;
    for(std::size_t v = 0; v < mesh.sites.size(); v += step)
      if(mesh.topology.incident_cell(static_cast<int>(v)) >= 0)
        points.push_back(in_frame(position(mesh.sites[v])));
    return points;
  }

  // Gives the number of the node, or ~block.
  int split(Sample begin, Sample end, int blocks, Random_source& random)
  {
    if(blocks == 1)
      return ~number_of_leaves_++;
    const int first = (blocks + (random.uniform() < 0.5)) / 2;
    const double share = double(first) / blocks + spread_of_cuts * (2 * random.uniform() - 1);
    const Sample middle = begin + static_cast<std::ptrdiff_t>(share * double(end - begin));
    Node node = { 0, 0, {} };
    if(begin != end)
    {
      node.axis = longest_axis(begin, end);
      std::nth_element(begin, middle, end, [&node](const Vector_3& p, const Vector_3& q)
                       { return p[node.axis] < q[node.axis]; });
      node.cut = (*middle)[node.axis];
    }
    const int number = static_cast<int>(nodes_.size());
    nodes_.push_back(node);
    const int low = split(begin, middle, first, random), high = split(middle, end, blocks - first, random);
    nodes_[number].child = {{ low, high }};
    return number;
  }

  Vector_3 in_frame(const Vector_3& p) const { return { frame_[0].dot(p), frame_[1].dot(p), frame_[2].dot(p) }; }

  static int longest_axis(Sample begin, Sample end)
  {
    std::array<double, 3> extent;
    for(int axis = 0; axis < 3; ++axis)
    {
      const auto ends = std::minmax_element(begin, end, [axis](const Vector_3& p, const Vector_3& q) { return p[axis] < q[axis]; });
      extent[axis] = (*ends.second)[axis] - (*ends.first)[axis];
    }
    return static_cast<int>(std::max_element(extent.begin(), extent.end()) - extent.begin());
  }

  std::array<Vector_3, 3> frame_;
  std::vector<Node> nodes_;
  int root_ = 0, number_of_leaves_ = 0;
};

// The cells of a mesh in the blocks of a partition of space, by their centroids.
class Mesh_partition_3
{
public:
  Mesh_partition_3(const Constrained_triangulation_3& mesh, int number_of_blocks, Random_source random,
                   const Thread_policy& threads)
  {
    const Space_partition_3 space(mesh, number_of_blocks, random);
    const int cells = mesh.topology.number_of_cell_slots();
    std::vector<int> block(cells);
    // 0 for no block yet.
    std::vector<std::atomic<int> > block_of_vertex(mesh.sites.size());
    for_each_in_chunks(cells, threads, [&](int c)
    {
      block[c] = mesh.topology.is_alive(c) ? space.block(centroid(mesh, c)) : int(no_block);
      for(int i = 0; i < 4 && block[c] >= 0; ++i)
        join(block_of_vertex[mesh.topology.vertices(c)[i]], block[c] + 1);
    });
    cells_ = Buckets(cells, number_of_blocks, [&block](int c) { return block[c]; }, threads);
    vertices_ = Buckets(static_cast<int>(mesh.sites.size()), number_of_blocks,
                        [&](int v) { return block_of_vertex[v].load(std::memory_order_relaxed) - 1; }, threads);
  }

  int number_of_blocks() const { return cells_.number_of_buckets(); }
  const Buckets& cells() const { return cells_; }
  // The vertices with all their cells in one block.
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

  static Vector_3 centroid(const Constrained_triangulation_3& mesh, int cell)
  {
    Vector_3 sum;
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

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_BLOCKS_MESH_PARTITION_3_H
