// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_GIVEN_UP_CELLS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_GIVEN_UP_CELLS_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>

#include <Eigen/Core>

#include <boost/functional/hash.hpp>

#include <array>
#include <unordered_map>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The slivers that nothing has improved: as long as their vertices stay where they are, they are left alone,
// whatever numbers the cells of the mesh have.
class Given_up_cells
{
public:
  void add(const Constrained_triangulation_3& mesh, int cell) { centroids_[vertices(mesh, cell)] = centroid(mesh, cell); }

  bool contain(const Constrained_triangulation_3& mesh, int cell) const
  {
    const auto it = centroids_.find(vertices(mesh, cell));
    return it != centroids_.end() && it->second == centroid(mesh, cell);
  }

private:
  typedef std::array<int, 4> Quadruple;

  static Quadruple vertices(const Constrained_triangulation_3& mesh, int cell)
  {
    const int* const v = mesh.topology.vertices(cell);
    return sorted(Quadruple{{ v[0], v[1], v[2], v[3] }});
  }

  // In an order that does not depend on that of the vertices, or else the sum would round otherwise.
  static Eigen::Vector3d centroid(const Constrained_triangulation_3& mesh, int cell)
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for(int v : vertices(mesh, cell))
      sum += position(mesh.sites[v]) / 4;
    return sum;
  }

  std::unordered_map<Quadruple, Eigen::Vector3d, boost::hash<Quadruple> > centroids_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_GIVEN_UP_CELLS_H
