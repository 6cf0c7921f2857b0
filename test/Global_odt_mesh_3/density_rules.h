// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_TEST_DENSITY_RULES_H
#define GLOBAL_ODT_MESH_3_TEST_DENSITY_RULES_H

#include "check.h"

#include <CGAL/Global_odt_mesh_3/internal/density/Adaptive_cubature_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Point_rule_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/energy/Odt_cell_energies_3.h>
#include <CGAL/Global_odt_mesh_3/internal/energy/Reference_energy_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Quadratic_polynomial_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <random>
#include <utility>
#include <vector>

// Densities, and the rules that integrate them, for tests.
using namespace CGAL::Global_odt_mesh_3::internal;

typedef Eigen::Vector3d Vector;
typedef std::function<double(const Vector&)> Field;
typedef std::vector<Site> Sites;

inline Vector vector(const Site& s) { return Vector(s.x, s.y, s.z); }
inline Site site(const Vector& x, double weight = 0) { return { x.x(), x.y(), x.z(), weight }; }

inline double constant(const Vector&) { return 1; }
inline double smooth(const Vector& x) { return std::exp(1.1 * x.x() - 0.8 * x.y() + 1.7 * x.z()); }
inline double bell(const Vector& x) { return 1 / (0.1 + (x - Vector(0.3, 0.4, 0.45)).squaredNorm()); }
inline double waves(const Vector& x) { return 1.2 + std::sin(7 * x.x()) * std::cos(5 * x.y() - 3 * x.z()); }

// The interpolation between the vertices, wherever they are at the moment.
class Linear_quadrature
  : public Density_quadrature_3
{
public:
  explicit Linear_quadrature(Density density) : density_(std::move(density)) {}

  Density_moments_3 moments(int, const int* v, const Site* s) override
  {
    return linear_density_moments({{ density_(v[0], s[v[0]]), density_(v[1], s[v[1]]),
                                     density_(v[2], s[v[2]]), density_(v[3], s[v[3]]) }});
  }

  std::unique_ptr<Density_quadrature_3> part(const std::vector<int>& vertices) const override
  {
    return std::make_unique<Linear_quadrature>(renumbered(density_, vertices));
  }

private:
  Density density_;
};

inline Quadratic_polynomial_3 quadratic(const Vector& center, double c, const Vector& b, const Eigen::Matrix3d& q)
{
  return { coordinates(center), c, coordinates(b), {{ q(0, 0), q(1, 1), q(2, 2), 2 * q(1, 2), 2 * q(2, 0), 2 * q(0, 1) }} };
}

enum Rule { LINEAR, FOUR_POINTS, FIFTEEN_POINTS, CUBATURE };
inline constexpr std::array<Rule, 4> all_rules = {{ LINEAR, FOUR_POINTS, FIFTEEN_POINTS, CUBATURE }};
inline constexpr std::array<const char*, 4> names = {{ "linear", "4 points", "15 points", "cubature" }};

inline std::unique_ptr<Density_quadrature_3> make_rule(Rule rule, const Field& field, double tolerance = 1e-10,
                                                       int most_regions = 5000)
{
  const Density_quadrature_3::Density density = [field](int, const Site& s) { return field(vector(s)); };
  switch(rule)
  {
  case LINEAR: return std::make_unique<Linear_quadrature>(density);
  case FOUR_POINTS: return std::make_unique<Point_rule_quadrature_3>(density, Point_rule_quadrature_3::four_points());
  case FIFTEEN_POINTS: return std::make_unique<Point_rule_quadrature_3>(density, Point_rule_quadrature_3::fifteen_points());
  default: return std::make_unique<Adaptive_cubature_quadrature_3>(density, tolerance, most_regions);
  }
}

static const Cell_vertices first_four = {{ 0, 1, 2, 3 }};

static Density_moments_3 moments(Density_quadrature_3& rule, const Sites& s, const Cell_vertices& v = first_four)
{
  return rule.moments(0, v.data(), s.data());
}

inline Cell_energy energy(const Sites& s, const Density_moments_3& m)
{
  return odt_energy(Cell_products(s[0], s[1], s[2], s[3]), s[0], s[1], s[2], s[3], m);
}

inline double determinant(const Sites& s, const Cell_vertices& v = first_four)
{
  return Cell_products(s[v[0]], s[v[1]], s[v[2]], s[v[3]]).determinant;
}

inline double random_number(std::mt19937& random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

inline Vector random_vector(std::mt19937& random, double low, double high)
{
  const double x = random_number(random, low, high), y = random_number(random, low, high);
  return Vector(x, y, random_number(random, low, high));
}

// A cell of the unit cube that is not too flat.
inline Sites random_cell(std::mt19937& random)
{
  for(;;)
  {
    Sites s;
    for(int i = 0; i < 4; ++i)
      s.push_back(site(random_vector(random, 0, 1), random_number(random, 0, 0.05)));
    if(determinant(s) > 0.05)
      return s;
  }
}

// The largest difference of two moments.
inline double difference(const Density_moments_3& a, const Density_moments_3& b)
{
  check::Largest d;
  for(int i = 0; i < 4; ++i)
    d.add(std::abs(a.first[i] - b.first[i]));
  for(int e = 0; e < 6; ++e)
    d.add(std::abs(a.mixed[e] - b.mixed[e]));
  return d;
}

inline double mean_density(const Density_moments_3& m) { return m.first[0] + m.first[1] + m.first[2] + m.first[3]; }

inline Vector vector(const Site_gradient& g) { return Vector(g.x, g.y, g.z); }

// The largest difference of two gradients, and of D.
inline double difference(const Cell_energy& a, const Cell_energy& b)
{
  check::Largest d;
  for(int i = 0; i < 4; ++i)
  {
    d.add((vector(a.gradient[i]) - vector(b.gradient[i])).norm());
    d.add(std::abs(a.gradient[i].diagonal - b.gradient[i].diagonal));
  }
  return d;
}

template <class... What>
inline void near(double value, double wanted, double tolerance, const What&... what)
{
  check::that(std::abs(value - wanted) <= tolerance, what..., ": ", value, ", not ", wanted);
}

#endif // GLOBAL_ODT_MESH_3_TEST_DENSITY_RULES_H
