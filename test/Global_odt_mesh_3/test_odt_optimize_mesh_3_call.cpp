// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The call: named parameters in all styles, return codes, cancellation, bounds on time and
// iterations, schedules and seeds, slivers, exceptions, degenerate meshes, and the calls
// from make_mesh_3().

#include "mesh_contract.h"
#include "mesh_domains.h"
#include "subdomain_measures.h"

#include <CGAL/Annealing_schedules_3.h>
#include <CGAL/Density_quadratures_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Random.h>
#include <CGAL/Real_timer.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/refine_mesh_3.h>
#include <CGAL/remove_slivers_mesh_3.h>
#include <CGAL/version.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using domains::Labeled_c3t3;
using domains::Labeled_domain;
using domains::Point_3;
namespace params = CGAL::parameters;

typedef Mesh_contract<Labeled_c3t3, Labeled_domain> Contract;

// Vertices on the sphere move.
static void check_moved(const Contract& contract, const Labeled_c3t3& c3t3, double share_of_layer = 0.03)
{
  contract.check_moved(c3t3, 2e-3, 30, share_of_layer);
}

static void parameter_styles(const Labeled_c3t3& input, const Labeled_domain& domain)
{
  Labeled_c3t3 reference(input);
  CGAL::odt_optimize_mesh_3(reference, domain, params::time_limit = 100, params::max_iteration_number = 5,
                            params::convergence = 0.001, params::freeze_bound = 0.0005, params::do_freeze = false);
  Labeled_c3t3 local(input);
  CGAL::odt_optimize_mesh_3(local, domain, params::max_iteration_number = 5, params::convergence = 0.001,
                            params::freeze_bound = 0.0005, params::do_freeze = false,
                            params::number_of_rounds = 0, params::do_remove_slivers = false);
  const auto expected = Contract::points(reference), expected_without_search = Contract::points(local);
  check::that(expected != Contract::points(input), "parameters: nothing moved");
  check::that(expected != expected_without_search, "parameters: those of search and slivers have no effect");
  const auto compare = [&](const Labeled_c3t3& c3t3, const char* style, bool searches = true)
  {
    check::that(Contract::points(c3t3) == (searches ? expected : expected_without_search),
                "parameters given as ", style, " have another effect");
  };
  {
    Labeled_c3t3 c(input);
    CGAL::odt_optimize_mesh_3(c, domain, params::do_freeze = false, params::number_of_rounds = 0,
                              params::freeze_bound = 0.0005, params::do_remove_slivers = false, params::random_seed(5),
                              params::convergence = 0.001, params::max_iteration_number = 5);
    compare(c, "values with =, in another order, with the new ones among them", false);
  }
  {
    Labeled_c3t3 c(input), fixed(input);
    CGAL::odt_optimize_mesh_3(c, domain, params::optimize_boundary = true, params::max_iteration_number = 5,
                              params::convergence = 0.001, params::do_freeze = false);
    compare(c, "optimize_boundary and others");
    CGAL::odt_optimize_mesh_3(fixed, domain, params::optimize_boundary = false, params::max_iteration_number = 5,
                              params::do_freeze = false);
    Contract(input, domain, "optimize_boundary = false").check(fixed);
  }
#if CGAL_VERSION_NR < 1050600000
  {
    Labeled_c3t3 c(input);
    CGAL::odt_optimize_mesh_3(c, domain, 100, 5, 0.001, 0.0005, false);
    compare(c, "values by position");
  }
  {
    Labeled_c3t3 c(input);
    CGAL::odt_optimize_mesh_3(c, domain, 100, 5, 0.001, params::do_freeze = false, params::freeze_bound = 0.0005,
                              params::optimize_boundary = true);
    compare(c, "values by position, then by name");
  }
#else
  {
    Labeled_c3t3 c(input), by_default(input);
    CGAL::odt_optimize_mesh_3(c, domain, params::default_values());
    CGAL::odt_optimize_mesh_3(by_default, domain);
    check::that(Contract::points(c) == Contract::points(by_default), "default_values() are others");
  }
  {
    Labeled_c3t3 c(input);
    CGAL::odt_optimize_mesh_3(c, domain, params::time_limit(100).max_iteration_number(5).convergence(0.001)
                                               .freeze_bound(0.0005).do_freeze(false).sliver_bound(0));
    compare(c, "a chain");
  }
  {
    Labeled_c3t3 c(input);
    CGAL::odt_optimize_mesh_3(c, domain, params::maximum_running_time(100).number_of_iterations(5)
                                               .convergence(0.001).freeze_bound(0.0005).do_freeze(false));
    compare(c, "a chain with the names shared by other packages");
  }
  {
    Labeled_c3t3 c(input);
    CGAL::odt_optimize_mesh_3(c, domain, params::number_of_rounds(0).convergence(0.001).max_iteration_number(5),
                              params::freeze_bound(0.0005).do_freeze(false).random_seed(3),
                              params::do_remove_slivers(false));
    compare(c, "chains", false);
  }
#endif
  {
    Labeled_c3t3 c(input);
    CGAL::odt_optimize_mesh_3_impl(c, domain, 100., std::size_t(5), 0.001, 0.0005, false);
    compare(c, "arguments of odt_optimize_mesh_3_impl()");
  }
}

static void return_codes(const Labeled_c3t3& input, const Labeled_domain& domain)
{
  const Contract contract(input, domain, "return codes");
  const auto expect = [&](CGAL::Mesh_optimization_return_code code, CGAL::Mesh_optimization_return_code expected,
                          const Labeled_c3t3& c3t3, const char* what)
  {
    check::that(code == expected, what, ": return code ", code, ", not ", expected);
    check_moved(contract, c3t3);
  };
  {
    Labeled_c3t3 c(input);
    expect(CGAL::odt_optimize_mesh_3(c, domain, params::time_limit = 1e-9, params::convergence = 0),
           CGAL::TIME_LIMIT_REACHED, c, "time limit");
    contract.check_untouched(c);
  }
  {
    Labeled_c3t3 c(input);
    int iterations = 0;
    const auto count = [&](double) { ++iterations; return true; };
    expect(CGAL::odt_optimize_mesh_3(c, domain, params::max_iteration_number = 3, params::convergence = 0,
                                     params::do_freeze = false, params::do_remove_slivers = false, params::callback(count)),
           CGAL::MAX_ITERATION_NUMBER_REACHED, c, "iterations");
    check::that(iterations == 3, iterations, " iterations instead of 3");
  }
  {
    Labeled_c3t3 c(input);
    expect(CGAL::odt_optimize_mesh_3(c, domain, params::convergence = 0.05, params::do_freeze = false,
                                     params::number_of_rounds = 0, params::do_remove_slivers = false),
           CGAL::CONVERGENCE_REACHED, c, "convergence");
  }
  {
    Labeled_c3t3 c(input);
    expect(CGAL::odt_optimize_mesh_3(c, domain, params::convergence = 0, params::freeze_bound = 0.3,
                                     params::number_of_rounds = 0, params::do_remove_slivers = false),
           CGAL::ALL_VERTICES_FROZEN, c, "freezing");
  }
  {
    Labeled_c3t3 c(input);
    expect(CGAL::odt_optimize_mesh_3(c, domain, params::convergence = 0, params::do_freeze = false,
                                     params::number_of_rounds = 0, params::do_remove_slivers = false),
           CGAL::CANT_IMPROVE_ANYMORE, c, "exhaustion");
  }
}

static void cancellation(const Labeled_c3t3& input, const Labeled_domain& domain)
{
  const Contract contract(input, domain, "cancellation");
  std::vector<double> fractions;
  Labeled_c3t3 c3t3(input);
  const auto code = CGAL::odt_optimize_mesh_3(
    c3t3, domain, params::callback([&](double f) { fractions.push_back(f); return fractions.size() < 4; }));
  check::that(code == CGAL::TIME_LIMIT_REACHED, "cancellation: return code ", code);
  check::that(fractions.size() == 4, "the callback was called ", fractions.size(), " times");
  check_moved(contract, c3t3);
  check::that(Contract::points(c3t3) != Contract::points(input), "cancellation threw the iterations away");

}

// The fraction done that the callback is told goes from 0 through most of the way to 1, never back and not in leaps,
// whatever the schedule.
static void progress(const Labeled_c3t3& input, const Labeled_domain& domain)
{
  const auto report = [&](const char* what, const std::function<void(Labeled_c3t3&, std::function<bool(double)>)>& call)
  {
    std::vector<double> fractions;
    Labeled_c3t3 c3t3(input);
    call(c3t3, [&](double f) { fractions.push_back(f); return true; });
    check::Largest largest_leap;
    for(std::size_t n = 0; n < fractions.size(); ++n)
    {
      const double before = n == 0 ? 0. : fractions[n - 1];
      largest_leap.add(fractions[n] - before);
      check::that(fractions[n] >= before && fractions[n] <= 1, what, ": the fraction done goes from ", before, " to ", fractions[n]);
    }
    const double last = fractions.empty() ? 0. : fractions.back();
    std::cout << what << ": " << fractions.size() << " iterations, the last fraction is " << last << ", the largest leap "
              << largest_leap << std::endl;
    check::that(last >= 0.75, what, ": the last fraction is ", last);
    check::that(largest_leap <= 0.35, what, ": the fraction leaps by ", largest_leap);
  };
  report("progress of the default call", [&](Labeled_c3t3& c3t3, const std::function<bool(double)>& f)
  { CGAL::odt_optimize_mesh_3(c3t3, domain, params::callback(f)); });
  report("progress of Metropolis", [&](Labeled_c3t3& c3t3, const std::function<bool(double)>& f)
  {
    CGAL::odt_optimize_mesh_3(c3t3, domain, params::callback(f),
                              params::annealing_schedule = CGAL::Metropolis_annealing_schedule());
  });
  report("progress without search", [&](Labeled_c3t3& c3t3, const std::function<bool(double)>& f)
  { CGAL::odt_optimize_mesh_3(c3t3, domain, params::callback(f), params::number_of_rounds = 0); });
  report("progress with the boundary fixed", [&](Labeled_c3t3& c3t3, const std::function<bool(double)>& f)
  { CGAL::odt_optimize_mesh_3(c3t3, domain, params::callback(f), params::optimize_boundary = false); });
}

struct Iteration_counter
{
  int iterations = 0;
  void after_compute_moves() {}
  void after_move_points() {}
  void after_rebuild_restricted_delaunay() {}
  void end_of_iteration(int) { ++iterations; }
};

// The bound is for the iterations of all stages together, and the search takes place within it.
static void iteration_bound(const Labeled_c3t3& input, const Labeled_domain& domain)
{
  const Contract contract(input, domain, "70 iterations");
  const auto bounded = [&](std::size_t rounds)
  {
    Labeled_c3t3 c(input);
    Iteration_counter counted;
    const auto code = CGAL::odt_optimize_mesh_3(c, domain, params::max_iteration_number = 70, params::number_of_rounds = rounds,
                                                params::convergence = 0, params::do_freeze = false,
                                                params::do_remove_slivers = false, params::visitor(std::ref(counted)));
    check::that(counted.iterations <= 70, counted.iterations, " iterations instead of 70 at most");
    check::that(code == (counted.iterations == 70 ? CGAL::MAX_ITERATION_NUMBER_REACHED : CGAL::CANT_IMPROVE_ANYMORE),
                counted.iterations, " iterations of 70: return code ", code);
    check_moved(contract, c);
    return Contract::points(c);
  };
  check::that(bounded(4) != bounded(0), "within 70 iterations, nothing is searched");
  for(const bool freezes : { false, true })
  {
    Labeled_c3t3 c(input);
    Iteration_counter counted;
    CGAL::odt_optimize_mesh_3(c, domain, params::max_iteration_number = 70, params::do_freeze = freezes,
                              params::visitor(std::ref(counted)));
    check::that(counted.iterations <= 70, counted.iterations, " iterations of the usual call instead of 70 at most");
  }
}

// The search depends on the seed and the schedule alone.
static void schedules(const Labeled_c3t3& input, const Labeled_domain& domain)
{
  const Contract contract(input, domain, "schedules");
  const auto searched = [&](const auto& schedule, unsigned int seed)
  {
    Labeled_c3t3 c(input);
    CGAL::odt_optimize_mesh_3(c, domain, params::annealing_schedule = schedule, params::random_seed(seed),
                              params::number_of_rounds = 2, params::do_remove_slivers = false);
    check_moved(contract, c);
    return Contract::points(c);
  };
  const CGAL::Momentum_annealing_schedule momentum;
  CGAL::Momentum_annealing_schedule weaker;
  weaker.interior_amplitude = 0.05;
  const CGAL::Metropolis_annealing_schedule metropolis;
  CGAL::Metropolis_annealing_schedule shorter;
  shorter.iterations_in_round = 10;
  const auto by_momentum = searched(momentum, 1), by_metropolis = searched(metropolis, 1);
  check::that(searched(momentum, 1) == by_momentum, "momentum annealing is not deterministic");
  check::that(searched(metropolis, 1) == by_metropolis, "Metropolis annealing is not deterministic");
  check::that(searched(momentum, 2) != by_momentum, "another seed has no effect on momentum annealing");
  check::that(searched(metropolis, 2) != by_metropolis, "another seed has no effect on Metropolis annealing");
  check::that(searched(weaker, 1) != by_momentum, "the constants of momentum annealing have no effect");
  check::that(searched(shorter, 1) != by_metropolis, "the constants of Metropolis annealing have no effect");
  check::that(by_momentum != by_metropolis, "the schedule has no effect");
}

static double smallest_angle(const Labeled_c3t3& c3t3, Labeled_c3t3::Cell_handle c)
{
  std::array<CGAL::Global_odt_mesh_3::internal::Site, 4> s;
  for(int i = 0; i < 4; ++i)
  {
    const Point_3 p = c3t3.triangulation().point(c, i).point();
    s[i] = { p.x(), p.y(), p.z(), 0 };
  }
  const CGAL::Global_odt_mesh_3::internal::Cell_shape_3 shape(s[0], s[1], s[2], s[3]);
  return *std::min_element(shape.angles.begin(), shape.angles.end());
}

static std::size_t cells_below(const Labeled_c3t3& c3t3, double bound)
{
  std::size_t n = 0;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    n += smallest_angle(c3t3, c) < bound;
  return n;
}

struct Sliver_visitor
{
  int calls = 0;
  bool is_before_rebuilt = false;
  std::size_t slivers = 0;
  void after_compute_moves() {}
  void after_move_points() {}
  void after_rebuild_restricted_delaunay() { is_before_rebuilt = calls == 1; }
  void end_of_iteration(int) {}
  void after_sliver_removal(std::size_t n) { ++calls; slivers = n; }
};

// The numbers of cells below each angle that the removal of slivers goes for.
static std::vector<std::size_t> cells_below_steps(const Labeled_c3t3& c3t3)
{
  std::vector<std::size_t> numbers;
  for(double angle : { 20., 30., 35., 40., 45., 50. })
    numbers.push_back(cells_below(c3t3, angle));
  return numbers;
}

// The return code and the visitor tell how many cells stay below the bound; a higher bound never leads to less;
// and nothing is done if it is not wanted.
static void slivers()
{
  const Labeled_domain domain = domains::sphere();
  const Labeled_c3t3 input = domains::mesh(domain, 0.2), coarse = domains::mesh(domain, 0.5);
  CGAL::Mesh_optimization_return_code code;
  Sliver_visitor visitor;
  const auto optimized = [&](const Labeled_c3t3& from, double bound, std::size_t rounds = 4, bool removes = true)
  {
    const Contract contract(from, domain, "slivers");
    Labeled_c3t3 c(from);
    visitor = Sliver_visitor();
    code = CGAL::odt_optimize_mesh_3(c, domain, params::sliver_bound = bound, params::do_remove_slivers = removes,
                                     params::number_of_rounds = rounds, params::visitor(std::ref(visitor)));
    check_moved(contract, c);
    check::that(visitor.calls == 1 && visitor.is_before_rebuilt, "the visitor hears of slivers ", visitor.calls, " times");
    return c;
  };
  const Labeled_c3t3 by_default = optimized(input, 0);
  const bool is_usual = code == CGAL::CONVERGENCE_REACHED || code == CGAL::ALL_VERTICES_FROZEN;
  check::that(is_usual && visitor.slivers == 0, "by default, the return code is ", code, " and the visitor hears of ", visitor.slivers);
  check::that(cells_below(by_default, 35) == 0, "by default, ", cells_below(by_default, 35), " cells are below 35 degrees");

  // Where nearly all cells lack something, the call ends all the same, and they get no worse for it.
  std::vector<std::size_t> before;
  double smallest = 0;
  for(double bound : { 10., 20., 30., 40., 50., 60., 70.5 })
  {
    const Labeled_c3t3 c = optimized(input, bound);
    const std::vector<std::size_t> now = cells_below_steps(c);
    const double angle = CGAL::mesh_quality_report_3(c).smallest_angle;
    std::cout << "slivers: bound " << bound << ", smallest angle " << angle << ", " << cells_below(c, bound) << " cells below" << std::endl;
    check::that(visitor.slivers == cells_below(c, bound), cells_below(c, bound), " cells are below ", bound,
                " degrees, the visitor hears of ", visitor.slivers);
    check::that((code == CGAL::CANT_IMPROVE_ANYMORE) == (visitor.slivers > 0), "with bound ", bound, " the return code is ", code);
    check::that(angle >= smallest - 1e-6, "the bound ", bound, " leads to ", angle, " degrees, a lower one to ", smallest);
    for(std::size_t n = 0; n < before.size(); ++n)
      check::that(now[n] <= before[n], "the bound ", bound, " leads to ", now[n], " cells where a lower one leads to ", before[n]);
    if(bound <= 40)
      check::that(visitor.slivers == 0, visitor.slivers, " cells are left below ", bound, " degrees");
    // Cells that a lower bound has not gone for may have any angle.
    before.assign(now.begin(), now.begin() + (bound < 20 ? 0 : bound < 30 ? 1 : bound < 40 ? 2 : bound < 50 ? 4 : 6));
    smallest = angle;
  }
  const Labeled_c3t3 out_of_reach = optimized(coarse, 69);
  check::that(visitor.slivers > 0 && visitor.slivers == cells_below(out_of_reach, 69) && code == CGAL::CANT_IMPROVE_ANYMORE,
              cells_below(out_of_reach, 69), " cells are below 69 degrees, the visitor hears of ", visitor.slivers);

  // The search may have left none by chance.
  const Labeled_c3t3 on = optimized(input, 20, 0), off = optimized(input, 20, 0, false);
  std::cout << "slivers: " << cells_below(input, 20) << " in the input, " << cells_below(off, 20)
            << " in the local minimum, then " << cells_below(on, 20) << std::endl;
  check::that(visitor.slivers == cells_below(off, 20), "without removal, the visitor hears of ", visitor.slivers, " slivers");
  check::that(code == CGAL::CONVERGENCE_REACHED || code == CGAL::ALL_VERTICES_FROZEN, "without removal, the return code is ", code);
  check::that(cells_below(off, 20) > cells_below(on, 20) && Contract::points(off) != Contract::points(on),
              "do_remove_slivers = false has no effect");
}

// Slivers alone are removed by moving few vertices, from a mesh that nothing has minimized.
static void slivers_alone()
{
  const Labeled_domain domain = domains::sphere();
  const Labeled_c3t3 input = domains::mesh(domain, 0.15);
  const Contract contract(input, domain, "slivers alone");
  for(bool moves : { true, false })
  {
    Labeled_c3t3 c(input), fixed_bound(input);
    Sliver_visitor visitor;
    const auto code = CGAL::remove_slivers_mesh_3(c, domain, params::optimize_boundary = moves, params::random_seed(3),
                                                  params::visitor(std::ref(visitor)));
    check_moved(contract, c);
    check::that(code == CGAL::CONVERGENCE_REACHED && visitor.calls == 1, "the removal of slivers alone returns ", code);
    CGAL::remove_slivers_mesh_3(fixed_bound, domain, params::sliver_bound = 20, params::optimize_boundary = moves);
    const auto before = Contract::points(input), after = Contract::points(fixed_bound);
    std::vector<typename decltype(before)::value_type> kept;
    std::set_intersection(before.begin(), before.end(), after.begin(), after.end(), std::back_inserter(kept));
    std::cout << "slivers alone: " << cells_below(input, 20) << " -> " << cells_below(fixed_bound, 20) << ", " << kept.size()
              << " vertices of " << before.size() << " stay; " << CGAL::mesh_quality_report_3(c).smallest_angle
              << " degrees without a bound" << std::endl;
    check::that(cells_below(fixed_bound, 20) * 20 < cells_below(input, 20), "slivers are left");
    check::that(kept.size() > before.size() / 3, "only ", kept.size(), " vertices stay");
    check::that(CGAL::mesh_quality_report_3(c).smallest_angle >= CGAL::mesh_quality_report_3(fixed_bound).smallest_angle - 1e-6,
                "a bound leads to more than none");
  }
  Labeled_c3t3 c(input);
  check::that(CGAL::remove_slivers_mesh_3(c, domain, params::callback([](double) { return false; })) == CGAL::TIME_LIMIT_REACHED,
              "the callback is not obeyed");
}

// As many vertices as are asked for, more or fewer.
static void vertices_come_and_go(const Labeled_c3t3& input, const Labeled_domain& domain)
{
  Contract contract(input, domain, "vertices come and go");
  contract.permit(true, true);
  const std::size_t before = input.triangulation().number_of_vertices();
  for(std::size_t number : { before / 2, 2 * before })
  {
    Labeled_c3t3 c3t3(input);
    CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_insert_vertices = true, params::do_remove_vertices = true,
                              params::number_of_vertices = number);
    contract.check_moved(c3t3, 2e-3, 20, 0.3);
    const std::size_t after = c3t3.triangulation().number_of_vertices();
    check::that(100 * after >= 99 * number && 100 * after <= 101 * number, "vertices come and go: ", after, ", not ", number);
  }
}

// Where nothing can move, what is returned and told is what is there.
static void slivers_that_cannot_move()
{
  const Labeled_domain domain = domains::sphere();
  Labeled_c3t3 input = domains::mesh(domain, 0.3);
  for(Labeled_c3t3::Vertex_handle v : input.triangulation().finite_vertex_handles())
    input.set_dimension(v, 1);          // as on features
  const double bound = 40;
  const Contract contract(input, domain, "slivers that cannot move");
  for(bool is_alone : { true, false })
  {
    Labeled_c3t3 c(input);
    Sliver_visitor visitor;
    const auto code = is_alone
      ? CGAL::remove_slivers_mesh_3(c, domain, params::sliver_bound = bound, params::visitor(std::ref(visitor)))
      : CGAL::odt_optimize_mesh_3(c, domain, params::sliver_bound = bound, params::visitor(std::ref(visitor)));
    contract.check(c);
    check::that(cells_below(c, bound) > 0 && visitor.slivers == cells_below(c, bound), cells_below(c, bound),
                " cells are below the bound, the visitor hears of ", visitor.slivers);
    check::that(code == CGAL::CANT_IMPROVE_ANYMORE, "with slivers that cannot move, the return code is ", code);
  }
}

// On a mesh that is fine compared with the curvature, with some seeds: facets have angles of 30 degrees, the volume hardly
// changes, the median edge gets a little shorter, and the largest cell no larger.
static void fine_mesh()
{
  const Labeled_domain domain = domains::sphere();
  const Labeled_c3t3 input = domains::mesh(domain, 0.1);
  const Contract contract(input, domain, "fine mesh");
  for(unsigned int seed : { 0, 1, 2 })
  {
    Labeled_c3t3 c(input);
    CGAL::odt_optimize_mesh_3(c, domain, params::random_seed(seed));
    contract.check_moved(c, 2e-3, 30, 0.01);
    const double edge = median_edges(c).at(1) / median_edges(input).at(1);
    const double radius = largest_circumradii(c).at(1) / largest_circumradii(input).at(1);
    std::cout << "fine mesh: median edge times " << edge << ", largest circumradius times " << radius << std::endl;
    check::that(edge > 0.93 && edge < 1.01, "the median edge becomes longer by a factor of ", edge);
    check::that(radius < 1.05, "the largest circumradius becomes longer by a factor of ", radius);
  }
}

// A limit that is too short for the whole schedule shortens all stages: the call ends in time, give
// or take what cannot be interrupted, and with a better mesh than the input.
static void time_limit()
{
  const Labeled_domain domain = domains::sphere();
  const Labeled_c3t3 input = domains::mesh(domain, 0.075);
  const Contract contract(input, domain, "time limit");
  CGAL::Real_timer timer;
  timer.start();
  Labeled_c3t3 unlimited(input);
  CGAL::odt_optimize_mesh_3(unlimited, domain);
  const double limit = timer.time() / 2;
  timer.reset();
  Labeled_c3t3 limited(input);
  const auto code = CGAL::odt_optimize_mesh_3(limited, domain, params::time_limit = limit);
  const double taken = timer.time();
  std::cout << "time limit: " << input.triangulation().number_of_vertices() << " vertices, " << taken << " s of " << limit
            << ", return code " << code << ", cells below 20 degrees: " << cells_below(input, 20) << " -> " << cells_below(limited, 20)
            << std::endl;
  check::that(taken < 1.5 * limit + 1, "the call takes ", taken, " s for a limit of ", limit);
  check_moved(contract, limited);
  check::that(Contract::points(limited) != Contract::points(unlimited), "the limit has no effect");
  check::that(cells_below(limited, 20) < cells_below(input, 20) / 2, "the time is spent in vain");
}

static double smallest_angle(const Labeled_c3t3& c3t3)
{
  return CGAL::mesh_quality_report_3(c3t3, {}).smallest_angle;
}

// Whenever the call ends, by a callback or a limit, its result is valid, and has no smaller angle than the input. Slivers are
// removed once there have been iterations.
static void early_ends(const char* name, const Labeled_c3t3& input, const Labeled_domain& domain)
{
  const Contract contract(input, domain, name);
  const double before = smallest_angle(input);
  const auto check_end = [&](const std::string& what, const Labeled_c3t3& c3t3)
  {
    check_moved(contract, c3t3);
    const double after = smallest_angle(c3t3);
    check::that(after >= before - 1e-6, name, ", ", what, ": the smallest angle goes from ", before, " to ", after);
    return after;
  };
  for(int most : { 1, 3, 30, 90, 170, 200, 220, 230 })
  {
    Labeled_c3t3 c(input);
    int calls = 0;
    const auto code = CGAL::odt_optimize_mesh_3(c, domain, params::callback([&](double) { return ++calls < most; }));
    check::that(calls < most || code == CGAL::TIME_LIMIT_REACHED, name, ", end by callback: return code ", code);
    check::that(calls <= most, name, ": the callback is asked again");
    check::that(check_end("callback " + std::to_string(most), c) > 10 || most == 1, name, ": slivers are left by the end at call ", most);
  }
  CGAL::Real_timer timer;
  timer.start();
  Labeled_c3t3 unlimited(input);
  CGAL::odt_optimize_mesh_3(unlimited, domain);
  const double all = timer.time();
  for(double share : { 0.01, 0.05, 0.25, 0.5 })
  {
    Labeled_c3t3 c(input);
    timer.reset();
    CGAL::odt_optimize_mesh_3(c, domain, params::time_limit = share * all);
    const double taken = timer.time();
    const double after = check_end("time limit", c);
    std::cout << name << ": " << taken << " s of " << share * all << ", smallest angle " << before << " -> " << after << std::endl;
    check::that(taken < 1.3 * share * all + 2, name, ": the call takes ", taken, " s for a limit of ", share * all);
  }
}

static void exceptions(const Labeled_c3t3& input)
{
  // A domain that starts to throw after so many questions.
  long questions_left = -1;
  const Labeled_domain domain = domains::labeled([&](const Point_3& p) -> int
  {
    if(questions_left >= 0 && questions_left-- == 0)
      throw std::runtime_error("the domain fails");
    return domains::squared(p) < 1 ? 1 : 0;
  });
  const Contract contract(input, domain, "exceptions");
  const auto throws = [&](const char* what, Labeled_c3t3& c3t3, const std::function<void()>& call)
  {
    bool thrown = false;
    try { call(); }
    catch(const std::runtime_error&) { thrown = true; }
    questions_left = -1;
    check::that(thrown, what, " did not throw");
    contract.check_untouched(c3t3);
    contract.check(c3t3);
  };
  Labeled_c3t3 c3t3(input);
  for(long n : { 0L, 10L, 500L })
    throws("domain", c3t3, [&] { questions_left = n; CGAL::odt_optimize_mesh_3(c3t3, domain); });
  for(int n : { 0, 1, 5 })
  {
    int calls = 0;
    throws("callback", c3t3, [&]
    {
      CGAL::odt_optimize_mesh_3(c3t3, domain, params::convergence = 0, params::callback([&](double) -> bool
      {
        if(calls++ == n)
          throw std::runtime_error("the callback fails");
        return true;
      }));
    });
  }
}

static void throwing_fields(const Labeled_c3t3& input, const Labeled_domain& domain)
{
  const Contract contract(input, domain, "throwing fields");
  Labeled_c3t3 c3t3(input);
  const auto throws = [&](const auto& quadrature)
  {
    for(int n : { 0, 5000 })
    {
      int questions = 0;
      bool thrown = false;
      try
      {
        CGAL::odt_optimize_mesh_3(c3t3, domain, params::quadrature = quadrature, params::density([&](const Point_3& p) -> double
        {
          if(questions++ == n)
            throw std::runtime_error("the density fails");
          return 2 + p.z();
        }));
      }
      catch(const std::runtime_error&) { thrown = true; }
      check::that(thrown, "the density did not throw");
      contract.check_untouched(c3t3);
    }
  };
  throws(CGAL::Linear_density_rule_3());
  throws(CGAL::Fifteen_point_rule_3());
}

struct Counting_visitor
{
  int moves = 0, moved = 0, rebuilt = 0, iterations = 0;
  void after_compute_moves() { ++moves; }
  void after_move_points() { ++moved; }
  void after_rebuild_restricted_delaunay() { ++rebuilt; }
  void end_of_iteration(int i) { iterations = i == iterations ? i + 1 : -1; }
};

// Handles of vertices stay valid, in the same order, and what the mesh says of them stays, although cells are new.
static void vertices_stay(const Labeled_c3t3& input, const Labeled_domain& domain)
{
  Labeled_c3t3 c3t3(input);
  const auto& tr = c3t3.triangulation();
  const auto handles = [&tr]
  {
    std::vector<Labeled_c3t3::Vertex_handle> all;
    for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
      all.push_back(v);
    return all;
  };
  const auto before = handles();
  std::vector<Point_3> points;
  std::vector<std::pair<int, Labeled_c3t3::Index> > facts;
  for(auto v : before)
  {
    points.push_back(tr.point(v).point());
    facts.emplace_back(v->in_dimension(), v->index());
  }
  CGAL::odt_optimize_mesh_3(c3t3, domain);
  check::that(handles() == before, "vertices are others, or in another order");
  int moved = 0;
  for(std::size_t n = 0; n < before.size(); ++n)
  {
    check::that(before[n]->in_dimension() == facts[n].first && before[n]->index() == facts[n].second,
                "a vertex has another dimension or index");
    check::that(tr.is_vertex(before[n]) && before[n]->cell()->has_vertex(before[n]), "a vertex has no cell");
    moved += tr.point(before[n]).point() != points[n];
  }
  check::that(moved > 0.9 * double(before.size()), "only ", moved, " vertices have moved");
}

static void visitor(const Labeled_c3t3& input, const Labeled_domain& domain)
{
  Counting_visitor v;
  Labeled_c3t3 c3t3(input);
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::max_iteration_number = 4, params::convergence = 0,
                            params::do_freeze = false, params::visitor(std::ref(v)));
  check::that(v.moves == 4 && v.moved == 4 && v.iterations == 4 && v.rebuilt == 1, "the visitor counted ",
              v.moves, ' ', v.moved, ' ', v.iterations, ' ', v.rebuilt);
}

// Marks on the second side the facets that are in the complex on one only, after
// a vertex was inserted outside.
static void complete_facets(Labeled_c3t3& c3t3)
{
  auto& tr = c3t3.triangulation();
  for(auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f)
  {
    auto g = *f, h = tr.mirror_facet(*f);
    if(c3t3.is_in_complex(g) == c3t3.is_in_complex(h))
      continue;
    if(c3t3.is_in_complex(h))
      std::swap(g, h);
    h.first->set_surface_patch_index(h.second, c3t3.surface_patch_index(g));
    h.first->set_facet_surface_center(h.second, g.first->get_facet_surface_center(g.second));
    h.first->set_facet_surface_center_index(h.second, g.first->get_facet_surface_center_index(g.second));
  }
}

static void degenerate(const Labeled_c3t3& sphere_mesh, const Labeled_domain& domain)
{
  const auto survives = [&](const std::string& name, Labeled_c3t3& c3t3, bool may_move, double share_of_layer = 0.03)
  {
    const Contract contract(c3t3, domain, name);
    Labeled_c3t3 with_fixed_boundary(c3t3);
    CGAL::odt_optimize_mesh_3(with_fixed_boundary, domain, params::optimize_boundary = false);
    contract.check(with_fixed_boundary);
    Labeled_c3t3 with_edits(c3t3);
    Contract contract_of_edits(contract);
    contract_of_edits.permit(true, true);
    CGAL::odt_optimize_mesh_3(with_edits, domain, params::sliver_bound = 60, params::do_insert_vertices = true,
                              params::do_remove_vertices = true);
    check_moved(contract_of_edits, with_edits, share_of_layer);
    const auto code = CGAL::odt_optimize_mesh_3(c3t3, domain);
    check_moved(contract, c3t3, share_of_layer);
    if(!may_move)
    {
      contract.check_untouched(c3t3);
      check::that(code == CGAL::ALL_VERTICES_FROZEN, name, ": return code ", code);
      check::that(CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_freeze = false) == CGAL::CONVERGENCE_REACHED,
                  name, ": without freezing, the return code is not CONVERGENCE_REACHED");
    }
  };
  typedef Labeled_c3t3::Triangulation::Weighted_point Weighted_point;
  {
    Labeled_c3t3 c;
    survives("nothing at all", c, false);
    c.triangulation().insert(Weighted_point(Point_3(0, 0, 0)));
    survives("one vertex", c, false);
    c.triangulation().insert(Weighted_point(Point_3(1, 0, 0)));
    c.triangulation().insert(Weighted_point(Point_3(0, 1, 0)));
    survives("one triangle", c, false);
  }
  {
    Labeled_c3t3 c;
    for(int i = 0; i < 8; ++i)
      c.triangulation().insert(Weighted_point(Point_3(2 + (i & 1), 2 + (i >> 1 & 1), 2.1 + (i >> 2 & 1))));
    survives("no cell in the complex", c, false);
  }
  {
    Labeled_c3t3 c;
    const double s = 0.9;
    for(const Point_3& p : { Point_3(s, 0, 0), Point_3(-s, s, 0), Point_3(-s, -s, -s), Point_3(0, 0, s) })
    {
      const auto v = c.triangulation().insert(Weighted_point(p));
      v->set_dimension(2);
    }
    const auto cell = c.triangulation().finite_cells_begin();
    c.add_to_complex(cell, 1);
    for(int i = 0; i < 4; ++i)
    {
      c.add_to_complex(cell, i, std::make_pair(0, 1));
      const auto mirror = c.triangulation().mirror_facet(std::make_pair(Labeled_c3t3::Cell_handle(cell), i));
      cell->set_facet_surface_center(i, CGAL::ORIGIN);
      mirror.first->set_facet_surface_center(mirror.second, CGAL::ORIGIN);
    }
    survives("one cell", c, false);
  }
  {
    Labeled_c3t3 c = domains::mesh(domain, 1.2);
    survives("hardly an interior vertex", c, true, 0.07);
  }
  {
    Labeled_c3t3 c(sphere_mesh);
    for(auto v = c.triangulation().finite_vertices_begin(); v != c.triangulation().finite_vertices_end(); ++v)
      v->set_dimension(2);
    survives("all vertices on the surface", c, true);
  }
  {
    Labeled_c3t3 c(sphere_mesh);
    const auto v = c.triangulation().insert(Weighted_point(Point_3(2, 0.1, 0.2)));
    v->set_dimension(2);
    complete_facets(c);
    survives("isolated vertex", c, true);
  }
  {
    Labeled_c3t3 c(sphere_mesh);
    c.add_far_point(Weighted_point(Point_3(20, 1, 2)));
    complete_facets(c);
    survives("far point", c, true);
    check::that(c.number_of_far_points() == 1, "the far point was lost");
  }
}

// Cells of structured meshes that are flat up to rounding neither keep the others from moving nor get a label that does not fit.
static void structured(const Labeled_domain& domain)
{
  for(const int fixed_rings : { 0, 3 })
  {
    const Labeled_c3t3 input = domains::mesh_of_rings(domain, fixed_rings);
    for(const int iterations : { 0, 1 })
      for(const bool optimizes_boundary : { true, false })
      {
        const Contract contract(input, domain, "mesh with " + std::to_string(fixed_rings) + " fixed rings, "
                                + std::to_string(iterations) + " iterations");
        Labeled_c3t3 c3t3(input);
        CGAL::odt_optimize_mesh_3(c3t3, domain, params::optimize_boundary = optimizes_boundary,
                                  params::do_remove_slivers = false, params::max_iteration_number = iterations);
        if(optimizes_boundary)
          check_moved(contract, c3t3);
        else
          contract.check(c3t3);
        check::that(Contract::points(c3t3) != Contract::points(input), "a structured mesh does not move");
      }
  }
}

// Positions that are changed behind the back of a triangulation, by so much. Such a triangulation cannot be copied.
static void shift_vertices(Labeled_c3t3& c3t3, double amount, unsigned int seed)
{
  CGAL::Random random(seed);
  const auto shifted = [&](double x) { return x + random.get_double(-amount, amount); };
  auto& tr = c3t3.triangulation();
  for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
  {
    const auto& p = v->point();
    v->set_point(Labeled_c3t3::Triangulation::Weighted_point(Point_3(shifted(p.x()), shifted(p.y()), shifted(p.z())), p.weight()));
  }
}

// Meshes that are not regular, as when rounded coordinates are read from a file, or far worse: what comes out is regular, or is
// what came in.
static void not_regular()
{
  const Labeled_domain ball = domains::sphere(), three = domains::three_subdomains();
  const Labeled_c3t3 of_ball = domains::mesh(ball, 0.15), of_three = domains::mesh(three, 0.25);
  int changed = 0;
  for(const unsigned int seed : { 1, 2 })
    for(const double amount : { 1e-6, 1e-2, 5e-2 })
      for(const bool is_ball : { true, false })
        for(int call = 0; call < 3; ++call)
        {
          const Labeled_domain& domain = is_ball ? ball : three;
          Labeled_c3t3 c3t3(is_ball ? of_ball : of_three);
          shift_vertices(c3t3, amount, seed);
          const auto before = Contract::points(c3t3);
          const std::string name = "vertices shifted by " + std::to_string(amount) + ", seed " + std::to_string(seed)
                                   + ", call " + std::to_string(call);
          // Cells with inverted orientation have no dual points.
          std::optional<Contract> contract;
          if(amount < 1e-5)
            contract.emplace(c3t3, domain, name);
          if(call == 0)
            CGAL::odt_optimize_mesh_3(c3t3, domain);
          else if(call == 1)
            CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_insert_vertices = true, params::do_remove_vertices = true);
          else
            CGAL::remove_slivers_mesh_3(c3t3, domain);
          if(contract)
          {
            contract->permit(call == 1, call == 1);
            check_moved(*contract, c3t3);
          }
          const bool has_changed = Contract::points(c3t3) != before;
          check::that(!has_changed || c3t3.triangulation().is_valid(), name, ": the triangulation is not regular");
          check::that(call == 1 || c3t3.triangulation().number_of_vertices() == before.size(), name, ": vertices come or go");
          changed += has_changed;
        }
  check::that(changed > 20, "only ", changed, " of 36 calls change a mesh that is not regular");
}

static void called_by_the_mesher()
{
  // A domain of its own for each, as it carries the random generator.
  const Labeled_domain domain = domains::sphere(), same_domain = domains::sphere();
  domains::Labeled_criteria criteria(params::facet_angle = 25, params::facet_size = 0.3, params::facet_distance = 0.05,
                                     params::cell_radius_edge_ratio = 2.5, params::cell_size = 0.3);
  const auto plain = CGAL::make_mesh_3<Labeled_c3t3>(domain, criteria, params::no_exude(), params::no_perturb());
  const Contract contract(plain, domain, "make_mesh_3 with odt()");
  const auto c3t3 = CGAL::make_mesh_3<Labeled_c3t3>(same_domain, criteria, params::no_exude(), params::no_perturb(),
                                                   params::odt());
  check_moved(contract, c3t3);
  check::that(Contract::points(c3t3) != Contract::points(plain), "make_mesh_3 with odt() does not optimize");

  // The mesher computes surface centers anew, hence a contract of its own.
  Labeled_c3t3 rescanned(plain), refined(plain);
  CGAL::refine_mesh_3(rescanned, domain, criteria, params::no_exude(), params::no_perturb(), params::no_reset_c3t3());
  const Contract contract_after_scan(rescanned, domain, "refine_mesh_3 with odt()");
  CGAL::refine_mesh_3(refined, domain, criteria, params::no_exude(), params::no_perturb(), params::no_reset_c3t3(),
                      params::odt(params::time_limit = 10, params::convergence = 0.1));
  check_moved(contract_after_scan, refined);
  check::that(Contract::points(refined) != Contract::points(plain), "refine_mesh_3 with odt() does not optimize");

  // The optimized mesh satisfies the mesher, perturber and exuder.
  Labeled_c3t3 after(c3t3);
  CGAL::perturb_mesh_3(after, domain, params::sliver_bound = 5, params::time_limit = 5);
  CGAL::exude_mesh_3(after, params::sliver_bound = 5, params::time_limit = 5);
  check::that(after.triangulation().is_valid(), "not valid after perturbation and exudation");
  check::that(after.number_of_facets_in_complex() > 0 && after.number_of_cells_in_complex() > 0,
              "nothing left after perturbation and exudation");
}

int main()
{
  const Labeled_domain domain = domains::sphere();
  const Labeled_c3t3 mesh = domains::mesh(domain, 0.25);
  parameter_styles(mesh, domain);
  return_codes(mesh, domain);
  cancellation(mesh, domain);
  progress(mesh, domain);
  iteration_bound(mesh, domain);
  schedules(mesh, domain);
  slivers();
  slivers_alone();
  slivers_that_cannot_move();
  fine_mesh();
  time_limit();
  early_ends("early ends in a ball", domains::mesh(domain, 0.1), domain);
  early_ends("early ends in three subdomains", domains::mesh(domains::three_subdomains(), 0.12), domains::three_subdomains());
  throwing_fields(mesh, domain);
  exceptions(mesh);
  vertices_stay(mesh, domain);
  vertices_come_and_go(domains::mesh(domain, 0.15), domain);
  visitor(mesh, domain);
  degenerate(mesh, domain);
  structured(domain);
  not_regular();
  called_by_the_mesher();
  return check::result();
}
