// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A polyhedral domain with sharp features: vertices on them, with the balls that
// protect them, stay, and no other vertex enters a ball. Where edges on features are
// much shorter than those around, vertices are inserted.
//
//   optimize_mesh_with_features [surface.off [size relative to the bounding box]]

#include "mesh_picture.h"
#include "read_surface.h"
#include "write_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_polyhedron_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Mesh_polyhedron_3<K>::type Polyhedron;
typedef CGAL::Polyhedral_mesh_domain_with_features_3<K> Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type Tr;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Tr, Domain::Corner_index, Domain::Curve_index> C3t3;
typedef CGAL::Mesh_criteria_3<Tr> Criteria;
namespace params = CGAL::parameters;

int main(int argc, char* argv[])
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off");
  const double relative_size = argc > 2 ? std::atof(argv[2]) : 0.02;
  if(!(relative_size > 0 && relative_size < 1))
  {
    std::cerr << "the relative size must be between 0 and 1\n";
    return EXIT_FAILURE;
  }
  Polyhedron polyhedron;
  if(!read_surface(file, polyhedron))
    return EXIT_FAILURE;
  Domain domain(polyhedron);
  domain.detect_features();
  const CGAL::Bbox_3 box = domain.bbox();
  const double size = relative_size * std::hypot(box.x_span(), box.y_span(), box.z_span());
  const Criteria criteria(params::edge_size = size, params::facet_angle = 25, params::facet_size = size,
                          params::facet_distance = size / 10, params::cell_radius_edge_ratio = 3,
                          params::cell_size = size);
  C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::no_exude());
  const C3t3 before(c3t3);
  std::cout << "--- before ---\n" << CGAL::mesh_quality_report_3(before, criteria);
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_insert_vertices = true);
  std::cout << "--- after ---\n" << CGAL::mesh_quality_report_3(c3t3, criteria)
            << c3t3.number_of_corners() << " corners and " << c3t3.number_of_edges_in_complex()
            << " edges of features are where they were\n";
  write_mesh(c3t3, "features");
  draw_before_and_after(before, c3t3, "features");
  return EXIT_SUCCESS;
}
