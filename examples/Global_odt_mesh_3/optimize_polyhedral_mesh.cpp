// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes a closed polyhedral surface and optimizes the mesh: quality reports, meshes, and a picture of before and after.
//
//   optimize_polyhedral_mesh [surface.off [relative size [output prefix]]]
//
// The size of cells and facets is relative to the diagonal of the bounding box.

#include "mesh_picture.h"
#include "read_surface.h"
#include "terminal_progress.h"
#include "write_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_polyhedron_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/Real_timer.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Mesh_polyhedron_3<K>::type Polyhedron;
typedef CGAL::Polyhedral_mesh_domain_3<Polyhedron, K> Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type Tr;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Tr> C3t3;
typedef CGAL::Mesh_criteria_3<Tr> Criteria;
namespace params = CGAL::parameters;

int main(int argc, char* argv[])
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  const double relative_size = argc > 2 ? std::atof(argv[2]) : 0.0105;
  const std::string prefix = argc > 3 ? argv[3] : "optimized";
  if(!(relative_size > 0 && relative_size < 1))
  {
    std::cerr << "the relative size must be between 0 and 1\n";
    return EXIT_FAILURE;
  }
  Polyhedron polyhedron;
  if(!read_surface(file, polyhedron))
    return EXIT_FAILURE;
  std::cout << "meshing " << file << std::endl;
  const Domain domain(polyhedron);
  const CGAL::Bbox_3 box = domain.bbox();
  const double size = relative_size * std::hypot(box.x_span(), box.y_span(), box.z_span());
  const Criteria criteria(params::facet_angle = 25, params::facet_size = size, params::facet_distance = size / 8,
                          params::cell_radius_edge_ratio = 3, params::cell_size = size);
  C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::no_exude());
  const C3t3 before(c3t3);
  std::cout << "--- before ---\n" << CGAL::mesh_quality_report_3(before, criteria) << std::endl;

  CGAL::Real_timer timer;
  timer.start();
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::callback(Terminal_progress()));
  timer.stop();
  std::cout << "--- after " << timer.time() << " seconds ---\n" << CGAL::mesh_quality_report_3(c3t3, criteria) << std::endl;

  write_mesh(before, prefix + "_before");
  write_mesh(c3t3, prefix + "_after");
  draw_before_and_after(before, c3t3, prefix);
  return EXIT_SUCCESS;
}
