// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_CELL_KNOWLEDGE_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_CELL_KNOWLEDGE_H

#include <initializer_list>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// What is known of a cell as long as its vertices stay, in the bits that CGAL's optimizers
// use for facets: the cells that a vertex leaves behind are gone when it moves.
enum Cell_knowledge { IS_SETTLED, IS_BOUNDARY_CELL, MAY_HAVE_BOUNDARY_FACETS };

template <class Cell_handle>
bool knows(Cell_handle c, Cell_knowledge k) { return c->is_facet_visited(k); }

template <class Cell_handle>
void note(Cell_handle c, Cell_knowledge k) { c->set_facet_visited(k); }

template <class Cell_handle>
void forget(Cell_handle c, Cell_knowledge k) { c->reset_visited(k); }

template <class Cell_handle>
void forget(Cell_handle c)
{
  // Bits that threads may share are slow to write.
  for(Cell_knowledge k : { IS_SETTLED, IS_BOUNDARY_CELL, MAY_HAVE_BOUNDARY_FACETS })
    if(knows(c, k))
      forget(c, k);
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_CELL_KNOWLEDGE_H
