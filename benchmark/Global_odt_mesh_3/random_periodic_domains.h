// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_RANDOM_PERIODIC_DOMAINS_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_RANDOM_PERIODIC_DOMAINS_H

#include "periodic_meshes.h"

#include "random_draw.h"

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// Periodic domains and meshes of them that are drawn at random: level sets, implicit or labelled; foams; balls that overlap and
// touch; layers. The cube is somewhere. Its period is a power of two, so that its sides are equal to the last bit, and at most 1, since
// a postcondition of CGAL wants that.
namespace random_domains {

// Of a cube with sides of length 1.
inline std::pair<std::string, Labels> random_periodic_labels(Draw& draw)
{
  const auto points = [&draw](int most)
  {
    std::vector<periodic::Point> result;
    for(int n = draw.integer(2, most); n > 0; --n)
      result.emplace_back(draw.uniform(0, 1), draw.uniform(0, 1), draw.uniform(0, 1));
    return result;
  };
  switch(draw.integer(0, 3))
  {
  case 0:
  {
    const std::vector<periodic::Point> seeds = points(20);
    return { "foam", [=](const Place& p) { return 1 + periodic::nearest(seeds, periodic::Point(p[0], p[1], p[2])); } };
  }
  case 1:
  {
    const std::vector<periodic::Point> centers = points(8);
    const double radius = draw.uniform(0.1, 0.4);
    const int labels = draw.integer(1, 3);
    return { "balls", [=](const Place& place)
    {
      const periodic::Point p(place[0], place[1], place[2]);
      const int n = periodic::nearest(centers, p);
      return periodic::squared_distance(centers[n], p) < radius * radius ? 1 + n % labels : 0;
    } };
  }
  case 2:
  {
    const double thickness = draw.power(0.05, 0.5), height = draw.uniform(0, 0.2);
    const int beside = draw.integer(0, 2);
    return { "layers", [=](const Place& p)
    {
      const double z = p[2] + height * std::sin(2 * CGAL_PI * p[0]);
      return z - std::floor(z) < thickness ? 1 : beside;
    } };
  }
  default:
  {
    std::vector<std::array<double, 4> > waves(draw.integer(1, 6));
    for(auto& w : waves)
      w = {{ double(draw.integer(-2, 2)), double(draw.integer(-2, 2)), double(draw.integer(-2, 2)), draw.uniform(0, 1) }};
    const int labels = draw.integer(1, 3);
    const double width = draw.uniform(0.2, 1);
    return { "level sets", [=](const Place& p)
    {
      double f = 0;
      for(const auto& w : waves)
        f += std::sin(2 * CGAL_PI * (w[0] * p[0] + w[1] * p[1] + w[2] * p[2] + w[3]));
      return labels == 1 ? f < 0 : f < -width / 2 ? 1 : labels == 3 && f > width / 2 ? 3 : 2;
    } };
  }
  }
}

struct Periodic_input : Random_input
{
  typedef periodic::Domain Domain;
  typedef periodic::C3t3 C3t3;

  std::shared_ptr<Failing> failing = std::make_shared<Failing>();
  double period;
  periodic::Point corner;
  Domain domain;

  explicit Periodic_input(Draw& draw) : Periodic_input(draw, random_periodic_labels(draw)) {}

  periodic::Criteria criteria() const { return criteria_without_features<periodic::Criteria>(sizes, 0.6 * period); }
  C3t3 mesh() const { return CGAL::make_periodic_3_mesh_3<C3t3>(domain, criteria(), params::no_exude(), params::no_perturb()); }

  void fail_sometimes(Draw& draw) { failing->fail_sometimes(draw); }
  void stop_failing() { failing->throws_after = -1; }

private:
  Periodic_input(Draw& draw, const std::pair<std::string, Labels>& labels)
    : Random_input("periodic " + labels.first, draw)
    , period(std::ldexp(1., draw.chance(0.3) ? -draw.integer(1, 10) : 0))
    , corner(draw.chance(0.3) ? periodic::Point(draw.integer(-5, 5) * period, -0.5 * period, 100 * period) : periodic::Point(0, 0, 0))
    , domain(make(labels.second, draw.chance(0.3)))
  {}

  Domain make(const Labels& labels, bool is_implicit) const
  {
    const periodic::Kernel::Iso_cuboid_3 cube(corner, periodic::Point(corner.x() + period, corner.y() + period, corner.z() + period));
    const auto label = [labels, c = corner, r = period, f = failing](const periodic::Point& p)
    {
      f->ask();
      return labels({{ (p.x() - c.x()) / r, (p.y() - c.y()) / r, (p.z() - c.z()) / r }});
    };
    if(is_implicit)
      return Domain::create_implicit_mesh_domain([label](const periodic::Point& p) { return label(p) == 1 ? -1. : 1.; }, cube);
    return Domain(std::function<int(const periodic::Point&)>(label), cube);
  }
};

// Calls f(input).
template <class F>
void with_random_input(Draw& draw, const F& f)
{
  Periodic_input input(draw);
  f(input);
}

} // namespace random_domains

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_RANDOM_PERIODIC_DOMAINS_H
