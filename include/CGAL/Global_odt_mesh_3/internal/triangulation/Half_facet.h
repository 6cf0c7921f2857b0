// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_HALF_FACET_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_HALF_FACET_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <array>
#include <limits>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Vertex i of a cell and the facet opposite to it. Where the slot beyond a facet is asked for and the facet is
// constrained, the answer is the side of the facet from which it is looked at instead.
class Half_facet
{
public:
  constexpr Half_facet() : Half_facet(none) {}
  explicit constexpr Half_facet(int id) : id_(id) {}
  constexpr Half_facet(int cell, int index) : id_(4 * cell + index) {}

  // A constrained facet has two sides, 0 and 1, and may lack cells on one of them.
  static constexpr Half_facet side(int constrained_facet, int side) { return Half_facet(~(2 * constrained_facet + side)); }

  // The place in arrays of slots, or negative for sides.
  constexpr int id() const { return id_; }
  constexpr bool is_none() const { return id_ == none; }

  constexpr int cell() const { return id_ >> 2; }
  constexpr int index() const { return id_ & 3; }
  // Another one in the same cell.
  constexpr Half_facet in_cell(int index) const { return Half_facet((id_ & ~3) | index); }

  constexpr bool is_side() const { return id_ < 0; }
  // The place in arrays of sides.
  constexpr int side_id() const { return ~id_; }
  constexpr int constrained_facet() const { return ~id_ / 2; }
  constexpr int side() const { return ~id_ % 2; }
  constexpr Half_facet other_side() const { return Half_facet(~(~id_ ^ 1)); }

  friend constexpr bool operator==(Half_facet a, Half_facet b) { return a.id_ == b.id_; }
  friend constexpr bool operator!=(Half_facet a, Half_facet b) { return a.id_ != b.id_; }
  friend constexpr bool operator<(Half_facet a, Half_facet b) { return a.id_ < b.id_; }

private:
  static constexpr int none = (std::numeric_limits<int>::min)();

  int id_;
};

// The vertices of facet i of a cell, clockwise seen from vertex i, so that (v_i, v_o0, v_o1, v_o2) is oriented as the cell.
inline const std::array<int, 3>& facet_indices(int i)
{
  static constexpr std::array<std::array<int, 3>, 4> table
    = {{ {{1, 2, 3}}, {{0, 3, 2}}, {{0, 1, 3}}, {{0, 2, 1}} }};
  return table[i];
}

// The same of a cell, by their numbers.
inline std::array<int, 3> facet_vertices(const std::array<int, 4>& cell, int i)
{
  const std::array<int, 3>& o = facet_indices(i);
  return {{ cell[o[0]], cell[o[1]], cell[o[2]] }};
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_HALF_FACET_H
