// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_NUMBERED_TRIANGULATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_NUMBERED_TRIANGULATION_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Spatial_order.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Triangulation_table_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/All_cells.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Slot.h>

#include <CGAL/Time_stamper.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The exact regular triangulation of the vertices of a complex, and its vertices by their numbers.
template <class Triangulation>
class Numbered_triangulation_3
{
public:
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Cell_handle Cell_handle;
  typedef typename Triangulation::Facet Facet;
  typedef typename Triangulation::Weighted_point Weighted_point;

  const Triangulation& triangulation() const { return tr_; }
  Triangulation& triangulation() { return tr_; }
  Vertex_handle vertex(int v) const
  {
    CGAL_assertion(vertices_[v] != Vertex_handle());
    return vertices_[v];
  }
  std::size_t number_of_vertices() const { return vertices_.size(); }

  // All cells, listed when they are asked for first after a function of this class has changed vertices.
  const std::vector<Cell_handle>& cells() const
  {
    if(cells_.empty())
      cells_ = all_cells(tr_);
    return cells_;
  }

  // After changes that this class has not made itself.
  void set_cells(std::vector<Cell_handle> cells) { cells_ = std::move(cells); }

  static int number(Vertex_handle h) { return h->number(); }

  // Of the vertices of a cell, -1 for the infinite one.
  static std::array<int, 4> numbers(Cell_handle c)
  {
    return {{ number(c->vertex(0)), number(c->vertex(1)), number(c->vertex(2)), number(c->vertex(3)) }};
  }

  // The vertices of a finite facet, clockwise seen from its cell, from the lowest on: in an order that does not depend on
  // that of the cell.
  static std::array<int, 3> vertices(const Facet& f)
  {
    const std::array<int, 3>& k = facet_indices(f.second);
    return rotated(std::array<int, 3>{{ number(f.first->vertex(k[0])), number(f.first->vertex(k[1])),
                                        number(f.first->vertex(k[2])) }});
  }

  // Whether a facet is looked at from this cell, and not from the other: the one whose other vertex has the higher number.
  bool is_first_side(const Facet& f) const
  {
    const Vertex_handle here = f.first->vertex(f.second), beyond = tr_.mirror_vertex(f.first, f.second);
    return !tr_.is_infinite(here) && (tr_.is_infinite(beyond) || number(beyond) < number(here));
  }

  void build(const std::vector<Weighted_point>& points, const std::vector<Site>& sites)
  {
    clear(points.size());
    std::vector<int> all(points.size());
    std::iota(all.begin(), all.end(), 0);
    insert(all, points, sites);
  }

  // Without any vertices, but with room for them.
  void clear(std::size_t number_of_vertices)
  {
    tr_.clear();
    cells_.clear();
    vertices_.assign(number_of_vertices, Vertex_handle());
  }

  // Weighted points come first, so that those that they would hide are noticed
  // when they are inserted.
  void insert(const std::vector<int>& numbers, const std::vector<Weighted_point>& points, const std::vector<Site>& sites)
  {
    std::vector<Site> inserted;
    inserted.reserve(numbers.size());
    for(int v : numbers)
      inserted.push_back(sites[v]);
    std::vector<std::size_t> order = insertion_order(inserted);
    std::stable_partition(order.begin(), order.end(), [&](std::size_t n) { return inserted[n].weight != 0; });
    Cell_handle hint;
    for(std::size_t n : order)
      insert(numbers[n], points[numbers[n]], hint);
  }

  // A vertex that has no cell yet.
  void create_vertex(int v, const Weighted_point& p)
  {
    cells_.clear();
    vertices_[v] = tr_.tds().create_vertex();
    vertices_[v]->set_point(p);
    vertices_[v]->set_number(v);
  }

  // Whether each number has a vertex of its own.
  bool is_complete() const
  {
    return tr_.number_of_vertices() == vertices_.size()
           && std::find(vertices_.begin(), vertices_.end(), Vertex_handle()) == vertices_.end();
  }

  // Whether the vertex is in the triangulation, and not hidden.
  bool is_visible(int v) const { return vertices_[v] != Vertex_handle(); }

  // Whether so many vertices are moved one by one faster than a new triangulation is built.
  bool is_worth_moving(std::size_t number_of_moves) const
  {
    constexpr double most_moved_one_by_one = 1 / 20.;
    return is_complete() && double(number_of_moves) <= most_moved_one_by_one * double(vertices_.size());
  }

  void move(int v, const Weighted_point& p)
  {
    if(is_visible(v))
      remove(v);
    Cell_handle hint;
    insert(v, p, hint);
  }

  // Takes the vertex out of the triangulation.
  void remove(int v)
  {
    cells_.clear();
    tr_.remove(vertices_[v]);
    vertices_[v] = Vertex_handle();
  }

  // Puts it back, at or near a cell.
  void insert_near(int v, const Weighted_point& p, Cell_handle start) { insert(v, p, start); }

  // Becomes a copy of the input, whose points and numbers of vertices are given.
  template <class Input, class Number>
  void copy(const Input& input, const std::vector<Weighted_point>& points, const Number& number, const Thread_policy& threads)
  {
    typedef typename Input::Cell_handle Input_cell;
    const std::vector<Input_cell> cells = all_cells(input);
    CGAL::Unique_hash_map<Input_cell, int, CGAL::Hash_handles_with_or_without_timestamps> places(-1, cells.size());
    for(std::size_t n = 0; n < cells.size(); ++n)
      places[cells[n]] = static_cast<int>(n);
    const auto place = [&known = std::as_const(places)](Input_cell c) { return known[c]; };
    clear(points.size());
    tr_.tds().clear();
    tr_.tds().set_dimension(3);
    tr_.set_infinite_vertex(tr_.tds().create_vertex());
    for(std::size_t v = 0; v < points.size(); ++v)
      create_vertex(static_cast<int>(v), points[v]);
    cells_.reserve(cells.size());
    while(cells_.size() < cells.size())
      cells_.push_back(tr_.tds().create_cell());
    Triangulation_table_3(input, cells, number, place, threads).connect(vertices_, cells_, threads, tr_);
  }

  // Of a vertex, unless it is hidden.
  std::vector<int> neighbors(int v) const
  {
    std::vector<Vertex_handle> handles;
    if(is_visible(v))
      tr_.finite_adjacent_vertices(vertices_[v], std::back_inserter(handles));
    std::vector<int> numbers;
    for(Vertex_handle h : handles)
      numbers.push_back(number(h));
    return numbers;
  }

private:
  void insert(int v, const Weighted_point& p, Cell_handle& hint)
  {
    cells_.clear();
    const std::size_t before = tr_.number_of_vertices();
    const Vertex_handle h = hint == Cell_handle() ? tr_.insert(p) : tr_.insert(p, hint);
    vertices_[v] = Vertex_handle();
    if(h == Vertex_handle())
      return;
    // Unless it is that of another number at the same place.
    if(tr_.number_of_vertices() > before || std::find(vertices_.begin(), vertices_.end(), h) == vertices_.end())
    {
      vertices_[v] = h;
      h->set_number(v);
      if(tr_.number_of_vertices() != before + 1)
        forget_hidden_vertices();
    }
    hint = h->cell();
  }

  // Of vertices that another one hides, nothing is left in the triangulation.
  void forget_hidden_vertices()
  {
    std::vector<Vertex_handle> visible(vertices_.size());
    for(Vertex_handle h : tr_.finite_vertex_handles())
    {
      const int v = number(h);
      if(0 <= v && v < static_cast<int>(visible.size()) && vertices_[v] == h)
        visible[v] = h;
    }
    vertices_ = std::move(visible);
  }

  Triangulation tr_;
  std::vector<Vertex_handle> vertices_;
  mutable std::vector<Cell_handle> cells_;      // or none
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_NUMBERED_TRIANGULATION_3_H
