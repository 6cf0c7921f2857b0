// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Optimizes a ball with a smaller one inside, and prints all positions to the last bit.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <cstdio>
#include <functional>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Labeled_mesh_domain_3<Kernel> Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type Triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> C3t3;
typedef CGAL::Mesh_criteria_3<Triangulation> Criteria;

namespace params = CGAL::parameters;

int main()
{
  const std::function<int(const Kernel::Point_3&)> label = [](const Kernel::Point_3& p)
  {
    const double d = p.x() * p.x() + p.y() * p.y() + p.z() * p.z();
    return d < 0.16 ? 2 : d < 1 ? 1 : 0;
  };
  const Domain domain(label, Kernel::Sphere_3(CGAL::ORIGIN, 4.));
  const Criteria criteria(params::facet_angle = 25, params::facet_size = 0.25, params::facet_distance = 0.03,
                          params::cell_radius_edge_ratio = 3, params::cell_size = 0.25);
  C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_exude(), params::no_perturb());
  const int code = CGAL::odt_optimize_mesh_3(c3t3, domain);
  std::printf("%d\n", code);
  for(const auto& v : c3t3.triangulation().finite_vertex_handles())
    std::printf("%a %a %a\n", v->point().x(), v->point().y(), v->point().z());
  return 0;
}
