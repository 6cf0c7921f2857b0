// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_ODT_MESH_OPTIMIZER_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_ODT_MESH_OPTIMIZER_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Mesh_optimizer_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Odt_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/door/C3t3_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Mesh_domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/door/User_fields_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Optimization_visitor.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/User_field_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Stage_clock.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <CGAL/Mesh_optimization_return_code.h>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

template <class Visitor, class = void>
struct Wants_slivers : std::false_type {};

template <class Visitor>
struct Wants_slivers<Visitor, std::void_t<decltype(std::declval<Visitor&>().after_sliver_removal(std::size_t()))> >
  : std::true_type {};

template <class Visitor, class Vertex_handle, class = void>
struct Wants_removals : std::false_type {};

template <class Visitor, class Vertex_handle>
struct Wants_removals<Visitor, Vertex_handle,
                      std::void_t<decltype(std::declval<Visitor&>().before_vertex_removal(std::declval<Vertex_handle>()))> >
  : std::true_type {};

template <class Visitor, class Vertex_handle>
void tell_of_removal([[maybe_unused]] Visitor& visitor, [[maybe_unused]] Vertex_handle v)
{
  if constexpr (Wants_removals<Visitor, Vertex_handle>::value)
    visitor.before_vertex_removal(v);
}

template <class Visitor>
class User_visitor
  : public Optimization_visitor
{
public:
  explicit User_visitor(Visitor& visitor) : visitor_(visitor) {}

  void after_compute_moves() override { visitor_.after_compute_moves(); }
  void after_move_points() override { visitor_.after_move_points(); }
  void end_of_iteration(int n) override { visitor_.end_of_iteration(n); }
  void after_rebuild_restricted_delaunay() override { visitor_.after_rebuild_restricted_delaunay(); }

  void after_sliver_removal([[maybe_unused]] std::size_t slivers) override
  {
    if constexpr (Wants_slivers<Visitor>::value)
      visitor_.after_sliver_removal(slivers);
  }

private:
  Visitor& visitor_;
};

// Optimizes a c3t3: what the user has given becomes what the optimizer knows.
template <class C3t3, class Mesh_domain, class Visitor>
class Odt_mesh_optimizer_3
{
public:
  // Keeps references to its arguments, except for the fields.
  Odt_mesh_optimizer_3(C3t3& c3t3, const Mesh_domain& domain, Odt_task task, const Odt_parameters& parameters,
                       Visitor& visitor, const User_fields_3<C3t3>& fields = User_fields_3<C3t3>())
    : fields_(fields)
    , domain_(domain, parameters.domain_is_thread_safe ? threads() : Thread_policy())
    , mesh_(c3t3, domain_, [&visitor](typename C3t3::Vertex_handle v) { tell_of_removal(visitor, v); })
    , task_(task)
    , parameters_(parameters)
    , visitor_(visitor)
  {}

  // Loops refer to the clock.
  Odt_mesh_optimizer_3(const Odt_mesh_optimizer_3&) = delete;
  Odt_mesh_optimizer_3& operator=(const Odt_mesh_optimizer_3&) = delete;

  Mesh_optimization_return_code operator()()
  {
    const User_field_3 field = fields_.of_mesh([this](int v) { return mesh_.vertex(v); },
                                               [this](const Vertex_stratum& s) { return domain_.index(s.dimension, s.place); });
    return optimize_mesh(mesh_, domain_, task_, parameters_, field, visitor_, threads());
  }

  const Stage_clock& clock() const { return clock_; }
  const Oracle_statistics& oracle_statistics() const { return domain_.statistics(); }

private:
  Thread_policy threads() { return Thread_policy::for_tag<typename C3t3::Triangulation::Concurrency_tag>().with(clock_); }

  Stage_clock clock_;
  const User_fields_3<C3t3> fields_;
  Mesh_domain_view_3<Mesh_domain> domain_;
  C3t3_view_3<C3t3, Mesh_domain> mesh_;
  Odt_task task_;
  const Odt_parameters& parameters_;
  User_visitor<Visitor> visitor_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_ODT_MESH_OPTIMIZER_3_H
