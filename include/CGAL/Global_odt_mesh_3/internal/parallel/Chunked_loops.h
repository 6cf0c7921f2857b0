// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_CHUNKED_LOOPS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_CHUNKED_LOOPS_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

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

// Sums for numbered things to which the chunks of a loop add at the same time: each chunk has sums of its own, which are
// added up in the order of the chunks when they are asked for.
//
// All of a chunk's sums lie in one array as long as if it added to all things, so that adding is nearly as fast as to a
// plain array. Blocks that a chunk adds nothing to are neither written nor read, and so take no memory on systems that
// map memory at its first use; the others are zeroed when first written.
template <class Value>
class Chunked_sums
{
  // Blocks are whole cache lines.
  static constexpr int length_of_block = 16;
  struct alignas(64) Block { Value values[length_of_block]; };

public:
  Chunked_sums() {}

  // A copy has no sums.
  Chunked_sums(const Chunked_sums&) {}
  Chunked_sums& operator=(const Chunked_sums&) { return *this; }

  // What one chunk adds.
  class Part
  {
  public:
    Part(Block* blocks, char* is_used) : blocks_(blocks), is_used_(is_used) {}

    void add(int n, const Value& value) const
    {
      const std::size_t b = std::size_t(n) / length_of_block;
      if(BOOST_UNLIKELY(!is_used_[b]))
        begin(b);
      blocks_[b].values[std::size_t(n) % length_of_block] += value;
    }

  private:
    BOOST_NOINLINE void begin(std::size_t block) const
    {
      blocks_[block] = Block();
      is_used_[block] = true;
    }

    Block* blocks_;
    char* is_used_;
  };

  // Nothing is kept when the numbers change.
  void resize(std::size_t size, int number_of_parts)
  {
    if(size == size_ && number_of_parts == this->number_of_parts())
      return;
    size_ = size;
    parts_ = std::vector<Memory>(number_of_parts);
    for(Memory& part : parts_)
    {
      part.blocks.reset(new Block[number_of_blocks()]);
      part.is_used.resize(number_of_blocks());
    }
  }

  int number_of_parts() const { return static_cast<int>(parts_.size()); }
  int number_of_blocks() const { return static_cast<int>((size_ + length_of_block - 1) / length_of_block); }

  Part part(int p) { return Part(parts_[p].blocks.get(), parts_[p].is_used.data()); }

  // Sets the sums of a part to zero.
  void clear(int p) { std::fill(parts_[p].is_used.begin(), parts_[p].is_used.end(), char(false)); }

  // Calls f(n, sum) for the numbers n of blocks from `first` to `end`.
  template <class F>
  void for_each_sum(int first, int end, const F& f) const
  {
    for(int b = first; b < end; ++b)
    {
      Block sums = {};
      for(const Memory& part : parts_)
        if(part.is_used[b])
          for(int i = 0; i < length_of_block; ++i)
            sums.values[i] += part.blocks[b].values[i];
      const int begin = b * length_of_block, length = (std::min)(static_cast<int>(size_) - begin, int(length_of_block));
      for(int i = 0; i < length; ++i)
        f(begin + i, sums.values[i]);
    }
  }

private:
  struct Memory
  {
    std::unique_ptr<Block[]> blocks;
    std::vector<char> is_used;        // for each block
  };

  std::size_t size_ = 0;
  std::vector<Memory> parts_;
};

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
    // Chunks are at least as long as there are buckets, as each of them counts for all buckets.
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

  // The numbers of all buckets, one bucket after the other, and where those of a bucket are there.
  const std::vector<int>& numbers() const { return numbers_; }
  int begin(int bucket) const { return first_[bucket]; }
  int end(int bucket) const { return first_[bucket + 1]; }
  int size(int bucket) const { return end(bucket) - begin(bucket); }

private:
  static constexpr int least_length = 10000, most_chunks = 64;

  std::vector<int> first_, numbers_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_CHUNKED_LOOPS_H
