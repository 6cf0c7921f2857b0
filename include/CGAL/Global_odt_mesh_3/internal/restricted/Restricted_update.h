// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_UPDATE_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_UPDATE_H

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// How a restricted triangulation goes to new positions.
struct Restricted_update
{
  // On what evidence the dual point of a cell is believed to be on one side of the boundary:
  // as the normals tell unless it is close to tangential, unless it is not far from tangential
  // or they were wrong nearby, or never without asking the domain.
  enum Evidence { SOME_EVIDENCE, GOOD_EVIDENCE, ORACLE };

  bool boundary_moves;            // or else all boundary facets stay
  bool projects;                  // moved surface vertices to the surface
  Evidence evidence;
  bool finds_centers;             // of boundary facets; or else these are estimated
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_UPDATE_H
