// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_RANDOM_DRAW_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_RANDOM_DRAW_H

#include "mesh_domains.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Random.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <fstream>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// What random domains are drawn from: numbers, labels of points, criteria, and polyhedra of CGAL's data.
namespace random_domains {

using namespace domains;

// What a domain or callback throws when it is meant to.
struct Planned_failure : std::runtime_error
{
  Planned_failure() : std::runtime_error("planned failure") {}
};

class Draw
{
public:
  explicit Draw(unsigned int seed) : engine_(seed) { CGAL::get_default_random() = CGAL::Random(seed); }

  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }
  double power(double from, double to) { return std::exp(uniform(std::log(from), std::log(to))); }
  int integer(int from, int to) { return std::uniform_int_distribution<int>(from, to)(engine_); }
  bool chance(double p) { return uniform(0, 1) < p; }

private:
  std::mt19937 engine_;
};

// A domain asks this object, which stays where it is, at each question; perhaps from several threads.
struct Failing
{
  std::atomic<long> questions{0}, throws_after{-1};

  void fail_sometimes(Draw& draw)
  {
    questions = 0;
    throws_after = draw.chance(0.1) ? draw.integer(0, 20000) : -1;
  }

  void ask()
  {
    const long question = ++questions, last = throws_after;
    if(last >= 0 && question > last)
      throw Planned_failure();
  }
};

typedef std::array<double, 3> Place;
typedef std::function<int(const Place&)> Labels;

inline double squared_norm(const Place& p) { return p[0] * p[0] + p[1] * p[1] + p[2] * p[2]; }

// In about the unit ball.
inline std::pair<std::string, Labels> random_labels(Draw& draw)
{
  switch(draw.integer(0, 5))
  {
  case 0:
  {
    std::vector<std::array<double, 4> > waves(draw.integer(1, 6));
    for(auto& w : waves)
      w = {{ draw.uniform(-8, 8), draw.uniform(-8, 8), draw.uniform(-8, 8), draw.uniform(0, 6) }};
    const double height = draw.uniform(0, 0.35);
    return { "trigonometric surface", [=](const Place& p)
    {
      double f = squared_norm(p) - 0.7;
      for(const auto& w : waves)
        f += height * std::sin(w[0] * p[0] + w[1] * p[1] + w[2] * p[2] + w[3]);
      return f < 0 && squared_norm(p) < 1.5 ? 1 : 0;
    } };
  }
  case 1:
  {
    std::vector<Place> centers(draw.integer(2, 20));
    for(Place& c : centers)
      c = {{ draw.uniform(-1, 1), draw.uniform(-1, 1), draw.uniform(-1, 1) }};
    return { "Voronoi cells in a ball", [=](const Place& p)
    {
      if(squared_norm(p) >= 1)
        return 0;
      const auto distance = [&p](const Place& c) { return squared_norm({{ p[0] - c[0], p[1] - c[1], p[2] - c[2] }}); };
      return 1 + static_cast<int>(std::min_element(centers.begin(), centers.end(), [&](const Place& a, const Place& b)
                                                   { return distance(a) < distance(b); }) - centers.begin());
    } };
  }
  case 2:
  {
    const double thickness = draw.power(0.03, 0.3);
    return { "plate", [=](const Place& p)
    { return std::abs(p[0]) < 0.9 && std::abs(p[1]) < 0.8 && std::abs(p[2]) < thickness ? 1 : 0; } };
  }
  case 3:
  {
    const double gap = draw.chance(0.5) ? 0 : draw.uniform(-0.05, 0.05);
    const int second = draw.integer(1, 2);
    return { "balls that touch", [=](const Place& p)
    {
      return squared_norm({{ p[0] - 0.5, p[1], p[2] }}) < 0.25 ? 1
           : squared_norm({{ p[0] + 0.5 + gap, p[1], p[2] }}) < 0.25 ? second : 0;
    } };
  }
  case 4:
  {
    const double inner = draw.uniform(0.2, 0.95);
    const int hollow = draw.integer(0, 2);
    return { "shell", [=](const Place& p)
    { return squared_norm(p) >= 1 ? 0 : squared_norm(p) < inner * inner ? hollow : 1; } };
  }
  default:
  {
    const double radius = draw.uniform(0.1, 0.6), x = draw.uniform(-0.5, 0.5), y = draw.uniform(-0.5, 0.5);
    return { "ball cut by planes", [=](const Place& p)
    {
      return squared_norm(p) >= 1 ? 0 : squared_norm({{ p[0], p[1], p[2] - 0.3 }}) < radius * radius ? 4
           : p[0] > x ? 1 : p[1] > y ? 2 : 3;
    } };
  }
  }
}

// What inputs have in common: sizes of facets and cells relative to the radius.
struct Sizes
{
  double facet, cell, distance, angle, ratio;

  explicit Sizes(Draw& draw)
    : facet(draw.power(0.09, 0.6))
    , cell(facet * draw.uniform(0.7, 2))
    , distance(facet * draw.uniform(0.1, 0.5))
    , angle(draw.uniform(15, 30))
    , ratio(draw.uniform(2, 3.5))
  {}
};

inline double radius_of(const CGAL::Bbox_3& box)
{
  return std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()) / 2;
}

// What inputs have; those whose domains cannot fail leave the last two as they are.
struct Random_input
{
  std::string name;
  Sizes sizes;
  double tolerance = 1e-2;          // how far vertices may be off the surface, over the size of the mesh

  Random_input(const std::string& n, Draw& draw) : name(n), sizes(draw) {}

  void fail_sometimes(Draw&) {}
  void stop_failing() {}
};

template <class Criteria, class Cell_size>
Criteria criteria_without_features(const Sizes& sizes, double radius, const Cell_size& cell_size)
{
  return Criteria(params::facet_angle = sizes.angle, params::facet_size = sizes.facet * radius,
                  params::facet_distance = sizes.distance * radius, params::cell_radius_edge_ratio = sizes.ratio,
                  params::cell_size = cell_size);
}

template <class Criteria>
Criteria criteria_without_features(const Sizes& sizes, double radius)
{
  return criteria_without_features<Criteria>(sizes, radius, sizes.cell * radius);
}

template <class Criteria>
Criteria criteria_with_features(const Sizes& sizes, double radius)
{
  return Criteria(params::edge_size = sizes.facet * radius, params::facet_angle = sizes.angle,
                  params::facet_size = sizes.facet * radius, params::facet_distance = sizes.distance * radius / 4,
                  params::cell_radius_edge_ratio = sizes.ratio, params::cell_size = sizes.cell * radius);
}

inline const std::vector<std::string>& models()
{
  static const std::vector<std::string> names
    = { "3torus", "anchor", "bear", "bull", "camel", "cheese", "couplingdown", "cow", "cross", "cube", "dragknob",
        "eight", "elephant", "ellipsoid", "fandisk", "femur", "hand", "handle", "homer", "icosahedron", "joint",
        "knot1", "lion-head", "oblong", "octahedron", "part", "pinion", "pipe", "rotor", "sphere", "spool", "star",
        "tetrahedron", "triceratops", "tripod" };
  return names;
}

inline std::string random_model(Draw& draw) { return models()[draw.integer(0, static_cast<int>(models().size()) - 1)]; }

// That of the name, which becomes "sphere" if that is no closed surface of triangles that bounds a volume.
inline Polyhedron read_model(std::string& name)
{
  const auto is_fit = [](const Polyhedron& p)
  {
    return !p.empty() && p.is_valid() && p.is_closed() && p.is_pure_triangle()
           && !CGAL::Polygon_mesh_processing::does_self_intersect(p);
  };
  for(;;)
  {
    Polyhedron p;
    std::ifstream in(CGAL::data_file_path("meshes/" + name + ".off"));
    if(in >> p && is_fit(p))
      return p;
    if(name == "sphere")
      throw std::runtime_error("there is no file meshes/sphere.off in CGAL's data");
    name = "sphere";
  }
}

} // namespace random_domains

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_RANDOM_DRAW_H
