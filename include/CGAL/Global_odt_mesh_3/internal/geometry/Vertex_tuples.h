// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_VERTEX_TUPLES_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_VERTEX_TUPLES_H

#include <algorithm>
#include <array>
#include <utility>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The numbers of the vertices of a facet or cell.
typedef std::array<int, 3> Triple;
typedef std::array<int, 4> Quadruple;

// They are keys that do not depend on the order of the vertices once they are sorted.
template <class Tuple>
Tuple sorted(Tuple t)
{
  std::sort(t.begin(), t.end());
  return t;
}

// The same oriented facet, from its lowest vertex on.
inline Triple rotated(Triple t)
{
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

// The vertices of an oriented cell in ascending order, but for the last two where orientation asks for it.
inline Quadruple in_canonical_order(Quadruple v)
{
  bool is_odd = false;
  for(int i = 1; i < 4; ++i)
    for(int j = i; j > 0 && v[j] < v[j - 1]; --j)
    {
      std::swap(v[j], v[j - 1]);
      is_odd = !is_odd;
    }
  if(is_odd)
    std::swap(v[2], v[3]);
  return v;
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_VERTEX_TUPLES_H
