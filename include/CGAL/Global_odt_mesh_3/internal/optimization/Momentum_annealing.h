// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_MOMENTUM_ANNEALING_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_MOMENTUM_ANNEALING_H

#include <CGAL/Annealing_schedules_3.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Vector_loop.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Vertex_noise.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Gradient steps, longer than the AVV moves (2.3) of the paper, with momentum and with noise
// whose amplitude falls to zero. Every step that leads to a triangulation is taken, whatever
// the energy says.
class Momentum_annealing
{
public:
  explicit Momentum_annealing(unsigned int seed,
                              const Momentum_annealing_schedule& schedule = Momentum_annealing_schedule())
    : schedule_(schedule)
    , noise_(seed)
  {}

  // To be called when the vertices have got other neighbors or motions: forgets the
  // momentum and measures the edges.
  void start(const Odt_objective_3& f)
  {
    noise_.measure_edges(f);
    velocity_ = Eigen::VectorXd::Zero(f.point().size());
  }

  // The same with the momentum of steps before, and lengths of edges that have been measured.
  void start(Eigen::VectorXd velocity, std::vector<double> mean_edge_lengths)
  {
    noise_.set_edges(std::move(mean_edge_lengths));
    velocity_ = std::move(velocity);
  }

  const Eigen::VectorXd& velocity() const { return velocity_; }

  // One step when the fraction `done` of all steps is behind; false if it cannot be taken.
  bool iterate(Odt_objective_3& f, double done)
  {
    const double left = std::pow((std::max)(0., 1 - done), schedule_.decay);
    prepare_step(f, left * schedule_.interior_amplitude, left * schedule_.surface_amplitude);
    const Vector_loop loop(f.threads(), start_.size());
    const bool is_taken = f.evaluate(trial_);
    if(is_taken)
    {
      f.keep();
      loop.run([&](Eigen::Index n, Eigen::Index l)
      {
        velocity_.segment(n, l) = f.point().segment(n, l) - start_.segment(n, l);
      });
    }
    else
    {
      f.reject();
      loop.run([&](Eigen::Index n, Eigen::Index l) { velocity_.segment(n, l) *= 0.5; });
    }
    return is_taken;
  }

private:
  // Few vertices are not worth the trouble of a thread.
  static constexpr int least_vertices = 2000, most_chunks = 16;

  void prepare_step(const Odt_objective_3& f, double interior_amplitude, double surface_amplitude)
  {
    start_.resize(f.point().size());
    trial_.resize(f.point().size());
    noise_.draw();
    const Chunks vertices(f.number_of_vertices(), least_vertices, most_chunks);
    f.threads().for_each_chunk(vertices.number(), [&](int n)
    {
      for(int v = vertices.begin(n); v < vertices.end(n); ++v)
        prepare_step(f, v, interior_amplitude, surface_amplitude);
    });
  }

  // The noise goes into the point from which the step starts, so that it gives no momentum.
  void prepare_step(const Odt_objective_3& f, int v, double interior_amplitude, double surface_amplitude)
  {
    const int n = 3 * v;
    Eigen::Vector3d step = schedule_.momentum * velocity_.segment<3>(n)
                           - schedule_.step_length / f.diagonal()[n] * f.gradient().segment<3>(n);
    const double longest = f.is_frozen(v) ? 0 : schedule_.longest_step * noise_.mean_edge_length(v);
    const double squared_length = step.squaredNorm();
    if(squared_length > longest * longest)
      step *= longest / std::sqrt(squared_length);
    start_.segment<3>(n) = f.point().segment<3>(n)
                           + noise_.displacement(f, v, interior_amplitude, surface_amplitude);
    trial_.segment<3>(n) = start_.segment<3>(n) + step;
  }

  Momentum_annealing_schedule schedule_;
  Vertex_noise noise_;
  Eigen::VectorXd start_, trial_, velocity_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_MOMENTUM_ANNEALING_H
