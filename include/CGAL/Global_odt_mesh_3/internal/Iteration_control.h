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

namespace CGAL::Global_odt_mesh_3::internal {

// Applies the user's limits on time and iterations, and reports progress to the user.
class Iteration_control
{
public:
  Iteration_control(const Odt_parameters& parameters, Optimization_visitor& visitor)
    : parameters_(parameters)
    , visitor_(visitor)
  {
    timer_.start();
  }

  double time() const { return timer_.time(); }

  // Called once the mesh is read. Adopting the result of sliver removal and writing the mesh takes about half as long as reading it
  // and, until it is measured, rebuilding takes twice as long.
  void has_read(double begin)
  {
    writing_ = (std::max)(writing_, (time() - begin) / 2);
    rebuilding_ = (std::max)(rebuilding_, 4 * writing_);
  }
  void has_rebuilt(double begin) { rebuilding_ = time() - begin; }

  // Starts an attempt with at most that many iterations, unless the user sets another limit.
  void start(int usual_most_iterations, bool removes_slivers)
  {
    share_of_moves_ = removes_slivers ? 1 - share_of_slivers : 1.;
    const std::size_t most = parameters_.max_iteration_number;
    most_iterations_ = most == 0 ? usual_most_iterations
                     : static_cast<int>((std::min)(most, std::size_t((std::numeric_limits<int>::max)())));
    iterations_before_ += number_of_iterations_;
    number_of_iterations_ = 0;
    goes_on_ = !is_canceled_;
  }

  // The number of iterations in this attempt.
  int number_of_iterations() const { return number_of_iterations_; }

  // The number of iterations in this and all previous attempts.
  int number_of_all_iterations() const { return number_of_iterations_ + iterations_before_; }

  // Whether there is a result to keep if the optimization ends now; note_work() records work other than iterations.
  bool has_work() const { return has_other_work_ || number_of_all_iterations() > 0; }
  void note_work() { has_other_work_ = true; }

  // False once time or iterations are used up or the user cancels; then code() tells why.
  bool goes_on() const { return goes_on_; }
  Mesh_optimization_return_code code() const { return code_; }

  // Whether the user has canceled.
  bool is_canceled() const { return is_canceled_; }

  // Whether the time is used up or the user has canceled; until then, work that needs no iterations may be done.
  bool is_stopped() const { return is_canceled_ || !has_time(); }

  // The fraction of the time for iterations that has passed, or will have passed after a rebuild; 0 without a time limit. The rest
  // of the time is for the last rebuild, sliver removal, and writing.
  double elapsed(bool after_rebuilding = false) const
  {
    if(!(parameters_.time_limit > 0))
      return 0;
    const double end = share_of_moves_ * (parameters_.time_limit - writing_ - rebuilding_);
    return end > 0 ? (time() + (after_rebuilding ? rebuilding_ : 0)) / end : (std::numeric_limits<double>::infinity)();
  }

  // How much of the time between two of these fractions has passed; 1 if `end` is not after `begin`.
  double progress_between(double begin, double end) const
  {
    return !(parameters_.time_limit > 0) ? 0. : begin < end ? (elapsed() - begin) / (end - begin) : 1.;
  }

  // The largest fraction reported so far.
  double reported() const { return fraction_; }

  // Whether there is time left besides that for writing. After the user cancels, there is still a tenth of the time that has passed
  // or the time of a few rebuilds, so that the work done is not lost.
  bool has_time() const
  {
    if(is_canceled_ && time() > canceled_at_ + (std::max)(time_after_end * canceled_at_, rebuildings_after_end * rebuilding_))
      return false;
    return !(parameters_.time_limit > 0) || time() + writing_ <= parameters_.time_limit;
  }

  // Whether time and user permit work other than iterations; if not, goes_on() becomes false.
  bool may_go_on() { return may_go_on(has_time()); }
  // Like may_go_on(), but within the time for iterations.
  bool may_move() { return may_go_on(elapsed() <= 1); }

  // To be called before each iteration with the fraction of the work that is done; returns goes_on().
  bool begin_iteration(double progress)
  {
    goes_on_ = false;
    code_ = MAX_ITERATION_NUMBER_REACHED;
    if(number_of_iterations_ >= most_iterations_)
      return false;
    code_ = TIME_LIMIT_REACHED;
    if(elapsed() > 1 || !report(progress))
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
  static constexpr double share_of_slivers = 0.3, time_after_end = 0.1;
  static constexpr int rebuildings_after_end = 3;

  bool may_go_on(bool is_in_time)
  {
    if(is_in_time && report(fraction_))
      return true;
    goes_on_ = false;
    code_ = TIME_LIMIT_REACHED;
    return false;
  }

  // The fraction reported is the largest of those of the work, the iterations, and the time. A callback that has canceled is not
  // called again.
  bool report(double progress)
  {
    if(!parameters_.callback || is_canceled_)
      return !is_canceled_;
    const double iterations = double(number_of_iterations_) / most_iterations_;
    const double elapsed = parameters_.time_limit > 0 ? time() / parameters_.time_limit : 0.;
    fraction_ = (std::max)(fraction_, (std::min)(1., (std::max)({ progress, iterations, elapsed })));
    is_canceled_ = !parameters_.callback(fraction_);
    canceled_at_ = time();
    return !is_canceled_;
  }

  const Odt_parameters& parameters_;
  Optimization_visitor& visitor_;
  Real_timer timer_;
  int most_iterations_ = 1, number_of_iterations_ = 0, iterations_before_ = 0;
  bool goes_on_ = true, is_canceled_ = false, has_other_work_ = false;
  double fraction_ = 0, share_of_moves_ = 1 - share_of_slivers;
  double writing_ = 0, rebuilding_ = 0, canceled_at_ = 0;   // seconds
  Mesh_optimization_return_code code_ = CANT_IMPROVE_ANYMORE;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ITERATION_CONTROL_H
