// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ODT_MESH_OPTIMIZER_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ODT_MESH_OPTIMIZER_3_H

#include <CGAL/Global_odt_mesh_3/internal/Iteration_control.h>
#include <CGAL/Global_odt_mesh_3/internal/Odt_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/Optimization_attempt_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Round_plan.h>
#include <CGAL/Global_odt_mesh_3/internal/User_fields_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Point_coordinates.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Stage_clock.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Boundary_motion.h>

#include <CGAL/Mesh_optimization_return_code.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

template <class Visitor, class = void>
struct Wants_slivers : std::false_type {};

template <class Visitor>
struct Wants_slivers<Visitor, std::void_t<decltype(std::declval<Visitor&>().after_sliver_removal(std::size_t()))> >
  : std::true_type {};

// Optimizes a c3t3 in one of several attempts: first surface vertices follow normals, then, for rough surfaces
// or if no valid complex comes out of that, the domain is asked all the time; and in the end the boundary rests.
template <class C3t3, class Mesh_domain, class Visitor>
class Odt_mesh_optimizer_3
{
public:
  Odt_mesh_optimizer_3(C3t3& c3t3, const Mesh_domain& domain, Odt_task task, const Odt_parameters& parameters,
                       Visitor& visitor, const User_fields_3<C3t3>& fields = User_fields_3<C3t3>())
    : c3t3_(c3t3)
    , domain_(domain)
    , task_(task)
    , parameters_(parameters)
    , visitor_(visitor)
    , fields_(fields)
    , control_(parameters, visitor)
  {}

  Mesh_optimization_return_code operator()()
  {
    std::vector<Boundary_motion> motions;
    if(parameters_.optimize_boundary)
      motions = { Boundary_motion::BY_NORMALS, Boundary_motion::BY_DOMAIN };
    if(task_ != Odt_task::REMESH_BOUNDARY)
      motions.push_back(Boundary_motion::NONE);
    for(Boundary_motion motion : motions)
    {
      Attempt attempt(c3t3_, domain_, task_, parameters_, fields_, control_, motion);
      const bool is_done = attempt.run();
      oracle_statistics_ += attempt.oracle_statistics();
      number_of_surface_vertices_ = attempt.number_of_surface_vertices();
      if(!is_done)
        continue;
      attempt.commit();
      const std::size_t slivers = number_of_slivers();
      tell_visitor(slivers);
      return attempt.code(slivers);
    }
    return CANT_IMPROVE_ANYMORE;
  }

  // Of all attempts.
  Stage_clock& clock() { return control_.clock(); }
  const Oracle_statistics& oracle_statistics() const { return oracle_statistics_; }
  // Those that moved in the last attempt.
  std::size_t number_of_surface_vertices() const { return number_of_surface_vertices_; }

private:
  typedef Optimization_attempt_3<C3t3, Mesh_domain, Visitor> Attempt;

  // The cells below the bound, if there is one.
  std::size_t number_of_slivers() const
  {
    if(!(parameters_.sliver_bound > 0))
      return 0;
    const Angle_deficit_3 deficit(parameters_.sliver_bound);
    const auto site = [](const auto& v) { return weighted_site(v->point()); };
    return std::count_if(c3t3_.cells_in_complex_begin(), c3t3_.cells_in_complex_end(), [&](const auto& c)
    { return deficit({{ site(c.vertex(0)), site(c.vertex(1)), site(c.vertex(2)), site(c.vertex(3)) }}) > 0; });
  }

  void tell_visitor(std::size_t slivers)
  {
    if constexpr (Wants_slivers<Visitor>::value)
      visitor_.after_sliver_removal(slivers);
    visitor_.after_rebuild_restricted_delaunay();
  }

  C3t3& c3t3_;
  const Mesh_domain& domain_;
  Odt_task task_;
  const Odt_parameters& parameters_;
  Visitor& visitor_;
  User_fields_3<C3t3> fields_;
  Iteration_control<Visitor> control_;
  Oracle_statistics oracle_statistics_;
  std::size_t number_of_surface_vertices_ = 0;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ODT_MESH_OPTIMIZER_3_H
