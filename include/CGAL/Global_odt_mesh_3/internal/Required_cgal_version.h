// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_REQUIRED_CGAL_VERSION_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_REQUIRED_CGAL_VERSION_H

#include <CGAL/version.h>

#if CGAL_VERSION_NR < 1050500000
#  error "Global_odt_mesh_3 requires CGAL 5.5 or later"
#endif

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_REQUIRED_CGAL_VERSION_H
