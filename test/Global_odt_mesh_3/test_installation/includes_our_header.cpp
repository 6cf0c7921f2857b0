// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/odt_optimize_mesh_3.h>

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ODT_MESH_OPTIMIZER_3_H
#  error "the header of the same name of CGAL was found first"
#endif
