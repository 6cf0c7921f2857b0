// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A density on a grid, interpolated by splines, and integrated by rules of more and more points. Prints the energy that
// each of them leads to, measured by adaptive cubature.

#include <CGAL/Density_quadratures_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Spline_grid_field_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_energy_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Labeled_mesh_domain_3<K> Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type Tr;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Tr> C3t3;
typedef CGAL::Mesh_criteria_3<Tr> Criteria;
typedef CGAL::Spline_grid_field_3<K> Density;
namespace params = CGAL::parameters;

double squared_distance_from_center(const K::Point_3& p)
{
  return CGAL::squared_distance(p, K::Point_3(CGAL::ORIGIN));
}

template <class Quadrature>
void optimize(C3t3 c3t3, const Domain& domain, const Density& density, const char* name, const Quadrature& quadrature)
{
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::density = density, params::quadrature = quadrature);
  std::cout << name << ": energy " << CGAL::odt_energy_3(c3t3, params::density = density) << std::endl;
}

int main()
{
  // Sizes in the middle are half of those at the surface.
  const Density density(CGAL::Bbox_3(-1, -1, -1, 1, 1, 1), 21, 21, 21, [](const K::Point_3& p)
                        { return 1 + 31 * std::exp(-4 * squared_distance_from_center(p)); });
  const Domain domain = Domain::create_implicit_mesh_domain(
    [](const K::Point_3& p) { return squared_distance_from_center(p) - 1; }, K::Sphere_3(CGAL::ORIGIN, 2.));
  const Criteria criteria(params::facet_angle = 30, params::facet_size = 0.15, params::facet_distance = 0.02,
                          params::cell_radius_edge_ratio = 2, params::cell_size = 0.12);
  const C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::no_exude());
  std::cout << "input: energy " << CGAL::odt_energy_3(c3t3, params::density = density) << std::endl;
  optimize(c3t3, domain, density, "linear interpolation", CGAL::Linear_density_rule_3());
  optimize(c3t3, domain, density, "four points", CGAL::Four_point_rule_3());
  optimize(c3t3, domain, density, "fifteen points", CGAL::Fifteen_point_rule_3());
  return EXIT_SUCCESS;
}
