// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_LIMITED_MEMORY_BFGS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_LIMITED_MEMORY_BFGS_H

#include <CGAL/Global_odt_mesh_3/internal/optimization/Curvature_pairs.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Vector_loop.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <Eigen/Core>

#include <cmath>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

struct Limited_memory_bfgs_parameters
{
  int memory = 12;                  // number of correction pairs
  double delta = 0.1;               // of the approximate Wolfe conditions
  double energy_tolerance = 1e-9;   // by how much, relatively, the energy may rise in a step
  int max_halvings = 20;            // of the step length, before giving up
};

// L-BFGS, whose initial matrix is gamma * D^{-1}, D being a diagonal that
// the function gives along with its gradient, and a backtracking line search
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

  // Where it goes does not depend on the threads.
  explicit Limited_memory_bfgs(const Limited_memory_bfgs_parameters& parameters = Limited_memory_bfgs_parameters(),
                               const Thread_policy& threads = Thread_policy())
    : parameters_(parameters)
    , threads_(threads)
    , pairs_(parameters.memory, threads)
  {}

  // Forgets the curvature seen so far, as needed when the function changes.
  void reset() { pairs_.clear(); }

  // One iteration from the function's current point.
  template <class Function>
  Status iterate(Function& f)
  {
    x_.resize(f.point().size());
    g_.resize(f.point().size());
    loop().run([&](Eigen::Index n, Eigen::Index l)
    {
      x_.segment(n, l) = f.point().segment(n, l);
      g_.segment(n, l) = f.gradient().segment(n, l);
    });
    const double energy = f.value();
    for(;;)
    {
      const double slope = pairs_.compute_direction(g_, f.diagonal(), direction_);
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
  template <class Function>
  bool line_search(Function& f, double energy, double slope)
  {
    const double highest = energy + parameters_.energy_tolerance * std::abs(energy);
    double step = 1;
    trial_.resize(x_.size());
    for(int n = 0; n < parameters_.max_halvings; ++n)
    {
      loop().run([&](Eigen::Index b, Eigen::Index l)
      {
        trial_.segment(b, l) = x_.segment(b, l) + step * direction_.segment(b, l);
      });
      const bool feasible = f.evaluate(trial_);
      if(feasible && f.value() <= highest && slope_at(f.gradient()) <= (1 - 2 * parameters_.delta) * -slope)
      {
        // The step really taken, which the function may have shortened at some vertices.
        pairs_.add(x_, g_, f.point(), f.gradient(), f.diagonal());
        f.accept();
        return true;
      }
      f.reject();
      step /= 2;
    }
    return false;
  }

  double slope_at(const Eigen::VectorXd& gradient) const
  {
    return loop().sums(1, [&](Eigen::Index n, Eigen::Index l, auto& sum)
    {
      sum[0] += direction_.segment(n, l).dot(gradient.segment(n, l));
    })[0];
  }

  Vector_loop loop() const { return Vector_loop(threads_, x_.size()); }

  Limited_memory_bfgs_parameters parameters_;
  Thread_policy threads_;
  Curvature_pairs pairs_;
  Eigen::VectorXd x_, g_, direction_, trial_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_LIMITED_MEMORY_BFGS_H
