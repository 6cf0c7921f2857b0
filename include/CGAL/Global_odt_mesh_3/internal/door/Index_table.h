// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_INDEX_TABLE_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_INDEX_TABLE_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The index types of which it is known that they have an order.
template <class T>
struct Is_ordered_index : std::bool_constant<std::is_arithmetic<T>::value || std::is_enum<T>::value> {};

template <class T, class U>
struct Is_ordered_index<std::pair<T, U> > : std::conjunction<Is_ordered_index<T>, Is_ordered_index<U> > {};

// Numbers for the different values of an index type, of which the concepts require no more than that it can be compared for
// equality. With an order, there may be thousands of values, such as the grains of a polycrystal.
template <class T>
class Index_table
{
public:
  int number(const T& value)
  {
    const int n = number_or(value, -1);
    if(n >= 0)
      return n;
    if constexpr (Is_ordered_index<T>::value)
      numbers_.emplace(value, static_cast<int>(values_.size()));
    values_.push_back(value);
    return static_cast<int>(values_.size()) - 1;
  }

  // The number of the value if it has one, or else `other`.
  int number_or(const T& value, int other) const
  {
    if constexpr (Is_ordered_index<T>::value)
    {
      const auto it = numbers_.find(value);
      return it != numbers_.end() ? it->second : other;
    }
    else
    {
      const auto it = std::find(values_.begin(), values_.end(), value);
      return it != values_.end() ? static_cast<int>(it - values_.begin()) : other;
    }
  }

  const T& value(int number) const { return values_[static_cast<std::size_t>(number)]; }

private:
  std::vector<T> values_;
  std::conditional_t<Is_ordered_index<T>::value, std::map<T, int>, std::monostate> numbers_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_INDEX_TABLE_H
