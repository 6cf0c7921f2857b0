// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_COLLECT_IN_CHUNKS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_COLLECT_IN_CHUNKS_H

#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunks.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

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

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_COLLECT_IN_CHUNKS_H
