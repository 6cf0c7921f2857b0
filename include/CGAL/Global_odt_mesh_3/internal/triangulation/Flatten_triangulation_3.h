// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_FLATTEN_TRIANGULATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_FLATTEN_TRIANGULATION_3_H

#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flat_triangulation_3.h>

#include <CGAL/Time_stamper.h>
#include <CGAL/Unique_hash_map.h>

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

// Loads the cells of `tr` for which `is_inside` holds into flat arrays, vertices
// being named by `number`. Facets for which `is_constrained` holds, and those between
// inside and outside, become constrained facets, with side 0 on the side of the facet's cell.
// The constrained facets are returned, followed by facets that are constrained facets according to
// `is_constrained` and have no cell inside.
template <class Triangulation, class Number, class Is_inside, class Is_constrained>
std::vector<Constrained_facet<Triangulation> >
flatten_triangulation_3(const Triangulation& tr,
                        const Number& number,
                        const Is_inside& is_inside,
                        const Is_constrained& is_constrained,
                        Flat_triangulation_3& flat)
{
  typedef typename Triangulation::Cell_handle Cell_handle;
  typedef typename Triangulation::Facet Facet;
  typedef CGAL::Hash_handles_with_or_without_timestamps Hash;

  std::vector<Constrained_facet<Triangulation> > constrained_facets, outside_facets;
  std::vector<Cell_handle> cells;
  CGAL::Unique_hash_map<Cell_handle, int, Hash> cell_number(-1, 2 * tr.number_of_vertices());
  flat = Flat_triangulation_3();
  flat.reserve(tr.number_of_vertices(), tr.number_of_cells());
  for(auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
  {
    std::array<int, 4> v;
    for(int i = 0; i < 4; ++i)
      v[i] = number(c->vertex(i));
    if(is_inside(c))
    {
      // CGAL orders the vertices of a cell as we do.
      cell_number[c] = flat.add_cell(v[0], v[1], v[2], v[3]);
      cells.push_back(c);
      continue;
    }
    // Facets of the complex without any cell of the complex occur where the
    // surface folds.
    for(int i = 0; i < 4; ++i)
    {
      const Cell_handle d = c->neighbor(i);
      const bool second_visit = !tr.is_infinite(d) && d < Cell_handle(c);
      if(!second_visit && (tr.is_infinite(d) || !is_inside(d)) && is_constrained(Facet(c, i)))
      {
        const auto& f = Flat_triangulation_3::facet_vertices(i);
        outside_facets.push_back({ Facet(c, i), {{ v[f[0]], v[f[1]], v[f[2]] }} });
      }
    }
  }
  for(std::size_t n = 0; n < cells.size(); ++n)
    for(int i = 0; i < 4; ++i)
    {
      const Cell_handle c = cells[n], d = c->neighbor(i);
      const int slot = static_cast<int>(4 * n) + i;
      const int beyond = cell_number[d];
      const int mirror = beyond < 0 ? -1 : 4 * beyond + d->index(c);
      if(mirror >= 0 && mirror < slot)
        continue;
      if(mirror >= 0 && !is_constrained(Facet(c, i)))
      {
        flat.set_neighbors(slot, mirror);
        continue;
      }
      const int facet_number = static_cast<int>(constrained_facets.size());
      const auto& f = Flat_triangulation_3::facet_vertices(i);
      constrained_facets.push_back({ Facet(c, i), {{ flat.vertex(slot - i + f[0]), flat.vertex(slot - i + f[1]),
                                        flat.vertex(slot - i + f[2]) }} });
      flat.set_neighbors(slot, Flat_triangulation_3::constrained_neighbor(facet_number, 0));
      if(mirror >= 0)
        flat.set_neighbors(mirror, Flat_triangulation_3::constrained_neighbor(facet_number, 1));
    }
  constrained_facets.insert(constrained_facets.end(), outside_facets.begin(), outside_facets.end());
  return constrained_facets;
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_FLATTEN_TRIANGULATION_3_H
