// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_WORKING_TRIANGULATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_WORKING_TRIANGULATION_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Exact_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Spatial_order.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>

#include <CGAL/assertions.h>
#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The exact regular triangulation of the vertices of a complex, and its vertices by their numbers.
class Working_triangulation_3
{
public:
  const Exact_triangulation_3& triangulation() const { return tr_; }
  Exact_triangulation_3& triangulation() { return tr_; }
  Vertex_handle vertex(int v) const
  {
    CGAL_assertion(vertices_[v] != Vertex_handle());
    return vertices_[v];
  }

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
  static Quadruple numbers(Cell_handle c)
  {
    return {{ number(c->vertex(0)), number(c->vertex(1)), number(c->vertex(2)), number(c->vertex(3)) }};
  }

  // The vertices of a finite facet, clockwise seen from its cell, from the lowest on: in an order that does not depend on
  // that of the cell.
  static Triple vertices(const Facet& f)
  {
    return rotated(facet_vertices(numbers(f.first), f.second));
  }

  // Whether a facet is looked at from this cell, and not from the other: the one whose other vertex has the higher number.
  bool is_first_side(const Facet& f) const
  {
    const Vertex_handle here = f.first->vertex(f.second), beyond = tr_.mirror_vertex(f.first, f.second);
    return !tr_.is_infinite(here) && (tr_.is_infinite(beyond) || number(beyond) < number(here));
  }

  void build(const std::vector<Site>& sites)
  {
    clear(sites.size());
    std::vector<int> all(sites.size());
    std::iota(all.begin(), all.end(), 0);
    insert(all, sites);
  }

  // Without any vertices, but with room for them.
  void clear(std::size_t number_of_vertices)
  {
    tr_.clear();
    cells_.clear();
    vertices_.assign(number_of_vertices, Vertex_handle());
  }

  // The same, and its memory is free.
  void release()
  {
    clear(0);
    vertices_.shrink_to_fit();
    cells_.shrink_to_fit();
  }

  // Weighted points come first, so that those that they would hide are noticed
  // when they are inserted.
  void insert(const std::vector<int>& numbers, const std::vector<Site>& sites)
  {
    std::vector<Site> inserted;
    inserted.reserve(numbers.size());
    for(int v : numbers)
      inserted.push_back(sites[v]);
    std::vector<std::size_t> order = insertion_order(inserted);
    std::stable_partition(order.begin(), order.end(), [&](std::size_t n) { return inserted[n].weight != 0; });
    Cell_handle hint;
    for(std::size_t n : order)
      insert(numbers[n], inserted[n], hint);
  }

  // A vertex that has no cell yet.
  void create_vertex(int v, const Site& s)
  {
    cells_.clear();
    vertices_[v] = tr_.tds().create_vertex();
    vertices_[v]->set_point(weighted_point(s));
    vertices_[v]->set_number(v);
  }

  // The next number, which has no vertex yet.
  void add_vertex() { vertices_.emplace_back(); }
  void remove_last_vertex() { vertices_.pop_back(); }

  // Gives the vertices that are visible these numbers, in the order of those that they have.
  void renumber(const std::vector<int>& numbers)
  {
    std::vector<Vertex_handle> vertices;
    for(std::size_t v = 0; v < vertices_.size(); ++v)
      if(vertices_[v] != Vertex_handle())
      {
        vertices_[v]->set_number(numbers[v]);
        vertices.push_back(vertices_[v]);
      }
    vertices_ = std::move(vertices);
  }

  // Whether each number has a vertex of its own.
  bool is_complete() const
  {
    return tr_.number_of_vertices() == vertices_.size()
           && std::find(vertices_.begin(), vertices_.end(), Vertex_handle()) == vertices_.end();
  }

  // Whether the vertex is in the triangulation, and not hidden.
  bool is_visible(int v) const { return vertices_[v] != Vertex_handle(); }

  bool is_cell(const Quadruple& q) const
  {
    Cell_handle c;
    return std::all_of(q.begin(), q.end(), [this](int v) { return is_visible(v); })
           && tr_.is_cell(vertices_[q[0]], vertices_[q[1]], vertices_[q[2]], vertices_[q[3]], c);
  }

  // Whether this is a regular triangulation of its vertices, of which there are several where a sphere passes through five. One that
  // is copied need not be, or is another than CGAL's functions make, and then those that insert and remove vertices are of no use.
  bool is_regular(const Thread_policy& threads) const
  {
    const std::vector<Cell_handle>& all = cells();
    const auto is_everywhere = [&](const auto& holds)
    {
      return collect_in_chunks(static_cast<int>(all.size()), threads, [&](int n, std::vector<int>& wrong)
      {
        if(!holds(all[n]))
          wrong.push_back(n);
      }).empty();
    };
    const auto vertices = [](Cell_handle c)
    { return std::array<Vertex_handle, 4>{{ c->vertex(0), c->vertex(1), c->vertex(2), c->vertex(3) }}; };
    // Only positive cells have spheres.
    return is_everywhere([&](Cell_handle c) { return tr_.is_infinite(c) || is_positive(vertices(c)); })
           && is_everywhere([this](Cell_handle c) { return is_locally_regular(c); });
  }

  // Whether these, in this order, are those of a positive cell.
  static bool is_positive(const std::array<Vertex_handle, 4>& v)
  {
    const auto p = [&v](int i) { return v[i]->point().point(); };
    return CGAL::orientation(p(0), p(1), p(2), p(3)) == POSITIVE;
  }

  // Whether so many vertices are moved one by one faster than a new triangulation is built.
  bool is_worth_moving(std::size_t number_of_moves) const
  {
    constexpr double most_moved_one_by_one = 1 / 20.;
    return is_complete() && double(number_of_moves) <= most_moved_one_by_one * double(vertices_.size());
  }

  void move(int v, const Site& s)
  {
    if(is_visible(v))
      remove(v);
    Cell_handle hint;
    insert(v, s, hint);
  }

  // Goes to these sites by moving vertices; false if that is not the way, and then nothing is built that is of any use.
  bool go_to(const std::vector<Site>& sites)
  {
    if(sites.size() != vertices_.size() || !is_complete())
      return false;
    const std::vector<int> moved = elsewhere(sites);
    if(!is_worth_moving(moved.size()))
      return false;
    for(int v : moved)
      move(v, sites[v]);
    return is_complete();
  }

  // Whether the triangulation is of dimension 3 without the vertex, too. As a rule, the first cell tells.
  bool keeps_dimension_without(int v) const
  {
    std::array<Exact_traits::Point_3, 3> base;
    bool has_base = false;
    for(Cell_handle c : tr_.finite_cell_handles())
    {
      int i;
      if(!c->has_vertex(vertices_[v], i))
        return true;
      for(int k = 0; k < 3; ++k)
      {
        const Exact_traits::Point_3& p = c->vertex(facet_indices(i)[k])->point().point();
        if(!has_base)
          base[k] = p;
        else if(!CGAL::coplanar(base[0], base[1], base[2], p))
          return true;
      }
      has_base = true;
    }
    return false;
  }

  // Takes the vertex out of the triangulation.
  void remove(int v)
  {
    cells_.clear();
    tr_.remove(vertices_[v]);
    vertices_[v] = Vertex_handle();
  }

  // A cell that is to come, by its vertices, -1 for the infinite one.
  struct New_cell
  {
    Quadruple vertices;
    int label;
  };

  // Cells of the triangulation give way to others that fill the same space. All vertices have to be there before, and those without
  // cells are to be removed afterwards. Gives the new cells.
  std::vector<Cell_handle> replace(const std::vector<Cell_handle>& old_cells, const std::vector<New_cell>& new_cells)
  {
    std::vector<Side> sides;
    std::vector<Cell_handle> created;
    for(Cell_handle c : old_cells)
      c->set_flag(GIVES_WAY);
    for(Cell_handle c : old_cells)
      for(int i = 0; i < 4; ++i)
        if(!c->neighbor(i)->has_flag(GIVES_WAY))
          add_side(tr_.mirror_facet(Facet(c, i)), sides);
    for(const New_cell& n : new_cells)
    {
      const Cell_handle c = tr_.tds().create_cell(handle(n.vertices[0]), handle(n.vertices[1]), handle(n.vertices[2]),
                                                  handle(n.vertices[3]));
      created.push_back(c);
      c->set_label(n.label);
      for(int i = 0; i < 4; ++i)
      {
        c->vertex(i)->set_cell(c);
        add_side(Facet(c, i), sides);
      }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.key < b.key; });
    for(std::size_t n = 0; n < sides.size(); n += 2)
    {
      CGAL_assertion(n + 1 < sides.size() && sides[n].key == sides[n + 1].key);
      tr_.tds().set_adjacency(sides[n].facet.first, sides[n].facet.second, sides[n + 1].facet.first, sides[n + 1].facet.second);
    }
    for(Cell_handle c : old_cells)
      tr_.tds().delete_cell(c);
    cells_.clear();
    return created;
  }

  void set_site(int v, const Site& s) { vertices_[v]->set_point(weighted_point(s)); }

  // Of a vertex that no cell has any more.
  void remove_without_cells(int v)
  {
    tr_.tds().delete_vertex(vertices_[v]);
    vertices_[v] = Vertex_handle();
  }

  // Becomes the triangulation of a table, whatever that is like, in which its vertices are numbered otherwise.
  void copy(const Mesh_table_3& table, const std::vector<int>& numbers_in_table, const Thread_policy& threads)
  {
    clear(numbers_in_table.size());
    tr_.tds().clear();
    tr_.tds().set_dimension(3);
    tr_.set_infinite_vertex(tr_.tds().create_vertex());
    std::vector<Vertex_handle> in_table(table.sites.size());
    for(std::size_t v = 0; v < numbers_in_table.size(); ++v)
    {
      create_vertex(static_cast<int>(v), table.sites[numbers_in_table[v]]);
      in_table[numbers_in_table[v]] = vertices_[v];
    }
    const std::vector<Mesh_table_3::Cell>& rows = table.cells;
    cells_.reserve(rows.size());
    while(cells_.size() < rows.size())
      cells_.push_back(tr_.tds().create_cell());
    connect_cells(table, in_table, cells_, threads, tr_);
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
  // A facet, with its sorted vertices.
  struct Side
  {
    Triple key;
    Facet facet;
  };

  static void add_side(const Facet& f, std::vector<Side>& sides)
  {
    sides.push_back({ sorted(facet_vertices(numbers(f.first), f.second)), f });
  }

  Vertex_handle handle(int v) const { return v < 0 ? tr_.infinite_vertex() : vertices_[v]; }

  bool is_locally_regular(Cell_handle c) const
  {
    for(int i = 0; i < 4; ++i)
    {
      if(!is_first_side(Facet(c, i)))
        continue;
      const Vertex_handle beyond = tr_.mirror_vertex(c, i);
      if(!tr_.is_infinite(beyond) && tr_.side_of_power_sphere(c, beyond->point(), false) == ON_BOUNDED_SIDE)
        return false;
    }
    return true;
  }

  // The vertices that are not at these sites.
  std::vector<int> elsewhere(const std::vector<Site>& sites) const
  {
    std::vector<int> found;
    for(int v = 0; v < static_cast<int>(sites.size()); ++v)
      if(!same_place(sites[v], weighted_site(vertices_[v]->point())))
        found.push_back(v);
    return found;
  }

  void insert(int v, const Site& s, Cell_handle& hint)
  {
    const Weighted_point p = weighted_point(s);
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

  Exact_triangulation_3 tr_;
  std::vector<Vertex_handle> vertices_;
  mutable std::vector<Cell_handle> cells_;      // or none
};

// Tells the cells of a boundary facet, which do not know it, whether it is in the complex.
inline void mark_facet(const Boundary_facet& of_boundary, const Facet& facet, const Working_triangulation_3& working)
{
  if(of_boundary.patch != Boundary_facet::no_patch)
    for(const Facet& f : { facet, working.triangulation().mirror_facet(facet) })
      f.first->set_facet_in_complex(f.second);
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_WORKING_TRIANGULATION_3_H
