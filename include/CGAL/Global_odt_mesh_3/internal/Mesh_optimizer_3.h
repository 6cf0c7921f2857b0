// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_OPTIMIZER_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_OPTIMIZER_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Odt_parameters.h>

#include <CGAL/Mesh_optimization_return_code.h>

namespace CGAL::Global_odt_mesh_3::internal {

class Domain_view_3;
class User_mesh_view_3;
class Optimization_visitor;
class Thread_policy;
struct User_field_3;

// All that happens between reading and writing the mesh. It depends on no type of the user, so it may be compiled once, in a
// library.
Mesh_optimization_return_code
optimize_mesh(User_mesh_view_3& mesh, const Domain_view_3& domain, Odt_task task, const Odt_parameters& parameters,
              const User_field_3& field, Optimization_visitor& visitor, const Thread_policy& threads);

} // namespace CGAL::Global_odt_mesh_3::internal

#ifndef CGAL_GLOBAL_ODT_MESH_3_COMPILED_CORE
#  include <CGAL/Global_odt_mesh_3/internal/Mesh_optimizer_3_impl.h>
#endif

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_OPTIMIZER_3_H
