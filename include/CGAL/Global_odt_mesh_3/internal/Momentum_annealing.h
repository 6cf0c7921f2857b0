// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MOMENTUM_ANNEALING_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MOMENTUM_ANNEALING_H

#include <CGAL/Global_odt_mesh_3/internal/Odt_objective_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

struct Momentum_annealing_parameters
{
  double momentum = 0.8;                // the part of a step that goes on in the next one
  double interior_amplitude = 0.15;     // of the noise at the beginning, over the mean incident edge length
  double surface_amplitude = 0.1;
  double decay = 0.6;                   // the exponent of the time left
  double longest_step = 0.3;            // of a vertex, over its mean incident edge length
};

// Gradient steps of length 1/D, the AVV moves (2.3) of the paper, with momentum and with
// noise whose amplitude falls to zero. Every step that leads to a triangulation is taken,
// whatever the energy says.
class Momentum_annealing
{
public:
  explicit Momentum_annealing(unsigned int seed,
                              const Momentum_annealing_parameters& parameters = Momentum_annealing_parameters())
    : parameters_(parameters)
    , random_(seed)
  {}

  // To be called when the vertices have got other neighbors or motions: forgets the
  // momentum and measures the edges.
  void start(const Odt_objective_3& f)
  {
    f.mean_edge_lengths(edge_length_);
    velocity_ = Eigen::VectorXd::Zero(f.point().size());
  }

  // One step when the fraction `done` of all steps is behind.
  void iterate(Odt_objective_3& f, double done)
  {
    const double left = std::pow((std::max)(0., 1 - done), parameters_.decay);
    x_ = f.point();
    step_ = parameters_.momentum * velocity_ - (f.gradient().array() / f.diagonal().array()).matrix();
    noise_.resize(x_.size());
    for(int v = 0; v < f.number_of_vertices(); ++v)
    {
      auto step = step_.segment<3>(3 * v);
      auto noise = noise_.segment<3>(3 * v);
      noise = random_direction();
      if(f.is_frozen(v))
      {
        step.setZero();
        noise.setZero();
        continue;
      }
      const double longest = parameters_.longest_step * edge_length_[v], length = step.norm();
      if(length > longest)
        step *= longest / length;
      const bool on_surface = f.normal(v) != nullptr;
      if(on_surface)
      {
        const Eigen::Map<const Eigen::Vector3d> n(f.normal(v)->data());
        noise -= n.dot(noise) * n;
      }
      noise *= left * edge_length_[v] * uniform_(random_)
               * (on_surface ? parameters_.surface_amplitude : parameters_.interior_amplitude);
    }
    if(f.evaluate(x_ + step_ + noise_))
    {
      f.keep();
      velocity_ = f.point() - x_ - noise_;
    }
    else
    {
      f.reject();
      velocity_ *= 0.5;
    }
  }

private:
  Eigen::Vector3d random_direction()
  {
    Eigen::Vector3d d;
    do
      d = { normal_(random_), normal_(random_), normal_(random_) };
    while(d.squaredNorm() < 1e-12);
    return d.normalized();
  }

  Momentum_annealing_parameters parameters_;
  std::mt19937 random_;
  std::uniform_real_distribution<double> uniform_{ 0, 1 };
  std::normal_distribution<double> normal_;
  std::vector<double> edge_length_;
  Eigen::VectorXd x_, step_, noise_, velocity_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MOMENTUM_ANNEALING_H
