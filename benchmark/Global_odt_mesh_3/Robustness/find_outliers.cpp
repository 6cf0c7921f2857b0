// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls the optimizer, CGAL's odt, and the cheapest chain of CGAL's functions that removes slivers, which is odt and perturb, and on
// images exude, on meshes of many kinds and sizes, each in a process of its own, and prints the CPU times, where ours is spent, the worst cells, how many cells and facets break the sizes that the mesh was made with, and by
// how much the volumes and the median edges of subdomains change.
//
//   find_outliers [name of an input, or model.off:relative size, or model.off:relative size:smooth] ...
//
// Environment: CGAL_DATA_DIR, the directory of CGAL's data; RANDOM_SEED and NUMBER_OF_ROUNDS, parameters of the optimizer.

#include "benchmark_inputs.h"
#include "cpu_seconds.h"
#include "odt_of_mesh_3.h"
#include "process_of_its_own.h"
#include "subdomain_measures.h"
#include "synthetic_images.h"

#include <CGAL/Global_odt_mesh_3/internal/Mesh_changes_3.h>
#include <CGAL/Mesh_domain_with_polyline_features_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/exude_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/perturb_mesh_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace inputs;
namespace odt = CGAL::Global_odt_mesh_3::internal;

typedef CGAL::Mesh_domain_with_polyline_features_3<Labeled_domain> Polyline_domain;
typedef CGAL::Mesh_triangulation_3<Polyline_domain>::type Polyline_triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Polyline_triangulation, Polyline_domain::Corner_index,
                                                Polyline_domain::Curve_index> Polyline_c3t3;

// What the mesh was asked for: circumradii of cells by their subdomain, and radii of surface Delaunay balls.
struct Sizes
{
  std::function<double(int)> cell;
  double facet;
  bool are_of_image = false;
};

struct Outcome
{
  double cpu = 0;                               // seconds
  std::array<double, odt::Stage_clock::NUMBER_OF_STAGES> stages = {};   // of these
  double smallest_angle = 0, radius_ratio = 0;
  std::size_t below_20 = 0, below_30 = 0, cells = 0;
  double largest_cell = 0, largest_facet = 0;   // over the wanted size
  std::size_t large_cells = 0, large_facets = 0;
  double volume = 0, median_edge = 0;           // the largest changes of a subdomain's
};

template <class C3t3>
Outcome measure(const C3t3& c3t3, const Sizes& sizes, const C3t3& input)
{
  constexpr double tolerance = 1e-9;
  Outcome o;
  const CGAL::Mesh_quality_report_3 q = CGAL::mesh_quality_report_3(c3t3, { 20, 30 });
  o.smallest_angle = q.smallest_angle;
  o.radius_ratio = q.mean_radius_ratio;
  o.below_20 = q.cells_below[0].second;
  o.below_30 = q.cells_below[1].second;
  o.cells = q.number_of_cells;
  const auto& tr = c3t3.triangulation();
  const auto position = [](const auto& v) { return v->point().point(); };
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
  {
    const double radius = std::sqrt(CGAL::squared_distance(position(c->vertex(0)), tr.dual(c)));
    const double r = radius / sizes.cell(static_cast<int>(c->subdomain_index()));
    o.largest_cell = (std::max)(o.largest_cell, r);
    o.large_cells += r > 1 + tolerance;
  }
  for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
  {
    const double r = std::sqrt(CGAL::squared_distance(position(f->first->vertex((f->second + 1) % 4)),
                                                      f->first->get_facet_surface_center(f->second))) / sizes.facet;
    o.largest_facet = (std::max)(o.largest_facet, r);
    o.large_facets += r > 1 + tolerance;
  }
  o.volume = odt::largest_change(volumes(input), volumes(c3t3));
  o.median_edge = odt::largest_change(median_edges(input), median_edges(c3t3));
  return o;
}

template <class C3t3, class F>
Outcome outcome(const C3t3& input, const Sizes& sizes, const F& optimize)
{
  return in_process_of_its_own<Outcome>([&]
  {
    C3t3 c3t3(input);
    Outcome of_call;
    const double cpu = seconds([&] { optimize(c3t3, of_call); });
    Outcome o = measure(c3t3, sizes, input);
    o.cpu = cpu;
    o.stages = of_call.stages;
    return o;
  });
}

static void print(const char* what, const Outcome& o, double reference)
{
  std::printf("  %-6s %7.2f s %5.2f  angle %5.2f  <20 %5zu  <30 %5zu  3r/R %.4f  "
              "cells %.3f, %zu of %zu over  facets %.3f, %zu over  volume %+.2f %%  edge %+.1f %%\n", what, o.cpu,
              o.cpu / reference, o.smallest_angle, o.below_20, o.below_30, o.radius_ratio, o.largest_cell, o.large_cells, o.cells,
              o.largest_facet, o.large_facets, 100 * o.volume, 100 * o.median_edge);
  std::fflush(stdout);
}

// The ratios of CPU times, over that of the chain, of meshes with 1000 vertices or more, by name.
static std::vector<std::pair<double, std::string> > ratios;

template <class C3t3, class Domain>
void compare(const std::string& name, const C3t3& input, const Domain& domain, const Sizes& sizes)
{
  constexpr std::size_t few_vertices = 1000;
  const std::size_t vertices = input.triangulation().number_of_vertices();
  std::printf("%s, %zu vertices\n", name.c_str(), vertices);
  print("input", measure(input, sizes, input), 1);
  const Outcome cgal = outcome(input, sizes, [&](C3t3& c3t3, Outcome&) { odt_of_mesh_3(c3t3, domain); });
  const Outcome chain = outcome(input, sizes, [&](C3t3& c3t3, Outcome&)
  {
    odt_of_mesh_3(c3t3, domain);
    CGAL::perturb_mesh_3(c3t3, domain, params::sliver_bound = 20);
    if(sizes.are_of_image)
      CGAL::exude_mesh_3(c3t3);
  });
  print("odt", cgal, chain.cpu);
  print("chain", chain, chain.cpu);
  const Outcome ours = outcome(input, sizes, [&](C3t3& c3t3, Outcome& o)
  {
    typedef CGAL::Mesh_3::Null_global_optimizer_visitor<C3t3> Visitor;
    Visitor visitor;
    odt::Odt_parameters parameters;
    if(const char* seed = std::getenv("RANDOM_SEED"))
      parameters.random_seed = static_cast<unsigned int>(std::atoi(seed));
    if(const char* rounds = std::getenv("NUMBER_OF_ROUNDS"))
      parameters.number_of_rounds = static_cast<std::size_t>(std::atoi(rounds));
    odt::Odt_mesh_optimizer_3<C3t3, Domain, Visitor> optimizer(c3t3, domain, odt::Odt_task::OPTIMIZE, parameters, visitor);
    optimizer();
    for(int n = 0; n < odt::Stage_clock::NUMBER_OF_STAGES; ++n)
      o.stages[n] = optimizer.clock().seconds(n);
  });
  print("ours", ours, chain.cpu);
  for(int n = 0; n < odt::Stage_clock::NUMBER_OF_STAGES; ++n)
    std::printf("%s%s %.2f", n == 0 ? "         " : ", ", odt::Stage_clock::name(n), ours.stages[n]);
  std::printf("\n");
  if(vertices >= few_vertices)
    ratios.emplace_back(ours.cpu / chain.cpu, name);
}

static void compare_model(const std::string& name, const std::string& file, double relative_size, bool with_features)
{
  const Polyhedron polyhedron = read_polyhedron(file);
  Polyhedral_domain domain(polyhedron);
  if(with_features)
    domain.detect_features();
  const CGAL::Bbox_3 b = domain.bbox();
  const double size = relative_size * std::sqrt(CGAL::square(b.xmax() - b.xmin()) + CGAL::square(b.ymax() - b.ymin())
                                                + CGAL::square(b.zmax() - b.zmin()));
  compare(name, polyhedral_mesh(domain, relative_size, with_features, 0.1), domain, { [size](int) { return size; }, size });
}

// The sizes of cells are one plus the second by the label.
static void compare_image(const std::string& name, const CGAL::Image_3& image, double facet_size, double facet_distance,
                          double cell_size, double more_by_label = 0)
{
  typedef CGAL::Mesh_constant_domain_field_3<Kernel, Labeled_domain::Index> Field;
  const Labeled_domain domain = image_domain(image);
  Field field(cell_size);
  const auto size = [=](int label) { return cell_size + more_by_label * label; };
  if(more_by_label != 0)
    for(int label = 1; label <= 5; ++label)
      field.set_size(size(label), 3, domain.index_from_subdomain_index(label));
  typedef CGAL::Mesh_criteria_3<Labeled_triangulation> Criteria;
  const Criteria criteria(params::facet_angle = 30, params::facet_size = facet_size, params::facet_distance = facet_distance,
                          params::cell_radius_edge_ratio = 3, params::cell_size = field);
  compare(name, reproducible_mesh<Labeled_c3t3>(domain, criteria), domain, { size, facet_size, true });
}

// A ball that sticks out of a box: label 2 in the ball, 1 in the rest of the box. The edges of the box and the circles in
// its sides are features.
static void compare_ball_in_box(const std::string& name, double scale)
{
  typedef std::vector<Point_3> Polyline;
  constexpr double radius = 1.2, circle = 0.6633249580710799;     // the root of 1.2^2 - 1
  constexpr int edges_of_circle = 72;
  const Polyline_domain domain(std::function<int(const Point_3&)>([](const Point_3& p)
  {
    if((std::max)({ std::abs(p.x()), std::abs(p.y()), std::abs(p.z()) }) > 1)
      return 0;
    return CGAL::squared_distance(p, Point_3(CGAL::ORIGIN)) < radius * radius ? 2 : 1;
  }), CGAL::Bbox_3(-1.1, -1.1, -1.1, 1.1, 1.1, 1.1));
  std::vector<Polyline> features;
  const auto at = [](int axis, double a, double b, double c)
  { return axis == 0 ? Point_3(a, b, c) : axis == 1 ? Point_3(c, a, b) : Point_3(b, c, a); };
  for(int axis = 0; axis < 3; ++axis)
    for(double s : { -1., 1. })
    {
      for(double t : { -1., 1. })
        features.push_back({ at(axis, -1, s, t), at(axis, 1, s, t) });
      features.emplace_back();
      for(int n = 0; n <= edges_of_circle; ++n)
      {
        const double angle = 2 * CGAL_PI * (n % edges_of_circle) / edges_of_circle;
        features.back().push_back(at(axis, s, circle * std::cos(angle), circle * std::sin(angle)));
      }
    }
  Polyline_domain with_features = domain;
  with_features.add_features(features.begin(), features.end());
  typedef CGAL::Mesh_criteria_3<Polyline_triangulation> Criteria;
  const double cell_size = 0.12 * scale, facet_size = 0.09 * scale;
  const Criteria criteria(params::edge_size = 0.072 * scale, params::facet_angle = 25, params::facet_size = facet_size,
                          params::facet_distance = 0.0054 * scale, params::cell_radius_edge_ratio = 2.5,
                          params::cell_size = cell_size);
  compare(name, reproducible_mesh<Polyline_c3t3>(with_features, criteria), with_features,
          { [=](int) { return cell_size; }, facet_size });
}

static std::map<std::string, std::function<void()> > all_inputs()
{
  std::map<std::string, std::function<void()> > inputs;
  const auto add_model = [&](const std::string& model, double relative_size, bool with_features = true)
  {
    char size[16];
    std::snprintf(size, sizeof size, " %.4g", relative_size);
    const std::string name = model + size;
    inputs[name] = [=] { compare_model(name, CGAL::data_file_path("meshes/" + model + ".off"), relative_size, with_features); };
  };
  for(const auto& m : { std::make_pair("part", 0.018), { "rotor_small", 0.03 }, { "pinion_small", 0.03 },
                        { "couplingdown", 0.03 }, { "fandisk", 0.0215 }, { "fandisk", 0.05 }, { "joint", 0.03 },
                        { "anchor", 0.03 }, { "spool", 0.03 }, { "cross", 0.04 }, { "cheese", 0.03 },
                        { "tripod", 0.03 }, { "u", 0.03 }, { "pinion", 0.04 }, { "handle", 0.03 }, { "dragknob", 0.04 } })
    add_model(m.first, m.second);
  for(const auto& m : { std::make_pair("elephant", 0.02), { "armadillo", 0.02 }, { "bear", 0.03 }, { "knot1", 0.025 },
                        { "cactus", 0.025 }, { "blobby", 0.025 }, { "hand", 0.025 } })
    add_model(m.first, m.second, false);
  inputs["ball in box"] = [] { compare_ball_in_box("ball in box", 1); };
  inputs["coarse ball in box"] = [] { compare_ball_in_box("coarse ball in box", 1.5); };
  inputs["polycrystal"] = [] { compare_image("polycrystal", synthetic_images::polycrystal(80, 20), 5, 1, 6); };
  inputs["fine polycrystal"] = [] { compare_image("fine polycrystal", synthetic_images::polycrystal(80, 20), 3, .6, 3.6); };
  inputs["head"] = [] { compare_image("head", synthetic_images::head(96), 4, .9, 5); };
  inputs["separate balls"] = [] { compare_image("separate balls", synthetic_images::separate_balls(), 1.8, .3, 1.2, .5); };
  inputs["liver"] = []
  {
    CGAL::Image_3 image;
    if(image.read(CGAL::data_file_path("images/liver.inr.gz").c_str()))
      compare_image("liver", image, 6, 2, 8);
  };
  const auto add_sphere = [&](const std::string& name, double size)
  {
    inputs[name] = [=]
    {
      const Labeled_domain domain = sphere_domain();
      compare(name, sphere(domain, size), domain, { [=](int) { return size; }, size });
    };
  };
  add_sphere("sphere", 0.0572);
  add_sphere("coarse sphere", 0.096);
  add_sphere("small sphere", 0.15);
  return inputs;
}

int main(int argc, char* argv[])
{
  const auto inputs = all_inputs();
  std::vector<std::string> names(argv + 1, argv + argc);
  if(names.empty())
    for(const auto& i : inputs)
      names.push_back(i.first);
  for(const std::string& name : names)
  {
    const auto it = inputs.find(name);
    const std::size_t colon = name.find(".off:");
    if(it != inputs.end())
      it->second();
    else if(colon != std::string::npos)
      compare_model(name, name.substr(0, colon + 4), std::atof(name.c_str() + colon + 5),
                    name.find(":smooth") == std::string::npos);
    else
      std::printf("there is no input %s\n", name.c_str());
  }
  std::sort(ratios.begin(), ratios.end());
  if(ratios.empty())
    return EXIT_SUCCESS;
  std::printf("CPU over that of CGAL's chain, meshes of 1000 vertices or more: median %.2f, largest\n",
              ratios[ratios.size() / 2].first);
  for(std::size_t n = 0; n < (std::min)(ratios.size(), std::size_t(20)); ++n)
    std::printf("  %5.2f %s\n", ratios[ratios.size() - 1 - n].first, ratios[ratios.size() - 1 - n].second.c_str());
  return EXIT_SUCCESS;
}
