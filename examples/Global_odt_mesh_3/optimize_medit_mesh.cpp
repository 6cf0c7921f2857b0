// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A file in the format of Medit that holds no more than vertices, and tetrahedra with labels, as other programs write them: the
// domain is made of the mesh's own boundary. The example first writes two such files, with 17 and with 6 digits.
//
//   optimize_medit_mesh [mesh.mesh]

#include "complex_of_labels.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/File_medit.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_polyhedron_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_complex_mesh_domain_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Polyhedral_complex_mesh_domain_3<K, CGAL::Mesh_polyhedron_3<K>::type> Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type Tr;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Tr, Domain::Corner_index, Domain::Curve_index> C3t3;
namespace params = CGAL::parameters;

// The other program: a ball of two subdomains.
inline void write_files(const std::string& name_of_17_digits, const std::string& name_of_6_digits)
{
  typedef CGAL::Labeled_mesh_domain_3<K> Ball;
  typedef CGAL::Mesh_triangulation_3<Ball>::type Ball_tr;
  typedef CGAL::Mesh_complex_3_in_triangulation_3<Ball_tr> Ball_c3t3;
  const Ball ball([](const K::Point_3& p) { return CGAL::squared_distance(p, K::Point_3(CGAL::ORIGIN)) > 1 ? 0 : p.z() > 0.1 ? 1 : 2; },
                  K::Sphere_3(CGAL::ORIGIN, 2.));
  const CGAL::Mesh_criteria_3<Ball_tr> criteria(params::facet_angle = 25, params::facet_size = 0.12, params::facet_distance = 0.012,
                                                params::cell_radius_edge_ratio = 2, params::cell_size = 0.12);
  const Ball_c3t3 c3t3 = CGAL::make_mesh_3<Ball_c3t3>(ball, criteria, params::no_perturb(), params::no_exude());
  for(const int digits : { 17, 6 })
  {
    std::map<Ball_tr::Vertex_handle, std::size_t> number;
    std::ostringstream vertices, tetrahedra;
    vertices.precision(digits);
    for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    {
      for(int i = 0; i < 4; ++i)
      {
        const auto it = number.emplace(c->vertex(i), number.size() + 1);
        if(it.second)
          vertices << c->vertex(i)->point().point() << " 0\n";
        tetrahedra << it.first->second << ' ';
      }
      tetrahedra << c->subdomain_index() << '\n';
    }
    std::ofstream out(digits == 17 ? name_of_17_digits : name_of_6_digits);
    out << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << number.size() << '\n' << vertices.str() << "Tetrahedra\n"
        << c3t3.number_of_cells_in_complex() << '\n' << tetrahedra.str() << "End\n";
  }
}

// The optimizer makes meshes that are Delaunay, and cannot do so if many facets of the boundary are not.
inline std::size_t number_of_facets_that_are_not_delaunay(const C3t3& c3t3)
{
  Tr delaunay;
  std::map<Tr::Vertex_handle, Tr::Vertex_handle> copy;
  const Tr& tr = c3t3.triangulation();
  for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
    copy[v] = delaunay.insert(v->point());
  std::size_t result = 0;
  for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
  {
    Tr::Cell_handle c;
    int i, j, k;
    const auto vertex = [&](int n) { return copy[f->first->vertex((f->second + n) % 4)]; };
    result += !delaunay.is_facet(vertex(1), vertex(2), vertex(3), c, i, j, k);
  }
  return result;
}

inline bool optimize(const std::string& file)
{
  std::ifstream in(file);
  C3t3 c3t3;
  if(!in || !CGAL::IO::read_MEDIT(in, c3t3.triangulation()))
  {
    std::cerr << file << " is no mesh in the format of Medit with a boundary that is a manifold\n";
    return false;
  }
  Complex_of_labels<C3t3, Domain> complex(c3t3);
  const Domain domain(complex.surfaces().begin(), complex.surfaces().end(), complex.labels().begin(), complex.labels().end());
  complex.complete(domain);
  std::cout << "--- " << file << " ---\n" << CGAL::mesh_quality_report_3(c3t3)
            << c3t3.number_of_edges_in_complex() << " edges on features, " << c3t3.number_of_corners() << " corners\n"
            << number_of_facets_that_are_not_delaunay(c3t3) << " facets of the boundary are not Delaunay\n";
  // No facet may be farther from the surface than before, and all are on it.
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::optimize_boundary = false, params::do_insert_vertices = true);
  std::cout << "--- optimized ---\n" << CGAL::mesh_quality_report_3(c3t3);
  return true;
}

int main(int argc, char* argv[])
{
  if(argc > 1)
    return optimize(argv[1]) ? EXIT_SUCCESS : EXIT_FAILURE;
  write_files("ball_17_digits.mesh", "ball_6_digits.mesh");
  return optimize("ball_17_digits.mesh") && optimize("ball_6_digits.mesh") ? EXIT_SUCCESS : EXIT_FAILURE;
}
