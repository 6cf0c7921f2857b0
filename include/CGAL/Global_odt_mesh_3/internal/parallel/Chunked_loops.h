// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_CHUNKED_LOOPS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_CHUNKED_LOOPS_H

#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The numbers below `size` in chunks of about equal length. Which ones never depends on the number of threads, so
// that sums over chunks, added up in their order, do not depend on it either.
class Chunks
{
public:
  Chunks(int size, int least_length, int most_chunks)
    : size_(size)
    , number_((std::max)(1, (std::min)(size / least_length, most_chunks)))
  {}

  int number() const { return number_; }
  int begin(int chunk) const { return static_cast<int>(std::int64_t(size_) * chunk / number_); }
  int end(int chunk) const { return begin(chunk + 1); }

private:
  int size_, number_;
};

// Calls f(n) for the numbers n below `size`, in any order. `least_length` of these calls are worth the trouble of a thread.
template <class F>
void for_each_in_chunks(int size, const Thread_policy& threads, const F& f, int least_length = 1000)
{
  constexpr int most_chunks = 256;
  const Chunks chunks(size, least_length, most_chunks);
  threads.for_each_chunk(chunks.number(), [&](int k)
  {
    for(int n = chunks.begin(k); n < chunks.end(k); ++n)
      f(n);
  });
}

// What f(n, found) adds to `found` for the numbers n below `size`, in their order.
template <class T = int, class F>
std::vector<T> collect_in_chunks(int size, const Thread_policy& threads, const F& f, int least_length = 1000)
{
  constexpr int most_chunks = 256;
  const Chunks chunks(size, least_length, most_chunks);
  std::vector<std::vector<T> > found(chunks.number());
  threads.for_each_chunk(chunks.number(), [&](int n)
  {
    for(int k = chunks.begin(n); k < chunks.end(n); ++k)
      f(k, found[n]);
  });
  std::vector<T> all;
  for(const std::vector<T>& some : found)
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_CHUNKED_LOOPS_H
