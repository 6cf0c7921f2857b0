// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// One period of a gyroid, with a subdomain on each side of the surface.

#include <CGAL/Periodic_3_mesh_3/config.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Periodic_3_mesh_triangulation_3.h>
#include <CGAL/make_periodic_3_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <algorithm>
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

double smallest_dihedral_angle(const C3t3& c3t3)
{
  double smallest = 180;
  for(C3t3::Cells_in_complex_iterator c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
  {
    const K::Tetrahedron_3 t = c3t3.triangulation().tetrahedron(c);
    for(int i = 0; i < 3; ++i)
      for(int j = i + 1; j < 4; ++j)
      {
        const int k = (i == 0 ? (j == 1 ? 2 : 1) : 0), l = 6 - i - j - k;
        smallest = (std::min)(smallest, std::abs(CGAL::approximate_dihedral_angle(t[i], t[j], t[k], t[l])));
      }
  }
  return smallest;
}

int main()
{
  const Domain domain(side_of_gyroid, K::Iso_cuboid_3(0, 0, 0, 1, 1, 1));
  const Criteria criteria(params::facet_angle = 30, params::facet_size = 0.08, params::facet_distance = 0.02,
                          params::cell_radius_edge_ratio = 2, params::cell_size = 0.08);
  C3t3 c3t3 = CGAL::make_periodic_3_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::no_exude());
  std::cout << c3t3.number_of_cells_in_complex() << " cells, smallest dihedral angle " << smallest_dihedral_angle(c3t3) << std::endl;

  CGAL::odt_optimize_mesh_3(c3t3, domain);
  std::cout << c3t3.number_of_cells_in_complex() << " cells, smallest dihedral angle " << smallest_dihedral_angle(c3t3) << std::endl;
  return EXIT_SUCCESS;
}
