// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_FOR_EACH_IN_CHUNKS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_FOR_EACH_IN_CHUNKS_H

#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunks.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

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

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_FOR_EACH_IN_CHUNKS_H
