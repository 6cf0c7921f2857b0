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

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <type_traits>
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
// plain array. Pages that a chunk adds nothing to are neither written nor read, and so take no memory on systems that
// map memory at its first use; pages in use are zeroed when first written. Zero bytes have to mean an empty sum.
template <class Value>
class Chunked_sums
{
  static_assert(std::is_trivially_copyable<Value>::value, "sums are zeroed as bytes");

public:
  // Pages are zeroed one by one; sums over chunks are formed by blocks of pages.
  static constexpr int pages_in_block = 8, page_bits = 3, page_length = 1 << page_bits,
                       block_length = pages_in_block * page_length;

  Chunked_sums() {}

  // A copy has no sums.
  Chunked_sums(const Chunked_sums&) {}
  Chunked_sums& operator=(const Chunked_sums&) { return *this; }

  // What one chunk adds.
  class Part
  {
  public:
    Part(Value* values, bool* is_used) : values_(values), is_used_(is_used) {}

    void add(int n, const Value& value) const
    {
      if(BOOST_UNLIKELY(!is_used_[n >> page_bits]))
        begin(n >> page_bits);
      values_[n] += value;
    }

  private:
    BOOST_NOINLINE void begin(int page) const
    {
      std::memset(static_cast<void*>(values_ + page * page_length), 0, page_length * sizeof(Value));
      is_used_[page] = true;
    }

    Value* values_;
    bool* is_used_;     // for each page
  };

  // Nothing is kept when the numbers change.
  void resize(std::size_t size, int number_of_parts)
  {
    if(size == size_ && number_of_parts == number_of_parts_)
      return;
    size_ = size;
    number_of_parts_ = number_of_parts;
    length_ = std::size_t(number_of_blocks()) * block_length;
    values_ = Memory<Value>(number_of_parts * length_);
    is_used_ = Memory<bool>(number_of_parts * length_ / page_length);
    for(int p = 0; p < number_of_parts; ++p)
      clear(p);
  }

  int number_of_parts() const { return number_of_parts_; }
  int number_of_blocks() const { return static_cast<int>((size_ + block_length - 1) / block_length); }

  Part part(int p)
  {
    CGAL_assertion(0 <= p && p < number_of_parts_);
    return Part(values_.get() + p * length_, is_used(p));
  }

  // Sets the sums of a part to zero.
  void clear(int p) { std::memset(is_used(p), 0, length_ / page_length); }

  // Calls f(n, sum) for the numbers n of blocks from `first` to `end`.
  template <class F>
  void for_each_sum(int first, int end, const F& f) const
  {
    for(int block = first; block < end; ++block)
    {
      const std::size_t begin = std::size_t(block) * block_length;
      Value sums[block_length] = {};
      for(int p = 0; p < number_of_parts_; ++p)
        for_each_page(is_used(p), block, [&](std::size_t page)
        {
          const Value* const values = values_.get() + p * length_ + page * page_length;
          Value* const s = sums + (page * page_length - begin);
          for(int i = 0; i < page_length; ++i)
            s[i] += values[i];
        });
      const int length = static_cast<int>((std::min)(size_ - begin, std::size_t(block_length)));
      for(int i = 0; i < length; ++i)
        f(static_cast<int>(begin) + i, sums[i]);
    }
  }

private:
  // In whole cache lines.
  template <class T>
  class Memory
  {
  public:
    Memory() {}

    explicit Memory(std::size_t size)
      : bytes_(std::malloc(size * sizeof(T) + cache_line))
    {
      if(bytes_ == nullptr)
        throw std::bad_alloc();
    }

    T* get() const
    {
      const std::uintptr_t p = reinterpret_cast<std::uintptr_t>(bytes_.get());
      return reinterpret_cast<T*>((p + cache_line - 1) / cache_line * cache_line);
    }

  private:
    static constexpr std::size_t cache_line = 64;
    struct Free { void operator()(void* p) const { std::free(p); } };

    std::unique_ptr<void, Free> bytes_;
  };

  bool* is_used(int p) const { return is_used_.get() + p * (length_ / page_length); }

  // Those of a block that are used, mostly none or all.
  template <class F>
  static void for_each_page(const bool* used, int block, const F& f)
  {
    const std::size_t first = std::size_t(block) * pages_in_block;
    std::uint64_t any;
    static_assert(sizeof(any) == pages_in_block * sizeof(bool), "a block is looked at as a whole");
    std::memcpy(&any, used + first, sizeof(any));
    for(std::size_t page = first; any != 0 && page < first + pages_in_block; ++page)
      if(used[page])
        f(page);
  }

  std::size_t size_ = 0, length_ = 0;     // the length is that of a part, in whole blocks
  int number_of_parts_ = 0;
  Memory<Value> values_;
  Memory<bool> is_used_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_CHUNKED_LOOPS_H
