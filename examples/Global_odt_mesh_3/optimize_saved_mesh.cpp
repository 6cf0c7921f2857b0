// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A mesh that is saved, and loaded by another program, which makes the domain anew: optimized there, it becomes the same as
// without the file. A lens with a sharp rim.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/File_binary_mesh_3.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_domain_with_polyline_features_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <set>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Mesh_domain_with_polyline_features_3<CGAL::Labeled_mesh_domain_3<K> > Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type Tr;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Tr, Domain::Corner_index, Domain::Curve_index> C3t3;
typedef CGAL::Mesh_criteria_3<Tr> Criteria;
namespace params = CGAL::parameters;

// Negative where two balls of radius 1 overlap.
inline double lens(const K::Point_3& p)
{
  return p.x() * p.x() + p.y() * p.y() + std::pow(std::abs(p.z()) + 0.6, 2) - 1;
}

inline Domain lens_domain()
{
  Domain domain = Domain::create_implicit_mesh_domain(lens, K::Sphere_3(CGAL::ORIGIN, 2.));
  const int number_of_points = 360;
  std::vector<K::Point_3> rim;
  for(int n = 0; n <= number_of_points; ++n)
  {
    const double angle = 2 * std::acos(-1.) * (n % number_of_points) / number_of_points;
    rim.emplace_back(0.8 * std::cos(angle), 0.8 * std::sin(angle), 0);
  }
  const std::vector<std::vector<K::Point_3> > features(1, rim);
  domain.add_features(features.begin(), features.end());
  return domain;
}

inline C3t3 make_and_save(const std::string& file)
{
  const Domain domain = lens_domain();
  const Criteria criteria(params::edge_size = 0.07, params::facet_angle = 25, params::facet_size = 0.07,
                          params::facet_distance = 0.007, params::cell_radius_edge_ratio = 2, params::cell_size = 0.07);
  const C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::no_exude());
  std::ofstream out(file, std::ios::binary);
  CGAL::IO::save_binary_file(out, c3t3);
  return c3t3;
}

inline std::set<K::Point_3> points(const C3t3& c3t3)
{
  std::set<K::Point_3> result;
  const Tr& tr = c3t3.triangulation();
  for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
    result.insert(v->point().point());
  return result;
}

int main()
{
  const std::string file = "lens.cgal";
  C3t3 made = make_and_save(file);
  std::cout << "--- before ---\n" << CGAL::mesh_quality_report_3(made);

  C3t3 loaded;
  std::ifstream in(file, std::ios::binary);
  if(!CGAL::IO::load_binary_file(in, loaded))
  {
    std::cerr << file << " cannot be read\n";
    return EXIT_FAILURE;
  }
  const Domain domain = lens_domain();
  CGAL::odt_optimize_mesh_3(loaded, domain);
  std::cout << "--- loaded and optimized ---\n" << CGAL::mesh_quality_report_3(loaded);

  CGAL::odt_optimize_mesh_3(made, domain);
  std::cout << "without the file, vertices are " << (points(made) == points(loaded) ? "at the same points\n" : "elsewhere\n");
  return EXIT_SUCCESS;
}
