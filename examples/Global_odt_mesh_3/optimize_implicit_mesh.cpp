// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The shortest program: an implicit domain, meshed and optimized in one call.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <cstdlib>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Labeled_mesh_domain_3<K> Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type Tr;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Tr> C3t3;
typedef CGAL::Mesh_criteria_3<Tr> Criteria;
namespace params = CGAL::parameters;

double ellipsoid(const K::Point_3& p)
{
  return p.x() * p.x() + 2 * p.y() * p.y() + 4 * p.z() * p.z() - 1;
}

int main()
{
  const Domain domain = Domain::create_implicit_mesh_domain(ellipsoid, K::Sphere_3(CGAL::ORIGIN, 2.));
  const Criteria criteria(params::facet_angle = 30, params::facet_size = 0.1, params::facet_distance = 0.01,
                          params::cell_radius_edge_ratio = 2, params::cell_size = 0.1);

  const C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria, params::odt(params::time_limit = 10),
                                            params::no_perturb(), params::no_exude());
  std::cout << CGAL::mesh_quality_report_3(c3t3);
  return EXIT_SUCCESS;
}
