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
#include <CGAL/Global_odt_mesh_3/internal/optimization/Vector_loop.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// What the last steps of L-BFGS tell about curvature, and the direction that follows: the two-loop recursion (Nocedal
// and Wright, Numerical Optimization, Algorithm 7.4) with the initial matrix gamma D^{-1}.
//
// Both loops only need the products of all pairs, which are kept, and with one other vector, which are computed
// at once: the vectors, too long for a cache, are read three times per direction instead of ten.
class Curvature_pairs
{
public:
  explicit Curvature_pairs(int most, const Thread_policy& threads)
    : threads_(threads)
    , most_(most)
    , products_(most, most)
  {}

  bool empty() const { return pairs_.empty(); }
  void clear() { pairs_.clear(); }

  // The step from x, with gradient g, to another point, with its gradient and D. Negative curvature says nothing of
  // use.
  void add(const Eigen::VectorXd& x, const Eigen::VectorXd& g, const Eigen::VectorXd& other_x,
           const Eigen::VectorXd& other_g, const Eigen::VectorXd& diagonal)
  {
    Pair& p = next_;
    p.s.resize(x.size());
    p.y.resize(x.size());
    const Eigen::VectorXd sums = Vector_loop(threads_, x.size()).sums(4, [&](Eigen::Index n, Eigen::Index l, auto& sum)
    {
      auto s = p.s.segment(n, l), y = p.y.segment(n, l);
      s = other_x.segment(n, l) - x.segment(n, l);
      y = other_g.segment(n, l) - g.segment(n, l);
      sum[0] += s.dot(y);
      sum[1] += s.squaredNorm();
      sum[2] += y.squaredNorm();
      sum[3] += (y.array().square() / diagonal.segment(n, l).array()).sum();
    });
    if(!(sums[0] > 1e-10 * std::sqrt(sums[1] * sums[2])))
      return;
    gamma_ = sums[0] / sums[3];
    append();
  }

  // Sets the direction for the gradient g, and gives its product with g.
  double compute_direction(const Eigen::VectorXd& g, const Eigen::VectorXd& diagonal, Eigen::VectorXd& direction)
  {
    const Vector_loop loop(threads_, g.size());
    const Eigen::VectorXd alpha = first_loop(loop, g);
    const Eigen::VectorXd weight = alpha - second_loop(loop, g, diagonal, alpha, direction);
    return loop.sums(1, [&](Eigen::Index n, Eigen::Index l, auto& sum)
    {
      auto d = direction.segment(n, l);
      for(int i = 0; i < size(); ++i)
        d += weight[i] * pairs_[i].s.segment(n, l);
      d = -d;
      sum[0] += d.dot(g.segment(n, l));
    })[0];
  }

private:
  struct Pair
  {
    Eigen::VectorXd s, y;
  };

  int size() const { return static_cast<int>(pairs_.size()); }

  // The new pair takes the place of the oldest, whose memory serves the next.
  void append()
  {
    if(size() < most_)
      pairs_.emplace_back();
    else
    {
      std::rotate(pairs_.begin(), pairs_.begin() + 1, pairs_.end());
      for(int j = 1; j < most_; ++j)
        products_.col(j - 1).head(most_ - 1) = products_.col(j).tail(most_ - 1).eval();
    }
    std::swap(pairs_.back(), next_);
  }

  // Gives the factors of y, after the products with the newest y have become known.
  Eigen::VectorXd first_loop(const Vector_loop& loop, const Eigen::VectorXd& g)
  {
    const int k = size();
    const Eigen::VectorXd sums = loop.sums(2 * k, [&](Eigen::Index n, Eigen::Index l, auto& sum)
    {
      for(int i = 0; i < k; ++i)
      {
        const auto s = pairs_[i].s.segment(n, l);
        sum[i] += s.dot(g.segment(n, l));
        sum[k + i] += s.dot(pairs_.back().y.segment(n, l));
      }
    });
    Eigen::VectorXd alpha = sums.head(k);
    if(k > 0)
      products_.col(k - 1).head(k) = sums.tail(k);
    for(int i = k - 1; i >= 0; --i)
    {
      for(int j = i + 1; j < k; ++j)
        alpha[i] -= alpha[j] * products_(i, j);
      alpha[i] /= products_(i, i);
    }
    return alpha;
  }

  // Sets the direction to what the initial matrix makes of the rest, and gives what the second loop takes from alpha.
  Eigen::VectorXd second_loop(const Vector_loop& loop, const Eigen::VectorXd& g, const Eigen::VectorXd& diagonal,
                              const Eigen::VectorXd& alpha, Eigen::VectorXd& direction) const
  {
    const int k = size();
    const double gamma = k > 0 ? gamma_ : 1;
    direction.resize(g.size());
    Eigen::VectorXd beta = loop.sums(k, [&](Eigen::Index n, Eigen::Index l, auto& sum)
    {
      auto d = direction.segment(n, l);
      d = g.segment(n, l);
      for(int i = k - 1; i >= 0; --i)
        d -= alpha[i] * pairs_[i].y.segment(n, l);
      d.array() *= gamma / diagonal.segment(n, l).array();
      for(int i = 0; i < k; ++i)
        sum[i] += pairs_[i].y.segment(n, l).dot(d);
    });
    for(int i = 0; i < k; ++i)
    {
      for(int j = 0; j < i; ++j)
        beta[i] += (alpha[j] - beta[j]) * products_(j, i);
      beta[i] /= products_(i, i);
    }
    return beta;
  }

  Thread_policy threads_;
  int most_;
  std::vector<Pair> pairs_;         // from the oldest to the newest
  Pair next_;
  Eigen::MatrixXd products_;        // of s, of the row, and y, of the column, that is not older
  double gamma_ = 1;
};

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
