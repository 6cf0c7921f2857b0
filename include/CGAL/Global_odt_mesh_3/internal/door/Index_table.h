// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_INDEX_TABLE_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_INDEX_TABLE_H

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Numbers for the few different values of an index type of which nothing is
// known but that it can be compared for equality.
template <class T>
class Index_table
{
public:
  int number(const T& value)
  {
    if(last_ < values_.size() && values_[last_] == value)
      return static_cast<int>(last_);
    last_ = place(value);
    if(last_ == values_.size())
      values_.push_back(value);
    return static_cast<int>(last_);
  }

  // The number of the value if it has one, or else `other`.
  int number_or(const T& value, int other) const
  {
    const std::size_t n = place(value);
    return n < values_.size() ? static_cast<int>(n) : other;
  }

  const T& value(int number) const { return values_[number]; }

private:
  std::size_t place(const T& value) const
  {
    return std::size_t(std::find(values_.begin(), values_.end(), value) - values_.begin());
  }

  std::vector<T> values_;
  std::size_t last_ = 0;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_INDEX_TABLE_H
