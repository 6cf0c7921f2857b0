// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes a closed polyhedral surface and optimizes the mesh: report, meshes and
// picture before and after.
//
//   optimize_polyhedral_mesh [surface.off [relative size [output prefix]]]
//
// The size of cells and facets is relative to the diagonal of the bounding box.
// Without the elephant of CGAL's data package, an implicit domain stands in.

#include "mesh_picture.h"
#include "optimize_and_report.h"
#include "read_surface.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_polyhedron_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/make_mesh_3.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Mesh_polyhedron_3<K>::type Polyhedron;
typedef CGAL::Polyhedral_mesh_domain_3<Polyhedron, K> Polyhedral_domain;
typedef CGAL::Labeled_mesh_domain_3<K> Implicit_domain;
namespace params = CGAL::parameters;

template <class Domain>
void run(const Domain& domain, double size, const std::string& prefix)
{
  typedef typename CGAL::Mesh_triangulation_3<Domain>::type Tr;
  typedef CGAL::Mesh_complex_3_in_triangulation_3<Tr> C3t3;
  typedef CGAL::Mesh_criteria_3<Tr> Criteria;

  Criteria criteria(params::facet_angle = 25, params::facet_size = size, params::facet_distance = size / 8,
                    params::cell_radius_edge_ratio = 3, params::cell_size = size);
  C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::no_exude());
  const C3t3 before(c3t3);
  // To the local minimum, whatever the time.
  optimize_and_report(c3t3, domain, prefix, params::do_freeze = false, params::convergence = 0.001);
  draw_before_and_after(before, c3t3, prefix);
}

double torus(const K::Point_3& p)
{
  const double ring = std::sqrt(p.x() * p.x() + p.y() * p.y()) - 1;
  return ring * ring + p.z() * p.z() - 0.2;
}

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

  if(argc <= 1 && !can_be_opened(file))
  {
    std::cout << file << " is not there; meshing a torus\n";
    run(Implicit_domain::create_implicit_mesh_domain(torus, K::Sphere_3(CGAL::ORIGIN, 4.)), 5 * relative_size, prefix);
    return EXIT_SUCCESS;
  }
  Polyhedron polyhedron;
  if(!read_surface(file, polyhedron))
    return EXIT_FAILURE;
  std::cout << "meshing " << file << std::endl;
  const Polyhedral_domain domain(polyhedron);
  const CGAL::Bbox_3 b = domain.bbox();
  const double diagonal = std::sqrt(CGAL::square(b.xmax() - b.xmin()) + CGAL::square(b.ymax() - b.ymin())
                                    + CGAL::square(b.zmax() - b.zmin()));
  run(domain, relative_size * diagonal, prefix);
  return EXIT_SUCCESS;
}
