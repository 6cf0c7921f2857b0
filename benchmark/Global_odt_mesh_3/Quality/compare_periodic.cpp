// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The default call beside CGAL's odt, and odt, perturb and exude, on periodic meshes of both sides of three minimal surfaces, each
// in a process of its own, as a table in Markdown.
//
//   compare_periodic [size of cells, default 0.06, where 1 is the period]

#include "periodic_meshes.h"

#include "Markdown_table.h"
#include "measured_call.h"
#include "odt_of_mesh_3.h"

#include <cstdlib>
#include <iostream>

using namespace periodic;
namespace params = CGAL::parameters;

struct Surface
{
  const char* name;
  double (*function)(const Point&);
};

static void compare(const Surface& surface, double size, Markdown_table& table)
{
  const Domain domain([&](const Point& p) { return surface.function(p) < 0 ? 1 : 2; }, Kernel::Iso_cuboid_3(0, 0, 0, 1, 1, 1));
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
