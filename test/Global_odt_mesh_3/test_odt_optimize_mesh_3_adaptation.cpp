// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// With do_insert_vertices and do_remove_vertices, all that is promised holds but the number of vertices, and cells get better.

#include "mesh_contract.h"
#include "mesh_domains.h"

#include <CGAL/Density_quadratures_3.h>
#include <CGAL/Feature_edge_size_field_3.h>
#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Mesh_constant_domain_field_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/perturb_mesh_3.h>
#include <CGAL/refine_mesh_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace params = CGAL::parameters;
using domains::Point_3;

static constexpr double surface = 4e-3;       // how far points of surfaces are from them, over the size of the mesh

template <class C3t3>
CGAL::Mesh_quality_report_3 quality_of(const C3t3& c3t3)
{ return CGAL::mesh_quality_report_3(c3t3, { 30 }); }

static std::size_t cells_below_30(const CGAL::Mesh_quality_report_3& q)
{ return q.cells_below[0].second; }

// Of several meshes.
struct Mean_quality
{
  double smallest_angle = 0, radius_ratio = 0, share_below_30 = 0;
  int number = 0;

  void add(const CGAL::Mesh_quality_report_3& q)
  {
    ++number;
    const auto add = [this](double& mean, double x) { mean += (x - mean) / number; };
    add(smallest_angle, q.smallest_angle);
    add(radius_ratio, q.mean_radius_ratio);
    add(share_below_30, double(cells_below_30(q)) / double(q.number_of_cells));
  }
};

static std::ostream& operator<<(std::ostream& out, const Mean_quality& q)
{
  return out << "smallest angle " << q.smallest_angle << ", below 30 degrees " << 100 * q.share_below_30 << " % of the cells, mean 3r/R "
             << q.radius_ratio;
}

template <class Cell_handle>
double circumradius(Cell_handle c)
{
  const auto p = [&](int i) { return c->vertex(i)->point().point(); };
  return std::sqrt(CGAL::squared_radius(p(0), p(1), p(2), p(3)));
}

// The circumradii of cells, over the size that they may have.
template <class C3t3, class Size>
std::vector<double> relative_circumradii(const C3t3& c3t3, const Size& size)
{
  std::vector<double> radii;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    radii.push_back(circumradius(c) / size(c));
  std::sort(radii.begin(), radii.end());
  return radii;
}

// The largest of each subdomain.
template <class C3t3>
std::map<typename C3t3::Subdomain_index, double> largest_circumradii(const C3t3& c3t3)
{
  std::map<typename C3t3::Subdomain_index, double> largest;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
  {
    double& r = largest[c3t3.subdomain_index(c)];
    r = (std::max)(r, circumradius(c));
  }
  return largest;
}

// But for a share, where edges cannot be split.
static bool are_within(const std::vector<double>& radii, double share = 0.001)
{
  const auto too_large = radii.end() - std::upper_bound(radii.begin(), radii.end(), 1 + 1e-5);
  return double(too_large) <= share * double(radii.size());
}

// What is known of a vertex by its handle.
template <class C3t3>
struct Handle
{
  typename C3t3::Vertex_handle vertex;
  int dimension;
  typename C3t3::Index index;

  explicit Handle(typename C3t3::Vertex_handle v) : vertex(v), dimension(v->in_dimension()), index(v->index()) {}
};

// Checks that all handles, but for those that the visitor was told of, are still those of vertices, which are on the same as before.
template <class C3t3>
void check_handles(const std::string& name, const C3t3& c3t3, const std::vector<Handle<C3t3> >& handles,
                   const std::set<typename C3t3::Vertex_handle>& removed = {})
{
  std::set<typename C3t3::Vertex_handle> present;
  for(auto v = c3t3.triangulation().finite_vertices_begin(); v != c3t3.triangulation().finite_vertices_end(); ++v)
    present.insert(v);
  int lost = 0;
  for(const auto& h : handles)
    lost += removed.count(h.vertex) == 0
            && (present.count(h.vertex) == 0 || h.vertex->in_dimension() != h.dimension || !(h.vertex->index() == h.index));
  check::that(lost == 0, name, ": ", lost, " handles of vertices have lost their vertices");
}

template <class C3t3>
std::vector<Handle<C3t3> > handles_of(const C3t3& c3t3)
{
  std::vector<Handle<C3t3> > handles;
  for(auto v = c3t3.triangulation().finite_vertices_begin(); v != c3t3.triangulation().finite_vertices_end(); ++v)
    handles.emplace_back(v);
  return handles;
}

// Is told of vertices that are removed.
template <class Vertex_handle>
struct Removal_visitor
{
  std::set<Vertex_handle> removed;

  void after_compute_moves() {}
  void after_move_points() {}
  void end_of_iteration(int) {}
  void after_rebuild_restricted_delaunay() {}
  void before_vertex_removal(Vertex_handle v) { removed.insert(v); }
};

// Gives how many vertices are removed by two calls, of which one inserts others. With few vertices, a single call may have better
// or worse luck; so qualities are compared over several seeds.
template <class C3t3, class Domain>
std::size_t test_removal(const std::string& name, const C3t3& input, const Domain& domain, double facet_angle = 30)
{
  constexpr unsigned int seeds = 3;
  std::size_t removed = 0;
  for(bool inserts : { false, true })
  {
    Mean_quality with_all, with_removal;
    for(unsigned int seed = 0; seed < seeds; ++seed)
    {
      Mesh_contract<C3t3, Domain> contract(input, domain, name + ", vertices removed");
      contract.permit(inserts, true);
      C3t3 without(input), c3t3(input);
      CGAL::odt_optimize_mesh_3(without, domain, params::random_seed(seed));
      const auto handles = handles_of(c3t3);
      Removal_visitor<typename C3t3::Vertex_handle> visitor;
      CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_remove_vertices = true, params::do_insert_vertices = inserts,
                                params::random_seed(seed), params::visitor(std::ref(visitor)));
      contract.check_moved(c3t3, surface, facet_angle);
      check_handles(name, c3t3, handles, visitor.removed);
      const std::size_t before = input.triangulation().number_of_vertices(), after = c3t3.triangulation().number_of_vertices();
      check::that(after >= before - visitor.removed.size() && (inserts || after == before - visitor.removed.size()), name,
                  ": the visitor was told of ", visitor.removed.size(), " vertices, but there are ", after, " of ", before);
      with_all.add(quality_of(without));
      with_removal.add(quality_of(c3t3));
      removed += visitor.removed.size();
    }
    std::cout << name << (inserts ? ", with insertion" : "") << ": without removal " << with_all << "; with it " << with_removal << std::endl;
    // Fewer vertices have less freedom; in coarse meshes that costs a little, and one or two cells decide about the smallest angle.
    check::that(with_removal.radius_ratio > with_all.radius_ratio - 0.02
                && with_removal.smallest_angle > (std::min)(with_all.smallest_angle, 30.) - 5
                && with_removal.share_below_30 < with_all.share_below_30 + 0.02, name, ": removal makes cells worse");
  }
  Mesh_contract<C3t3, Domain> contract(input, domain, name + ", vertices removed inside");
  contract.permit(false, true);
  C3t3 fixed(input);
  CGAL::odt_optimize_mesh_3(fixed, domain, params::do_remove_vertices = true, params::optimize_boundary = false);
  contract.check(fixed);
  return removed / seeds;
}

// Optimizes the mesh in several ways. Gives how many vertices the call inserts by default.
template <class C3t3, class Domain>
std::size_t test(const std::string& name, const C3t3& input, const Domain& domain, double facet_angle = 30)
{
  Mesh_contract<C3t3, Domain> contract(input, domain, name);
  contract.permit(true, false);
  C3t3 without(input), c3t3(input);
  CGAL::odt_optimize_mesh_3(without, domain);
  const auto handles = handles_of(c3t3);
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_insert_vertices = true);
  contract.check_moved(c3t3, surface, facet_angle);
  check_handles(name, c3t3, handles);
  const std::size_t before = input.triangulation().number_of_vertices(), after = c3t3.triangulation().number_of_vertices();
  const auto q_without = quality_of(without), q = quality_of(c3t3);
  std::cout << name << ": vertices " << before << " -> " << after << ", smallest angle " << q_without.smallest_angle << " -> "
            << q.smallest_angle << ", cells below 30 degrees " << cells_below_30(q_without) << " -> " << cells_below_30(q) << std::endl;
  check::that(q.smallest_angle > (std::min)(q_without.smallest_angle, 30.) - 1 && cells_below_30(q) <= cells_below_30(q_without), name,
              ": insertion makes cells worse");

  C3t3 again(input);
  CGAL::odt_optimize_mesh_3(again, domain, params::do_insert_vertices = true);
  check::that((Mesh_contract<C3t3, Domain>::points(again) == Mesh_contract<C3t3, Domain>::points(c3t3)), name,
              ": not deterministic");
  // Of a mesh that has been refined, too.
  CGAL::odt_optimize_mesh_3(again, domain, params::do_insert_vertices = true, params::number_of_rounds = 1);
  contract.check_moved(again, surface, facet_angle);

  C3t3 fixed(input);
  const auto handles_of_fixed = handles_of(fixed);
  CGAL::odt_optimize_mesh_3(fixed, domain, params::do_insert_vertices = true, params::optimize_boundary = false);
  contract.check(fixed);
  check_handles(name, fixed, handles_of_fixed);

  C3t3 short_of_time(input);
  CGAL::odt_optimize_mesh_3(short_of_time, domain, params::do_insert_vertices = true, params::max_iteration_number = 10);
  contract.check_moved(short_of_time, surface, facet_angle);

  const auto largest = largest_circumradii(input);
  const std::vector<double> radii = relative_circumradii(c3t3, [&](auto c) { return largest.at(c3t3.subdomain_index(c)); });
  std::cout << "  largest circumradius over that of the input: " << radii.back() << std::endl;
  check::that(are_within(radii), name, ": there are larger cells than before");

  // The field is told of inserted vertices what they are on.
  C3t3 sized(input);
  std::set<int> dimensions;
  const double largest_of_all = relative_circumradii(input, [](auto) { return 1; }).back();
  const auto size = [&](const Point_3& p, int dimension, const typename Domain::Index& index)
  {
    dimensions.insert(dimension);
    if(dimension == 2)
      domain.surface_patch_index(index);
    else if(dimension == 3)
      domain.subdomain_index(index);
    return largest_of_all * (0.7 + 0.1 * p.x());
  };
  CGAL::odt_optimize_mesh_3(sized, domain, params::do_insert_vertices = true, params::sizing_field = size,
                            params::number_of_rounds = 1);
  contract.check_moved(sized, surface, (std::min)(facet_angle, 15.), 0.3);     // as sizes change
  check::that(dimensions.count(3) + dimensions.count(2) > 0, name, ": the field is not asked");
  std::cout << "  smaller sizes: vertices " << before << " -> " << sized.triangulation().number_of_vertices() << std::endl;
  return after - before;
}

// Sizes are those of the field where both may be done.
template <class C3t3, class Domain>
void test_sizes(const std::string& name, const C3t3& input, const Domain& domain, double share_at_junctions)
{
  const double largest = relative_circumradii(input, [](auto) { return 1; }).back();
  for(double factor : { 0.6, 1.5 })
  {
    Mesh_contract<C3t3, Domain> contract(input, domain, name + ", sizes");
    contract.permit(true, true);
    contract.permit_finer_surfaces();
    C3t3 c3t3(input);
    CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_insert_vertices = true, params::do_remove_vertices = true,
                              params::sizing_field = factor * largest);
    contract.check_moved(c3t3, surface, 15, 0.3);        // as sizes change
    const std::vector<double> radii = relative_circumradii(c3t3, [&](auto) { return factor * largest; });
    std::cout << name << ", sizes times " << factor << ": vertices " << input.triangulation().number_of_vertices() << " -> "
              << c3t3.triangulation().number_of_vertices() << ", largest and median circumradius over the size " << radii.back()
              << ", " << radii[radii.size() / 2] << std::endl;
    check::that(are_within(radii, share_at_junctions + 0.001), name, ": cells are larger than the size");
    check::that(radii[radii.size() / 2] > 0.4, name, ": cells are much smaller than the size");
  }
}

// As many vertices as are wanted, graded by a density, too; or the function says that it cannot.
template <class C3t3, class Domain>
void test_number(const std::string& name, const C3t3& input, const Domain& domain, const std::vector<double>& factors,
                 bool is_reached = true)
{
  const double before = double(input.triangulation().number_of_vertices());
  for(double factor : factors)
    for(bool is_graded : { false, true })
    {
      Mesh_contract<C3t3, Domain> contract(input, domain, name + ", number of vertices");
      const std::size_t wanted = static_cast<std::size_t>(factor * before);
      contract.permit(true, true, before / double(wanted));
      contract.permit_finer_surfaces();
      C3t3 c3t3(input);
      Removal_visitor<typename C3t3::Vertex_handle> visitor;
      const auto handles = handles_of(c3t3);
      const auto optimize = [&](const auto&... sizes)
      {
        return CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_insert_vertices = true, params::do_remove_vertices = true,
                                         params::number_of_vertices = wanted, params::visitor(std::ref(visitor)), sizes...);
      };
      const CGAL::Mesh_optimization_return_code code
        = is_graded ? optimize(params::density = [](const Point_3& p) { return std::exp(2 * p.x()); }) : optimize();
      contract.check_moved(c3t3, surface, 15, factor < 0.5 ? 0.6 : 0.3);        // as sizes change
      check_handles(name, c3t3, handles, visitor.removed);
      const double after = double(c3t3.triangulation().number_of_vertices());
      std::cout << name << ": vertices " << before << " -> " << after << ", wanted " << wanted << (is_graded ? ", graded" : "")
                << ", smallest angle " << quality_of(c3t3).smallest_angle << std::endl;
      const bool has_number = std::abs(after - double(wanted)) <= (std::max)(2., 0.01 * double(wanted));
      check::that(has_number || !is_reached, name, ": ", after, " vertices instead of ", wanted);
      check::that(after <= (std::max)(before, double(wanted)), name, ": ", after, " vertices, more than ", wanted);
      check::that(has_number || code == CGAL::CANT_IMPROVE_ANYMORE, name, ": the number is not met, but the function says ", code);
    }
}

// Sizes by subdomain hold in each, be the vertices between them of another size, as of a field by the kind of the place.
static void test_sizes_by_subdomain(const domains::Labeled_domain& domain)
{
  typedef domains::Labeled_domain Domain;
  typedef CGAL::Mesh_constant_domain_field_3<domains::Kernel, Domain::Index> Field;
  const std::map<int, double> sizes = {{ 1, 0.3 }, { 2, 0.2 }, { 3, 0.12 }};
  Field field(0.5);
  for(const auto& s : sizes)
    field.set_size(s.second, 3, domain.index_from_subdomain_index(s.first));
  const domains::Labeled_criteria criteria(params::facet_angle = 25, params::facet_size = 0.25, params::facet_distance = 0.03,
                                           params::cell_radius_edge_ratio = 2.5, params::cell_size = field);
  const auto input = CGAL::make_mesh_3<domains::Labeled_c3t3>(domain, criteria, params::no_perturb(), params::no_exude());
  for(unsigned int seed : { 0, 1 })
  {
    domains::Labeled_c3t3 c3t3(input);
    CGAL::odt_optimize_mesh_3(c3t3, domain, params::sizing_field = field, params::do_insert_vertices = true,
                              params::do_remove_vertices = true, params::random_seed(seed));
    std::map<int, std::vector<double> > radii;
    for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
      radii[c3t3.subdomain_index(c)].push_back(circumradius(c) / sizes.at(c3t3.subdomain_index(c)));
    for(const auto& r : radii)
    {
      const auto share_above = [&](double bound)
      { return double(std::count_if(r.second.begin(), r.second.end(), [=](double x) { return x > bound; })) / double(r.second.size()); };
      std::cout << "sizes by subdomain, " << r.first << ": " << r.second.size() << " cells, of which " << 100 * share_above(1)
                << " % are larger, " << 100 * share_above(1.1) << " % by a tenth" << std::endl;
      check::that(share_above(1 + 1e-5) <= 0.02 && share_above(1.1) <= 0.005, "cells of subdomain ", r.first, " are larger than its size");
    }
  }
}

// Sizes in wrong units do not keep the function from asking whether it may go on, and it leaves a valid mesh.
template <class C3t3, class Domain>
void test_wrong_units(const C3t3& input, const Domain& domain)
{
  for(long most_calls : { 0, 30 })
  {
    Mesh_contract<C3t3, Domain> contract(input, domain, "wrong units");
    contract.permit(true, false);
    C3t3 c3t3(input);
    long calls = 0;
    const auto code = CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_insert_vertices = true, params::sizing_field = 1e-5,
                                                params::callback([&](double) { return calls++ < most_calls; }));
    contract.check_moved(c3t3, surface, 15, 0.3);
    check::that(code == CGAL::TIME_LIMIT_REACHED && calls == most_calls + 1, "wrong units: ", calls, " calls, code ", code);
    check::that((c3t3.triangulation().number_of_vertices() > input.triangulation().number_of_vertices()) == (most_calls > 0),
                "wrong units: ", c3t3.triangulation().number_of_vertices(), " vertices after ", calls, " calls");
  }
}

// A field need be known in the domain only, and outside no farther from it than edges are long.
template <class C3t3, class Domain>
void test_where_fields_are_asked(const std::string& name, const C3t3& input, const Domain& domain)
{
  std::vector<Point_3> on_surface;
  double longest = 0;
  for(auto v = input.triangulation().finite_vertices_begin(); v != input.triangulation().finite_vertices_end(); ++v)
    if(v->in_dimension() < 3)
      on_surface.push_back(v->point().point());
  for(auto c = input.cells_in_complex_begin(); c != input.cells_in_complex_end(); ++c)
    for(int i = 0; i < 3; ++i)
      for(int j = i + 1; j < 4; ++j)
        longest = (std::max)(longest, CGAL::squared_distance(c->vertex(i)->point().point(), c->vertex(j)->point().point()));
  // The nearest vertex of the surface may be half an edge farther.
  const double farthest = 1.25 * std::sqrt(longest);
  long far_away = 0;
  for(double slope : { 2., 8. })
  {
    const auto size = [&](const Point_3& p)
    {
      const auto is_near = [&](const Point_3& q) { return CGAL::squared_distance(p, q) < farthest * farthest; };
      far_away += !domain.is_in_domain_object()(p) && std::none_of(on_surface.begin(), on_surface.end(), is_near);
      return std::exp(slope * p.x());
    };
    const auto field = [&](const Point_3& p, int, const typename Domain::Index&) { return size(p); };
    const auto optimize = [&](const auto&... others)
    {
      C3t3 c3t3(input);
      CGAL::odt_optimize_mesh_3(c3t3, domain, others...);
    };
    optimize(params::sizing_field = field);
    optimize(params::sizing_field = field, params::quadrature = CGAL::Four_point_rule_3());
    optimize(params::density = size, params::annealing_schedule = CGAL::Metropolis_annealing_schedule(), params::number_of_rounds = 2);
    optimize(params::density = size, params::do_insert_vertices = true, params::do_remove_vertices = true);
  }
  check::that(far_away == 0, name, ": a field is asked ", far_away, " times far from the domain");
}

// A field from feature edges is what it says, and a mesh made with it is better.
static void test_feature_edge_sizes(const domains::Polyhedral_c3t3& c3t3, const domains::Polyhedral_domain& domain, double size,
                                    double edge_size)
{
  typedef CGAL::Feature_edge_size_field_3<domains::Polyhedral_c3t3> Field;
  typedef domains::Polyhedral_domain::Index Index;
  const double gradation = 0.45;
  const Field field(c3t3, size, gradation);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> u(-1, 2);
  double least = size;
  for(int n = 0; n < 200; ++n)
  {
    const Point_3 p(u(random), u(random), u(random));
    double expected = size;
    for(auto e = c3t3.edges_in_complex_begin(); e != c3t3.edges_in_complex_end(); ++e)
    {
      const Point_3 a = e->first->vertex(e->second)->point().point(), b = e->first->vertex(e->third)->point().point();
      for(const Point_3& end : { a, b })
        expected = (std::min)(expected, std::sqrt(CGAL::squared_distance(a, b) + gradation * gradation * CGAL::squared_distance(p, end)));
    }
    least = (std::min)(least, expected);
    check::that(std::abs(field(p, 3, Index()) - expected) < 1e-9, "size from feature edges: ", field(p, 3, Index()), ", not ", expected);
  }
  check::that(least < size, "no feature edge matters: the test is too weak");

  const domains::Polyhedral_criteria criteria(params::edge_size = edge_size, params::facet_angle = 25, params::facet_size = field,
                                              params::cell_radius_edge_ratio = 2, params::cell_size = field);
  domains::Polyhedral_c3t3 graded = CGAL::make_mesh_3<domains::Polyhedral_c3t3>(domain, criteria, params::no_perturb(), params::no_exude());
  domains::Polyhedral_c3t3 as_it_was(c3t3);
  CGAL::odt_optimize_mesh_3(as_it_was, domain);
  CGAL::odt_optimize_mesh_3(graded, domain);
  const auto before = quality_of(as_it_was), after = quality_of(graded);
  std::cout << "sizes from feature edges: vertices " << c3t3.triangulation().number_of_vertices() << " -> "
            << graded.triangulation().number_of_vertices() << ", smallest angle " << before.smallest_angle << " -> " << after.smallest_angle
            << ", cells below 30 degrees " << cells_below_30(before) << " -> " << cells_below_30(after) << std::endl;
  check::that(after.smallest_angle > before.smallest_angle && 4 * cells_below_30(after) <= cells_below_30(before), "sizes from feature edges make cells no better");
}

// CGAL's own functions go on with the mesh.
static void go_on(const domains::Polyhedral_c3t3& input, const domains::Polyhedral_domain& domain, double size)
{
  domains::Polyhedral_c3t3 c3t3(input);
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_insert_vertices = true, params::number_of_rounds = 1);
  const std::size_t before = c3t3.triangulation().number_of_vertices();
  CGAL::refine_mesh_3(c3t3, domain, domains::Polyhedral_criteria(params::facet_size = 0.4 * size, params::cell_size = 0.4 * size),
                      params::no_exude(), params::no_perturb());
  check::that(c3t3.triangulation().is_valid() && c3t3.triangulation().number_of_vertices() > before, "refinement fails");
  CGAL::perturb_mesh_3(c3t3, domain, params::time_limit = 5);
  check::that(c3t3.triangulation().is_valid(), "perturbation fails");
}

// Whenever the callback ends the call, also while vertices are inserted, the result is valid, and no angle is smaller than before.
static void early_ends(const domains::Labeled_c3t3& input, const domains::Labeled_domain& domain)
{
  const CGAL::Mesh_constant_domain_field_3<domains::Kernel, domains::Labeled_domain::Index> size(0.12);
  Mesh_contract<domains::Labeled_c3t3, domains::Labeled_domain> contract(input, domain, "early ends");
  contract.permit(true, true);
  contract.permit_finer_surfaces();
  const double before = quality_of(input).smallest_angle;
  std::set<std::size_t> numbers;
  for(int most : { 1, 5, 10, 15, 20, 25, 30, 35, 40, 50, 100, 1000 })
  {
    domains::Labeled_c3t3 c3t3(input);
    int calls = 0;
    const auto code = CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_insert_vertices = true, params::do_remove_vertices = true,
                                                params::sizing_field = size, params::callback([&](double) { return ++calls < most; }));
    check::that(calls < most || code == CGAL::TIME_LIMIT_REACHED, "early end: return code ", code);
    contract.check_moved(c3t3, surface);
    const double after = quality_of(c3t3).smallest_angle;
    check::that(after >= before - 1e-6, "an end at call ", most, " makes the smallest angle ", after, " of ", before);
    numbers.insert(c3t3.triangulation().number_of_vertices());
    std::cout << "early end at call " << calls << ": " << c3t3.triangulation().number_of_vertices() << " vertices, smallest angle "
              << before << " -> " << after << std::endl;
  }
  check::that(numbers.size() > 4, "insertion is not interrupted: the test is too weak");
}

// Nothing has happened if the domain throws, whenever that is, or the callback does.
static void exceptions()
{
  long questions = 0, fails_after = -1;
  const domains::Labeled_domain domain = domains::labeled([&](const Point_3& p)
  {
    if(fails_after >= 0 && ++questions > fails_after)
      throw std::runtime_error("the domain fails");
    // Voxels of a ball that is cut by a plane, and of a smaller ball inside.
    const auto center = [](double x) { return std::round(31 * x) / 31 - 0.5; };
    const double x = center(p.x()), y = center(p.y()), z = center(p.z()), r = x * x + y * y + z * z;
    return r > 0.16 ? 0 : r < 0.02 ? 3 : x < 0.02 ? 1 : 2;
  });
  const domains::Labeled_c3t3 input = domains::mesh(domain, 0.15);
  const Mesh_contract<domains::Labeled_c3t3, domains::Labeled_domain> contract(input, domain, "throwing domain");
  fails_after = 1000000000;
  domains::Labeled_c3t3 optimized(input);
  CGAL::odt_optimize_mesh_3(optimized, domain, params::do_insert_vertices = true, params::number_of_rounds = 1);
  const long all = questions;
  std::cout << all << " questions to the domain" << std::endl;
  check::that(optimized.triangulation().number_of_vertices() > input.triangulation().number_of_vertices(),
              "no vertex is inserted: the test is too weak");
  for(int n = 0; n < 24; ++n)
  {
    domains::Labeled_c3t3 c3t3(input);
    questions = 0;
    fails_after = all * n / 24;
    bool throws = false;
    try { CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_insert_vertices = true, params::number_of_rounds = 1); }
    catch(const std::runtime_error&) { throws = true; }
    fails_after = -1;
    check::that(throws, "the domain does not throw");
    contract.check_untouched(c3t3);
  }
}

int main()
{
  const domains::Labeled_domain sphere = domains::sphere(), plate = domains::thin_plate(), three = domains::three_subdomains();
  const domains::Labeled_c3t3 ball = domains::mesh(sphere, 0.18);
  const std::size_t in_ball = test("ball", ball, sphere);
  check::that(50 * in_ball <= ball.triangulation().number_of_vertices(), "a mesh with even sizes gets ", in_ball, " vertices");
  test("thin plate", domains::mesh(plate, 0.3), plate, 20);
  test("three subdomains", domains::mesh(three, 0.25), three);
  const CGAL::Image_3 image = domains::labeled_image();
  const domains::Labeled_domain of_image = domains::labeled_image_domain(image);
  test("labeled image", domains::mesh(of_image, 0.09), of_image, 25);

  domains::Polyhedral_domain box(domains::notched_box());
  box.detect_features();
  const domains::Polyhedral_c3t3 short_edges = domains::mesh(box, 0.5, true, 0.08);
  check::that(test("box with short feature edges", short_edges, box) > 100, "feature edges are short, but no vertices come");
  test("box with even edges", domains::mesh(box, 0.3, true), box);
  test("box without features", domains::mesh(box, 0.3, false), box);

  check::that(test_removal("box with short feature edges", short_edges, box)
              + test_removal("labeled image", domains::mesh(of_image, 0.15), of_image, 20)
              + test_removal("three subdomains", domains::mesh(three, 0.15), three)
              + test_removal("thin plate", domains::mesh(plate, 0.3), plate, 20) > 0, "no vertex is removed: the test is too weak");
  check::that(50 * test_removal("ball", ball, sphere) <= ball.triangulation().number_of_vertices(),
              "more than 1 % of the vertices of a mesh with even sizes are removed, in two calls");

  test_feature_edge_sizes(short_edges, box, 0.5, 0.08);
  test_sizes("ball", ball, sphere, 0);
  test_sizes("three subdomains", domains::mesh(three, 0.2), three, 0.02);
  test_sizes_by_subdomain(three);
  test_wrong_units(ball, sphere);
  // Slivers at features get vertices only as long as there are fewer.
  test_number("box with short feature edges", short_edges, box, { 1.25 });
  test_number("ball", ball, sphere, { 0.25, 0.8, 1., 4. });
  test_number("coarse ball", domains::mesh(sphere, 0.3), sphere, { 0.25, 0.5 });
  const domains::Labeled_domain torus = domains::torus();
  test_number("torus", domains::mesh(torus, 0.25), torus, { 0.25, 0.5 });
  test_number("three subdomains", domains::mesh(three, 0.12), three, { 0.8, 1., 4. });
  test_number("three subdomains", domains::mesh(three, 0.3), three, { 0.25 }, false);
  test_number("labeled image", domains::mesh(of_image, 0.07), of_image, { 0.8, 1., 4. });
  test_number("box with even edges", domains::mesh(box, 0.2, true), box, { 0.8, 1., 4. });
  test_number("box with even edges", domains::mesh(box, 0.2, true), box, { 0.25 }, false);
  test_where_fields_are_asked("coarse ball", domains::mesh(sphere, 0.3), sphere);
  test_where_fields_are_asked("torus", domains::mesh(torus, 0.25), torus);

  go_on(short_edges, box, 0.5);
  early_ends(ball, sphere);
  exceptions();
  return check::result();
}
