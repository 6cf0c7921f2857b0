// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_CELL_CERTIFICATE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_CELL_CERTIFICATE_3_H

#include <CGAL/Global_odt_mesh_3/internal/parallel/Collect_in_chunks.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Exact_regularity_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Taken_cells_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Slot.h>

#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Rejects the cells that are not positive, and those on both sides of facets that are not strictly locally
// regular. Where spheres pass through five vertices, insertion is to decide.
inline void certify_cells(Taken_cells_3& taken, const Exact_regularity_3& tests, const Thread_policy& threads)
{
  const std::vector<int>& cells = taken.cells();
  const auto find_wrong_cells = [&](int n, std::vector<int>& wrong)
  {
    const int c = cells[n];
    const Exact_regularity_3::Cell cell(tests, taken.flat().vertices(c));
    if(!cell.is_positive())
      return wrong.push_back(c);
    for(int i = 0; i < 4; ++i)
    {
      const Slot s(c, i), across = taken.mate(s);
      if(s < across && taken.is_taken(across.cell()) && !cell.is_outside(taken.flat().vertex(across)))
        wrong.insert(wrong.end(), { c, across.cell() });
    }
  };
  for(int c : collect_in_chunks(static_cast<int>(cells.size()), threads, find_wrong_cells))
    taken.reject(c);
  taken.update();
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_CELL_CERTIFICATE_3_H
