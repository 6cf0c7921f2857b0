// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes a closed polyhedral surface and optimizes the mesh: a summary, meshes, and pictures of before and after.
//
//   optimize_polyhedral_mesh [--histograms] [surface.off [relative size [output prefix]]]
//
// The size of cells and facets is relative to the diagonal of the bounding box. With --histograms, whole quality reports are printed.

#include "mesh_picture.h"
#include "print_summary.h"
#include "read_surface.h"
#include "terminal_progress.h"
#include "write_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_optimization_report_3.h>
#include <CGAL/Mesh_polyhedron_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/Real_timer.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Mesh_polyhedron_3<K>::type Polyhedron;
typedef CGAL::Polyhedral_mesh_domain_3<Polyhedron, K> Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type Tr;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Tr> C3t3;
typedef CGAL::Mesh_criteria_3<Tr> Criteria;
namespace params = CGAL::parameters;

int main(int argc, char* argv[])
{
  std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool wants_histograms = !arguments.empty() && arguments[0] == "--histograms";
  if(wants_histograms)
    arguments.erase(arguments.begin());
  const std::string file = arguments.size() > 0 ? arguments[0] : CGAL::data_file_path("meshes/elephant.off");
  const double relative_size = arguments.size() > 1 ? std::atof(arguments[1].c_str()) : 0.0105;
  const std::string prefix = arguments.size() > 2 ? arguments[2] : "optimized";
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

  CGAL::Mesh_optimization_report_3<C3t3> report;
  CGAL::Real_timer timer;
  timer.start();
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::callback(Terminal_progress()), params::optimization_report = std::ref(report));
  timer.stop();
  if(wants_histograms)
    std::cout << "--- before ---\n" << CGAL::mesh_quality_report_3(before, criteria)
              << "--- after ---\n" << CGAL::mesh_quality_report_3(c3t3, criteria) << '\n';
  print_summary(CGAL::mesh_quality_report_3(before, { 10, 20, 30 }), CGAL::mesh_quality_report_3(c3t3, { 10, 20, 30 }), report,
                timer.time());

  write_mesh(before, prefix + "_before");
  write_mesh(c3t3, prefix + "_after");
  draw_before_and_after(before, c3t3, prefix);
  draw_whole_and_cut(c3t3, prefix + "_whole");
  return EXIT_SUCCESS;
}
