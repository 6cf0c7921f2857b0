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

#include <algorithm>
#include <array>
#include <set>
#include <type_traits>
#include <unordered_set>
#include <vector>
#include <utility>

namespace CGAL::Global_odt_mesh_3::internal {

// A property map of truth values.
template <class Map, class Key, class = void>
struct Is_map : std::false_type {};

template <class Map, class Key>
struct Is_map<Map, Key, std::void_t<decltype(get(std::declval<const Map&>(), std::declval<Key&>()))> >
  : std::is_convertible<decltype(get(std::declval<const Map&>(), std::declval<Key&>())), bool> {};

// What the caller wants to stay: vertices, and cells with their vertices.
template <class C3t3>
class User_constraints_3
{
  typedef typename C3t3::Triangulation Triangulation;
  typedef CGAL::Hash_handles_with_or_without_timestamps Hash;

public:
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Cell_handle Cell_handle;
  typedef typename Triangulation::Facet Facet;

  bool has(Vertex_handle v) const { return vertices_.count(v) > 0 || vertices_of_cells_.count(v) > 0; }
  bool has(const Facet& f) const { return !facets_.empty() && facets_.count(vertices(f)) > 0; }
  bool has_cells() const { return !cells_.empty(); }
  bool has(Cell_handle c) const { return cells_.count(c) > 0; }

  // Asks the property maps, once for each vertex and for each cell of the complex, and for each facet of it from both sides.
  template <class Arguments>
  void read(const C3t3& c3t3, const Arguments& arguments)
  {
    const Triangulation& tr = c3t3.triangulation();
    if constexpr (Arguments::template has<internal_np::cell_selector_t>)
      for(Cell_handle c : tr.all_cell_handles())
        if(c3t3.is_in_complex(c) && !is_true(arguments.template get<internal_np::cell_selector_t>(), c))
          cells_.insert(c);
    find_vertices_of_cells();
    if constexpr (Arguments::template has<internal_np::vertex_is_constrained_t>)
      for(Vertex_handle v : tr.finite_vertex_handles())
        if(is_true(arguments.template get<internal_np::vertex_is_constrained_t>(), v))
          vertices_.insert(v);
    if constexpr (Arguments::template has<internal_np::facet_is_constrained_t>)
      for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
        if(const auto& map = arguments.template get<internal_np::facet_is_constrained_t>();
           is_true(map, Facet(*f)) || is_true(map, tr.mirror_facet(*f)))
        {
          const Facet_vertices t = vertices(*f);
          facets_.insert(t);
          vertices_.insert(t.begin(), t.end());
        }
  }

  // Releases the vertices of cells, as far as none of the others has them, and no map says that these stay.
  void release(const std::vector<Cell_handle>& cells)
  {
    for(Cell_handle c : cells)
      cells_.erase(c);
    find_vertices_of_cells();
  }

private:
  typedef std::array<Vertex_handle, 3> Facet_vertices;

  static Facet_vertices vertices(const Facet& f)
  {
    Facet_vertices t;
    for(int k = 0; k < 3; ++k)
      t[k] = f.first->vertex((f.second + k + 1) % 4);
    std::sort(t.begin(), t.end());
    return t;
  }

  void find_vertices_of_cells()
  {
    vertices_of_cells_.clear();
    for(Cell_handle c : cells_)
      for(int i = 0; i < 4; ++i)
        vertices_of_cells_.insert(c->vertex(i));
  }

  template <class Map, class Key>
  static bool is_true(const Map& map, Key key)
  {
    static_assert(Is_map<Map, Key>::value,
                  "vertex_is_constrained_map, facet_is_constrained_map, and cell_is_selected_map need a ReadablePropertyMap with key "
                  "type Vertex_handle, Facet, or Cell_handle and "
                  "value type bool: wrap a std::set in CGAL::Boolean_property_map, a std::map in boost::associative_property_map, and a "
                  "function in boost::function_property_map");
    if constexpr (Is_map<Map, Key>::value)
      return get(map, key);
    else
      return false;
  }

  std::unordered_set<Vertex_handle, Hash> vertices_, vertices_of_cells_;
  std::unordered_set<Cell_handle, Hash> cells_;
  std::set<Facet_vertices> facets_;         // which cells may lose, by handles that stay valid
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_USER_CONSTRAINTS_3_H
