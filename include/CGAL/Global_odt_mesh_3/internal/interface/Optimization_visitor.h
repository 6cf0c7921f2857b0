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

#include <CGAL/Mesh_optimization_report_3.h>

#include <cstddef>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// What is told to the visitor of the user, whatever its type, and in the report.
class Optimization_visitor
{
public:
  Mesh_optimization_summary_3* summary = nullptr;     // unless nobody wants to know
  std::vector<int> obstacles;                         // vertices around which no valid mesh could be made

  virtual ~Optimization_visitor() {}

  virtual void after_compute_moves() {}
  virtual void after_move_points() {}
  virtual void end_of_iteration(int) {}
  virtual void after_sliver_removal(std::size_t) {}
  virtual void after_rebuild_restricted_delaunay() {}
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_INTERFACE_OPTIMIZATION_VISITOR_H
