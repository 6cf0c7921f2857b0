// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_FLATTEN_TRIANGULATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_FLATTEN_TRIANGULATION_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Collect_in_chunks.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Canonical_order.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flat_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Slot.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// A facet that must stay, as it was found in the triangulation.
template <class Triangulation>
struct Constrained_facet
{
  typename Triangulation::Facet facet;
  std::array<int, 3> vertices;      // clockwise seen from facet.first
};

// Loads cells of a triangulation into flat arrays.
template <class Triangulation, class Number, class Label, class Is_marked>
class Triangulation_flattener_3
{
public:
  typedef std::vector<Constrained_facet<Triangulation> > Constrained_facets;

  Triangulation_flattener_3(const Triangulation& tr, const std::vector<typename Triangulation::Cell_handle>& cells,
                            const Number& number, const Label& label, const Is_marked& is_marked,
                            const Thread_policy& threads)
    : tr_(tr)
    , cells_(cells)
    , number_(number)
    , label_(label)
    , is_marked_(is_marked)
    , threads_(threads)
  {}

  Constrained_facets operator()(Flat_triangulation_3& flat)
  {
    flat = Flat_triangulation_3();
    const std::vector<int> marked_outside = read_cells();
    const int number_of_vertices = static_cast<int>(tr_.number_of_vertices());
    Canonical_order order(std::move(vertices_), number_of_vertices, threads_);
    std::vector<int> neighbors(order.vertices().size());
    const std::vector<Border_facet> border = set_neighbors(order, neighbors);
    Constrained_facets facets;
    facets.reserve(border.size());
    for(const Border_facet& f : border)
    {
      const int n = static_cast<int>(facets.size());
      facets.push_back(constrained_facet(cells_[f.cell], f.index));
      neighbors[f.slot.id()] = Slot::side(n, 0).id();
      if(!f.mate.is_none())
        neighbors[f.mate.id()] = Slot::side(n, 1).id();
    }
    flat.assign(order.take_vertices(), std::move(neighbors), number_of_vertices, 2 * facets.size());
    for(int n : marked_outside)
      add_outside_facets(cells_[n], facets);
    return facets;
  }

private:
  typedef typename Triangulation::Cell_handle Cell_handle;
  typedef typename Triangulation::Facet Facet;
  typedef std::array<int, 4> Quadruple;

  // What the cell says of itself and of its facets, the bits of which are in the order of the cell's slots.
  struct Cell_facts
  {
    typename std::decay<decltype(std::declval<Label>()(Cell_handle()))>::type label;
    int marks;
  };

  // A constrained facet with cells inside: where it is first among the cells and in the flat arrays.
  struct Border_facet
  {
    int cell, index;
    Slot slot, mate;

    bool operator<(const Border_facet& o) const { return std::tie(cell, index) < std::tie(o.cell, o.index); }
  };

  // Gives the cells outside that have marked facets.
  std::vector<int> read_cells()
  {
    vertices_.resize(cells_.size());
    facts_.resize(cells_.size());
    return collect_in_chunks(static_cast<int>(cells_.size()), threads_, [this](int n, std::vector<int>& marked_outside)
    {
      const Cell_handle c = cells_[n];
      if(is_inside(c))
        return read_cell(n);
      vertices_[n][0] = Flat_triangulation_3::no_vertex;
      if(!tr_.is_infinite(c) && has_marks(c))
        marked_outside.push_back(n);
    });
  }

  bool is_inside(Cell_handle c) const { return label_(c) != decltype(label_(c))() && !tr_.is_infinite(c); }

  bool has_marks(Cell_handle c) const
  {
    return is_marked_(c, 0) || is_marked_(c, 1) || is_marked_(c, 2) || is_marked_(c, 3);
  }

  // CGAL orders the vertices of a cell as we do.
  void read_cell(int n)
  {
    const Cell_handle c = cells_[n];
    const Quadruple v = {{ number_(c->vertex(0)), number_(c->vertex(1)), number_(c->vertex(2)), number_(c->vertex(3)) }};
    vertices_[n] = in_canonical_order(v);
    facts_[n] = { label_(c), 0 };
    for(int i = 0; i < 4; ++i)
      if(is_marked_(c, i))
        facts_[n].marks |= 1 << (std::find(vertices_[n].begin(), vertices_[n].end(), v[i]) - vertices_[n].begin());
  }

  // Gives the constrained facets, whose sides are still to be set, in the order of the cells.
  std::vector<Border_facet> set_neighbors(const Canonical_order& order, std::vector<int>& neighbors) const
  {
    std::vector<std::vector<Border_facet> > found(order.number_of_chunks());
    order.for_each_facet([&](int chunk, Slot s, Slot t)
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

  bool is_constrained(const Canonical_order& order, Slot s, Slot t) const
  {
    if(t.is_none())
      return true;
    const Cell_facts &a = facts_[order.number(s.cell())], &b = facts_[order.number(t.cell())];
    return a.label != b.label || (a.marks >> s.index() & 1) || (b.marks >> t.index() & 1);
  }

  Border_facet border_facet(const Canonical_order& order, Slot s, Slot t) const
  {
    if(!t.is_none() && order.number(t.cell()) < order.number(s.cell()))
      std::swap(s, t);
    const int n = order.number(s.cell());
    int i = 0;
    while(number_(cells_[n]->vertex(i)) != order.vertices()[s.id()])
      ++i;
    return { n, i, s, t };
  }

  Constrained_facet<Triangulation> constrained_facet(Cell_handle c, int i) const
  {
    const std::array<int, 3>& f = facet_indices(i);
    return { Facet(c, i), {{ number_(c->vertex(f[0])), number_(c->vertex(f[1])), number_(c->vertex(f[2])) }} };
  }

  // Facets of the complex without any cell of the complex occur where the surface folds.
  void add_outside_facets(Cell_handle c, Constrained_facets& facets) const
  {
    for(int i = 0; i < 4; ++i)
    {
      const Cell_handle d = c->neighbor(i);
      const bool second_visit = !tr_.is_infinite(d) && number_(tr_.mirror_vertex(c, i)) > number_(c->vertex(i));
      if(!second_visit && !is_inside(d) && is_marked_(c, i))
        facets.push_back(constrained_facet(c, i));
    }
  }

  const Triangulation& tr_;
  const std::vector<Cell_handle>& cells_;
  const Number& number_;
  const Label& label_;
  const Is_marked& is_marked_;
  const Thread_policy threads_;
  std::vector<Quadruple> vertices_;     // of the cells inside
  std::vector<Cell_facts> facts_;
};

// Loads those of all cells of `tr` that have a label into flat arrays, in canonical order, vertices being named by `number`.
// Facets between labels, or inside and outside, and those that are marked, from which side does not matter, become
// constrained facets, with side 0 on the side of the facet's cell.
// They are returned, followed by marked facets that have no cell inside.
template <class Triangulation, class Number, class Label, class Is_marked>
std::vector<Constrained_facet<Triangulation> >
flatten_triangulation_3(const Triangulation& tr, const std::vector<typename Triangulation::Cell_handle>& cells,
                        const Number& number, const Label& label, const Is_marked& is_marked,
                        const Thread_policy& threads, Flat_triangulation_3& flat)
{
  return Triangulation_flattener_3<Triangulation, Number, Label, Is_marked>(tr, cells, number, label, is_marked,
                                                                            threads)(flat);
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_FLATTEN_TRIANGULATION_3_H
