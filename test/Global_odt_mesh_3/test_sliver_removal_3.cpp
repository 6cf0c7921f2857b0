// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The removal of slivers: the deficit of angles is what it says, trials leave no trace or an
// exact regular triangulation, and in the end no cell that could be helped is a sliver.

#include "check.h"
#include "random_cube_triangulation.h"

#include <CGAL/Global_odt_mesh_3/internal/blocks/Mesh_partition_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Indexed_relocation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Sliver_removal_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flips_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <optional>
#include <random>
#include <set>
#include <vector>

using namespace CGAL::Global_odt_mesh_3::internal;

typedef std::array<Site, 4> Tetrahedron;

static double deficit(const Tetrahedron& t, double bound)
{
  return Angle_deficit_3(bound)(t);
}

static double determinant(const Tetrahedron& t)
{
  return (position(t[1]) - position(t[0])).cross(position(t[2]) - position(t[0])).dot(position(t[3]) - position(t[0]));
}

static Tetrahedron cell(const Moving_triangulation_3& mesh, int c)
{
  const int* const v = mesh.topology.vertices(c);
  return {{ mesh.sites[v[0]], mesh.sites[v[1]], mesh.sites[v[2]], mesh.sites[v[3]] }};
}

static double sum_of_deficits(const Moving_triangulation_3& mesh, double bound)
{
  double sum = 0;
  for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
    if(mesh.topology.is_alive(c))
      sum += deficit(cell(mesh, c), bound);
  return sum;
}

static int number_of_cells(const Moving_triangulation_3& mesh)
{
  int number = 0;
  for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
    number += mesh.topology.is_alive(c);
  return number;
}

// The deficit is the sum of the squares of what the six angles lack, a function of the shape of
// the cell alone, and nothing where nothing is missing.
static void angle_deficit(std::mt19937& random)
{
  std::uniform_real_distribution<double> u(-1, 1);
  int with_deficit = 0, without = 0, slivers = 0;
  for(int n = 0; n < 2000; ++n)
  {
    Tetrahedron t;
    for(int i = 0; i < 4; ++i)
      t[i] = { u(random), u(random), u(random), 0 };
    if(n % 4 == 1)        // a sliver: a quadrangle that is not quite flat
    {
      const double height = std::pow(10, 4 * u(random) - 5);
      for(int i = 0; i < 4; ++i)
        t[i] = { std::cos(1.57 * i + 0.2 * u(random)), std::sin(1.57 * i + 0.2 * u(random)), height * u(random), 0 };
    }
    if(n % 4 == 2)        // a short edge
      t[1] = { t[0].x + 1e-3 * u(random), t[0].y + 1e-3 * u(random), t[0].z + 1e-3 * u(random), 0 };
    const Cell_shape_3 shape(t[0], t[1], t[2], t[3]);
    for(double bound : { 20., 65., 110. })
    {
      double expected = 0;
      for(double angle : shape.angles)
        expected += angle < bound ? (bound - angle) * (bound - angle) : 0;
      const double found = deficit(t, bound);
      // The angle of a flat cell is as far off as the cosine rounds.
      const double rounding = 1e-3 * bound;
      check::that(std::abs(found - expected) <= rounding, "the deficit of a cell is ", found, ", not ", expected);
      (found > 0 ? with_deficit : without) += 1;
      slivers += n % 4 == 1 && found > 3 * 19 * 19;

      std::array<int, 4> order = {{ 0, 1, 2, 3 }};
      do
      {
        const Tetrahedron permuted = {{ t[order[0]], t[order[1]], t[order[2]], t[order[3]] }};
        check::that(std::abs(deficit(permuted, bound) - found) <= rounding, "the order of the vertices matters");
      }
      while(std::next_permutation(order.begin(), order.end()));
      Tetrahedron elsewhere = t;
      for(Site& s : elsewhere)
        s = { 1024 * s.x + 100, 1024 * s.y - 30, 1024 * s.z + 7, 5 };
      check::that(std::abs(deficit(elsewhere, bound) - found) <= rounding, "position, scale or weight matters");
    }
  }
  check::that(with_deficit > 1000 && without > 100 && slivers > 100, "not all kinds of cells tried: ", with_deficit, ' ',
              without, ' ', slivers);
  const Tetrahedron regular = {{ { 1, 1, 1, 0 }, { 1, -1, -1, 0 }, { -1, 1, -1, 0 }, { -1, -1, 1, 0 } }};
  const double angle = std::acos(1 / 3.) * 180 / CGAL_PI;
  check::that(deficit(regular, angle - 1e-6) == 0, "a regular cell lacks something");
  check::that(std::abs(deficit(regular, angle + 1) - 6) < 1e-9, "a regular cell does not lack one degree six times");
}

// The gradient of each angle that lacks something is what differences say, and that of all vertices together is
// zero, since a translation changes no angle.
static void angle_gradients(std::mt19937& random)
{
  std::uniform_real_distribution<double> u(-1, 1);
  const Angle_deficit_3 angle_deficit(179);
  check::Largest largest_error, largest_sum;
  int tried = 0;
  while(tried < 200)
  {
    Tetrahedron t;
    for(Site& s : t)
      s = { u(random), u(random), u(random), 0 };
    const Cell_shape_3 shape(t[0], t[1], t[2], t[3]);
    if(*std::min_element(shape.angles.begin(), shape.angles.end()) < 5 || !(determinant(t) > 0))
      continue;
    ++tried;
    const auto lacks = [&](const Tetrahedron& moved)
    {
      std::vector<double> result;
      angle_deficit.for_each_lack(moved, [&](double lack) { result.push_back(lack); });
      return result;
    };
    std::vector<Eigen::Vector3d> sum(6, Eigen::Vector3d::Zero());
    for(int m = 0; m < 4; ++m)
    {
      std::vector<Eigen::Vector3d> gradient;
      angle_deficit.for_each_gradient(t, m, [&](double, const Eigen::Vector3d& g) { gradient.push_back(g); });
      check::that(gradient.size() == 6, "only ", gradient.size(), " angles have gradients");
      const Eigen::Vector3d direction = Eigen::Vector3d(u(random), u(random), u(random)).normalized();
      const double h = 1e-6;
      Tetrahedron forward = t, backward = t;
      forward[m] = site_at(position(t[m]) + h * direction, 0);
      backward[m] = site_at(position(t[m]) - h * direction, 0);
      const std::vector<double> after = lacks(forward), before = lacks(backward);
      for(std::size_t n = 0; n < 6; ++n)
      {
        sum[n] += gradient[n];
        const double difference = (before[n] - after[n]) / (2 * h);
        largest_error.add(std::abs(gradient[n].dot(direction) - difference) / (1 + gradient[n].norm()));
      }
    }
    for(const Eigen::Vector3d& s : sum)
      largest_sum.add(s.norm());
  }
  std::cout << "gradients of angles are off by " << largest_error << ", of translations by " << largest_sum << std::endl;
  check::that(largest_error < 1e-5 && largest_sum < 1e-8, "gradients of angles are wrong");
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

// Cells whose dual point a vertex of the interior holds beyond the surface.
static int cells_beyond_surfaces(const Moving_triangulation_3& mesh)
{
  int number = 0;
  for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
    for(int i = 0; i < 4 && mesh.topology.is_alive(c); ++i)
    {
      const int* const v = mesh.topology.vertices(c);
      number += v[i] < mesh.number_of_interior_vertices && mesh.is_beyond_surface(Half_facet(c, i));
    }
  return number;
}

// A vertex that is moved on trial takes the triangulation along: rejected, everything is as
// before, bit by bit; accepted, it is the regular triangulation, and the deficits have changed by
// what the trial has said.
static void vertex_trials(bool weighted, bool has_surface, std::mt19937& random)
{
  const double bound = 30;
  Moving_triangulation_3 mesh = random_cube(4, 200, 0, weighted, random);
  if(has_surface)
    std::fill(mesh.surface_heights.begin(), mesh.surface_heights.end(), 0.);
  Indexed_relocation_3 trial(mesh, bound);
  std::vector<double> edge_length;
  mesh.mean_edge_lengths(edge_length);
  std::uniform_real_distribution<double> u(-1, 1);
  int accepted = 0, rejected = 0, impossible = 0, held_back = 0, beyond = cells_beyond_surfaces(mesh);
  double sum = sum_of_deficits(mesh, bound);
  for(int n = 0; n < 400; ++n)
  {
    const int v = std::uniform_int_distribution<int>(0, mesh.number_of_movable_vertices - 1)(random);
    const double reach = edge_length[v] * (n % 3 == 0 ? 0.8 : 0.2);
    Site s = mesh.sites[v];
    s = { s.x + reach * u(random), s.y + reach * u(random), s.z + reach * u(random), s.weight };
    const Snapshot before(mesh);
    const double change = trial.move(v, s);
    check::that(mesh.topology.is_valid(), "not valid during a trial");
    if(change == (std::numeric_limits<double>::infinity)() || n % 2 == 0)
    {
      trial.reject();
      check::that(before.describes(mesh) && mesh.topology.is_valid(), "a rejected trial leaves a trace");
      if(change != (std::numeric_limits<double>::infinity)())
      {
        // A second time, it is the same trial.
        check::that(trial.move(v, s) == change, "a rejected trial is not repeated");
        trial.reject();
        ++rejected;
        continue;
      }
      ++impossible;
      if(has_surface)
      {
        std::vector<double> heights(mesh.surface_heights.size(), (std::numeric_limits<double>::max)());
        heights.swap(mesh.surface_heights);
        held_back += trial.move(v, s) != (std::numeric_limits<double>::infinity)();
        trial.reject();
        heights.swap(mesh.surface_heights);
      }
      continue;
    }
    trial.accept();
    ++accepted;
    const double sum_before = sum;
    sum = sum_of_deficits(mesh, bound);
    check::that(std::abs(change - (sum - sum_before)) <= 1e-9 * sum, "the deficits change by ", sum - sum_before,
                ", the trial said ", change);
    double kept = 0;
    for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
      kept += trial.deficit(c);
    check::that(std::abs(kept - sum) <= 1e-9 * sum, "the deficits add up to ", sum, ", those kept to ", kept);
    check::that(mesh.topology.is_valid() && (has_surface || mesh.is_regular()),
                "an accepted trial leaves no regular triangulation");
    const int beyond_before = beyond;
    beyond = cells_beyond_surfaces(mesh);
    check::that(beyond <= beyond_before, "an accepted trial pushes a dual point through the surface");
    if(n % 5 == 0)
      check::that(difference_to_exact(mesh) == 0, "an accepted trial leaves another triangulation than CGAL's: ",
                  difference_to_exact(mesh), " cells");
  }
  std::cout << "trials" << (weighted ? " with weights" : "") << (has_surface ? " below a surface" : "") << ": " << accepted
            << " accepted, " << rejected << " rejected, " << impossible << " impossible" << std::endl;
  check::that(accepted > 50 && rejected > 50 && impossible > 20, "not all kinds of trials made");
  check::that(!has_surface || held_back > 0, "the surface holds nothing back");
  check::that(difference_to_exact(mesh) == 0, "the triangulation is not CGAL's in the end");
}

// Trials in a part of the mesh leave all cells that are not of the part as they are, and what they know is known to the whole.
static void trials_in_parts(std::mt19937& random)
{
  const double bound = 30;
  Moving_triangulation_3 mesh = random_cube(4, 600, 0, false, random);
  const Mesh_parts_3 parts(mesh, 2, Random_source(1), Thread_policy());
  const auto cells_outside = [&]
  {
    std::set<std::array<int, 4> > outside;
    for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
      if(mesh.topology.is_alive(c) && parts.part(mesh.topology.cell(c)) != 0)
        outside.insert(sorted(mesh.topology.cell(c)));
    return outside;
  };
  const std::set<std::array<int, 4> > outside = cells_outside();
  const int cells = mesh.topology.number_of_cells();
  Indexed_relocation_3 whole(mesh, bound);
  std::vector<Indexed_triangulation_3> topologies = mesh.topology.split(2, 20);
  whole.make_room();
  check::that(mesh.topology.number_of_cell_slots() >= cells + 40 && number_of_cells(mesh) == cells && mesh.topology.is_valid(),
              "a split alters the whole");
  Indexed_relocation_3 trial(whole, topologies[0], parts, 0, true);
  std::vector<double> edge_length;
  mesh.mean_edge_lengths(edge_length);
  std::uniform_real_distribution<double> u(-1, 1);
  int accepted = 0, refused = 0;
  for(int n = 0; n < 1000; ++n)
  {
    const int v = std::uniform_int_distribution<int>(0, mesh.number_of_movable_vertices - 1)(random);
    const std::size_t refusals = trial.number_of_refusals();
    if(!trial.may_move(v))
      continue;
    Site s = mesh.sites[v];
    const double reach = 0.4 * edge_length[v];
    s = { s.x + reach * u(random), s.y + reach * u(random), s.z + reach * u(random), s.weight };
    const double change = trial.move(v, s);
    const bool is_refused = trial.number_of_refusals() > refusals;
    check::that(!is_refused || !std::isfinite(change), "a trial goes beyond its part");
    refused += is_refused;
    accepted += std::isfinite(change);
    std::isfinite(change) ? trial.accept() : trial.reject();
  }
  std::cout << "trials in a part: " << accepted << " accepted, " << refused << " refused" << std::endl;
  check::that(accepted > 50 && refused > 5, "not all kinds of trials made in a part");
  check::that(cells_outside() == outside, "trials in a part alter cells outside of it");
  mesh.topology.join(topologies);
  whole.join(trial);
  check::that(mesh.topology.is_valid() && mesh.topology.number_of_cells() == number_of_cells(mesh), "parts do not join");
  for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
    check::that(whole.deficit(c) == (mesh.topology.is_alive(c) ? deficit(cell(mesh, c), bound) : 0),
                "the whole does not know a deficit of a part");
}

// What has been accepted since a mark is taken back as a whole, or stays.
static void marked_trials(std::mt19937& random)
{
  const double bound = 30;
  Moving_triangulation_3 mesh = random_cube(4, 200, 0, false, random);
  Indexed_relocation_3 trial(mesh, bound);
  std::vector<double> edge_length;
  mesh.mean_edge_lengths(edge_length);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto kept = [&]
  {
    double sum = 0;
    for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
      sum += trial.deficit(c);
    return sum;
  };
  for(int n = 0; n < 40; ++n)
  {
    const Snapshot before(mesh);
    const double sum_before = kept();
    double change = 0;
    int accepted = 0;
    trial.set_mark();
    for(int m = 0; m < 12; ++m)
    {
      const int v = std::uniform_int_distribution<int>(0, mesh.number_of_movable_vertices - 1)(random);
      Site s = mesh.sites[v];
      const double reach = 0.2 * edge_length[v];
      s = { s.x + reach * u(random), s.y + reach * u(random), s.z + reach * u(random), s.weight };
      const double c = trial.move(v, s);
      if(std::isfinite(c) && m % 3 != 0)
      {
        trial.accept();
        change += c;
        ++accepted;
      }
      else
      {
        const Snapshot now(mesh);
        trial.reject();
        check::that(!now.describes(mesh) && mesh.topology.is_valid(), "a rejected trial after a mark leaves a trace");
      }
    }
    check::that(accepted > 0 && !trial.cells_since_mark().empty(), "nothing is accepted after a mark");
    check::that(std::abs(kept() - sum_before - change) <= 1e-9 * sum_before, "deficits after a mark are not those kept");
    if(n % 2 == 0)
    {
      trial.reject_since_mark();
      check::that(before.describes(mesh) && mesh.topology.is_valid(), "trials since a mark leave a trace");
      check::that(kept() == sum_before, "deficits since a mark are not taken back");
    }
    else
    {
      const Snapshot now(mesh);
      trial.accept_since_mark();
      check::that(now.describes(mesh) && std::abs(sum_of_deficits(mesh, bound) - kept()) <= 1e-9 * sum_before,
                  "accepting what there is changes it");
    }
    check::that(trial.cells_since_mark().empty(), "cells are remembered without a mark");
  }
  check::that(difference_to_exact(mesh) == 0, "the triangulation after marked trials is not CGAL's");
}

// Displacing all vertices of a cell at once leads to less deficit than single vertices do.
static void joint_tries(const Moving_triangulation_3& cube)
{
  const double bound = 38;
  std::array<double, 2> sum = {};
  for(unsigned int seed : { 5, 6, 7, 8 })
    for(bool joint_tries : { false, true })
    {
      Moving_triangulation_3 mesh = cube;
      Sliver_removal_parameters parameters;
      if(!joint_tries)
        parameters.most_joint_tries = 0;
      Sliver_removal_3(mesh, bound, seed, nullptr, parameters).run();
      sum[joint_tries] += sum_of_deficits(mesh, bound);
      check::that(mesh.topology.is_valid() && mesh.is_regular() && difference_to_exact(mesh) <= 4,
                  "the triangulation after joint tries is not CGAL's");
    }
  std::cout << "sum of deficits without joint tries " << sum[0] << ", with them " << sum[1] << std::endl;
  check::that(sum[1] < 0.9 * sum[0], "joint tries improve little");
}

static Moving_triangulation_3 minimized_cube(int grid)
{
  std::mt19937 random(5);
  Moving_triangulation_3 mesh = random_cube(grid, 700, 0, false, random);
  Odt_objective_3 f(mesh);
  Limited_memory_bfgs minimizer;
  for(int n = 0; n < 300 && minimizer.iterate(f) == Limited_memory_bfgs::STEP_TAKEN; ++n)
    ;
  return mesh;
}

// Cells with an angle below the bound that have a vertex with a number below this.
static int slivers(const Moving_triangulation_3& mesh, double bound, int vertices)
{
  int number = 0;
  for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
    if(mesh.topology.is_alive(c))
    {
      const int* const v = mesh.topology.vertices(c);
      number += *std::min_element(v, v + 4) < vertices && deficit(cell(mesh, c), bound) > 0;
    }
  return number;
}

static double energy(Moving_triangulation_3 mesh) { return Odt_objective_3(mesh).value(); }

static bool is_same(const Site& a, const Site& b) { return a.x == b.x && a.y == b.y && a.z == b.z && a.weight == b.weight; }

static bool has_same_sites(const Moving_triangulation_3& a, const Moving_triangulation_3& b)
{
  return std::equal(a.sites.begin(), a.sites.end(), b.sites.begin(), b.sites.end(), is_same);
}

// Every cell that could be helped has been, which costs no more energy than this, relatively; where
// vertices go depends on the seed alone, if there are so many slivers that some need random positions.
static void removal(const Moving_triangulation_3& cube, int least_slivers, double most_rise)
{
  const double bound = 20;
  const auto removed = [&](unsigned int seed)
  {
    Moving_triangulation_3 mesh = cube;
    Sliver_removal_3 removal(mesh, bound, seed);
    removal.run();
    const int before = slivers(cube, bound, cube.number_of_movable_vertices);
    const int after = slivers(mesh, bound, mesh.number_of_movable_vertices);
    const double rise = energy(mesh) / energy(cube) - 1;
    std::cout << "removal, seed " << seed << ": " << before << " -> " << after << " slivers by " << removal.number_of_moves()
              << " moves, E rises by " << 100 * rise << " %" << std::endl;
    check::that(before >= least_slivers, "only ", before, " slivers to remove");
    check::that(after == 0, after, " slivers remain");
    check::that(rise < most_rise, "the energy rises by ", 100 * rise, " %");
    check::that(removal.number_of_moves() > 0 && removal.number_of_surface_moves() == 0, "moves are miscounted");
    check::that(mesh.topology.is_valid() && mesh.is_regular() && difference_to_exact(mesh) <= 4,
                "the triangulation without slivers is not CGAL's");
    int fixed_moved = 0, untouched = 0;
    for(int v = 0; v < static_cast<int>(mesh.sites.size()); ++v)
    {
      fixed_moved += v >= mesh.number_of_movable_vertices && !is_same(mesh.sites[v], cube.sites[v]);
      untouched += v < mesh.number_of_movable_vertices && is_same(mesh.sites[v], cube.sites[v]);
    }
    check::that(fixed_moved == 0, fixed_moved, " vertices moved that may not");
    check::that(untouched > mesh.number_of_movable_vertices / 3, "only ", untouched, " vertices are left alone");
    return mesh;
  };
  const Moving_triangulation_3 first = removed(1);
  check::that(has_same_sites(removed(1), first), "the same seed leads elsewhere");
  check::that(least_slivers < 100 || !has_same_sites(removed(2), first), "another seed leads to the same mesh");
}

static void mean_edges(const Moving_triangulation_3& cube)
{
  std::vector<double> length;
  cube.mean_edge_lengths(length);
  for(int v = 0; v < cube.number_of_movable_vertices; ++v)
    check::that(std::abs(cube.mean_edge_length(v) - length[v]) <= 1e-12 * length[v], "the mean edge of ", v,
                " is another one than among all");
}

// A third of the vertices inside and half of those on the surface stay; the others on the surface
// keep their z, which they lose on approach.
struct Motion_in_layers
  : public Vertex_motion_3
{
  explicit Motion_in_layers(const Moving_triangulation_3& from) : from(from) {}

  bool is_inside(int v) const { return v < from.number_of_interior_vertices; }

  bool approach(int v, Site&) override
  {
    approached += !is_inside(v);
    return is_inside(v) ? v % 3 != 0 : v % 2 == 0;
  }

  bool settle(int v, Site& s) override
  {
    check::that(!is_inside(v), "a vertex of the interior is asked to settle");
    ++settled;
    s.z = from.sites[v].z;
    return true;
  }

  const Moving_triangulation_3& from;
  std::size_t approached = 0, settled = 0;
};

// Vertices move as they are told; without a word, those on a surface stay.
static void removal_at_surface(Moving_triangulation_3 cube)
{
  const double bound = 20;
  cube.number_of_interior_vertices -= 300;
  for(bool moves : { false, true })
  {
    Moving_triangulation_3 mesh = cube;
    Motion_in_layers motion(cube);
    Sliver_removal_3 removal(mesh, bound, 3, moves ? &motion : nullptr);
    removal.run();
    std::size_t moved = 0, against_rule = 0;
    for(int v = 0; v < mesh.number_of_interior_vertices; ++v)
      against_rule += moves && v % 3 == 0 && !is_same(mesh.sites[v], cube.sites[v]);
    for(int v = mesh.number_of_interior_vertices; v < mesh.number_of_movable_vertices; ++v)
    {
      const bool has_moved = !is_same(mesh.sites[v], cube.sites[v]);
      moved += has_moved;
      against_rule += has_moved && (!moves || v % 2 != 0 || mesh.sites[v].z != cube.sites[v].z);
    }
    check::that(against_rule == 0, against_rule, " vertices move where they may not");
    check::that((moved > 0) == moves && (motion.settled > 0) == moves, moved, " vertices move on the surface");
    check::that(moved <= removal.number_of_surface_moves() && removal.number_of_surface_moves() < removal.number_of_moves(),
                "moves on the surface are miscounted");
    check::that(!moves || 2 * motion.settled < motion.approached, "every place is settled, not the promising ones alone");
    std::cout << "at a surface: " << slivers(cube, bound, mesh.number_of_interior_vertices) << " -> "
              << slivers(mesh, bound, mesh.number_of_interior_vertices) << " slivers of interior vertices" << std::endl;
    check::that(slivers(mesh, bound, mesh.number_of_interior_vertices) <= slivers(cube, bound, mesh.number_of_interior_vertices) / 3,
                "slivers of interior vertices remain");
  }
}

// A mesh that is treated in parts first ends with as few slivers and as regular as one that is treated as a whole, also
// if its parts are so small that hardly a vertex may move, or have no room for more cells.
static void removal_in_parts(const Moving_triangulation_3& cube)
{
  const double bound = 30;
  const auto removed = [&](int vertices_of_part, int free_cells)
  {
    Moving_triangulation_3 mesh = cube;
    Sliver_removal_parameters parameters;
    parameters.vertices_of_part = vertices_of_part;
    parameters.free_cells_of_part = free_cells;
    Sliver_removal_3 removal(mesh, bound, 1, nullptr, parameters);
    removal.run();
    // The squares of the grid have two diagonals.
    check::that(mesh.topology.is_valid() && mesh.is_regular() && difference_to_exact(mesh) <= 16,
                "the triangulation after a removal in parts is not CGAL's");
    check::that(mesh.topology.number_of_cells() == number_of_cells(mesh), "cells are lost, or counted twice");
    std::cout << "parts of " << vertices_of_part << " vertices: " << removal.number_of_moves() << " moves, sum of deficits "
              << sum_of_deficits(mesh, bound) << std::endl;
    return mesh;
  };
  const Moving_triangulation_3 whole = removed(1000000, 0);
  for(int vertices : { 100, 300, 600 })
    for(int free_cells : { 0, 100 })
    {
      const Moving_triangulation_3 mesh = removed(vertices, free_cells);
      check::that(!has_same_sites(mesh, whole) || vertices == 100, "nothing is done in parts of ", vertices);
      check::that(sum_of_deficits(mesh, bound) < 1.3 * sum_of_deficits(whole, bound) + 100, "parts of ", vertices,
                  " leave more slivers");
    }
}

// Where nothing may move or the bound is beyond reach, it comes to an end nonetheless.
static void removal_in_vain(const Moving_triangulation_3& cube)
{
  {
    Moving_triangulation_3 fixed = cube;
    fixed.number_of_interior_vertices = fixed.number_of_movable_vertices = 0;
    Sliver_removal_3 removal(fixed, 20, 4);
    removal.run();
    check::that(removal.number_of_moves() == 0 && has_same_sites(fixed, cube), "vertices move though none may");
    check::that(slivers(fixed, 20, static_cast<int>(fixed.sites.size())) > 0, "there were no slivers");
  }
  {
    Moving_triangulation_3 mesh = cube;
    Sliver_removal_3 removal(mesh, 20, 4);
    removal.run();
    check::that(removal.number_of_tries() < 20 * static_cast<std::size_t>(cube.topology.number_of_cells()),
                "tries with a bound within reach are as many as with one that is not");
  }
  // No triangulation has such angles throughout; the tries are in proportion to the cells all the same.
  for(double bound : { 50., 60., 70., 80. })
  {
    Moving_triangulation_3 mesh = cube;
    Sliver_removal_parameters parameters;
    parameters.most_tries = 20 * static_cast<std::size_t>(cube.topology.number_of_cells());
    Sliver_removal_3 removal(mesh, bound, 4, nullptr, parameters);
    removal.run();
    const double before = sum_of_deficits(cube, bound), after = sum_of_deficits(mesh, bound);
    std::cout << "bound " << bound << ", out of reach: sum of deficits " << before << " -> " << after << " by "
              << removal.number_of_moves() << " moves of " << removal.number_of_tries() << " tries" << std::endl;
    check::that(after < before, "the deficits do not fall");
    // The last cell, or joint displacement of a cell, is not broken off.
    const std::size_t for_a_cell = 8 * (parameters.tries_per_vertex + 1);
    check::that(removal.number_of_tries() <= parameters.most_tries + for_a_cell, "bound ", bound, ": ", removal.number_of_tries(), " tries");
    check::that(mesh.topology.is_valid() && mesh.is_regular() && difference_to_exact(mesh) <= 4,
                "the triangulation after many moves is not CGAL's");
  }
}

int main()
{
  const unsigned int seed = 11;
  std::cout << "seed " << seed << std::endl;
  std::mt19937 random(seed);
  angle_deficit(random);
  angle_gradients(random);
  undone_flips(random);
  vertex_trials(false, false, random);
  vertex_trials(true, false, random);
  vertex_trials(false, true, random);
  trials_in_parts(random);
  marked_trials(random);
  // The grid on the surface is coarse for the vertices inside, which makes slivers, or fits them.
  const Moving_triangulation_3 cube = minimized_cube(6);
  mean_edges(cube);
  removal(cube, 100, 0.025);
  removal(minimized_cube(8), 5, 0.005);
  removal_at_surface(cube);
  removal_in_vain(cube);
  removal_in_parts(minimized_cube(10));
  joint_tries(minimized_cube(8));
  return check::result();
}
