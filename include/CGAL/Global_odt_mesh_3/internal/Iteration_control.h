// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ITERATION_CONTROL_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ITERATION_CONTROL_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Odt_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Optimization_visitor.h>

#include <CGAL/Mesh_optimization_return_code.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// What the user says of when to stop, and is told about the iterations.
class Iteration_control
{
public:
  Iteration_control(const Odt_parameters& parameters, Optimization_visitor& visitor)
    : parameters_(parameters)
    , visitor_(visitor)
  {
    timer_.start();
  }

  // For an attempt with that many iterations at most, unless the user says otherwise.
  void start(int usual_most_iterations)
  {
    const std::size_t most = parameters_.max_iteration_number;
    most_iterations_ = most == 0 ? usual_most_iterations
                     : static_cast<int>((std::min)(most, std::size_t((std::numeric_limits<int>::max)())));
    iterations_before_ += number_of_iterations_;
    number_of_iterations_ = 0;
    goes_on_ = !is_canceled_;
  }

  // Of the attempt.
  int number_of_iterations() const { return number_of_iterations_; }

  // False once time or iterations are used up, or the user has said so; then code() says why.
  bool goes_on() const { return goes_on_; }
  Mesh_optimization_return_code code() const { return code_; }

  // Whether the time is used up, or the user has said so; what needs no iterations may be done as long as that is not so.
  bool is_stopped() const { return !goes_on_ && code_ == TIME_LIMIT_REACHED; }

  // The fraction of the time that has passed, or 0 if there is no limit.
  double elapsed() const { return parameters_.time_limit > 0 ? timer_.time() / parameters_.time_limit : 0.; }

  // The part that has passed of the time between two fractions of it; all if it was over when it began.
  double progress_between(double begin, double end) const
  {
    return !(parameters_.time_limit > 0) ? 0. : begin < end ? (elapsed() - begin) / (end - begin) : 1.;
  }

  // The largest fraction reported so far.
  double reported() const { return fraction_; }

  bool has_time() const { return elapsed() <= 1; }

  // Whether time and user permit to do more than iterations; changes goes_on() if not.
  bool may_go_on()
  {
    if(has_time() && report(fraction_))
      return true;
    goes_on_ = false;
    code_ = TIME_LIMIT_REACHED;
    return false;
  }

  // Before each iteration, with the fraction of the work that is done; gives goes_on().
  bool begin_iteration(double progress)
  {
    goes_on_ = false;
    code_ = MAX_ITERATION_NUMBER_REACHED;
    if(number_of_iterations_ >= most_iterations_)
      return false;
    code_ = TIME_LIMIT_REACHED;
    if(!has_time() || !report(progress))
      return false;
    goes_on_ = true;
    visitor_.after_compute_moves();
    return true;
  }

  void end_iteration()
  {
    visitor_.after_move_points();
    visitor_.end_of_iteration(iterations_before_ + number_of_iterations_);
    ++number_of_iterations_;
  }

private:
  // The fraction done is the largest of those of the work, the iterations and the time. A callback that has said no is not asked
  // again.
  bool report(double progress)
  {
    if(!parameters_.callback || is_canceled_)
      return !is_canceled_;
    const double iterations = double(number_of_iterations_) / most_iterations_;
    fraction_ = (std::max)(fraction_, (std::min)(1., (std::max)({ progress, iterations, elapsed() })));
    is_canceled_ = !parameters_.callback(fraction_);
    return !is_canceled_;
  }

  const Odt_parameters& parameters_;
  Optimization_visitor& visitor_;
  Real_timer timer_;
  int most_iterations_ = 1, number_of_iterations_ = 0, iterations_before_ = 0;
  bool goes_on_ = true, is_canceled_ = false;
  double fraction_ = 0;
  Mesh_optimization_return_code code_ = CANT_IMPROVE_ANYMORE;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ITERATION_CONTROL_H
