// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_THREAD_POLICY_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_THREAD_POLICY_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/blocked_range.h>
#  include <tbb/parallel_for.h>
#  include <tbb/parallel_invoke.h>
#  include <tbb/parallel_sort.h>
#  include <tbb/partitioner.h>
#  include <tbb/task_arena.h>
#  include <tbb/task_group.h>
#endif

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <type_traits>
#include <utility>

namespace CGAL::Global_odt_mesh_3::internal {

// The seconds that each stage of a call takes, without those of stages within it.
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

  double seconds(int stage) const { return seconds_[stage]; }

  // The stage lasts from here to the end of the scope.
  class In_stage
  {
  public:
    // No clock: nobody wants to know.
    In_stage(Stage_clock* clock, Stage stage) : clock_(clock), outer_(clock != nullptr ? clock->enter(stage) : stage) {}
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

private:
  typedef std::chrono::steady_clock Clock;

  // Gives the stage before.
  Stage enter(Stage stage)
  {
    const Clock::time_point begin = std::exchange(begin_, Clock::now());
    seconds_[stage_] += std::chrono::duration<double>(begin_ - begin).count();
    return std::exchange(stage_, stage);
  }

  Stage stage_ = OTHER;
  Clock::time_point begin_ = Clock::now();
  std::array<double, NUMBER_OF_STAGES> seconds_ = {};
};

// Whether loops run on one thread or on those that TBB has for the caller, whose arena and limits they keep to.
// Nothing else knows TBB.
class Thread_policy
{
public:
  // Loops run on one thread.
  Thread_policy() {}

  // Threads for what is made for them, if TBB is linked.
  template <class Concurrency_tag>
  static Thread_policy for_tag()
  {
    Thread_policy policy;
#ifdef CGAL_LINKED_WITH_TBB
    policy.is_parallel_ = std::is_convertible<Concurrency_tag, Parallel_tag>::value;
#endif
    return policy;
  }

  bool is_parallel() const { return is_parallel_; }

  // The same, with a clock for the stages of what uses it.
  Thread_policy with(Stage_clock& clock) const
  {
    Thread_policy policy = *this;
    policy.clock_ = &clock;
    return policy;
  }

  // Or null.
  Stage_clock* clock() const { return clock_; }

  // Calls f(n) for the chunks n of a loop, with threads in any order and several at once. What f throws
  // comes out here.
  template <class F>
  void for_each_chunk(int number_of_chunks, const F& f) const
  {
#ifdef CGAL_LINKED_WITH_TBB
    if(is_parallel_ && number_of_chunks > 1)
      return run_chunks(number_of_chunks, std::cref(f));
#endif
    for(int n = 0; n < number_of_chunks; ++n)
      f(n);
  }

  // Calls f and g, which know nothing of each other, at the same time if there are threads. Only one of them may have loops.
  template <class F, class G>
  void run_both(const F& f, const G& g) const
  {
#ifdef CGAL_LINKED_WITH_TBB
    if(is_parallel_)
    {
      tbb::task_group_context context(tbb::task_group_context::bound, context_traits());
      tbb::parallel_invoke(f, g, context);
      return;
    }
#endif
    f();
    g();
  }

  // Calls f, what the user has given, from within a loop: while threads of its own are waited for, no other chunk is begun.
  template <class F>
  auto call_isolated(const F& f) const
  {
#ifdef CGAL_LINKED_WITH_TBB
    return tbb::this_task_arena::isolate(f);
#else
    return f();
#endif
  }

  // Sorts elements that are all different, so that there is one order.
  template <class Iterator, class Less>
  void sort(Iterator begin, Iterator end, const Less& less) const
  {
#ifdef CGAL_LINKED_WITH_TBB
    if(is_parallel_)
    {
      tbb::parallel_sort(begin, end, less);
      return;
    }
#endif
    std::sort(begin, end, less);
  }

private:
#ifdef CGAL_LINKED_WITH_TBB
  // All threads round as the one that calls.
  static std::uintptr_t context_traits() { return tbb::task_group_context::default_traits | tbb::task_group_context::fp_settings; }

  // This is one function for all loops, as what TBB makes of each takes time to compile.
  static void run_chunks(int number_of_chunks, const std::function<void(int)>& f)
  {
    const auto run = [&f](const tbb::blocked_range<int>& chunks)
    {
      for(int n = chunks.begin(); n < chunks.end(); ++n)
        f(n);
    };
    tbb::task_group_context context(tbb::task_group_context::bound, context_traits());
    tbb::parallel_for(tbb::blocked_range<int>(0, number_of_chunks, 1), run, tbb::simple_partitioner(), context);
  }
#endif

  bool is_parallel_ = false;
  Stage_clock* clock_ = nullptr;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_THREAD_POLICY_H
