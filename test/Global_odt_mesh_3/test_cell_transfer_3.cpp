// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "check.h"
#include "load_triangulation_3.h"
#include "mesh_domains.h"
#include "labelled_triangulation_checks.h"
#include "opened_complex.h"

#include <CGAL/Global_odt_mesh_3/internal/complex/Cell_transfer_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_updater_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Labelled_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Vertex_moves_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flips_3.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace CGAL::Global_odt_mesh_3::internal;
using domains::Labeled_c3t3;
using domains::Labeled_domain;
using domains::Labeled_triangulation;
using domains::Polyhedral_c3t3;
using domains::Polyhedral_domain;

enum Outcome { TRANSFERRED, NOT_TRANSFERRED, ANY };

// Values are found by their tuples, the first that a tuple has got, and none where there are none.
static void tuple_table()
{
  typedef std::array<int, 3> Triple;
  Tuple_table<Triple, int> table;
  check::that(table.find({{ 1, 2, 3 }}) == nullptr, "an empty table has a value");
  const unsigned int seed = 4;
  Random_source random(seed);
  std::map<Triple, int> expected;
  const auto number = [&random] { return static_cast<int>(30 * random.uniform()) - 1; };
  for(int n = 0; n < 10000; ++n)
  {
    if(n == 5000)
      table.reserve(20000);
    const Triple t = {{ number(), number(), number() }};
    table.insert(t, n);
    expected.emplace(t, n);
  }
  check::that(std::map(table.entries().begin(), table.entries().end()) == expected
              && table.entries().size() == expected.size(), "the table has other entries");
  int absent = 0;
  for(int n = 0; n < 30 * 30 * 30; ++n)
  {
    const Triple t = {{ n / 900 - 1, n / 30 % 30 - 1, n % 30 - 1 }};
    const int* const value = table.find(t);
    const auto e = expected.find(t);
    check::that(e == expected.end() ? value == nullptr : value != nullptr && *value == e->second, "a wrong value");
    absent += value == nullptr;
  }
  check::that(absent > 1000, "hardly any tuple is absent");
}

// What is transferred from the mesh for positions that may be others is what insertion gives; how many vertices
// were inserted for it, or -1 if it was not transferred.
static int transfer_cells(const std::string& name, const Moving_triangulation_3& mesh, const std::vector<Site>& sites, Outcome expected)
{
  Labelled_triangulation_3 inserted, transferred;
  inserted.build(sites);
  Cell_transfer_3 transfer(mesh, sites, Thread_policy::for_tag<CGAL::Parallel_tag>());
  const bool is_transferred = transfer.run(transferred);
  std::cout << name << ": " << (is_transferred ? "" : "not ") << "transferred, " << transfer.number_of_inserted_vertices()
            << " of " << sites.size() << " vertices inserted" << std::endl;
  check::that(expected == ANY || is_transferred == (expected == TRANSFERRED), name, ": ", is_transferred ? "" : "not ", "transferred");
  if(!is_transferred)
    return -1;
  check::that(inserted.is_complete(), name, ": hidden vertices are overlooked");
  check::that(transferred.is_complete() && std::equal(sites.begin(), sites.end(), transferred.sites().begin(), transferred.sites().end(),
                                                      same_place), name, ": vertices are not where they are to be");
  check::that(cells_of(transferred) == cells_of(inserted), name, ": not the cells that insertion gives");
  check::that(is_regular_triangulation_of_cgal(transferred), name, ": the triangulation is not valid");
  // Vertices can be moved afterwards.
  std::vector<Site> elsewhere = sites;
  for(int v = 0; v < static_cast<int>(sites.size()); v += 97)
    elsewhere[v] = sites[(v + 50) % sites.size()];
  for(int v = 50; v < static_cast<int>(sites.size()); v += 97)
    elsewhere[v] = site_at((position(sites[v]) + position(sites[v - 1])) / 2, sites[v].weight);
  if(move_vertices(elsewhere, transferred))
    check::that(is_regular_triangulation_of_cgal(transferred), name, ": vertices cannot be moved");
  return transfer.number_of_inserted_vertices();
}

// Moves vertices of a mesh, which stays regular.
static void move(Moving_triangulation_3& mesh, double length, unsigned int seed)
{
  Random_source random(seed);
  mesh.keep();
  mesh.evaluate();
  std::vector<double> edges;
  mesh.shortest_edges(edges);
  for(int n = 0; n < 3; ++n)
  {
    mesh.keep();
    mesh.move([&](int v, Site& s)
    {
      if(v < mesh.number_of_interior_vertices)
        s = site_at(position(s) + length * edges[v] * random.direction(), s.weight);
    });
    if(!mesh.evaluate())
      mesh.restore();
  }
}

// Surface vertices elsewhere than in the mesh, as after their projection.
static std::vector<Site> with_moved_surface(const Moving_triangulation_3& mesh, double length, unsigned int seed)
{
  Random_source random(seed);
  std::vector<double> edges;
  mesh.shortest_edges(edges);
  std::vector<Site> sites = mesh.sites;
  for(int v = mesh.number_of_interior_vertices; v < mesh.number_of_movable_vertices; ++v)
    sites[v] = site_at(position(sites[v]) + length * edges[v] * random.direction(), sites[v].weight);
  return sites;
}

// Flips a share of the facets where that leads to positive cells.
static int flip_at_random(Moving_triangulation_3& mesh, double share, unsigned int seed)
{
  Random_source random(seed);
  int flips = 0;
  for(int n = 0, end = mesh.topology.number_of_half_facets(); n < end; ++n)
  {
    const Half_facet s(n);
    if(random.uniform() > share || !mesh.topology.is_alive(s.cell()) || mesh.topology.neighbor(s).is_side())
      continue;
    const std::array<double, 3> volumes = mesh.volumes_after_2_3(s);
    if(!(volumes[0] > 0 && volumes[1] > 0 && volumes[2] > 0))
      continue;
    flip_2_3(mesh.topology, s);
    ++flips;
  }
  return flips;
}

// A mesh of a domain after small and large motions, with a surface that moves, so that facets of it change, with wrong
// flips, and with vertices that have left their stars: all of it is transferred, with more insertions.
template <class C3t3, class Domain>
void domain_meshes(const std::string& name, const C3t3& c3t3, const Domain& domain, Outcome expected)
{
  const Opened_complex<C3t3, Domain> setting(c3t3, domain, true);
  Moving_triangulation_3 mesh = setting.mesh;
  transfer_cells(name + ", as read", mesh, mesh.sites, expected);
  move(mesh, 0.2, 1);
  const int fewest = transfer_cells(name + ", moved", mesh, mesh.sites, expected);
  for(double length : { 0.01, 0.1, 0.3 })
    transfer_cells(name + ", surface moved by " + std::to_string(length), mesh,
                             with_moved_surface(mesh, length, 2), length < 0.2 ? expected : ANY);
  {
    Moving_triangulation_3 flipped = mesh;
    check::that(flip_at_random(flipped, 0.001, 3) > 0, name, ": nothing is flipped");
    const int n = transfer_cells(name + ", with wrong flips", flipped, flipped.sites, expected);
    check::that(n < 0 || n > fewest, name, ": no wrong flip is noticed");
  }
  {
    std::vector<Site> sites = mesh.sites;
    std::vector<double> edges;
    mesh.mean_edge_lengths(edges);
    Random_source random(4);
    for(int v = 0; v < mesh.number_of_interior_vertices; v += 300)
      sites[v] = site_at(position(sites[v]) + 0.7 * edges[v] * random.direction(), sites[v].weight);
    transfer_cells(name + ", with inverted cells", mesh, sites, expected);
  }
  flip_at_random(mesh, 1, 5);
  transfer_cells(name + ", with many wrong flips", mesh, mesh.sites, ANY);
}

// A complex gets where it gets by insertion of all vertices.
template <class C3t3, class Domain>
void complexes(const std::string& name, const C3t3& c3t3, const Domain& domain, bool is_final)
{
  Opened_complex<C3t3, Domain> with(c3t3, domain, true), without(c3t3, domain, true);
  for(unsigned int n = 0; n < 3; ++n)
  {
    move(with.mesh, 0.1, 10 + n);
    const bool done = with.complex.advance(with.mesh, is_final);
    check::that(without.complex.advance(with.mesh.sites, is_final) == done, name, ": only one way succeeds");
    if(!done)
      continue;
    const auto &a = with.complex.snapshot(), &b = without.complex.snapshot();
    std::set<std::pair<Quadruple, int> > labels[2];
    for(const Complex_snapshot_3* s : { &a, &b })
      for(int c : s->triangulation.cells())
        labels[s == &b].emplace(sorted(s->triangulation.vertices(c)), s->triangulation.label(c));
    check::that(a.has_positions(b.sites()) && labels[0] == labels[1], name, ": the complexes have other cells");
    std::set<std::array<int, 3> > facets[2];
    for(const Boundary_facet& f : a.boundary.complex().facets())
      facets[0].insert(sorted(f.vertices));
    for(const Boundary_facet& f : b.boundary.complex().facets())
      facets[1].insert(sorted(f.vertices));
    check::that(facets[0] == facets[1], name, ": the complexes have other facets");
    with.complex.load_into(with.mesh);
  }
  std::cout << name << ": " << with.complex.number_of_transfers() << " transfers" << std::endl;
  check::that(with.complex.number_of_transfers() == 3, name, ": ", with.complex.number_of_transfers(), " transfers");
  check::that(without.complex.number_of_transfers() == 0, name, ": transferred without a mesh");
}

// Points of a lattice, some of them elsewhere: where spheres pass through more than four, the result is that of insertion.
static void lattices()
{
  const int n = 16;
  for(double left_in_place : { 1., 0.5, 0.1, 0. })
  {
    Random_source random(6);
    Labeled_triangulation tr;
    for(int i = 0; i <= n; ++i)
      for(int j = 0; j <= n; ++j)
        for(int k = 0; k <= n; ++k)
        {
          Vector_3 p(i, j, k);
          const bool is_inside = 0 < (std::min)({ i, j, k }) && (std::max)({ i, j, k }) < n;
          const Vector_3 by = 0.3 * random.direction();
          if(is_inside && i > left_in_place * n)
            p += by;
          tr.insert(Labeled_triangulation::Weighted_point(Labeled_triangulation::Bare_point(p.x(), p.y(), p.z()), 0));
        }
    const Moving_triangulation_3 mesh = load_triangulation_3(tr);
    transfer_cells("lattice of which " + std::to_string(left_in_place) + " is in place", mesh, mesh.sites,
                                     left_in_place == 1 ? NOT_TRANSFERRED : left_in_place > 0.3 ? ANY : TRANSFERRED);
  }
}

static Moving_triangulation_3 random_points()
{
  Random_source random(7);
  Labeled_triangulation tr;
  for(int i = 0; i < 4000; ++i)
  {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    tr.insert(Labeled_triangulation::Weighted_point(Labeled_triangulation::Bare_point(x, y, z), 0));
  }
  return load_triangulation_3(tr);
}

// Where vertices get hidden, by those that are inserted or by those that are left out, or two are in one place, that is
// noticed.
static void hidden_vertices()
{
  const Moving_triangulation_3 mesh = random_points();
  const int inside = mesh.number_of_interior_vertices / 2, fixed = mesh.number_of_interior_vertices;
  transfer_cells("random points", mesh, mesh.sites, TRANSFERRED);
  for(int v : { inside, fixed })
  {
    std::vector<Site> sites = mesh.sites;
    sites[v].weight = 0.03;
    transfer_cells("random points, one with a large weight", mesh, sites, NOT_TRANSFERRED);
    sites[v].weight = -0.1;
    transfer_cells("random points, one with a negative weight", mesh, sites,
                                     v == inside ? NOT_TRANSFERRED : ANY);
  }
  std::vector<Site> sites = mesh.sites;
  sites[inside] = sites[inside + 1];
  transfer_cells("random points, two in one place", mesh, sites, NOT_TRANSFERRED);
}

// Weights that change some cells: the others are transferred.
static void weighted_vertices()
{
  const Moving_triangulation_3 mesh = random_points();
  std::vector<Site> sites = mesh.sites;
  Random_source random(8);
  for(int v = 0; v < mesh.number_of_movable_vertices; v += 40)
    sites[v].weight = 1e-4 * random.uniform();
  transfer_cells("random points with weights", mesh, sites, TRANSFERRED);
}

// Random points in a tetrahedron of this size around the origin, whose vertices are fixed.
static Moving_triangulation_3 tetrahedron(double size, unsigned int seed)
{
  Random_source random(seed);
  Labeled_triangulation tr;
  const auto insert = [&](const Vector_3& p)
  {
    tr.insert(Labeled_triangulation::Weighted_point(Labeled_triangulation::Bare_point(p.x(), p.y(), p.z()), 0));
  };
  for(const Vector_3& corner : { Vector_3(3, 3, 3), Vector_3(3, -3, -3), Vector_3(-3, 3, -3),
                                        Vector_3(-3, -3, 3) })
    insert(size * corner);
  for(int n = 0; n < 40; ++n)
  {
    const double radius = size * random.uniform();
    insert(radius * random.direction());
  }
  return load_triangulation_3(tr);
}

// Both meshes as parts of one, fixed vertices last.
static Moving_triangulation_3 side_by_side(const Moving_triangulation_3& a, const Moving_triangulation_3& b)
{
  const int interior_a = a.number_of_interior_vertices, interior_b = b.number_of_interior_vertices,
            sites_a = static_cast<int>(a.sites.size());
  Moving_triangulation_3 both = a;
  both.number_of_interior_vertices = both.number_of_movable_vertices = interior_a + interior_b;
  both.sites.insert(both.sites.begin() + interior_a, b.sites.begin(), b.sites.begin() + interior_b);
  both.sites.insert(both.sites.end(), b.sites.begin() + interior_b, b.sites.end());
  std::vector<int> vertices, neighbors;
  for(const Moving_triangulation_3* part : { &a, &b })
  {
    const bool is_b = part == &b;
    const int slots = is_b ? a.topology.number_of_half_facets() : 0, sides = is_b ? a.topology.number_of_sides() : 0;
    for(int n = 0; n < part->topology.number_of_half_facets(); ++n)
    {
      const int v = part->topology.cell_vertices()[n], across = part->topology.neighbors()[n];
      const bool is_interior = v < part->number_of_interior_vertices;
      vertices.push_back(is_b ? v + (is_interior ? interior_a : sites_a) : v + (is_interior ? 0 : interior_b));
      neighbors.push_back(across < 0 ? across - sides : across + slots);
    }
  }
  both.topology.assign(vertices, neighbors, both.sites.size(), a.topology.number_of_sides() + b.topology.number_of_sides());
  return both;
}

static Moving_triangulation_3 with_cells_twice(const Moving_triangulation_3& mesh)
{
  const Indexed_triangulation_3& t = mesh.topology;
  std::vector<int> vertices, neighbors;
  for(int copy : { 0, 1 })
    for(int n = 0; n < t.number_of_half_facets(); ++n)
    {
      const Half_facet across(t.neighbors()[n]);
      vertices.push_back(t.cell_vertices()[n]);
      neighbors.push_back(across.id() + copy * (across.is_side() ? -t.number_of_sides() : t.number_of_half_facets()));
    }
  Moving_triangulation_3 twice = mesh;
  twice.topology.assign(vertices, neighbors, mesh.sites.size(), 2 * t.number_of_sides());
  return twice;
}

// Each cell of a mesh is fine, and the mesh is not: it covers a part of space twice, or passes over a vertex.
static void wrong_covers()
{
  const Moving_triangulation_3 large = tetrahedron(1, 13), small = tetrahedron(0.001, 14);
  transfer_cells("tetrahedron", large, large.sites, TRANSFERRED);
  transfer_cells("small tetrahedron", small, small.sites, TRANSFERRED);
  const Moving_triangulation_3 both = side_by_side(large, small);
  transfer_cells("one tetrahedron inside the other", both, both.sites, NOT_TRANSFERRED);
  transfer_cells("each cell twice", with_cells_twice(large), large.sites, NOT_TRANSFERRED);
  std::vector<Site> sites = large.sites;
  sites.push_back(Site{ 0.01, 0.02, 0.03, 0 });
  transfer_cells("a vertex without cells", large, sites, NOT_TRANSFERRED);
}

// A cell is transferred if it is positive, also without any neighbor that would tell.
static void single_cells()
{
  const std::vector<Site> sites = { { 0, 0, 0, 0 }, { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 } };
  for(bool is_positive : { true, false })
  {
    Indexed_triangulation_3 flat;
    flat.reserve(4, 1);
    flat.add_cell(0, 1, is_positive ? 2 : 3, is_positive ? 3 : 2);
    for(int i = 0; i < 4; ++i)
      flat.set_neighbors(Half_facet(0, i), Half_facet::side(i, 0));
    Transferred_cells_3 transferred(flat, 4, 4, Thread_policy());
    check::that(transferred.is_transferred(0), "the cell is not even looked at");
    certify_cells(transferred, sites, Thread_policy());
    check::that(transferred.is_transferred(0) == is_positive, is_positive ? "a good cell is rejected" : "an inverted cell is transferred");
  }
}

// A vertex that another one hides, or that comes to a place that is taken, is known to be so, and can be moved to where it
// is seen again.
static void hiding_vertices()
{
  // A ball, a vertex within it, which an octahedron leaves visible, and one that comes to hide it.
  std::vector<Site> sites = { { 0, 0, 0, 1 }, { 0.9, 0, 0, 0 }, { 2, 0.1, 0.1, 0 }, { 3, 0, 0, 0 }, { -3, 0, 0, 0 }, { 0, 3, 0, 0 },
                              { 0, -3, 0, 0 }, { 0, 0, 3, 0 }, { 0, 0, -3, 0 } };
  Labelled_triangulation_3 tr;
  tr.build(sites);
  check::that(tr.is_complete(), "a visible vertex is not there");
  const auto build_with = [&](int v, const Site& s)
  {
    std::vector<Site> moved = sites;
    moved[v] = s;
    tr.build(moved);
  };
  build_with(2, { 1.1, 0, 0, 0 });
  check::that(!tr.is_complete() && !tr.is_visible(1) && tr.is_visible(2), "a hidden vertex is not noticed");
  build_with(1, { 0, 3, 0, 0 });
  check::that(!tr.is_complete() && tr.is_visible(1) != tr.is_visible(5), "a taken place is not noticed");
  tr.build(sites);
  Vertex_moves_3 moves(tr);
  check::that(moves.move(1, { 0, 2, 0, 0 }) && is_regular_triangulation_of_cgal(tr), "a vertex cannot be moved");
  check::that(moves.move(1, sites[1]) && tr.is_complete() && is_regular_triangulation_of_cgal(tr), "a vertex cannot be moved back");
  check::that(!moves.move(1, { 0.1, 0, 0, 0 }), "a vertex moves to where it is hidden");
}

int main()
{
  tuple_table();
  hiding_vertices();
  std::cout << "seeds: 1 to 8, 10 to 14" << std::endl;
  lattices();
  hidden_vertices();
  weighted_vertices();
  single_cells();
  wrong_covers();
  {
    const Labeled_domain domain = domains::sphere();
    const Labeled_c3t3 c3t3 = domains::mesh(domain, 0.11);
    domain_meshes("sphere", c3t3, domain, TRANSFERRED);
    complexes("sphere", c3t3, domain, false);
    complexes("sphere, final", c3t3, domain, true);
  }
  {
    const Labeled_domain domain = domains::three_subdomains();
    const Labeled_c3t3 c3t3 = domains::mesh(domain, 0.1);
    domain_meshes("three subdomains", c3t3, domain, TRANSFERRED);
    complexes("three subdomains", c3t3, domain, true);
  }
  {
    const Labeled_domain domain = domains::labeled([](const domains::Point_3& p)
      { return domains::squared(p) < 1 && domains::squared(p) > 0.2 ? 1 : 0; });
    const Labeled_c3t3 c3t3 = domains::mesh(domain, 0.1);
    domain_meshes("cavity", c3t3, domain, TRANSFERRED);
    complexes("cavity", c3t3, domain, true);
  }
  {
    const Labeled_domain domain = domains::torus();
    domain_meshes("torus", domains::mesh(domain, 0.1), domain, TRANSFERRED);
  }
  {
    // Nearly all vertices are on the surface.
    const Labeled_domain domain = domains::thin_plate();
    const Opened_complex<Labeled_c3t3, Labeled_domain> plate(domains::mesh(domain, 0.15), domain, true);
    transfer_cells("thin plate", plate.mesh, plate.mesh.sites, NOT_TRANSFERRED);
  }
  {
    Polyhedral_domain domain(domains::notched_box());
    domain.detect_features();
    const Polyhedral_c3t3 c3t3 = domains::mesh(domain, 0.15, true);
    domain_meshes("box with features", c3t3, domain, TRANSFERRED);
    complexes("box with features", c3t3, domain, true);
  }
  return check::result();
}
