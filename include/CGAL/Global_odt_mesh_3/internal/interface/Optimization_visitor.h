// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_INTERFACE_OPTIMIZATION_VISITOR_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_INTERFACE_OPTIMIZATION_VISITOR_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <cstddef>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// What is told to the visitor of the user, whatever its type.
class Optimization_visitor
{
public:
  virtual ~Optimization_visitor() {}

  virtual void after_compute_moves() {}
  virtual void after_move_points() {}
  virtual void end_of_iteration(int) {}
  virtual void after_sliver_removal(std::size_t) {}
  virtual void after_rebuild_restricted_delaunay() {}
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_INTERFACE_OPTIMIZATION_VISITOR_H
