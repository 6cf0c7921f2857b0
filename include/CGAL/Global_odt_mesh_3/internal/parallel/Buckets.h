// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_BUCKETS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_BUCKETS_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>

#include <algorithm>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The numbers below a size, distributed to buckets, in each of which they are in their order.
class Buckets
{
public:
  Buckets() {}

  // bucket(n) is that of n, or negative if n is in none.
  template <class Bucket>
  Buckets(int size, int number_of_buckets, const Bucket& bucket, const Thread_policy& threads)
    : first_(number_of_buckets + 1, 0)
  {
    // At least as long as there are buckets, as each chunk counts for all of them.
    const Chunks chunks(size, (std::max)(int(least_length), number_of_buckets), most_chunks);
    std::vector<std::vector<int> > place(chunks.number());      // in each bucket, of the next one of a chunk
    threads.for_each_chunk(chunks.number(), [&](int k)
    {
      place[k].assign(number_of_buckets, 0);
      for(int n = chunks.begin(k); n < chunks.end(k); ++n)
        if(const int b = bucket(n); b >= 0)
          ++place[k][b];
    });
    int places = 0;
    for(int b = 0; b < number_of_buckets; ++b)
    {
      first_[b] = places;
      for(std::vector<int>& p : place)
      {
        const int number = p[b];
        p[b] = places;
        places += number;
      }
    }
    first_[number_of_buckets] = places;
    numbers_.resize(places);
    threads.for_each_chunk(chunks.number(), [&](int k)
    {
      for(int n = chunks.begin(k); n < chunks.end(k); ++n)
        if(const int b = bucket(n); b >= 0)
          numbers_[place[k][b]++] = n;
    });
  }

  int number_of_buckets() const { return static_cast<int>(first_.size()) - 1; }

  // One after the other, the numbers of all buckets, and where those of a bucket are there.
  const std::vector<int>& numbers() const { return numbers_; }
  int begin(int bucket) const { return first_[bucket]; }
  int end(int bucket) const { return first_[bucket + 1]; }
  int size(int bucket) const { return end(bucket) - begin(bucket); }

private:
  static constexpr int least_length = 10000, most_chunks = 64;

  std::vector<int> first_, numbers_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_BUCKETS_H
