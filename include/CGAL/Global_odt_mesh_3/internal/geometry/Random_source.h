// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_RANDOM_SOURCE_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_RANDOM_SOURCE_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>

#include <cmath>
#include <cstdint>
#include <random>

namespace CGAL::Global_odt_mesh_3::internal {

// Random bits from a counter (Steele, Lea and Flood, Fast Splittable Pseudorandom Number Generators, 2014). Any
// number is as good a seed as any other, so that each of many things can have its own numbers, in whatever
// order they are drawn.
class Split_mix_engine
{
public:
  typedef std::uint64_t result_type;

  explicit Split_mix_engine(std::uint64_t seed) : counter_(seed) {}

  // The engine of the n-th of many things that share a seed.
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

// Random numbers and directions that a seed determines bit by bit: the standard prescribes
// the output of its engines, but not that of its distributions. Since it does not prescribe the order in which operands
// and arguments are evaluated either, no expression draws twice.
template <class Engine>
class Random_numbers
{
public:
  explicit Random_numbers(const Engine& engine) : engine_(engine) {}

  // A number in [0, 1).
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  // A seed for another source.
  unsigned int seed() { return static_cast<unsigned int>(engine_() >> 32); }

  // Uniform on the unit sphere: a point of the disk, lifted (Marsaglia, Choosing a point from
  // the surface of a sphere, 1972). Both its coordinates come from one number.
  Vector_3 direction()
  {
    for(;;)
    {
      const std::uint64_t bits = engine_();
      const double x = half(bits >> 32), y = half(bits & 0xffffffffu), s = x * x + y * y;
      if(s < 1)
      {
        const double r = 2 * std::sqrt(1 - s);
        return { x * r, y * r, 1 - 2 * s };
      }
    }
  }

private:
  // A number in (-1, 1), from 32 bits.
  static double half(std::uint64_t bits) { return (static_cast<double>(bits) + 0.5) * 0x1p-31 - 1; }

  Engine engine_;
};

// Random numbers that are drawn one after the other.
class Random_source
  : public Random_numbers<std::mt19937_64>
{
public:
  explicit Random_source(unsigned int seed) : Random_numbers(std::mt19937_64(seed)) {}
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_RANDOM_SOURCE_H
