// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Bad parameters are refused by a precondition that names them, also in programs that are compiled without any
// check of CGAL; the ends of the ranges are allowed.

#ifndef NDEBUG
#  define NDEBUG
#endif
#define CGAL_NDEBUG
#define CGAL_NO_ASSERTIONS
#define CGAL_NO_PRECONDITIONS

#include "mesh_contract.h"
#include "mesh_domains.h"

#include <CGAL/Annealing_schedules_3.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Density_quadratures_3.h>
#include <CGAL/Feature_edge_size_field_3.h>
#include <CGAL/Local_feature_size_field_3.h>
#include <CGAL/Quadratic_density_3.h>
#include <CGAL/Spline_grid_field_3.h>
#include <CGAL/exude_mesh_3.h>
#include <CGAL/odt_energy_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/remesh_boundary_mesh_3.h>
#include <CGAL/remove_slivers_mesh_3.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using domains::Labeled_c3t3;
using domains::Labeled_domain;
using domains::Point_3;
namespace params = CGAL::parameters;

typedef Mesh_contract<Labeled_c3t3, Labeled_domain> Contract;

static const double nan_value = std::numeric_limits<double>::quiet_NaN();
static const double infinity = std::numeric_limits<double>::infinity();

static void refuses(const char* name, const std::function<void()>& call)
{
  bool thrown = false;
  try { call(); }
  catch(const CGAL::Precondition_exception& e)
  {
    thrown = e.message().find(name) != std::string::npos;
  }
  check::that(thrown, "no precondition names the bad ", name);
}

static void numbers(Labeled_c3t3& c3t3, const Labeled_domain& domain)
{
  // The least of those that are too large.
  const double too_many = std::ldexp(1., std::numeric_limits<std::size_t>::digits);
  refuses("max_iteration_number", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::max_iteration_number = too_many); });
  for(double bad : { -1., nan_value, -infinity })
  {
    refuses("time_limit", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::time_limit = bad); });
    refuses("time_limit", [&] { CGAL::remesh_boundary_mesh_3(c3t3, domain, params::time_limit = bad); });
    refuses("time_limit", [&] { CGAL::remove_slivers_mesh_3(c3t3, domain, params::time_limit = bad); });
    refuses("max_iteration_number", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::max_iteration_number = bad); });
    refuses("number_of_rounds", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::number_of_rounds = bad); });
    refuses("surface_weight", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::surface_weight = bad); });
  }
  refuses("surface_weight", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::surface_weight = infinity); });
  refuses("max_iteration_number", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::max_iteration_number = -1); });
  refuses("number_of_rounds", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::number_of_rounds = -1); });
  refuses("number_of_vertices", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::number_of_vertices = 100); });
  refuses("number_of_vertices", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::number_of_vertices = 100,
                                                                params::do_insert_vertices = true); });
  for(double bad : { 0., -1., 4e7, nan_value })
    refuses("number_of_vertices", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::number_of_vertices = bad,
                                                                  params::do_insert_vertices = true, params::do_remove_vertices = true); });
  for(double bad : { -1., -1e-300, nan_value, infinity, -infinity })
  {
    refuses("facet_distance", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::facet_distance = bad); });
    refuses("facet_distance", [&] { CGAL::remesh_boundary_mesh_3(c3t3, domain, params::facet_distance = bad); });
    refuses("facet_distance", [&] { CGAL::remove_slivers_mesh_3(c3t3, domain, params::facet_distance = bad); });
  }
  for(double bad : { 0., -1., nan_value, infinity })
    refuses("largest_size", [&] { CGAL::Feature_edge_size_field_3<Labeled_c3t3>(c3t3, bad); });
  for(double bad : { -1., nan_value, infinity })
    refuses("gradation", [&] { CGAL::Feature_edge_size_field_3<Labeled_c3t3>(c3t3, 1, bad); });
  refuses("time_limit", [&] { CGAL::odt_optimize_mesh_3_impl(c3t3, domain, -1., 0, 0.1, 0.1, true); });
  for(double bad : { -0.1, 1.001, 5., nan_value, infinity })
  {
    refuses("convergence", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::convergence = bad); });
    refuses("freeze_bound", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::freeze_bound = bad); });
  }
  for(double bad : { -0.1, -1e-9, 70.5001, 70.6, 180., nan_value, infinity, -infinity })
  {
    refuses("sliver_bound", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::sliver_bound = bad); });
    refuses("sliver_bound", [&] { CGAL::remove_slivers_mesh_3(c3t3, domain, params::sliver_bound = bad); });
    // Also where it would not be used.
    refuses("sliver_bound", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_remove_slivers = false,
                                                            params::sliver_bound = bad); });
  }
}

static void allowed(const Labeled_c3t3& input, const Labeled_domain& domain)
{
  const auto allows = [&](const char* what, const auto& first, const auto& second, const auto& third)
  {
    Labeled_c3t3 c3t3(input);
    try { CGAL::odt_optimize_mesh_3(c3t3, domain, first, second, third, params::max_iteration_number = 1); }
    catch(const CGAL::Precondition_exception& e) { check::that(false, what, ": ", e.message()); }
  };
  allows("zeros", params::convergence = 0, params::freeze_bound = 0, params::sliver_bound = 0);
  allows("the largest number", params::number_of_rounds = (std::numeric_limits<std::size_t>::max)(), params::do_freeze = true,
         params::convergence = 1);
  allows("no weight", params::number_of_rounds = 0, params::surface_weight = 0, params::sliver_bound = 0);
  allows("the largest", params::convergence = 1, params::freeze_bound = 1, params::do_freeze = true);
  allows("the largest angle", params::time_limit = 0.5, params::number_of_rounds = 0, params::sliver_bound = 70.5);
  allows("no distance", params::number_of_rounds = 0, params::facet_distance = 0, params::do_freeze = true);
  allows("a large distance", params::number_of_rounds = 0, params::facet_distance = 1e300, params::do_freeze = true);
  allows("unlimited", params::time_limit = infinity, params::number_of_rounds = 0, params::optimize_boundary = true);
  CGAL::Momentum_annealing_schedule schedule;
  schedule.momentum = schedule.surface_amplitude = 0;
  schedule.interior_amplitude = 1;
  allows("the ends of a schedule", params::time_limit = 0, params::number_of_rounds = 1, params::annealing_schedule = schedule);
  // Also passed by reference, such a density is integrated exactly: the linear rule does not permit a zero at a vertex.
  const auto zero_at_vertex = CGAL::Quadratic_density_3<domains::Kernel>::squared_distance(
    input.triangulation().finite_vertices_begin()->point().point());
  allows("a density that is zero at a vertex", params::number_of_rounds = 0, params::density = zero_at_vertex, params::do_freeze = true);
  allows("the same by reference", params::number_of_rounds = 0, params::density = std::cref(zero_at_vertex), params::do_freeze = true);
  check::that(CGAL::odt_energy_3(input, params::density = zero_at_vertex)
              == CGAL::odt_energy_3(input, params::density = std::cref(zero_at_vertex)), "the energy of a density by reference");
  allows("a weight", params::number_of_rounds = 0, params::surface_weight = 1e3, params::do_remove_slivers = false);
  allows("an integer as weight", params::number_of_rounds = 0, params::surface_weight(2), params::do_remove_slivers(true));
}

static void allowed_for_slivers(const Labeled_c3t3& input, const Labeled_domain& domain)
{
  const auto allows = [&](const char* what, const auto&... parameters)
  {
    Labeled_c3t3 c3t3(input);
    try { CGAL::remove_slivers_mesh_3(c3t3, domain, parameters...); }
    catch(const CGAL::Precondition_exception& e) { check::that(false, what, ", slivers alone: ", e.message()); }
  };
  allows("nothing");
  allows("zeros", params::time_limit = 0, params::sliver_bound = 0);
  allows("the largest angle", params::sliver_bound = 70.5, params::optimize_boundary = false);
  allows("unlimited", params::time_limit = infinity, params::sliver_bound = 20, params::random_seed(1));
}

static void fields(Labeled_c3t3& c3t3, const Labeled_domain& domain)
{
  typedef Labeled_domain::Index Index;
  for(double bad : { 0., -1., nan_value, infinity })
  {
    // On the way, too.
    for(int n : { 0, 5000 })
    {
      int questions = 0;
      refuses("sizing_field", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::sizing_field =
        [&](const Point_3& p, int, const Index&) { return questions++ < n ? 2 + p.z() : bad; }); });
      questions = 0;
      refuses("density", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::density(
        [&](const Point_3& p) { return questions++ < n ? 2 + p.z() : bad; })); });
    }
    refuses("sizing_field", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::sizing_field = bad); });
    refuses("sizing_field", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::sizing_field = bad, params::do_insert_vertices = true); });
  }
  refuses("sizing_field and density", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::sizing_field = 1., params::density(
    [](const Point_3&) { return 1.; })); });
  // Negative in one half, or everywhere zero.
  typedef CGAL::Quadratic_density_3<domains::Kernel> Quadratic_density;
  for(double slope : { 1., 0. })
    refuses("density", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::density(
      Quadratic_density(0, domains::Kernel::Vector_3(slope, 0, 0), {{ 0, 0, 0, 0, 0, 0 }}))); });
  // In cells, when it is good at vertices.
  std::set<std::array<double, 3> > places;
  for(auto v = c3t3.triangulation().finite_vertices_begin(); v != c3t3.triangulation().finite_vertices_end(); ++v)
    places.insert({{ v->point().x(), v->point().y(), v->point().z() }});
  const auto bad_in_cells = [&](const Point_3& p) { return places.count({{ p.x(), p.y(), p.z() }}) != 0 ? 1. : -1.; };
  refuses("density", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::density(bad_in_cells),
                                                     params::quadrature = CGAL::Four_point_rule_3()); });
  for(double bad : { 0., nan_value, infinity })
    refuses("density", [&] { CGAL::odt_energy_3(c3t3, params::density([&](const Point_3&) { return bad; })); });
}

static void constants(Labeled_c3t3& c3t3, const Labeled_domain& domain)
{
  for(double bad : { 0., -1., nan_value, infinity })
    refuses("tolerance", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::quadrature(CGAL::Adaptive_cubature_3{ bad })); });
  refuses("most_regions", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::quadrature = CGAL::Adaptive_cubature_3{ 1e-3, 0 }); });
  const auto refuses_momentum = [&](const char* name, double CGAL::Momentum_annealing_schedule::* constant, double value)
  {
    CGAL::Momentum_annealing_schedule schedule;
    schedule.*constant = value;
    refuses(name, [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::annealing_schedule = schedule); });
  };
  const auto refuses_metropolis = [&](const char* name, auto constant, auto value)
  {
    CGAL::Metropolis_annealing_schedule schedule;
    schedule.*constant = value;
    refuses(name, [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::annealing_schedule(schedule)); });
  };
  typedef CGAL::Momentum_annealing_schedule Momentum;
  typedef CGAL::Metropolis_annealing_schedule Metropolis;
  for(double bad : { -0.1, nan_value, infinity })
  {
    refuses_momentum("momentum", &Momentum::momentum, bad);
    refuses_momentum("step_length", &Momentum::step_length, bad);
    refuses_momentum("interior_amplitude", &Momentum::interior_amplitude, bad);
    refuses_momentum("surface_amplitude", &Momentum::surface_amplitude, bad);
    refuses_momentum("decay", &Momentum::decay, bad);
    refuses_momentum("longest_step", &Momentum::longest_step, bad);
    refuses_metropolis("perturbation", &Metropolis::perturbation, bad);
    refuses_metropolis("temperature", &Metropolis::temperature, bad);
    refuses_metropolis("cooling", &Metropolis::cooling, bad);
  }
  refuses_momentum("momentum", &Momentum::momentum, 1);
  refuses_momentum("interior_amplitude", &Momentum::interior_amplitude, 1.1);
  refuses_metropolis("perturbation", &Metropolis::perturbation, 1.1);
  refuses_metropolis("iterations_in_round", &Metropolis::iterations_in_round, 0);
  refuses_metropolis("cooling", &Metropolis::cooling, 1.1);
  refuses_metropolis("final_iterations", &Metropolis::final_iterations, -1);
}

static void designed_fields()
{
  typedef CGAL::Spline_grid_field_3<domains::Kernel> Grid_field;
  const auto one = [](const Point_3&) { return 1.; };
  refuses("nodes", [&] { Grid_field(CGAL::Bbox_3(0, 0, 0, 1, 1, 1), 5, 4, 5, one); });
  refuses("box", [&] { Grid_field(CGAL::Bbox_3(0, 0, 0, 1, 0, 1), 5, 5, 5, one); });
  refuses("number of values", [&] { Grid_field(CGAL::Bbox_3(0, 0, 0, 1, 1, 1), 5, 5, 5, std::vector<double>(124, 1.)); });
  refuses("not finite", [&] { Grid_field(CGAL::Bbox_3(0, 0, 0, 1, 1, 1), 5, 5, 5, [](const Point_3&) { return infinity; }); });

  typedef CGAL::Local_feature_size_field_3<Labeled_domain> Size_field;
  const std::vector<Point_3> points = { Point_3(0, 0, 0), Point_3(1, 0, 0) };
  refuses("no samples", [&] { Size_field::from_points(std::vector<Point_3>()); });
  refuses("not finite", [&] { Size_field::from_points(std::vector<Point_3>(2, Point_3(0, 0, infinity))); });
  refuses("same point", [&] { Size_field::from_points(std::vector<Point_3>(2, Point_3(0, 0, 1))); });
  const auto refuses_constant = [&](const char* name, double CGAL::Local_feature_size_parameters_3::* constant)
  {
    for(double bad : { -1., nan_value, infinity })
    {
      CGAL::Local_feature_size_parameters_3 parameters;
      parameters.*constant = bad;
      refuses(name, [&] { Size_field::from_points(points, parameters); });
    }
  };
  refuses_constant("size_factor", &CGAL::Local_feature_size_parameters_3::size_factor);
  refuses_constant("gradation", &CGAL::Local_feature_size_parameters_3::gradation);
  refuses_constant("smallest_size", &CGAL::Local_feature_size_parameters_3::smallest_size);
  refuses_constant("largest_size", &CGAL::Local_feature_size_parameters_3::largest_size);
  refuses_constant("sample_spacing", &CGAL::Local_feature_size_parameters_3::sample_spacing);
}

// The message tells where a field is bad, and what it is there.
static void places_of_fields(Labeled_c3t3& c3t3, const Labeled_domain& domain)
{
  const Point_3 first = c3t3.triangulation().finite_vertices_begin()->point().point();
  std::ostringstream place;
  place << "at (" << first.x() << ", " << first.y() << ", " << first.z() << ") it is ";
  const auto at_first = [&](double bad) { return [first, bad](const Point_3& p) { return p == first ? bad : 1; }; };
  refuses(("density must be positive and finite: " + place.str() + "-2").c_str(),
          [&] { CGAL::odt_energy_3(c3t3, params::density = at_first(-2)); });
  refuses((place.str() + "0").c_str(), [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::density = at_first(0)); });
  refuses(("sizing_field must be positive and finite: " + place.str() + "inf").c_str(), [&] { CGAL::odt_optimize_mesh_3(
    c3t3, domain, params::sizing_field = [&](const Point_3& p, int, const Labeled_domain::Index&) { return at_first(infinity)(p); }); });
  // Where vertices are inserted, it is asked by others.
  refuses(") it is -1", [&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::sizing_field = -1, params::do_insert_vertices = true); });
}

// exude_mesh_3() gives weights to vertices off the features; the message says what to do about those inside. Those on surfaces may have
// weights, and stay where they are with them.
static void weights(const Labeled_c3t3& input, const Labeled_domain& domain)
{
  Labeled_c3t3 exuded(input);
  CGAL::exude_mesh_3(exuded, params::sliver_bound = 20);
  refuses("weights on vertices inside of subdomains: call this function before exude_mesh_3(), and give no_exude() to make_mesh_3()",
          [&] { CGAL::odt_optimize_mesh_3(exuded, domain); });
  refuses("weights", [&] { CGAL::remesh_boundary_mesh_3(exuded, domain); });
  refuses("weights", [&] { CGAL::remove_slivers_mesh_3(exuded, domain); });

  Labeled_c3t3 weighted(input);
  const auto f = *weighted.facets_in_complex_begin();
  const Labeled_c3t3::Vertex_handle v = f.first->vertex((f.second + 1) % 4);
  const Point_3 place = v->point().point();
  constexpr double weight = 1e-9;
  v->set_point(Labeled_c3t3::Triangulation::Weighted_point(place, weight));
  try { CGAL::odt_optimize_mesh_3(weighted, domain, params::number_of_rounds = 0); }
  catch(const CGAL::Precondition_exception& e) { check::that(false, "a weight on the surface: ", e.message()); }
  check::that(v->point().point() == place && v->point().weight() == weight, "a vertex with a weight on the surface has changed");
}

static int number_of_failures = 0;

int main()
{
  const Labeled_domain domain = domains::sphere();
  const Labeled_c3t3 input = domains::mesh(domain, 0.25);
  allowed(input, domain);
  allowed_for_slivers(input, domain);

  // They end where those of CGAL do.
  CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) { ++number_of_failures; });
  Labeled_c3t3 c3t3(input);
  const Contract contract(input, domain, "bad parameters");
  numbers(c3t3, domain);
  check::that(number_of_failures > 0, "the error handler of CGAL is not called");
  fields(c3t3, domain);
  places_of_fields(c3t3, domain);
  constants(c3t3, domain);
  designed_fields();
  weights(input, domain);
  contract.check_untouched(c3t3);
  return check::result();
}
