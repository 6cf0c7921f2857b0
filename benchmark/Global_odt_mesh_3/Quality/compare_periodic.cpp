// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The default call beside CGAL's odt, and odt, perturb and exude, on periodic meshes of both sides of three minimal surfaces, each
// in a process of its own, as a table in Markdown.
//
//   compare_periodic [size of cells, default 0.06, where 1 is the period]

// The headers of Periodic_3_mesh_3 have to come before those of Mesh_3.
#include <CGAL/Periodic_3_mesh_3/config.h>
#include <CGAL/make_periodic_3_mesh_3.h>
#include <CGAL/optimize_periodic_3_mesh_3.h>

#include "Markdown_table.h"
#include "measured_call.h"
#include "odt_of_mesh_3.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Periodic_3_mesh_triangulation_3.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Labeled_mesh_domain_3<Kernel> Domain;
typedef CGAL::Periodic_3_mesh_triangulation_3<Domain>::type Triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> C3t3;
typedef CGAL::Mesh_criteria_3<Triangulation> Criteria;
namespace params = CGAL::parameters;

struct Surface
{
  const char* name;
  double (*function)(double x, double y, double z);
};

static double gyroid(double x, double y, double z)
{
  return std::cos(x) * std::sin(y) + std::cos(y) * std::sin(z) + std::cos(z) * std::sin(x);
}

static double double_diamond(double x, double y, double z)
{
  return std::sin(x) * std::sin(y) * std::sin(z) + std::sin(x) * std::cos(y) * std::cos(z)
         + std::cos(x) * std::sin(y) * std::cos(z) + std::cos(x) * std::cos(y) * std::sin(z);
}

static double schwarz_p(double x, double y, double z) { return std::cos(x) + std::cos(y) + std::cos(z); }

static void compare(const Surface& surface, double size, Markdown_table& table)
{
  const double turn = 2 * CGAL_PI;
  const Domain domain([&](const Kernel::Point_3& p) { return surface.function(turn * p.x(), turn * p.y(), turn * p.z()) < 0 ? 1 : 2; },
                      Kernel::Iso_cuboid_3(0, 0, 0, 1, 1, 1));
  const Criteria criteria(params::facet_angle = 30, params::facet_size = size, params::facet_distance = size / 4,
                          params::cell_radius_edge_ratio = 2, params::cell_size = size);
  CGAL::get_default_random() = CGAL::Random(0);
  // CGAL's odt crashes on copies.
  C3t3 input = CGAL::make_periodic_3_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::no_exude());
  const auto add = [&](const char* what, const Measured_mesh& m, bool is_compared = true)
  {
    table.add({ surface.name, what }, { m.vertices, m.radius_ratio, m.smallest_angle, m.below_20,
                                        is_compared ? m.cpu : Markdown_table::none }, is_compared);
  };
  add("input", measured(input), false);
  add("CGAL's odt", measured_call_on(input, [&](C3t3& c3t3) { odt_of_mesh_3(c3t3, domain); }));
  add("CGAL's odt, perturb, exude", measured_call_on(input, [&](C3t3& c3t3)
  {
    odt_of_mesh_3(c3t3, domain);
    CGAL::perturb_periodic_3_mesh_3(c3t3, domain, params::sliver_bound = 20);
    CGAL::exude_periodic_3_mesh_3(c3t3);
  }));
  add("this package", measured_call_on(input, [&](C3t3& c3t3) { CGAL::odt_optimize_mesh_3(c3t3, domain); }));
}

int main(int argc, char* argv[])
{
  const double size = argc > 1 ? std::atof(argv[1]) : 0.06;
  Markdown_table table({ "surface", "method" }, { { "vertices", 0, Better::NEITHER }, { "mean 3r/R", 4, Better::HIGH },
                                                  { "smallest dihedral angle (degrees)", 1, Better::HIGH },
                                                  { "cells below 20 degrees", 0, Better::LOW }, { "CPU time (s)", 1, Better::LOW } });
  for(const Surface& surface : { Surface{ "gyroid", gyroid }, Surface{ "double diamond", double_diamond }, Surface{ "Schwarz P", schwarz_p } })
    compare(surface, size, table);
  std::cout << table;
  return EXIT_SUCCESS;
}
