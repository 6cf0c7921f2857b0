// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A mesh that is made for threads: the result does not depend on how many there are, nor on whether there are any, and
// what the user gives is called from one only, but for a domain that is said to be safe. What it throws comes out, and leaves
// the mesh.

#include "check.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Global_odt_mesh_3/internal/blocks/Block_annealing_3.h>
#include <CGAL/IO/File_binary_mesh_3.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/tags.h>

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Labeled_mesh_domain_3<Kernel> Domain;
template <class Concurrency_tag>
using C3t3_for = CGAL::Mesh_complex_3_in_triangulation_3<
  typename CGAL::Mesh_triangulation_3<Domain, CGAL::Default, Concurrency_tag>::type>;
typedef C3t3_for<CGAL::Parallel_tag> C3t3;
typedef C3t3::Triangulation Triangulation;
typedef CGAL::Mesh_criteria_3<Triangulation> Criteria;
namespace params = CGAL::parameters;

static double squared(const Point_3& p) { return (p - CGAL::ORIGIN).squared_length(); }

typedef std::vector<std::array<double, 3> > Coordinates;

// In an order that does not depend on the containers.
template <class C3t3>
Coordinates coordinates(const C3t3& c3t3)
{
  Coordinates c;
  const auto& tr = c3t3.triangulation();
  for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
  {
    const Point_3& p = tr.point(v).point();
    c.push_back({{ p.x(), p.y(), p.z() }});
  }
  std::sort(c.begin(), c.end());
  return c;
}

template <class C3t3>
C3t3 read(const std::string& mesh)
{
  C3t3 c3t3;
  std::istringstream stream(mesh);
  check::that(CGAL::IO::load_binary_file(stream, c3t3), "the mesh cannot be read");
  return c3t3;
}

// The thread that calls first, and whether another one does; calls fail after some. The first thread may wait for another
// one, lest it be done with all calls while the machine is busy otherwise.
struct Caller
{
  std::thread::id thread = std::this_thread::get_id();
  std::atomic<bool> is_other{false};
  std::atomic<long> calls_left{most_calls};
  std::atomic<int> milliseconds_to_wait{0};

  static constexpr long most_calls = 1000000000;

  // With the thread that calls now.
  void start_over()
  {
    thread = std::this_thread::get_id();
    is_other = false;
    calls_left = most_calls;
  }

  void check()
  {
    if(std::this_thread::get_id() != thread)
      is_other = true;
    else if(!is_other && milliseconds_to_wait > 0)
    {
      --milliseconds_to_wait;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if(--calls_left < 0)
      throw std::runtime_error("what the user gives fails");
  }
};

// A graded density.
struct Density
{
  typedef Kernel::FT FT;
  Caller* caller;

  FT operator()(const Point_3& p) const
  {
    caller->check();
    return 1 + 20 * p.x() * p.x();
  }
};

// The whole call, with rounds and slivers.
template <class C3t3>
Coordinates optimized(const std::string& mesh, const Domain& domain, std::size_t threads, bool domain_is_safe = false)
{
  tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
  C3t3 c3t3 = read<C3t3>(mesh);
  const Coordinates before = coordinates(c3t3);
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::number_of_rounds = 1, params::domain_is_thread_safe = domain_is_safe);
  check::that(c3t3.triangulation().is_valid(), "the triangulation is not valid");
  const Coordinates after = coordinates(c3t3);
  check::that(after.size() == before.size() && after != before, "vertices are lost, or nothing has moved");
  return after;
}

// Gives what they lead to.
static Coordinates same_for_all_threads(const std::string& mesh, const Domain& domain, const std::vector<std::size_t>& numbers)
{
  const Coordinates expected = optimized<C3t3>(mesh, domain, 1);
  for(std::size_t threads : numbers)
    check::that(optimized<C3t3>(mesh, domain, threads) == expected, threads, " threads lead elsewhere than one");
  check::that(optimized<C3t3_for<CGAL::Sequential_tag> >(mesh, domain, 1) == expected,
              "a mesh that is not made for threads leads elsewhere");
  return expected;
}

template <class F>
void fails_without_a_trace(const char* what, C3t3& c3t3, const C3t3& input, const F& optimize)
{
  c3t3 = input;
  const Coordinates before = coordinates(c3t3);
  bool has_thrown = false;
  try { optimize(); }
  catch(const std::runtime_error&) { has_thrown = true; }
  check::that(has_thrown, "the exception of the ", what, " is lost");
  check::that(coordinates(c3t3) == before && c3t3.is_valid(), "an exception of the ", what, " has changed the mesh");
}

static void users_are_called_from_one_thread(const C3t3& input, const Domain& domain, Caller& caller)
{
  tbb::global_control control(tbb::global_control::max_allowed_parallelism, 4);
  for(bool has_points_in_cells : { false, true })
  {
    C3t3 c3t3 = input;
    Caller caller_of_density;
    const Density density = { &caller_of_density };
    const auto optimize_with = [&](const auto& quadrature)
    {
      CGAL::odt_optimize_mesh_3(c3t3, domain, params::number_of_rounds = 0, params::density = density,
                                params::quadrature = quadrature, params::max_iteration_number = 20,
                                params::do_remove_slivers = false);
    };
    const auto optimize = [&]
    {
      has_points_in_cells ? optimize_with(CGAL::Four_point_rule_3()) : optimize_with(CGAL::Linear_density_rule_3());
    };
    optimize();
    check::that(!caller.is_other && !caller_of_density.is_other, "the density or the domain is called from another thread");
    // Again, so that it fails half way.
    caller_of_density.calls_left = (Caller::most_calls - caller_of_density.calls_left) / 2;
    fails_without_a_trace("density", c3t3, input, optimize);
  }
}

// Counts the calls and iterations, all from the thread that has made it.
struct Visitor
{
  Caller* caller;
  int* calls;

  void count() const
  {
    caller->check();
    ++*calls;
  }
  void after_compute_moves() const { count(); }
  void after_move_points() const { count(); }
  void after_rebuild_restricted_delaunay() const { count(); }
  void end_of_iteration(int) const { count(); }
  void after_sliver_removal(std::size_t) const { count(); }
};

// The work is that of the caller's arena, and callback and visitor are called from the thread that calls, the callback not while it
// runs, even if it waits for threads.
static void in_an_arena(const std::string& mesh, const Domain& domain, Caller& caller, std::atomic<int>& arenas,
                        const Coordinates& expected)
{
  tbb::global_control control(tbb::global_control::max_allowed_parallelism, 4);
  for(int threads : { 1, 3 })
  {
    arenas = 0;
    tbb::task_arena arena(threads);
    arena.execute([&]
    {
      C3t3 c3t3 = read<C3t3>(mesh);
      caller.start_over();
      Caller caller_of_callback, caller_of_visitor;
      int calls = 0, callbacks = 0, running = 0, most_running = 0;
      const Visitor visitor = { &caller_of_visitor, &calls };
      CGAL::odt_optimize_mesh_3(c3t3, domain, params::number_of_rounds = 1, params::domain_is_thread_safe = true,
                                params::visitor(visitor), params::callback([&](double)
                                {
                                  caller_of_callback.check();
                                  ++callbacks;
                                  most_running = (std::max)(most_running, ++running);
                                  tbb::parallel_for(0, 16, [](int) { std::this_thread::sleep_for(std::chrono::microseconds(200)); });
                                  --running;
                                  return true;
                                }));
      check::that(calls > 0 && callbacks > 0 && !caller_of_visitor.is_other && !caller_of_callback.is_other,
                  "callback or visitor are called from another thread, or not at all");
      check::that(most_running == 1, "the callback is called while it runs");
      check::that(coordinates(c3t3) == expected, "in an arena of ", threads, " the mesh becomes another one");
    });
    check::that(arenas == 1 << threads, "threads of another arena work than that of the caller, of ", threads);
    check::that(threads > 1 || !caller.is_other, "an arena of one thread gets more");
  }
}

// A domain that is said to be safe is asked by several threads.
static void safe_domain(const C3t3& input, const Domain& domain, Caller& caller)
{
  tbb::global_control control(tbb::global_control::max_allowed_parallelism, 4);
  C3t3 c3t3 = input;
  const auto optimize = [&]
  {
    CGAL::odt_optimize_mesh_3(c3t3, domain, params::number_of_rounds = 1, params::domain_is_thread_safe = true);
  };
  caller.start_over();
  caller.milliseconds_to_wait = 20000;
  optimize();
  check::that(caller.is_other, "a domain that is safe is asked by one thread");
  const long needed = Caller::most_calls - caller.calls_left;
  for(long share : { 4, 2 })
  {
    caller.calls_left = needed / share;
    fails_without_a_trace("domain", c3t3, input, optimize);
  }
}

int main()
{
  Caller caller;
  bool is_meshing = true;   // which is the business of CGAL's threads
  std::atomic<int> arenas{0};   // a bit for each number of threads in an arena from which the domain is asked
  const auto label = [&](const Point_3& p)
  {
    if(!is_meshing)
    {
      caller.check();
      arenas |= 1 << (std::min)(tbb::this_task_arena::max_concurrency(), 30);
    }
    return squared(p) < 1 ? 1 : 0;
  };
  const Domain domain(label, Kernel::Sphere_3(CGAL::ORIGIN, 4.));
  // Cut into eight pieces: many vertices stay, and with them cells that have all vertices on the boundary.
  const auto piece = [&](const Point_3& p) { return label(p) == 0 ? 0 : 1 + (p.x() > 0.1) + 2 * (p.y() > 0.1) + 4 * (p.z() > 0.1); };
  const Domain pieces(piece, Kernel::Sphere_3(CGAL::ORIGIN, 4.));
  const auto mesh_of = [&](const Domain& domain, double size)
  {
    const Criteria criteria(params::facet_angle = 25, params::facet_size = size, params::facet_distance = size / 10,
                            params::cell_radius_edge_ratio = 2, params::cell_size = size);
    is_meshing = true;
    const C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::no_exude());
    is_meshing = false;
    std::cout << c3t3.triangulation().number_of_vertices() << " vertices, " << c3t3.number_of_cells_in_complex() << " cells"
              << std::endl;
    return c3t3;
  };
  const auto mesh_with = [&](double size) { return mesh_of(domain, size); };
  const auto stored = [](const C3t3& c3t3)
  {
    std::ostringstream stream;
    CGAL::IO::save_binary_file(stream, c3t3);
    return stream.str();
  };
  const C3t3 c3t3 = mesh_with(0.09), large = mesh_with(0.05);
  check::that(c3t3.number_of_cells_in_complex() > 24000, "too few cells for several threads to have something to do");
  check::that(CGAL::Global_odt_mesh_3::internal::Block_annealing_3::usual_number_of_blocks(
                large.triangulation().number_of_vertices()) > 1, "too few vertices for a search in blocks");
  const Coordinates expected = same_for_all_threads(stored(c3t3), domain, { 2, 3, 8 }),
                    expected_of_large = same_for_all_threads(stored(large), domain, { 3 });
  // By one thread, as the mesher of several is not what is tested.
  const auto mesh_by_one_thread = [&](const Domain& domain, double size)
  {
    tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
    return mesh_of(domain, size);
  };
  const std::string mesh_of_pieces = stored(mesh_by_one_thread(pieces, 0.15));
  const Coordinates expected_of_pieces = same_for_all_threads(mesh_of_pieces, pieces, { 2, 8 });
  users_are_called_from_one_thread(c3t3, domain, caller);
  // From here on, other threads may ask.
  check::that(optimized<C3t3>(stored(c3t3), domain, 8, true) == expected
              && optimized<C3t3>(stored(large), domain, 3, true) == expected_of_large, "threads that ask the domain lead elsewhere");
  for(std::size_t threads : { 2, 4, 8 })
    check::that(optimized<C3t3>(mesh_of_pieces, pieces, threads, true) == expected_of_pieces,
                threads, " threads that ask a domain of several pieces lead elsewhere");
  in_an_arena(stored(c3t3), domain, caller, arenas, expected);
  safe_domain(c3t3, domain, caller);
  return check::result();
}
