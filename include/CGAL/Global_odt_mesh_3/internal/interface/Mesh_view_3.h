// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_INTERFACE_MESH_VIEW_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_INTERFACE_MESH_VIEW_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_table_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <cstddef>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The mesh of the user, whatever its type. Vertices and facets are numbered as in its table, subdomains and patches as by the
// view of the domain.
class Mesh_view_3
{
public:
  virtual ~Mesh_view_3() {}

  // The same each time until something is written.
  virtual Mesh_table_3 read(const Thread_policy& threads) = 0;

  // The patch of a vertex of dimension 2.
  virtual int patch(int vertex) const = 0;

  // Not to be asked by several threads, as CGAL marks cells while it looks.
  virtual bool is_cell(const Quadruple& vertices) const = 0;

  // How many cells of the complex have a dihedral angle below a bound, in degrees.
  virtual std::size_t number_of_slivers(double bound) const = 0;

  // Of a table for the same vertices; nothing has changed if that throws.
  virtual void write(const Mesh_table_3& table) = 0;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_INTERFACE_MESH_VIEW_3_H
