// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The sizes are designed from the shape of the domain: fine where it is thin or bent, coarse inside. The same
// field goes to the mesh generator and to the optimizer. If a number of vertices is given, the field decides on
// the ratios of sizes, and the mesh gets that many.
//
//   optimize_by_local_feature_size [surface.off [number of vertices]]

#include "read_surface.h"
#include "write_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Local_feature_size_field_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_polyhedron_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

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
  Polyhedron polyhedron;
  if(!read_surface(file, polyhedron))
    return EXIT_FAILURE;
  const Domain domain(polyhedron);
  const CGAL::Local_feature_size_field_3<Domain> size(domain);
  const Criteria criteria(params::facet_angle = 25, params::facet_size = size,
                          params::facet_distance = size.parameters().smallest_size / 2,
                          params::cell_radius_edge_ratio = 2, params::cell_size = size);
  C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::no_exude());
  std::cout << "--- before ---\n" << CGAL::mesh_quality_report_3(c3t3);
  if(argc > 2)
    CGAL::odt_optimize_mesh_3(c3t3, domain, params::sizing_field = size, params::do_insert_vertices = true,
                              params::do_remove_vertices = true, params::number_of_vertices = std::strtoul(argv[2], nullptr, 10));
  else
    CGAL::odt_optimize_mesh_3(c3t3, domain, params::sizing_field = size);
  std::cout << "--- after ---\n" << CGAL::mesh_quality_report_3(c3t3);
  write_mesh(c3t3, "by_local_feature_size");
  return EXIT_SUCCESS;
}
