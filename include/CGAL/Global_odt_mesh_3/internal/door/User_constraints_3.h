// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_USER_CONSTRAINTS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_USER_CONSTRAINTS_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/door/Named_parameters.h>

#include <type_traits>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// What the caller wants to stay.
class User_constraints_3
{
public:
  // By its place among the finite vertices.
  bool has_vertex(int n) const { return !vertices_.empty() && vertices_[n]; }

  // Asks the property map once for each vertex.
  template <class C3t3, class Arguments>
  void read(const C3t3& c3t3, const Arguments& arguments)
  {
    if constexpr (Arguments::template has<internal_np::vertex_is_constrained_t>)
    {
      const typename C3t3::Triangulation& tr = c3t3.triangulation();
      for(typename C3t3::Triangulation::Vertex_handle v : tr.finite_vertex_handles())
        vertices_.push_back(is_true(arguments.template get<internal_np::vertex_is_constrained_t>(), v));
    }
  }

private:
  template <class Map, class Key>
  static bool is_true(const Map& map, Key key)
  {
    static_assert(std::is_convertible<decltype(get(map, key)), bool>::value, "vertex_is_constrained_map must have values of type bool");
    return get(map, key);
  }

  std::vector<char> vertices_;              // if the caller says anything of them
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_USER_CONSTRAINTS_3_H
