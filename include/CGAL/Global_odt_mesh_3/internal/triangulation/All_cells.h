// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_ALL_CELLS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_ALL_CELLS_H

#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The cells of a triangulation, also infinite ones, in their order there, so that chunks of them can be visited.
template <class Triangulation>
std::vector<typename Triangulation::Cell_handle> all_cells(const Triangulation& tr)
{
  std::vector<typename Triangulation::Cell_handle> cells;
  cells.reserve(tr.tds().number_of_cells());
  for(auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
    cells.push_back(c);
  return cells;
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_ALL_CELLS_H
