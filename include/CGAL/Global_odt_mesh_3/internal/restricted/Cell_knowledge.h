// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_CELL_KNOWLEDGE_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_CELL_KNOWLEDGE_H

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// What is known of a cell as long as its vertices stay, in bits of the cell: the cells that a vertex leaves behind are gone
// when it moves.
enum Cell_knowledge { IS_SETTLED, IS_BOUNDARY_CELL, MAY_HAVE_BOUNDARY_FACETS };

template <class Cell_handle>
bool knows(Cell_handle c, Cell_knowledge k) { return c->is_marked(k); }

template <class Cell_handle>
void note(Cell_handle c, Cell_knowledge k) { c->mark(k); }

template <class Cell_handle>
void forget(Cell_handle c, Cell_knowledge k) { c->unmark(k); }

template <class Cell_handle>
void forget(Cell_handle c) { c->unmark_all(); }

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_CELL_KNOWLEDGE_H
