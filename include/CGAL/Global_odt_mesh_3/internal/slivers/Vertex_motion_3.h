// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_VERTEX_MOTION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_VERTEX_MOTION_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Where the vertices of slivers may go. Several threads may ask for vertices of the interior at the same time, and for those
// on surfaces if the removal of slivers is told so.
class Vertex_motion_3
{
public:
  virtual ~Vertex_motion_3() {}

  // Changes a place for the vertex to one as good as allowed, quickly; false if the vertex has to
  // stay.
  virtual bool approach(int v, Site& s) = 0;

  // Changes a place that has been approached, and has turned out to be promising, to one that is
  // allowed, perhaps where it is; false if the vertex has to stay.
  virtual bool settle(int v, Site& s) = 0;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_VERTEX_MOTION_3_H
