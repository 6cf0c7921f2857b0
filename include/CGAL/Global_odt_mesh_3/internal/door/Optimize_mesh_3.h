// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_OPTIMIZE_MESH_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_OPTIMIZE_MESH_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Mesh_optimizer_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Odt_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/Parameter_check.h>
#include <CGAL/Global_odt_mesh_3/internal/door/C3t3_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Mesh_domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Named_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Optimize_periodic_mesh_3.h>
#include <CGAL/Global_odt_mesh_3/internal/door/User_constraints_3.h>
#include <CGAL/Global_odt_mesh_3/internal/door/User_fields_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Optimization_visitor.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/User_field_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>

#include <CGAL/Mesh_3/Null_global_optimizer_visitor.h>
#include <CGAL/Mesh_optimization_report_3.h>
#include <CGAL/Mesh_optimization_return_code.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>

namespace CGAL::Global_odt_mesh_3::internal {

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
  // Keeps references to its arguments, except for fields and constraints.
  Odt_mesh_optimizer_3(C3t3& c3t3, const Mesh_domain& domain, Odt_task task, const Odt_parameters& parameters,
                       Visitor& visitor, const User_fields_3<C3t3>& fields = User_fields_3<C3t3>(),
                       const User_constraints_3<C3t3>& constraints = User_constraints_3<C3t3>())
    : c3t3_(c3t3)
    , fields_(fields)
    , domain_(domain, parameters.domain_is_thread_safe ? threads() : Thread_policy())
    , mesh_(c3t3, domain_, constraints, [&visitor](typename C3t3::Vertex_handle v) { tell_of_removal(visitor, v); })
    , task_(task)
    , parameters_(parameters)
    , visitor_(visitor)
  {}

  // Threads refer to the clock.
  Odt_mesh_optimizer_3(const Odt_mesh_optimizer_3&) = delete;
  Odt_mesh_optimizer_3& operator=(const Odt_mesh_optimizer_3&) = delete;

  Mesh_optimization_return_code operator()()
  {
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(is_domain_of_mesh(c3t3_, domain_, dual_point_and_centroid), wrong_domain);
    if(Has_facets_of_mesh<Mesh_domain>::value && has_facets_of_mesh(domain_, c3t3_))
      domain_.set_cells_of_mesh();
    const User_field_3 field = fields_.of_mesh([this](int v) { return mesh_.vertex(v); },
                                               [this](const Vertex_stratum& s) { return domain_.index(s.dimension, s.place); });
    return optimize_mesh(mesh_, domain_, task_, parameters_, field, visitor_, threads());
  }

  // The same, with a report.
  Mesh_optimization_return_code operator()(Mesh_optimization_report_3<C3t3>& report)
  {
    report = Mesh_optimization_report_3<C3t3>();
    visitor_.summary = &report;
    const Mesh_optimization_return_code code = (*this)();
    for(int v : visitor_.obstacles)
      if(report.reason == Mesh_optimization_summary_3::NO_VALID_MESH && mesh_.has_vertex(v))
        report.obstacles.push_back(mesh_.vertex(v));
    report.released_cells = mesh_.released_cells();
    for(int n = 0; n < Stage_clock::NUMBER_OF_STAGES; ++n)
      report.seconds.emplace_back(Stage_clock::name(n), clock_.seconds(n));
    return code;
  }

  const Stage_clock& clock() const { return clock_; }

private:
  // A mesh from elsewhere may have inverted cells, of which CGAL gives no dual point, or flat ones, of which it is anywhere.
  static std::array<Vector_3, 2> dual_point_and_centroid(typename C3t3::Cell_handle c)
  {
    const std::array<Site, 4> s = sites_of(*c);
    const Vector_3 dual = position(s[0]) + Cell_products(s[0], s[1], s[2], s[3]).to_dual();
    return {{ dual, centroid(s) }};
  }

  Thread_policy threads() { return Thread_policy::for_tag<typename C3t3::Triangulation::Concurrency_tag>().with(clock_); }

  Stage_clock clock_;
  const C3t3& c3t3_;
  const User_fields_3<C3t3> fields_;
  Mesh_domain_view_3<Mesh_domain> domain_;
  C3t3_view_3<C3t3, Mesh_domain> mesh_;
  Odt_task task_;
  const Odt_parameters& parameters_;
  User_visitor<Visitor> visitor_;
};

template <class C3T3>
constexpr bool is_periodic = std::is_same<typename C3T3::Triangulation::Periodic_tag, Tag_true>::value;

// What odt_optimize_mesh_3() reads for periodic meshes, and for others.
typedef Parameter_list<tags::time_limit, tags::max_iteration_number, tags::convergence, tags::freeze_bound, tags::do_freeze,
                       tags::sliver_bound, internal_np::do_remove_slivers_t, internal_np::annealing_schedule_t,
                       internal_np::number_of_rounds_t, internal_np::optimize_boundary_t, internal_np::surface_weight_t,
                       internal_np::random_seed_t, internal_np::callback_t, internal_np::optimization_report_t> Periodic_parameters;
typedef Parameter_list<internal_np::do_insert_vertices_t, internal_np::do_remove_vertices_t, internal_np::number_of_vertices_t,
                       tags::sizing_field, internal_np::density_t, internal_np::quadrature_t, internal_np::domain_is_thread_safe_t,
                       internal_np::vertex_is_constrained_t, internal_np::facet_is_constrained_t, internal_np::cell_selector_t,
                       tags::facet_distance, internal_np::visitor_t> Other_parameters;
template <class C3T3>
using Optimization_parameters = std::conditional_t<is_periodic<C3T3>, Periodic_parameters,
                                                   decltype(Periodic_parameters() + Other_parameters())>;

template <class T>
T& unwrap(T& t) { return t; }

template <class T>
T& unwrap(std::reference_wrapper<T>& t) { return t.get(); }

// The visitor among the arguments, or else one that does nothing.
template <class C3T3, class Arguments>
auto find_visitor(const Arguments& arguments)
{
  if constexpr (Arguments::template has<internal_np::visitor_t>)
    return arguments.template get<internal_np::visitor_t>();
  else
    return Mesh_3::Null_global_optimizer_visitor<C3T3>();
}

// Calls the optimizer, with the report among the arguments if there is one.
template <class C3T3, class Optimizer, class Arguments>
Mesh_optimization_return_code call_with_report(Optimizer&& optimizer, const Arguments& arguments)
{
  if constexpr (Arguments::template has<internal_np::optimization_report_t>)
  {
    typedef std::decay_t<decltype(arguments.template get<internal_np::optimization_report_t>())> Given;
    constexpr bool is_report = std::is_same<Given, std::reference_wrapper<Mesh_optimization_report_3<C3T3> > >::value;
    static_assert(is_report, "optimization_report must be std::ref(r), r being a Mesh_optimization_report_3 of the type of the mesh");
    if constexpr (is_report)
      return optimizer(arguments.template get<internal_np::optimization_report_t>().get());
    else
      return CANT_IMPROVE_ANYMORE;
  }
  else
    return optimizer();
}

template <class C3T3, class MeshDomain, class Arguments>
Mesh_optimization_return_code
optimize(C3T3& c3t3, const MeshDomain& domain, Odt_task task, const Odt_parameters& p, const Arguments& arguments)
{
  User_fields_3<C3T3> fields;
  fields.read(arguments);
  p.check();
  fields.check();
  static_assert(Is_mesh_domain<MeshDomain>::value, "the second argument is no MeshDomain_3");
  if constexpr (!Is_mesh_domain<MeshDomain>::value || !Arguments::are_valid)
    return CANT_IMPROVE_ANYMORE;
  else
  {
    const auto& tr = c3t3.triangulation();
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(
      std::none_of(tr.finite_vertices_begin(), tr.finite_vertices_end(), [](const auto& v) { return v.in_dimension() > 2 && v.point().weight() != 0; }),
      "c3t3 must not have weights on vertices inside of subdomains: call this function before exude_mesh_3(), and give no_exude() to "
      "make_mesh_3()");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(tr.number_of_cells() <= Indexed_triangulation_3::most_cells,
                                           "c3t3 must not have more than 268,435,456 cells");
    if constexpr (is_periodic<C3T3>)
      return call_with_report<C3T3>(Periodic_mesh_optimizer_3<C3T3, MeshDomain>(c3t3, domain, p), arguments);
    else
    {
      User_constraints_3<C3T3> constraints;
      constraints.read(c3t3, arguments);
      auto visitor = find_visitor<C3T3>(arguments);
      typedef std::decay_t<decltype(unwrap(visitor))> Visitor;
      return call_with_report<C3T3>(Odt_mesh_optimizer_3<C3T3, MeshDomain, Visitor>(c3t3, domain, task, p, unwrap(visitor), fields, constraints), arguments);
    }
  }
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_OPTIMIZE_MESH_3_H
