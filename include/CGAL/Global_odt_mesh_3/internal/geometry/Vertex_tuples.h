// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_VERTEX_TUPLES_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_VERTEX_TUPLES_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The numbers of the vertices of a facet or cell.
typedef std::array<int, 3> Triple;
typedef std::array<int, 4> Quadruple;

// The index of a vertex in a facet or cell, whose number of vertices it is if they do not have it.
template <class Tuple>
int index_of(const Tuple& t, int v)
{
  int n = 0;
  while(n < static_cast<int>(t.size()) && t[n] != v)
    ++n;
  return n;
}

// They are keys that do not depend on the order of the vertices once they are sorted.
template <class Tuple>
Tuple sorted(Tuple t)
{
  // By insertion: calls of std::sort() would take longer than the few exchanges.
  for(std::size_t n = 1; n < t.size(); ++n)
    for(std::size_t m = n; m > 0 && t[m] < t[m - 1]; --m)
      std::swap(t[m], t[m - 1]);
  return t;
}

// The same oriented facet, from its lowest vertex on.
inline Triple rotated(Triple t)
{
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

// The vertices of an oriented cell in ascending order, but for the last two where orientation asks for it.
inline Quadruple in_canonical_order(Quadruple v)
{
  bool is_odd = false;
  for(int i = 1; i < 4; ++i)
    for(int j = i; j > 0 && v[j] < v[j - 1]; --j)
    {
      std::swap(v[j], v[j - 1]);
      is_odd = !is_odd;
    }
  if(is_odd)
    std::swap(v[2], v[3]);
  return v;
}

// Each edge of some cells once, as increasing numbers, in order.
inline std::vector<std::array<int, 2> > edges_of(const std::vector<Quadruple>& cells)
{
  std::vector<std::array<int, 2> > edges;
  edges.reserve(6 * cells.size());
  for(const Quadruple& q : cells)
    for(int i = 0; i < 3; ++i)
      for(int j = i + 1; j < 4; ++j)
        edges.push_back({{ (std::min)(q[i], q[j]), (std::max)(q[i], q[j]) }});
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

// Values for facets or cells, by the numbers of their vertices in an order that is the same for all who ask, such as sorted().
// They are together in memory, in the order in which they have come.
template <class Tuple, class T>
class Tuple_table
{
public:
  typedef std::pair<Tuple, T> Entry;

  void reserve(std::size_t size)
  {
    entries_.reserve(size);
    provide_places(2 * size);
  }

  // The first value that a tuple gets is its value.
  void insert(const Tuple& tuple, const T& value)
  {
    provide_places(2 * (entries_.size() + 1));
    const std::size_t p = place(tuple);
    if(places_[p] != none)
      return;
    entries_.emplace_back(tuple, value);
    places_[p] = static_cast<int>(entries_.size()) - 1;
  }

  // Null if there is none.
  const T* find(const Tuple& tuple) const
  {
    const int n = entries_.empty() ? int(none) : places_[place(tuple)];
    return n == none ? nullptr : &entries_[n].second;
  }

  const std::vector<Entry>& entries() const { return entries_; }

private:
  static constexpr int none = -1;

  // The place of the tuple, or the one where it may be put.
  std::size_t place(const Tuple& tuple) const
  {
    std::uint64_t hash = 0;
    for(int v : tuple)
      hash = (hash ^ static_cast<std::uint64_t>(v)) * 0x9e3779b97f4a7c15u;
    const std::size_t last = places_.size() - 1;
    std::size_t p = static_cast<std::size_t>(hash >> 32) & last;
    while(places_[p] != none && entries_[places_[p]].first != tuple)
      p = (p + 1) & last;
    return p;
  }

  void provide_places(std::size_t number)
  {
    if(number <= places_.size())
      return;
    std::size_t size = 16;
    while(size < number)
      size *= 2;
    places_.assign(size, int(none));
    for(std::size_t n = 0; n < entries_.size(); ++n)
      places_[place(entries_[n].first)] = static_cast<int>(n);
  }

  std::vector<Entry> entries_;
  std::vector<int> places_;         // of entries, a power of two of which at least half are free
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_VERTEX_TUPLES_H
