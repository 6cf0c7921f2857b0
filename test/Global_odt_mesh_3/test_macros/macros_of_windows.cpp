// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The headers of the package do not mind macros that those of Windows define. Not all headers of others survive
// near, far and small; these come first. The mesh generator includes odt_optimize_mesh_3.h, which is kept for later.

#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))

#define CGAL_ODT_OPTIMIZE_MESH_3_H
#include <CGAL/make_mesh_3.h>
#undef CGAL_ODT_OPTIMIZE_MESH_3_H

#include <CGAL/AABB_tree.h>
#if __has_include(<CGAL/AABB_traits_3.h>)
#  include <CGAL/AABB_traits_3.h>
#  include <CGAL/AABB_triangle_primitive_3.h>
#else
#  include <CGAL/AABB_traits.h>
#  include <CGAL/AABB_triangle_primitive.h>
#endif
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_3/Mesh_global_optimizer.h>
#include <CGAL/Mesh_3/Mesh_sizing_field.h>
#include <CGAL/Mesh_3/Odt_move.h>
#include <CGAL/Mesh_3/internal/check_weights.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_domain_with_polyline_features_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Robust_weighted_circumcenter_filtered_traits_3.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/boost/graph/split_graph_into_polylines.h>
#include <CGAL/spatial_sort.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR < 1050600000
#  include <boost/parameter.hpp>
#endif
#include <Eigen/Dense>
#include <boost/functional/hash.hpp>
#include <boost/graph/adjacency_list.hpp>

#include <chrono>
#include <iomanip>
#include <optional>
#include <random>
#include <sstream>
#include <unordered_map>
#include <variant>

#define far
#define near
#define interface struct
#define small char

#include <CGAL/Annealing_schedules_3.h>
#include <CGAL/Density_quadratures_3.h>
#include <CGAL/Feature_edge_size_field_3.h>
#include <CGAL/Local_feature_size_field_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Quadratic_density_3.h>
#include <CGAL/Spline_grid_field_3.h>
#include <CGAL/Tetrahedral_mesh_domain_3.h>
#include <CGAL/complete_mesh_complex_3.h>
#include <CGAL/odt_energy_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/odt_optimize_tetrahedral_mesh_3.h>
#include <CGAL/remesh_boundary_mesh_3.h>
#include <CGAL/remove_slivers_mesh_3.h>

#ifdef CGAL_GLOBAL_ODT_MESH_3_INLINE
#  error "a macro is left that is of no use outside"
#endif

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Labeled_mesh_domain_3<Kernel> Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type Triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> C3t3;

int main()
{
  // The mesh generator finds the function that was kept for later.
  const Domain domain = Domain::create_implicit_mesh_domain(
    [](const Kernel::Point_3& p) { return CGAL::squared_distance(p, Kernel::Point_3(CGAL::ORIGIN)) - 1; },
    Kernel::Sphere_3(CGAL::ORIGIN, 2.));
  const CGAL::Mesh_criteria_3<Triangulation> criteria(
    CGAL::parameters::facet_angle = 25, CGAL::parameters::facet_size = 0.5, CGAL::parameters::cell_size = 0.5);
  C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria, CGAL::parameters::odt());
  CGAL::remove_slivers_mesh_3(c3t3, domain, CGAL::parameters::sliver_bound = 20);
  CGAL::complete_mesh_complex_3(c3t3);
  CGAL::odt_optimize_tetrahedral_mesh_3(c3t3);
  return c3t3.triangulation().is_valid() ? 0 : 1;
}
