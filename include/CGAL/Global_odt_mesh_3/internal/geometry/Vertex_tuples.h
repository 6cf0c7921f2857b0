// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_VERTEX_TUPLES_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_VERTEX_TUPLES_H

#include <algorithm>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The numbers of the vertices of a facet or cell, as std::array<int, n>, are keys that
// do not depend on the order of the vertices once they are sorted.
template <class Tuple>
Tuple sorted(Tuple t)
{
  std::sort(t.begin(), t.end());
  return t;
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_VERTEX_TUPLES_H
