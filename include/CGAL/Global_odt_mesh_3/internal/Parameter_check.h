// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARAMETER_CHECK_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARAMETER_CHECK_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/assertions.h>

// Checks a precondition on a parameter in every build: the check costs nothing compared with the call, and a bad value would pass
// unnoticed.
#define CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(condition, message) \
  ((condition) ? static_cast<void>(0) : ::CGAL::precondition_fail(#condition, __FILE__, __LINE__, message))

namespace CGAL::Global_odt_mesh_3::internal {

constexpr char wrong_domain[] = "the domain must be that of the mesh: it finds the dual points of most cells in other subdomains than theirs";

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARAMETER_CHECK_H
