// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_TEST_CHECK_H
#define GLOBAL_ODT_MESH_3_TEST_CHECK_H

#include <cmath>
#include <cstdlib>
#include <iostream>

// Counts failed checks, and says which; unlike assertions it goes on.
namespace check {

inline int& failures()
{
  static int n = 0;
  return n;
}

template <class... What>
void that(bool ok, const What&... what)
{
  if(ok)
    return;
  ++failures();
  std::cerr << "FAILED: ";
  (std::cerr << ... << what) << std::endl;
}

// The largest of the numbers that are added, as std::max would have it, but not a number as soon as one of
// them is none: no bound holds for it then.
class Largest
{
public:
  void add(double x)
  {
    if(!(x <= value_) && !std::isnan(value_))
      value_ = x;
  }

  operator double() const { return value_; }

private:
  double value_ = 0;
};

inline int result()
{
  std::clog << (failures() == 0 ? "all checks passed" : "some checks FAILED") << std::endl;
  return failures() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace check

#endif // GLOBAL_ODT_MESH_3_TEST_CHECK_H
