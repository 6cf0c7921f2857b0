// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Two hundred seeded small meshes over all kinds of domains: no crash, no broken
// promise, the boundary's topology and the volumes as they were.

#include "mesh_contract.h"
#include "mesh_domains.h"

#include <CGAL/Random.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <iostream>
#include <random>
#include <string>

using namespace domains;

// One of some users' habits: the default call, a long run without freezing, few
// iterations, the boundary fixed, a global search.
template <class C3t3, class Domain>
static void test(const std::string& name, const C3t3& input, const Domain& domain, unsigned int seed, bool is_smooth)
{
  const std::string what = name + ", seed " + std::to_string(seed);
  const Mesh_contract<C3t3, Domain> contract(input, domain, what);
  C3t3 c3t3(input);
  switch(seed % 5)
  {
  case 0: CGAL::odt_optimize_mesh_3(c3t3, domain); break;
  case 1: CGAL::odt_optimize_mesh_3(c3t3, domain, CGAL::parameters::convergence = 0,
                                    CGAL::parameters::do_freeze = false,
                                    CGAL::parameters::max_iteration_number = 60); break;
  case 2: CGAL::odt_optimize_mesh_3(c3t3, domain, CGAL::parameters::max_iteration_number = 2); break;
  case 3: CGAL::odt_optimize_mesh_3(c3t3, domain, CGAL::parameters::optimize_boundary = false); break;
  default: CGAL::odt_optimize_mesh_3(c3t3, domain, CGAL::parameters::number_of_rounds = 3,
                                     CGAL::parameters::random_seed(seed));
  }
  if(seed % 5 == 3)
    contract.check(c3t3);
  else
    contract.check_moved(c3t3, is_smooth ? 0.1 : 0.2, is_smooth ? 0.06 : 0.15, 4e-3);
}

int main()
{
  const unsigned int first_seed = 1000, runs = 200;
  std::cout << "seeds " << first_seed << " to " << first_seed + runs - 1 << std::endl;
  const CGAL::Image_3 labels = labeled_image(), grays = gray_image();
  const Polyhedron box = notched_box();
  const Polyhedral_domain box_domain(box);
  Polyhedral_domain feature_domain(box);
  feature_domain.detect_features();

  for(unsigned int seed = first_seed; seed < first_seed + runs; ++seed)
  {
    std::mt19937 random(seed);
    CGAL::get_default_random() = CGAL::Random(seed);
    const double factor = std::uniform_real_distribution<double>(0.8, 1.6)(random);
    // Labeled domains carry a random generator, hence a new one for each seed.
    const auto labeled_test = [&](const char* name, const Labeled_domain& domain, double size, bool is_smooth)
    { test(name, mesh(domain, size * factor), domain, seed, is_smooth); };
    switch(seed % 9)
    {
    case 0: labeled_test("sphere", sphere(), 0.3, true); break;
    case 1: labeled_test("torus", torus(), 0.2, true); break;
    case 2: labeled_test("three subdomains", three_subdomains(), 0.25, true); break;
    case 3: labeled_test("thin plate", thin_plate(), 0.2, false); break;
    case 4: labeled_test("labeled image", labeled_image_domain(labels), 0.1, false); break;
    case 5: labeled_test("gray image", gray_image_domain(grays), 0.1, true); break;
    case 6:
    {
      const Labeled_domain domain = sphere();
      test("graded sphere", graded_mesh(domain, 0.15 * factor), domain, seed, true);
      break;
    }
    case 7: test("polyhedron", mesh(box_domain, 0.4 * factor, false), box_domain, seed, false); break;
    default: test("polyhedron with features", mesh(feature_domain, 0.35 * factor, true), feature_domain, seed, true);
    }
  }
  return check::result();
}
