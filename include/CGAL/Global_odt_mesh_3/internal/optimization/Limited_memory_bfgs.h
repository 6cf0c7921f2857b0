// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_LIMITED_MEMORY_BFGS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_LIMITED_MEMORY_BFGS_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/density/Density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

struct Limited_memory_bfgs_parameters
{
  int memory = 12;                  // number of correction pairs
  double delta = 0.1;               // of the approximate Wolfe conditions
  double energy_tolerance = 1e-9;   // by how much, relatively, the energy may rise in a step
  int max_halvings = 20;            // of the step length, before giving up
};

// L-BFGS by the two-loop recursion (Nocedal and Wright, Numerical Optimization, Algorithm 7.4), whose initial matrix is
// gamma * D^{-1}, D being a diagonal that the function gives along with its gradient, and a backtracking line search
// that ends on the first of the two approximate Wolfe conditions (Hager and Zhang, 2005): the slope must not have become
// too steep upward. The second one is against steps that are too short, and this search only shortens them; steps of
// negative curvature are no correction pairs.
//
// The function has to model
//   double value() const;                  at the current point or, after evaluate(), at the trial
//   const Eigen::VectorXd& point() const;
//   const Eigen::VectorXd& gradient() const;
//   const Eigen::VectorXd& diagonal() const;
//   bool evaluate(const Eigen::VectorXd& x);   may alter x; false: not feasible
//   void accept();                         the trial becomes the current point
//   void reject();                         goes back to the current point, with all of the above
class Limited_memory_bfgs
{
public:
  enum Status { STEP_TAKEN, NO_STEP_FOUND };

  // The result does not depend on the threads.
  explicit Limited_memory_bfgs(const Limited_memory_bfgs_parameters& parameters = Limited_memory_bfgs_parameters(),
                               const Thread_policy& threads = Thread_policy())
    : parameters_(parameters)
    , threads_(threads)
  {}

  // Forgets the curvature seen so far, as needed when the function changes.
  void reset() { pairs_.clear(); }

  // Makes one iteration from the function's current point.
  template <class Function>
  Status iterate(Function& f)
  {
    x_ = f.point();
    g_ = f.gradient();
    const double energy = f.value();
    for(;;)
    {
      compute_direction(f.diagonal());
      const double slope = dot(direction_, g_);
      // What the step may gain has to be more than rounding.
      if(slope < -1e-15 * std::abs(energy) && line_search(f, energy, slope))
        return STEP_TAKEN;
      // The curvature may be stale; try the plain preconditioned gradient.
      if(pairs_.empty())
        return NO_STEP_FOUND;
      reset();
    }
  }

private:
  static constexpr int least_length = 16384, most_segments = 16;

  // A step, the change of the gradient, and their product.
  struct Pair
  {
    Eigen::VectorXd s, y;
    double product;
  };

  void compute_direction(const Eigen::VectorXd& diagonal)
  {
    const double gamma = pairs_.empty() ? 1 : gamma_;
    std::vector<double> alpha(pairs_.size());
    direction_ = -g_;
    for(std::size_t n = pairs_.size(); n-- > 0; )
    {
      alpha[n] = dot(pairs_[n].s, direction_) / pairs_[n].product;
      add_to_direction(-alpha[n], pairs_[n].y);
    }
    for_each_segment([&](int, Eigen::Index n, Eigen::Index l)
    {
      direction_.segment(n, l).array() *= gamma / diagonal.segment(n, l).array();
    });
    for(std::size_t n = 0; n < pairs_.size(); ++n)
      add_to_direction(alpha[n] - dot(pairs_[n].y, direction_) / pairs_[n].product, pairs_[n].s);
  }

  void add_to_direction(double factor, const Eigen::VectorXd& x)
  {
    for_each_segment([&](int, Eigen::Index n, Eigen::Index l) { direction_.segment(n, l) += factor * x.segment(n, l); });
  }

  template <class Function>
  bool line_search(Function& f, double energy, double slope)
  {
    const double highest = energy + parameters_.energy_tolerance * std::abs(energy);
    double step = 1;
    for(int n = 0; n < parameters_.max_halvings; ++n)
    {
      trial_ = x_ + step * direction_;
      const bool feasible = f.evaluate(trial_);
      if(feasible && f.value() <= highest && dot(direction_, f.gradient()) <= (1 - 2 * parameters_.delta) * -slope)
      {
        add_pair(f.point(), f.gradient(), f.diagonal());
        f.accept();
        return true;
      }
      f.reject();
      step /= 2;
    }
    return false;
  }

  // Adds the pair of the step really taken, which the function may have shortened at some vertices. A negative curvature is of no
  // use.
  void add_pair(const Eigen::VectorXd& x, const Eigen::VectorXd& g, const Eigen::VectorXd& diagonal)
  {
    Pair p = { x - x_, g - g_, 0 };
    p.product = dot(p.s, p.y);
    if(!(p.product > 1e-10 * p.s.norm() * p.y.norm()))
      return;
    gamma_ = p.product / (p.y.array().square() / diagonal.array()).sum();
    if(static_cast<int>(pairs_.size()) == parameters_.memory)
      pairs_.pop_front();
    pairs_.push_back(std::move(p));
  }

  // Calls f(k, begin, length) for the segments k of long vectors, on threads, which have no part in what they are.
  template <class F>
  void for_each_segment(const F& f) const
  {
    const Chunks segments(static_cast<int>(x_.size()), least_length, most_segments);
    threads_.for_each_chunk(segments.number(), [&](int k)
    {
      f(k, Eigen::Index(segments.begin(k)), Eigen::Index(segments.end(k) - segments.begin(k)));
    });
  }

  double dot(const Eigen::VectorXd& x, const Eigen::VectorXd& y) const
  {
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(most_segments);
    for_each_segment([&](int k, Eigen::Index n, Eigen::Index l) { sums[k] = x.segment(n, l).dot(y.segment(n, l)); });
    return sums.sum();
  }

  Limited_memory_bfgs_parameters parameters_;
  Thread_policy threads_;
  std::deque<Pair> pairs_;      // from the oldest to the newest
  double gamma_ = 1;
  Eigen::VectorXd x_, g_, direction_, trial_;
};

// How the energy with that quadrature of the density, or without any, is minimized.
inline Limited_memory_bfgs_parameters minimizer_parameters(const Density_quadrature_3* quadrature)
{
  Limited_memory_bfgs_parameters p;
  if(quadrature != nullptr)
  {
    p.memory = 15;      // graded meshes take more iterations
    p.energy_tolerance = quadrature->energy_tolerance();
  }
  return p;
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_LIMITED_MEMORY_BFGS_H
