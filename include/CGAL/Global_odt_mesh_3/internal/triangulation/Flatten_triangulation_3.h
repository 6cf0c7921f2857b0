// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_FLATTEN_TRIANGULATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_FLATTEN_TRIANGULATION_3_H

#include <CGAL/Global_odt_mesh_3/internal/triangulation/Cell_numbers.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flat_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Slot.h>

#include <CGAL/assertions.h>

#include <array>
#include <cstddef>
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
template <class Triangulation, class Number, class Is_inside, class Is_constrained>
class Triangulation_flattener_3
{
public:
  Triangulation_flattener_3(const Triangulation& tr, const Number& number, const Is_inside& is_inside,
                            const Is_constrained& is_constrained, Flat_triangulation_3& flat)
    : tr_(tr)
    , number_(number)
    , is_inside_(is_inside)
    , is_constrained_(is_constrained)
    , flat_(flat)
    , cell_number_(tr.number_of_cells())
  {}

  std::vector<Constrained_facet<Triangulation> > operator()()
  {
    flat_ = Flat_triangulation_3();
    flat_.reserve(tr_.number_of_vertices(), tr_.number_of_cells());
    for(auto c = tr_.finite_cells_begin(); c != tr_.finite_cells_end(); ++c)
      if(is_inside_(c))
        add_cell(c);
      else
        add_outside_facets(c);
    for(std::size_t n = 0; n < cells_.size(); ++n)
      for(int i = 0; i < 4; ++i)
        set_neighbors(Slot(static_cast<int>(n), i));
    facets_.insert(facets_.end(), outside_facets_.begin(), outside_facets_.end());
    CGAL_expensive_assertion(flat_.is_valid());
    return facets_;
  }

private:
  typedef typename Triangulation::Cell_handle Cell_handle;
  typedef typename Triangulation::Facet Facet;

  // CGAL orders the vertices of a cell as we do.
  void add_cell(Cell_handle c)
  {
    cell_number_.set(c, flat_.add_cell(number_(c->vertex(0)), number_(c->vertex(1)), number_(c->vertex(2)),
                                       number_(c->vertex(3))));
    cells_.push_back(c);
  }

  // Facets of the complex without any cell of the complex occur where the surface folds.
  void add_outside_facets(Cell_handle c)
  {
    for(int i = 0; i < 4; ++i)
    {
      const Cell_handle d = c->neighbor(i);
      const bool second_visit = !tr_.is_infinite(d) && number_(tr_.mirror_vertex(c, i)) > number_(c->vertex(i));
      if(second_visit || (!tr_.is_infinite(d) && is_inside_(d)) || !is_constrained_(Facet(c, i)))
        continue;
      const std::array<int, 3>& f = facet_indices(i);
      outside_facets_.push_back({ Facet(c, i), {{ number_(c->vertex(f[0])), number_(c->vertex(f[1])),
                                                  number_(c->vertex(f[2])) }} });
    }
  }

  void set_neighbors(Slot s)
  {
    if(!flat_.neighbor(s).is_none())
      return;
    const Cell_handle c = cells_[s.cell()], d = c->neighbor(s.index());
    const int beyond = cell_number_[d];
    const bool has_mirror = beyond >= 0;
    const Slot mirror = has_mirror ? Slot(beyond, d->index(c)) : Slot();
    const Facet facet(c, s.index());
    if(has_mirror && !is_constrained_(facet))
      return flat_.set_neighbors(s, mirror);
    const int number = static_cast<int>(facets_.size());
    facets_.push_back({ facet, flat_.facet(s) });
    flat_.set_neighbors(s, Slot::side(number, 0));
    if(has_mirror)
      flat_.set_neighbors(mirror, Slot::side(number, 1));
  }

  const Triangulation& tr_;
  const Number& number_;
  const Is_inside& is_inside_;
  const Is_constrained& is_constrained_;
  Flat_triangulation_3& flat_;
  Cell_numbers<Cell_handle> cell_number_;
  std::vector<Cell_handle> cells_;
  std::vector<Constrained_facet<Triangulation> > facets_, outside_facets_;
};

// Loads the cells of `tr` for which `is_inside` holds into flat arrays, vertices
// being named by `number`. Facets for which `is_constrained` holds, and those between
// inside and outside, become constrained facets, with side 0 on the side of the facet's cell.
// They are returned, followed by facets that `is_constrained` names and that have no cell inside.
template <class Triangulation, class Number, class Is_inside, class Is_constrained>
std::vector<Constrained_facet<Triangulation> >
flatten_triangulation_3(const Triangulation& tr, const Number& number, const Is_inside& is_inside,
                        const Is_constrained& is_constrained, Flat_triangulation_3& flat)
{
  return Triangulation_flattener_3<Triangulation, Number, Is_inside, Is_constrained>(tr, number, is_inside, is_constrained,
                                                                                    flat)();
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_FLATTEN_TRIANGULATION_3_H
