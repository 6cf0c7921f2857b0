// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Two ways to a well-spaced boundary: the surface remeshed first and then fixed while the
// interior is optimized, or all vertices together.

#include "mesh_picture.h"
#include "torus_mesh.h"

#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/remesh_boundary_mesh_3.h>

#include <cstdlib>
#include <iostream>

int main()
{
  const Domain domain = torus_domain();
  const C3t3 input = torus_mesh(domain);
  std::cout << "--- input ---\n" << CGAL::mesh_quality_report_3(input);

  C3t3 remeshed(input);
  CGAL::remesh_boundary_mesh_3(remeshed, domain);
  std::cout << "--- boundary remeshed ---\n" << CGAL::mesh_quality_report_3(remeshed);
  CGAL::odt_optimize_mesh_3(remeshed, domain, params::optimize_boundary = false);
  std::cout << "--- then the interior ---\n" << CGAL::mesh_quality_report_3(remeshed);

  C3t3 together(input);
  CGAL::odt_optimize_mesh_3(together, domain);
  std::cout << "--- all together ---\n" << CGAL::mesh_quality_report_3(together);
  draw_before_and_after(input, together, "remeshed_boundary");
  return EXIT_SUCCESS;
}
