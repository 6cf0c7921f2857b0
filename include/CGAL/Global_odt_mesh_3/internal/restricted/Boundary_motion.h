// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_BOUNDARY_MOTION_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_BOUNDARY_MOTION_H

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// How the vertices on surfaces move, and with that, what is believed about the domain.
//
// By normals: vertices follow tangential planes and are projected to the surface now and then, and until the final state
// normals tell on which side of the surface a dual point lies; the domain is asked where that is not clear. On
// surfaces that are rough compared with the mesh, as those of images are, normals mean
// little: the domain is asked where each vertex goes, and for dual points that are not far from the tangential planes.
enum class Boundary_motion { BY_NORMALS, BY_DOMAIN, NONE };

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_BOUNDARY_MOTION_H
