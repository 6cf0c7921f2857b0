// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_CELL_NUMBERS_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_CELL_NUMBERS_H

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Numbers of cells of a triangulation that must not be changed, by their addresses: those that lie side by side in memory,
// as neighbors often do, are side by side in the table as well, so that looking them up is fast.
template <class Cell_handle>
class Cell_numbers
{
public:
  static constexpr int none = -1;

  explicit Cell_numbers(std::size_t most_cells)
  {
    std::size_t size = 4 * group_size;
    while(size < 2 * most_cells)
      size *= 2;
    entries_.resize(size);
    while((size >> bits_) > group_size)
      ++bits_;
  }

  void set(Cell_handle c, int number)
  {
    const std::uintptr_t key = address(c);
    std::size_t p = first_place(key);
    while(entries_[p].number != none && entries_[p].address != key)
      p = next_place(p);
    entries_[p] = { key, number };
  }

  // The number of the cell, or `none`.
  int operator[](Cell_handle c) const
  {
    const std::uintptr_t key = address(c);
    std::size_t p = first_place(key);
    while(entries_[p].number != none && entries_[p].address != key)
      p = next_place(p);
    return entries_[p].number;
  }

private:
  struct Entry
  {
    std::uintptr_t address = 0;
    int number = none;
  };

  static constexpr std::size_t group_size = 8;

  static std::uintptr_t address(Cell_handle c) { return reinterpret_cast<std::uintptr_t>(&*c); }

  // Groups of neighbors are spread over the table, as the golden ratio does it.
  std::size_t first_place(std::uintptr_t key) const
  {
    const std::uint64_t n = key / sizeof(*Cell_handle());
    const std::uint64_t group = ((n / group_size) * 0x9e3779b97f4a7c15u) >> (64 - bits_);
    return static_cast<std::size_t>(group * group_size + n % group_size);
  }

  std::size_t next_place(std::size_t p) const { return (p + 1) & (entries_.size() - 1); }

  std::vector<Entry> entries_;
  int bits_ = 0;                        // of the number of a group
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_CELL_NUMBERS_H
