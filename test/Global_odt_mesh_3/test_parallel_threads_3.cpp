// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Loops that run on threads give the same, bit for bit, as on one.

#include "check.h"
#include "gradient_of.h"
#include "random_cube_triangulation.h"
#include "search_globally.h"

#include <CGAL/Annealing_schedules_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Linear_density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/energy/Odt_energy_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunks.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Fused_pass_3.h>
#include <CGAL/tags.h>

#include <tbb/global_control.h>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <vector>

using namespace CGAL::Global_odt_mesh_3::internal;

static Thread_policy on_threads() { return Thread_policy::for_tag<CGAL::Parallel_tag>(); }

// Each number is in one chunk, and chunk() says which.
static void chunks()
{
  for(int size : { 0, 1, 7, 99, 100, 101, 1000, 12345, 2000000000 })
    for(int most : { 1, 3, 16 })
    {
      const Chunks c(size, 100, most);
      check::that(c.number() == std::max(1, std::min(size / 100, most)), c.number(), " chunks for ", size);
      check::that(c.begin(0) == 0 && c.end(c.number() - 1) == size, "the chunks do not cover ", size);
      for(int n = 0; n < c.number() && size > 0; ++n)
        check::that(c.chunk(c.begin(n)) == n && c.chunk(c.end(n) - 1) == n, "chunk ", n, " of ", size, " is not found");
    }
}

// Each chunk is run once, and what one of them throws comes out.
static void policy()
{
  check::that(on_threads().is_parallel(), "Parallel_tag does not lead to threads");
  check::that(!Thread_policy::for_tag<CGAL::Sequential_tag>().is_parallel(), "Sequential_tag leads to threads");
  for(const Thread_policy& threads : { Thread_policy(), on_threads() })
  {
    std::vector<std::atomic<int> > runs(100);
    threads.for_each_chunk(100, [&](int n) { ++runs[n]; });
    for(const std::atomic<int>& r : runs)
      check::that(r == 1, "a chunk is run ", r, " times");
    bool has_thrown = false;
    try { threads.for_each_chunk(100, [](int n) { if(n == 50) throw std::runtime_error("a chunk fails"); }); }
    catch(const std::runtime_error&) { has_thrown = true; }
    check::that(has_thrown, "the exception of a chunk is lost");
  }
}

// With cells enough for several chunks.
static Moving_triangulation_3 large_cube()
{
  std::mt19937 random(17);
  return random_cube(12, 7000, 0, false, random);
}

// The sums over chunks are those over all cells.
static void sums()
{
  Moving_triangulation_3 mesh = large_cube();
  mesh.set_threads(on_threads());
  mesh.is_regular();
  double energy = 0;
  std::vector<Site_gradient> gradient(mesh.sites.size(), Site_gradient{ 0, 0, 0, 0 });
  for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
  {
    const int* const v = mesh.topology.vertices(c);
    const Cell_energy e = Fused_pass_3::cell_energy(mesh.products(c), c, v, mesh.sites.data(), nullptr);
    energy += e.energy;
    for(int i = 0; i < 4; ++i)
      gradient[v[i]] += e.gradient[i];
  }
  check::that(std::abs(mesh.energy() - energy) <= 1e-12 * energy, "the energy is not that of the cells");
  const std::vector<Site_gradient> found = gradient_of(mesh);
  for(std::size_t v = 0; v < gradient.size(); ++v)
  {
    const Site_gradient &g = gradient[v], &h = found[v];
    const double tolerance = 1e-12 * g.diagonal;
    check::that(std::abs(g.x - h.x) <= tolerance && std::abs(g.y - h.y) <= tolerance && std::abs(g.z - h.z) <= tolerance
                && std::abs(g.diagonal - h.diagonal) <= tolerance, "the gradient at ", v, " is not that of the cells");
  }
}

// All that a mesh ends with, in numbers.
static std::vector<double> contents(const Moving_triangulation_3& mesh)
{
  std::vector<double> c = { mesh.energy() };
  for(const Site& s : mesh.sites)
    c.insert(c.end(), { s.x, s.y, s.z });
  for(const Site_gradient& g : gradient_of(mesh))
    c.insert(c.end(), { g.x, g.y, g.z, g.diagonal });
  for(int s = 0; s < mesh.topology.number_of_slots(); ++s)
    c.push_back(mesh.topology.cell_vertices()[s]);
  return c;
}

// A search, with the flips and the cells to untangle that its passes find, in uniform and in graded density.
static std::vector<double> searched(const Moving_triangulation_3& cube, bool is_graded)
{
  Moving_triangulation_3 mesh = cube;
  mesh.set_threads(on_threads());
  Linear_density_quadrature_3 quadrature([](int, const Site& s) { return 1 + 10 * s.x * s.x; }, mesh.sites);
  if(is_graded)
    mesh.set_quadrature(&quadrature);
  Odt_objective_3 f(mesh);
  CGAL::Momentum_annealing_schedule schedule;
  search_globally(mesh, f, schedule, 3, 1);
  check::that(mesh.statistics().flips > 1000 && mesh.statistics().untangled_cells > 0, "the search is too tame");
  mesh.set_quadrature(nullptr);
  return contents(mesh);
}

static void searches()
{
  const Moving_triangulation_3 cube = large_cube();
  for(bool is_graded : { false, true })
  {
    std::vector<double> expected;
    for(std::size_t threads : { 1, 2, 3, 8 })
    {
      tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      const std::vector<double> found = searched(cube, is_graded);
      if(expected.empty())
        expected = found;
      check::that(found == expected, threads, " threads lead elsewhere than one");
    }
  }
}

int main()
{
  chunks();
  policy();
  sums();
  searches();
  return check::result();
}
