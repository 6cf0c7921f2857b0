// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_LIMITED_MEMORY_BFGS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_LIMITED_MEMORY_BFGS_H

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

struct Limited_memory_bfgs_parameters
{
  int memory = 12;                  // number of correction pairs
  double delta = 0.1;               // of the approximate Wolfe condition
  double energy_tolerance = 1e-9;   // by how much, relatively, the energy may rise in a step
  int max_halvings = 20;            // of the step length, before giving up
};

// The two-loop recursion of L-BFGS (Nocedal and Wright, Numerical Optimization,
// Algorithm 7.4) whose initial matrix is gamma * D^{-1}, D being a diagonal that
// the function gives along with its gradient, and a backtracking line search
// that ends on the approximate Wolfe condition (Hager and Zhang, 2005).
//
// The function has to model
//   double value() const;                  at the point last evaluated
//   const Eigen::VectorXd& point() const;
//   const Eigen::VectorXd& gradient() const;
//   const Eigen::VectorXd& diagonal() const;
//   bool evaluate(const Eigen::VectorXd& x);   may alter x; false: not feasible
//   void accept();                         the last point becomes the current one
//   void reject();                         goes back to the current point
class Limited_memory_bfgs
{
public:
  enum Status { STEP_TAKEN, NO_STEP_FOUND };

  explicit Limited_memory_bfgs(const Limited_memory_bfgs_parameters& parameters
                                 = Limited_memory_bfgs_parameters())
    : parameters_(parameters)
  {}

  // Forgets the curvature seen so far, as needed when the function changes.
  void reset() { size_ = 0; }

  // One iteration from the function's current point.
  template <class Function>
  Status iterate(Function& f)
  {
    x_ = f.point();
    g_ = f.gradient();
    const double energy = f.value();
    for(;;)
    {
      compute_direction(f.diagonal());
      const double slope = direction_.dot(g_);
      // What the step may gain has to be more than rounding.
      if(slope < -1e-15 * std::abs(energy) && line_search(f, energy, slope))
        return STEP_TAKEN;
      // The curvature may be stale; try the plain preconditioned gradient.
      if(size_ == 0)
        return NO_STEP_FOUND;
      reset();
    }
  }

private:
  void compute_direction(const Eigen::VectorXd& diagonal)
  {
    direction_ = g_;
    alpha_.resize(size_);
    for(int n = size_ - 1; n >= 0; --n)
    {
      const Pair& p = pair(n);
      alpha_[n] = p.s.dot(direction_) / p.sy;
      direction_ -= alpha_[n] * p.y;
    }
    direction_.array() /= diagonal.array();
    if(size_ > 0)
      direction_ *= pair(size_ - 1).gamma;
    for(int n = 0; n < size_; ++n)
    {
      const Pair& p = pair(n);
      direction_ += (alpha_[n] - p.y.dot(direction_) / p.sy) * p.s;
    }
    direction_ = -direction_;
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
      if(feasible && f.value() <= highest
         && direction_.dot(f.gradient()) <= (1 - 2 * parameters_.delta) * -slope)
      {
        update(f);
        f.accept();
        return true;
      }
      f.reject();
      step /= 2;
    }
    return false;
  }

  // The pair is made of the step really taken, which the function may have
  // shortened at some vertices.
  template <class Function>
  void update(const Function& f)
  {
    if(pairs_.size() < static_cast<std::size_t>(parameters_.memory))
      pairs_.resize(parameters_.memory);
    if(size_ == 0)
      first_ = 0;
    Pair& p = size_ < parameters_.memory ? pair(size_) : pair(0);
    p.s = f.point() - x_;
    p.y = f.gradient() - g_;
    p.sy = p.s.dot(p.y);
    const double yy = (p.y.array().square() / f.diagonal().array()).sum();
    if(!(p.sy > 1e-10 * std::sqrt(p.s.squaredNorm() * p.y.squaredNorm())))
    {
      // Negative curvature says nothing of use; with the memory full it has
      // overwritten the oldest pair, which goes.
      if(size_ == parameters_.memory)
      {
        first_ = (first_ + 1) % parameters_.memory;
        --size_;
      }
      return;
    }
    p.gamma = p.sy / yy;
    if(size_ < parameters_.memory)
      ++size_;
    else
      first_ = (first_ + 1) % parameters_.memory;
  }

  struct Pair
  {
    Eigen::VectorXd s, y;
    double sy, gamma;
  };

  Pair& pair(int n) { return pairs_[(first_ + n) % parameters_.memory]; }

  Limited_memory_bfgs_parameters parameters_;
  std::vector<Pair> pairs_;   // a ring, from the oldest to the newest
  int first_ = 0;
  int size_ = 0;
  std::vector<double> alpha_;
  Eigen::VectorXd x_, g_, direction_, trial_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_LIMITED_MEMORY_BFGS_H
