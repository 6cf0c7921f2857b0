// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What do_insert_vertices does to CAD parts, whose feature edges are shorter than the edges beyond, to images with thin layers and
// junctions, and to smooth surfaces, where it should do nothing.
//
//   insert_vertices [name of one input]
//
// Prints vertices, the smallest dihedral angle, cells below 20 and 30 degrees, mean 3r/R, and CPU seconds, of the input, the default
// call, and the one with insertion. "numbers" changes the number of vertices of an elephant, up and down; "edges" makes meshes a second
// time, with sizes that grow from feature edges, before the default call. Environment: CGAL_DATA_DIR, the directory of CGAL's data.

#include "benchmark_inputs.h"
#include "cpu_seconds.h"
#include "synthetic_images.h"

#include <CGAL/Feature_edge_size_field_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

using namespace inputs;

template <class C3t3>
static void print(const char* what, const C3t3& c3t3, double seconds)
{
  const CGAL::Mesh_quality_report_3 r = CGAL::mesh_quality_report_3(c3t3, { 20, 30 });
  std::printf("  %-16s %7zu %6.1f %6zu %6zu %7.4f %6.1f\n", what, r.number_of_vertices, r.smallest_angle, r.cells_below[0].second,
              r.cells_below[1].second, r.mean_radius_ratio, seconds);
  std::fflush(stdout);
}

template <class C3t3, class Domain>
static void compare(const std::string& name, const C3t3& input, const Domain& domain)
{
  std::printf("%s\n", name.c_str());
  print("input", input, 0);
  for(bool inserts : { false, true })
  {
    C3t3 c3t3(input);
    const double time = seconds([&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_insert_vertices = inserts); });
    print(inserts ? "with insertion" : "default", c3t3, time);
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

// Each mesh is made of the one before, as the paper makes one of a boundary, a density, and a number of vertices.
static void change_number(double size)
{
  const Polyhedral_domain domain(read_polyhedron(CGAL::data_file_path("meshes/elephant.off")));
  Polyhedral_c3t3 c3t3 = polyhedral_mesh(domain, size, false, 0.1);
  std::printf("elephant, numbers\n");
  print("input", c3t3, 0);
  for(std::size_t number : { 1000, 3000, 10000, 30000, 100000, 30000, 10000, 3000, 1000 })
  {
    const double time = seconds([&]
    {
      CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_insert_vertices = true, params::do_remove_vertices = true,
                                params::number_of_vertices = number);
    });
    print(std::to_string(number).c_str(), c3t3, time);
  }
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
  if(is_wanted("numbers"))
    change_number(.03);
  if(is_wanted("edges"))
    for(const Model& m : { Model{ "couplingdown", .03, true }, Model{ "pinion_small", .03, true }, Model{ "fandisk", .0215, true } })
      compare_with_sizes_from_edges(m.name, m.size);
  CGAL::Image_3 image;
  if(is_wanted("liver") && image.read(CGAL::data_file_path("images/liver.inr.gz").c_str()))
    compare_image("liver", image, 6, 2, 8);
}

int main(int argc, char* argv[])
{
  std::printf("  %-16s %7s %6s %6s %6s %7s %6s\n", "", "vert.", "angle", "< 20", "< 30", "3r/R", "CPU s");
  try
  {
    compare_all(argc > 1 ? argv[1] : "");
  }
  catch(const std::exception& e)
  {
    std::cerr << e.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
