// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The indexed triangulation stays valid under flips and agrees with CGAL's exact
// one while its vertices move, and the minimizer finds a stationary point.

#include "averaging_iteration.h"
#include "check.h"
#include "gradient_of.h"
#include "random_cube_triangulation.h"

#include <CGAL/Global_odt_mesh_3/internal/density/Polynomial_density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flips_3.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <optional>
#include <random>
#include <set>
#include <stdexcept>
#include <vector>

using namespace CGAL::Global_odt_mesh_3::internal;

// Each pair of flips 2-3 and 3-2 leads back to the same cells.
static void flips(std::mt19937& random)
{
  Moving_triangulation_3 mesh = random_cube(3, 60, 0, false, random);
  Indexed_triangulation_3& t = mesh.topology;
  check::that(t.is_valid(), "the indexed triangulation is not valid after loading");
  const auto cells = [&t]
  {
    std::set<std::array<int, 4> > s;
    for(int c = 0; c < t.number_of_cell_slots(); ++c)
      if(t.is_alive(c))
      {
        std::array<int, 4> v = t.cell(c);
        std::sort(v.begin(), v.end());
        s.insert(v);
      }
    return s;
  };
  const auto before = cells();
  int flipped = 0;
  for(int n = 0; n < 4 * static_cast<int>(before.size()); n += 7)
  {
    const Half_facet s(n);
    if(!t.is_alive(s.cell()) || t.neighbor(s).is_side())
      continue;
    const std::array<int, 3> three = flip_2_3(t, s);
    check::that(t.is_valid(), "not valid after flip 2-3");
    const std::optional<Edge_ring_3> ring = ring_of_degree_3(t, three[1], 0, 1);
    check::that(ring.has_value(), "the new edge does not have degree 3");
    if(!ring)
      return;
    flip_3_2(t, *ring);
    check::that(t.is_valid(), "not valid after flip 3-2");
    ++flipped;
  }
  check::that(flipped > 50, "only ", flipped, " flips");
  check::that(cells() == before, "flips 2-3 and 3-2 do not undo each other");
  t.compact();
  check::that(t.is_valid() && cells() == before, "compaction changes cells");
}

// After every step of a random walk, the repaired triangulation is the exact one.
// Lawson's flips may get stuck after a wild step; this must be rare, be noticed
// by is_regular(), and be over with the next step.
static void random_walk(bool weighted, double shift, std::mt19937& random)
{
  Moving_triangulation_3 mesh = random_cube(4, 200, shift, weighted, random);
  check::that(difference_to_exact(mesh) == 0, "loaded triangulation is not CGAL's");
  std::uniform_real_distribution<double> u(-1, 1);
  mesh.keep();
  std::size_t failures = 0, stuck = 0;
  for(int step = 0; step < 40; ++step)
  {
    const double amplitude = step % 2 == 0 ? 0.05 : 0.01;
    mesh.move([&](int, Site& s)
    {
      s.x = std::clamp(s.x - shift + amplitude * u(random), 0.02, 0.98) + shift;
      s.y = std::clamp(s.y - shift + amplitude * u(random), 0.02, 0.98) + shift;
      s.z = std::clamp(s.z - shift + amplitude * u(random), 0.02, 0.98) + shift;
    });
    if(!mesh.evaluate())
    {
      mesh.restore();
      ++failures;
      check::that(mesh.topology.is_valid() && difference_to_exact(mesh) == 0, "not the exact triangulation after restoring");
      continue;
    }
    check::that(mesh.topology.is_valid(), "indexed triangulation not valid after step ", step);
    const std::size_t difference = difference_to_exact(mesh);
    // The energy updated flip by flip is that of a fresh pass.
    const double energy = mesh.energy();
    const Site_gradient g = gradient_of(mesh)[0];
    const bool regular = mesh.is_regular();
    check::that(regular == (difference == 0), difference, " cells differ from CGAL's after step ", step);
    check::that(regular || step % 2 == 0, "not regular after the small step ", step);
    stuck += !regular;
    check::that(std::abs(mesh.energy() - energy) <= 1e-10 * energy, "the energy is not that of the cells");
    check::that(std::abs(gradient_of(mesh)[0].x - g.x) <= 1e-10 * g.diagonal, "the gradient is not that of the cells");
    mesh.keep();
  }
  check::that(failures < 10, failures, " of 40 steps could not be repaired");
  check::that(stuck <= 1, stuck, " of 40 steps did not end on the exact triangulation");
  check::that(mesh.statistics().flips > 1000, "the walk hardly flipped");
}

// Each flip is taken back at once, as rounding may do later.
struct Flips_taken_back
{
  Indexed_triangulation_3& t;
  std::size_t most, number = 0;

  std::array<int, 3> flip_2_3(Half_facet s)
  {
    if(++number > most)
      throw std::runtime_error("endless flips");
    const std::array<int, 3> three = CGAL::Global_odt_mesh_3::internal::flip_2_3(t, s);
    const std::array<int, 2> two = CGAL::Global_odt_mesh_3::internal::flip_3_2(t, *ring_of_degree_3(t, three[0], 0, 1));
    return {{ two[0], two[1], two[1] }};
  }

  std::array<int, 2> flip_3_2(const Edge_ring_3& ring)
  {
    if(++number > most)
      throw std::runtime_error("endless flips");
    const std::array<int, 2> two = CGAL::Global_odt_mesh_3::internal::flip_3_2(t, ring);
    const std::array<int, 3> three = CGAL::Global_odt_mesh_3::internal::flip_2_3(t, Half_facet(two[0], 0));
    return {{ three[0], three[1] }};
  }
};

// Lawson's flips end even if they lead nowhere, whether other facets wait for them or not, and say that facets are left.
static void endless_flips(std::mt19937& random)
{
  std::uniform_real_distribution<double> u(-0.1, 0.1);
  for(int n = 0; n < 20; ++n)
  {
    Moving_triangulation_3 mesh = random_cube(3, 60, 0, false, random);
    for(int v = 0; v < mesh.number_of_movable_vertices; ++v)
      mesh.sites[v].x += u(random);
    std::vector<Half_facet> facets;
    for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
      mesh.push_facets(c, facets);
    std::shuffle(facets.begin(), facets.end(), random);
    Flips_taken_back flips = { mesh.topology, 1000 + 40 * facets.size() };
    bool is_regular = true;
    try { is_regular = Lawson_flips_3<Flips_taken_back>(mesh, flips, facets).make_regular(); }
    catch(const std::runtime_error& e) { check::that(false, e.what()); }
    check::that(flips.number > 0 && !is_regular && facets.empty(), "facets are left, and nothing is said of them");
  }
}

// L-BFGS lowers the energy step by step and reaches a vanishing gradient, lower
// than the AVV iteration ends.
static void minimization(double shift, std::mt19937& random)
{
  Moving_triangulation_3 mesh = random_cube(8, 1500, shift, false, random);
  Moving_triangulation_3 copy = mesh;
  Odt_objective_3 objective(mesh);
  Limited_memory_bfgs minimizer;
  const double tolerance = shift == 0 ? 1e-9 : 1e-8;   // the coordinates' own rounding
  double energy = objective.value();
  int n = 0;
  while(objective.gradient().norm() > tolerance && n < 400)
  {
    if(minimizer.iterate(objective) != Limited_memory_bfgs::STEP_TAKEN)
      break;
    check::that(objective.value() <= energy * (1 + 1e-8), "the energy rose in iteration ", n);
    energy = objective.value();
    if(++n % 50 == 0)
    {
      mesh.topology.compact();
      mesh.keep();
    }
  }
  std::cout << "L-BFGS, origin moved by " << shift << ": " << n << " iterations, |g| "
            << objective.gradient().norm() << ", E " << energy << std::endl;
  check::that(objective.gradient().norm() <= tolerance, "no convergence");
  check::that(difference_to_exact(mesh) <= 4, "the minimizer's triangulation is not CGAL's");

  Odt_objective_3 avv(copy);
  Averaging_iteration averaging;
  for(int i = 0; i < 500; ++i)
    check::that(averaging.iterate(avv), "AVV finds no step in iteration ", i);
  check::that(energy < avv.value(), "AVV finds a lower energy: ", avv.value(), " < ", energy);
}

// A rejected trial, whether it was feasible or not, leaves no trace in the objective nor in the mesh.
static void rejected_trials(std::mt19937& random)
{
  Moving_triangulation_3 mesh = random_cube(4, 200, 0, false, random);
  Linear_density_quadrature_3 quadrature([](int, const Site& s) { return 1 + s.x * s.x + s.y; }, mesh.sites);
  mesh.set_quadrature(&quadrature);
  Odt_objective_3 f(mesh);
  std::uniform_real_distribution<double> u(-1, 1);
  int feasible = 0;
  for(int n = 0; n < 40; ++n)
  {
    const Eigen::VectorXd x = f.point(), g = f.gradient(), d = f.diagonal();
    const double value = f.value();
    const std::vector<double> densities = quadrature.values();
    Eigen::VectorXd trial = x;
    for(double& t : trial)
      t += (n % 2 == 0 ? 0.02 : 1) * u(random);
    if(f.evaluate(trial))
    {
      ++feasible;
      check::that(f.value() != value && f.point() != x && f.gradient() != g && f.diagonal() != d,
                  "a trial changes nothing");
    }
    f.reject();
    check::that(f.value() == value && f.point() == x && f.gradient() == g && f.diagonal() == d,
                "a rejected trial leaves a trace in the objective");
    check::that(mesh.energy() == value && quadrature.values() == densities && mesh.topology.is_valid(),
                "a rejected trial leaves a trace in the mesh");
    for(int v = 0; v < mesh.number_of_movable_vertices; ++v)
    {
      const Site& s = mesh.sites[v];
      check::that(position(s) == vector_at(x, v),
                  "a rejected trial leaves a trace at a vertex of the mesh");
    }
    if(n % 4 == 0 && f.evaluate(x - (g.array() / d.array()).matrix()))
      f.accept();
  }
  check::that(feasible >= 20 && feasible < 40, feasible, " of 40 trials feasible, not all kinds tried");
}

// The objective, of which some trials are said not to be feasible; what is tried is recorded.
struct Function_with_refusals
{
  Odt_objective_3& f;
  int refusals = 0;
  std::vector<Eigen::VectorXd> trials = {};

  double value() const { return f.value(); }
  const Eigen::VectorXd& point() const { return f.point(); }
  const Eigen::VectorXd& gradient() const { return f.gradient(); }
  const Eigen::VectorXd& diagonal() const { return f.diagonal(); }
  bool evaluate(const Eigen::VectorXd& x)
  {
    trials.push_back(x);
    return f.evaluate(x) && refusals-- <= 0;
  }
  void accept() { f.accept(); }
  void reject() { f.reject(); }
};

// Where the direction that curvature gives leads nowhere, the next one is that of the diagonal of the current point.
static void second_direction(std::mt19937& random)
{
  Moving_triangulation_3 mesh = random_cube(4, 200, 0, false, random);
  Odt_objective_3 objective(mesh);
  Function_with_refusals f = { objective };
  Limited_memory_bfgs_parameters parameters;
  Limited_memory_bfgs minimizer(parameters);
  for(int n = 0; n < 5; ++n)
    check::that(minimizer.iterate(f) == Limited_memory_bfgs::STEP_TAKEN, "no step from a random start");
  const Eigen::VectorXd wanted = f.point() - (f.gradient().array() / f.diagonal().array()).matrix();
  f.trials.clear();
  f.refusals = parameters.max_halvings;
  minimizer.iterate(f);
  check::that(f.trials.size() > static_cast<std::size_t>(parameters.max_halvings), "the minimizer gives up");
  if(f.trials.size() > static_cast<std::size_t>(parameters.max_halvings))
    check::that((f.trials[parameters.max_halvings] - wanted).norm() <= 1e-14 * wanted.norm(),
                "the second direction is not that of the current point");
}

// All that flips may change, slots that they have added apart.
struct Snapshot
{
  std::vector<int> vertices, neighbors, incident_cells, constrained_slots;
  std::vector<Site> sites;
  int number_of_cells;

  explicit Snapshot(const Moving_triangulation_3& mesh)
    : Snapshot(mesh, mesh.topology.number_of_half_facets())
  {}

  Snapshot(const Moving_triangulation_3& mesh, int number_of_half_facets)
    : sites(mesh.sites)
    , number_of_cells(mesh.topology.number_of_cells())
  {
    const Indexed_triangulation_3& t = mesh.topology;
    for(int s = 0; s < number_of_half_facets; ++s)
    {
      vertices.push_back(t.vertex(Half_facet(s)));
      neighbors.push_back(t.is_alive(Half_facet(s).cell()) ? t.neighbor(Half_facet(s)).id() : 0);
    }
    for(std::size_t v = 0; v < mesh.sites.size(); ++v)
      incident_cells.push_back(t.incident_cell(static_cast<int>(v)));
    for(int w = 0; w < t.number_of_constrained_facets(); ++w)
      for(int side : { 0, 1 })
        constrained_slots.push_back(t.constrained_half_facet(w, side).id());
  }

  bool describes(const Moving_triangulation_3& mesh) const
  {
    const Snapshot now(mesh, static_cast<int>(vertices.size()));
    for(int s = static_cast<int>(vertices.size()); s < mesh.topology.number_of_half_facets(); ++s)
      if(mesh.topology.is_alive(Half_facet(s).cell()))
        return false;
    return now.vertices == vertices && now.neighbors == neighbors && now.incident_cells == incident_cells
           && now.constrained_slots == constrained_slots && now.number_of_cells == number_of_cells
           && std::equal(now.sites.begin(), now.sites.end(), sites.begin(), sites.end(), [](const Site& a, const Site& b)
                         { return a.x == b.x && a.y == b.y && a.z == b.z && a.weight == b.weight; });
  }
};

// Whether some cell has all of these vertices.
static bool has_cell_with(const Indexed_triangulation_3& t, const std::vector<int>& vertices)
{
  std::vector<Half_facet> star;
  t.star(vertices[0], star);
  return std::any_of(star.begin(), star.end(), [&](Half_facet s)
  {
    return std::all_of(vertices.begin(), vertices.end(), [&](int v) { return t.has_vertex(s.cell(), v); });
  });
}

// Flips of either kind, without regard to where the vertices are; how many of each.
static std::array<int, 2> flip_at_random(Indexed_triangulation_3& t, int attempts, std::mt19937& random)
{
  std::array<int, 2> number = {{ 0, 0 }};
  for(int n = 0; n < attempts; ++n)
  {
    const Half_facet s(std::uniform_int_distribution<int>(0, t.number_of_half_facets() - 1)(random));
    if(!t.is_alive(s.cell()) || t.neighbor(s).is_side())
      continue;
    if(const std::optional<Edge_ring_3> ring = ring_of_degree_3(t, s.cell(), s.index(), (s.index() + 1) % 4))
    {
      if(has_cell_with(t, { t.vertex((*ring)[0]), t.vertex((*ring)[1]), t.vertex((*ring)[2]) }))
        continue;
      flip_3_2(t, *ring);
      ++number[1];
    }
    else if(!has_cell_with(t, { t.vertex(s), t.vertex(t.neighbor(s)) }))
    {
      flip_2_3(t, s);
      ++number[0];
    }
  }
  return number;
}

// However many flips a trial makes, undone it has never been; ended it stays.
static void undone_flips(std::mt19937& random)
{
  Moving_triangulation_3 mesh = random_cube(3, 60, 0, false, random);
  Indexed_triangulation_3& t = mesh.topology;
  std::array<int, 2> number = {{ 0, 0 }};
  for(int n = 0; n < 100; ++n)
  {
    const Snapshot before(mesh);
    t.begin_trial();
    const std::array<int, 2> made = flip_at_random(t, 1 + n, random);
    for(int k : { 0, 1 })
      number[k] += made[k];
    check::that(t.is_valid(), "not valid after flips");
    check::that(made[0] + made[1] == 0 || !before.describes(mesh), "flips change nothing");
    if(n % 5 == 4)
    {
      // What has ended is not undone by the next trial.
      t.end_trial();
      const Snapshot ended(mesh);
      t.begin_trial();
      t.undo_trial();
      check::that(ended.describes(mesh), "an empty trial changes something");
    }
    else
    {
      t.undo_trial();
      check::that(before.describes(mesh) && t.is_valid(), "flips are not undone");
    }
  }
  check::that(number[0] > 500 && number[1] > 100, "only ", number[0], " and ", number[1], " flips");
  t.compact();
  check::that(t.is_valid(), "not valid after compaction");
}

// What cannot be made regular where it is stays as it is, with all vertices, since a trial that fails leaves things half done.
static void infeasible_beginning(std::mt19937& random)
{
  Moving_triangulation_3 mesh = random_cube(3, 60, 0, false, random);
  mesh.sites[0].z = 1.5;
  const auto cells = [&mesh]
  {
    std::vector<std::array<int, 4> > alive;
    for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
      if(mesh.topology.is_alive(c))
        alive.push_back(mesh.topology.cell(c));
    return alive;
  };
  const auto before = cells();
  Odt_objective_3 objective(mesh);
  check::that(!objective.is_feasible() && mesh.statistics().flips > 0, "a vertex outside of the domain is feasible, or nothing is tried");
  check::that(cells() == before, "a trial that fails leaves a trace");
  check::that(objective.gradient().isZero(0) && objective.number_of_frozen_vertices() == objective.number_of_vertices(),
              "vertices of what is not feasible may move");
  Limited_memory_bfgs().iterate(objective);
  check::that(cells() == before && mesh.sites[0].z == 1.5, "the minimizer changes what is not feasible");
}

// As many cells as there may be are found around a vertex in a time that is proportional to their number.
static void large_star()
{
  constexpr int size = 200000;
  Indexed_triangulation_3 ring;
  ring.reserve(2 + size, size);
  for(int c = 0; c < size; ++c)
    ring.add_cell(0, 1, 2 + c, 2 + (c + 1) % size);
  for(int c = 0; c < size; ++c)
  {
    ring.set_neighbors(Half_facet(c, 2), Half_facet((c + 1) % size, 3));
    for(int i = 0; i < 2; ++i)
      ring.set_neighbors(Half_facet(c, i), Half_facet::side(2 * c + i, 0));
  }
  std::vector<Half_facet> slots;
  CGAL::Real_timer timer;
  timer.start();
  ring.star(1, slots);
  check::that(timer.time() < 3, "a star of ", size, " cells takes ", timer.time(), " s");
  std::set<int> cells;
  for(Half_facet s : slots)
    if(ring.vertex(s) == 1)
      cells.insert(s.cell());
  check::that(slots.size() == size && cells.size() == size, cells.size(), " cells in a star of ", size);
}

int main()
{
  const unsigned int seed = 9;
  std::cout << "seed " << seed << std::endl;
  std::mt19937 random(seed);
  flips(random);
  random_walk(false, 0, random);
  random_walk(true, 0, random);
  random_walk(false, 1000, random);
  rejected_trials(random);
  second_direction(random);
  endless_flips(random);
  undone_flips(random);
  infeasible_beginning(random);
  large_star();
  minimization(0, random);
  minimization(1000, random);
  return check::result();
}
