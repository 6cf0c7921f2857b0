// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_VERTEX_RINGS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_VERTEX_RINGS_3_H

#include <cstddef>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Some vertices of a triangulation, by their numbers, then their neighbors, and so on, ring by ring.
class Vertex_rings_3
{
public:
  // Numbers below zero, of the infinite vertex, do not matter.
  template <class Vertices>
  Vertex_rings_3(const Numbered_triangulation_3& triangulation, const Vertices& vertices)
    : triangulation_(triangulation)
  {
    for(int v : vertices)
      if(v >= 0)
        add(v);
  }

  // All vertices, and those that the last ring has added.
  const std::vector<int>& vertices() const { return vertices_; }
  std::vector<int> last_ring() const { return std::vector<int>(vertices_.begin() + begin_, vertices_.end()); }

  // Adds the neighbors of those that have been added last.
  void grow()
  {
    const std::vector<int> ring = last_ring();
    begin_ = vertices_.size();
    for(int v : ring)
      for(int w : triangulation_.neighbors(v))
        add(w);
  }

private:
  void add(int v)
  {
    if(known_.insert(v).second)
      vertices_.push_back(v);
  }

  const Numbered_triangulation_3& triangulation_;
  std::vector<int> vertices_;
  std::size_t begin_ = 0;               // of the last ring
  std::unordered_set<int> known_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_VERTEX_RINGS_3_H
