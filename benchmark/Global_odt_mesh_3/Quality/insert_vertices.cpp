// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What do_insert_vertices does to CAD parts, whose feature edges are shorter than the edges beyond, to images with thin layers and
// junctions, and to smooth surfaces, where it should do nothing.
//
//   insert_vertices [name of one input]
//
// Prints a table in Markdown of the default call and the one with insertion. "edges" makes meshes a second time, with sizes that grow
// from feature edges. Environment: CGAL_DATA_DIR, the directory of CGAL's data.

#include "Markdown_table.h"
#include "benchmark_inputs.h"
#include "measured_call.h"
#include "synthetic_images.h"

#include <CGAL/Feature_edge_size_field_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <cstdlib>
#include <iostream>
#include <string>

using namespace inputs;

static Markdown_table table({ "mesh", "call" },
                            { { "vertices", 0, Better::NEITHER }, { "smallest dihedral angle (degrees)", 1, Better::HIGH },
                              { "cells below 20 degrees", 0, Better::LOW }, { "cells below 30 degrees", 0, Better::LOW },
                              { "mean 3r/R", 3, Better::HIGH }, { "CPU time (s)", 1, Better::LOW } });

template <class C3t3, class Domain>
static void compare(const std::string& name, const C3t3& input, const Domain& domain)
{
  for(bool inserts : { false, true })
  {
    const Measured_mesh m = measured_call(input, [&](C3t3& c3t3)
                                          { CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_insert_vertices = inserts); });
    table.add({ name, inserts ? "with insertion" : "default" }, { m.vertices, m.smallest_angle, m.below_20, m.below_30, m.radius_ratio, m.cpu });
  }
}

// The size of cells is relative to the diagonal of the bounding box.
static void compare_polyhedron(const std::string& model, double size, bool with_features)
{
  Polyhedral_domain domain(read_polyhedron(CGAL::data_file_path("meshes/" + model + ".off")));
  if(with_features)
    domain.detect_features();
  compare(model, polyhedral_mesh(domain, size, with_features, 0.1), domain);
}

static void compare_with_sizes_from_edges(const std::string& model, double size)
{
  Polyhedral_domain domain(read_polyhedron(CGAL::data_file_path("meshes/" + model + ".off")));
  domain.detect_features();
  const Polyhedral_c3t3 first = polyhedral_mesh(domain, size, true, 0.1);
  const double length = size * diagonal(domain);
  const CGAL::Feature_edge_size_field_3<Polyhedral_c3t3> field(first, length);
  const CGAL::Mesh_criteria_3<Polyhedral_triangulation> criteria(
    params::edge_size = length, params::facet_angle = 25, params::facet_size = field, params::facet_distance = 0.1 * length,
    params::cell_radius_edge_ratio = 3, params::cell_size = field);
  compare(model + ", sizes from feature edges", reproducible_mesh<Polyhedral_c3t3>(domain, criteria), domain);
}

static void compare_image(const std::string& name, const CGAL::Image_3& image, double facet_size, double facet_distance,
                          double cell_size)
{
  const Labeled_domain domain = image_domain(image);
  const CGAL::Mesh_criteria_3<Labeled_triangulation> criteria(
    params::facet_angle = 30, params::facet_size = facet_size, params::facet_distance = facet_distance,
    params::cell_radius_edge_ratio = 3, params::cell_size = cell_size);
  compare(name, reproducible_mesh<Labeled_c3t3>(domain, criteria), domain);
}

static void compare_all(const std::string& only)
{
  const auto is_wanted = [&only](const std::string& name) { return only.empty() || only == name; };
  struct Model
  {
    const char* name;
    double size;
    bool with_features;
  };
  for(const Model& m : { Model{ "couplingdown", .03, true }, Model{ "pinion_small", .03, true }, Model{ "fandisk", .0215, true },
                         Model{ "part", .018, true }, Model{ "anchor", .03, true }, Model{ "helmet", .04, true },
                         Model{ "fandisk_large", .03, true }, Model{ "joint", .03, true }, Model{ "rotor", .04, true },
                         Model{ "elephant", .03, false }, Model{ "cow", .03, false }, Model{ "bear", .04, false },
                         Model{ "sphere", .04, false } })
    if(is_wanted(m.name))
      compare_polyhedron(m.name, m.size, m.with_features);
  if(is_wanted("polycrystal"))
    compare_image("polycrystal", synthetic_images::polycrystal(80, 20), 5, 1, 6);
  if(is_wanted("fine polycrystal"))
    compare_image("fine polycrystal", synthetic_images::polycrystal(80, 20), 3, .6, 3.6);
  if(is_wanted("head"))
    compare_image("head", synthetic_images::head(96), 4, .9, 5);
  if(is_wanted("edges"))
    for(const Model& m : { Model{ "couplingdown", .03, true }, Model{ "pinion_small", .03, true }, Model{ "fandisk", .0215, true } })
      compare_with_sizes_from_edges(m.name, m.size);
  if(is_wanted("liver"))
    compare_image("liver", read_image("liver.inr.gz"), 6, 2, 8);
}

int main(int argc, char* argv[])
{
  compare_all(argc > 1 ? argv[1] : "");
  std::cout << table;
  return EXIT_SUCCESS;
}
