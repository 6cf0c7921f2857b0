// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The way from one valid snapshot of a complex to the next: what fails or throws on the way leaves no trace, vertices
// that need not go back do not, and a share of the time that is over when it begins is used up.

#include "check.h"
#include "mesh_domains.h"
#include "opened_complex.h"

#include <CGAL/Global_odt_mesh_3/internal/Iteration_control.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_updater_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Sliver_removal_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

// Memory that can be made to run out.
static long allocations = 0, allocations_left = -1;

void* operator new(std::size_t size)
{
  ++allocations;
  if(allocations_left >= 0 && allocations_left-- == 0)
    throw std::bad_alloc();
  void* const p = std::malloc(size);
  if(p == nullptr)
    throw std::bad_alloc();
  return p;
}

void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

using namespace CGAL::Global_odt_mesh_3::internal;
using domains::Labeled_c3t3;
using domains::Labeled_domain;
using domains::Point_3;

typedef Opened_complex<Labeled_c3t3, Labeled_domain> Opened;

// A ball with a smaller one inside, whose label function can be made to fail.
struct Fallible_ball
{
  enum Failure { NONE, THROW, SAY_OUTSIDE };

  Failure failure = NONE;
  long questions = 0, fails_after = 0;

  Labeled_domain domain()
  {
    return domains::labeled([this](const Point_3& p)
    {
      const bool fails = ++questions > fails_after && failure != NONE;
      if(fails && failure == THROW)
        throw std::runtime_error("the domain fails");
      const double d = domains::squared(p);
      return fails ? 0 : d < 0.16 ? 2 : d < 1 ? 1 : 0;
    });
  }

  void fail(Failure how, long after)
  {
    failure = how;
    questions = 0;
    fails_after = after;
  }
};

// The vertices, sorted, and the subdomain of each cell, and the number of its facets on surfaces.
static std::vector<std::array<int, 6> > labelled_cells(const Labelled_triangulation_3& tr)
{
  std::vector<std::array<int, 6> > cells;
  for(int c : tr.cells())
  {
    const std::array<int, 4> q = sorted(tr.vertices(c));
    int on_surface = 0;
    for(int i = 0; i < 4; ++i)
      on_surface += tr.is_in_complex(Half_facet(c, i));
    cells.push_back({{ q[0], q[1], q[2], q[3], tr.label(c), on_surface }});
  }
  std::sort(cells.begin(), cells.end());
  return cells;
}

// All that a snapshot and its triangulation say, in numbers.
static std::vector<double> contents(Complex_updater_3& complex)
{
  const Complex_snapshot_3& snapshot = complex.snapshot();
  const Labelled_triangulation_3& tr = snapshot.triangulation;
  std::vector<double> c = { double(snapshot.is_input) };
  for(const Site& s : snapshot.sites())
    c.insert(c.end(), { s.x, s.y, s.z, s.weight });
  for(const auto& center : snapshot.centers)
    c.insert(c.end(), { center.point[0], center.point[1], center.point[2], double(center.is_exact) });
  for(const Boundary_facet& f : snapshot.boundary.complex().facets())
    c.insert(c.end(), { double(f.vertices[0]), double(f.vertices[1]), double(f.vertices[2]), double(f.labels[0]),
                        double(f.labels[1]), double(f.patch) });
  for(int v = 0; v < snapshot.numbering->number_of_movable_vertices; ++v)
  {
    const Site& s = tr.sites()[v];
    c.insert(c.end(), { s.x, s.y, s.z });
  }
  for(const auto& cell : labelled_cells(tr))
    c.insert(c.end(), cell.begin(), cell.end());
  for(Half_facet f : find_boundary_facets(snapshot, Thread_policy()))
    for(Half_facet g : { f, tr.mirror(f) })
    {
      const Triple vertices = tr.facet_vertices(g);
      c.insert(c.end(), vertices.begin(), vertices.end());
      c.push_back(tr.is_in_complex(g));
    }
  return c;
}

// Positions a bit away from those of the snapshot; tangential on surfaces.
static std::vector<Site> displaced(const Complex_snapshot_3& snapshot, double amount, unsigned int seed)
{
  Random_source random(seed);
  std::vector<Site> sites = snapshot.sites();
  for(int v = 0; v < snapshot.numbering->number_of_movable_vertices; ++v)
  {
    Vector_3 by = amount * random.uniform() * random.direction();
    if(!snapshot.numbering->is_interior(v))
    {
      const Vector_3& n = snapshot.boundary.shape(v, 0).normal;
      by -= n.dot(by) * n;
    }
    sites[v] = site_at(position(sites[v]) + by, sites[v].weight);
  }
  return sites;
}

static std::unique_ptr<Opened> load(const Labeled_c3t3& c3t3, const Labeled_domain& domain)
{
  return std::make_unique<Opened>(c3t3, domain, true);
}

// A snapshot is what it was before a call of advance() that fails or throws, and the next call leads where it
// would have led without that one.
static void failures_leave_no_trace(Fallible_ball& ball, const Labeled_domain& domain, const Labeled_c3t3& c3t3)
{
  for(unsigned int seed : { 3, 4 })
  {
    std::cout << "seed of displacements: " << seed << std::endl;
    ball.fail(Fallible_ball::NONE, 0);
    const std::unique_ptr<Opened> opened = load(c3t3, domain), undisturbed = load(c3t3, domain);
    for(Complex_updater_3* c : { &opened->complex, &undisturbed->complex })
      check::that(c->advance(displaced(c->snapshot(), 0.02, seed), false), "a small displacement leads to no valid complex");
    const std::vector<double> before = contents(opened->complex);
    const std::vector<Site> target = displaced(opened->complex.snapshot(), 0.02, seed + 10);
    for(long after : { 0, 20, 100, 500, 1500, 3000 })
    {
      bool is_done = false, has_thrown = false;
      ball.fail(Fallible_ball::THROW, after);
      try { is_done = opened->complex.advance(target, true); }
      catch(const std::runtime_error&) { has_thrown = true; }
      check::that(has_thrown && !is_done, "the domain was not asked ", after, " times: the test is too weak");
      check::that(contents(opened->complex) == before, "an exception has changed the snapshot");
    }
    ball.fail(Fallible_ball::SAY_OUTSIDE, 0);
    check::that(!opened->complex.advance(target, true), "a complex was made of a domain that is empty");
    check::that(contents(opened->complex) == before, "a failure has changed the snapshot");

    ball.fail(Fallible_ball::NONE, 0);
    for(Complex_updater_3* c : { &opened->complex, &undisturbed->complex })
      check::that(c->advance(target, true), "a small displacement leads to no valid final complex");
    check::that(contents(opened->complex) == contents(undisturbed->complex), "failures have changed what follows");
  }
}

// Where surfaces meet, the planes at vertices tell the wrong side of some dual points. No vertex of the interior goes
// back for that.
static void misleading_planes()
{
  const Labeled_domain domain = domains::three_subdomains();
  const std::unique_ptr<Opened> opened = load(domains::mesh(domain, 0.2), domain);
  const std::vector<Site> target = displaced(opened->complex.snapshot(), 1e-7, 1);
  check::that(opened->complex.advance(target, false), "a tiny displacement leads to no valid complex");
  for(int v = 0; v < opened->complex.snapshot().numbering->number_of_interior_vertices; ++v)
    check::that(same_place(opened->complex.snapshot().sites()[v], target[v]), "vertex ", v, " has gone back without need");
}

// A snapshot whose trials are given up, or have moved nothing, is as it was: the triangulation that it has lent is found again, with its
// labels and patches. To adopt trials, the domain need not be asked.
static void triangulations_are_restored(Fallible_ball& ball, const Labeled_domain& domain, const Labeled_c3t3& c3t3)
{
  ball.fail(Fallible_ball::NONE, 0);
  const std::unique_ptr<Opened> opened = load(c3t3, domain);
  for(bool is_input : { true, false })
  {
    if(!is_input)
      check::that(opened->complex.advance(displaced(opened->complex.snapshot(), 0.02, 5), true),
                  "a small displacement leads to no valid complex");
    const std::vector<double> before = contents(opened->complex);
    const auto remove_slivers = [&](Editable_complex_3& complex)
    {
      Sliver_removal_3 removal(complex, Sliver_steps::last(30), 1);
      removal.raise_angles(100000, [] { return true; });
      check::that(removal.number_of_moves() > 5, "there are no slivers: the test is too weak");
    };
    {
      Editable_complex_3 given_up = opened->complex.edit();
      remove_slivers(given_up);
    }
    check::that(contents(opened->complex) == before, "trials that are given up change the complex");
    Editable_complex_3 unchanged = opened->complex.edit();
    check::that(opened->complex.adopt(unchanged) && contents(opened->complex) == before, "no trials change the complex");
    Editable_complex_3 complex = opened->complex.edit();
    remove_slivers(complex);
    ball.fail(Fallible_ball::SAY_OUTSIDE, 0);
    check::that(opened->complex.adopt(complex) && contents(opened->complex) != before, "trials that the domain has agreed to are not adopted");
    ball.fail(Fallible_ball::NONE, 0);
  }
}

// The same for the whole call.
static void exceptions_leave_the_mesh(Fallible_ball& ball, const Labeled_domain& domain, const Labeled_c3t3& input)
{
  Labeled_c3t3 c3t3(input);
  const auto points = [](const Labeled_c3t3& c)
  {
    std::vector<Point_3> p;
    for(auto v = c.triangulation().finite_vertices_begin(); v != c.triangulation().finite_vertices_end(); ++v)
      p.push_back(v->point().point());
    return p;
  };
  const auto before = points(c3t3);
  for(long after : { 0, 100, 1000, 3000 })
  {
    ball.fail(Fallible_ball::THROW, after);
    bool has_thrown = false;
    try { CGAL::odt_optimize_mesh_3(c3t3, domain); }
    catch(const std::runtime_error&) { has_thrown = true; }
    check::that(has_thrown, "the domain was not asked ", after, " times: the test is too weak");
    check::that(points(c3t3) == before && c3t3.is_valid(), "an exception has changed the mesh");
  }
}

// A stage gets its share of the time, from when it begins to where the share ends; if that is
// over already, nothing is left of it, so that noise that is to fade away in it has faded away.
static void shares_of_time()
{
  Optimization_visitor visitor;
  Odt_parameters parameters;
  const Iteration_control unlimited(parameters, visitor);
  check::that(unlimited.progress_between(0.2, 0.65) == 0, "time passes without a limit");
  Odt_parameters long_time;
  long_time.time_limit = 1e9;
  const Iteration_control limited(long_time, visitor);
  check::that(limited.progress_between(0, 0.65) < 1e-3, "time passes too fast");
  for(double begin : { 0.65, 0.7, 1.2 })
    check::that(limited.progress_between(begin, 0.65) == 1, "a share of the time that has passed is not used up");
}

// All of a mesh that may be harmed.
static std::vector<double> contents(const Labeled_c3t3& c3t3)
{
  const auto& tr = c3t3.triangulation();
  std::vector<double> c = { double(c3t3.number_of_cells_in_complex()), double(c3t3.number_of_facets_in_complex()),
                            double(tr.tds().number_of_cells()) };
  for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
    c.insert(c.end(), { tr.point(v).x(), tr.point(v).y(), tr.point(v).z(), double(v->in_dimension()) });
  for(auto h = tr.all_cells_begin(); h != tr.all_cells_end(); ++h)
  {
    c.push_back(double(h->subdomain_index()));
    for(int i = 0; i < 4; ++i)
      c.insert(c.end(), { double(h->vertex(i)->time_stamp()), double(h->neighbor(i)->time_stamp()),
                          double(h->is_facet_on_surface(i)) });
  }
  return c;
}

// Where memory runs out, the mesh is as before, also if that happens while the result is written.
static void memory_runs_out(const Labeled_c3t3& input, const Labeled_domain& domain, bool inserts)
{
  const auto optimize = [&](Labeled_c3t3& c3t3)
  {
    CGAL::odt_optimize_mesh_3(c3t3, domain, CGAL::parameters::max_iteration_number = 30,
                              CGAL::parameters::do_insert_vertices = inserts);
  };
  Labeled_c3t3 optimized(input);
  const long before = allocations;
  optimize(optimized);
  check::that(inserts == (optimized.triangulation().number_of_vertices() > input.triangulation().number_of_vertices()),
              "vertices are inserted, or not, against what is wanted: the test is too weak");
  const long all = allocations - before;
  std::cout << all << " allocations in a call" << std::endl;
  std::vector<long> lasts;
  for(long n = 0; n < 12; ++n)
    lasts.push_back(all * n / 12);
  for(long n = 1; n < 400; n += n < 40 ? 1 : 40)
    lasts.push_back(all - n);
  int failures = 0;
  for(long last : lasts)
  {
    Labeled_c3t3 c3t3(input);
    const std::vector<double> contents_before = contents(c3t3);
    bool throws = false;
    try
    {
      allocations_left = last;
      optimize(c3t3);
      allocations_left = -1;
    }
    catch(const std::bad_alloc&)
    {
      allocations_left = -1;
      throws = true;
    }
    failures += throws;
    check::that(contents(c3t3) == (throws ? contents_before : contents(optimized)) && c3t3.triangulation().is_valid(),
                "memory for ", last, " of ", all, " allocations harms the mesh");
  }
  check::that(failures > int(lasts.size()) / 2, "memory runs out in ", failures, " calls only");
}

// A visitor whose calls can be counted, and one of them made to fail.
template <class C3t3>
struct Fallible_visitor
{
  // The member functions that may throw without an effect on the mesh, and those that are called when it is final.
  enum Function { AFTER_COMPUTE_MOVES, AFTER_MOVE_POINTS, END_OF_ITERATION, BEFORE_VERTEX_REMOVAL, FIRST_OF_FINAL,
                  AFTER_SLIVER_REMOVAL = FIRST_OF_FINAL, AFTER_REBUILD, NUMBER_OF_FUNCTIONS };

  std::array<long, NUMBER_OF_FUNCTIONS> calls = {{ 0, 0, 0, 0, 0, 0 }};
  int fails_in = NUMBER_OF_FUNCTIONS;
  long fails_after = 0;

  void after_compute_moves() { called(AFTER_COMPUTE_MOVES); }
  void after_move_points() { called(AFTER_MOVE_POINTS); }
  void end_of_iteration(int) { called(END_OF_ITERATION); }
  void before_vertex_removal(typename C3t3::Triangulation::Vertex_handle) { called(BEFORE_VERTEX_REMOVAL); }
  void after_sliver_removal(std::size_t) { called(AFTER_SLIVER_REMOVAL); }
  void after_rebuild_restricted_delaunay() { called(AFTER_REBUILD); }

  void called(int function)
  {
    if(calls[function]++ == fails_after && function == fails_in)
      throw std::runtime_error("the visitor fails");
  }
};

// Whichever function of a visitor throws, in its first call, its last, or one between: the mesh is as before, or, where it was
// final already, optimized.
static void visitors_fail(const Labeled_c3t3& input, const Labeled_domain& domain)
{
  typedef Fallible_visitor<Labeled_c3t3> Visitor;
  const auto optimize = [&](Labeled_c3t3& c3t3, Visitor& visitor)
  {
    CGAL::odt_optimize_mesh_3(c3t3, domain, CGAL::parameters::max_iteration_number = 30,
                              CGAL::parameters::do_insert_vertices = true, CGAL::parameters::do_remove_vertices = true,
                              CGAL::parameters::visitor(std::ref(visitor)));
  };
  Labeled_c3t3 optimized(input);
  Visitor counting;
  optimize(optimized, counting);
  // The time stamps of a copy need not be those of the original.
  const std::vector<double> before = contents(Labeled_c3t3(input)), after = contents(optimized);
  for(int function = 0; function < Visitor::NUMBER_OF_FUNCTIONS; ++function)
  {
    const long calls = counting.calls[function];
    check::that(calls > 0, "a function of the visitor, ", function, ", is not called: the test is too weak");
    for(long failing : { 0L, calls / 2, calls - 1 })
    {
      Visitor visitor;
      visitor.fails_in = function;
      visitor.fails_after = failing;
      Labeled_c3t3 c3t3(input);
      bool throws = false;
      try { optimize(c3t3, visitor); }
      catch(const std::runtime_error&) { throws = true; }
      check::that(throws, "the visitor's exception is lost");
      check::that(contents(c3t3) == (function < Visitor::FIRST_OF_FINAL ? before : after) && c3t3.triangulation().is_valid(),
                  "a visitor that throws in its function ", function, ", call ", failing, ", harms the mesh");
    }
  }
}

// Where memory runs out while a point is inserted, triangulations that are built later are not harmed. CGAL
// fills holes with the help of a table that outlives the call.
static void memory_runs_out_in_a_triangulation()
{
  const unsigned int seed = 9;
  std::cout << "seed of points: " << seed << std::endl;
  Random_source random(seed);
  std::vector<Weighted_point> points;
  for(int n = 0; n < 100; ++n)
    points.emplace_back(Point_3(random.uniform(), random.uniform(), random.uniform()), 0);
  const auto build = [&points](Exact_triangulation_3& tr)
  {
    for(const auto& p : points)
      tr.insert(p);
  };
  bool is_enough = false;
  long last = 0;
  for(; !is_enough; ++last)
  {
    Exact_triangulation_3 lacking, later;
    allocations_left = last;
    try
    {
      build(lacking);
      is_enough = true;
    }
    catch(const std::bad_alloc&) {}
    allocations_left = -1;
    build(later);
    check::that(later.is_valid() && later.number_of_vertices() == points.size(),
                "memory for ", last, " allocations harms what comes after");
  }
  check::that(last > 20, "memory runs out at ", last, " places only");
}

int main()
{
  memory_runs_out_in_a_triangulation();
  // Where cells with small angles remain that no move helps.
  const CGAL::Image_3 image = domains::labeled_image();
  const Labeled_domain of_image = domains::labeled_image_domain(image);
  Fallible_ball ball;
  const Labeled_domain domain = ball.domain();
  const Labeled_c3t3 c3t3 = domains::mesh(domain, 0.2);
  failures_leave_no_trace(ball, domain, c3t3);
  triangulations_are_restored(ball, domain, c3t3);
  exceptions_leave_the_mesh(ball, domain, c3t3);
  misleading_planes();
  shares_of_time();
  ball.fail(Fallible_ball::NONE, 0);
  memory_runs_out(c3t3, domain, false);
  const Labeled_c3t3 meshed_image = domains::mesh(of_image, 0.15);
  memory_runs_out(meshed_image, of_image, true);
  visitors_fail(meshed_image, of_image);
  return check::result();
}
