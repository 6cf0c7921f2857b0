// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// On every kind of domain, whatever the mesh, odt_optimize_mesh_3() returns a
// valid complex with the boundary of the input, and better cells.

#include "mesh_contract.h"
#include "mesh_domains.h"

#include <CGAL/odt_optimize_mesh_3.h>

#include <iostream>
#include <string>

namespace params = CGAL::parameters;

// The mean over the cells of 3 r / R is the measure that ODT improves.
template <class C3t3>
double mean_radius_ratio(const C3t3& c3t3)
{
  typedef domains::Point_3 Point_3;
  double sum = 0;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
  {
    Point_3 p[4];
    for(int i = 0; i < 4; ++i)
      p[i] = c3t3.triangulation().point(c, i).point();
    double area = 0;
    for(int i = 0; i < 4; ++i)
      area += std::sqrt(CGAL::squared_area(p[(i + 1) % 4], p[(i + 2) % 4], p[(i + 3) % 4]));
    sum += 9 * std::abs(CGAL::volume(p[0], p[1], p[2], p[3])) / area
           / std::sqrt(CGAL::squared_radius(p[0], p[1], p[2], p[3]));
  }
  return sum / double(c3t3.number_of_cells_in_complex());
}

template <class C3t3, class Domain>
void test(const std::string& name, const C3t3& input, const Domain& domain, bool improves = true)
{
  std::cout << name << ": " << input.triangulation().number_of_vertices() << " vertices" << std::endl;
  const Mesh_contract<C3t3, Domain> contract(input, domain, name);
  const double before = mean_radius_ratio(input);

  C3t3 c3t3(input);
  CGAL::odt_optimize_mesh_3(c3t3, domain);
  contract.check(c3t3);
  const double after = mean_radius_ratio(c3t3);
  std::cout << "  mean 3r/R " << before << " -> " << after << std::endl;
  check::that(!improves || after > before + 0.005, name, ": not improved");
  check::that(!improves || Mesh_contract<C3t3, Domain>::points(c3t3) != Mesh_contract<C3t3, Domain>::points(input),
              name, ": nothing moved");

  // To the end, without freezing.
  C3t3 converged(input);
  CGAL::odt_optimize_mesh_3(converged, domain, params::do_freeze = false, params::convergence = 0,
                            params::max_iteration_number = 200);
  contract.check(converged);

  // Bit for bit the same, and again on the result.
  C3t3 again(input);
  CGAL::odt_optimize_mesh_3(again, domain);
  check::that((Mesh_contract<C3t3, Domain>::points(again) == Mesh_contract<C3t3, Domain>::points(c3t3)),
              name, ": not deterministic");
  CGAL::odt_optimize_mesh_3(again, domain);
  contract.check(again);
}

int main()
{
  using namespace domains;
  {
    const Labeled_domain domain = sphere();
    test("sphere", mesh(domain, 0.2), domain);
    test("graded sphere", graded_mesh(domain, 0.1), domain);
  }
  {
    const Labeled_domain domain = torus();
    test("torus", mesh(domain, 0.15), domain);
  }
  {
    const Labeled_domain domain = three_subdomains();
    test("three subdomains", mesh(domain, 0.2), domain);
  }
  {
    const Labeled_domain domain = thin_plate();
    test("thin plate", mesh(domain, 0.15), domain, false);
  }
  {
    const CGAL::Image_3 image = labeled_image();
    const Labeled_domain domain = labeled_image_domain(image);
    test("labeled image", mesh(domain, 0.08), domain);
  }
  {
    const CGAL::Image_3 image = gray_image();
    const Labeled_domain domain = gray_image_domain(image);
    test("gray image", mesh(domain, 0.08), domain);
  }
  {
    const Polyhedron box = notched_box();
    Polyhedral_domain domain(box);
    test("polyhedron", mesh(domain, 0.3, false), domain);
    domain.detect_features();
    test("polyhedron with features", mesh(domain, 0.25, true), domain);
  }
  return check::result();
}
