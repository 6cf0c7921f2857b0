// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_SPLIT_MIX_ENGINE_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_SPLIT_MIX_ENGINE_H

#include <cstdint>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Random bits from a counter (Steele, Lea and Flood, Fast Splittable Pseudorandom Number Generators, 2014). Any
// number is as good a seed as any other, so that each of many things can have its own numbers, in whatever
// order they are drawn.
class Split_mix_engine
{
public:
  typedef std::uint64_t result_type;

  explicit Split_mix_engine(std::uint64_t seed) : counter_(seed) {}

  // For the n-th of many things that share a seed.
  Split_mix_engine(std::uint64_t seed, int n)
    : counter_(Split_mix_engine(seed + UINT64_C(0xd1342543de82ef95) * static_cast<std::uint64_t>(n))())
  {}

  std::uint64_t operator()()
  {
    std::uint64_t z = counter_ += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
  }

private:
  std::uint64_t counter_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_SPLIT_MIX_ENGINE_H
