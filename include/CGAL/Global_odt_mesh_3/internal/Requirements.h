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

// Without these checks, an unmet requirement causes hundreds of errors. Including a missing header stops the compiler.
#if !(__cplusplus >= 201703L || _MSVC_LANG >= 201703L)
#  error "Global_odt_mesh_3 requires C++17: set CMAKE_CXX_STANDARD in CMake, or give the compiler -std=c++17"
#  include <CGAL/Global_odt_mesh_3/requires_C++17>
#endif

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/version.h>

#if CGAL_VERSION_NR < 1050500000
#  error "Global_odt_mesh_3 requires CGAL 5.5 or later: set CGAL_DIR in CMake, or give the compiler the directory of such a version first"
#  include <CGAL/Global_odt_mesh_3/requires_CGAL_5.5>
#endif

#if !__has_include(<Eigen/Core>)
#  error "Global_odt_mesh_3 requires Eigen 3: link Eigen3::Eigen in CMake, or give the compiler its directory, such as -I/usr/include/eigen3"
#  include <CGAL/Global_odt_mesh_3/requires_Eigen_3>
#endif

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_REQUIREMENTS_H
