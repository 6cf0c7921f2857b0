// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Blocks of a mesh: together they are the mesh, what is their own is as there, and a search in them leads to a valid mesh
// of as low an energy, the same for any number of threads.

#include "check.h"
#include "load_triangulation_3.h"

#include <CGAL/Annealing_schedules_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Global_odt_mesh_3/internal/blocks/Block_annealing_3.h>
#include <CGAL/Global_odt_mesh_3/internal/blocks/Mesh_blocks_3.h>
#include <CGAL/Global_odt_mesh_3/internal/blocks/Mesh_partition_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Adaptive_cubature_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Make_density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Point_rule_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Polynomial_density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Surface_cvt_objective_3.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/tags.h>

#include <tbb/global_control.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace CGAL::Global_odt_mesh_3::internal;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Regular_triangulation_3<Kernel> Regular;

static Thread_policy on_threads() { return Thread_policy::for_tag<CGAL::Parallel_tag>(); }

static Moving_triangulation_3 ball(int on_sphere, int inside)
{
  std::mt19937 random(5);
  std::normal_distribution<double> g;
  std::uniform_real_distribution<double> u(0, 1);
  std::vector<Regular::Weighted_point> points;
  for(int n = 0; n < on_sphere + inside; ++n)
  {
    const Vector_3 d = Vector_3(g(random), g(random), g(random)).normalized();
    const Vector_3 p = n < on_sphere ? d : Vector_3(0.97 * std::cbrt(u(random)) * d);
    points.emplace_back(Kernel::Point_3(p[0], p[1], p[2]), 0);
  }
  Moving_triangulation_3 mesh = load_triangulation_3(Regular(points.begin(), points.end()));
  // Those on the sphere move on it.
  mesh.number_of_movable_vertices = static_cast<int>(mesh.sites.size());
  return mesh;
}

// Facets between two halves are constrained, from both sides; the vertices there stay.
static Moving_triangulation_3 halved_ball(int on_sphere, int inside)
{
  Moving_triangulation_3 mesh = ball(on_sphere, inside);
  const auto is_above = [&mesh](int cell)
  {
    double z = 0;
    for(const Site& s : mesh.cell_sites(cell))
      z += s.z;
    return z > 0;
  };
  std::vector<char> is_interior(mesh.sites.size(), false);
  for(int v = 0; v < mesh.number_of_interior_vertices; ++v)
    is_interior[v] = true;
  for(int s = 0; s < mesh.topology.number_of_half_facets(); ++s)
  {
    const Half_facet slot(s), across = mesh.topology.neighbor(slot);
    if(across.is_side() || is_above(slot.cell()) == is_above(across.cell()))
      continue;
    for(int v : mesh.topology.facet(slot))
      is_interior[v] = false;
    const int number = mesh.topology.number_of_constrained_facets();
    mesh.topology.set_neighbors(slot, Half_facet::side(number, 0));
    mesh.topology.set_neighbors(across, Half_facet::side(number, 1));
  }
  std::vector<int> order(mesh.sites.size()), place(mesh.sites.size());
  for(std::size_t v = 0; v < order.size(); ++v)
    order[v] = static_cast<int>(v);
  const auto fixed = std::stable_partition(order.begin(), order.end(), [&](int v) { return is_interior[v]; });
  std::vector<Site> sites;
  for(int v : order)
  {
    place[v] = static_cast<int>(sites.size());
    sites.push_back(mesh.sites[v]);
  }
  mesh.sites.swap(sites);
  mesh.topology.renumber_vertices(place);
  mesh.topology.compact();
  mesh.number_of_interior_vertices = mesh.number_of_movable_vertices = static_cast<int>(fixed - order.begin());
  return mesh;
}

typedef std::set<std::array<int, 4> > Cells;

static Cells cells(const Moving_triangulation_3& mesh)
{
  Cells cells;
  for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
    if(mesh.topology.is_alive(c))
    {
      std::array<int, 4> v = mesh.topology.cell(c);
      std::sort(v.begin(), v.end());
      cells.insert(v);
    }
  return cells;
}

// The vertices of each constrained facet, seen from each side that has a cell.
static std::vector<std::array<int, 3> > constrained_facets(const Moving_triangulation_3& mesh)
{
  std::vector<std::array<int, 3> > facets;
  for(int n = 0; n < mesh.topology.number_of_constrained_facets(); ++n)
    for(int side = 0; side < 2; ++side)
    {
      const Half_facet s = mesh.topology.constrained_half_facet(n, side);
      std::array<int, 3> f = {{ -1, -1, -1 }};
      if(!s.is_none())
        f = mesh.topology.facet(s);
      facets.push_back(rotated(f));
    }
  return facets;
}

// Each cell is in one block, a vertex in the block of its cells if that is one, and no block is much larger than others.
static void partition(const Moving_triangulation_3& mesh)
{
  const int number = 7;
  const Mesh_partition_3 p(mesh, number, Random_source(3), on_threads());
  std::vector<int> block(mesh.topology.number_of_cell_slots(), -1);
  for(int b = 0; b < number; ++b)
    for(int n = p.cells().begin(b); n < p.cells().end(b); ++n)
    {
      check::that(std::exchange(block[p.cells().numbers()[n]], b) == -1, "a cell is in two blocks");
      check::that(n == p.cells().begin(b) || p.cells().numbers()[n - 1] < p.cells().numbers()[n], "cells are out of order");
    }
  std::vector<std::set<int> > blocks(mesh.sites.size());
  for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
  {
    check::that((block[c] >= 0) == mesh.topology.is_alive(c), "a cell is in no block, or one that is not alive is");
    for(int v : mesh.topology.cell(c))
      blocks[v].insert(block[c]);
  }
  std::size_t own = 0;
  for(int b = 0; b < number; ++b)
  {
    for(int n = p.vertices().begin(b); n < p.vertices().end(b); ++n, ++own)
      check::that(blocks[p.vertices().numbers()[n]] == std::set<int>{ b }, "a vertex has cells in other blocks");
    check::that(p.cells().size(b) * number > 0.6 * mesh.topology.number_of_cells()
                && p.cells().size(b) * number < 1.6 * mesh.topology.number_of_cells(), "block ", b, " has ",
                p.cells().size(b), " of ", mesh.topology.number_of_cells(), " cells");
  }
  const auto has_one = [](const std::set<int>& s) { return s.size() == 1; };
  check::that(own == std::size_t(std::count_if(blocks.begin(), blocks.end(), has_one)), "vertices of one block are missing");
}

// What is loaded and stored as it is makes the same mesh; and a block is a valid mesh, in which all facets of the mesh
// that are constrained are so, too.
static void load_and_store(const Moving_triangulation_3& input)
{
  Moving_triangulation_3 mesh = input;
  for(int round = 0; round < 3; ++round)
  {
    const Mesh_partition_3 partition(mesh, 5, Random_source(round), on_threads());
    Mesh_blocks_3 blocks(mesh, partition, on_threads());
    for(int n = 0; n < 5; ++n)
    {
      Moving_triangulation_3 part;
      blocks.load(n, part);
      check::that(part.topology.is_valid(), "block ", n, " is not valid");
      check::that(part.is_regular(), "block ", n, " is not regular");
      for(std::size_t v = 0; v < part.sites.size(); ++v)
        check::that(same_place(part.sites[v], mesh.sites[blocks.vertices(n)[v]])
                    && blocks.number(n, blocks.vertices(n)[v]) == int(v), "vertex ", v, " is another one in block ", n);
      blocks.store(n, part);
    }
    blocks.assemble();
    check::that(mesh.topology.is_valid(), "what is put together is not valid");
    check::that(cells(mesh) == cells(input), "cells are lost or new");
    check::that(constrained_facets(mesh) == constrained_facets(input), "constrained facets are lost or new");
    for(std::size_t v = 0; v < mesh.sites.size(); ++v)
      check::that(mesh.topology.has_vertex(mesh.topology.incident_cell(int(v)), int(v)), "vertex ", v, " has no cell of its own");
  }
}

// The moments in a block are those in the mesh.
static void quadratures(const Moving_triangulation_3& input)
{
  Moving_triangulation_3 mesh = input;
  const Density_quadrature_3::Density density = [](int v, const Site& s) { return 1 + s.x * s.x + 1e-3 * (v % 7); };
  std::vector<std::unique_ptr<Density_quadrature_3> > all;
  all.push_back(std::make_unique<Linear_density_quadrature_3>(density, mesh.sites));
  const Density_quadrature_3::Density smooth = [](int, const Site& s) { return 1 + s.x * s.x + std::exp(s.y); };
  all.push_back(std::make_unique<Density_moment_cache_3>(
    std::make_unique<Point_rule_quadrature_3>(smooth, Point_rule_quadrature_3::fifteen_points())));
  all.push_back(std::make_unique<Adaptive_cubature_quadrature_3>(smooth, 1e-3, 10));
  const Mesh_partition_3 partition(mesh, 4, Random_source(1), on_threads());
  Mesh_blocks_3 blocks(mesh, partition, on_threads());
  Moving_triangulation_3 part;
  blocks.load(2, part);
  for(const auto& q : all)
  {
    const std::unique_ptr<Density_quadrature_3> p = q->part(blocks.vertices(2));
    check::that(p->energy_tolerance() == q->energy_tolerance(), "the tolerance is another one");
    p->update(part.sites, part.number_of_movable_vertices, Thread_policy());
    for(int c = 0; c < part.topology.number_of_cell_slots(); ++c)
    {
      const int* const v = part.topology.vertices(c);
      std::array<int, 4> w;
      for(int i = 0; i < 4; ++i)
        w[i] = blocks.vertices(2)[v[i]];
      check::that(p->moments(c, v, part.sites.data()).first == q->moments(c, w.data(), mesh.sites.data()).first,
                  "the moments are not those of the mesh");
    }
  }
}

static Boundary_complex_3 hull(const Moving_triangulation_3& mesh)
{
  std::vector<Boundary_facet> facets;
  for(int n = 0; n < mesh.topology.number_of_constrained_facets(); ++n)
    facets.push_back({ mesh.topology.facet(mesh.topology.constrained_half_facet(n, 0)), {{ 0, 1 }}, 0 });
  return Boundary_complex_3(facets, mesh.sites.size());
}

// The surfaces add to the gradient of a block's own vertices what they add in the mesh, also where other edges have been
// theirs in between.
static void surface_terms(const Moving_triangulation_3& input)
{
  std::mt19937 random(3);
  std::normal_distribution<double> g(0, 0.1);
  std::vector<Site> elsewhere = input.sites;
  for(int v = input.number_of_interior_vertices; v < input.number_of_movable_vertices; ++v)
    elsewhere[v] = site_at((position(elsewhere[v]) + Vector_3(g(random), g(random), g(random))).normalized(), elsewhere[v].weight);
  for(bool is_graded : { false, true })
  {
    Moving_triangulation_3 mesh = input;
    const int interior = mesh.number_of_interior_vertices, all = mesh.number_of_movable_vertices;
    Surface_density density;
    if(is_graded)
      density = [](int, const Site& s) { return 2 + s.x; };
    Surface_cvt_term_3 term(interior, all - interior, 1.2, density);
    term.follow(hull(mesh), mesh.sites);
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(3 * all), diagonal = Eigen::VectorXd::Ones(3 * all);
    term(mesh.sites, gradient, diagonal);
    Eigen::VectorXd ignored = gradient, also_ignored = diagonal;
    term(elsewhere, ignored, also_ignored);
    term.prepare_parts(mesh.sites);
    const Mesh_partition_3 partition(mesh, 4, Random_source(1), on_threads());
    Mesh_blocks_3 blocks(mesh, partition, on_threads());
    int tested = 0;
    for(int n = 0; n < 4; ++n)
    {
      Moving_triangulation_3 part;
      blocks.load(n, part);
      const int first = part.number_of_interior_vertices, end = part.number_of_movable_vertices;
      Surface_cvt_term_3 of_part = term.part(blocks.vertices(n), first, end - first, [&](int v) { return blocks.number(n, v); });
      Eigen::VectorXd g = Eigen::VectorXd::Zero(3 * end), d = Eigen::VectorXd::Ones(3 * end);
      of_part(part.sites, g, d);
      for(int v = first; v < end; ++v, ++tested)
      {
        const int w = blocks.vertices(n)[v];
        check::that((g.segment<3>(3 * v) - gradient.segment<3>(3 * w)).norm() <= 1e-12 * gradient.segment<3>(3 * w).norm()
                    && std::abs(d[3 * v] - diagonal[3 * w]) <= 1e-12 * diagonal[3 * w], "the term is another one at ", w);
      }
    }
    check::that(tested > 100, "only ", tested, " vertices on the surface are in a block");
  }
}

static std::vector<Tangential_motion> on_sphere(const Moving_triangulation_3& mesh)
{
  std::vector<Tangential_motion> motions;
  for(int v = mesh.number_of_interior_vertices; v < mesh.number_of_movable_vertices; ++v)
    motions.push_back({ position(mesh.sites[v]), 0.02, mesh.sites[v] });
  return motions;
}

// A whole search, with its energy at the end.
static double search(Moving_triangulation_3& mesh, int number_of_blocks, bool is_graded, int iterations)
{
  mesh.set_threads(on_threads());
  Linear_density_quadrature_3 quadrature([](int, const Site& s) { return 1 + 3 * s.x * s.x; }, mesh.sites);
  if(is_graded)
    mesh.set_quadrature(&quadrature);
  std::unique_ptr<Surface_cvt_term_3> term;
  const std::vector<Tangential_motion> motions = on_sphere(mesh);
  if(!motions.empty())
  {
    term = std::make_unique<Surface_cvt_term_3>(mesh.number_of_interior_vertices, int(motions.size()), 1.2, Surface_density());
    term->follow(hull(mesh), mesh.sites);
    Odt_objective_3(mesh, motions, std::ref(*term));
  }
  Block_annealing_3 annealing(mesh, number_of_blocks, 1, CGAL::Momentum_annealing_schedule(), on_threads());
  annealing.start(motions, term.get());
  for(int n = 0; n < iterations; n += 10)
  {
    std::vector<double> done;
    for(int k = n; k < n + 10; ++k)
      done.push_back(double(k) / iterations);
    annealing.iterate(done, [] { return true; });
    check::that(mesh.topology.is_valid(), "the mesh is not valid after iteration ", n);
  }
  Odt_objective_3 objective(mesh);
  check::that(objective.is_feasible(), "the mesh cannot be made regular");
  mesh.set_quadrature(nullptr);
  return mesh.energy();
}

// Vertices that are fixed stay, and so do constrained facets; cells are positive; and in blocks that are as small as these,
// the energy is nearly as low as with one block.
static void searches(const Moving_triangulation_3& input, bool is_graded)
{
  Moving_triangulation_3 in_blocks = input, in_one = input;
  const double one = search(in_one, 1, is_graded, 100), energy = search(in_blocks, 6, is_graded, 100);
  check::that(energy < 1.01 * one, "the energy is ", energy, " and not ", one);
  Moving_triangulation_3 before = input;
  before.is_regular();
  check::that(is_graded || one < 0.9 * before.energy(), "a search leads from ", before.energy(), " to ", one, " only");
  for(int c = 0; c < in_blocks.topology.number_of_cell_slots(); ++c)
    check::that(!in_blocks.is_inverted(c), "cell ", c, " is turned over");
  check::that(constrained_facets(in_blocks) == constrained_facets(input), "constrained facets have been flipped");
  int moved = 0;
  for(int v = 0; v < static_cast<int>(input.sites.size()); ++v)
  {
    const bool has_moved = !same_place(in_blocks.sites[v], input.sites[v]);
    moved += has_moved;
    check::that(!has_moved || v < input.number_of_movable_vertices, "vertex ", v, " is fixed and has moved");
  }
  check::that(moved > 0.99 * input.number_of_movable_vertices, "only ", moved, " vertices have moved");
}

static std::vector<double> coordinates(const Moving_triangulation_3& mesh)
{
  std::vector<double> c;
  for(const Site& s : mesh.sites)
    c.insert(c.end(), { s.x, s.y, s.z });
  return c;
}

static void same_for_all_threads(const Moving_triangulation_3& input, bool is_graded)
{
  std::vector<double> expected;
  for(std::size_t threads : { 1, 2, 3, 8 })
  {
    tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    Moving_triangulation_3 mesh = input;
    search(mesh, 6, is_graded, 20);
    if(expected.empty())
      expected = coordinates(mesh);
    check::that(coordinates(mesh) == expected, threads, " threads lead elsewhere than one");
  }
}

// A density that throws in a block is heard of, and a search that is stopped leaves a valid mesh.
static void ends_before(const Moving_triangulation_3& input)
{
  Moving_triangulation_3 mesh = input;
  std::atomic<long> calls(0);
  Linear_density_quadrature_3 quadrature([&calls](int, const Site&)
  {
    if(++calls > 100000)
      throw std::runtime_error("the density fails");
    return 1.;
  }, mesh.sites);
  mesh.set_quadrature(&quadrature);
  Block_annealing_3 annealing(mesh, 6, 1, CGAL::Momentum_annealing_schedule(), on_threads());
  annealing.start({}, nullptr);
  bool has_thrown = false;
  try { annealing.iterate(std::vector<double>(100, 0.), [] { return true; }); }
  catch(const std::runtime_error&) { has_thrown = true; }
  check::that(has_thrown, "the exception of the density is lost");

  mesh = input;
  mesh.set_quadrature(nullptr);
  Block_annealing_3 stopped(mesh, 6, 1, CGAL::Momentum_annealing_schedule(), on_threads());
  stopped.start({}, nullptr);
  tbb::global_control control(tbb::global_control::max_allowed_parallelism, 1);
  stopped.iterate(std::vector<double>(10, 0.), [] { return false; });
  check::that(coordinates(mesh) == coordinates(input) && cells(mesh) == cells(input), "a search goes on when it may not");
}

int main()
{
  const Moving_triangulation_3 sphere = ball(1500, 8000), halves = halved_ball(1500, 8000);
  for(const Moving_triangulation_3* mesh : { &sphere, &halves })
  {
    partition(*mesh);
    load_and_store(*mesh);
    quadratures(*mesh);
    for(bool is_graded : { false, true })
      searches(*mesh, is_graded);
    same_for_all_threads(*mesh, mesh == &halves);
  }
  surface_terms(sphere);
  ends_before(halves);
  return check::result();
}
