// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MOMENTUM_ANNEALING_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MOMENTUM_ANNEALING_H

#include <CGAL/Global_odt_mesh_3/internal/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Vertex_noise.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

struct Momentum_annealing_parameters
{
  double momentum = 0.75;               // the part of a step that goes on in the next one
  double step_length = 1.4;             // over that of AVV; with this momentum, 1.9 swings up
  double interior_amplitude = 0.14;     // of the noise at the beginning, over the mean incident edge length
  double surface_amplitude = 0.1;
  double decay = 0.6;                   // the exponent of the time left
  double longest_step = 0.3;            // of a vertex, over its mean incident edge length
};

// Gradient steps, longer than the AVV moves (2.3) of the paper, with momentum and with noise whose amplitude falls to zero. Every step that leads to a triangulation is taken,
// whatever the energy says.
class Momentum_annealing
{
public:
  explicit Momentum_annealing(unsigned int seed,
                              const Momentum_annealing_parameters& parameters = Momentum_annealing_parameters())
    : parameters_(parameters)
    , noise_(seed)
  {}

  // To be called when the vertices have got other neighbors or motions: forgets the
  // momentum and measures the edges.
  void start(const Odt_objective_3& f)
  {
    noise_.measure_edges(f);
    velocity_ = Eigen::VectorXd::Zero(f.point().size());
  }

  // One step when the fraction `done` of all steps is behind.
  void iterate(Odt_objective_3& f, double done)
  {
    const double left = std::pow((std::max)(0., 1 - done), parameters_.decay);
    x_ = f.point();
    step_ = parameters_.momentum * velocity_
            - parameters_.step_length * (f.gradient().array() / f.diagonal().array()).matrix();
    shorten_steps(f);
    const Eigen::VectorXd& noise
      = noise_.draw(f, left * parameters_.interior_amplitude, left * parameters_.surface_amplitude);
    if(f.evaluate(x_ + step_ + noise))
    {
      f.keep();
      velocity_ = f.point() - x_ - noise;
    }
    else
    {
      f.reject();
      velocity_ *= 0.5;
    }
  }

private:
  void shorten_steps(const Odt_objective_3& f)
  {
    for(int v = 0; v < f.number_of_vertices(); ++v)
    {
      auto step = step_.segment<3>(3 * v);
      const double longest = f.is_frozen(v) ? 0 : parameters_.longest_step * noise_.mean_edge_length(v);
      const double length = step.norm();
      if(length > longest)
        step *= longest / length;
    }
  }

  Momentum_annealing_parameters parameters_;
  Vertex_noise noise_;
  Eigen::VectorXd x_, step_, velocity_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MOMENTUM_ANNEALING_H
