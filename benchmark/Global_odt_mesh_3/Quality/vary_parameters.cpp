// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What a parameter does, as a table in Markdown: each row is a call on the same mesh, in a process of its own.
//
//   vary_parameters number_of_rounds|sliver_bound|surface_weight|insertion|sizing_field|number_of_vertices|time_limit
//
// Environment: CGAL_DATA_DIR, the directory of CGAL's data.

#include "Markdown_table.h"
#include "benchmark_inputs.h"
#include "measured_call.h"
#include "realized_sizes.h"

#include <CGAL/odt_optimize_mesh_3.h>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

using namespace inputs;

static std::string printed(double x)
{
  std::ostringstream out;
  out << x;
  return out.str();
}

// The columns of all tables.
static std::vector<double> values(const Measured_mesh& m, bool is_input = false)
{
  return { m.vertices, m.radius_ratio, m.smallest_angle, m.below_20, m.below_30, m.facet_angle, m.mean_facet_angle,
           is_input ? Markdown_table::none : m.cpu };
}

// Of calls that differ by a parameter, on meshes that the first column names.
static Markdown_table table_of(const std::string& parameter)
{
  return Markdown_table({ "mesh", parameter },
                        { { "vertices", 0, Better::NEITHER }, { "mean 3r/R", 4, Better::HIGH },
                          { "smallest dihedral angle (degrees)", 1, Better::HIGH }, { "cells below 20 degrees", 0, Better::LOW },
                          { "cells below 30 degrees", 0, Better::LOW }, { "smallest angle of a facet (degrees)", 1, Better::HIGH },
                          { "mean of the smallest angles of facets (degrees)", 1, Better::HIGH }, { "CPU time (s)", 1, Better::LOW } });
}

// Calls f(name, mesh, domain) for the elephant that compare_tools has, too.
template <class Function>
void with_elephant(const Function& f)
{
  const Polyhedral_domain domain(read_polyhedron(CGAL::data_file_path("meshes/elephant.off")));
  f("elephant", polyhedral_mesh(domain, 0.02, false), domain);
}

template <class C3t3, class Domain, class... Parameters>
void add_call(Markdown_table& table, const std::string& mesh, const std::string& value, const C3t3& input, const Domain& domain,
              const Parameters&... parameters)
{
  table.add({ mesh, value }, values(measured_call(input, [&](C3t3& c3t3) { CGAL::odt_optimize_mesh_3(c3t3, domain, parameters...); })));
}

template <class C3t3>
void add_input(Markdown_table& table, const std::string& mesh, const C3t3& input)
{
  table.add({ mesh, "input" }, values(measured(input), true), false);
}

static Markdown_table vary_number_of_rounds()
{
  Markdown_table table = table_of("`number_of_rounds`");
  with_elephant([&](const char* name, const auto& input, const auto& domain)
  {
    for(std::size_t rounds : { 0, 1, 2, 4, 8, 20 })
      add_call(table, name, std::to_string(rounds) + (rounds == 4 ? " (default)" : ""), input, domain, params::number_of_rounds = rounds);
  });
  return table;
}

static Markdown_table vary_sliver_bound()
{
  Markdown_table table = table_of("`sliver_bound`, degrees");
  with_elephant([&](const char* name, const auto& input, const auto& domain)
  {
    add_call(table, name, "slivers not removed", input, domain, params::do_remove_slivers = false);
    for(double bound : { 20., 30., 35., 40. })
      add_call(table, name, printed(bound), input, domain, params::sliver_bound = bound);
    add_call(table, name, "0 (default)", input, domain);
  });
  return table;
}

static Markdown_table vary_surface_weight()
{
  Markdown_table table = table_of("`surface_weight`");
  with_elephant([&](const char* name, const auto& input, const auto& domain)
  {
    for(double weight : { 0., 0.5, 1.2, 3., 10. })
      add_call(table, name, printed(weight) + (weight == 1.2 ? " (default)" : ""), input, domain, params::surface_weight = weight);
  });
  return table;
}

static Markdown_table vary_insertion()
{
  Markdown_table table = table_of("parameters");
  const auto vary = [&](const char* name, const auto& input, const auto& domain)
  {
    const auto call = [&](const char* what, bool inserts, bool removes)
    {
      add_call(table, name, what, input, domain, params::do_insert_vertices = inserts, params::do_remove_vertices = removes);
    };
    add_input(table, name, input);
    call("default call", false, false);
    call("`do_insert_vertices`", true, false);
    call("`do_remove_vertices`", false, true);
    call("both", true, true);
  };
  for_model_with_features(vary, "CAD part (fandisk)", "fandisk", 0.03);
  const CGAL::Image_3 liver = read_image("liver.inr.gz");
  const Labeled_domain domain = image_domain(liver);
  vary("image (liver)", image_mesh(domain, 6, 8), domain);
  return table;
}

// One size everywhere.
struct Uniform_size
{
  typedef inputs::FT FT;
  typedef inputs::Point_3 Point_3;
  typedef Labeled_domain::Index Index;

  FT size;
  FT operator()(const Point_3&, const int, const Index&) const { return size; }
};

static Markdown_table vary_sizing_field()
{
  Markdown_table table({ "`sizing_field`" },
                       { { "deviation of log(edge / size)", 3, Better::NEITHER }, { "largest edge over smallest", 1, Better::NEITHER },
                         { "mean 3r/R", 4, Better::HIGH }, { "smallest dihedral angle (degrees)", 1, Better::HIGH },
                         { "CPU time (s)", 1, Better::LOW } });
  const Labeled_domain domain = sphere_domain();
  const Graded_sphere_size graded = { 0.0392 };
  const Labeled_c3t3 input = graded_sphere(domain, graded.smallest);
  const auto add = [&](const char* what, const Labeled_c3t3& c3t3, const auto& size, double cpu)
  {
    const Realized_sizes realized(c3t3, size);
    const Measured_mesh m = measured(c3t3);
    table.add({ what }, { realized.deviation, realized.ratio, m.radius_ratio, m.smallest_angle, cpu }, !std::isnan(cpu));
  };
  const auto add_call = [&](const char* what, const auto& size, const auto&... parameters)
  {
    Labeled_c3t3 c3t3(input);
    const double cpu = seconds([&] { CGAL::odt_optimize_mesh_3(c3t3, domain, parameters...); });
    add(what, c3t3, size, cpu);
  };
  const Uniform_size uniform = { 2 * graded.smallest };
  add("input, made with sizes of 1 to 5", input, graded, Markdown_table::none);
  add_call("none", graded);
  add_call("sizes of 1 to 5", graded, params::sizing_field = graded);
  add_call("uniform", uniform, params::sizing_field = uniform);
  return table;
}

static Markdown_table vary_number_of_vertices()
{
  Markdown_table table = table_of("`number_of_vertices`");
  for_each_input([&](const char* name, const auto& input, const auto& domain)
  {
    const std::size_t vertices = input.triangulation().number_of_vertices();
    add_input(table, name, input);
    for(std::size_t divisor : { 1, 2, 4 })
      add_call(table, name, divisor == 1 ? "that of the input" : "1/" + std::to_string(divisor) + " of it", input, domain,
               params::do_insert_vertices = true, params::do_remove_vertices = true, params::number_of_vertices = vertices / divisor);
  }, "elephant");
  return table;
}

static Markdown_table vary_time_limit()
{
  Markdown_table table = table_of("`time_limit`");
  for_each_input([&](const char* name, const auto& input, const auto& domain)
  {
    const Measured_mesh unlimited = measured_call(input, [&](auto& c3t3) { CGAL::odt_optimize_mesh_3(c3t3, domain); });
    table.add({ name, "0 (none)" }, values(unlimited));
    for(int divisor : { 2, 4 })
      add_call(table, name, "1/" + std::to_string(divisor) + " of the time without", input, domain,
               params::time_limit = unlimited.wall / divisor);
  }, "elephant");
  return table;
}

int main(int argc, char* argv[])
{
  const std::map<std::string, std::function<Markdown_table()> > tables
    = { { "number_of_rounds", vary_number_of_rounds }, { "sliver_bound", vary_sliver_bound },
        { "surface_weight", vary_surface_weight }, { "insertion", vary_insertion }, { "sizing_field", vary_sizing_field },
        { "number_of_vertices", vary_number_of_vertices }, { "time_limit", vary_time_limit } };
  const auto vary = tables.find(argc > 1 ? argv[1] : "");
  if(vary == tables.end())
  {
    std::cerr << "usage: " << argv[0];
    for(const auto& t : tables)
      std::cerr << (t.first == tables.begin()->first ? " " : "|") << t.first;
    std::cerr << std::endl;
    return EXIT_FAILURE;
  }
  std::cout << vary->second();
  return EXIT_SUCCESS;
}
