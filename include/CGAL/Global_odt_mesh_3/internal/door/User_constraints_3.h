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

#include <CGAL/Time_stamper.h>
#include <CGAL/Unique_hash_map.h>

#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// What the caller wants to stay: vertices, and cells with their vertices.
class User_constraints_3
{
public:
  // By their places among the finite vertices and among all cells.
  bool has_vertex(std::size_t n) const { return !vertices_.empty() && vertices_[n]; }
  bool has_cell(std::size_t n) const { return !cells_.empty() && cells_[n]; }

  // Asks the property maps, once for each vertex and for each cell of the complex.
  template <class C3t3, class Arguments>
  void read(const C3t3& c3t3, const Arguments& arguments)
  {
    constexpr bool has_vertices = Arguments::template has<internal_np::vertex_is_constrained_t>;
    constexpr bool has_cells = Arguments::template has<internal_np::cell_selector_t>;
    typedef typename C3t3::Triangulation Triangulation;
    const Triangulation& tr = c3t3.triangulation();
    CGAL::Unique_hash_map<typename Triangulation::Vertex_handle, bool, CGAL::Hash_handles_with_or_without_timestamps> is_kept(false);
    if constexpr (has_cells)
      for(typename Triangulation::Cell_handle c : tr.all_cell_handles())
      {
        cells_.push_back(c3t3.is_in_complex(c) && !is_true(arguments.template get<internal_np::cell_selector_t>(), c));
        for(int i = 0; i < 4 && cells_.back(); ++i)
          is_kept[c->vertex(i)] = true;
      }
    if constexpr (has_vertices || has_cells)
      for(typename Triangulation::Vertex_handle v : tr.finite_vertex_handles())
      {
        vertices_.push_back(is_kept[v]);
        if constexpr (has_vertices)
          vertices_.back() = is_true(arguments.template get<internal_np::vertex_is_constrained_t>(), v) || vertices_.back();
      }
  }

private:
  template <class Map, class Key>
  static bool is_true(const Map& map, Key key)
  {
    static_assert(std::is_convertible<decltype(get(map, key)), bool>::value,
                  "vertex_is_constrained_map and cell_is_selected_map must have values of type bool");
    return get(map, key);
  }

  std::vector<char> vertices_, cells_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_USER_CONSTRAINTS_3_H
