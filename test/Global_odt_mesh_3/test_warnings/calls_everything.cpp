// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Instantiates all that the package offers, to be compiled with as many warnings as a user may have switched on.

#ifdef OUR_HEADERS_FIRST
#  include <CGAL/odt_optimize_mesh_3.h>
#endif

#include <CGAL/Annealing_schedules_3.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Density_quadratures_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Feature_edge_size_field_3.h>
#include <CGAL/Local_feature_size_field_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Quadratic_density_3.h>
#include <CGAL/Spline_grid_field_3.h>
#include <CGAL/Tetrahedral_mesh_domain_3.h>
#include <CGAL/complete_mesh_complex_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_energy_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/odt_optimize_tetrahedral_mesh_3.h>
#include <CGAL/property_map.h>
#include <CGAL/remesh_boundary_mesh_3.h>
#include <CGAL/remove_slivers_mesh_3.h>
#include <CGAL/version.h>

#include <cstddef>
#include <functional>
#include <iostream>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
namespace params = CGAL::parameters;

struct Visitor
{
  void after_compute_moves() {}
  void after_move_points() {}
  void after_rebuild_restricted_delaunay() {}
  void end_of_iteration(int) {}
  void after_sliver_removal(std::size_t) {}
};

template <class C3t3, class Domain>
void call_functions(C3t3& c3t3, const Domain& domain)
{
  CGAL::odt_optimize_mesh_3(c3t3, domain);
  Visitor visitor;
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::time_limit = 10, params::max_iteration_number = 5, params::convergence = 0.1,
                            params::freeze_bound = 0.1, params::do_freeze = true, params::optimize_boundary = false,
                            params::annealing_schedule = CGAL::Metropolis_annealing_schedule(), params::number_of_rounds = 2, params::surface_weight = 1,
                            params::sliver_bound = 30, params::do_remove_slivers = true, params::domain_is_thread_safe = true,
                            params::random_seed(1), params::callback([](double) { return true; }),
                            params::visitor(std::ref(visitor)));
  const CGAL::Local_feature_size_field_3<Domain> size(domain), of_mesh = size.from_mesh(c3t3),
                                                 of_points = size.from_points(std::vector<Point_3>(2));
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::sizing_field = size, params::quadrature = CGAL::Adaptive_cubature_3());
  CGAL::remesh_boundary_mesh_3(c3t3, domain, params::sizing_field = std::cref(of_mesh));
  CGAL::odt_energy_3(c3t3, params::sizing_field = of_points);
  const CGAL::Feature_edge_size_field_3<C3t3> from_edges(c3t3, 1);
  CGAL::odt_energy_3(c3t3, params::sizing_field = from_edges);
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_insert_vertices = true, params::do_remove_vertices = true,
                            params::number_of_vertices = 100);
  CGAL::remove_slivers_mesh_3(c3t3, domain, params::time_limit = 10, params::sliver_bound = 30, params::optimize_boundary = false,
                              params::random_seed(1), params::callback([](double) { return true; }),
                              params::visitor(std::ref(visitor)));

  const CGAL::Constant_property_map<typename C3t3::Vertex_handle, bool> no_vertex(false);
  const CGAL::Constant_property_map<typename C3t3::Cell_handle, bool> all_cells(true);
  const CGAL::Constant_property_map<typename C3t3::Facet, bool> no_facet(false);
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::vertex_is_constrained_map(no_vertex), params::cell_is_selected_map(all_cells),
                            params::facet_is_constrained_map(no_facet), params::facet_distance = 0.1);
  CGAL::remesh_boundary_mesh_3(c3t3, domain, params::vertex_is_constrained_map(no_vertex), params::cell_is_selected_map(all_cells),
                               params::facet_is_constrained_map(no_facet), params::facet_distance = 0.1);
  CGAL::remove_slivers_mesh_3(c3t3, domain, params::vertex_is_constrained_map(no_vertex), params::cell_is_selected_map(all_cells),
                              params::facet_is_constrained_map(no_facet), params::facet_distance = 0.1);
#if CGAL_VERSION_NR >= 1050600000
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::facet_distance(0.1).facet_is_constrained_map(no_facet).random_seed(1));
#endif

  const CGAL::Spline_grid_field_3<Kernel> field(CGAL::Bbox_3(0, 0, 0, 1, 1, 1), 5, 5, 5, [](const Point_3&) { return 1.; });
  field.gradient(Point_3(0, 0, 0));
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::density = field, params::quadrature = CGAL::Four_point_rule_3());
  CGAL::odt_energy_3(c3t3, params::density = CGAL::Quadratic_density_3<Kernel>::squared_distance());
  std::cout << CGAL::mesh_quality_report_3(c3t3);
}

template <class Domain>
void mesh(const Domain& domain)
{
  typedef typename CGAL::Mesh_triangulation_3<Domain>::type Triangulation;
  typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> C3t3;
  const CGAL::Mesh_criteria_3<Triangulation> criteria(params::facet_size = 1, params::cell_size = 1);
  C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria, params::odt());
  call_functions(c3t3, domain);

  // The mesh as its own domain, which the mesh generator accepts, too.
  CGAL::complete_mesh_complex_3(c3t3, 60);
  CGAL::odt_optimize_tetrahedral_mesh_3(c3t3, params::time_limit = 10);
  const CGAL::Tetrahedral_mesh_domain_3<C3t3> of_mesh(c3t3);
  c3t3 = CGAL::make_mesh_3<C3t3>(of_mesh, criteria);
}

int main()
{
  mesh(CGAL::Labeled_mesh_domain_3<Kernel>::create_implicit_mesh_domain([](const Point_3& p) { return p.x(); },
                                                                        Kernel::Sphere_3(CGAL::ORIGIN, 1.)));
  mesh(CGAL::Polyhedral_mesh_domain_with_features_3<Kernel>(CGAL::Mesh_polyhedron_3<Kernel>::type()));
}
