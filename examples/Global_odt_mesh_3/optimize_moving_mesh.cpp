// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A body is stretched step by step. Its vertices are carried along, and the mesh is optimized after each step, with the domain at that
// time. The report tells what each call has done.

#include "torus_mesh.h"

#include <CGAL/Mesh_optimization_report_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>

// Stretched along the z axis at constant volume.
K::Point_3 stretched(const K::Point_3& p, double factor)
{
  return K::Point_3(p.x() / std::sqrt(factor), p.y() / std::sqrt(factor), p.z() * factor);
}

int main()
{
  constexpr double factor = 1.05;
  C3t3 c3t3 = torus_mesh(torus_domain());
  CGAL::odt_optimize_mesh_3(c3t3, torus_domain());
  double whole = 1;
  for(int step = 1; step <= 10; ++step)
  {
    whole *= factor;
    Tr& tr = c3t3.triangulation();
    for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
      v->set_point(Tr::Weighted_point(stretched(v->point().point(), factor)));
    // Cells keep their dual points unless they are told that vertices have moved.
    for(auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
      c->invalidate_weighted_circumcenter_cache();

    const Domain domain = Domain::create_implicit_mesh_domain([whole](const K::Point_3& p) { return torus(stretched(p, 1 / whole)); },
                                                              K::Sphere_3(CGAL::ORIGIN, 9.));
    CGAL::Mesh_optimization_report_3<C3t3> report;
    CGAL::odt_optimize_mesh_3(c3t3, domain, params::optimization_report = std::ref(report));
    std::cout << "--- stretched by " << whole << " ---\n" << report;
    if(!report.is_changed())
      std::cerr << "the mesh is as it was\n";
  }
  return EXIT_SUCCESS;
}
