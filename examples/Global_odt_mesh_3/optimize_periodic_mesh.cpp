// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// One period of a gyroid, with a subdomain on each side of the surface.

#include <CGAL/Periodic_3_mesh_3/config.h>

#include "mesh_picture.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Periodic_3_mesh_triangulation_3.h>
#include <CGAL/make_periodic_3_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Labeled_mesh_domain_3<K> Domain;
typedef CGAL::Periodic_3_mesh_triangulation_3<Domain>::type Tr;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Tr> C3t3;
typedef CGAL::Mesh_criteria_3<Tr> Criteria;
namespace params = CGAL::parameters;

// A function of period 1 in each direction.
int side_of_gyroid(const K::Point_3& p)
{
  const double x = 2 * CGAL_PI * p.x(), y = 2 * CGAL_PI * p.y(), z = 2 * CGAL_PI * p.z();
  return std::cos(x) * std::sin(y) + std::cos(y) * std::sin(z) + std::cos(z) * std::sin(x) < 0 ? 1 : 2;
}

int main()
{
  const Domain domain(side_of_gyroid, K::Iso_cuboid_3(0, 0, 0, 1, 1, 1));
  const Criteria criteria(params::facet_angle = 30, params::facet_size = 0.08, params::facet_distance = 0.02,
                          params::cell_radius_edge_ratio = 2, params::cell_size = 0.08);
  C3t3 c3t3 = CGAL::make_periodic_3_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::no_exude());
  const C3t3 before(c3t3);
  std::cout << "--- before ---\n" << CGAL::mesh_quality_report_3(before);
  CGAL::odt_optimize_mesh_3(c3t3, domain);
  std::cout << "--- after ---\n" << CGAL::mesh_quality_report_3(c3t3);
  draw_before_and_after(before, c3t3, "periodic", 1);
  return EXIT_SUCCESS;
}
