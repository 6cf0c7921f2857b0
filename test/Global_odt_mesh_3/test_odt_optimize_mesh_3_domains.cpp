// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// On every kind of domain, whatever the mesh, odt_optimize_mesh_3() returns a
// valid complex with the boundary of the input, and better cells; so it does on many small meshes with random sizes.

#include "mesh_contract.h"
#include "mesh_domains.h"
#include "opened_complex.h"
#include "realized_sizes.h"
#include "subdomain_measures.h"

#include <CGAL/Annealing_schedules_3.h>
#include <CGAL/Density_quadratures_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/sizing/Nodal_densities_3.h>
#include <CGAL/IO/File_binary_mesh_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Quadratic_density_3.h>
#include <CGAL/Random.h>
#include <CGAL/odt_energy_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace odt = CGAL::Global_odt_mesh_3::internal;
namespace params = CGAL::parameters;

// No call leaves more cells with small angles than it gets, nor a smaller angle.
template <class C3t3>
void check_not_worse(const std::string& name, const C3t3& before, const C3t3& after)
{
  const std::vector<double> bounds = { 10, 20, 30 };
  const auto q = CGAL::mesh_quality_report_3(before, bounds), p = CGAL::mesh_quality_report_3(after, bounds);
  for(std::size_t n = 0; n < bounds.size(); ++n)
    check::that(p.cells_below[n].second <= q.cells_below[n].second, name, ": ", p.cells_below[n].second, " cells below ", bounds[n],
                " degrees instead of ", q.cells_below[n].second);
  check::that(p.smallest_angle > (std::min)(q.smallest_angle, 30.) - 1e-9, name, ": a smallest angle of ", p.smallest_angle,
              " degrees instead of ", q.smallest_angle);
}

// How far points of surfaces are from them, over the size of the mesh.
static constexpr double surface = 4e-3;

template <class C3t3, class Domain>
void test(const std::string& name, const C3t3& input, const Domain& domain, bool improves = true)
{
  std::cout << name << ": " << input.triangulation().number_of_vertices() << " vertices" << std::endl;
  const Mesh_contract<C3t3, Domain> contract(input, domain, name);
  const auto mean_radius_ratio = [](const C3t3& c3t3) { return CGAL::mesh_quality_report_3(c3t3).mean_radius_ratio; };
  const double before = mean_radius_ratio(input);
  const auto check_improved = [&](const C3t3& c3t3)
  {
    const double after = mean_radius_ratio(c3t3);
    std::cout << "  mean 3r/R " << before << " -> " << after << std::endl;
    check::that(!improves || after > before + 0.005, name, ": not improved");
    check_not_worse(name, input, c3t3);
    check::that(!improves || Mesh_contract<C3t3, Domain>::points(c3t3) != Mesh_contract<C3t3, Domain>::points(input),
                name, ": nothing moved");
  };

  C3t3 c3t3(input);
  CGAL::odt_optimize_mesh_3(c3t3, domain);
  contract.check_moved(c3t3, surface);
  check_improved(c3t3);
  // Cells get rounder, hence the longest edges shorter.
  const auto edges = median_edges(c3t3);
  for(const auto& before : median_edges(input))
  {
    const double change = edges.at(before.first) / before.second - 1;
    std::cout << "  median edge " << before.second << ", " << 100 * change << " %" << std::endl;
    check::that(change > -0.15 && change < 0.02, name, ": the median edge changes by ", 100 * change, " %");
  }
  const auto radii = largest_circumradii(c3t3);
  for(const auto& before : largest_circumradii(input))
  {
    const double ratio = radii.at(before.first) / before.second;
    std::cout << "  largest circumradius times " << ratio << std::endl;
    check::that(ratio < 1.25, name, ": a cell is larger than all before, by ", ratio);
  }

  C3t3 fixed(input);
  CGAL::odt_optimize_mesh_3(fixed, domain, params::optimize_boundary = false);
  contract.check(fixed);
  check_improved(fixed);

  // To the end, without freezing.
  C3t3 converged(input);
  CGAL::odt_optimize_mesh_3(converged, domain, params::optimize_boundary(false), params::do_freeze = false,
                            params::convergence = 0, params::max_iteration_number = 200);
  contract.check(converged);

  C3t3 searched(input);
  CGAL::odt_optimize_mesh_3(searched, domain, params::number_of_rounds = 4);
  contract.check_moved(searched, surface);
  check_improved(searched);

  // Bit for bit the same, and again on the result.
  C3t3 again(input);
  CGAL::odt_optimize_mesh_3(again, domain);
  check::that((Mesh_contract<C3t3, Domain>::points(again) == Mesh_contract<C3t3, Domain>::points(c3t3)),
              name, ": not deterministic");
  for(int call = 2; call <= 4; ++call)
  {
    const C3t3 once(again);
    CGAL::odt_optimize_mesh_3(again, domain);
    contract.check_moved(again, surface);
    check_not_worse(name + ", call " + std::to_string(call), once, again);
    // No larger cells for nothing.
    const auto radii_of_once = largest_circumradii(once);
    const auto below_30 = [](const C3t3& c) { return CGAL::mesh_quality_report_3(c, { 20, 30 }).cells_below; };
    const auto slivers = below_30(once);
    if(slivers[0].second == 0 && 2 * below_30(again)[1].second >= slivers[1].second)
      for(const auto& after : largest_circumradii(again))
        check::that(after.second <= (slivers[1].second > 0 ? 1.1001 : 1.0001) * radii_of_once.at(after.first),
                    name, ", call ", call, ": a larger cell than before");
  }
}

// Mean edge length between vertices of the interior, by distance from the center.
static std::vector<std::pair<double, int> > edge_length_profile(const domains::Labeled_c3t3& c3t3)
{
  std::vector<std::pair<double, int> > bins(5, { 0., 0 });
  const auto& tr = c3t3.triangulation();
  for(auto e = tr.finite_edges_begin(); e != tr.finite_edges_end(); ++e)
  {
    const auto u = e->first->vertex(e->second), v = e->first->vertex(e->third);
    if(u->in_dimension() != 3 || v->in_dimension() != 3)
      continue;
    const domains::Point_3 m = CGAL::midpoint(u->point().point(), v->point().point());
    auto& bin = bins[(std::min)(4, static_cast<int>(5 * std::sqrt(domains::squared(m))))];
    bin.first += std::sqrt(CGAL::squared_distance(u->point().point(), v->point().point()));
    ++bin.second;
  }
  for(auto& bin : bins)
    bin.first /= (std::max)(1, bin.second);
  return bins;
}

// A uniform mesh is taken for uniform, and a graded one keeps its sizes, however
// long the minimizer runs.
static void grading(const domains::Labeled_domain& domain)
{
  using namespace domains;
  Labeled_c3t3 uniform = mesh(domain, 0.2), graded = graded_mesh(domain, 0.05);
  const auto is_uniform = [&domain](const Labeled_c3t3& c3t3)
  {
    const odt::Opened_complex<Labeled_c3t3, Labeled_domain> opened(c3t3, domain, true);
    return odt::Input_density_3(opened.mesh).is_uniform();
  };
  check::that(is_uniform(uniform), "a uniform mesh is not taken for uniform");
  check::that(!is_uniform(graded), "a graded mesh is taken for uniform");

  const auto before = edge_length_profile(graded);
  const auto check_sizes = [&](const char* name, const auto& quadrature)
  {
    Labeled_c3t3 c3t3(graded);
    CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_freeze = false, params::convergence = 0,
                              params::max_iteration_number = 150, params::quadrature = quadrature);
    const auto after = edge_length_profile(c3t3);
    for(std::size_t n = 0; n < before.size(); ++n)
    {
      if(before[n].second < 50)
        continue;
      std::cout << "  " << name << ": edge length in bin " << n << ": " << before[n].first << " -> " << after[n].first << std::endl;
      check::that(std::abs(after[n].first / before[n].first - 1) < 0.1, name, ": sizes in bin ", n, " changed");
    }
  };
  check_sizes("linear rule", CGAL::Linear_density_rule_3());
  check_sizes("4 points", CGAL::Four_point_rule_3());
}

// Small at the south pole, three times as large at the north pole.
struct Size_by_latitude
{
  typedef domains::FT FT;
  typedef domains::Point_3 Point_3;
  typedef domains::Labeled_domain::Index Index;

  FT operator()(const Point_3& p, int dimension, const Index&) const
  {
    check::that(dimension == 2 || dimension == 3, "the field is asked for a vertex in dimension ", dimension);
    return (std::max)(0.5, 2 + p.z());
  }
};

// From a uniform mesh, vertices go where the sizes want them, or the density that amounts to the
// same; a number asks for a uniform mesh.
static void wanted_sizes(const domains::Labeled_domain& domain)
{
  using namespace domains;
  typedef Mesh_contract<Labeled_c3t3, Labeled_domain> Contract;
  const Labeled_c3t3 input = mesh(domain, 0.16);
  const Contract contract(input, domain, "wanted sizes");
  const Size_by_latitude size;
  const auto optimized = [&](const auto&... np)
  {
    Labeled_c3t3 c3t3(input);
    CGAL::odt_optimize_mesh_3(c3t3, domain, np...);
    contract.check_moved(c3t3, 0.02, 20);       // as sizes change
    return c3t3;
  };
  const Labeled_c3t3 usual = optimized(params::random_seed(0));
  const Labeled_c3t3 sized = optimized(params::sizing_field = size);
  const Labeled_c3t3 dense = optimized(params::density([&](const Point_3& p)
                                       { return std::pow(size(p, 3, Labeled_domain::Index()), -5) / 1000; }));
  const auto slope_of_sizes = [&size](const Labeled_c3t3& c3t3) { return Realized_sizes(c3t3, size, 3).slope; };
  const double before = slope_of_sizes(usual), after = slope_of_sizes(sized);
  const double by_density = slope_of_sizes(dense);
  std::cout << "  slope of sizes: " << before << " -> " << after << ", by density " << by_density << std::endl;
  check::that(std::abs(before) < 0.1, "a uniform mesh is graded");
  check::that(after > 0.5 && after < 1.2, "the sizes are not those wanted");
  check::that(std::abs(after - by_density) < 0.05, "a density leads to other sizes than the sizes that it stands for");
  check::that(Contract::points(optimized(params::sizing_field = 0.3)) == Contract::points(usual),
              "a number leads elsewhere than a uniform mesh");

  // Rules of more points lead to the same sizes, and polynomials, integrated exactly, to the energy of a rule that is exact for
  // them. The search goes other ways each time.
  const Labeled_c3t3 finer = optimized(params::quadrature = CGAL::Four_point_rule_3(), params::sizing_field = size);
  check::that(std::abs(slope_of_sizes(finer) - after) < 0.1, "a rule of four points leads to other sizes");
  const auto quadratic = CGAL::Quadratic_density_3<Kernel>::squared_distance(Point_3(0.3, 0, 0));
  const double exact = CGAL::odt_energy_3(optimized(params::density(quadratic)), params::density(quadratic));
  const double sampled = CGAL::odt_energy_3(optimized(params::quadrature(CGAL::Fifteen_point_rule_3()), params::density(quadratic)),
                                            params::density(quadratic));
  const double ignored = CGAL::odt_energy_3(usual, params::density(quadratic));
  std::cout << "  energy for a quadratic density: uniform " << ignored << ", exact " << exact << ", 15 points " << sampled << std::endl;
  check::that(exact < 0.95 * ignored && std::abs(exact / sampled - 1) < 0.01, "exact integrals lead elsewhere than good ones");

  // A field that is passed by reference is not copied.
  int questions = 0;
  const auto counting = [&questions](const Point_3&, int, const Labeled_domain::Index&) { ++questions; return 1.; };
  optimized(params::sizing_field = std::cref(counting));
  check::that(questions > 0, "a field passed by reference is not asked");
}

// Of holes that are smaller than cells, the mesher finds those with a dual point in them. No vertex may move so that there
// are more.
static void holes()
{
  using namespace domains;
  const int number_of_holes = 300;
  const double radius = 0.04, size = 0.3;
  for(unsigned int seed : { 2, 3 })
  {
    CGAL::Random random(seed);
    std::vector<Point_3> centers;
    for(int n = 0; n < number_of_holes; ++n)
    {
      const double x = random.get_double(-1, 1), y = random.get_double(-1, 1), z = random.get_double(-1, 1);
      centers.emplace_back(x, y, z);
    }
    const Labeled_domain domain = labeled([centers, radius](const Point_3& p)
    {
      const auto is_around = [&](const Point_3& c) { return CGAL::squared_distance(p, c) < radius * radius; };
      return squared(p) < 1 && std::none_of(centers.begin(), centers.end(), is_around) ? 1 : 0;
    });
    CGAL::get_default_random() = CGAL::Random(seed);
    const Labeled_c3t3 input = mesh(domain, size);
    const Mesh_contract<Labeled_c3t3, Labeled_domain> contract(input, domain, "holes, seed " + std::to_string(seed));
    Labeled_c3t3 c3t3(input);
    CGAL::odt_optimize_mesh_3(c3t3, domain);
    contract.check_moved(c3t3, 1e-2);
    c3t3 = input;
    CGAL::odt_optimize_mesh_3(c3t3, domain, params::optimize_boundary = false);
    contract.check(c3t3);
  }
}

// The cells with a dihedral angle below the bound that have a vertex that may move: of dimension 3
// and off the boundary or, if there is none, of dimension 2.
struct Slivers
{
  int with_interior_vertex = 0, with_surface_vertex = 0;

  template <class C3t3>
  Slivers(const C3t3& c3t3, double bound)
  {
    std::set<typename C3t3::Vertex_handle> on_boundary;
    for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
      for(int k = 1; k < 4; ++k)
        on_boundary.insert(f->first->vertex((f->second + k) % 4));
    for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    {
      std::array<odt::Site, 4> s;
      bool has_interior_vertex = false, has_surface_vertex = false;
      for(int i = 0; i < 4; ++i)
      {
        const auto v = c->vertex(i);
        s[i] = odt::weighted_site(c3t3.triangulation().point(v));
        const bool is_weighted = s[i].weight != 0;
        has_interior_vertex = has_interior_vertex
                              || (v->in_dimension() == 3 && !is_weighted && on_boundary.count(v) == 0);
        has_surface_vertex = has_surface_vertex || (v->in_dimension() == 2 && !is_weighted);
      }
      const odt::Cell_shape_3 shape(s[0], s[1], s[2], s[3]);
      if(*std::min_element(shape.angles.begin(), shape.angles.end()) >= bound)
        continue;
      if(has_interior_vertex)
        ++with_interior_vertex;
      else
        with_surface_vertex += has_surface_vertex;
    }
  }
};

// Two vertices that are alone in a ball see all of its surface, and dozens of cells share the edge between them.
template <class C3t3>
static bool has_room(const C3t3& c3t3)
{
  const int few = 4;
  int n = 0;
  for(auto v = c3t3.triangulation().finite_vertices_begin(); v != c3t3.triangulation().finite_vertices_end(); ++v)
    n += c3t3.in_dimension(v) == 3;
  return n >= few;
}

// The search ends where slivers are removed: below the usual bound of 20 degrees there are none in
// the interior and, far below it, none on surfaces. If those are rough, there is hardly any, and worse cells
// there may cost some degrees inside. Near a boundary that is fixed, there is less room.
template <class C3t3>
static void check_slivers(const std::string& what, const C3t3& c3t3, bool surface_moves, bool is_rough)
{
  const Slivers slivers(c3t3, surface_moves ? (is_rough ? 15 : 20) : 10), bad_slivers(c3t3, 10);
  const bool is_clean = slivers.with_interior_vertex <= (is_rough ? 1 : 0);
  check::that(is_clean || !has_room(c3t3), what, ": ", slivers.with_interior_vertex, " slivers in the interior");
  check::that(!surface_moves || bad_slivers.with_surface_vertex <= (is_rough ? 1 : 0), what, ": ",
              bad_slivers.with_surface_vertex, " bad slivers on the surface");
}

// One of some users' habits: the default call, a long run without freezing, few
// iterations, the boundary fixed, a short global search of either kind.
template <class C3t3, class Domain>
static void test_habit(const std::string& name, const C3t3& input, const Domain& domain, unsigned int seed,
                       bool is_rough = false)
{
  const std::string what = name + ", seed " + std::to_string(seed);
  const Mesh_contract<C3t3, Domain> contract(input, domain, what);
  C3t3 c3t3(input);
  switch(seed % 5)
  {
  case 0: CGAL::odt_optimize_mesh_3(c3t3, domain); break;
  case 1: CGAL::odt_optimize_mesh_3(c3t3, domain, params::convergence = 0, params::do_freeze = false,
                                    params::max_iteration_number = 60); break;
  case 2: CGAL::odt_optimize_mesh_3(c3t3, domain, params::max_iteration_number = 2); break;
  case 3: CGAL::odt_optimize_mesh_3(c3t3, domain, params::optimize_boundary = false); break;
  default:
    if(seed % 2 == 0)
      CGAL::odt_optimize_mesh_3(c3t3, domain, params::number_of_rounds = 3, params::random_seed(seed));
    else
      CGAL::odt_optimize_mesh_3(c3t3, domain, params::number_of_rounds = 2,
                                params::annealing_schedule = CGAL::Metropolis_annealing_schedule(),
                                params::random_seed(seed));
  }
  if(seed % 5 == 3)
    contract.check(c3t3);
  else
    contract.check_moved(c3t3, surface);
  check_not_worse(what, input, c3t3);
  if(seed % 5 == 0 || seed % 5 >= 3)
    check_slivers(what, c3t3, seed % 5 != 3, is_rough);
}

// Two hundred seeded small meshes: no crash, no broken promise, the boundary's topology and the volumes as they were, and
// hardly any sliver left.
static void random_meshes()
{
  using namespace domains;
  const unsigned int first_seed = 1000, runs = 200;
  std::cout << "seeds " << first_seed << " to " << first_seed + runs - 1 << std::endl;
  const CGAL::Image_3 labels = labeled_image(), grays = gray_image();
  const Polyhedron box = notched_box();
  const Polyhedral_domain box_domain(box);
  Polyhedral_domain feature_domain(box);
  feature_domain.detect_features();

  for(unsigned int seed = first_seed; seed < first_seed + runs; ++seed)
  {
    std::mt19937 random(seed);
    CGAL::get_default_random() = CGAL::Random(seed);
    const double factor = std::uniform_real_distribution<double>(0.8, 1.6)(random);
    // Labeled domains carry a random generator, hence a new one for each seed.
    const auto labeled_test = [&](const char* name, const Labeled_domain& domain, double size, bool is_rough = false)
    { test_habit(name, mesh(domain, size * factor), domain, seed, is_rough); };
    switch(seed % 9)
    {
    case 0: labeled_test("sphere", sphere(), 0.3); break;
    case 1: labeled_test("torus", torus(), 0.2); break;
    case 2: labeled_test("three subdomains", three_subdomains(), 0.25); break;
    case 3: labeled_test("thin plate", thin_plate(), 0.2); break;
    case 4: labeled_test("labeled image", labeled_image_domain(labels), 0.1, true); break;
    case 5: labeled_test("gray image", gray_image_domain(grays), 0.1); break;
    case 6:
    {
      const Labeled_domain domain = sphere();
      test_habit("graded sphere", graded_mesh(domain, 0.15 * factor), domain, seed);
      break;
    }
    case 7: test_habit("polyhedron", mesh(box_domain, 0.4 * factor, false), box_domain, seed); break;
    default: test_habit("polyhedron with features", mesh(feature_domain, 0.35 * factor, true), feature_domain, seed);
    }
  }
}

// What a file keeps of a mesh.
template <class C3t3>
C3t3 reloaded(const C3t3& c3t3)
{
  std::stringstream file;
  CGAL::IO::save_binary_file(file, c3t3);
  C3t3 result;
  check::that(CGAL::IO::load_binary_file(file, result), "a saved mesh cannot be loaded");
  return result;
}

// With vertices, cells, and the vertices of cells in random orders, and without surface centers and edges of features.
template <class C3t3>
C3t3 shuffled(const C3t3& c3t3, unsigned int seed)
{
  typedef typename C3t3::Triangulation Triangulation;
  typedef typename C3t3::Vertex_handle Vertex_handle;
  typedef typename C3t3::Cell_handle Cell_handle;
  std::mt19937 random(seed);
  const Triangulation& from = c3t3.triangulation();
  std::vector<Vertex_handle> vertices;
  for(auto v = from.finite_vertices_begin(); v != from.finite_vertices_end(); ++v)
    vertices.push_back(v);
  std::vector<Cell_handle> cells = odt::all_cells(from);
  std::shuffle(vertices.begin(), vertices.end(), random);
  std::shuffle(cells.begin(), cells.end(), random);
  C3t3 result;
  Triangulation& tr = result.triangulation();
  tr.tds().cells().clear();
  tr.tds().set_dimension(3);
  std::map<Vertex_handle, int> number = {{ from.infinite_vertex(), int(odt::Mesh_table_3::infinite) }};
  std::vector<Vertex_handle> new_vertices;
  for(Vertex_handle v : vertices)
  {
    number.emplace(v, static_cast<int>(new_vertices.size()));
    new_vertices.push_back(tr.tds().create_vertex());
    new_vertices.back()->set_point(v->point());
    new_vertices.back()->set_dimension(v->in_dimension());
    new_vertices.back()->set_index(v->index());
  }
  std::map<Cell_handle, int> place;
  for(Cell_handle c : cells)
    place.emplace(c, static_cast<int>(place.size()));
  odt::Mesh_table_3 table;
  std::vector<Cell_handle> new_cells;
  for(Cell_handle c : cells)
  {
    std::array<int, 4> order = {{ 0, 1, 2, 3 }};
    std::rotate(order.begin(), order.begin() + random() % 3, order.begin() + 3);
    if(random() % 2)
      order = {{ order[1], order[0], order[3], order[2] }};
    new_cells.push_back(tr.tds().create_cell());
    new_cells.back()->set_subdomain_index(c->subdomain_index());
    table.cells.emplace_back();
    for(int i = 0; i < 4; ++i)
    {
      new_cells.back()->set_surface_patch_index(i, c->surface_patch_index(order[i]));
      table.cells.back().vertices[i] = number[c->vertex(order[i])];
      table.cells.back().neighbors[i] = place[c->neighbor(order[i])];
    }
  }
  odt::connect_cells(table, new_vertices, new_cells, tr);
  check::that(tr.is_valid(), "a mesh in another order is not valid");
  result.rescan_after_load_of_triangulation();
  return result;
}

// The points of the cells, and their labels.
template <class C3t3>
std::set<std::pair<std::set<domains::Point_3>, int> > labeled_cells(const C3t3& c3t3)
{
  std::set<std::pair<std::set<domains::Point_3>, int> > cells;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
  {
    std::set<domains::Point_3> points;
    for(int i = 0; i < 4; ++i)
      points.insert(c->vertex(i)->point().point());
    cells.emplace(points, c->subdomain_index());
  }
  return cells;
}

// A mesh that comes from a file, or is in another order, becomes the same, to the last bit.
template <class C3t3, class Domain>
void order_of_input(const std::string& name, const C3t3& input, const Domain& domain, const Domain& made_anew)
{
  for(const unsigned int seed : { 0, 1 })
    for(const bool may_insert : { false, true })
    {
      const auto optimized = [&](C3t3 c3t3, const Domain& of)
      {
        CGAL::odt_optimize_mesh_3(c3t3, of, params::random_seed(seed), params::do_insert_vertices = may_insert);
        return labeled_cells(c3t3);
      };
      const auto expected = optimized(input, domain);
      check::that(expected != labeled_cells(input), name, ": nothing has changed");
      check::that(optimized(reloaded(input), made_anew) == expected, name, ": a mesh from a file becomes another one, insertion ", may_insert);
      check::that(optimized(shuffled(input, seed), domain) == expected, name, ": a mesh in another order becomes another one, insertion ",
                  may_insert);
    }
}

int main()
{
  using namespace domains;
  {
    const Labeled_domain domain = sphere();
    test("sphere", mesh(domain, 0.2), domain);
    test("graded sphere", graded_mesh(domain, 0.1), domain);
    grading(domain);
    wanted_sizes(domain);
  }
  {
    const Labeled_domain domain = torus();
    test("torus", mesh(domain, 0.15), domain);
  }
  {
    const Labeled_domain domain = three_subdomains();
    test("three subdomains", mesh(domain, 0.2), domain);
    order_of_input("three subdomains", mesh(domain, 0.2), domain, three_subdomains());
  }
  {
    const Labeled_domain domain = thin_plate();
    test("thin plate", mesh(domain, 0.15), domain, false);
  }
  {
    const CGAL::Image_3 image = labeled_image();
    const Labeled_domain domain = labeled_image_domain(image);
    test("labeled image", mesh(domain, 0.08), domain);
  }
  {
    const CGAL::Image_3 image = gray_image();
    const Labeled_domain domain = gray_image_domain(image);
    test("gray image", mesh(domain, 0.08), domain);
  }
  {
    const Polyhedron box = notched_box();
    Polyhedral_domain domain(box);
    test("polyhedron", mesh(domain, 0.3, false), domain);
    domain.detect_features();
    test("polyhedron with features", mesh(domain, 0.25, true), domain);
    Polyhedral_domain made_anew(box);
    made_anew.detect_features();
    order_of_input("polyhedron with features", mesh(domain, 0.25, true), domain, made_anew);
  }
  holes();
  random_meshes();
  return check::result();
}
