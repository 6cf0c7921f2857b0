// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_INDEXED_TRIANGULATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_INDEXED_TRIANGULATION_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

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

// Arrays of numbers that remember what has been overwritten.
//
// From begin_trial() to end_trial(), changes are remembered, and undo_trial() brings back what was
// there when it began. Another beginning ends the trial before.
template <int number_of_arrays>
class Undoable_arrays
{
public:
  const std::vector<int>& operator[](int array) const { return arrays_[array]; }

  // The array, for changes that are not to be undone.
  std::vector<int>& unguarded(int array)
  {
    CGAL_assertion(changes_[array].empty());
    return arrays_[array];
  }

  void write(int array, int place, int value)
  {
    int& entry = arrays_[array][place];
    if(is_on_trial_)
      changes_[array].push_back({ place, entry });
    entry = value;
  }

  void push(int array, int value)
  {
    arrays_[array].push_back(value);
    if(is_on_trial_)
      changes_[array].push_back({ pushed, value });
  }

  int pop(int array)
  {
    const int value = arrays_[array].back();
    arrays_[array].pop_back();
    if(is_on_trial_)
      changes_[array].push_back({ popped, value });
    return value;
  }

  // Makes the array longer by as many values, which stay when a trial is undone.
  void extend(int array, std::size_t number, int value) { arrays_[array].resize(arrays_[array].size() + number, value); }

  void begin_trial()
  {
    for(std::vector<Change>& c : changes_)
    {
      // The first steps change more than all others.
      if(c.size() < c.capacity() / 8)
        std::vector<Change>(c.capacity() / 2).swap(c);
      c.clear();
    }
    is_on_trial_ = true;
  }

  void end_trial()
  {
    is_on_trial_ = false;
    for(std::vector<Change>& c : changes_)
      c.clear();
  }

  // Takes back what has changed since the trial began.
  void undo_trial()
  {
    for(int a = 0; a < number_of_arrays; ++a)
      undo(arrays_[a], changes_[a]);
  }

private:
  // What was there before, or has been pushed at the end, or popped from there.
  struct Change
  {
    int place, value;
  };
  static constexpr int pushed = -1, popped = -2;

  static void undo(std::vector<int>& array, std::vector<Change>& changes)
  {
    for( ; !changes.empty(); changes.pop_back())
    {
      const Change& c = changes.back();
      if(c.place == pushed)
        array.pop_back();
      else if(c.place == popped)
        array.push_back(c.value);
      else
        array[c.place] = c.value;
    }
  }

  std::array<std::vector<int>, number_of_arrays> arrays_;
  bool is_on_trial_ = false;
  std::array<std::vector<Change>, number_of_arrays> changes_;
};

// The combinatorics of a triangulation in index arrays.
//
// For each slot, the vertex is stored, and the slot across the facet, so that one look-up gives the neighbor
// and the vertex beyond the facet. Cells are positively oriented: det(v1-v0, v2-v0, v3-v0) > 0.
class Indexed_triangulation_3
{
  enum Array { CELL_VERTICES, NEIGHBORS, VERTEX_CELL, CONSTRAINED_SLOTS, FREE_CELLS, NUMBER_OF_ARRAYS };

public:
  Indexed_triangulation_3() {}

  static constexpr int no_vertex = -1;
  // With this number, and room for the cells that flips make, slots have numbers of type int.
  static constexpr std::size_t most_cells = std::size_t(1) << 28;

  int number_of_constrained_facets() const { return static_cast<int>(arrays_[CONSTRAINED_SLOTS].size() / 2); }
  int number_of_sides() const { return static_cast<int>(arrays_[CONSTRAINED_SLOTS].size()); }
  // The facet of the cell on that side of the constrained facet, or none.
  Half_facet constrained_half_facet(int facet, int side) const { return constrained_half_facet(Half_facet::side(facet, side)); }
  Half_facet constrained_half_facet(Half_facet side) const { return Half_facet(arrays_[CONSTRAINED_SLOTS][side.side_id()]); }

  int number_of_vertices() const { return static_cast<int>(arrays_[VERTEX_CELL].size()); }
  int number_of_half_facets() const { return static_cast<int>(arrays_[CELL_VERTICES].size()); }
  int number_of_cell_slots() const { return number_of_half_facets() / 4; }
  int number_of_cells() const { return number_of_cell_slots() - static_cast<int>(arrays_[FREE_CELLS].size()); }
  bool is_alive(int cell) const { return vertex(Half_facet(cell, 0)) != no_vertex; }

  int vertex(Half_facet s) const
  {
    CGAL_assertion(0 <= s.id() && s.id() < number_of_half_facets());
    return arrays_[CELL_VERTICES][s.id()];
  }

  Half_facet neighbor(Half_facet s) const
  {
    CGAL_assertion(0 <= s.id() && s.id() < number_of_half_facets());
    return Half_facet(arrays_[NEIGHBORS][s.id()]);
  }

  int incident_cell(int vertex) const { return arrays_[VERTEX_CELL][vertex]; }

  // The vertices of all cells, in the order of slots.
  const int* cell_vertices() const { return arrays_[CELL_VERTICES].data(); }
  const int* neighbors() const { return arrays_[NEIGHBORS].data(); }
  // The vertices of one cell.
  const int* vertices(int cell) const { return cell_vertices() + 4 * cell; }
  std::array<int, 4> cell(int c) const { return {{ vertices(c)[0], vertices(c)[1], vertices(c)[2], vertices(c)[3] }}; }

  // The vertices of the facet, clockwise seen from that of the slot.
  std::array<int, 3> facet(Half_facet s) const
  {
    const std::array<int, 3>& f = facet_indices(s.index());
    return {{ vertex(s.in_cell(f[0])), vertex(s.in_cell(f[1])), vertex(s.in_cell(f[2])) }};
  }

  bool has_vertex(int cell, int v) const { return std::find(vertices(cell), vertices(cell) + 4, v) != vertices(cell) + 4; }

  // The slot of a vertex of the cell.
  Half_facet slot(int cell, int v) const
  {
    CGAL_assertion(has_vertex(cell, v));
    int i = 0;
    while(i < 3 && vertices(cell)[i] != v)
      ++i;
    return Half_facet(cell, i);
  }

  // The slots of `vertex` in all cells around it, on both sides of constrained facets.
  void star(int vertex, std::vector<Half_facet>& slots) const
  {
    slots.clear();
    Tuple_table<std::array<int, 1>, int> reached;
    const auto reach = [&](int cell)
    {
      if(cell >= 0)
        reached.insert({{ cell }}, 0);
      if(reached.entries().size() > slots.size())
        slots.push_back(slot(cell, vertex));
    };
    reach(incident_cell(vertex));
    for(std::size_t n = 0; n < slots.size(); ++n)
      for(int i = 0; i < 4; ++i)
      {
        if(i == slots[n].index())
          continue;
        const Half_facet across = neighbor(slots[n].in_cell(i));
        reach((across.is_side() ? constrained_half_facet(across.other_side()) : across).cell());
      }
  }

  void reserve(std::size_t vertices, std::size_t cells)
  {
    arrays_.unguarded(VERTEX_CELL).assign(vertices, -1);
    arrays_.unguarded(CELL_VERTICES).reserve(4 * cells + 64);
    arrays_.unguarded(NEIGHBORS).reserve(4 * cells + 64);
  }

  // Adds a cell whose neighbors are still to be set.
  int add_cell(int v0, int v1, int v2, int v3)
  {
    if(arrays_[FREE_CELLS].empty())
      add_free_cell();
    const int c = arrays_.pop(FREE_CELLS);
    set_cell(c, v0, v1, v2, v3);
    return c;
  }

  void set_cell(int c, int v0, int v1, int v2, int v3)
  {
    const std::array<int, 4> v = {{ v0, v1, v2, v3 }};
    for(int i = 0; i < 4; ++i)
    {
      arrays_.write(CELL_VERTICES, Half_facet(c, i).id(), v[i]);
      arrays_.write(VERTEX_CELL, v[i], c);
    }
  }

  void remove_cell(int c)
  {
    CGAL_assertion(is_alive(c));
    for(int i = 0; i < 4; ++i)
      arrays_.write(CELL_VERTICES, Half_facet(c, i).id(), no_vertex);
    arrays_.push(FREE_CELLS, c);
  }

  // The other may be a side of a constrained facet.
  void set_neighbors(Half_facet s, Half_facet other)
  {
    arrays_.write(NEIGHBORS, s.id(), other.id());
    if(!other.is_side())
      return arrays_.write(NEIGHBORS, other.id(), s.id());
    if(static_cast<std::size_t>(other.side_id()) >= arrays_[CONSTRAINED_SLOTS].size())
      arrays_.extend(CONSTRAINED_SLOTS, (other.side_id() | 1) + 1 - arrays_[CONSTRAINED_SLOTS].size(), Half_facet().id());
    arrays_.write(CONSTRAINED_SLOTS, other.side_id(), s.id());
  }

  // What changes on trial is undone as Undoable_arrays says.
  void begin_trial() { arrays_.begin_trial(); }
  void end_trial() { arrays_.end_trial(); }
  void undo_trial() { arrays_.undo_trial(); }

  // Gives vertex v the number place[v]. Ends a trial.
  void renumber_vertices(const std::vector<int>& place)
  {
    end_trial();
    for(int& v : arrays_.unguarded(CELL_VERTICES))
      if(v != no_vertex)
        v = place[v];
    std::vector<int>& incident = arrays_.unguarded(VERTEX_CELL);
    incident.assign(place.size(), -1);
    for(int s = 0; s < number_of_half_facets(); ++s)
      if(is_alive(Half_facet(s).cell()))
        incident[cell_vertices()[s]] = Half_facet(s).cell();
    CGAL_expensive_assertion(is_valid());
  }

  // Closes the gaps and lays the cells out in the order of their first vertices, which
  // are numbered along a space filling curve. Ends a trial.
  void compact(const Thread_policy& threads = Thread_policy())
  {
    end_trial();
    const std::vector<int> place = places_by_first_vertex();
    std::vector<int> vertices(4 * number_of_cells()), neighbors(vertices.size());
    const Chunks cells(number_of_cell_slots(), least_cells, most_chunks);
    threads.for_each_chunk(cells.number(), [&](int n)
    {
      for(int c = cells.begin(n); c < cells.end(n); ++c)
        for(int i = 0; i < 4 && place[c] >= 0; ++i)
        {
          const Half_facet from(c, i), to(place[c], i), across = neighbor(from);
          vertices[to.id()] = vertex(from);
          neighbors[to.id()] = across.is_side() ? across.id() : Half_facet(place[across.cell()], across.index()).id();
        }
    });
    assign(std::move(vertices), std::move(neighbors), arrays_[VERTEX_CELL].size(), arrays_[CONSTRAINED_SLOTS].size());
  }

  // Becomes a triangulation of these cells, all alive, in the order of slots. Ends a trial.
  void assign(std::vector<int> cell_vertices, std::vector<int> neighbors, std::size_t number_of_vertices,
              std::size_t number_of_sides)
  {
    std::vector<int> vertex_cell(number_of_vertices, -1), constrained_slots(number_of_sides, Half_facet().id());
    for(int s = 0; s < static_cast<int>(neighbors.size()); ++s)
    {
      vertex_cell[cell_vertices[s]] = Half_facet(s).cell();
      if(Half_facet(neighbors[s]).is_side())
        constrained_slots[Half_facet(neighbors[s]).side_id()] = s;
    }
    end_trial();
    arrays_.unguarded(CELL_VERTICES).swap(cell_vertices);
    arrays_.unguarded(NEIGHBORS).swap(neighbors);
    arrays_.unguarded(VERTEX_CELL).swap(vertex_cell);
    arrays_.unguarded(CONSTRAINED_SLOTS).swap(constrained_slots);
    arrays_.unguarded(FREE_CELLS).clear();
    CGAL_expensive_assertion(is_valid());
  }

  // Gives away the memory of cells, of which none are left. Ends a trial.
  void take_memory(std::vector<int>& cell_vertices, std::vector<int>& neighbors)
  {
    end_trial();
    cell_vertices = std::move(arrays_.unguarded(CELL_VERTICES));
    neighbors = std::move(arrays_.unguarded(NEIGHBORS));
  }

  // Whether the arrays describe a triangulation: mutual neighbors that share
  // their three common vertices, in opposite orientations.
  bool is_valid() const
  {
    for(int s = 0; s < number_of_half_facets(); ++s)
      if(is_alive(Half_facet(s).cell()) && !is_valid(Half_facet(s)))
        return false;
    for(std::size_t v = 0; v < arrays_[VERTEX_CELL].size(); ++v)
    {
      const int c = incident_cell(static_cast<int>(v));
      if(c >= 0 && !has_vertex(c, static_cast<int>(v)))
        return false;
    }
    return true;
  }

private:
  // A chunk is to be worth the trouble of a thread.
  static constexpr int least_cells = 10000, most_chunks = 16;

  void add_free_cell()
  {
    arrays_.extend(FREE_CELLS, 1, number_of_cell_slots());
    arrays_.extend(CELL_VERTICES, 4, no_vertex);
    arrays_.extend(NEIGHBORS, 4, Half_facet().id());
  }

  // The place of each cell, or -1 for those that are not alive.
  std::vector<int> places_by_first_vertex() const
  {
    const auto first_vertex = [this](int c) { return *std::min_element(vertices(c), vertices(c) + 4); };
    std::vector<int> next(arrays_[VERTEX_CELL].size() + 1, 0), place(number_of_cell_slots(), -1);
    for(int c = 0; c < number_of_cell_slots(); ++c)
      if(is_alive(c))
        ++next[first_vertex(c) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    for(int c = 0; c < number_of_cell_slots(); ++c)
      if(is_alive(c))
        place[c] = next[first_vertex(c)]++;
    return place;
  }

  bool is_valid(Half_facet s) const
  {
    const Half_facet across = neighbor(s);
    if(across.is_side())
      return !across.is_none() && constrained_half_facet(across) == s;
    if(across.id() >= number_of_half_facets() || !is_alive(across.cell()) || neighbor(across) != s)
      return false;
    const std::array<int, 3> f = facet(s);
    std::array<int, 3> g = facet(across);
    std::reverse(g.begin(), g.end());
    return rotated(f) == rotated(g);
  }

  Undoable_arrays<NUMBER_OF_ARRAYS> arrays_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_INDEXED_TRIANGULATION_3_H
