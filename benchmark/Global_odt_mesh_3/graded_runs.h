// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_GRADED_RUNS_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_GRADED_RUNS_H

#include "cpu_seconds.h"
#include "function_density_3.h"

#include <CGAL/Global_odt_mesh_3/internal/density/Field_density_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Make_density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/energy/Reference_energy_3.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Cell_order.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <ostream>
#include <utility>
#include <vector>

// The energy (2.5) of a mesh, whatever the mesh believes.
inline double true_energy(const CGAL::Global_odt_mesh_3::internal::Moving_triangulation_3& mesh,
                          CGAL::Global_odt_mesh_3::internal::Density_3& density, double tolerance)
{
  std::vector<CGAL::Global_odt_mesh_3::internal::Cell_vertices> cells;
  for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
    if(mesh.topology.is_alive(c))
      cells.push_back(mesh.topology.cell(c));
  return reference_energy(mesh.sites, cells, density, CGAL::Adaptive_cubature_3{ tolerance });
}

// A mesh with its density integrated by a quadrature.
class Graded_run
{
public:
  typedef CGAL::Global_odt_mesh_3::internal::Moving_triangulation_3 Mesh;
  typedef CGAL::Global_odt_mesh_3::internal::Odt_objective_3 Objective;
  typedef CGAL::Global_odt_mesh_3::internal::Density_quadrature_3 Quadrature;

  Graded_run(const Mesh& mesh, std::unique_ptr<Quadrature> quadrature)
    : mesh_(mesh)
    , quadrature_(std::move(quadrature))
    , order_(mesh_)
  {
    mesh_.set_quadrature(quadrature_.get());
    objective_ = std::make_unique<Objective>(mesh_);
  }

  Graded_run(const Graded_run&) = delete;

  Mesh& mesh() { return mesh_; }
  Objective& objective() { return *objective_; }
  double time() const { return time_; }
  int iterations() const { return iterations_; }

  // `iterate()`, which says whether it has moved anything, at most so often; `after()` is not timed.
  template <class Iterate, class After>
  void repeat(int times, const Iterate& iterate, const After& after)
  {
    for(int n = 0; n < times; ++n)
    {
      bool moved = false;
      time_ += seconds([&] { moved = iterate(n); order_.maintain(mesh_); });
      if(!moved)
        break;
      ++iterations_;
      after();
    }
  }

  template <class Iterate>
  void repeat(int times, const Iterate& iterate) { repeat(times, iterate, [] {}); }

private:
  Mesh mesh_;
  std::unique_ptr<Quadrature> quadrature_;
  CGAL::Global_odt_mesh_3::internal::Cell_order order_;
  std::unique_ptr<Objective> objective_;
  double time_ = 0;
  int iterations_ = 0;
};

// What becomes of the true energy from one iteration of a run to the next.
class Energy_trace
{
public:
  struct Step
  {
    double time, energy, gradient;
  };

  void add(double energy, Graded_run& run)
  {
    steps_.push_back({ run.time(), energy, run.objective().gradient().norm() });
    if(energy > last_)
    {
      ++rises_;
      largest_rise_ = (std::max)(largest_rise_, energy / last_ - 1);
    }
    last_ = energy;
    lowest_ = (std::min)(lowest_, energy);
  }

  double last() const { return last_; }
  double lowest() const { return lowest_; }
  int rises() const { return rises_; }
  double largest_rise() const { return largest_rise_; }   // relatively
  const std::vector<Step>& steps() const { return steps_; }

private:
  double last_ = (std::numeric_limits<double>::max)(), lowest_ = last_, largest_rise_ = 0;
  int rises_ = 0;
  std::vector<Step> steps_;
};

// As a block of a data file: iteration, time, energy, gradient.
inline void write_trace(const Energy_trace& trace, std::ostream& out)
{
  int n = 0;
  out.precision(10);
  for(const Energy_trace::Step& s : trace.steps())
    out << ++n << ' ' << s.time << ' ' << s.energy << ' ' << s.gradient << '\n';
  out << "\n\n";
}

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_GRADED_RUNS_H
