// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The energy of densities: its gradient, the theorems of the paper, how it falls when vertices move, and odt_energy_3().

#include "check.h"
#include "density_rules.h"
#include "function_density_3.h"
#include "gradient_of.h"
#include "random_cube_triangulation.h"

#include <CGAL/Global_odt_mesh_3/internal/density/Make_density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Polynomial_density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Quadratic_density_3.h>
#include <CGAL/odt_energy_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Regular_triangulation_3.h>

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
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

template <class Numbers>
static std::vector<Cell_vertices> cells(const Indexed_triangulation_3& t, const Numbers& numbers)
{
  std::vector<Cell_vertices> v;
  for(int c : numbers)
    v.push_back(t.cell(c));
  return v;
}

static std::vector<Cell_vertices> cells(const Indexed_triangulation_3& t)
{
  std::vector<int> numbers;
  for(int c = 0; c < t.number_of_cell_slots(); ++c)
    if(t.is_alive(c))
      numbers.push_back(c);
  return cells(t, numbers);
}

static double true_energy(const Sites& s, const std::vector<Cell_vertices>& v, const Field& f, double tolerance = 1e-10)
{
  Function_density_3 density([&f](const Site& x) { return f(vector(x)); });
  return reference_energy(s, v, density, { tolerance, 5000 });
}

// By differences of the fourth order, as the cells around move along.
static Vector true_gradient(Moving_triangulation_3& mesh, int v, double step, const Field& f)
{
  std::vector<Half_facet> slots;
  mesh.topology.star(v, slots);
  std::vector<int> numbers;
  for(Half_facet s : slots)
    numbers.push_back(s.cell());
  const std::vector<Cell_vertices> star = cells(mesh.topology, numbers);
  const Site s = mesh.sites[v];
  Vector g;
  for(int k = 0; k < 3; ++k)
  {
    const auto at = [&](double t)
    {
      mesh.sites[v] = site(vector(s) + t * Vector::Unit(k), s.weight);
      return true_energy(mesh.sites, star, f, 1e-12);
    };
    g[k] = (8 * (at(step) - at(-step)) - (at(2 * step) - at(-2 * step))) / (12 * step);
  }
  mesh.sites[v] = s;
  return g;
}

// The error of the gradients of some vertices, relative to their size.
static double error_of_gradient(Moving_triangulation_3& mesh, Density_quadrature_3& rule, const Field& f)
{
  std::vector<double> length;
  mesh.mean_edge_lengths(length);
  mesh.set_quadrature(&rule);
  mesh.is_regular();
  const std::vector<Site_gradient> gradient = gradient_of(mesh);
  double error = 0, size = 0;
  const int n = mesh.number_of_movable_vertices;
  for(int v = 0; v < n; v += 1 + n / 25)
  {
    const Vector g = true_gradient(mesh, v, 0.01 * length[v], f);
    error += (vector(gradient[v]) - g).squaredNorm();
    size += g.squaredNorm();
  }
  mesh.set_quadrature(nullptr);
  return std::sqrt(error / size);
}

// (4.6) with the moments of any rule approaches the derivative of the true energy, with the order of the rule; with exact
// moments it is the derivative.
static void gradients(bool weighted, std::mt19937& random)
{
  std::array<std::vector<double>, 4> errors;
  for(int level = 0; level < 3; ++level)
  {
    Moving_triangulation_3 mesh = random_cube(2 << level, 30 << 3 * level, 0, weighted, random);
    for(Rule r : all_rules)
      errors[r].push_back(error_of_gradient(mesh, *make_rule(r, smooth), smooth));
    const Quadratic_polynomial_3 q = quadratic({ 0.3, 0.4, 0.5 }, 0.1, { 0, 0, 0.1 }, Vector(1, 2, 3).asDiagonal());
    Quadratic_density_quadrature_3 exact(q);
    const double error = error_of_gradient(mesh, exact, [&q](const Vector& x) { return q(site(x)); });
    check::that(error < 1e-8, "error of the gradient for a quadratic density: ", error);
  }
  for(Rule r : all_rules)
    std::cout << "error of the gradient" << (weighted ? ", weighted, " : ", ") << names[r] << ": " << errors[r][0] << ", "
              << errors[r][1] << ", " << errors[r][2] << std::endl;
  const auto falls = [&errors](Rule r, double factor)
  { return errors[r][0] > factor * errors[r][1] && errors[r][1] > factor * errors[r][2]; };
  check::that(falls(LINEAR, 1.5) && falls(FOUR_POINTS, 1.5) && falls(FIFTEEN_POINTS, 8), "the errors of gradients do not fall");
  for(int level = 0; level < 3; ++level)
  {
    check::that(errors[FOUR_POINTS][level] < errors[LINEAR][level]
                && errors[FIFTEEN_POINTS][level] < errors[FOUR_POINTS][level] / 10,
                "the gradients of rules of higher degree are not better");
    check::that(errors[CUBATURE][level] < 1e-8, "error of the gradient by cubature: ", errors[CUBATURE][level]);
  }
}

static const std::vector<std::pair<const char*, Field> > densities
  = { { "constant", constant }, { "exp", smooth }, { "bell", bell }, { "waves", waves } };

// Sites 0, 1 and 2 are a triangle, 3 and 4 the apexes of the two cells on it, or the ends of the edge of three cells.
static const std::vector<Cell_vertices> two_cells = { {{ 3, 0, 1, 2 }}, {{ 4, 0, 2, 1 }} };
static const std::vector<Cell_vertices> three_cells = { {{ 3, 4, 0, 1 }}, {{ 3, 4, 1, 2 }}, {{ 3, 4, 2, 0 }} };

static bool can_be_flipped(const Sites& s)
{
  for(const std::vector<Cell_vertices>& cells : { two_cells, three_cells })
    for(const Cell_vertices& v : cells)
      if(determinant(s, v) < 1e-3)
        return false;
  return true;
}

// Whether the two cells are the regular triangulation.
static bool are_two_regular(const Sites& s) { return Cell_products(s[3], s[0], s[1], s[2]).power(s[3], s[4]) > 0; }

// Of five points, the regular triangulation is that of the lower true energy, for whatever density; it is the same
// where all are on a sphere.
static void five_points(bool weighted, double distance_to_sphere, std::mt19937& random)
{
  int told = 0, flips[2] = { 0, 0 };
  for(int n = 0; n < 100; )
  {
    Sites s;
    for(int i = 0; i < 5; ++i)
    {
      Vector x = random_vector(random, -1, 1);
      if(distance_to_sphere > 0)
        x *= (1 + random_number(random, -1, 1) * distance_to_sphere) / x.norm();
      s.push_back(site(0.3 * x + Vector(0.5, 0.5, 0.5), weighted ? random_number(random, 0, 0.02) : 0));
    }
    if(!can_be_flipped(s))
      continue;
    ++n;
    const bool two = are_two_regular(s);
    ++flips[two];
    for(const auto& density : densities)
    {
      const double regular = true_energy(s, two ? two_cells : three_cells, density.second, 1e-8);
      const double other = true_energy(s, two ? three_cells : two_cells, density.second, 1e-8);
      const double gain = other - regular, noise = 1e-8 * std::abs(other);
      check::that(gain > -noise, "the flip of a regular triangulation lowers the energy from ", regular, " to ", other,
                  ", density ", density.first);
      told += gain > noise;
      if(distance_to_sphere > 0 && !weighted)
        check::that(gain < 20 * distance_to_sphere * other, "a jump of the energy near the sphere: ", gain);
    }
  }
  check::that(flips[0] > 10 && flips[1] > 10, "one kind of configuration is missing");
  check::that(distance_to_sphere > 0 && distance_to_sphere < 1e-8 ? told < 40 : told > 300, told, " energies of 400 differ");
}

// No flip 2-3 or 3-2 of a regular triangulation lowers the true energy.
static void all_flips(const Moving_triangulation_3& mesh, const char* what, std::size_t least_flips)
{
  Indexed_triangulation_3 t = mesh.topology;
  std::array<std::size_t, 2> flips = {};
  const auto compare = [&](const auto& before, const auto& flip)
  {
    const std::vector<Cell_vertices> regular = cells(t, before);
    t.begin_trial();
    const std::vector<Cell_vertices> other = cells(t, flip());
    t.undo_trial();
    if(std::any_of(other.begin(), other.end(), [&mesh](const Cell_vertices& v) { return determinant(mesh.sites, v) <= 0; }))
      return;
    ++flips[other.size() == 2];
    for(const auto& density : densities)
    {
      const double e = true_energy(mesh.sites, regular, density.second, 1e-9);
      const double flipped = true_energy(mesh.sites, other, density.second, 1e-9);
      check::that(flipped > e - 1e-8 * std::abs(e), what, ": flip to ", other.size(), " cells lowers the energy from ",
                  e, " to ", flipped, ", density ", density.first);
    }
  };
  for(int n = 0; n < t.number_of_half_facets(); ++n)
  {
    const Half_facet s(n), across = t.neighbor(s);
    if(s < across)
      compare(std::array<int, 2>{{ s.cell(), across.cell() }}, [&] { return flip_2_3(t, s); });
  }
  for(int c = 0; c < t.number_of_cell_slots(); ++c)
    for(int i = 0; i < 3; ++i)
      for(int j = i + 1; j < 4; ++j)
      {
        const std::optional<Edge_ring_3> ring = ring_of_degree_3(t, c, i, j);
        if(ring && c < (*ring)[1].cell() && c < (*ring)[2].cell())
          compare(std::array<int, 3>{{ c, (*ring)[1].cell(), (*ring)[2].cell() }}, [&] { return flip_3_2(t, *ring); });
      }
  std::cout << what << ": " << flips[0] << " flips 2-3, " << flips[1] << " flips 3-2" << std::endl;
  check::that(flips[0] > least_flips && flips[1] > least_flips / 20, what, ": hardly a flip to test");
}

static Moving_triangulation_3 perturbed_grid(int n, double perturbation, std::mt19937& random)
{
  typedef CGAL::Regular_triangulation_3<CGAL::Exact_predicates_inexact_constructions_kernel> Regular;
  std::vector<Regular::Weighted_point> points;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j)
      for(int k = 0; k <= n; ++k)
      {
        const Vector x = Vector(i, j, k) / n + random_vector(random, -perturbation, perturbation);
        points.emplace_back(Regular::Bare_point(x.x(), x.y(), x.z()), 0);
      }
  return load_triangulation_3(Regular(points.begin(), points.end()));
}

// (2.4), written with the moments: the integrals of rho |x - x_i|^2, i being the vertices of the cell, over 6.
static double other_extension(const Sites& s, const std::vector<Cell_vertices>& cells, const Field& f)
{
  const auto rule = make_rule(CUBATURE, f);
  double sum = 0;
  for(const Cell_vertices& v : cells)
  {
    const Density_moments_3 m = moments(*rule, s, v);
    double integral = 0;
    for(int e = 0; e < 6; ++e)
    {
      const int i = Density_moments_3::edges[e][0], j = Density_moments_3::edges[e][1];
      integral += (m.first[i] + m.first[j] - 4 * m.mixed[e]) * (vector(s[v[i]]) - vector(s[v[j]])).squaredNorm();
    }
    sum += determinant(s, v) / 6 * integral / 6;
  }
  return sum;
}

// Theorem 3.2 and Figure 3: where one of five points crosses the sphere of the others, the energy is continuous but has
// a kink, downward on either side; the other extension jumps unless the density is constant.
static void continuity()
{
  Sites s;
  for(double angle : { 4.4, 2.3, 0.3 })
    s.push_back(site(Vector(std::sqrt(0.99) * std::cos(angle), std::sqrt(0.99) * std::sin(angle), 0.1)));
  s.push_back(site(Vector(0.1, -0.2, 0.9).normalized()));
  const Vector on_sphere = Vector(-0.2, 0.1, -0.8).normalized(), direction = Vector(0.3, 0.2, -0.9).normalized();
  s.push_back(site(on_sphere));
  const auto at = [&](double t, const std::function<double(const std::vector<Cell_vertices>&)>& energy)
  {
    s[4] = site(on_sphere + t * direction);
    check::that(can_be_flipped(s) && are_two_regular(s) == (t > 0), "the triangulation does not flip on the sphere");
    return energy(are_two_regular(s) ? two_cells : three_cells);
  };
  for(const auto& density : densities)
  {
    const Field& f = density.second;
    const auto value = [&](double t) { return at(t, [&](const auto& cells) { return true_energy(s, cells, f); }); };
    const auto other = [&](double t) { return at(t, [&](const auto& cells) { return other_extension(s, cells, f); }); };
    const double scale = value(1e-9);
    for(double step : { 1e-2, 1e-4, 1e-6 })
      check::that(std::abs(value(step) - value(-step)) < 10 * step * scale, "the energy jumps, density ", density.first);
    const double h = 1e-3, after = (value(2 * h) - value(h)) / h, before = (value(-h) - value(-2 * h)) / h;
    const double jump = std::abs(other(1e-9) - other(-1e-9));
    std::cout << "continuity, density " << density.first << ": E " << scale << ", derivatives " << before << " and " << after
              << ", jump of the other extension " << jump << std::endl;
    // Along the same branch, the derivative changes by less than that.
    const double change = std::abs((value(3 * h) - value(2 * h)) / h - after);
    check::that(before - after > 0.05 * scale && before - after > 10 * change,
                "the derivatives do not differ, density ", density.first);
    check::that(&density == &densities[0] ? jump < 1e-7 * scale : jump > 1e-3 * scale, "the other extension jumps by ",
                jump, ", density ", density.first);
  }
  const double difference = at(0.1, [&](const auto& cells)
                               { return other_extension(s, cells, constant) - true_energy(s, cells, constant); });
  near(difference, 0, 1e-12, "the extensions for a constant density");
}

// Energy and gradient that flips keep up to date are those of a fresh pass, and of a quadrature that remembers nothing.
static void random_walk(Rule r, std::mt19937& random)
{
  Moving_triangulation_3 mesh = random_cube(3, 80, 0, true, random);
  const auto rule = make_rule(r, bell, 1e-7);
  Density_moment_cache_3 cache(make_rule(r, bell, 1e-7));
  mesh.set_quadrature(&cache);
  mesh.keep();
  int steps = 0;
  for(int step = 0; step < 15; ++step)
  {
    mesh.move([&](int, Site& s)
    {
      const Vector x = vector(s) + random_vector(random, -0.02, 0.02);
      s = site(x.cwiseMax(0.02).cwiseMin(0.98));
    });
    if(!mesh.evaluate())
    {
      mesh.restore();
      continue;
    }
    ++steps;
    const double energy = mesh.energy();
    const std::vector<Site_gradient> gradient = gradient_of(mesh);
    for(Density_quadrature_3* quadrature : { static_cast<Density_quadrature_3*>(&cache), rule.get() })
    {
      mesh.set_quadrature(quadrature);
      // Whether flips got stuck is not the matter here.
      mesh.is_regular();
      near(mesh.energy(), energy, 1e-11 * energy, names[r], ", energy after flips");
      check::Largest error;
      const std::vector<Site_gradient> fresh = gradient_of(mesh);
      for(std::size_t v = 0; v < gradient.size(); ++v)
        error.add((vector(fresh[v]) - vector(gradient[v])).norm() / fresh[v].diagonal);
      check::that(error < 1e-10, names[r], ", error of the gradient after flips: ", error);
    }
    mesh.set_quadrature(&cache);
    mesh.keep();
  }
  check::that(steps > 10 && mesh.statistics().flips > 300,
              "the walk hardly flipped: ", steps, " steps, ", mesh.statistics().flips, " flips");
}

// The true energy at the minimum that L-BFGS finds for a rule. On the way, it never rises. The gradient falls to a tolerance
// of which the square is above rounding, relative to that at the start.
static double minimize(Moving_triangulation_3& mesh, Rule r, const Field& f, double tolerance = 1e-7)
{
  std::unique_ptr<Density_quadrature_3> rule = make_rule(r, f, 1e-7);
  if(r == LINEAR)
    rule = std::make_unique<Linear_density_quadrature_3>([&f](int, const Site& s) { return f(vector(s)); }, mesh.sites);
  mesh.set_quadrature(rule.get());
  Odt_objective_3 objective(mesh);
  Limited_memory_bfgs minimizer(minimizer_parameters(rule.get()));
  const double first_gradient = objective.gradient().norm(), first = true_energy(mesh.sites, cells(mesh.topology), f, 1e-7);
  double energy = first;
  check::Largest rise;
  int n = 0;
  while(objective.gradient().norm() > tolerance * first_gradient && n < 500
        && minimizer.iterate(objective) == Limited_memory_bfgs::STEP_TAKEN)
  {
    ++n;
    const double before = energy;
    energy = true_energy(mesh.sites, cells(mesh.topology), f, 1e-7);
    rise.add(energy / before - 1);
  }
  std::cout << "L-BFGS, " << names[r] << ": " << n << " iterations, true energy " << first << " -> " << energy
            << ", largest rise " << rise << ", gradient " << objective.gradient().norm() / first_gradient << std::endl;
  check::that(objective.gradient().norm() <= tolerance * first_gradient, "L-BFGS, ", names[r], ", does not converge");
  check::that(r == LINEAR || rise < (r == FOUR_POINTS ? 1e-5 : 1e-9), "L-BFGS, ", names[r],
              ", raises the true energy by ", rise);
  return energy;
}

// Minima for linear densities are none of the true energy: better moments lead lower from there. From the start, which of
// two minima is lower is a matter of chance as well.
static void minimization(std::mt19937& random)
{
  const Field f = [](const Vector& x) { return std::exp(-8 * (x - Vector(0.5, 0.5, 0.5)).squaredNorm()) + 0.05; };
  const Moving_triangulation_3 random_mesh = random_cube(4, 150, 0, false, random);
  Moving_triangulation_3 mesh = random_mesh, four = random_mesh, fifteen = random_mesh;
  const double linear = minimize(mesh, LINEAR, f);
  check::that(minimize(four, FOUR_POINTS, f) < 1.01 * linear, "L-BFGS with four points ends too high");
  check::that(minimize(fifteen, FIFTEEN_POINTS, f) < 1.01 * linear, "L-BFGS with fifteen points ends too high");
  check::that(minimize(mesh, FIFTEEN_POINTS, f, 1e-5) < 0.9999 * linear,
              "the minimum for linear densities cannot be lowered");
}

namespace params = CGAL::parameters;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Labeled_mesh_domain_3<Kernel> Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type Triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> C3t3;

// Random points in the unit ball, some weighted; two subdomains, and cells beside them.
static C3t3 random_ball(std::mt19937& random)
{
  C3t3 c3t3;
  for(int n = 0; n < 300; )
  {
    const Vector x = random_vector(random, -1, 1);
    if(x.norm() > 1)
      continue;
    const bool is_weighted = n % 9 == 0;
    const Triangulation::Weighted_point p(Point_3(x.x(), x.y(), x.z()), is_weighted ? 1e-3 : 0);
    const auto v = c3t3.triangulation().insert(p);
    c3t3.set_dimension(v, is_weighted ? 1 : 3);
    c3t3.set_index(v, 1);
    ++n;
  }
  for(auto c = c3t3.triangulation().finite_cells_begin(); c != c3t3.triangulation().finite_cells_end(); ++c)
    if(c->vertex(0)->point().x() < 0.5)
      c3t3.add_to_complex(c, c->vertex(1)->point().y() < 0 ? 1 : 2);
  return c3t3;
}

struct Size
{
  typedef Kernel::FT FT;
  typedef Kernel::Point_3 Point_3;
  typedef Domain::Index Index;
  FT operator()(const Point_3& p, const int, const Index&) const { return 0.3 + 0.1 * p.x() + 0.05 * p.y() * p.y(); }
};

// The public function: what its parameters mean, and how the rules compare.
static void public_energy(const C3t3& c3t3)
{
  const auto energy = [&c3t3](const auto&... np) { return CGAL::odt_energy_3(c3t3, np...); };
  const double uniform = CGAL::mesh_quality_report_3(c3t3).total().energy;
  near(energy(), uniform, 1e-13 * uniform, "without density");
  near(energy(params::density([](const Point_3&) { return 1.; })), uniform, 1e-12 * uniform, "density 1");
  near(energy(params::density([](const Point_3&) { return 7.; }), params::quadrature(CGAL::Linear_density_rule_3())),
       7 * uniform, 1e-12 * uniform, "density 7");
  near(energy(params::sizing_field = 0.7), uniform * std::pow(0.7, -5), 1e-11 * uniform, "constant size");
  const auto density = [](const Point_3& p) { return std::pow(Size()(p, 3, Domain::Index()), -5.); };
  const double wanted = energy(params::density(density));
  near(energy(params::sizing_field = Size()), wanted, 1e-10 * wanted, "size and density");
  near(energy(params::density(density), params::quadrature(CGAL::Adaptive_cubature_3{ 1e-11, 5000 })), wanted, 1e-7 * wanted,
       "the tolerance without a word");

  const auto error = [&](const auto& rule)
  { return std::abs(energy(params::density(density), params::quadrature(rule)) / wanted - 1); };
  const double linear = error(CGAL::Linear_density_rule_3()), four = error(CGAL::Four_point_rule_3()),
               fifteen = error(CGAL::Fifteen_point_rule_3());
  std::cout << "odt_energy_3(), errors of the rules: " << linear << ", " << four << ", " << fifteen << std::endl;
  check::that(linear < 0.5 && four < linear / 3 && fifteen < four / 10, "the errors of the rules do not fall");

  // Zero at a vertex.
  const auto q = CGAL::Quadratic_density_3<Kernel>::squared_distance(
    c3t3.triangulation().finite_vertices_begin()->point().point());
  const double exact = energy(params::density(q));
  near(energy(params::density(q), params::quadrature(CGAL::Adaptive_cubature_3{ 1e-10, 500 })), exact, 1e-9 * exact,
       "quadratic density, cubature");
  near(energy(params::density(q), params::quadrature(CGAL::Fifteen_point_rule_3())), exact, 1e-13 * exact,
       "quadratic density, 15 points");
  near(energy(params::density([&q](const Point_3& p) { return 1e-30 + q(p); })), exact, 1e-7 * exact,
       "quadratic density as any other");
  check::that(CGAL::odt_energy_3(C3t3()) == 0 && CGAL::odt_energy_3(C3t3(), params::density(density)) == 0,
              "energy of nothing");
}

// Values that make no sense violate a precondition that names the parameter, wherever in a cell they occur.
static void bad_values(const C3t3& c3t3)
{
  const auto refuses = [](const char* name, const std::function<void()>& call)
  {
    bool is_thrown = false;
    try { call(); }
    catch(const CGAL::Precondition_exception& e) { is_thrown = e.message().find(name) != std::string::npos; }
    check::that(is_thrown, "no precondition names the bad ", name);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const CGAL::Failure_behaviour behaviour = CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
  const CGAL::Failure_function handler = CGAL::set_error_handler(
    [](const char*, const char*, const char*, int, const char*) {});
  for(double bad : { 0., -1., nan, std::numeric_limits<double>::infinity() })
  {
    refuses("sizing_field", [&] { CGAL::odt_energy_3(c3t3, params::sizing_field = bad); });
    // The first are vertices.
    for(int good : { 0, 100, 20000 })
      refuses("density", [&]
      {
        int questions = 0;
        CGAL::odt_energy_3(c3t3, params::density([&](const Point_3&) { return questions++ < good ? 1. : bad; }));
      });
  }
  const auto one = params::density([](const Point_3&) { return 1.; });
  const CGAL::Quadratic_density_3<Kernel> negative(0, CGAL::NULL_VECTOR, {{ -1, -1, -1, 0, 0, 0 }});
  refuses("density", [&] { CGAL::odt_energy_3(c3t3, params::density(negative)); });
  refuses("sizing_field and density", [&] { CGAL::odt_energy_3(c3t3, one, params::sizing_field = 1.); });
  for(double bad : { 0., -1., nan })
    refuses("tolerance", [&] { CGAL::odt_energy_3(c3t3, one, params::quadrature(CGAL::Adaptive_cubature_3{ bad })); });
  for(int bad : { 0, -1 })
    refuses("most_regions", [&]
            { CGAL::odt_energy_3(c3t3, one, params::quadrature(CGAL::Adaptive_cubature_3{ 1e-6, bad })); });
  CGAL::set_error_handler(handler);
  CGAL::set_error_behaviour(behaviour);
}

int main()
{
  const unsigned int seed = 17;
  std::cout << "seed " << seed << std::endl;
  std::mt19937 random(seed);
  gradients(false, random);
  gradients(true, random);
  for(double distance_to_sphere : { 0., 1e-2, 1e-10 })
    five_points(false, distance_to_sphere, random);
  five_points(true, 0, random);
  all_flips(random_cube(3, 60, 0, false, random), "random cube", 150);
  all_flips(random_cube(3, 60, 0, true, random), "weighted random cube", 150);
  all_flips(perturbed_grid(4, 1e-5, random), "perturbed grid", 150);
  continuity();
  random_walk(FIFTEEN_POINTS, random);
  random_walk(CUBATURE, random);
  minimization(random);
  const C3t3 ball = random_ball(random);
  public_energy(ball);
  bad_values(ball);
  return check::result();
}
