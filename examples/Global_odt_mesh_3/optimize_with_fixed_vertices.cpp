// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Vertices at which a simulation takes its samples stay where they are, while all others move.

#include "torus_mesh.h"

#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/property_map.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <set>

typedef C3t3::Vertex_handle Vertex_handle;

// The vertex that is nearest to a point on the circle in the middle of the torus.
Vertex_handle vertex_at(const C3t3& c3t3, double angle)
{
  return c3t3.triangulation().nearest_power_vertex(K::Point_3(std::cos(angle), std::sin(angle), 0));
}

int main()
{
  const Domain domain = torus_domain();
  C3t3 c3t3 = torus_mesh(domain);
  std::cout << "--- input ---\n" << CGAL::mesh_quality_report_3(c3t3);

  std::set<Vertex_handle> samples;
  for(int n = 0; n < 60; ++n)
    samples.insert(vertex_at(c3t3, 0.1 * n));
  const CGAL::Boolean_property_map<std::set<Vertex_handle> > is_sample(samples);
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::vertex_is_constrained_map(is_sample));
  std::cout << "--- optimized, but for " << samples.size() << " vertices ---\n" << CGAL::mesh_quality_report_3(c3t3);
  return EXIT_SUCCESS;
}
