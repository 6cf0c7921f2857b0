// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The contract checker itself: it accepts a copy of the mesh, and sees every kind
// of damage, that of an optimizer that moves surface vertices included.

#include "mesh_contract.h"
#include "mesh_domains.h"

#include <CGAL/Mesh_3/Mesh_global_optimizer.h>
#include <CGAL/Mesh_3/Mesh_sizing_field.h>
#include <CGAL/Mesh_3/Odt_move.h>

#include <functional>
#include <iostream>
#include <limits>
#include <sstream>
#include <string>

// Damages a copy of the mesh; the checks have to fail for it: the one for a fixed boundary and,
// unless the harm is only that the boundary moved, that for a moving one.
template <class C3t3, class Domain>
static void damage(const std::string& what, const C3t3& input, const Domain& domain,
                   const std::function<void(C3t3&)>& harm, bool boundary_may_move = false)
{
  const Mesh_contract<C3t3, Domain> contract(input, domain, what);
  const std::function<void(const C3t3&)> checks[] = {
    [&](const C3t3& c) { contract.check(c); },
    [&](const C3t3& c) { contract.check_moved(c, 1e-3); } };
  for(int moved = 0; moved < (boundary_may_move ? 1 : 2); ++moved)
  {
    C3t3 c3t3(input);
    const int before = check::failures();
    checks[moved](c3t3);
    check::that(check::failures() == before, what, ": a copy is not accepted");

    harm(c3t3);
    const int so_far = check::failures();
    std::ostringstream expected;
    std::streambuf* const errors = std::cerr.rdbuf(expected.rdbuf());
    checks[moved](c3t3);
    std::cerr.rdbuf(errors);
    const int seen = check::failures() - so_far;
    check::failures() = so_far;
    check::that(seen > 0, what, moved ? ", boundary moving" : ", boundary fixed", ": not seen");
    std::cout << what << ": " << seen << " complaints" << std::endl;
  }
}

template <class C3t3>
static typename C3t3::Triangulation::Vertex_handle some_vertex(C3t3& c3t3, int dimension)
{
  for(auto v = c3t3.triangulation().finite_vertices_begin(); v != c3t3.triangulation().finite_vertices_end(); ++v)
    if(v->in_dimension() == dimension)
      return v;
  return {};
}

// Gives a vertex the index of one that has another.
template <class C3t3>
static void change_index(C3t3& c3t3, int dimension)
{
  const auto changed = some_vertex(c3t3, dimension);
  for(auto v = c3t3.triangulation().finite_vertices_begin(); v != c3t3.triangulation().finite_vertices_end(); ++v)
    if(!(v->index() == changed->index()))
    {
      changed->set_index(v->index());
      return;
    }
}

template <class C3t3>
static typename C3t3::Facet some_facet(const C3t3& c3t3) { return *c3t3.facets_in_complex_begin(); }

template <class C3t3>
static typename C3t3::Cell_handle some_cell(const C3t3& c3t3) { return c3t3.cells_in_complex_begin(); }

// Midway between a surface center and the dual point of the cell on one side: as
// far from the vertices of the facet as from each other, but elsewhere.
template <class C3t3>
static void slide_center(C3t3& c3t3)
{
  const auto f = some_facet(c3t3);
  const auto mirror = c3t3.triangulation().mirror_facet(f);
  const auto center = CGAL::midpoint(f.first->get_facet_surface_center(f.second),
                                     c3t3.triangulation().dual(c3t3.is_in_complex(f.first) ? f.first : mirror.first));
  f.first->set_facet_surface_center(f.second, center);
  mirror.first->set_facet_surface_center(mirror.second, center);
}

template <class C3t3, class Domain>
static void test(const C3t3& input, const Domain& domain)
{
  typedef std::function<void(C3t3&)> Harm;
  const auto harm = [&](const std::string& what, const Harm& h) { damage(what, input, domain, h); };
  harm("facet removed", [](C3t3& c) { c.remove_from_complex(some_facet(c)); });
  harm("cell removed", [](C3t3& c) { c.remove_from_complex(some_cell(c)); });
  harm("cell relabelled", [](C3t3& c)
  {
    const auto cell = some_cell(c);
    c.remove_from_complex(cell);
    c.add_to_complex(cell, 7);
  });
  harm("patch index on one side", [](C3t3& c)
  {
    const auto f = some_facet(c);
    const auto m = c.triangulation().mirror_facet(f);
    m.first->set_surface_patch_index(m.second, typename C3t3::Surface_patch_index());
  });
  harm("surface center on one side", [](C3t3& c)
  {
    const auto f = some_facet(c);
    f.first->set_facet_surface_center(f.second, f.first->get_facet_surface_center(f.second) + typename domains::Kernel::Vector_3(0.3, 0, 0));
  });
  harm("surface center slid", [](C3t3& c) { slide_center(c); });
  harm("dimension of a surface vertex", [](C3t3& c) { some_vertex(c, 2)->set_dimension(3); });
  harm("dimension of an interior vertex", [](C3t3& c) { some_vertex(c, 3)->set_dimension(2); });
  harm("index of a surface vertex", [](C3t3& c) { change_index(c, 2); });
  harm("index of an interior vertex", [](C3t3& c) { change_index(c, 3); });
  harm("cells too many counted", [](C3t3& c) { some_cell(c)->set_subdomain_index(typename C3t3::Subdomain_index()); });
  harm("vertex added", [](C3t3& c)
  {
    const auto cell = some_cell(c);
    const auto p = CGAL::centroid(c.triangulation().point(cell, 0).point(), c.triangulation().point(cell, 1).point(),
                                  c.triangulation().point(cell, 2).point(), c.triangulation().point(cell, 3).point());
    c.triangulation().insert(typename C3t3::Triangulation::Weighted_point(p));
  });
  harm("interior vertex moved under its cells", [](C3t3& c)
  {
    const auto v = some_vertex(c, 3);
    const auto p = c.triangulation().point(v).point();
    v->set_point(typename C3t3::Triangulation::Weighted_point(domains::Point_3(p.x() + 1e-6, p.y(), p.z())));
  });
  damage<C3t3>("CGAL's optimizer", input, domain, [&domain](C3t3& c)
  {
    typedef CGAL::Mesh_3::Mesh_sizing_field<typename C3t3::Triangulation> Sizing;
    CGAL::Mesh_3::Mesh_global_optimizer<C3t3, Domain, CGAL::Mesh_3::Odt_move<C3t3, Sizing> >
      optimizer(c, domain, 0.01, true, 0.02);
    optimizer(10);
  }, true);
}

// No bound holds for an error that is not a number, whatever comes before or after it.
static void largest_of_what_is_no_number()
{
  check::Largest numbers, first, last;
  for(double x : { 1., 3., 2. })
    numbers.add(x);
  check::that(numbers == 3, "the largest of 1, 3, 2 is ", numbers);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(double x : { nan, 1. })
    first.add(x);
  for(double x : { 1., nan })
    last.add(x);
  check::that(!(first < 1e300) && !(last < 1e300), "what is not a number has got lost");
}

int main()
{
  largest_of_what_is_no_number();
  using namespace domains;
  const Labeled_domain ball = sphere();
  const Labeled_c3t3 input = mesh(ball, 0.3);
  test(input, ball);
  damage<Labeled_c3t3>("surface vertex moved", input, ball, [](Labeled_c3t3& c)
  {
    const auto v = some_vertex(c, 2);
    const auto p = c.triangulation().point(v).point();
    v->set_point(Labeled_c3t3::Triangulation::Weighted_point(Point_3(p.x() + 1e-13, p.y(), p.z())));
  }, true);
  damage<Labeled_c3t3>("surface vertex off the surface", input, ball, [](Labeled_c3t3& c)
  {
    const auto v = some_vertex(c, 2);
    const auto p = c.triangulation().point(v).point();
    v->set_point(Labeled_c3t3::Triangulation::Weighted_point(CGAL::ORIGIN + 1.003 * (p - CGAL::ORIGIN)));
  });

  Polyhedral_domain box(notched_box());
  box.detect_features();
  const Polyhedral_c3t3 c3t3 = mesh(box, 0.4, true);
  test(c3t3, box);
  typedef Polyhedral_c3t3 C;
  const auto harm = [&](const std::string& what, const std::function<void(C&)>& h) { damage(what, c3t3, box, h); };
  harm("corner removed", [](C& c) {
    const C::Vertex_handle v = c.vertices_in_complex_begin();
    c.remove_from_complex(v);
   });
  harm("feature edge removed", [](C& c) { c.remove_from_complex(*c.edges_in_complex_begin()); });
  harm("curve index changed", [](C& c)
  {
    const auto e = *c.edges_in_complex_begin();
    const auto curve = c.curve_index(e);
    c.remove_from_complex(e);
    c.add_to_complex(e, curve + 100);
  });
  return check::result();
}
