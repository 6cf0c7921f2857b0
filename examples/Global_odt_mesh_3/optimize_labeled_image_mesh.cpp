// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A segmented image with several subdomains: vertices move inside, and on the interfaces between them.
//
//   optimize_labeled_image_mesh [image.inr.gz]

#include "mesh_picture.h"
#include "write_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Image_3.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Labeled_mesh_domain_3<K> Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type Tr;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Tr> C3t3;
typedef CGAL::Mesh_criteria_3<Tr> Criteria;
namespace params = CGAL::parameters;

int main(int argc, char* argv[])
{
  const std::string file = argc > 1 ? argv[1] : CGAL::data_file_path("images/liver.inr.gz");
  CGAL::Image_3 image;
  const bool is_there = std::ifstream(file).good();
  if(!is_there || !image.read(file.c_str()))
  {
    std::cerr << file << (is_there ? " is not an image that ImageIO can read\n" : " cannot be opened\n");
    return EXIT_FAILURE;
  }
  const Domain domain = Domain::create_labeled_image_mesh_domain(image);
  const Criteria criteria(params::facet_angle = 30, params::facet_size = 6, params::facet_distance = 2,
                          params::cell_radius_edge_ratio = 3, params::cell_size = 8);
  C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::no_exude());
  const C3t3 before(c3t3);
  std::cout << "--- before ---\n" << CGAL::mesh_quality_report_3(before);
  CGAL::odt_optimize_mesh_3(c3t3, domain);
  std::cout << "--- after ---\n" << CGAL::mesh_quality_report_3(c3t3);
  write_mesh(c3t3, "labeled_image");
  draw_before_and_after(before, c3t3, "labeled_image", 1);
  return EXIT_SUCCESS;
}
