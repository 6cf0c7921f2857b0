// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_OPTIMIZER_3_IMPL_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_OPTIMIZER_3_IMPL_H

#include <CGAL/Global_odt_mesh_3/internal/Iteration_control.h>
#include <CGAL/Global_odt_mesh_3/internal/Mesh_optimizer_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Odt_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/Optimization_attempt_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Optimization_visitor.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/User_field_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <CGAL/Mesh_optimization_return_code.h>

#include <cstddef>
#include <vector>

#ifdef CGAL_GLOBAL_ODT_MESH_3_COMPILED_CORE
#  define CGAL_GLOBAL_ODT_MESH_3_INLINE
#else
#  define CGAL_GLOBAL_ODT_MESH_3_INLINE inline
#endif

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// In one of several attempts: first surface vertices follow normals, then, for rough surfaces
// or if no valid complex comes out of that, the domain is asked all the time; and in the end the boundary rests.
CGAL_GLOBAL_ODT_MESH_3_INLINE
Mesh_optimization_return_code
optimize_mesh(Mesh_view_3& mesh, const Domain_view_3& domain, Odt_task task, const Odt_parameters& parameters,
              const User_field_3& field, Optimization_visitor& visitor, const Thread_policy& threads)
{
  Iteration_control control(parameters, visitor);
  std::vector<Boundary_motion> motions;
  if(parameters.optimize_boundary)
    motions = { Boundary_motion::BY_NORMALS, Boundary_motion::BY_DOMAIN };
  if(task != Odt_task::REMESH_BOUNDARY)
    motions.push_back(Boundary_motion::NONE);
  for(Boundary_motion motion : motions)
  {
    Optimization_attempt_3 attempt(mesh, domain, task, parameters, field, control, threads, motion);
    if(!attempt.run())
      continue;
    attempt.commit();
    const std::size_t slivers = parameters.sliver_bound > 0 ? mesh.number_of_slivers(parameters.sliver_bound) : 0;
    visitor.after_sliver_removal(slivers);
    visitor.after_rebuild_restricted_delaunay();
    return attempt.code(slivers);
  }
  return CANT_IMPROVE_ANYMORE;
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_OPTIMIZER_3_IMPL_H
