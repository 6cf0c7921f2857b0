// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_STAGE_CLOCK_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_STAGE_CLOCK_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <array>
#include <chrono>
#include <utility>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Where the time of a call goes: the seconds that each stage takes, those of stages within it left out, and how many of
// them are spent in loops that threads share.
class Stage_clock
{
public:
  enum Stage { READ, DENSITY, REMESH, SEARCH, MINIMIZE, TRIANGULATE, CHECK, INDEX, REMOVE_SLIVERS, WRITE, OTHER,
               NUMBER_OF_STAGES };

  static const char* name(int stage)
  {
    static constexpr std::array<const char*, NUMBER_OF_STAGES> names
      = {{ "read", "density", "remesh", "search", "minimize", "triangulate", "check", "index", "remove slivers",
           "write", "other" }};
    return names[stage];
  }

  struct Seconds
  {
    double all = 0, in_loops = 0;
  };

  const Seconds& seconds(int stage) const { return seconds_[stage]; }

  // From here to the end of the scope.
  class In_stage
  {
  public:
    // No clock: nobody wants to know.
    In_stage(Stage_clock* clock, Stage stage) : clock_(clock), outer_(stage)
    {
      if(clock_ != nullptr)
        outer_ = clock_->enter(stage);
    }
    ~In_stage()
    {
      if(clock_ != nullptr)
        clock_->enter(outer_);
    }
    In_stage(const In_stage&) = delete;
    In_stage& operator=(const In_stage&) = delete;

  private:
    Stage_clock* clock_;
    Stage outer_;
  };

  class In_loop
  {
  public:
    explicit In_loop(Stage_clock* clock) : clock_(clock)
    {
      if(clock_ != nullptr)
        begin_ = Clock::now();
    }
    ~In_loop()
    {
      if(clock_ != nullptr)
        clock_->seconds_[clock_->stage_].in_loops += since(begin_);
    }
    In_loop(const In_loop&) = delete;
    In_loop& operator=(const In_loop&) = delete;

  private:
    Stage_clock* clock_;
    std::chrono::steady_clock::time_point begin_;
  };

private:
  typedef std::chrono::steady_clock Clock;

  static double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

  // Gives the stage before.
  Stage enter(Stage stage)
  {
    seconds_[stage_].all += since(begin_);
    begin_ = Clock::now();
    return std::exchange(stage_, stage);
  }

  Stage stage_ = OTHER;
  Clock::time_point begin_ = Clock::now();
  std::array<Seconds, NUMBER_OF_STAGES> seconds_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_STAGE_CLOCK_H
