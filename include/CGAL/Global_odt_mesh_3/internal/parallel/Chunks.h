// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_CHUNKS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_CHUNKS_H

#include <algorithm>
#include <cstdint>

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

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_PARALLEL_CHUNKS_H
