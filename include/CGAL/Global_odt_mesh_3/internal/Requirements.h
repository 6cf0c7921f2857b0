// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_REQUIREMENTS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_REQUIREMENTS_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/version.h>

#if CGAL_VERSION_NR < 1050500000
#  error "Global_odt_mesh_3 requires CGAL 5.5 or later: set CGAL_DIR in CMake, or give the compiler the directory of such a version first"
#endif

#if !__has_include(<Eigen/Core>)
#  error "Global_odt_mesh_3 requires Eigen 3: link Eigen3::Eigen in CMake, or give the compiler its directory, such as -I/usr/include/eigen3"
#endif

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_REQUIREMENTS_H
