// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_INDEX_TRIANGULATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_INDEX_TRIANGULATION_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Cell_order.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// A facet that must stay, as it was found in the triangulation.
struct Constrained_facet
{
  int cell, index;
  Triple vertices;                  // clockwise seen from the cell
};

typedef std::vector<Constrained_facet> Constrained_facets;

// The cell beyond a facet: whether it is inside, and its vertex opposite to the facet, or -1 if it is infinite.
struct Cell_across
{
  bool is_inside;
  int vertex;
};

// Loads cells of a triangulation into index arrays.
//
// Cells are numbered by `Cells`, which knows is_infinite(n), is_inside(n), the numbers of its finite vertices(n), its label(n),
// whether a facet is_marked(n, i), and what is across(n, i).
template <class Cells>
class Triangulation_indexer_3
{
public:
  Triangulation_indexer_3(const Cells& cells, int number_of_cells, int number_of_vertices, const Thread_policy& threads)
    : cells_(cells)
    , number_of_cells_(number_of_cells)
    , number_of_vertices_(number_of_vertices)
    , threads_(threads)
  {}

  Constrained_facets operator()(Indexed_triangulation_3& flat)
  {
    flat = Indexed_triangulation_3();
    const std::vector<int> marked_outside = read_cells();
    Canonical_order order(std::move(vertices_), number_of_vertices_, threads_);
    std::vector<int> neighbors(order.vertices().size());
    const std::vector<Border_facet> border = set_neighbors(order, neighbors);
    Constrained_facets facets;
    facets.reserve(border.size());
    for(const Border_facet& f : border)
    {
      const int n = static_cast<int>(facets.size());
      facets.push_back(constrained_facet(f.cell, f.index));
      neighbors[f.slot.id()] = Half_facet::side(n, 0).id();
      if(!f.mate.is_none())
        neighbors[f.mate.id()] = Half_facet::side(n, 1).id();
    }
    flat.assign(order.take_vertices(), std::move(neighbors), number_of_vertices_, 2 * facets.size());
    for(int n : marked_outside)
      add_outside_facets(n, facets);
    return facets;
  }

private:
  // What the cell says of itself and of its facets, the bits of which are in the order of the cell's slots.
  struct Cell_facts
  {
    int label;
    int marks;
  };

  // A constrained facet with cells inside: where it is first among the cells and in the index arrays.
  struct Border_facet
  {
    int cell, index;
    Half_facet slot, mate;

    bool operator<(const Border_facet& o) const { return std::tie(cell, index) < std::tie(o.cell, o.index); }
  };

  // Gives the cells outside that have marked facets.
  std::vector<int> read_cells()
  {
    vertices_.resize(number_of_cells_);
    facts_.resize(number_of_cells_);
    return collect_in_chunks(number_of_cells_, threads_, [this](int n, std::vector<int>& marked_outside)
    {
      if(cells_.is_inside(n))
        return read_cell(n);
      vertices_[n][0] = Indexed_triangulation_3::no_vertex;
      if(!cells_.is_infinite(n) && has_marks(n))
        marked_outside.push_back(n);
    });
  }

  bool has_marks(int n) const
  {
    return cells_.is_marked(n, 0) || cells_.is_marked(n, 1) || cells_.is_marked(n, 2) || cells_.is_marked(n, 3);
  }

  // CGAL orders the vertices of a cell as we do.
  void read_cell(int n)
  {
    const Quadruple v = cells_.vertices(n);
    vertices_[n] = in_canonical_order(v);
    facts_[n] = { cells_.label(n), 0 };
    for(int i = 0; i < 4; ++i)
      if(cells_.is_marked(n, i))
        facts_[n].marks |= 1 << index_of(vertices_[n], v[i]);
  }

  // Gives the constrained facets, whose sides are still to be set, in the order of the cells.
  std::vector<Border_facet> set_neighbors(const Canonical_order& order, std::vector<int>& neighbors) const
  {
    std::vector<std::vector<Border_facet> > found(order.number_of_chunks());
    order.for_each_facet([&](int chunk, Half_facet s, Half_facet t)
    {
      if(is_constrained(order, s, t))
      {
        found[chunk].push_back(border_facet(order, s, t));
        return;
      }
      neighbors[s.id()] = t.id();
      neighbors[t.id()] = s.id();
    });
    std::vector<Border_facet> border;
    for(const std::vector<Border_facet>& some : found)
      border.insert(border.end(), some.begin(), some.end());
    threads_.sort(border.begin(), border.end(), std::less<Border_facet>());
    return border;
  }

  bool is_constrained(const Canonical_order& order, Half_facet s, Half_facet t) const
  {
    if(t.is_none())
      return true;
    const Cell_facts &a = facts_[order.number(s.cell())], &b = facts_[order.number(t.cell())];
    return a.label != b.label || (a.marks >> s.index() & 1) || (b.marks >> t.index() & 1);
  }

  Border_facet border_facet(const Canonical_order& order, Half_facet s, Half_facet t) const
  {
    if(!t.is_none() && order.number(t.cell()) < order.number(s.cell()))
      std::swap(s, t);
    const int n = order.number(s.cell());
    return { n, index_of(cells_.vertices(n), order.vertices()[s.id()]), s, t };
  }

  Constrained_facet constrained_facet(int n, int i) const
  {
    return { n, i, facet_vertices(cells_.vertices(n), i) };
  }

  // Facets of the complex without any cell of the complex occur where the surface folds.
  void add_outside_facets(int n, Constrained_facets& facets) const
  {
    for(int i = 0; i < 4; ++i)
    {
      const Cell_across across = cells_.across(n, i);
      const bool second_visit = across.vertex > cells_.vertices(n)[i];
      if(!second_visit && !across.is_inside && cells_.is_marked(n, i))
        facets.push_back(constrained_facet(n, i));
    }
  }

  const Cells& cells_;
  const int number_of_cells_, number_of_vertices_;
  const Thread_policy threads_;
  std::vector<Quadruple> vertices_;     // of the cells inside
  std::vector<Cell_facts> facts_;
};

// Loads those of all cells that are inside into index arrays, in canonical order.
// Facets between labels, or inside and outside, and those that are marked, from which side does not matter, become
// constrained facets, with side 0 on the side of the facet's cell.
// They are returned, followed by marked facets that have no cell inside.
template <class Cells>
Constrained_facets index_cells(const Cells& cells, std::size_t number_of_cells, std::size_t number_of_vertices,
                               const Thread_policy& threads, Indexed_triangulation_3& flat)
{
  return Triangulation_indexer_3<Cells>(cells, static_cast<int>(number_of_cells), static_cast<int>(number_of_vertices),
                                          threads)(flat);
}

// Cells of a triangulation of CGAL's, for which functions tell numbers of vertices, labels, which are 0 outside, and marks.
template <class Triangulation, class Number, class Label, class Is_marked>
struct Cells_of_triangulation_3
{
  typedef typename Triangulation::Cell_handle Cell_handle;

  const Triangulation& tr;
  const std::vector<Cell_handle>& handles;
  const Number& number;
  const Label& label_of;
  const Is_marked& is_facet_marked;

  bool is_infinite(int n) const { return tr.is_infinite(handles[n]); }
  bool is_inside(int n) const { return is_inside(handles[n]); }
  bool is_inside(Cell_handle c) const { return label_of(c) != 0 && !tr.is_infinite(c); }
  int label(int n) const { return label_of(handles[n]); }
  bool is_marked(int n, int i) const { return is_facet_marked(handles[n], i); }

  Quadruple vertices(int n) const
  {
    const Cell_handle c = handles[n];
    return {{ number(c->vertex(0)), number(c->vertex(1)), number(c->vertex(2)), number(c->vertex(3)) }};
  }

  Cell_across across(int n, int i) const
  {
    const Cell_handle c = handles[n], d = c->neighbor(i);
    return { is_inside(d), tr.is_infinite(d) ? -1 : number(tr.mirror_vertex(c, i)) };
  }
};

template <class Triangulation, class Number, class Label, class Is_marked>
Constrained_facets index_triangulation_3(const Triangulation& tr, const std::vector<typename Triangulation::Cell_handle>& cells,
                                         const Number& number, const Label& label, const Is_marked& is_marked,
                                         const Thread_policy& threads, Indexed_triangulation_3& flat)
{
  const Cells_of_triangulation_3<Triangulation, Number, Label, Is_marked> numbered{ tr, cells, number, label, is_marked };
  return index_cells(numbered, cells.size(), tr.number_of_vertices(), threads, flat);
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_INDEX_TRIANGULATION_3_H
