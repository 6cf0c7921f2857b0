// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_SHARED_COUNTER_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_SHARED_COUNTER_H

#include <atomic>
#include <cstddef>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// A number that several threads may add to.
class Shared_counter
{
public:
  Shared_counter() : count_(0) {}
  Shared_counter(const Shared_counter& other) : count_(other) {}
  Shared_counter& operator=(const Shared_counter& other)
  {
    count_.store(other, std::memory_order_relaxed);
    return *this;
  }

  operator std::size_t() const { return count_.load(std::memory_order_relaxed); }
  void operator++() { *this += 1; }
  void operator+=(std::size_t n) { count_.fetch_add(n, std::memory_order_relaxed); }

private:
  std::atomic<std::size_t> count_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_SHARED_COUNTER_H
