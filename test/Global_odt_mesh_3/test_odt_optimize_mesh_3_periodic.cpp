// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What is promised of meshes in periodic triangulations, also through make_periodic_3_mesh_3(..., odt()).

#include "periodic_meshes.h"

#include <CGAL/Mesh_domain_with_polyline_features_3.h>
#include <CGAL/Periodic_3_function_wrapper.h>
#include <CGAL/Random.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace periodic;
typedef CGAL::Mesh_domain_with_polyline_features_3<Domain> Domain_with_features;
template <class D>
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<typename CGAL::Periodic_3_mesh_triangulation_3<D>::type, int, int>;
typedef std::function<double(const Point&)> Function;
namespace params = CGAL::parameters;

static const Kernel::Iso_cuboid_3 cube(0, 0, 0, 1, 1, 1);

// One subdomain where the function is negative, or two or three, by its value.
static int label(double value, int subdomains)
{
  if(subdomains == 3)
    return value < -0.5 ? 1 : value < 0.5 ? 2 : 3;
  return value < 0 ? 1 : subdomains == 2 ? 2 : 0;
}

// The domain carries a random generator.
static Domain make_domain(const Function& f, int subdomains, CGAL::Random& random)
{
  return Domain([f, subdomains](const Point& p) { return label(f(p), subdomains); }, cube, params::p_rng = &random);
}

static Criteria criteria(double size)
{
  return Criteria(params::facet_angle = 30, params::facet_size = size, params::facet_distance = size / 5,
                  params::cell_radius_edge_ratio = 2, params::cell_size = size);
}

static C3t3 make_mesh(const Domain& domain, double size)
{
  return CGAL::make_periodic_3_mesh_3<C3t3>(domain, criteria(size), params::no_exude(), params::no_perturb());
}

// Whether the call keeps what it promises, and makes the mesh better.
static void test_domain(const std::string& name, const Domain& domain, unsigned int seed, int rounds = 4)
{
  const std::string run = name + ", seed " + std::to_string(seed);
  C3t3 c3t3 = make_mesh(domain, 0.09);
  const State<C3t3> before(c3t3);
  CGAL::Real_timer timer;
  timer.start();
  const auto code = CGAL::odt_optimize_mesh_3(c3t3, domain, params::random_seed(seed), params::number_of_rounds(rounds));
  const State<C3t3> after(c3t3);
  std::cout << run << ": " << before.vertices.size() << " vertices, angles " << before.smallest_angle << " -> " << after.smallest_angle
            << ", 3r/R " << before.mean_ratio << " -> " << after.mean_ratio << ", " << timer.time() << " s" << std::endl;
  check::that(code == CGAL::CONVERGENCE_REACHED || code == CGAL::ALL_VERTICES_FROZEN, run, ": return code ", code);
  check_contract(before, c3t3, domain, run);
  check::that(after.mean_ratio > before.mean_ratio + 0.01, run, ": mean radius ratio ", after.mean_ratio);
}

static void test_function(const std::string& name, const Function& f, int subdomains, unsigned int seed)
{
  CGAL::Random random(seed);
  test_domain(name + ", " + std::to_string(subdomains) + " subdomains", make_domain(f, subdomains, random), seed);
}

// The cells of random points, which meet by three along lines that no mesh has as features.
static void test_foam(unsigned int seed)
{
  CGAL::Random random(seed);
  std::vector<Point> seeds;
  for(int n = 0; n < 14; ++n)
    seeds.emplace_back(random.get_double(), random.get_double(), random.get_double());
  test_domain("foam", Domain([seeds](const Point& p) { return 1 + nearest(seeds, p); }, cube, params::p_rng = &random), seed, 0);
}

// As the mesh generator leaves points of its lattice that come to lie close to a surface: with dimension 2, but no index of a patch.
static void test_vertices_without_patch(unsigned int seed)
{
  std::vector<Point> points[2];
  for(int n = 0; n < 2; ++n)
  {
    CGAL::Random random(seed);
    const Domain domain = make_domain(gyroid, 2, random);
    C3t3 c3t3 = make_mesh(domain, 0.1);
    int count = 0;
    for(auto v = c3t3.triangulation().vertices_begin(); n == 1 && v != c3t3.triangulation().vertices_end(); ++v)
      if(v->in_dimension() == 2 && ++count % 5 == 0)
        c3t3.set_index(v, domain.index_from_subdomain_index(1));
    const State<C3t3> before(c3t3);
    CGAL::odt_optimize_mesh_3(c3t3, domain, params::number_of_rounds(0));
    const State<C3t3> after(c3t3);
    points[n] = after.points;
    check::that(after.vertices == before.vertices && after.points != before.points, "vertices without a patch, seed ", seed, ": not optimized");
  }
  check::that(points[0] == points[1], "vertices without a patch, seed ", seed, ": another mesh");
}

// In a cube with another corner and another period.
static void test_other_cube()
{
  CGAL::Random random(0);
  const auto f = [](const Point& p) { return label(gyroid(Point(p.x() / 2, p.y() / 2, p.z() / 2)), 2); };
  const Domain domain(f, Kernel::Iso_cuboid_3(-1, -1, -1, 1, 1, 1), params::p_rng = &random);
  C3t3 c3t3 = make_mesh(domain, 0.18);
  const State<C3t3> before(c3t3);
  CGAL::odt_optimize_mesh_3(c3t3, domain);
  const State<C3t3> after(c3t3);
  check::that(c3t3.triangulation().is_valid() && after.vertices == before.vertices, "other cube: not valid");
  check::that(after.smallest_angle > before.smallest_angle && after.mean_ratio > before.mean_ratio, "other cube: quality ", after.smallest_angle);
  check_labels(before, c3t3, domain, "other cube");
}

// Meshes are so coarse here that they have cells with wrong labels.
static void test_calls()
{
  CGAL::Random random(0), same_random(0);
  const Domain domain = make_domain(schwarz_p, 1, random), same_domain = make_domain(schwarz_p, 1, same_random);
  C3t3 plain = make_mesh(domain, 0.15);
  const C3t3 optimized = CGAL::make_periodic_3_mesh_3<C3t3>(same_domain, criteria(0.15), params::odt(params::max_iteration_number = 100),
                                                            params::no_exude(), params::no_perturb());
  const State<C3t3> before(plain), after(optimized);
  check::that(optimized.triangulation().is_valid() && after.points.size() == before.points.size(), "not valid after odt()");
  check::that(after.points != before.points, "odt() did nothing");
  check_labels(before, optimized, domain, "odt()");
  const auto code = CGAL::odt_optimize_periodic_3_mesh_3(plain, domain, params::max_iteration_number = 20, params::convergence = 0,
                                                         params::do_freeze = false);
  check::that(code == CGAL::MAX_ITERATION_NUMBER_REACHED, "return code ", code);
  check::that(plain.triangulation().is_valid() && State<C3t3>(plain).points != before.points, "odt_optimize_periodic_3_mesh_3");
  check_labels(before, plain, domain, "odt_optimize_periodic_3_mesh_3");
}

static void test_limits()
{
  CGAL::Random random(0);
  const Domain domain = make_domain(gyroid, 2, random);
  const C3t3 input = make_mesh(domain, 0.1);
  const State<C3t3> before(input);

  C3t3 canceled = input;
  const State<C3t3> before_cancel(canceled);
  double last = 0;
  int calls = 0;
  const auto stop = [&](double fraction)
  {
    check::that(fraction >= last && fraction <= 1, "the fraction falls from ", last, " to ", fraction);
    last = fraction;
    return ++calls < 150;
  };
  check::that(CGAL::odt_optimize_mesh_3(canceled, domain, params::callback(stop)) == CGAL::TIME_LIMIT_REACHED, "code of a canceled call");
  check::that(calls == 150, "called ", calls, " times");
  check_contract(before_cancel, canceled, domain, "canceled");
  check::that(State<C3t3>(canceled).mean_ratio > before.mean_ratio, "a canceled call is in vain");

  C3t3 limited = input;
  const State<C3t3> before_limit(limited);
  CGAL::Real_timer timer;
  timer.start();
  const auto code = CGAL::odt_optimize_mesh_3(limited, domain, params::time_limit = 2);
  check::that(timer.time() < 4, "time_limit = 2 took ", timer.time(), " s");
  check::that(code == CGAL::TIME_LIMIT_REACHED || timer.time() < 2, "code with a time limit: ", code);
  check_contract(before_limit, limited, domain, "time limit");

  C3t3 with_bound = input;
  check::that(CGAL::odt_optimize_mesh_3(with_bound, domain, params::sliver_bound = 50, params::number_of_rounds(0))
                == CGAL::CANT_IMPROVE_ANYMORE, "a bound of 50 degrees");
  C3t3 with_few_iterations = input;
  check::that(CGAL::odt_optimize_mesh_3(with_few_iterations, domain, params::sliver_bound = 50, params::max_iteration_number = 10)
                == CGAL::MAX_ITERATION_NUMBER_REACHED, "ten iterations, and a bound of 50 degrees");
}

// A higher bound never leads to less, a lower one is met where a higher one is, and the code says whether it is.
static void test_bounds(const Function& f, unsigned int seed)
{
  CGAL::Random random(seed);
  const Domain domain = make_domain(f, 2, random);
  const C3t3 input = make_mesh(domain, 0.11);
  std::vector<std::pair<double, double> > reached;
  for(double bound : { 10., 20., 30., 40. })
  {
    const std::string run = "bound " + std::to_string(bound) + ", seed " + std::to_string(seed);
    C3t3 c3t3 = input;
    const auto code = CGAL::odt_optimize_mesh_3(c3t3, domain, params::sliver_bound = bound, params::number_of_rounds(0), params::random_seed(seed));
    const double angle = State<C3t3>(c3t3).smallest_angle;
    std::cout << run << ": " << angle << " degrees" << std::endl;
    for(const auto& r : reached)
      check::that(angle < r.first ? r.second <= angle : r.second >= r.first, run, ": ", angle, ", and with ", r.first, " ", r.second);
    check::that(angle < bound ? code == CGAL::CANT_IMPROVE_ANYMORE : code == CGAL::CONVERGENCE_REACHED || code == CGAL::ALL_VERTICES_FROZEN,
                run, ": code ", code);
    reached.emplace_back(bound, angle);
  }
}

// Wherever the user ends a call, it does not leave the slivers that there were.
static void test_ended(unsigned int seed)
{
  CGAL::Random random(seed);
  const Domain domain = make_domain(gyroid, 2, random);
  const C3t3 input = make_mesh(domain, 0.11);
  const State<C3t3> before(input);
  for(int last : { 50, 200, 600 })
  {
    C3t3 c3t3 = input;
    int calls = 0;
    const auto stop = [&](double fraction)
    {
      check::that(fraction >= 0 && fraction <= 1, "a fraction of ", fraction);
      return ++calls < last;
    };
    const auto code = CGAL::odt_optimize_mesh_3(c3t3, domain, params::callback(stop));
    const State<C3t3> after(c3t3);
    std::cout << "ended at call " << last << ": " << before.slivers << " -> " << after.slivers << " slivers" << std::endl;
    check::that(code == CGAL::TIME_LIMIT_REACHED || calls < last, "ended at call ", last, ": code ", code);
    check::that(4 * after.slivers < before.slivers, "ended at call ", last, ": ", before.slivers, " -> ", after.slivers, " slivers");
  }
}

// Where there is no time to rebuild a mesh, nothing is begun.
static void test_short_limit()
{
  CGAL::Random random(0);
  long questions = 0;
  const Domain domain = make_domain([&questions](const Point& p) { ++questions; return gyroid(p); }, 2, random);
  C3t3 c3t3 = make_mesh(domain, 0.1);
  const State<C3t3> before(c3t3);
  questions = 0;
  check::that(CGAL::odt_optimize_mesh_3(c3t3, domain, params::time_limit = 1e-3) == CGAL::TIME_LIMIT_REACHED, "code of a short call");
  check::that(questions == 0 && State<C3t3>(c3t3) == before, "a short call asks the domain ", questions, " times");
}

// Where three subdomains meet, the mesh generator may take the patch of two others. Here it has for all facets between two.
static void test_mistaken_patch(unsigned int seed)
{
  CGAL::Random random(seed);
  const Domain domain = make_domain(double_diamond, 3, random);
  C3t3 c3t3 = make_mesh(domain, 0.12);
  for(auto c = c3t3.triangulation().cells_begin(); c != c3t3.triangulation().cells_end(); ++c)
    for(int i = 0; i < 4; ++i)
      if(c3t3.is_in_complex(c, i) && c->surface_patch_index(i) == std::make_pair(1, 2))
        c->set_surface_patch_index(i, std::make_pair(2, 3));
  const State<C3t3> before(c3t3);
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::number_of_rounds(0));
  check::that(State<C3t3>(c3t3).points != before.points, "mistaken patch: not optimized");
  check_labels(before, c3t3, domain, "mistaken patch");
}

// Wherever the domain throws, the mesh is as it was.
static void test_exceptions()
{
  long countdown = -1;
  CGAL::Random random(0);
  const auto f = [&countdown](const Point& p)
  {
    if(countdown >= 0 && countdown-- == 0)
      throw std::runtime_error("thrown by the domain");
    return gyroid(p);
  };
  const Domain domain = make_domain(f, 2, random);
  C3t3 c3t3 = make_mesh(domain, 0.1);
  const State<C3t3> before(c3t3);
  for(long n : { 0L, 1000L, 20000L, 60000L, 120000L })
  {
    countdown = n;
    bool has_thrown = false;
    try
    {
      CGAL::odt_optimize_mesh_3(c3t3, domain, params::number_of_rounds(1));
    }
    catch(const std::runtime_error&)
    {
      has_thrown = true;
    }
    countdown = -1;
    if(!has_thrown)
      break;
    check::that(State<C3t3>(c3t3) == before, "not as it was after the ", n, "th call");
    check::that(n > 0 || has_thrown, "nothing thrown");
  }
  check::that(c3t3.triangulation().is_valid(), "not valid after exceptions");
}

// A ball with a circle on it, which goes through a side of the cube, and a corner.
static void test_features()
{
  const auto ball = [](const Point& p) { return CGAL::squared_distance(p, Point(0.5, 0.5, 0)) - 0.09; };
  typedef CGAL::Periodic_3_function_wrapper<Function, Kernel> Periodic_function;
  const auto periodic = [ball](const Point& p) { return (std::min)(ball(p), ball(Point(p.x(), p.y(), p.z() - 1))); };
  Domain_with_features domain = Domain_with_features::create_implicit_mesh_domain(Periodic_function(Function(periodic), cube), cube);
  std::vector<std::vector<Point> > circle(1);
  for(int n = 0; n < 90; ++n)
    circle.front().push_back(Point(0.5 + 0.3 * std::cos(n * turn / 90), 0.5 + 0.3 * std::sin(n * turn / 90), 0));
  circle.front().push_back(circle.front().front());
  domain.add_features(circle.begin(), circle.end());
  domain.add_corner(Point(0.5, 0.5, 0.3));
  typedef Complex<Domain_with_features> Mesh;
  const CGAL::Mesh_criteria_3<Mesh::Triangulation> criteria(
    params::edge_size = 0.06, params::facet_angle = 30, params::facet_size = 0.08, params::facet_distance = 0.01,
    params::cell_radius_edge_ratio = 2, params::cell_size = 0.08);
  Mesh c3t3 = CGAL::make_periodic_3_mesh_3<Mesh>(domain, criteria, params::features(), params::no_exude(), params::no_perturb());
  const State<Mesh> before(c3t3);
  CGAL::odt_optimize_mesh_3(c3t3, domain);
  const State<Mesh> after(c3t3);
  std::cout << "features: " << before.vertices.size() << " vertices, " << before.edges << " edges, angles " << before.smallest_angle
            << " -> " << after.smallest_angle << ", 3r/R " << before.mean_ratio << " -> " << after.mean_ratio << std::endl;
  check::that(before.edges > 20 && before.corners > 0, "no features");
  check_contract(before, c3t3, domain, "features");
  check::that(after.mean_ratio > before.mean_ratio, "features: quality");
}

// CGAL's example of features: a cone whose halves meet in a circle. If the function is not periodic, facets come into the complex that
// separate nothing.
static void test_cone(bool is_periodic)
{
  typedef CGAL::Periodic_3_function_wrapper<Function, Kernel> Periodic_function;
  const Function cone = [](const Point& p)
  {
    return CGAL::square(p.x() - 0.51) + CGAL::square(p.y() - 0.51) > 0.9 * CGAL::square(p.z() - 0.5) ? 1. : -1.;
  };
  CGAL::Random random(0);
  Domain_with_features domain = Domain_with_features::create_implicit_mesh_domain(is_periodic ? Function(Periodic_function(cone, cube)) : cone,
                                                                                  cube, params::p_rng = &random);
  std::vector<std::vector<Point> > circle(1);
  const double radius = 0.5 * std::sqrt(0.9);
  for(int n = 0; n <= 360; ++n)
    circle.front().push_back(Point(0.51 + radius * std::sin(n % 360 * turn / 360), 0.51 + radius * std::cos(n % 360 * turn / 360), 0));
  domain.add_features(circle.begin(), circle.end());
  domain.add_corner(Point(0.51, 0.51, 0.5));
  typedef Complex<Domain_with_features> Mesh;
  const CGAL::Mesh_criteria_3<Mesh::Triangulation> criteria(params::edge_size = 0.05, params::facet_angle = 0.05, params::facet_size = 0.05,
                                                            params::cell_radius_edge_ratio = 2, params::cell_size = 0.5);
  Mesh c3t3 = CGAL::make_periodic_3_mesh_3<Mesh>(domain, criteria, params::features(), params::no_exude(), params::no_perturb());
  const State<Mesh> before(c3t3);
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::number_of_rounds(0));
  const State<Mesh> after(c3t3);
  std::cout << "cone: " << before.disagreeing.size() << " facets separate nothing, angles " << before.smallest_angle << " -> "
            << after.smallest_angle << ", slivers " << before.slivers << " -> " << after.slivers << std::endl;
  check::that(is_periodic == before.disagreeing.empty(), "cone: facets that separate nothing");
  check::that(after.disagreeing == before.disagreeing, "cone: facets that separate nothing have gone");
  check_contract(before, c3t3, domain, "cone");
  // Vertices of facets that separate nothing stay, and slivers between them.
  check::that(2 * after.slivers < before.slivers, "cone: slivers ", after.slivers);
  check::that(!is_periodic || after.smallest_angle > 12, "cone: smallest angle ", after.smallest_angle);
}

int main()
{
  for(unsigned int seed = 0; seed < 3; ++seed)
  {
    // So coarse that a sliver may be left at the surface.
    test_function("Schwarz P", schwarz_p, 1, seed);
    test_function("gyroid", gyroid, 2, seed);
    test_function("double diamond", double_diamond, seed == 0 ? 3 : 2, seed);
    if(seed < 2)
      test_foam(seed);
    test_vertices_without_patch(seed);
  }
  for(unsigned int seed = 0; seed < 2; ++seed)
  {
    test_bounds(gyroid, seed);
    test_bounds(schwarz_p, seed);
    test_ended(seed);
    test_mistaken_patch(seed);
  }
  test_cone(true);
  test_cone(false);
  test_short_limit();
  test_other_cube();
  test_calls();
  test_limits();
  test_exceptions();
  test_features();
  return check::result();
}
