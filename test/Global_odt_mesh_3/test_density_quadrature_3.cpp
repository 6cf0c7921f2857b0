// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The rules that integrate densities over cells: exactness, orders of convergence, tolerances, invariance, and what is kept
// of them.

#include "check.h"
#include "density_rules.h"

#include <CGAL/Global_odt_mesh_3/internal/density/Make_density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Polynomial_density_quadrature_3.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Exact_rational Rational;
typedef CGAL::Simple_cartesian<Rational>::Vector_3 Exact_vector;
typedef std::array<int, 4> Exponents;

// In barycentric coordinates.
struct Polynomial
{
  std::map<Exponents, Rational> terms;

  static Polynomial constant(const Rational& c) { return { { { Exponents(), c } } }; }

  static Polynomial coordinate(int i)
  {
    Exponents a = {};
    a[i] = 1;
    return { { { a, Rational(1) } } };
  }

  friend Polynomial operator+(Polynomial p, const Polynomial& q)
  {
    for(const auto& t : q.terms)
      p.terms[t.first] += t.second;
    return p;
  }

  friend Polynomial operator*(const Polynomial& p, const Polynomial& q)
  {
    Polynomial product;
    for(const auto& s : p.terms)
      for(const auto& t : q.terms)
      {
        Exponents a;
        for(int i = 0; i < 4; ++i)
          a[i] = s.first[i] + t.first[i];
        product.terms[a] += s.second * t.second;
      }
    return product;
  }

  friend Polynomial operator*(const Rational& c, const Polynomial& p) { return constant(c) * p; }

  // Over the cell: that of l^a is 6 a! / (3 + |a|)!.
  Rational mean() const
  {
    Rational sum(0);
    for(const auto& t : terms)
    {
      Rational m(6);
      int degree = 3;
      for(int a : t.first)
      {
        degree += a;
        for(int k = 2; k <= a; ++k)
          m *= k;
      }
      for(int k = 2; k <= degree; ++k)
        m /= k;
      sum += m * t.second;
    }
    return sum;
  }
};

static Density_moments_3 exact_moments(const Polynomial& rho)
{
  Density_moments_3 m;
  for(int i = 0; i < 4; ++i)
    m.first[i] = CGAL::to_double((rho * Polynomial::coordinate(i)).mean());
  for(int e = 0; e < 6; ++e)
    m.mixed[e] = CGAL::to_double((rho * Polynomial::coordinate(Density_moments_3::edges[e][0])
                                      * Polynomial::coordinate(Density_moments_3::edges[e][1])).mean());
  return m;
}

struct Exact_cell
{
  std::array<Exact_vector, 4> x;
  std::array<Rational, 4> height;           // of the lifted points
  std::array<Polynomial, 3> position;

  explicit Exact_cell(const Sites& s)
  {
    for(int i = 0; i < 4; ++i)
    {
      x[i] = Exact_vector(s[i].x, s[i].y, s[i].z);
      height[i] = x[i].squared_length() - Rational(s[i].weight);
      for(int k = 0; k < 3; ++k)
        position[k] = position[k] + x[i][k] * Polynomial::coordinate(i);
    }
  }

  // From the definitions: the integral of rho (f_I - x^2), and (3.1), where the derivative of f_I for x_i is
  // l_i (2 x_i - grad f_I).
  Cell_energy energy(const Polynomial& rho) const
  {
    const Exact_vector a = x[1] - x[0], b = x[2] - x[0], c = x[3] - x[0];
    const Rational det = CGAL::determinant(a, b, c), volume = det / 6;
    const Exact_vector slope = ((height[1] - height[0]) * CGAL::cross_product(b, c)
                                + (height[2] - height[0]) * CGAL::cross_product(c, a)
                                + (height[3] - height[0]) * CGAL::cross_product(a, b)) / det;
    Polynomial error;
    for(int i = 0; i < 4; ++i)
      error = error + height[i] * Polynomial::coordinate(i);
    for(int k = 0; k < 3; ++k)
      error = error + Rational(-1) * position[k] * position[k];
    Cell_energy e;
    e.energy = CGAL::to_double(volume * (rho * error).mean());
    for(int i = 0; i < 4; ++i)
    {
      const Rational m = volume * (rho * Polynomial::coordinate(i)).mean();
      const Exact_vector g = m * (2 * x[i] - slope);
      e.gradient[i] = { CGAL::to_double(g.x()), CGAL::to_double(g.y()), CGAL::to_double(g.z()), CGAL::to_double(2 * m) };
    }
    return e;
  }
};

static Sites random_integer_cell(std::mt19937& random)
{
  std::uniform_int_distribution<int> coordinate(-9, 9), weight(0, 20);
  Sites s;
  do
  {
    s.clear();
    for(int i = 0; i < 4; ++i)
    {
      const int x = coordinate(random), y = coordinate(random), z = coordinate(random);
      s.push_back({ double(x), double(y), double(z), double(weight(random)) });
    }
  }
  while(determinant(s) <= 0);
  return s;
}

// The moments that a rule gives, and energy and gradient from them, are the exact ones.
static void compare_with_exact(const Sites& s, const Density_moments_3& m, const Polynomial& rho, const char* what)
{
  const Density_moments_3 exact = exact_moments(rho);
  const double mean = CGAL::to_double(rho.mean());
  near(difference(m, exact), 0, 1e-14 * mean, what, ", moments");
  const Cell_energy e = energy(s, m), wanted = Exact_cell(s).energy(rho);
  const double size = 30, scale = determinant(s) * mean;
  near(e.energy, wanted.energy, 1e-15 * scale * size * size, what, ", energy");
  // The edges squared times the other edges, instead of the volume.
  near(difference(e, wanted), 0, 1e-15 * mean * std::pow(size, 4), what, ", gradient");
}

// Theorems 4.1 and 4.2: the formulas for linear densities are the integrals, on weighted vertices as well.
static void linear_densities(std::mt19937& random)
{
  std::uniform_int_distribution<int> value(1, 9);
  for(int n = 0; n < 50; ++n)
  {
    std::array<double, 4> rho;
    Polynomial polynomial;
    for(int i = 0; i < 4; ++i)
    {
      rho[i] = value(random);
      polynomial = polynomial + Rational(rho[i]) * Polynomial::coordinate(i);
    }
    compare_with_exact(random_integer_cell(random), linear_density_moments(rho), polynomial, "linear density");
  }
}

// The moments of quadratic densities are exact; and since these times two coordinates are of degree 4, those by the
// fifteen points are as well.
static void quadratic_densities(std::mt19937& random)
{
  std::uniform_int_distribution<int> value(-3, 3);
  const auto vector_of_integers = [&] { const int x = value(random), y = value(random); return Vector(x, y, value(random)); };
  for(int n = 0; n < 50; ++n)
  {
    const Sites s = random_integer_cell(random);
    Eigen::Matrix3d factor;
    factor << vector_of_integers(), vector_of_integers(), vector_of_integers();
    const Vector center = vector_of_integers(), slope = vector_of_integers();
    // Positive on the whole box.
    const Quadratic_polynomial_3 q = quadratic(center, 300, slope, factor * factor.transpose());
    std::array<Polynomial, 3> d = Exact_cell(s).position;
    for(int k = 0; k < 3; ++k)
      d[k] = d[k] + Polynomial::constant(-center[k]);
    Polynomial rho = Polynomial::constant(q.constant);
    for(int k = 0; k < 3; ++k)
      rho = rho + Rational(q.linear[k]) * d[k] + Rational(q.quadratic[k]) * d[k] * d[k]
                + Rational(q.quadratic[3 + k]) * d[(k + 1) % 3] * d[(k + 2) % 3];
    Quadratic_density_quadrature_3 exact(q);
    compare_with_exact(s, moments(exact, s), rho, "quadratic density");
    const auto rule = make_rule(FIFTEEN_POINTS, [&q](const Vector& x) { return q(site(x)); });
    compare_with_exact(s, moments(*rule, s), rho, "quadratic density by fifteen points");
  }
}

static std::vector<Exponents> exponents(int degree)
{
  std::vector<Exponents> all;
  for(int a = 0; a <= degree; ++a)
    for(int b = 0; a + b <= degree; ++b)
      for(int c = 0; a + b + c <= degree; ++c)
        all.push_back({{ a, b, c, degree - a - b - c }});
  return all;
}

static double power(const std::array<double, 4>& l, const Exponents& a)
{
  return std::pow(l[0], a[0]) * std::pow(l[1], a[1]) * std::pow(l[2], a[2]) * std::pow(l[3], a[3]);
}

// A rule has positive weights and inner points, so that moments are positive, and the degree that it is said to have.
static void points_of_rules()
{
  const auto check_rule = [](const Point_rule_quadrature_3::Rule& rule, std::size_t size)
  {
    check::that(rule.points.size() == size, rule.points.size(), " points, not ", size);
    double weights = 0;
    for(const auto& p : rule.points)
    {
      weights += p.weight;
      const auto& l = p.coordinates;
      check::that(p.weight > 0 && *std::min_element(l.begin(), l.end()) > 0, size, " points, one with a bad weight or place");
      near(l[0] + l[1] + l[2] + l[3], 1, 1e-15, size, " points, sum of coordinates");
    }
    near(weights, 1, 1e-15, size, " points, sum of weights");
    for(int n = 0; n <= rule.degree + 1; ++n)
    {
      check::Largest error;
      for(const Exponents& a : exponents(n))
      {
        double sum = 0;
        for(const auto& p : rule.points)
          sum += p.weight * power(p.coordinates, a);
        error.add(std::abs(sum - CGAL::to_double(Polynomial{ { { a, Rational(1) } } }.mean())));
      }
      check::that(n <= rule.degree ? error < 1e-16 * 4 : error > 1e-5, size, " points, error ", error, " at degree ", n);
    }
  };
  check_rule(Point_rule_quadrature_3::four_points(), 4);
  check_rule(Point_rule_quadrature_3::fifteen_points(), 15);
}

// Moments are exact up to the degree of the rule less the two of the coordinates that they multiply by.
static void degrees_of_moments()
{
  const Sites corner = { { 0, 0, 0, 0 }, { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 } };
  const std::array<int, 4> degrees = {{ 1, 0, 3, 5 }};
  for(Rule r : all_rules)
    for(int n = 0; n <= degrees[r] + 1; ++n)
    {
      check::Largest error;
      for(const Exponents& a : exponents(n))
      {
        const auto rule = make_rule(r, [&a](const Vector& x)
                                    { return power({{ 1 - x.sum(), x.x(), x.y(), x.z() }}, a); }, 1e-10, 1);
        error.add(difference(moments(*rule, corner), exact_moments({ { { a, Rational(1) } } })));
      }
      check::that(n <= degrees[r] ? error < 1e-15 : error > 1e-7, names[r], ", error of moments ", error,
                  " at degree ", n);
    }
}

// On cells that shrink, errors of the first moments and of the energy fall with the powers that the degrees tell.
static void orders()
{
  const Sites cell = { { 0.1, 0, 0.2, 0 }, { 1.1, 0.15, 0, 0 }, { 0.5, 0.5, 0.1, 0 }, { 0.2, 0.25, 0.5, 0 } };
  // The four points integrate products of two coordinates, but not with a linear density; the seventh degree of one
  // region of the cubature is that of its products, too.
  const std::array<double, 4> order_of_moments = {{ 2, 2, 5, 7 }}, order_of_energy = {{ 2, 1, 4, 6 }};
  const Field steep = [](const Vector& x) { return std::pow(smooth(x), 3); };
  const Field rational = [](const Vector& x) { return 1 / (1 + x.squaredNorm()); };
  for(const auto& density : { std::make_pair("exp", steep), std::make_pair("1/(1+x^2)", rational) })
    for(Rule r : all_rules)
    {
      const auto rule = make_rule(r, density.second, 1e-14, 1), reference = make_rule(CUBATURE, density.second, 1e-13);
      std::vector<std::array<double, 2> > errors;
      for(double h = r < FIFTEEN_POINTS ? 0.125 : 0.25; errors.size() < 3; h /= 2)
      {
        Sites s = cell;
        for(Site& p : s)
          p = site(Vector(0.4, 0.3, 0.3) + h * (vector(p) - Vector(0.4, 0.3, 0.3)));
        const Density_moments_3 m = moments(*rule, s), exact = moments(*reference, s);
        check::Largest first;
        for(int i = 0; i < 4; ++i)
          first.add(std::abs(m.first[i] / exact.first[i] - 1));
        errors.push_back({{ first, std::abs(energy(s, m).energy / energy(s, exact).energy - 1) }});
      }
      const auto order = [&errors](int what) { return std::log2(errors[1][what] / errors[2][what]); };
      std::cout << density.first << ", " << names[r] << ": error of moments " << errors[2][0] << ", order " << order(0)
                << ", of the energy " << errors[2][1] << ", order " << order(1) << std::endl;
      near(order(0), order_of_moments[r], 0.4, names[r], ", order of moments");
      near(order(1), order_of_energy[r], 0.6, names[r], ", order of the energy");
    }
}

// Of the exponential function: the sum of h_k/(k + n)!, h_k being the complete symmetric polynomials. Shifted, so that
// nothing cancels.
static double divided_difference_of_exp(std::vector<double> u)
{
  const double shift = *std::min_element(u.begin(), u.end());
  std::vector<double> h(100, 0);
  h[0] = 1;
  for(double x : u)
    for(std::size_t k = 1; k < h.size(); ++k)
      h[k] += (x - shift) * h[k - 1];
  double sum = 0, factorial = 1;
  for(std::size_t n = 2; n < u.size(); ++n)
    factorial *= double(n);
  for(std::size_t k = 0; k < h.size(); factorial *= double(++k + u.size() - 1))
    sum += h[k] / factorial;
  return sum * std::exp(shift);
}

// By Hermite and Genocchi, the mean of l_i l_j exp is six times the divided difference at the vertices, i and j.
static Density_moments_3 moments_of_exp(const Vector& a, const Sites& s)
{
  std::vector<double> u;
  for(int i = 0; i < 4; ++i)
    u.push_back(a.dot(vector(s[i])));
  const auto with = [&u](int i, int j = -1)
  {
    std::vector<double> nodes = u;
    nodes.push_back(u[i]);
    if(j >= 0)
      nodes.push_back(u[j]);
    return 6 * divided_difference_of_exp(nodes);
  };
  Density_moments_3 m;
  for(int i = 0; i < 4; ++i)
    m.first[i] = with(i);
  for(int e = 0; e < 6; ++e)
    m.mixed[e] = with(Density_moments_3::edges[e][0], Density_moments_3::edges[e][1]);
  return m;
}

// The error is below the tolerance, on densities that vary by some powers of ten, and not for the price of a better one.
static void cubature_of_exp(std::mt19937& random)
{
  std::array<check::Largest, 3> worst;
  std::vector<std::size_t> questions(3, 0);
  const std::array<double, 3> tolerances = {{ 1e-4, 1e-7, 1e-10 }};
  for(int n = 0; n < 60; ++n)
  {
    const Sites s = random_cell(random);
    const Vector a = random_vector(random, -12, 12);
    const Density_moments_3 exact = moments_of_exp(a, s);
    for(std::size_t t = 0; t < 3; ++t)
    {
      const auto rule = make_rule(CUBATURE, [&](const Vector& x)
                                  { ++questions[t]; return std::exp(a.dot(x)); }, tolerances[t]);
      const double error = difference(moments(*rule, s), exact) / mean_density(exact);
      check::that(error <= tolerances[t], "cubature of exp, error ", error, " for a tolerance of ", tolerances[t]);
      worst[t].add(error);
    }
  }
  std::cout << "cubature of exp: largest errors " << worst[0] << ", " << worst[1] << ", " << worst[2] << ", "
            << questions[0] / 60 << ", " << questions[1] / 60 << ", " << questions[2] / 60
            << " questions a cell" << std::endl;
  check::that(questions[0] < questions[1] && questions[1] < questions[2], "the tolerance has no effect on the effort");
}

// A jump cannot be integrated to any tolerance: the cubature gives up when it is to, with a result that is fair.
static void cubature_of_jump()
{
  const Sites corner = { { 0, 0, 0, 0 }, { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 } };
  for(int most_regions : { 20, 200, 2000 })
  {
    int questions = 0;
    const auto rule = make_rule(CUBATURE, [&questions](const Vector& x) { ++questions; return x.x() < 0.31 ? 1. : 11.; },
                                1e-12, most_regions);
    const double exact = 1 + 10 * std::pow(0.69, 3), error = std::abs(mean_density(moments(*rule, corner)) / exact - 1);
    std::cout << "cubature of a jump: error " << error << " with " << most_regions << " regions" << std::endl;
    // 35 points a region, 30 to choose where to divide it.
    check::that(questions == 35 + 100 * (most_regions - 1), questions, " questions for ", most_regions, " regions");
    check::that(error < 2 / std::pow(most_regions, 2. / 3), "cubature of a jump, error ", error);
  }
  const auto rule = make_rule(CUBATURE, [](const Vector& x) { return x.x() < 0.31 ? 1. : 11.; }, 1e-12, 100000);
  CGAL::Real_timer timer;
  timer.start();
  moments(*rule, corner);
  check::that(timer.time() < 5, "the time is not proportional to the number of regions: ", timer.time(), " s");
}

// The order of the vertices changes no more than the tolerance allows.
static void cubature_of_permuted_cells(std::mt19937& random)
{
  const double tolerance = 1e-8;
  for(const Field& f : { Field(bell), Field(waves) })
  {
    const Sites s = random_cell(random);
    const auto rule = make_rule(CUBATURE, f, tolerance);
    const Density_moments_3 m = moments(*rule, s);
    for(Cell_vertices v = first_four; std::next_permutation(v.begin(), v.end()); )
    {
      const Density_moments_3 permuted = moments(*rule, s, v);
      for(int i = 0; i < 4; ++i)
        near(permuted.first[i], m.first[v[i]], 2 * tolerance * mean_density(m), "cubature of a permuted cell");
    }
  }
}

// Cells that have not moved are not integrated again, others are, and what a density that throws has left is not believed.
static void cache(std::mt19937& random)
{
  Sites s = random_cell(random);
  s.push_back(site(random_vector(random, 1, 2)));
  const std::array<Cell_vertices, 2> v = {{ {{ 0, 1, 2, 3 }}, {{ 1, 2, 3, 4 }} }};
  bool is_broken = false;
  int questions = 0;
  std::size_t answers = 0;
  const Field density = [&](const Vector& x)
  {
    ++answers;
    if(is_broken && ++questions == 3)
      throw std::runtime_error("the density fails");
    return smooth(x);
  };
  Density_moment_cache_3 cache(make_rule(FIFTEEN_POINTS, density));
  const auto rule = make_rule(FIFTEEN_POINTS, smooth);
  std::size_t wanted = 0;
  const auto ask = [&](int cell, const Cell_vertices& vertices, bool is_new, const char* what)
  {
    const Density_moments_3 m = cache.moments(cell, vertices.data(), s.data());
    wanted += is_new ? 15 : 0;
    check::that(difference(m, moments(*rule, s, vertices)) == 0, "cache, ", what, ": not the moments");
    check::that(answers == wanted, "cache, ", what, ": the density is asked ", answers, " times, not ", wanted);
  };
  for(bool is_new : { true, false, false })
    for(int cell : { 0, 1000 })
      ask(cell, v[cell > 0], is_new, "cells at rest");
  s[0].y += 0.01;
  ask(0, v[0], true, "moved");
  ask(1000, v[1], false, "neighbor of the moved cell");
  s[3].weight += 0.1;
  ask(0, v[0], false, "another weight");
  ask(0, v[1], true, "other vertices");
  ask(0, {{ 2, 1, 4, 3 }}, true, "permuted vertices");

  const Sites before = s;
  s[2].x += 0.01;
  for(int cell : { 1000, 5 })     // once known and new
  {
    is_broken = true;
    questions = 0;
    bool is_thrown = false;
    try { cache.moments(cell, v[1].data(), s.data()); }
    catch(const std::runtime_error&) { is_thrown = true; }
    check::that(is_thrown, "the density does not throw");
    is_broken = false;
    wanted = answers;
    ask(cell, v[1], true, "after an exception");
    ask(cell, v[1], false, "after an exception, again");
  }
  s = before;
  ask(1000, v[1], true, "moved back");
}

// Energy and gradient by all rules move, turn and scale with the cell and its density.
static void invariance(std::mt19937& random)
{
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(1.1, Vector(1, 2, 3).normalized()).toRotationMatrix();
  struct Motion { const char* name; Eigen::Matrix3d turn; double scale; Vector shift; double tolerance; };
  const std::array<Motion, 3> motions = {{ { "translation", Eigen::Matrix3d::Identity(), 1, { 1e5, -1e5, 2e5 }, 1e-9 },
                                           { "rotation", rotation, 1, { 0, 0, 0 }, 1e-13 },
                                           { "scaling", Eigen::Matrix3d::Identity(), 1e-3, { 0, 0, 0 }, 1e-13 } }};
  const Vector center(0.2, 0.4, 0.1), slope(0.1, -0.2, 0.2);
  const Eigen::Matrix3d q = Vector(1, 2, 3).asDiagonal();
  for(const Motion& m : motions)
    for(int n = 0; n < 10; ++n)
    {
      const Sites s = random_cell(random);
      Sites moved;
      for(const Site& p : s)
        moved.push_back(site(m.scale * m.turn * vector(p) + m.shift, m.scale * m.scale * p.weight));
      const Field moved_bell = [&m](const Vector& x) { return bell(m.turn.transpose() * (x - m.shift) / m.scale); };
      const auto compare = [&](Density_quadrature_3& rule, Density_quadrature_3& moved_rule, const char* name,
                               double tolerance)
      {
        const Density_moments_3 first = moments(rule, s);
        Cell_energy e = energy(s, first);
        const Cell_energy f = energy(moved, moments(moved_rule, moved));
        const double scale = mean_density(first);
        near(f.energy / std::pow(m.scale, 5), e.energy, tolerance * scale, m.name, ", energy, ", name);
        for(Site_gradient& g : e.gradient)
        {
          const Vector turned = std::pow(m.scale, 4) * m.turn * vector(g);
          g = { turned.x(), turned.y(), turned.z(), std::pow(m.scale, 3) * g.diagonal };
        }
        check::Largest error;
        for(int i = 0; i < 4; ++i)
        {
          error.add((vector(f.gradient[i]) - vector(e.gradient[i])).norm() / std::pow(m.scale, 4));
          near(f.gradient[i].diagonal, e.gradient[i].diagonal, tolerance * scale * std::pow(m.scale, 3), m.name,
               ", D, ", name);
        }
        check::that(error <= 10 * tolerance * scale, m.name, ", error of the gradient, ", name, ": ", error);
      };
      for(Rule r : all_rules)
        compare(*make_rule(r, bell), *make_rule(r, moved_bell), names[r],
                r == CUBATURE ? (std::max)(m.tolerance, 2e-10) : m.tolerance);
      const Vector moved_center = m.scale * m.turn * center + m.shift;
      Quadratic_density_quadrature_3 exact(quadratic(center, 1, slope, q)), moved_exact(
        quadratic(moved_center, 1, m.turn * slope / m.scale, m.turn * q * m.turn.transpose() / (m.scale * m.scale)));
      compare(exact, moved_exact, "quadratic", m.tolerance);
    }
}

int main()
{
  const unsigned int seed = 17;
  std::cout << "seed " << seed << std::endl;
  std::mt19937 random(seed);
  linear_densities(random);
  quadratic_densities(random);
  points_of_rules();
  degrees_of_moments();
  orders();
  cubature_of_exp(random);
  cubature_of_jump();
  cubature_of_permuted_cells(random);
  invariance(random);
  cache(random);
  return check::result();
}
