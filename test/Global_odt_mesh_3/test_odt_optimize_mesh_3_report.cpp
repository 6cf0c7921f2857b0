// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A call tells what it has done, and no call is stuck: bodies that are stretched step by step, domains that are another's, calls
// that are ended at once, meshes with nothing to do.

#include "../../examples/Global_odt_mesh_3/complex_of_medit_mesh.h"
#include "check.h"
#include "mesh_domains.h"
#include "structured_box.h"

#include <CGAL/Mesh_optimization_report_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Random.h>
#include <CGAL/Real_timer.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/property_map.h>
#include <CGAL/remove_slivers_mesh_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace params = CGAL::parameters;
using domains::Labeled_c3t3;
using domains::Labeled_domain;
using domains::Point_3;
typedef CGAL::Mesh_optimization_report_3<Labeled_c3t3> Report;
typedef Labeled_c3t3::Vertex_handle Vertex_handle;
typedef Labeled_c3t3::Cell_handle Cell_handle;

static std::vector<Point_3> points(const Labeled_c3t3& c3t3)
{
  std::vector<Point_3> result;
  for(auto v = c3t3.triangulation().finite_vertices_begin(); v != c3t3.triangulation().finite_vertices_end(); ++v)
    result.push_back(v->point().point());
  return result;
}

static double smallest_angle(Cell_handle c)
{
  const auto p = [c](int i) { return c->vertex(i)->point().point(); };
  double result = 180;
  for(int i = 0; i < 3; ++i)
    for(int j = i + 1; j < 4; ++j)
    {
      const int k = i == 0 ? (j == 1 ? 2 : 1) : 0, l = 6 - i - j - k;
      result = (std::min)(result, std::abs(CGAL::approximate_dihedral_angle(p(i), p(j), p(k), p(l))));
    }
  return result;
}

// How many cells are in another subdomain than their dual point is.
static std::size_t wrong_cells(const Labeled_c3t3& c3t3, const Labeled_domain& domain)
{
  std::size_t wrong = 0;
  for(auto c = c3t3.triangulation().finite_cells_begin(); c != c3t3.triangulation().finite_cells_end(); ++c)
  {
    const auto label = domain.is_in_domain_object()(c3t3.triangulation().dual(c));
    wrong += (label ? *label : 0) != (c3t3.is_in_complex(c) ? c3t3.subdomain_index(c) : 0);
  }
  return wrong;
}

// Two subdomains, stretched by exp(t) along one axis at constant volume.
static Labeled_domain stretched_body(double t)
{
  const double e = std::exp(t);
  return domains::labeled([e](const Point_3& p)
  {
    const double r = e * (p.x() * p.x() + p.y() * p.y()) + p.z() * p.z() / (e * e);
    return r < 0.25 ? 2 : r < 0.8 ? 1 : 0;
  });
}

static void stretch(Labeled_c3t3& c3t3, double step)
{
  const double e = std::exp(step);
  auto& tr = c3t3.triangulation();
  for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
  {
    const Point_3 p = v->point().point();
    v->set_point(Labeled_c3t3::Triangulation::Weighted_point(Point_3(p.x() / std::sqrt(e), p.y() / std::sqrt(e), p.z() * e)));
  }
  for(auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
    c->invalidate_weighted_circumcenter_cache();
}

// Optimized after each step; no two calls in a row do nothing, and what they make is valid.
static void check_stretched(double step, int steps, unsigned int seed, bool selects_half = false)
{
  Labeled_c3t3 c3t3 = domains::mesh(stretched_body(0), 0.16);
  const std::size_t vertices = c3t3.triangulation().number_of_vertices();
  bool was_unchanged = false;
  double smallest = 180;
  for(int n = 1; n <= steps; ++n)
  {
    if(n > 1)
      stretch(c3t3, step);
    const Labeled_domain domain = stretched_body((n - 1) * step);
    Report report;
    std::set<Cell_handle> selected;
    for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
      if(!selects_half || c->vertex(0)->point().x() > 0)
        selected.insert(c);
    CGAL::odt_optimize_mesh_3(c3t3, domain, params::random_seed(seed), params::optimization_report = std::ref(report),
                              params::cell_is_selected_map(CGAL::Boolean_property_map<std::set<Cell_handle> >(selected)));
    const std::string name = "body stretched by " + std::to_string(step) + (selects_half ? ", half of it selected" : "") + ", step "
                             + std::to_string(n) + ", seed " + std::to_string(seed);
    check::that(report.is_changed() || !was_unchanged, name, ": two calls in a row do nothing");
    was_unchanged = !report.is_changed();
    check::that(c3t3.triangulation().number_of_vertices() == vertices, name, ": vertices are lost");
    if(!report.is_changed())
      continue;
    check::that(c3t3.triangulation().is_valid() && wrong_cells(c3t3, domain) == 0, name, ": the mesh is not valid");
    smallest = (std::min)(smallest, CGAL::mesh_quality_report_3(c3t3).smallest_angle);
  }
  std::cout << "body stretched by " << step << " " << steps << " times, seed " << seed << ": smallest angle " << smallest << std::endl;
  check::that(selects_half || smallest > 20, "body stretched by ", step, ": smallest angle ", smallest);
}

// One half of a deformed mesh is selected: cells of the other half are there afterwards, or are named.
static void check_selected_half()
{
  Labeled_c3t3 c3t3 = domains::mesh(stretched_body(0), 0.16);
  stretch(c3t3, 0.1);
  const Labeled_domain domain = stretched_body(0.1);
  std::set<Cell_handle> selected;
  std::vector<std::array<Vertex_handle, 4> > kept;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    if(c->vertex(0)->point().x() > 0)
      selected.insert(c);
    else
      kept.push_back({{ c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3) }});
  Report report;
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::optimization_report = std::ref(report),
                            params::cell_is_selected_map(CGAL::Boolean_property_map<std::set<Cell_handle> >(selected)));
  std::size_t gone = 0;
  Cell_handle c;
  for(const auto& v : kept)
    gone += !c3t3.triangulation().is_cell(v[0], v[1], v[2], v[3], c);
  std::cout << "half of a deformed body: " << report.released_cells.size() << " of " << kept.size() << " cells could not stay" << std::endl;
  check::that(report.is_changed() && c3t3.triangulation().is_valid(), "half of a deformed body: reason ", int(report.reason));
  check::that(gone <= report.released_cells.size() && report.released_cells.size() < kept.size(), "half of a deformed body: ", gone,
              " cells are gone, and ", report.released_cells.size(), " of ", kept.size(), " are named");
}

static void check_wrong_domain()
{
  Labeled_c3t3 c3t3 = domains::mesh(domains::sphere(), 0.3);
  const std::vector<Point_3> before = points(c3t3);
  const Labeled_domain reversed = domains::labeled([](const Point_3& p) { return domains::squared(p) < 1 ? 0 : 1; });
  bool is_refused = false;
  const CGAL::Failure_behaviour old = CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
  try
  {
    CGAL::odt_optimize_mesh_3(c3t3, reversed);
  }
  catch(const CGAL::Precondition_exception& e)
  {
    is_refused = e.message().find("domain must be that of the mesh") != std::string::npos;
  }
  CGAL::set_error_behaviour(old);
  check::that(is_refused && points(c3t3) == before, "a domain with its sign reversed is not refused");
}

struct Last_calls
{
  std::size_t slivers = std::size_t(-1);
  int rebuilt = 0;

  void after_compute_moves() {}
  void after_move_points() {}
  void after_rebuild_restricted_delaunay() { ++rebuilt; }
  void end_of_iteration(int) {}
  void after_sliver_removal(std::size_t n) { slivers = n; }
};

// What is told of calls that end in different ways.
static void check_reasons()
{
  const Labeled_domain domain = domains::sphere();
  const Labeled_c3t3 input = domains::mesh(domain, 0.12);
  CGAL::Real_timer timer;

  Labeled_c3t3 c3t3(input);
  Report report;
  timer.start();
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::optimization_report = std::ref(report));
  timer.stop();
  const double time_of_call = timer.time();
  const CGAL::Mesh_quality_report_3 quality = CGAL::mesh_quality_report_3(c3t3, { 20. });
  double seconds = 0;
  for(const auto& s : report.seconds)
    seconds += s.second;
  check::that(report.is_changed() && report.number_of_iterations > 10 && report.number_of_slivers == quality.cells_below[0].second
              && report.sliver_bound == 20, "the report of a default call: ", report);
  check::that(std::abs(report.largest_volume_change) < 0.02 && report.largest_volume_change != 0 && report.farthest_facet > 0
              && report.farthest_facet < 0.05 && seconds > 0 && seconds < 1.01 * time_of_call, "the report's measures: ", report);
  std::ostringstream printed;
  printed << report;
  const std::string text = printed.str();
  check::that(text.find("mesh changed") == 0 && std::count(text.begin(), text.end(), '\n') <= 5, "a report is printed as ", text);

  // Nothing to do.
  const std::vector<Point_3> before = points(c3t3);
  Last_calls last;
  const auto code = CGAL::remove_slivers_mesh_3(c3t3, domain, params::sliver_bound = 20, params::optimization_report = std::ref(report),
                                                params::visitor(std::ref(last)));
  check::that(report.reason == Report::NOTHING_TO_DO && code == CGAL::CONVERGENCE_REACHED && points(c3t3) == before && last.rebuilt == 1
              && last.slivers == 0, "a mesh without slivers: ", report);

  // One who says no at once has the mesh as it was, and soon.
  c3t3 = input;
  int calls = 0;
  timer.reset();
  timer.start();
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::callback([&calls](double) { ++calls; return false; }),
                            params::optimization_report = std::ref(report));
  timer.stop();
  check::that(report.reason == Report::OUT_OF_TIME && calls == 1 && points(c3t3) == points(input), "a call that is ended at once: ", report);
  check::that(timer.time() < 0.2 * time_of_call + 0.05, "a call that is ended at once takes ", timer.time(), " s of ", time_of_call);

  // Vertices that are inserted are counted, and there are fewer questions than edges.
  calls = 0;
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_insert_vertices = true, params::do_remove_vertices = true, params::sizing_field = 0.09,
                            params::number_of_rounds = 1, params::callback([&calls](double) { return ++calls > 0; }),
                            params::optimization_report = std::ref(report));
  const std::size_t vertices = c3t3.triangulation().number_of_vertices(), were = input.triangulation().number_of_vertices();
  check::that(report.number_of_inserted_vertices > 0 && were + report.number_of_inserted_vertices - report.number_of_removed_vertices == vertices,
              were, " -> ", vertices, " vertices: ", report);
  check::that(std::size_t(calls) < vertices, calls, " questions in a call that inserts ", report.number_of_inserted_vertices, " vertices");
}

// Slivers that are to stay do not count, and only once, however often the mesh is read.
static void check_slivers_that_stay()
{
  const Labeled_domain domain = domains::sphere();
  Labeled_c3t3 c3t3 = domains::mesh(domain, 0.2);
  constexpr double bound = 40;
  std::set<Cell_handle> selected;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    if(c->vertex(0)->point().x() > 0)
      selected.insert(c);
  std::set<std::set<Vertex_handle> > kept;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    if(selected.count(c) == 0)
      kept.insert({ c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3) });
  Last_calls last;
  CGAL::remove_slivers_mesh_3(c3t3, domain, params::sliver_bound = bound, params::visitor(std::ref(last)),
                              params::cell_is_selected_map(CGAL::Boolean_property_map<std::set<Cell_handle> >(selected)));
  std::size_t slivers = 0;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    slivers += smallest_angle(c) < bound && kept.count({ c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3) }) == 0;
  check::that(last.slivers == slivers, last.slivers, " slivers are told of, and ", slivers, " are left");
}

// Sizes of the mesh generator that grow from a corner of a box.
struct Growing_size
{
  typedef double FT;
  typedef domains::Polyhedral_domain::Index Index;
  typedef domains::Point_3 Point_3;

  double operator()(const Point_3& p, int, const Index&) const { return 0.05 + 0.3 * std::sqrt(domains::squared(p)); }
};

// The field with which a mesh with features has been made costs hardly any angle.
static void check_field_near_features()
{
  const domains::Polyhedron polyhedron = domains::notched_box();
  domains::Polyhedral_domain domain(polyhedron);
  domain.detect_features();
  const Growing_size size;
  const domains::Polyhedral_criteria criteria(params::edge_size = size, params::facet_angle = 25, params::facet_size = size,
                                              params::facet_distance = 0.02, params::cell_radius_edge_ratio = 2, params::cell_size = size);
  CGAL::get_default_random() = CGAL::Random(0);
  const auto input = CGAL::make_mesh_3<domains::Polyhedral_c3t3>(domain, criteria, params::no_perturb(), params::no_exude());
  double angle[2] = { 0, 0 }, ratio[2] = { 0, 0 };
  constexpr unsigned int seeds = 3;
  for(unsigned int seed = 0; seed < seeds; ++seed)
    for(bool has_field : { false, true })
    {
      domains::Polyhedral_c3t3 c3t3(input);
      if(has_field)
        CGAL::odt_optimize_mesh_3(c3t3, domain, params::random_seed(seed), params::sizing_field = size);
      else
        CGAL::odt_optimize_mesh_3(c3t3, domain, params::random_seed(seed));
      const CGAL::Mesh_quality_report_3 quality = CGAL::mesh_quality_report_3(c3t3);
      angle[has_field] += quality.smallest_angle / seeds;
      ratio[has_field] += quality.mean_radius_ratio / seeds;
    }
  std::cout << "field near features: smallest angles " << angle[0] << ", " << angle[1] << " with it; 3r/R " << ratio[0] << ", " << ratio[1]
            << std::endl;
  check::that(angle[1] > 0.7 * angle[0] && ratio[1] > ratio[0] - 0.04, "a field makes cells near features worse");
}

// Where spheres pass through more than four vertices, the cells are those that were there.
static void check_structured_box(int cells_in_hexahedron, double angle)
{
  const Medit_mesh mesh = structured_box::mesh(4, cells_in_hexahedron);
  structured_box::C3t3 c3t3;
  const Complex_of_medit_mesh<structured_box::C3t3> complex(mesh, c3t3, 60);
  const structured_box::Domain domain(c3t3);
  const std::size_t cells = c3t3.number_of_cells_in_complex();
  CGAL::remove_slivers_mesh_3(c3t3, domain);
  const double after = CGAL::mesh_quality_report_3(c3t3).smallest_angle;
  check::that(after > angle - 0.01 && c3t3.number_of_cells_in_complex() == cells && c3t3.triangulation().is_valid(), "a box of hexahedra in ",
              cells_in_hexahedron, " cells: ", cells, " -> ", c3t3.number_of_cells_in_complex(), ", smallest angle ", after);
}

int main()
{
  check_wrong_domain();
  check_reasons();
  check_slivers_that_stay();
  for(unsigned int seed = 0; seed < 2; ++seed)
  {
    check_stretched(0.03, 16, seed);
    check_stretched(0.12, 6, seed);
    check_stretched(0.12, 4, seed, true);
  }
  check_selected_half();
  check_field_near_features();
  check_structured_box(5, 54.7);
  check_structured_box(6, 45);
  return check::result();
}
