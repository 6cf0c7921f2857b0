// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// All of a pipeline, and no more: meshes a closed surface, optimizes the mesh, checks its angles, and writes it.
//
//   mesh_optimize_check_write [surface.off]

#include "read_surface.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/output_to_vtu.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_polyhedron_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <cstdlib>
#include <fstream>
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
  Polyhedron surface;
  if(!read_surface(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"), surface))
    return EXIT_FAILURE;
  const Domain domain(surface);
  const double size = (domain.bbox().xmax() - domain.bbox().xmin()) / 25;
  const Criteria criteria(params::facet_angle = 25, params::facet_size = size, params::facet_distance = size / 8,
                          params::cell_radius_edge_ratio = 3, params::cell_size = size);

  C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::no_exude());
  CGAL::odt_optimize_mesh_3(c3t3, domain);

  const double smallest_angle = CGAL::mesh_quality_report_3(c3t3).smallest_angle;
  std::cout << c3t3.number_of_cells_in_complex() << " cells, all dihedral angles above " << smallest_angle << " degrees\n";
  std::ofstream file("optimized.vtu", std::ios::binary);
  CGAL::IO::output_to_vtu(file, c3t3);
  return file && smallest_angle > 10 ? EXIT_SUCCESS : EXIT_FAILURE;
}
