// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What a property map says is to stay does, bit for bit, whatever else the call is to do; the rest of the mesh gets better,
// and all that is promised holds.

#include "kept_facets.h"
#include "mesh_contract.h"
#include "mesh_domains.h"

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/property_map.h>
#include <CGAL/remesh_boundary_mesh_3.h>
#include <CGAL/remove_slivers_mesh_3.h>
#include <CGAL/version.h>

#include <boost/property_map/property_map.hpp>

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
#include <vector>

namespace params = CGAL::parameters;

static constexpr double surface = 4e-3;       // how far points of surfaces are from them, over the size of the mesh

// A readable property map of a function, and no more than that.
template <class Key>
struct Map_of_function
{
  typedef Key key_type;
  typedef bool value_type;
  typedef bool reference;
  typedef boost::readable_property_map_tag category;

  std::function<bool(Key)> function;

  friend bool get(const Map_of_function& map, const Key& key) { return map.function(key); }
};

// A vertex as it is before the call.
template <class C3t3>
struct Vertex_record
{
  typename C3t3::Vertex_handle vertex;
  std::array<double, 4> point;
  int dimension;
  typename C3t3::Index index;

  explicit Vertex_record(typename C3t3::Vertex_handle v)
    : vertex(v), point(point_of(v)), dimension(v->in_dimension()), index(v->index())
  {}

  bool has_moved() const { return point_of(vertex) != point; }
  bool is_the_same() const { return !has_moved() && vertex->in_dimension() == dimension && vertex->index() == index; }

private:
  static std::array<double, 4> point_of(typename C3t3::Vertex_handle v)
  {
    const auto& p = v->point();
    return {{ p.point().x(), p.point().y(), p.point().z(), p.weight() }};
  }
};

template <class C3t3>
std::vector<Vertex_record<C3t3> > vertices_of(const C3t3& c3t3)
{
  std::vector<Vertex_record<C3t3> > result;
  for(typename C3t3::Vertex_handle v : c3t3.triangulation().finite_vertex_handles())
    result.emplace_back(v);
  return result;
}

// How many vertices have moved. Those that are `kept` must not have, and must be there.
template <class C3t3, class Kept>
int check_kept(const std::string& name, const C3t3& c3t3, const std::vector<Vertex_record<C3t3> >& before, const Kept& kept)
{
  std::set<typename C3t3::Vertex_handle> present;
  for(typename C3t3::Vertex_handle v : c3t3.triangulation().finite_vertex_handles())
    present.insert(v);
  int lost = 0, changed = 0, moved = 0;
  for(const Vertex_record<C3t3>& v : before)
  {
    const bool is_present = present.count(v.vertex) > 0;
    moved += is_present && v.has_moved();
    if(!kept(v.vertex))
      continue;
    lost += !is_present;
    changed += is_present && !v.is_the_same();
  }
  check::that(lost == 0, name, ": ", lost, " vertices that were to stay have been removed");
  check::that(changed == 0, name, ": ", changed, " vertices that were to stay have moved, or their dimension or index has changed");
  return moved;
}

// A cell of the complex as it is before the call, with its facets.
template <class C3t3>
class Cell_record
{
  typedef typename C3t3::Cell_handle Cell_handle;
  typedef typename C3t3::Vertex_handle Vertex_handle;

public:
  Cell_record(const C3t3& c3t3, Cell_handle c)
    : label_(c3t3.subdomain_index(c))
  {
    for(int i = 0; i < 4; ++i)
    {
      vertices_[i] = c->vertex(i);
      patches_[i] = c3t3.surface_patch_index(c, i);
      beyond_[i] = c3t3.subdomain_index(c->neighbor(i));
    }
  }

  bool is_there(const C3t3& c3t3) const
  {
    Cell_handle c;
    if(!c3t3.triangulation().is_cell(vertices_[0], vertices_[1], vertices_[2], vertices_[3], c) || !(c3t3.subdomain_index(c) == label_))
      return false;
    for(int i = 0; i < 4; ++i)
    {
      const int n = c->index(vertices_[i]);
      if(!(c3t3.surface_patch_index(c, n) == patches_[i]) || !(c3t3.subdomain_index(c->neighbor(n)) == beyond_[i]))
        return false;
    }
    return true;
  }

private:
  typename C3t3::Subdomain_index label_;
  std::array<Vertex_handle, 4> vertices_;
  std::array<typename C3t3::Surface_patch_index, 4> patches_;         // of the facets opposite to them
  std::array<typename C3t3::Subdomain_index, 4> beyond_;
};

// Of the cells of one subdomain.
static CGAL::Mesh_quality_report_3 quality_of(domains::Labeled_c3t3 c3t3, int subdomain)
{
  std::vector<domains::Labeled_c3t3::Cell_handle> others;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    if(c3t3.subdomain_index(c) != subdomain)
      others.push_back(c);
  for(domains::Labeled_c3t3::Cell_handle c : others)
    c3t3.remove_from_complex(c);
  return CGAL::mesh_quality_report_3(c3t3);
}

// Some vertices, each with the same probability.
template <class C3t3>
std::set<typename C3t3::Vertex_handle> some_vertices(const C3t3& c3t3, double share, unsigned int seed)
{
  std::mt19937 random(seed);
  std::set<typename C3t3::Vertex_handle> result;
  for(typename C3t3::Vertex_handle v : c3t3.triangulation().finite_vertex_handles())
    if(std::uniform_real_distribution<double>(0, 1)(random) < share)
      result.insert(v);
  return result;
}

// What a call may do to the number of vertices.
enum class Numbers { STAY, GROW, CHANGE };

// What calls that change numbers of vertices may make of these.
static constexpr double fewer_vertices = 0.9;

template <class C3t3, class Domain>
void permit(Numbers numbers, Mesh_contract<C3t3, Domain>& contract)
{
  contract.permit(numbers != Numbers::STAY, numbers == Numbers::CHANGE, numbers == Numbers::CHANGE ? 1 / fewer_vertices : 1);
}

// Calls the function on copies of the mesh, in which a share of the vertices is to stay.
template <class C3t3, class Domain, class Call>
void check_random_vertices(const std::string& name, const C3t3& input, const Domain& domain, Numbers numbers, const Call& call)
{
  unsigned int seed = 0;
  for(double share : { 0.05, 0.5, 0.95 })
  {
    const std::string n = name + ", " + std::to_string(share) + " of the vertices stay";
    Mesh_contract<C3t3, Domain> contract(input, domain, n);
    permit(numbers, contract);
    C3t3 c3t3(input);
    std::set<typename C3t3::Vertex_handle> kept = some_vertices(c3t3, share, seed++);
    const auto before = vertices_of(c3t3);
    call(c3t3, params::vertex_is_constrained_map(CGAL::Boolean_property_map<std::set<typename C3t3::Vertex_handle> >(kept)));
    const auto is_kept = [&kept](typename C3t3::Vertex_handle v) { return kept.count(v) > 0; };
    const int moved = check_kept(n, c3t3, before, is_kept);
    check::that(moved > 0 || share > 0.9, n, ": no vertex has moved");
    contract.check_moved(c3t3, surface, 20);
    if(share != 0.5)
      continue;
    Mesh_contract<C3t3, Domain> second_contract(c3t3, domain, n + ", a second call");
    permit(numbers, second_contract);
    call(c3t3, params::vertex_is_constrained_map(CGAL::Boolean_property_map<std::set<typename C3t3::Vertex_handle> >(kept)));
    check_kept(n, c3t3, before, is_kept);
    second_contract.check_moved(c3t3, surface, 20);
  }
}

// Calls check(what, numbers, call) for calls of all kinds, `call(c3t3, parameter)` each.
template <class C3t3, class Domain, class Check>
void for_each_call(const Domain& domain, const Check& check)
{
  check("all", Numbers::STAY, [&](C3t3& c, const auto& parameter)
        { CGAL::odt_optimize_mesh_3(c, domain, params::number_of_rounds = 1, parameter); });
  check("the interior", Numbers::STAY, [&](C3t3& c, const auto& parameter)
        { CGAL::odt_optimize_mesh_3(c, domain, params::number_of_rounds = 0, params::optimize_boundary = false,
                                    parameter); });
  check("insertion", Numbers::GROW, [&](C3t3& c, const auto& parameter)
        { CGAL::odt_optimize_mesh_3(c, domain, params::number_of_rounds = 0, params::do_insert_vertices = true,
                                    parameter); });
  check("insertion and removal", Numbers::CHANGE, [&](C3t3& c, const auto& parameter)
        { CGAL::odt_optimize_mesh_3(c, domain, params::number_of_rounds = 0, params::do_insert_vertices = true,
                                    params::do_remove_vertices = true, parameter); });
  check("fewer vertices", Numbers::CHANGE, [&](C3t3& c, const auto& parameter)
        { CGAL::odt_optimize_mesh_3(c, domain, params::number_of_rounds = 0, params::do_insert_vertices = true,
                                    params::do_remove_vertices = true, parameter,
                                    params::number_of_vertices = fewer_vertices * double(c.triangulation().number_of_vertices())); });
  check("the surface", Numbers::STAY, [&](C3t3& c, const auto& parameter)
        { CGAL::remesh_boundary_mesh_3(c, domain, params::max_iteration_number = 100, parameter); });
  check("slivers", Numbers::STAY, [&](C3t3& c, const auto& parameter)
        { CGAL::remove_slivers_mesh_3(c, domain, parameter); });
}

template <class C3t3, class Domain>
void check_random_vertices(const std::string& name, const C3t3& input, const Domain& domain)
{
  for_each_call<C3t3>(domain, [&](const char* what, Numbers numbers, const auto& call)
                      { check_random_vertices(name + ", " + what, input, domain, numbers, call); });
}

// The same for facets of the complex, in calls that change most.
template <class C3t3, class Domain>
void check_random_facets(const std::string& name, const C3t3& input, const Domain& domain)
{
  typedef typename C3t3::Vertex_handle Vertex_handle;
  typedef typename C3t3::Facet Facet;
  const auto check = [&](const char* what, Numbers numbers, const auto& call)
  {
    unsigned int seed = 0;
    for(double share : { 0.02, 0.2, 0.9 })
    {
      const std::string n = name + ", " + what + ", " + std::to_string(share) + " of the facets stay";
      Mesh_contract<C3t3, Domain> contract(input, domain, n);
      permit(numbers, contract);
      C3t3 c3t3(input);
      std::set<Facet> constrained = kept_facets::some(c3t3, share, seed);
      const auto records = kept_facets::records(c3t3, constrained);
      const auto all = kept_facets::all(c3t3);
      std::set<Vertex_handle> kept;
      for(const Facet& f : constrained)
        for(int k = 1; k < 4; ++k)
          kept.insert(f.first->vertex((f.second + k) % 4));
      const auto before = vertices_of(c3t3);
      call(c3t3, seed++, params::facet_is_constrained_map(CGAL::Boolean_property_map<std::set<Facet> >(constrained)));
      const int moved = check_kept(n, c3t3, before, [&kept](Vertex_handle v) { return kept.count(v) > 0; });
      check::that(moved > 0, n, ": no vertex has moved");
      kept_facets::check_there(n, c3t3, records);
      const auto gone = std::count_if(all.begin(), all.end(), [&](const auto& f) { return !f.is_there(c3t3); });
      check::that(gone > 0 || share > 0.5, n, ": no facet has changed");
      contract.check_moved(c3t3, surface, 20);
    }
  };
  check("all", Numbers::STAY, [&](C3t3& c, unsigned int seed, const auto& map)
        { CGAL::odt_optimize_mesh_3(c, domain, params::number_of_rounds = 1, params::random_seed(seed), map); });
  check("insertion and removal", Numbers::CHANGE, [&](C3t3& c, unsigned int seed, const auto& map)
        { CGAL::odt_optimize_mesh_3(c, domain, params::number_of_rounds = 0, params::do_insert_vertices = true,
                                    params::do_remove_vertices = true, params::random_seed(seed), map); });
  check("slivers", Numbers::STAY, [&](C3t3& c, unsigned int seed, const auto& map)
        { CGAL::remove_slivers_mesh_3(c, domain, params::random_seed(seed), map); });
}

// Each facet of the complex is asked for from both sides, before any of them is changed. All may stay.
static void check_all_facets(const domains::Labeled_c3t3& input, const domains::Labeled_domain& domain)
{
  using domains::Labeled_c3t3;
  typedef Labeled_c3t3::Facet Facet;
  const std::string name = "all facets stay";
  Mesh_contract<Labeled_c3t3, domains::Labeled_domain> contract(input, domain, name);
  Labeled_c3t3 c3t3(input);
  std::size_t questions = 0, others = 0;
  std::set<Facet> asked;
  const auto ask = [&](const Facet& f)
  {
    ++questions;
    others += !c3t3.is_in_complex(f);
    asked.insert(f);
    return false;
  };
  CGAL::remesh_boundary_mesh_3(c3t3, domain, params::facet_is_constrained_map(Map_of_function<Facet>{ ask }),
                               params::max_iteration_number = 1);
  check::that(asked.size() == 2 * input.number_of_facets_in_complex() && questions == asked.size() && others == 0, name,
              ": the map was asked ", questions, " times about ", asked.size(), " sides of ", input.number_of_facets_in_complex(), " facets");
  const Map_of_function<Facet> map{ [](const Facet&) { return true; } };
  Labeled_c3t3 fixed(input);
  const auto before = vertices_of(fixed);
  CGAL::odt_optimize_mesh_3(fixed, domain, params::facet_is_constrained_map(map), params::number_of_rounds = 1);
  check::that(check_kept(name, fixed, before, [](Labeled_c3t3::Vertex_handle v) { return v->in_dimension() < 3; }) > 0, name,
              ": no vertex inside has moved");
  contract.check(fixed);
}

// The same for cells of which those in a half space are selected, and perhaps a share of the others, or of all.
template <class C3t3, class Domain, class Call>
void check_cells(const std::string& name, const C3t3& input, const Domain& domain, Numbers numbers, double x, double share,
                 const Call& call)
{
  typedef typename C3t3::Vertex_handle Vertex_handle;
  typedef typename C3t3::Cell_handle Cell_handle;
  Mesh_contract<C3t3, Domain> contract(input, domain, name);
  permit(numbers, contract);
  C3t3 c3t3(input);
  std::mt19937 random(1);
  std::set<Cell_handle> selected;
  std::set<Vertex_handle> kept;
  std::vector<Cell_record<C3t3> > kept_cells;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    if(CGAL::centroid(c3t3.triangulation().tetrahedron(c)).x() > x && std::uniform_real_distribution<double>(0, 1)(random) < share)
      selected.insert(c);
    else
    {
      kept_cells.emplace_back(c3t3, c);
      for(int i = 0; i < 4; ++i)
        kept.insert(c->vertex(i));
    }
  const auto before = vertices_of(c3t3);
  call(c3t3, params::cell_is_selected_map(CGAL::Boolean_property_map<std::set<Cell_handle> >(selected)));
  const int moved = check_kept(name, c3t3, before, [&kept](Vertex_handle v) { return kept.count(v) > 0; });
  check::that(moved > 0, name, ": no vertex has moved");
  const auto gone = std::count_if(kept_cells.begin(), kept_cells.end(), [&](const Cell_record<C3t3>& c) { return !c.is_there(c3t3); });
  check::that(gone == 0, name, ": ", gone, " of ", kept_cells.size(), " cells that were to stay, or their facets, have changed");
  contract.check_moved(c3t3, surface, 20);
}

// The cells to the left of a plane stay, or some everywhere.
template <class C3t3, class Domain>
void check_cells(const std::string& name, const C3t3& input, const Domain& domain, double x)
{
  for_each_call<C3t3>(domain, [&](const char* what, Numbers numbers, const auto& call)
  {
    check_cells(name + ", half of the cells stay, " + what, input, domain, numbers, x, 1, call);
    check_cells(name + ", some cells stay, " + what, input, domain, numbers, -100, 0.97, call);
  });
}

// All vertices stay, or all but one.
template <class C3t3, class Domain>
void check_most_vertices(const std::string& name, const C3t3& input, const Domain& domain)
{
  typedef typename C3t3::Vertex_handle Vertex_handle;
  const Mesh_contract<C3t3, Domain> contract(input, domain, name + ", all vertices stay");
  const CGAL::Constant_property_map<Vertex_handle, bool> all(true);
  C3t3 c3t3(input);
  int calls = 0;
  const auto count = [&calls](double) { ++calls; return true; };
  check::that(CGAL::odt_optimize_mesh_3(c3t3, domain, params::vertex_is_constrained_map(all), params::callback(count))
                == CGAL::ALL_VERTICES_FROZEN,
              name, ": vertices that are to stay are not frozen");
  check::that(CGAL::remesh_boundary_mesh_3(c3t3, domain, params::vertex_is_constrained_map(all), params::callback(count))
                == CGAL::CONVERGENCE_REACHED,
              name, ": a surface that is to stay has not converged");
  check::that(CGAL::remove_slivers_mesh_3(c3t3, domain, params::vertex_is_constrained_map(all), params::callback(count))
                == CGAL::CONVERGENCE_REACHED,
              name, ": slivers that are to stay are looked for");
  check::that(calls == 0, name, ": there are iterations though all vertices are to stay");
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_remove_vertices = true, params::vertex_is_constrained_map(all));
  contract.check_untouched(c3t3);

  // Others may come, and these move.
  const std::string with_more = name + ", all vertices stay, and others come";
  Mesh_contract<C3t3, Domain> contract_of_more(input, domain, with_more);
  contract_of_more.permit(true, false);
  const auto before_more = vertices_of(c3t3);
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::number_of_rounds = 0, params::do_insert_vertices = true,
                            params::vertex_is_constrained_map(all));
  check_kept(with_more, c3t3, before_more, [](Vertex_handle) { return true; });
  check::that(c3t3.triangulation().number_of_vertices() > before_more.size(), with_more, ": none has come");
  contract_of_more.check_moved(c3t3, surface, 20);

  for(unsigned int seed = 0; seed < 4; ++seed)
  {
    const std::string n = name + ", all vertices stay but one";
    const Mesh_contract<C3t3, Domain> contract_of_one(input, domain, n);
    C3t3 copy(input);
    const auto before = vertices_of(copy);
    // Any, but one of the surface first.
    std::mt19937 random(seed);
    Vertex_handle one;
    do
      one = before[random() % before.size()].vertex;
    while(seed == 0 && one->in_dimension() != 2);
    const Map_of_function<Vertex_handle> others{ [one](Vertex_handle v) { return v != one; } };
    CGAL::odt_optimize_mesh_3(copy, domain, params::number_of_rounds = 1, params::random_seed(seed),
                              params::vertex_is_constrained_map(others));
    check_kept(n, copy, before, others.function);
    contract_of_one.check_moved(copy, surface, 20);
  }
}

// Maps of several kinds that say the same, and one that says nothing.
static void check_kinds_of_maps(const domains::Labeled_c3t3& input, const domains::Labeled_domain& domain)
{
  using domains::Labeled_c3t3;
  typedef Labeled_c3t3::Vertex_handle Vertex_handle;
  typedef Labeled_c3t3::Cell_handle Cell_handle;
  typedef Mesh_contract<Labeled_c3t3, domains::Labeled_domain> Contract;
  const auto optimize = [&](Labeled_c3t3& c, const auto&... parameters)
  { CGAL::odt_optimize_mesh_3(c, domain, params::number_of_rounds = 1, parameters...); };
  const auto is_kept = [](Vertex_handle v) { return v->point().point().x() > 0; };
  std::vector<Contract> expected;
  const auto check = [&](const char* what, const Labeled_c3t3& c)
  {
    if(expected.empty())
      expected.emplace_back(c, domain, "another kind of map");
    expected.back().check_untouched(c);
    check::that(!c.triangulation().finite_vertex_handles().empty(), what);
  };

  Labeled_c3t3 c(input);
  int questions = 0;
  Map_of_function<Vertex_handle> function{ [&](Vertex_handle v) { ++questions; return is_kept(v); } };
  optimize(c, params::vertex_is_constrained_map(function));
  check::that(questions == static_cast<int>(input.triangulation().number_of_vertices()), "the map was asked ", questions, " times");
  check("a function", c);

  Labeled_c3t3 d(input);
  std::map<Vertex_handle, bool> values;
  for(Vertex_handle v : d.triangulation().finite_vertex_handles())
    values[v] = is_kept(v);
  optimize(d, params::vertex_is_constrained_map(boost::associative_property_map<std::map<Vertex_handle, bool> >(values)));
  check("values", d);
  Labeled_c3t3 e(input);
  values.clear();
  for(Vertex_handle v : e.triangulation().finite_vertex_handles())
    values[v] = is_kept(v);
  const auto constant_values = boost::make_assoc_property_map(const_cast<const std::map<Vertex_handle, bool>&>(values));
  optimize(e, params::vertex_is_constrained_map(constant_values));
  check("constant values", e);
#if CGAL_VERSION_NR >= 1050600000
  Labeled_c3t3 f(input);
  CGAL::odt_optimize_mesh_3(f, domain, params::number_of_rounds(1).vertex_is_constrained_map(function));
  check("a chain", f);
#endif

  Labeled_c3t3 free(input), unconstrained(input);
  optimize(free);
  questions = 0;
  const Map_of_function<Cell_handle> all_cells{ [&](Cell_handle) { ++questions; return true; } };
  optimize(unconstrained, params::vertex_is_constrained_map(CGAL::Constant_property_map<Vertex_handle, bool>(false)),
           params::cell_is_selected_map(all_cells));
  check::that(questions == static_cast<int>(input.number_of_cells_in_complex()), "the map was asked for cells ", questions, " times");
  Contract(free, domain, "maps that constrain nothing").check_untouched(unconstrained);

  Labeled_c3t3 unselected(input);
  check::that(CGAL::odt_optimize_mesh_3(unselected, domain, params::do_insert_vertices = true, params::do_remove_vertices = true,
                                        params::cell_is_selected_map(CGAL::Constant_property_map<Cell_handle, bool>(false)))
                == CGAL::ALL_VERTICES_FROZEN,
              "vertices of cells that are to stay are not frozen");
  Contract(input, domain, "no cell is selected").check_untouched(unselected);
}

// The exception comes, and the mesh is as it was.
template <class C3t3, class Domain>
void check_exceptions(const std::string& name, const C3t3& input, const Domain& domain)
{
  const Mesh_contract<C3t3, Domain> contract(input, domain, name + ", the map throws");
  std::size_t n = 0, last = 0;
  const auto throw_at_last = [&](auto)
  {
    if(++n == last)
      throw std::runtime_error("no value");
    return true;
  };
  const auto check = [&](std::size_t number_of_keys, const auto& parameter)
  {
    for_each_call<C3t3>(domain, [&](const char* what, Numbers, const auto& call)
    {
      C3t3 c3t3(input);
      n = 0;
      last = number_of_keys;
      bool thrown = false;
      try { call(c3t3, parameter); }
      catch(const std::runtime_error&) { thrown = true; }
      check::that(thrown, name, ", ", what, ": the exception of the map does not come");
      contract.check_untouched(c3t3);
    });
  };
  check(input.triangulation().number_of_vertices(),
        params::vertex_is_constrained_map(Map_of_function<typename C3t3::Vertex_handle>{ throw_at_last }));
  check(input.number_of_cells_in_complex(), params::cell_is_selected_map(Map_of_function<typename C3t3::Cell_handle>{ throw_at_last }));
}

struct Sliver_visitor
{
  std::size_t slivers = 0;
  void after_compute_moves() {}
  void after_move_points() {}
  void after_rebuild_restricted_delaunay() {}
  void end_of_iteration(int) {}
  void after_sliver_removal(std::size_t n) { slivers = n; }
};

// A ball in a box. The cells of the box stay, or those that are not near the ball, so that its surface moves. A few cells at those that
// stay keep the removal of slivers from going beyond 30 degrees, unless it is told to. Of slivers that stay, the caller hears nothing.
static void check_ball_in_box()
{
  using domains::Labeled_c3t3;
  typedef Labeled_c3t3::Cell_handle Cell_handle;
  const domains::Labeled_domain domain = domains::labeled([](const domains::Point_3& p)
  {
    if((std::max)({ std::abs(p.x()), std::abs(p.y()), std::abs(p.z()) }) > 0.8)
      return 0;
    return domains::squared(p) < 0.25 ? 1 : 2;
  });
  const Labeled_c3t3 input = domains::mesh(domain, 0.1);
  const auto is_in_ball = [](Cell_handle c) { return c->subdomain_index() == 1; };
  const auto is_near_ball = [](Cell_handle c)
  {
    bool is_near = true;
    for(int i = 0; i < 4; ++i)
      is_near = is_near && domains::squared(c->vertex(i)->point().point()) < 0.5;
    return is_near;
  };
  const auto check = [&](const std::string& name, const std::function<bool(Cell_handle)>& is_selected, double bound, double angle,
                         double ratio)
  {
    Labeled_c3t3 c3t3(input);
    Mesh_contract<Labeled_c3t3, domains::Labeled_domain> contract(c3t3, domain, name);
    std::vector<Cell_record<Labeled_c3t3> > kept_cells;
    for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
      if(!is_selected(c))
        kept_cells.emplace_back(c3t3, c);
    Sliver_visitor visitor;
    const auto code = CGAL::odt_optimize_mesh_3(c3t3, domain, params::sliver_bound = bound, params::visitor(std::ref(visitor)),
                                                params::cell_is_selected_map(Map_of_function<Cell_handle>{ is_selected }));
    const auto gone = std::count_if(kept_cells.begin(), kept_cells.end(), [&](const auto& c) { return !c.is_there(c3t3); });
    check::that(gone == 0, name, ": ", gone, " of ", kept_cells.size(), " cells that were to stay have changed");
    contract.check_moved(c3t3, surface);
    const CGAL::Mesh_quality_report_3 ball = quality_of(c3t3, 1);
    std::cout << name << ": " << ball.number_of_cells << " cells in the ball, smallest angle " << ball.smallest_angle << ", mean 3r/R "
              << ball.mean_radius_ratio << std::endl;
    check::that(ball.smallest_angle > angle && ball.mean_radius_ratio > ratio, name, ": the ball has an angle of ", ball.smallest_angle,
                " degrees, and a mean 3r/R of ", ball.mean_radius_ratio);
    check::that((visitor.slivers > 0) == (ball.smallest_angle < bound) && (code == CGAL::CANT_IMPROVE_ANYMORE) == (ball.smallest_angle < bound),
                name, ": code ", code, " and ", visitor.slivers, " slivers");
  };
  check("ball in a box that stays", is_in_ball, 0, 29, 0.86);
  check("ball in a box that stays, with a bound", is_in_ball, 40, 33, 0.86);
  check("ball in a box that stays, with a low bound", is_in_ball, 20, 20, 0.86);
  check("ball in a box that stays away from it", is_near_ball, 0, 29, 0.88);
}

// The vertices of two subdomains stay, and the cells of the third get better.
static void check_subdomains(const domains::Labeled_c3t3& input, const domains::Labeled_domain& domain)
{
  using domains::Labeled_c3t3;
  typedef Labeled_c3t3::Vertex_handle Vertex_handle;
  Labeled_c3t3 c3t3(input);
  std::set<Vertex_handle> kept;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    for(int i = 0; i < 4; ++i)
      if(c3t3.subdomain_index(c) != 3)
        kept.insert(c->vertex(i));
  const auto before = vertices_of(c3t3);
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::vertex_is_constrained_map(CGAL::Boolean_property_map<std::set<Vertex_handle> >(kept)));
  check_kept("two subdomains stay", c3t3, before, [&kept](Vertex_handle v) { return kept.count(v) > 0; });
  const double before_call = quality_of(input, 3).mean_radius_ratio, after_call = quality_of(c3t3, 3).mean_radius_ratio;
  check::that(after_call > before_call + 0.05, "the cells of the third subdomain have a mean 3r/R of ", after_call, ", before ", before_call);
}

int main()
{
  const domains::Labeled_domain sphere = domains::sphere(), three = domains::three_subdomains();
  const domains::Labeled_c3t3 ball = domains::mesh(sphere, 0.25), parts = domains::mesh(three, 0.13);
  domains::Polyhedral_domain box(domains::notched_box());
  box.detect_features();
  const domains::Polyhedral_c3t3 part = domains::mesh(box, 0.4, true);

  check_random_vertices("ball", ball, sphere);
  check_random_vertices("three subdomains", parts, three);
  check_random_vertices("box", part, box);
  check_random_facets("ball", ball, sphere);
  check_random_facets("three subdomains", parts, three);
  check_random_facets("box", part, box);
  check_all_facets(ball, sphere);
  check_cells("ball", ball, sphere, 0.);
  check_cells("three subdomains", parts, three, 0.1);
  check_cells("box", part, box, 1.);
  check_ball_in_box();
  check_most_vertices("ball", ball, sphere);
  check_most_vertices("three subdomains", parts, three);
  check_most_vertices("box", part, box);
  check_kinds_of_maps(ball, sphere);
  check_exceptions("ball", ball, sphere);
  check_exceptions("box", part, box);
  check_subdomains(parts, three);
  return check::result();
}
