// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_FLAT_TRIANGULATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_FLAT_TRIANGULATION_3_H

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The combinatorics of a triangulation in two flat arrays.
//
// Slot 4c+i stands for vertex i of cell c and for the facet opposite to it.
// Across that facet lies slot 4d+j, so that one look-up gives the neighbor d and
// the vertex j beyond the facet. A negative entry stands for one side of a constrained facet, a
// facet that must stay. Cells are positively oriented: det(v1-v0, v2-v0, v3-v0) > 0.
class Flat_triangulation_3
{
public:
  static constexpr int no_vertex = -1;

  // The vertices of facet i, clockwise seen from vertex i, so that
  // (v_i, v_o0, v_o1, v_o2) is oriented as the cell.
  static const std::array<int, 3>& facet_vertices(int i)
  {
    static constexpr std::array<std::array<int, 3>, 4> table
      = {{ {{1, 2, 3}}, {{0, 3, 2}}, {{0, 1, 3}}, {{0, 2, 1}} }};
    return table[i];
  }

  // A constrained facet has two sides, 0 and 1, and may lack cells on one of them.
  static constexpr bool is_constrained(int neighbor) { return neighbor < 0; }
  static constexpr int constrained_facet(int neighbor) { return ~neighbor / 2; }
  static constexpr int constrained_side(int neighbor) { return ~neighbor % 2; }
  static constexpr int constrained_neighbor(int facet, int side) { return ~(2 * facet + side); }

  int number_of_constrained_facets() const { return static_cast<int>(constrained_slots_.size() / 2); }
  // The facet of the cell on that side of the constrained facet, or -1.
  int constrained_slot(int facet, int side) const { return constrained_slots_[2 * facet + side]; }

  int number_of_slots() const { return static_cast<int>(cell_vertices_.size()); }
  int number_of_cell_slots() const { return number_of_slots() / 4; }
  int number_of_cells() const { return number_of_cell_slots() - static_cast<int>(free_cells_.size()); }
  bool is_alive(int cell) const { return cell_vertices_[4 * cell] != no_vertex; }

  int vertex(int slot) const { return cell_vertices_[slot]; }
  int neighbor(int slot) const { return neighbors_[slot]; }
  const int* cell_vertices() const { return cell_vertices_.data(); }
  const int* neighbors() const { return neighbors_.data(); }
  int incident_cell(int vertex) const { return vertex_cell_[vertex]; }

  void reserve(std::size_t vertices, std::size_t cells)
  {
    vertex_cell_.assign(vertices, -1);
    cell_vertices_.reserve(4 * cells + 64);
    neighbors_.reserve(4 * cells + 64);
  }

  // Adds a cell whose neighbors are still to be set.
  int add_cell(int v0, int v1, int v2, int v3)
  {
    const int c = allocate_cell();
    set_cell(c, v0, v1, v2, v3);
    return c;
  }

  void set_neighbors(int slot, int other)
  {
    write(&Flat_triangulation_3::neighbors_, slot, other);
    if(!is_constrained(other))
      write(&Flat_triangulation_3::neighbors_, other, slot);
    else
    {
      if(static_cast<std::size_t>(~other) >= constrained_slots_.size())
        constrained_slots_.resize((~other | 1) + 1, -1);
      write(&Flat_triangulation_3::constrained_slots_, ~other, slot);
    }
  }

  // From begin_trial() to end_trial(), what flips overwrite is remembered, and undo_trial() brings
  // back what was there when the trial had a certain length. Another beginning ends the trial before.
  void begin_trial()
  {
    overwritten_.clear();
    is_on_trial_ = true;
  }

  void end_trial()
  {
    is_on_trial_ = false;
    overwritten_.clear();
  }

  std::size_t trial_length() const { return overwritten_.size(); }

  void undo_trial(std::size_t length = 0)
  {
    for( ; overwritten_.size() > length; overwritten_.pop_back())
    {
      const Overwritten& w = overwritten_.back();
      if(w.index == pushed)
        free_cells_.pop_back();
      else if(w.index == popped)
        free_cells_.push_back(w.value);
      else
        (this->*w.array)[w.index] = w.value;
    }
  }

  // Replaces the two cells at facet `slot` by the three around the edge between
  // the two apices.
  std::array<int, 3> flip_2_3(int slot)
  {
    const int other = neighbors_[slot];
    const int c = slot / 4, d = other / 4;
    const int a = cell_vertices_[slot], b = cell_vertices_[other];
    std::array<int, 3> p;             // the common facet, seen from a
    std::array<int, 3> above, below;  // what lies beyond the facets of c and d opposite to p
    for(int k = 0; k < 3; ++k)
    {
      const int s = 4 * c + facet_vertices(slot % 4)[k];
      p[k] = cell_vertices_[s];
      above[k] = neighbors_[s];
    }
    for(int k = 0; k < 3; ++k)
    {
      const int s = 4 * d + facet_vertices(other % 4)[k];
      below[index(p, cell_vertices_[s])] = neighbors_[s];
    }
    const std::array<int, 3> t = {{ c, d, allocate_cell() }};
    for(int k = 0; k < 3; ++k)
      set_cell(t[k], a, b, p[(k + 1) % 3], p[(k + 2) % 3]);
    for(int k = 0; k < 3; ++k)
    {
      set_neighbors(4 * t[k], below[k]);
      set_neighbors(4 * t[k] + 1, above[k]);
      set_neighbors(4 * t[k] + 2, 4 * t[(k + 1) % 3] + 3);
    }
    return t;
  }

  // The three cells around the edge between vertices i and j of `cell`, if these
  // are all. `ring` gets, cell after cell, the slot of the vertex that the next
  // cell does not have.
  bool has_degree_3(int cell, int i, int j, std::array<int, 3>& ring) const
  {
    int leave = 0;
    while(leave == i || leave == j)
      ++leave;
    int c = cell, kept = cell_vertices_[4 * cell + 6 - i - j - leave];
    for(int n = 0; n < 3; ++n)
    {
      ring[n] = 4 * c + leave;
      const int across = neighbors_[ring[n]];
      if(is_constrained(across))
        return false;
      // The next cell has the kept vertex and is left by the facet opposite to it.
      c = across / 4;
      leave = index_in_cell(c, kept);
      kept = cell_vertices_[across];
    }
    return c == cell;
  }

  // Replaces the three cells around an edge, `ring` of has_degree_3(), by the
  // two on either side of the triangle of the other vertices.
  std::array<int, 2> flip_3_2(const std::array<int, 3>& ring)
  {
    // The cell ring[n]/4 has the vertices p[n] and p[n+1] of the triangle, and
    // (a, b, p[0], p[1]) is positive in the first.
    const std::array<int, 3> p = {{ cell_vertices_[ring[0]], cell_vertices_[ring[1]],
                                    cell_vertices_[ring[2]] }};
    const std::array<int, 3>& f = facet_vertices(ring[0] % 4);
    const int first = 4 * (ring[0] / 4);
    const int m = index({{ cell_vertices_[first + f[0]], cell_vertices_[first + f[1]],
                           cell_vertices_[first + f[2]] }}, p[1]);
    const int a = cell_vertices_[first + f[(m + 1) % 3]];
    const int b = cell_vertices_[first + f[(m + 2) % 3]];

    std::array<int, 3> above, below;  // beyond the facets opposite to b and to a
    for(int n = 0; n < 3; ++n)
    {
      const int k = (n + 2) % 3;      // the vertex of the triangle that this cell lacks
      const int c = ring[n] / 4;
      above[k] = neighbors_[4 * c + index_in_cell(c, b)];
      below[k] = neighbors_[4 * c + index_in_cell(c, a)];
    }
    const int c = ring[0] / 4, d = ring[1] / 4;
    release_cell(ring[2] / 4);
    set_cell(c, a, p[0], p[1], p[2]);
    set_cell(d, b, p[0], p[2], p[1]);
    set_neighbors(4 * c, 4 * d);
    for(int k = 0; k < 3; ++k)
    {
      set_neighbors(4 * c + 1 + k, above[k]);
      set_neighbors(4 * d + 1 + (3 - k) % 3, below[k]);
    }
    return {{ c, d }};
  }

  int index_in_cell(int cell, int vertex) const
  {
    for(int i = 0; i < 4; ++i)
      if(cell_vertices_[4 * cell + i] == vertex)
        return i;
    return -1;
  }

  // The slots of `vertex` in all cells around it, on both sides of constrained facets.
  void star(int vertex, std::vector<int>& slots) const
  {
    slots.clear();
    const int first = vertex_cell_[vertex];
    if(first < 0)
      return;
    slots.push_back(4 * first + index_in_cell(first, vertex));
    for(std::size_t n = 0; n < slots.size(); ++n)
    {
      const int c = slots[n] / 4;
      for(int i = 0; i < 4; ++i)
      {
        if(4 * c + i == slots[n])
          continue;
        int across = neighbors_[4 * c + i];
        if(is_constrained(across))
          across = constrained_slots_[~across ^ 1];
        if(across < 0)
          continue;
        const int s = 4 * (across / 4) + index_in_cell(across / 4, vertex);
        if(std::find(slots.begin(), slots.end(), s) == slots.end())
          slots.push_back(s);
      }
    }
  }

  // Gives vertex v the number place[v].
  void renumber_vertices(const std::vector<int>& place)
  {
    for(int& v : cell_vertices_)
      if(v != no_vertex)
        v = place[v];
    vertex_cell_.assign(place.size(), -1);
    for(int s = 0; s < number_of_slots(); ++s)
      if(is_alive(s / 4))
        vertex_cell_[cell_vertices_[s]] = s / 4;
  }

  // Closes the gaps and lays the cells out in the order of their first vertices, which
  // are numbered along a space filling curve. Ends a trial.
  void compact()
  {
    end_trial();
    const auto first_vertex = [this](int c)
    {
      const int* const v = &cell_vertices_[4 * c];
      return *std::min_element(v, v + 4);
    };
    std::vector<int> next(vertex_cell_.size() + 1, 0), place(number_of_cell_slots(), -1);
    for(int c = 0; c < number_of_cell_slots(); ++c)
      if(is_alive(c))
        ++next[first_vertex(c) + 1];
    std::partial_sum(next.begin(), next.end(), next.begin());
    const int number_of_cells = next.back();
    for(int c = 0; c < number_of_cell_slots(); ++c)
      if(is_alive(c))
        place[c] = next[first_vertex(c)]++;

    std::vector<int> vertices(4 * number_of_cells), neighbors(4 * number_of_cells);
    for(int c = 0; c < number_of_cell_slots(); ++c)
      for(int i = 0; i < 4 && place[c] >= 0; ++i)
      {
        const int across = neighbors_[4 * c + i];
        vertices[4 * place[c] + i] = cell_vertices_[4 * c + i];
        neighbors[4 * place[c] + i] = is_constrained(across) ? across : 4 * place[across / 4] + across % 4;
      }
    cell_vertices_.swap(vertices);
    neighbors_.swap(neighbors);
    free_cells_.clear();
    for(int s = 0; s < number_of_slots(); ++s)
    {
      vertex_cell_[cell_vertices_[s]] = s / 4;
      if(is_constrained(neighbors_[s]))
        constrained_slots_[~neighbors_[s]] = s;
    }
  }

  // Whether the arrays describe a triangulation: mutual neighbors that share
  // their three common vertices, in opposite orientations.
  bool is_valid() const
  {
    for(int s = 0; s < number_of_slots(); ++s)
    {
      if(!is_alive(s / 4))
        continue;
      if(is_constrained(neighbors_[s]))
      {
        if(constrained_slots_[~neighbors_[s]] != s)
          return false;
        continue;
      }
      const int other = neighbors_[s];
      if(other >= number_of_slots() || !is_alive(other / 4) || neighbors_[other] != s)
        return false;
      std::array<int, 3> f, g;
      for(int k = 0; k < 3; ++k)
      {
        f[k] = cell_vertices_[4 * (s / 4) + facet_vertices(s % 4)[k]];
        g[k] = cell_vertices_[4 * (other / 4) + facet_vertices(other % 4)[2 - k]];
      }
      std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
      std::rotate(g.begin(), std::min_element(g.begin(), g.end()), g.end());
      if(f != g)
        return false;
    }
    for(std::size_t v = 0; v < vertex_cell_.size(); ++v)
      if(vertex_cell_[v] >= 0 && index_in_cell(vertex_cell_[v], static_cast<int>(v)) < 0)
        return false;
    return true;
  }

private:
  static int index(const std::array<int, 3>& a, int v)
  {
    return v == a[0] ? 0 : v == a[1] ? 1 : 2;
  }

  typedef std::vector<int> Flat_triangulation_3::* Array;

  // What has been overwritten, pushed at the end of the free cells, or popped from there.
  struct Overwritten
  {
    Array array;
    int index, value;
  };
  static constexpr int pushed = -1, popped = -2;

  void write(Array array, int index, int value)
  {
    int& place = (this->*array)[index];
    if(is_on_trial_)
      overwritten_.push_back({ array, index, place });
    place = value;
  }

  int allocate_cell()
  {
    if(free_cells_.empty())
    {
      free_cells_.push_back(number_of_cell_slots());
      cell_vertices_.resize(cell_vertices_.size() + 4, no_vertex);
      neighbors_.resize(neighbors_.size() + 4, ~0);
    }
    const int c = free_cells_.back();
    free_cells_.pop_back();
    if(is_on_trial_)
      overwritten_.push_back({ &Flat_triangulation_3::free_cells_, popped, c });
    return c;
  }

  void release_cell(int c)
  {
    for(int i = 0; i < 4; ++i)
      write(&Flat_triangulation_3::cell_vertices_, 4 * c + i, no_vertex);
    free_cells_.push_back(c);
    if(is_on_trial_)
      overwritten_.push_back({ &Flat_triangulation_3::free_cells_, pushed, c });
  }

  void set_cell(int c, int v0, int v1, int v2, int v3)
  {
    const std::array<int, 4> v = {{ v0, v1, v2, v3 }};
    for(int i = 0; i < 4; ++i)
    {
      write(&Flat_triangulation_3::cell_vertices_, 4 * c + i, v[i]);
      write(&Flat_triangulation_3::vertex_cell_, v[i], c);
    }
  }

  std::vector<int> cell_vertices_;
  std::vector<int> neighbors_;
  std::vector<int> vertex_cell_;
  std::vector<int> constrained_slots_;     // of both sides of each constrained facet
  std::vector<int> free_cells_;
  bool is_on_trial_ = false;
  std::vector<Overwritten> overwritten_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_FLAT_TRIANGULATION_3_H
