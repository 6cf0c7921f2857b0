// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Each of these calls has an argument that is no good, and must not compile. Its #line directive
// gives the name under which check_refusals.cmake looks for the error, and the comment before says what the error is to say.
// Those of old_... exist before CGAL 5.6 only, those of new_... from there on.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_energy_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/property_map.h>
#include <CGAL/remesh_boundary_mesh_3.h>
#include <CGAL/remove_slivers_mesh_3.h>
#include <CGAL/tags.h>
#include <CGAL/version.h>

#include <map>
#include <set>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Labeled_mesh_domain_3<Kernel> Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type Triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> C3t3;
namespace params = CGAL::parameters;

struct Periodic_c3t3
{
  struct Triangulation { typedef CGAL::Tag_true Periodic_tag; };
};

template <class... NamedParameters>
void periodic_call(const NamedParameters&... np)
{
  namespace odt = CGAL::Global_odt_mesh_3::internal;
  odt::Named_arguments<odt::Optimization_parameters<Periodic_c3t3>, NamedParameters...> arguments(np...);
}

// Message: is no named parameter: write parameters::name = value
void no_parameters(C3t3& c3t3, const Domain& domain)
{
#if CGAL_VERSION_NR < 1050600000
#line 1 "old_sixth_number"
  CGAL::odt_optimize_mesh_3(c3t3, domain, 10, 5, 0.1, 0.1, false, 7);
#else
#line 1 "new_number"
  CGAL::odt_optimize_mesh_3(c3t3, domain, 10);
#line 1 "new_second_number"
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::time_limit = 10, 5.);
#endif
#line 1 "literal"
  CGAL::odt_optimize_mesh_3(c3t3, domain, "time_limit");
#line 1 "string"
  CGAL::remesh_boundary_mesh_3(c3t3, domain, std::string("time_limit"));
#line 1 "slivers_string"
  CGAL::remove_slivers_mesh_3(c3t3, domain, std::string("sliver_bound"));
#if CGAL_VERSION_NR >= 1050600000
#line 1 "new_slivers_number"
  CGAL::remove_slivers_mesh_3(c3t3, domain, 20.);
#endif
#line 1 "field_without_name"
  CGAL::odt_energy_3(c3t3, [](const Kernel::Point_3&) { return 1.; });
}

// Message: is none of those that this function reads
void not_read(C3t3& c3t3, const Domain& domain)
{
#line 1 "sliver_criterion"
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::sliver_criterion = 1);
#line 1 "verbose"
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::verbose(true));
#line 1 "verbose_in_chain"
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::random_seed(1).verbose(true));
#line 1 "verbose_in_front"
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::verbose(true).random_seed(1));
#line 1 "remeshing_sliver_bound"
  CGAL::remesh_boundary_mesh_3(c3t3, domain, params::sliver_bound = 10);
#line 1 "remeshing_rounds"
  CGAL::remesh_boundary_mesh_3(c3t3, domain, params::number_of_rounds = 4);
#line 1 "remeshing_removal"
  CGAL::remesh_boundary_mesh_3(c3t3, domain, params::do_remove_slivers = false);
#line 1 "remeshing_weight"
  CGAL::remesh_boundary_mesh_3(c3t3, domain, params::surface_weight = 1);
#line 1 "slivers_rounds"
  CGAL::remove_slivers_mesh_3(c3t3, domain, params::number_of_rounds = 4);
#line 1 "slivers_removal"
  CGAL::remove_slivers_mesh_3(c3t3, domain, params::do_remove_slivers = true);
#line 1 "slivers_weight"
  CGAL::remove_slivers_mesh_3(c3t3, domain, params::surface_weight = 1);
#line 1 "slivers_convergence"
  CGAL::remove_slivers_mesh_3(c3t3, domain, params::sliver_bound = 20, params::convergence = 0.1);
#line 1 "slivers_iterations"
  CGAL::remove_slivers_mesh_3(c3t3, domain, params::max_iteration_number = 10);
#line 1 "slivers_sizing_field"
  CGAL::remove_slivers_mesh_3(c3t3, domain, params::sizing_field = 1.);
#line 1 "slivers_density"
  CGAL::remove_slivers_mesh_3(c3t3, domain, params::density([](const Kernel::Point_3&) { return 1.; }));
#line 1 "slivers_criterion"
  CGAL::remove_slivers_mesh_3(c3t3, domain, params::sliver_criterion = 1);
#line 1 "slivers_verbose_in_chain"
  CGAL::remove_slivers_mesh_3(c3t3, domain, params::random_seed(1).verbose(true));
#line 1 "energy_time_limit"
  CGAL::odt_energy_3(c3t3, params::time_limit = 10);
#line 1 "energy_random_seed"
  CGAL::odt_energy_3(c3t3, params::random_seed(1));
#line 1 "periodic_insertion"
  periodic_call(params::do_insert_vertices = true);
#line 1 "periodic_removal"
  periodic_call(params::do_remove_vertices = true);
#line 1 "periodic_distance"
  periodic_call(params::facet_distance = 1);
#line 1 "periodic_facets"
  periodic_call(params::facet_is_constrained_map(CGAL::Constant_property_map<int, bool>(true)));
#line 1 "energy_distance"
  CGAL::odt_energy_3(c3t3, params::facet_distance = 1);
#line 1 "periodic_sizes"
  periodic_call(params::sizing_field = 1);
}

// Message: is given twice
void given_twice(C3t3& c3t3, const Domain& domain)
{
#line 1 "twice"
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::time_limit = 10, params::time_limit = 20);
#line 1 "distance_twice"
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::facet_distance = 1, params::facet_distance = 2);
#line 1 "twice_in_chain"
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::random_seed(1).random_seed(2));
#line 1 "slivers_twice"
  CGAL::remove_slivers_mesh_3(c3t3, domain, params::sliver_bound = 10, params::sliver_bound = 20);
#line 1 "removal_twice"
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_remove_slivers = true, params::do_remove_slivers = false);
#line 1 "weight_twice"
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::surface_weight = 1, params::surface_weight(2));
#if CGAL_VERSION_NR < 1050600000
#line 1 "old_twice_by_position"
  CGAL::odt_optimize_mesh_3(c3t3, domain, 10, params::time_limit = 20);
#endif
}

// Message: the second argument is no MeshDomain_3
void no_domain(C3t3& c3t3, const CGAL::Mesh_criteria_3<Triangulation>& criteria)
{
#line 1 "criteria_as_domain"
  CGAL::odt_optimize_mesh_3(c3t3, criteria);
#line 1 "domain_forgotten"
  CGAL::odt_optimize_mesh_3(c3t3, params::time_limit = 10, params::do_freeze = true);
#line 1 "remeshing_criteria_as_domain"
  CGAL::remesh_boundary_mesh_3(c3t3, criteria);
#line 1 "slivers_domain_forgotten"
  CGAL::remove_slivers_mesh_3(c3t3, params::sliver_bound = 20);
}

// Message: need a ReadablePropertyMap
void no_map(C3t3& c3t3, const Domain& domain)
{
#line 1 "set_as_map"
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::vertex_is_constrained_map(std::set<C3t3::Vertex_handle>()));
#line 1 "map_as_map"
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::cell_is_selected_map(std::map<C3t3::Cell_handle, bool>()));
#line 1 "function_as_map"
  CGAL::remove_slivers_mesh_3(c3t3, domain, params::vertex_is_constrained_map([](C3t3::Vertex_handle) { return true; }));
#line 1 "set_of_facets_as_map"
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::facet_is_constrained_map(std::set<C3t3::Facet>()));
#line 1 "slivers_map_of_vertices_for_facets"
  CGAL::remove_slivers_mesh_3(c3t3, domain,
                              params::facet_is_constrained_map(CGAL::Boolean_property_map<std::set<C3t3::Vertex_handle> >()));
#line 1 "remeshing_function_of_facets"
  CGAL::remesh_boundary_mesh_3(c3t3, domain, params::facet_is_constrained_map([](C3t3::Facet) { return true; }));
#line 1 "map_of_strings"
  CGAL::remesh_boundary_mesh_3(c3t3, domain, params::cell_is_selected_map(CGAL::Constant_property_map<C3t3::Cell_handle, std::string>()));
}

// Message: sizing_field must be a number, or be called as f(p, dimension, index) and return one
void no_sizing_field(C3t3& c3t3, const Domain& domain)
{
#line 1 "field_of_one_argument"
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::sizing_field = [](const Kernel::Point_3&) { return 1.; });
#line 1 "string_as_field"
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::sizing_field = std::string("1"));
#line 1 "field_of_strings"
  CGAL::remesh_boundary_mesh_3(c3t3, domain, params::sizing_field = [](const Kernel::Point_3&, int, const Domain::Index&)
                                                                    { return std::string(); });
#line 1 "energy_field_of_one_argument"
  CGAL::odt_energy_3(c3t3, params::sizing_field = [](const Kernel::Point_3&) { return 1.; });
}

// Message: density must be called as f(p) and return a number
void no_density(C3t3& c3t3, const Domain& domain)
{
#line 1 "number_as_density"
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::density = 1.);
#line 1 "density_of_three_arguments"
  CGAL::odt_energy_3(c3t3, params::density = [](const Kernel::Point_3&, int, const Domain::Index&) { return 1.; });
}

// Message: callback must be called as f(x), x being the fraction done, and return bool
void no_callback(C3t3& c3t3, const Domain& domain)
{
#line 1 "callback_without_value"
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::callback([](double) {}));
#line 1 "slivers_callback_without_argument"
  CGAL::remove_slivers_mesh_3(c3t3, domain, params::callback([] { return true; }));
}

// Message: cannot have a value of this type
void no_value(C3t3& c3t3, const Domain& domain)
{
#line 1 "literal_as_truth"
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_insert_vertices = "yes");
#line 1 "pointer_as_truth"
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_freeze = &domain);
#line 1 "string_as_distance"
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::facet_distance = std::string("0.1"));
#line 1 "slivers_field_as_distance"
  CGAL::remove_slivers_mesh_3(c3t3, domain, params::facet_distance = [](const Kernel::Point_3&) { return 0.1; });
#line 1 "remeshing_literal_as_distance"
  CGAL::remesh_boundary_mesh_3(c3t3, domain, params::facet_distance = "0.1");
#line 1 "string_as_time"
  CGAL::remove_slivers_mesh_3(c3t3, domain, params::time_limit = std::string("10"));
#line 1 "string_as_count"
  CGAL::remesh_boundary_mesh_3(c3t3, domain, params::max_iteration_number = std::string("10"));
#line 1 "number_as_schedule"
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::annealing_schedule = 1);
}

// Message: this named parameter is read by
void in_odt_of_the_mesher()
{
#line 1 "odt_rounds"
  params::odt(params::number_of_rounds = 40);
#line 1 "odt_time_limit_and_boundary"
  params::odt(params::time_limit = 10, params::optimize_boundary = false);
#line 1 "odt_removal"
  params::odt(params::do_remove_slivers = false);
#line 1 "odt_weight"
  params::odt(params::surface_weight = 1);
#if CGAL_VERSION_NR >= 1050600000
#line 1 "new_odt_schedule_in_chain"
  params::odt(params::annealing_schedule(CGAL::Momentum_annealing_schedule()).time_limit(10));
#endif
}
