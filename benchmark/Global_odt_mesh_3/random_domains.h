// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_RANDOM_DOMAINS_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_RANDOM_DOMAINS_H

#include "random_composite_domains.h"
#include "random_draw.h"

#include <CGAL/make_mesh_3.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>

// Domains and meshes of them that are drawn at random: implicit ones with one and with many subdomains, thin, tangent, tiny,
// huge, and far from the origin; images; polyhedra with and without features; and what is composed of these.
namespace random_domains {

struct Implicit_input : Random_input
{
  typedef Labeled_domain Domain;
  typedef Labeled_c3t3 C3t3;

  std::shared_ptr<Failing> failing = std::make_shared<Failing>();
  double radius;
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
    return is_graded ? criteria_without_features<Labeled_criteria>(sizes, radius, Size{ graded })
                     : criteria_without_features<Labeled_criteria>(sizes, radius);
  }

  C3t3 mesh() const { return CGAL::make_mesh_3<C3t3>(domain, criteria(), params::no_exude(), params::no_perturb()); }

  void fail_sometimes(Draw& draw) { failing->fail_sometimes(draw); }
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
    : Random_input(labels.first, draw)
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
      f->ask();
      return labels({{ (p.x() - c.x()) / r, (p.y() - c.y()) / r, (p.z() - c.z()) / r }});
    };
  }
};

// The same, or gray values, on a grid, perhaps with noise.
struct Image_input : Random_input
{
  typedef Labeled_domain Domain;
  typedef Labeled_c3t3 C3t3;

  CGAL::Image_3 image;
  Domain domain;

  explicit Image_input(Draw& draw) : Image_input(draw, random_labels(draw), draw.chance(0.3)) {}

  Labeled_criteria criteria() const { return criteria_without_features<Labeled_criteria>(sizes, 0.5); }
  C3t3 mesh() const { return CGAL::make_mesh_3<C3t3>(domain, criteria(), params::no_exude(), params::no_perturb()); }

private:
  Image_input(Draw& draw, const std::pair<std::string, Labels>& labels, bool is_gray)
    : Random_input((is_gray ? "gray image of a " : "labeled image of a ") + labels.first, draw)
    , image(make(draw, labels.second, is_gray))
    , domain(is_gray ? gray_image_domain(image) : labeled_image_domain(image))
  {
    tolerance = 5e-2;               // steps of voxels
  }

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

struct Polyhedral_input : Random_input
{
  typedef Polyhedral_domain Domain;
  typedef Polyhedral_c3t3 C3t3;

  double radius;
  bool has_features;
  Polyhedron polyhedron;
  Domain domain;

  explicit Polyhedral_input(Draw& draw)
    : Random_input(random_model(draw), draw)
    , has_features(draw.chance(0.5))
    , polyhedron(read_model(name))
    , domain(polyhedron)
  {
    radius = radius_of(domain.bbox());
    if(has_features)
      domain.detect_features();
    name += has_features ? " with features" : " without features";
  }

  Polyhedral_criteria criteria() const { return criteria_with_features<Polyhedral_criteria>(sizes, radius); }
  C3t3 mesh() const
  {
    if(has_features)
      return CGAL::make_mesh_3<C3t3>(domain, criteria(), params::no_exude(), params::no_perturb());
    return CGAL::make_mesh_3<C3t3>(domain, criteria(), params::no_exude(), params::no_perturb(), params::no_features());
  }
};

template <class Input, class F>
void with_input(Draw& draw, const F& f)
{
  Input input(draw);
  f(input);
}

// Calls f(input).
template <class F>
void with_random_input(Draw& draw, const F& f)
{
  const int kind = draw.integer(0, 13);
  if(kind < 4)
    with_input<Implicit_input>(draw, f);
  else if(kind < 6)
    with_input<Image_input>(draw, f);
  else if(kind < 8)
    with_input<Polyhedral_input>(draw, f);
  else if(kind < 10)
    with_input<Surface_inside_input>(draw, f);
  else if(kind < 12)
    with_input<Polyhedral_complex_input>(draw, f);
  else
    with_input<Hybrid_input>(draw, f);
}

} // namespace random_domains

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_RANDOM_DOMAINS_H
