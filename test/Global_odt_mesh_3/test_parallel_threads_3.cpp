// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Loops that run on threads give the same, bit for bit, as without.

#include "check.h"
#include "gradient_of.h"
#include "random_cube_triangulation.h"
#include "search_globally.h"

#include <CGAL/Annealing_schedules_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Polynomial_density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/energy/Odt_cell_energies_3.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Fused_pass_3.h>
#include <CGAL/tags.h>

#include <tbb/global_control.h>

#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <stdexcept>
#include <vector>

using namespace CGAL::Global_odt_mesh_3::internal;

static Thread_policy on_threads() { return Thread_policy::for_tag<CGAL::Parallel_tag>(); }

// Each number is in one chunk.
static void chunks()
{
  for(int size : { 0, 1, 7, 99, 100, 101, 1000, 12345, 2000000000 })
    for(int most : { 1, 3, 16 })
    {
      const Chunks c(size, 100, most);
      check::that(c.number() == std::max(1, std::min(size / 100, most)), c.number(), " chunks for ", size);
      check::that(c.begin(0) == 0 && c.end(c.number() - 1) == size, "the chunks do not cover ", size);
      for(int n = 1; n < c.number(); ++n)
        check::that(c.begin(n) == c.end(n - 1) && c.begin(n) < c.end(n), "chunk ", n, " of ", size, " is amiss");
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

// Sorting gives the one order that there is.
static void sorting()
{
  for(const Thread_policy& threads : { Thread_policy(), on_threads() })
    for(int size : { 0, 1, 2, 499, 100000 })
    {
      std::vector<int> numbers;
      for(int n = 0; n < size; ++n)
        numbers.push_back(static_cast<int>((n * 7919ll) % size));
      threads.sort(numbers.begin(), numbers.end(), std::greater<int>());
      for(int n = 0; n < size; ++n)
        check::that(numbers[n] == size - 1 - n, "number ", n, " of ", size, " is ", numbers[n]);
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
    const Cell_energy e = uniform_odt_energy(mesh.products(c), mesh.sites[v[0]], mesh.sites[v[1]], mesh.sites[v[2]], mesh.sites[v[3]]);
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
static std::vector<double> contents(Moving_triangulation_3& mesh)
{
  std::vector<double> c = { mesh.energy() };
  mesh.is_regular();
  for(const Site& s : mesh.sites)
    c.insert(c.end(), { s.x, s.y, s.z });
  for(const Site_gradient& g : gradient_of(mesh))
    c.insert(c.end(), { g.x, g.y, g.z, g.diagonal });
  for(int s = 0; s < mesh.topology.number_of_half_facets(); ++s)
    c.push_back(mesh.topology.cell_vertices()[s]);
  return c;
}

// A density that no thread may ask while another one does.
struct Jealous_density
{
  std::atomic<int>* askers;

  double operator()(int, const Site& s) const
  {
    check::that(++*askers == 1, "the density is asked by several threads");
    const double density = 1 + 10 * s.x * s.x;
    --*askers;
    return density;
  }
};

enum class Grading { NONE, OF_THREADS, OF_ONE_THREAD };

// Where a method leads from the same start.
template <class Method>
static std::vector<double> result(const Moving_triangulation_3& cube, Grading grading, const Thread_policy& threads,
                                  const Method& method)
{
  Moving_triangulation_3 mesh = cube;
  mesh.set_threads(threads);
  std::atomic<int> askers(0);
  Linear_density_quadrature_3 shared([](int, const Site& s) { return 1 + 10 * s.x * s.x; }, mesh.sites, true);
  Linear_density_quadrature_3 jealous(Jealous_density{ &askers }, mesh.sites);
  if(grading != Grading::NONE)
    mesh.set_quadrature(grading == Grading::OF_THREADS ? &shared : &jealous);
  method(mesh);
  const std::vector<double> all = contents(mesh);
  mesh.set_quadrature(nullptr);
  return all;
}

// The same for all numbers of threads, and where there never are any.
template <class Method>
static void same_bits(const char* name, const Method& method)
{
  const Moving_triangulation_3 cube = large_cube();
  for(Grading grading : { Grading::NONE, Grading::OF_THREADS, Grading::OF_ONE_THREAD })
  {
    const std::vector<double> expected = result(cube, grading, Thread_policy(), method);
    for(std::size_t threads : { 1, 2, 3, 8 })
    {
      tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
      check::that(result(cube, grading, on_threads(), method) == expected, name, ": ", threads,
                  " threads lead elsewhere than none");
    }
  }
}

// With the flips and the cells to untangle that its passes find.
static void search(Moving_triangulation_3& mesh)
{
  Odt_objective_3 f(mesh);
  search_globally(mesh, f, CGAL::Momentum_annealing_schedule(), 3, 1);
  check::that(mesh.statistics().flips > 1000 && mesh.statistics().untangled_cells > 0, "the search is too tame");
}

static void minimize(Moving_triangulation_3& mesh)
{
  Odt_objective_3 f(mesh);
  Limited_memory_bfgs minimizer(Limited_memory_bfgs_parameters(), mesh.threads());
  int steps = 0;
  while(steps < 30 && minimizer.iterate(f) == Limited_memory_bfgs::STEP_TAKEN)
    ++steps;
  check::that(steps > 15, "the minimizer gives up after ", steps, " steps");
}

// Sums of parts that are used here and there are those of all that has been added since they were cleared.
static void parts_of_sums()
{
  struct Number
  {
    double x;
    Number& operator+=(const Number& o) { x += o.x; return *this; }
  };
  std::mt19937 random(4);
  Chunked_sums<Number> sums;
  for(std::size_t size : { 1, 63, 64, 1000, 1000, 200 })
  {
    const int parts = 5;
    sums.resize(size, parts);
    std::vector<double> expected(size, 0), found(size, -1);
    for(int p = 0; p < parts; ++p)
    {
      sums.clear(p);
      for(std::size_t n = 0; n < size / 4 + 1; ++n)
      {
        const int place = static_cast<int>(random() % size), value = static_cast<int>(random() % 100);
        sums.part(p).add(place, { double(value) });
        expected[place] += value;
      }
    }
    sums.for_each_sum(0, sums.number_of_blocks(), [&](int n, const Number& sum) { found[n] = sum.x; });
    check::that(found == expected, "wrong sums of ", size);
  }
}

int main()
{
  chunks();
  policy();
  sorting();
  parts_of_sums();
  sums();
  same_bits("search", search);
  same_bits("minimizer", minimize);
  return check::result();
}
