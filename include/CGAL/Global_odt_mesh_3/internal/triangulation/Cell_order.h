// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_CELL_ORDER_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_CELL_ORDER_H

#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <cstddef>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Flips scatter the cells over memory, which makes evaluations of large meshes slower. Lays
// them out anew, at a current point, when there has been a flip for eight cells.
class Cell_order
{
public:
  explicit Cell_order(const Moving_triangulation_3& mesh) : flips_(mesh.statistics().flips) {}

  void maintain(Moving_triangulation_3& mesh)
  {
    const std::size_t flips = mesh.statistics().flips;
    if(flips - flips_ < static_cast<std::size_t>(mesh.topology.number_of_cells()) / 8)
      return;
    mesh.compact();
    flips_ = flips;
  }

private:
  std::size_t flips_;   // when the order was last good
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_CELL_ORDER_H
