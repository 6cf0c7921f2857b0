// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_LIMITED_MEMORY_BFGS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_LIMITED_MEMORY_BFGS_H

#include <boost/circular_buffer.hpp>

#include <Eigen/Core>

#include <cmath>
#include <utility>

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

  explicit Limited_memory_bfgs(const Limited_memory_bfgs_parameters& parameters
                                 = Limited_memory_bfgs_parameters())
    : parameters_(parameters)
    , pairs_(parameters.memory)
  {}

  // Forgets the curvature seen so far, as needed when the function changes.
  void reset() { pairs_.clear(); }

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
      if(pairs_.empty())
        return NO_STEP_FOUND;
      reset();
    }
  }

private:
  void compute_direction(const Eigen::VectorXd& diagonal)
  {
    direction_ = g_;
    for(auto p = pairs_.rbegin(); p != pairs_.rend(); ++p)
    {
      p->alpha = p->s.dot(direction_) / p->sy;
      direction_ -= p->alpha * p->y;
    }
    direction_.array() /= diagonal.array();
    if(!pairs_.empty())
      direction_ *= pairs_.back().gamma;
    for(const Pair& p : pairs_)
      direction_ += (p.alpha - p.y.dot(direction_) / p.sy) * p.s;
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
    Pair& p = next_;
    p.s = f.point() - x_;
    p.y = f.gradient() - g_;
    p.sy = p.s.dot(p.y);
    // Negative curvature says nothing of use.
    if(!(p.sy > 1e-10 * std::sqrt(p.s.squaredNorm() * p.y.squaredNorm())))
      return;
    p.gamma = p.sy / (p.y.array().square() / f.diagonal().array()).sum();
    if(!pairs_.full())
    {
      pairs_.push_back(std::move(p));
      return;
    }
    // The new pair takes the place of the oldest, whose memory serves the next.
    std::swap(p, pairs_.front());
    pairs_.rotate(pairs_.begin() + 1);
  }

  struct Pair
  {
    Eigen::VectorXd s, y;
    double sy, gamma, alpha;
  };

  Limited_memory_bfgs_parameters parameters_;
  boost::circular_buffer<Pair> pairs_;    // from the oldest to the newest
  Pair next_;
  Eigen::VectorXd x_, g_, direction_, trial_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_LIMITED_MEMORY_BFGS_H
