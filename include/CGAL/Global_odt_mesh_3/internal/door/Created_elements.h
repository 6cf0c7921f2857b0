// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_CREATED_ELEMENTS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_CREATED_ELEMENTS_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Vertices, cells, and feature edges that are erased again unless they are kept.
template <class C3t3>
class Created_elements
{
public:
  typedef typename C3t3::Triangulation Triangulation;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Cell_handle Cell_handle;

  explicit Created_elements(C3t3& c3t3)
    : c3t3_(c3t3)
    , tds_(c3t3.triangulation().tds())
  {}
  Created_elements(const Created_elements&) = delete;
  Created_elements& operator=(const Created_elements&) = delete;

  ~Created_elements()
  {
    if(is_kept_)
      return;
    for(const Edge& e : edges_)
      if(c3t3_.is_in_complex(e.first, e.second))
        c3t3_.remove_from_complex(e.first, e.second);
    for(Vertex_handle v : vertices_)
      if(v != Vertex_handle())
        tds_.delete_vertex(v);
    for(Cell_handle c : cells_)
      if(c != Cell_handle())
        tds_.cells().erase(c);
  }

  // Or none in its place.
  Vertex_handle create_vertex(bool is_removed)
  {
    vertices_.emplace_back();
    if(!is_removed)
      vertices_.back() = tds_.create_vertex();
    return vertices_.back();
  }

  void create_cell()
  {
    cells_.emplace_back();
    cells_.back() = tds_.create_cell();
  }

  void create_edge(Vertex_handle v, Vertex_handle w, const typename C3t3::Curve_index& curve)
  {
    edges_.emplace_back(v, w);
    c3t3_.add_to_complex(v, w, curve);
  }

  void keep() { is_kept_ = true; }

  const std::vector<Vertex_handle>& vertices() const { return vertices_; }
  const std::vector<Cell_handle>& cells() const { return cells_; }

private:
  typedef std::pair<Vertex_handle, Vertex_handle> Edge;

  C3t3& c3t3_;
  typename Triangulation::Triangulation_data_structure& tds_;
  std::vector<Vertex_handle> vertices_;
  std::vector<Cell_handle> cells_;
  std::vector<Edge> edges_;
  bool is_kept_ = false;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_CREATED_ELEMENTS_H
