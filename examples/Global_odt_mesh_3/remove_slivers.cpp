// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Slivers removed from a mesh that stays as it is elsewhere: up to an angle that is asked for, or as far as can be had.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/remove_slivers_mesh_3.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Labeled_mesh_domain_3<K> Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type Tr;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Tr> C3t3;
typedef CGAL::Mesh_criteria_3<Tr> Criteria;
namespace params = CGAL::parameters;

double torus(const K::Point_3& p)
{
  const double ring = std::sqrt(p.x() * p.x() + p.y() * p.y()) - 1;
  return ring * ring + p.z() * p.z() - 0.16;
}

int main()
{
  const Domain domain = Domain::create_implicit_mesh_domain(torus, K::Sphere_3(CGAL::ORIGIN, 4.));
  const Criteria criteria(params::facet_angle = 30, params::facet_size = 0.1, params::facet_distance = 0.01,
                          params::cell_radius_edge_ratio = 2, params::cell_size = 0.1);
  const C3t3 input = CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::no_exude());
  std::cout << "--- input ---\n" << CGAL::mesh_quality_report_3(input);

  C3t3 some_removed(input);
  if(CGAL::remove_slivers_mesh_3(some_removed, domain, params::sliver_bound = 20) == CGAL::CANT_IMPROVE_ANYMORE)
    std::cout << "cells below 20 degrees are left\n";
  std::cout << "--- up to 20 degrees ---\n" << CGAL::mesh_quality_report_3(some_removed);

  C3t3 all_removed(input);
  CGAL::remove_slivers_mesh_3(all_removed, domain);
  std::cout << "--- as far as can be had ---\n" << CGAL::mesh_quality_report_3(all_removed);
  return EXIT_SUCCESS;
}
