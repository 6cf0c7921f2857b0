// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A graded mesh: the optimizer gets the field of sizes with which the mesh has been made.
// Prints the mean edge length by distance from the center, and draws the mesh before and after.

#include "mesh_picture.h"
#include "write_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Labeled_mesh_domain_3<K> Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type Tr;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Tr> C3t3;
typedef CGAL::Mesh_criteria_3<Tr> Criteria;
namespace params = CGAL::parameters;

double distance_from_center(const K::Point_3& p)
{
  return std::sqrt(CGAL::squared_distance(p, K::Point_3(CGAL::ORIGIN)));
}

// Coarse in the middle, five times finer at the surface.
struct Size
{
  typedef K::FT FT;
  typedef K::Point_3 Point_3;
  typedef Domain::Index Index;
  FT operator()(const Point_3& p, int, const Index&) const
  {
    return 0.05 * (1 + 4 * (std::max)(0., 1 - distance_from_center(p)));
  }
};

std::array<double, 5> mean_edge_lengths(const C3t3& c3t3)
{
  std::array<double, 5> sum = {}, count = {};
  const Tr& tr = c3t3.triangulation();
  for(auto e = tr.finite_edges_begin(); e != tr.finite_edges_end(); ++e)
  {
    const K::Point_3 a = tr.point(e->first, e->second).point(), b = tr.point(e->first, e->third).point();
    const int bin = (std::min)(4, static_cast<int>(5 * distance_from_center(CGAL::midpoint(a, b))));
    sum[bin] += std::sqrt(CGAL::squared_distance(a, b));
    ++count[bin];
  }
  for(int n = 0; n < 5; ++n)
    sum[n] /= (std::max)(1., count[n]);
  return sum;
}

int main()
{
  const Domain domain = Domain::create_implicit_mesh_domain(
    [](const K::Point_3& p) { return distance_from_center(p) - 1; }, K::Sphere_3(CGAL::ORIGIN, 2.));
  const Criteria criteria(params::facet_angle = 30, params::facet_size = 0.06, params::facet_distance = 0.01,
                          params::cell_radius_edge_ratio = 2, params::cell_size = Size());
  C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::no_exude());
  const C3t3 input(c3t3);
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::sizing_field = Size());
  const auto before = mean_edge_lengths(input), after = mean_edge_lengths(c3t3);
  std::cout << "mean edge length by distance from the center, before and after\n";
  for(int n = 0; n < 5; ++n)
    std::cout << n / 5. << " - " << (n + 1) / 5. << "   " << before[n] << "   " << after[n] << '\n';
  write_mesh(c3t3, "graded");
  draw_before_and_after(input, c3t3, "graded", 1);
  return EXIT_SUCCESS;
}
