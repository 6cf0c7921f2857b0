// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_RANDOM_DOMAINS_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_RANDOM_DOMAINS_H

#include "mesh_domains.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Random.h>
#include <CGAL/make_mesh_3.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <fstream>
#include <functional>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Domains and meshes of them that are drawn at random: implicit ones with one and with many subdomains, thin, tangent, tiny,
// huge, and far from the origin; images; polyhedra with and without features.
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

struct Implicit_input
{
  typedef Labeled_domain Domain;
  typedef Labeled_c3t3 C3t3;

  // The domain asks this object, which stays where it is; perhaps from several threads.
  struct Failing
  {
    std::atomic<long> questions{0}, throws_after{-1};
  };

  std::string name;
  std::shared_ptr<Failing> failing = std::make_shared<Failing>();
  Sizes sizes;
  double radius, tolerance = 1e-2;
  bool is_graded;
  Point_3 center;
  Domain domain;

  explicit Implicit_input(Draw& draw) : Implicit_input(draw, random_labels(draw)) {}

  Labeled_criteria criteria() const
  {
    const Point_3 c = center;
    const double r = radius, smallest = sizes.cell * radius / 2;
    const auto graded = [=](const Point_3& p, int, const Domain::Index&)
    { return smallest * (1 + 2 * std::sqrt(CGAL::to_double(CGAL::squared_distance(p, c))) / r); };
    if(is_graded)
      return Labeled_criteria(params::facet_angle = sizes.angle, params::facet_size = sizes.facet * radius,
                              params::facet_distance = sizes.distance * radius, params::cell_radius_edge_ratio = sizes.ratio,
                              params::cell_size = Size{ graded });
    return Labeled_criteria(params::facet_angle = sizes.angle, params::facet_size = sizes.facet * radius,
                            params::facet_distance = sizes.distance * radius, params::cell_radius_edge_ratio = sizes.ratio,
                            params::cell_size = sizes.cell * radius);
  }

  C3t3 mesh() const { return CGAL::make_mesh_3<C3t3>(domain, criteria(), params::no_exude(), params::no_perturb()); }

  void fail_sometimes(Draw& draw)
  {
    failing->questions = 0;
    failing->throws_after = draw.chance(0.1) ? draw.integer(0, 20000) : -1;
  }
  void stop_failing() { failing->throws_after = -1; }

private:
  struct Size
  {
    typedef domains::FT FT;
    typedef domains::Point_3 Point_3;
    typedef Domain::Index Index;
    std::function<FT(const Point_3&, int, const Index&)> f;
    FT operator()(const Point_3& p, int dimension, const Index& index) const { return f(p, dimension, index); }
  };

  Implicit_input(Draw& draw, std::pair<std::string, Labels> labels)
    : name(labels.first)
    , sizes(draw)
    , radius(draw.chance(0.3) ? draw.power(1e-6, 1e6) : 1)
    , is_graded(draw.chance(0.3))
    , center(draw.chance(0.2) ? Point_3(1000 * radius, -300 * radius, 20 * radius) : Point_3(0, 0, 0))
    , domain(function(labels.second), Sphere_3(center, 4 * radius * radius), 1e-4)
  {}

  std::function<int(const Point_3&)> function(const Labels& labels) const
  {
    const double r = radius;
    const Point_3 c = center;
    const std::shared_ptr<Failing> f = failing;
    return [=](const Point_3& p)
    {
      const long question = ++f->questions, last = f->throws_after;
      if(last >= 0 && question > last)
        throw Planned_failure();
      return labels({{ (p.x() - c.x()) / r, (p.y() - c.y()) / r, (p.z() - c.z()) / r }});
    };
  }
};

// The same, or gray values, on a grid, perhaps with noise.
struct Image_input
{
  typedef Labeled_domain Domain;
  typedef Labeled_c3t3 C3t3;

  std::string name;
  Sizes sizes;
  double tolerance = 5e-2;          // steps of voxels
  CGAL::Image_3 image;
  Domain domain;

  explicit Image_input(Draw& draw) : Image_input(draw, random_labels(draw), draw.chance(0.3)) {}

  Labeled_criteria criteria() const
  {
    return Labeled_criteria(params::facet_angle = sizes.angle, params::facet_size = sizes.facet / 2,
                            params::facet_distance = sizes.distance / 2, params::cell_radius_edge_ratio = sizes.ratio,
                            params::cell_size = sizes.cell / 2);
  }
  C3t3 mesh() const { return CGAL::make_mesh_3<C3t3>(domain, criteria(), params::no_exude(), params::no_perturb()); }
  void fail_sometimes(Draw&) {}
  void stop_failing() {}

private:
  Image_input(Draw& draw, const std::pair<std::string, Labels>& labels, bool is_gray)
    : name((is_gray ? "gray image of a " : "labeled image of a ") + labels.first)
    , sizes(draw)
    , image(make(draw, labels.second, is_gray))
    , domain(is_gray ? gray_image_domain(image) : labeled_image_domain(image))
  {}

  static CGAL::Image_3 make(Draw& draw, const Labels& labels, bool is_gray)
  {
    using namespace CGAL;
    const int n = draw.integer(12, 48);
    const double noise = draw.chance(0.5) ? 0 : draw.uniform(0, 0.01);
    const auto at = [&](double x, double y, double z)
    {
      const Place p = {{ 2.4 * x - 1.2, 2.4 * y - 1.2, 2.4 * z - 1.2 }};
      return draw.chance(noise) ? draw.integer(0, 3) : labels(p);
    };
    if(!is_gray)
      return domains::image<unsigned char>(n, WK_FIXED, SGN_UNSIGNED, at);
    return domains::image<float>(n, WK_FLOAT, SGN_SIGNED, [&](double x, double y, double z)
                                 { return (at(x, y, z) > 0 ? 1 : 0) + draw.uniform(-0.1, 0.1); });
  }
};

struct Polyhedral_input
{
  typedef Polyhedral_domain Domain;
  typedef Polyhedral_c3t3 C3t3;

  std::string name;
  Sizes sizes;
  double tolerance = 1e-2, radius;
  bool has_features;
  Polyhedron polyhedron;
  Domain domain;

  explicit Polyhedral_input(Draw& draw)
    : name(models()[draw.integer(0, static_cast<int>(models().size()) - 1)])
    , sizes(draw)
    , has_features(draw.chance(0.5))
    , polyhedron(read(name))
    , domain(polyhedron)
  {
    const auto box = domain.bbox();
    radius = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()) / 2;
    if(has_features)
      domain.detect_features();
    name += has_features ? " with features" : " without features";
  }

  Polyhedral_criteria criteria() const
  {
    return Polyhedral_criteria(params::edge_size = sizes.facet * radius, params::facet_angle = sizes.angle,
                               params::facet_size = sizes.facet * radius,
                               params::facet_distance = sizes.distance * radius / 4,
                               params::cell_radius_edge_ratio = sizes.ratio, params::cell_size = sizes.cell * radius);
  }
  C3t3 mesh() const
  {
    if(has_features)
      return CGAL::make_mesh_3<C3t3>(domain, criteria(), params::no_exude(), params::no_perturb());
    return CGAL::make_mesh_3<C3t3>(domain, criteria(), params::no_exude(), params::no_perturb(), params::no_features());
  }
  void fail_sometimes(Draw&) {}
  void stop_failing() {}

private:
  static const std::vector<std::string>& models()
  {
    static const std::vector<std::string> names
      = { "3torus", "anchor", "bear", "bull", "camel", "cheese", "couplingdown", "cow", "cross", "cube", "dragknob",
          "eight", "elephant", "ellipsoid", "fandisk", "femur", "hand", "handle", "homer", "icosahedron", "joint",
          "knot1", "lion-head", "oblong", "octahedron", "part", "pinion", "pipe", "rotor", "sphere", "spool", "star",
          "tetrahedron", "triceratops", "tripod" };
    return names;
  }

  // A sphere in place of what bounds no volume.
  static Polyhedron read(std::string& name)
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
};

// Calls f(input).
template <class F>
void with_random_input(Draw& draw, const F& f)
{
  const int kind = draw.integer(0, 9);
  if(kind < 5)
  {
    Implicit_input input(draw);
    f(input);
  }
  else if(kind < 7)
  {
    Image_input input(draw);
    f(input);
  }
  else
  {
    Polyhedral_input input(draw);
    f(input);
  }
}

} // namespace random_domains

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_RANDOM_DOMAINS_H
