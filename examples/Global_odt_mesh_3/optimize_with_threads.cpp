// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A mesh that is made and optimized by several threads: the triangulation is made for them by `CGAL::Parallel_tag`, and
// the program links TBB. Threads may query this domain at the same time. The result of the optimizer does not depend on their
// number.
//
//   optimize_with_threads [number of threads]

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Real_timer.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/tags.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Labeled_mesh_domain_3<K> Domain;
typedef CGAL::Mesh_triangulation_3<Domain, CGAL::Default, CGAL::Parallel_tag>::type Tr;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Tr> C3t3;
typedef CGAL::Mesh_criteria_3<Tr> Criteria;
namespace params = CGAL::parameters;

// A gyroid in a ball.
double gyroid(const K::Point_3& p)
{
  const double x = 5 * p.x(), y = 5 * p.y(), z = 5 * p.z();
  const double surface = std::sin(x) * std::cos(y) + std::sin(y) * std::cos(z) + std::sin(z) * std::cos(x);
  return (std::max)(surface / 5, p.x() * p.x() + p.y() * p.y() + p.z() * p.z() - 1);
}

int main(int argc, char* argv[])
{
  const int threads = argc > 1 ? std::atoi(argv[1]) : tbb::this_task_arena::max_concurrency();
  if(threads < 1)
  {
    std::cerr << "the number of threads must be positive\n";
    return EXIT_FAILURE;
  }
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));

  const Domain domain = Domain::create_implicit_mesh_domain(gyroid, K::Sphere_3(CGAL::ORIGIN, 2.));
  const Criteria criteria(params::facet_angle = 25, params::facet_size = 0.06, params::facet_distance = 0.01,
                          params::cell_radius_edge_ratio = 2, params::cell_size = 0.06);
  C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::no_exude());

  CGAL::Real_timer timer;
  timer.start();
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::domain_is_thread_safe = true);
  timer.stop();
  std::cout << threads << " threads, " << timer.time() << " seconds\n" << CGAL::mesh_quality_report_3(c3t3);
  return EXIT_SUCCESS;
}
