// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_POINT_RULE_QUADRATURE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_POINT_RULE_QUADRATURE_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/density/Density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Adds up moments from values of the density at points of a cell.
class Density_samples_3
{
public:
  typedef std::array<double, 4> Barycentric_coordinates;

  // The products of coordinates in the order of Density_moments_3, then the squares.
  typedef std::array<double, 10> Products;

  // The densities are asked as of the vertex with the lowest number: that of the highest dimension.
  Density_samples_3(const Density_quadrature_3::Density& density, const int* vertices, const Site* sites)
    : density_(density)
    , vertex_((std::min)((std::min)(vertices[0], vertices[1]), (std::min)(vertices[2], vertices[3])))
    , sites_{{ sites[vertices[0]], sites[vertices[1]], sites[vertices[2]], sites[vertices[3]] }}
  {}

  double density(const Barycentric_coordinates& l) const
  {
    Site s = { 0, 0, 0, 0 };
    for(int i = 0; i < 4; ++i)
    {
      s.x += l[i] * sites_[i].x;
      s.y += l[i] * sites_[i].y;
      s.z += l[i] * sites_[i].z;
    }
    return density_(vertex_, s);
  }

  // Adds rho times the products at a point of a rule, and its weight.
  void add(const Barycentric_coordinates& l, double weight, Products& sum) const
  {
    const double rho = weight * density(l);
    for(int e = 0; e < 6; ++e)
      sum[e] += rho * l[Density_moments_3::edges[e][0]] * l[Density_moments_3::edges[e][1]];
    for(int i = 0; i < 4; ++i)
      sum[6 + i] += rho * l[i] * l[i];
  }

  // The coordinates add up to one, so that m_i is the sum of all m_ij.
  static Density_moments_3 moments(const Products& p)
  {
    Density_moments_3 m;
    for(int i = 0; i < 4; ++i)
      m.first[i] = p[6 + i];
    for(int e = 0; e < 6; ++e)
    {
      m.mixed[e] = p[e];
      for(int i : Density_moments_3::edges[e])
        m.first[i] += p[e];
    }
    return m;
  }

private:
  const Density_quadrature_3::Density& density_;
  int vertex_;
  std::array<Site, 4> sites_;
};

// The moments by a symmetric rule with positive weights, from which follow positive moments.
class Point_rule_quadrature_3
  : public Density_quadrature_3
{
public:
  struct Point
  {
    double weight;
    Density_samples_3::Barycentric_coordinates coordinates;
  };

  struct Rule
  {
    int degree;
    std::vector<Point> points;
  };

  Point_rule_quadrature_3(Density density, Rule rule)
    : density_(std::move(density))
    , rule_(std::move(rule))
  {}

  // The rule of degree 2 (Stroud, Approximate Calculation of Multiple Integrals, T3:2-1).
  static Rule four_points()
  {
    Rule rule = { 2, {} };
    add_vertex_orbit((5 - std::sqrt(5.)) / 20, 0.25, rule);
    return rule;
  }

  // The rule of degree 5 (the same, T3:5-1).
  static Rule fifteen_points()
  {
    const double root = std::sqrt(15.);
    Rule rule = { 5, {{ 16. / 135, {{ 0.25, 0.25, 0.25, 0.25 }} }} };
    add_vertex_orbit((7 - root) / 34, (2665 + 14 * root) / 37800, rule);
    add_vertex_orbit((7 + root) / 34, (2665 - 14 * root) / 37800, rule);
    add_edge_orbit((5 - root) / 20, 10. / 189, rule);
    return rule;
  }

  Density_moments_3 moments(int, const int* vertices, const Site* sites) override
  {
    const Density_samples_3 samples(density_, vertices, sites);
    Density_samples_3::Products sum = {};
    for(const Point& p : rule_.points)
      samples.add(p.coordinates, p.weight, sum);
    return Density_samples_3::moments(sum);
  }

  std::unique_ptr<Density_quadrature_3> part(const std::vector<int>& vertices) const override
  {
    return std::make_unique<Point_rule_quadrature_3>(renumbered(density_, vertices), rule_);
  }

  // The moments multiply the density by two coordinates.
  double energy_tolerance() const override
  {
    return rule_.degree <= 2 ? tolerance_of_rough_moments : Density_quadrature_3::energy_tolerance();
  }

private:
  // Points with three coordinates `a`.
  static void add_vertex_orbit(double a, double weight, Rule& rule)
  {
    for(int i = 0; i < 4; ++i)
    {
      rule.points.push_back({ weight, {{ a, a, a, a }} });
      rule.points.back().coordinates[i] = 1 - 3 * a;
    }
  }

  // Points with two coordinates `a`.
  static void add_edge_orbit(double a, double weight, Rule& rule)
  {
    for(const std::array<int, 2>& edge : Density_moments_3::edges)
    {
      rule.points.push_back({ weight, {{ a, a, a, a }} });
      for(int i : edge)
        rule.points.back().coordinates[i] = 0.5 - a;
    }
  }

  Density density_;
  Rule rule_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_POINT_RULE_QUADRATURE_3_H
