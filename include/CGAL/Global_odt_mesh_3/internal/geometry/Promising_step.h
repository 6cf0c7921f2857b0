// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_PROMISING_STEP_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_PROMISING_STEP_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// A place for a vertex, and by how much the deficits of the angles around it change if its cells stay the same.
struct Promising_step
{
  int vertex;
  Site site;
  double change;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_PROMISING_STEP_H
