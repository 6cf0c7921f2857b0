// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_OPTIMIZER_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_OPTIMIZER_3_H

#include <CGAL/Global_odt_mesh_3/internal/Iteration_control.h>
#include <CGAL/Global_odt_mesh_3/internal/Odt_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/Optimization_attempt_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Optimization_visitor.h>
#include <CGAL/Global_odt_mesh_3/internal/Round_plan.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Field_density_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Stage_clock.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Boundary_motion.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Mesh_view_3.h>

#include <CGAL/Mesh_optimization_return_code.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Optimizes a mesh in one of several attempts: first surface vertices follow normals, then, for rough surfaces
// or if no valid complex comes out of that, the domain is asked all the time; and in the end the boundary rests.
class Mesh_optimizer_3
{
public:
  // Refers to its arguments.
  Mesh_optimizer_3(Mesh_view_3& mesh, const Domain_view_3& domain, Odt_task task, const Odt_parameters& parameters,
                   const User_field_3& field, Optimization_visitor& visitor, const Thread_policy& threads)
    : mesh_(mesh)
    , domain_(domain)
    , task_(task)
    , parameters_(parameters)
    , field_(field)
    , visitor_(visitor)
    , control_(parameters, visitor)
    , threads_(threads.with(control_.clock()))
  {}

  // The threads refer to the clock.
  Mesh_optimizer_3(const Mesh_optimizer_3&) = delete;
  Mesh_optimizer_3& operator=(const Mesh_optimizer_3&) = delete;

  Mesh_optimization_return_code operator()()
  {
    std::vector<Boundary_motion> motions;
    if(parameters_.optimize_boundary)
      motions = { Boundary_motion::BY_NORMALS, Boundary_motion::BY_DOMAIN };
    if(task_ != Odt_task::REMESH_BOUNDARY)
      motions.push_back(Boundary_motion::NONE);
    for(Boundary_motion motion : motions)
    {
      Optimization_attempt_3 attempt(mesh_, domain_, task_, parameters_, field_, control_, threads_, motion);
      const bool is_done = attempt.run();
      number_of_surface_vertices_ = attempt.number_of_surface_vertices();
      if(!is_done)
        continue;
      attempt.commit();
      const std::size_t slivers = parameters_.sliver_bound > 0 ? mesh_.number_of_slivers(parameters_.sliver_bound) : 0;
      visitor_.after_sliver_removal(slivers);
      visitor_.after_rebuild_restricted_delaunay();
      return attempt.code(slivers);
    }
    return CANT_IMPROVE_ANYMORE;
  }

  // Of all attempts.
  Stage_clock& clock() { return control_.clock(); }
  // Those that moved in the last attempt.
  std::size_t number_of_surface_vertices() const { return number_of_surface_vertices_; }

private:
  Mesh_view_3& mesh_;
  const Domain_view_3& domain_;
  Odt_task task_;
  const Odt_parameters& parameters_;
  const User_field_3& field_;
  Optimization_visitor& visitor_;
  Iteration_control control_;
  const Thread_policy threads_;
  std::size_t number_of_surface_vertices_ = 0;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_OPTIMIZER_3_H
