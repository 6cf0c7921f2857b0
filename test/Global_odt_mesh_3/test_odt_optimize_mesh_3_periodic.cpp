// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Periodic meshes are handed over to the optimizer of Mesh_3, also through
// make_periodic_3_mesh_3(..., odt()).

#include "check.h"

// The headers of Periodic_3_mesh_3 have to come before those of Mesh_3.
#include <CGAL/Periodic_3_mesh_3/config.h>
#include <CGAL/make_periodic_3_mesh_3.h>
#include <CGAL/optimize_periodic_3_mesh_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Periodic_3_mesh_triangulation_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <cmath>
#include <set>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Labeled_mesh_domain_3<Kernel> Domain;
typedef CGAL::Periodic_3_mesh_triangulation_3<Domain>::type Triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> C3t3;
typedef CGAL::Mesh_criteria_3<Triangulation> Criteria;
namespace params = CGAL::parameters;

static double schwarz_p(const Kernel::Point_3& p)
{
  const double t = 2 * CGAL_PI;
  return std::cos(t * p.x()) + std::cos(t * p.y()) + std::cos(t * p.z());
}

static std::set<Kernel::Point_3> points(const C3t3& c3t3)
{
  std::set<Kernel::Point_3> result;
  for(auto v = c3t3.triangulation().finite_vertices_begin(); v != c3t3.triangulation().finite_vertices_end(); ++v)
    result.insert(v->point().point());
  return result;
}

int main()
{
  const Kernel::Iso_cuboid_3 cube(0, 0, 0, 1, 1, 1);
  // A domain of its own for each mesh, as it carries the random generator.
  const Domain domain = Domain::create_implicit_mesh_domain(schwarz_p, cube);
  const Domain same_domain = Domain::create_implicit_mesh_domain(schwarz_p, cube);
  Criteria criteria(params::facet_angle = 30, params::facet_size = 0.15, params::facet_distance = 0.05,
                    params::cell_radius_edge_ratio = 2, params::cell_size = 0.15);
  C3t3 plain = CGAL::make_periodic_3_mesh_3<C3t3>(domain, criteria, params::no_exude(), params::no_perturb());
  const C3t3 optimized = CGAL::make_periodic_3_mesh_3<C3t3>(
    same_domain, criteria, params::odt(params::max_iteration_number = 3), params::no_exude(), params::no_perturb());
  check::that(optimized.number_of_cells_in_complex() > 100, "nothing meshed");
  check::that(optimized.triangulation().is_valid(), "not valid after odt()");
  check::that(points(optimized) != points(plain), "odt() did nothing");

  const auto before = points(plain);
  const auto code = CGAL::odt_optimize_periodic_3_mesh_3(plain, domain, params::max_iteration_number = 2,
                                                         params::convergence = 0, params::do_freeze = false);
  check::that(code == CGAL::MAX_ITERATION_NUMBER_REACHED, "return code ", code);
  check::that(plain.triangulation().is_valid(), "not valid after odt_optimize_periodic_3_mesh_3");
  check::that(points(plain) != before, "odt_optimize_periodic_3_mesh_3 did nothing");
  CGAL::odt_optimize_mesh_3(plain, domain, params::max_iteration_number = 1);
  check::that(plain.triangulation().is_valid(), "not valid after odt_optimize_mesh_3");
  return check::result();
}
