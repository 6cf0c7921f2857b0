// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_TEST_LABELLED_TRIANGULATION_CHECKS_H
#define GLOBAL_ODT_MESH_3_TEST_LABELLED_TRIANGULATION_CHECKS_H

#include <CGAL/Global_odt_mesh_3/internal/complex/Labelled_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Vertex_moves_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>

#include <algorithm>
#include <set>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The cells by the numbers of their vertices, -1 for the infinite one.
inline std::set<Quadruple> cells_of(const Labelled_triangulation_3& tr)
{
  std::set<Quadruple> cells;
  for(int c : tr.cells())
    cells.insert(sorted(tr.vertices(c)));
  return cells;
}

// Whether neighbors know each other, no two cells have the same vertices, and the cells are those of CGAL's triangulation of the
// vertices that are visible.
inline bool is_regular_triangulation_of_cgal(const Labelled_triangulation_3& tr)
{
  for(int c : tr.cells())
    for(int i = 0; i < 4; ++i)
    {
      const Half_facet f(c, i), across = tr.mirror(f);
      if(!tr.is_cell(across.cell()) || tr.mirror(across) != f
         || sorted(facet_vertices(tr.vertices(c), i)) != sorted(facet_vertices(tr.vertices(across.cell()), across.index())))
        return false;
    }
  std::vector<int> visible;
  for(int v = 0; v < static_cast<int>(tr.sites().size()); ++v)
  {
    const std::vector<int> star = tr.star(v);
    if(!star.empty())
      visible.push_back(v);
    if(std::any_of(star.begin(), star.end(), [&](int c) { return index_of(tr.vertices(c), v) == 4; }))
      return false;
  }
  Exact_triangulation_3 exact;
  exact.insert_sites(visible, tr.sites());
  Labelled_triangulation_3 anew;
  anew.assign(exact, tr.sites());
  const std::set<Quadruple> cells = cells_of(tr);
  return cells.size() == tr.cells().size() && cells == cells_of(anew) && is_regular(tr, Thread_policy());
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // GLOBAL_ODT_MESH_3_TEST_LABELLED_TRIANGULATION_CHECKS_H
