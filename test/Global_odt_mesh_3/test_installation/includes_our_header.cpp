// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The header that is found is ours, and of the version of the package. TBB is not switched on by linking our target.

#include <CGAL/odt_optimize_mesh_3.h>

#ifndef CGAL_GLOBAL_ODT_MESH_3
#  error "the header of the same name of CGAL was found first"
#endif
#ifdef INSTALLED_VERSION
static_assert(CGAL_GLOBAL_ODT_MESH_3 == INSTALLED_VERSION, "the header is of another version than its package");
#endif

#ifdef CGAL_LINKED_WITH_TBB
#  error "TBB is linked, though nobody asked for it"
#endif
