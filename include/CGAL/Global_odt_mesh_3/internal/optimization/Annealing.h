// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_ANNEALING_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_ANNEALING_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>

#include <CGAL/Annealing_schedules_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The method of the global search, with its constants.
typedef std::variant<Momentum_annealing_schedule, Metropolis_annealing_schedule> Annealing_schedule;

// Random displacements of the vertices, in the scale of their mean incident edges (section 4.3
// of the paper). Those of one vertex do not depend on whether and when others are asked for. The function is
// Odt_objective_3 or what offers the same.
class Vertex_noise
{
public:
  explicit Vertex_noise(unsigned int seed) : seeds_(seed) { draw(); }

  // This has to be called first, and when the edges have got other lengths.
  template <class Function>
  void measure_edges(const Function& f) { f.mean_edge_lengths(edge_length_); }
  // The same with lengths that have been measured.
  void set_edges(std::vector<double> lengths) { edge_length_ = std::move(lengths); }
  double mean_edge_length(int v) const { return edge_length_[v]; }

  // This has to be called when all vertices are to get other displacements.
  void draw() { seed_ = seeds_(); }

  // The displacement of a vertex in a random direction, or its tangential part on surfaces. Its length is uniform between zero and
  // the amplitude times the mean edge. Frozen vertices stay.
  template <class Function>
  Vector_3 displacement(const Function& f, int v, double interior_amplitude, double surface_amplitude) const
  {
    if(f.is_frozen(v))
      return Vector_3();
    Random_numbers<Split_mix_engine> random(Split_mix_engine(seed_, v));
    const Vector_3 direction = random.direction();
    const double length = edge_length_[v] * random.uniform();
    const Vector_3* normal = f.normal(v);
    if(normal == nullptr)
      return interior_amplitude * length * direction;
    return surface_amplitude * length * (direction - normal->dot(direction) * *normal);
  }

private:
  Split_mix_engine seeds_;
  std::uint64_t seed_ = 0;
  std::vector<double> edge_length_;
};

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

  // This has to be called when the vertices have got other neighbors or motions. It forgets the momentum and measures
  // the edges.
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

  // Makes one step when the fraction `done` of all steps has been made; false if it cannot be taken.
  bool iterate(Odt_objective_3& f, double done)
  {
    const double left = std::pow((std::max)(0., 1 - done), schedule_.decay);
    prepare_step(f, left * schedule_.interior_amplitude, left * schedule_.surface_amplitude);
    if(f.evaluate(trial_))
    {
      f.keep();
      velocity_ = f.point() - start_;
      return true;
    }
    f.reject();
    velocity_ *= 0.5;
    return false;
  }

private:
  void prepare_step(const Odt_objective_3& f, double interior_amplitude, double surface_amplitude)
  {
    start_.resize(f.point().size());
    trial_.resize(f.point().size());
    noise_.draw();
    for_each_in_chunks(f.number_of_vertices(), f.threads(),
                       [&](int v) { prepare_step(f, v, interior_amplitude, surface_amplitude); });
  }

  // The noise goes into the point from which the step starts, so that it gives no momentum.
  void prepare_step(const Odt_objective_3& f, int v, double interior_amplitude, double surface_amplitude)
  {
    Vector_3 step = schedule_.momentum * vector_at(velocity_, v)
                    - schedule_.step_length / f.diagonal()[3 * v] * vector_at(f.gradient(), v);
    const double longest = f.is_frozen(v) ? 0 : schedule_.longest_step * noise_.mean_edge_length(v);
    const double squared_length = step.squared_length();
    if(squared_length > longest * longest)
      step *= longest / std::sqrt(squared_length);
    const Vector_3 start = vector_at(f.point(), v) + noise_.displacement(f, v, interior_amplitude, surface_amplitude);
    set_vector(start_, v, start);
    set_vector(trial_, v, start + step);
  }

  Momentum_annealing_schedule schedule_;
  Vertex_noise noise_;
  Eigen::VectorXd start_, trial_, velocity_;
};

// What Algorithm 2 of the paper, the global ODT method, does between minimizations: it perturbs all vertices, and
// accepts the minimum to which they go then if it is lower than the one before or, with the
// probability of Metropolis, a little higher. The temperature is relative to the energy, so that
// the scale of the mesh does not matter. The function is Odt_objective_3 or what offers the same.
class Metropolis_annealing
{
public:
  explicit Metropolis_annealing(unsigned int seed,
                                const Metropolis_annealing_schedule& schedule = Metropolis_annealing_schedule())
    : schedule_(schedule)
    , temperature_(schedule.temperature)
    , random_(seed)
    , noise_(seed)
  {}

  const Metropolis_annealing_schedule& schedule() const { return schedule_; }
  double temperature() const { return temperature_; }

  // Step (1): whether the current point is close to a minimum, that is, what an AVV move (2.3) gains in first order
  // is little against the rises that are accepted.
  template <class Function>
  bool is_near_minimum(const Function& f) const
  {
    const double gain = (f.gradient().array().square() / f.diagonal().array()).sum();
    return gain <= small_part * temperature_ * std::abs(f.value());
  }

  // Step (3): the perturbed point becomes the current one. Noise that breaks the triangulation
  // is halved and, if that does not help, left.
  template <class Function>
  void perturb(Function& f)
  {
    noise_.measure_edges(f);
    noise_.draw();
    start_ = f.point();
    perturbation_.resize(start_.size());
    for(int v = 0; v < f.number_of_vertices(); ++v)
      set_vector(perturbation_, v, noise_.displacement(f, v, schedule_.perturbation, schedule_.perturbation));
    for(int n = 0; n < max_halvings; ++n, perturbation_ /= 2)
    {
      if(f.evaluate(start_ + perturbation_))
      {
        f.keep();
        return;
      }
      f.reject();
    }
  }

  // Step (6). Where the answer is no, the caller goes back to the state before the round.
  bool accepts(double energy_after, double energy_before)
  {
    if(energy_after <= energy_before)
      return true;
    if(std::exp(-relative_rise(energy_before, energy_after) / temperature_) > random_.uniform())
      return true;
    temperature_ *= schedule_.cooling;
    return false;
  }

private:
  static constexpr int max_halvings = 8;
  static constexpr double small_part = 1e-2;

  Metropolis_annealing_schedule schedule_;
  double temperature_;
  Random_source random_;
  Vertex_noise noise_;
  Eigen::VectorXd start_, perturbation_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_ANNEALING_H
