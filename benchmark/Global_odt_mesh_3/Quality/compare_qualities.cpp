// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The default call beside what CGAL reaches with odt, and with odt, perturb and exude, on the same meshes, each in a process of
// its own, as a table in Markdown: the call with seed 0, and the worst that seeds from 0 on lead to. CGAL's functions know of no
// seed, and do the same each time.
//
//   compare_qualities [number of seeds, default 5] [name of an input]
//
// Environment: CGAL_DATA_DIR, the directory of CGAL's data.

#include "Markdown_table.h"
#include "benchmark_inputs.h"
#include "measured_call.h"
#include "odt_of_mesh_3.h"

#include <CGAL/exude_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/perturb_mesh_3.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

using namespace inputs;

static void add_row(Markdown_table& table, const char* name, const char* method, const Measured_mesh& first,
                    const Measured_mesh& worst, bool is_compared = true)
{
  table.add({ name, method }, { first.vertices, first.radius_ratio, worst.radius_ratio, first.smallest_angle, worst.smallest_angle,
                                first.below_20, worst.below_20, is_compared ? first.cpu : Markdown_table::none }, is_compared);
}

template <class C3t3, class Domain>
void compare(const char* name, const C3t3& input, const Domain& domain, unsigned int seeds, Markdown_table& table)
{
  const auto add_one_of_cgal = [&](const char* method, const auto& optimize)
  {
    const Measured_mesh m = measured_call(input, optimize);
    add_row(table, name, method, m, m);
  };
  const Measured_mesh of_input = measured(input);
  add_row(table, name, "input", of_input, of_input, false);
  add_one_of_cgal("CGAL's odt", [&](C3t3& c3t3) { odt_of_mesh_3(c3t3, domain); });
  add_one_of_cgal("CGAL's odt, perturb, exude", [&](C3t3& c3t3)
  {
    odt_of_mesh_3(c3t3, domain);
    CGAL::perturb_mesh_3(c3t3, domain, params::sliver_bound = 20);
    CGAL::exude_mesh_3(c3t3);
  });
  Measured_mesh first, worst;
  for(unsigned int seed = 0; seed < seeds; ++seed)
  {
    const Measured_mesh m = measured_call(input, [&](C3t3& c3t3)
                                          { CGAL::odt_optimize_mesh_3(c3t3, domain, params::random_seed(seed)); });
    if(seed == 0)
      first = worst = m;
    worst.radius_ratio = (std::min)(worst.radius_ratio, m.radius_ratio);
    worst.smallest_angle = (std::min)(worst.smallest_angle, m.smallest_angle);
    worst.below_20 = (std::max)(worst.below_20, m.below_20);
  }
  add_row(table, name, "this package", first, worst);
}

int main(int argc, char* argv[])
{
  const unsigned int seeds = argc > 1 ? std::atoi(argv[1]) : 5;
  const std::string only = argc > 2 ? argv[2] : "";
  Markdown_table table({ "mesh", "method" },
                       { { "vertices", 0, Better::NEITHER },
                         { "mean 3r/R", 4, Better::HIGH }, { "worst", 4, Better::HIGH },
                         { "smallest dihedral angle (degrees)", 1, Better::HIGH }, { "worst", 1, Better::HIGH },
                         { "cells below 20 degrees", 0, Better::LOW }, { "worst", 0, Better::LOW },
                         { "CPU time (s)", 1, Better::LOW } });
  const auto compare_on = [&](const char* name, const auto& input, const auto& domain) { compare(name, input, domain, seeds, table); };
  for_each_input(compare_on, only);
  for_each_coarse_part(compare_on, only);
  std::cout << table;
  return EXIT_SUCCESS;
}
