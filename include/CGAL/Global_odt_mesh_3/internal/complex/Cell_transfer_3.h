// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CELL_TRANSFER_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CELL_TRANSFER_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Certified_region_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Exact_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Working_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Half_facet.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Builds the exact regular triangulation of points without inserting all of them: most cells of a flat
// triangulation that is nearly it are cells of it.
//
// Those cells are certified, and the other vertices inserted; the border of the cells that are transferred is then found
// among the facets of that triangulation, and what is inside of it gives way. As the border of
// a part of the triangulation bounds that part, cells that are positive cover all once; and where all
// facets are locally regular, the whole is regular. So the result is what insertion of all gives.
class Cell_transfer_3
{
public:
  // The indexed mesh may be at other positions.
  Cell_transfer_3(const Constrained_triangulation_3& mesh, const std::vector<Site>& sites,
                  const Thread_policy& threads, Working_triangulation_3& working)
    : sites_(sites)
    , threads_(threads)
    , working_(working)
    , tr_(working.triangulation())
    , transferred_(mesh.topology, mesh.number_of_interior_vertices, static_cast<int>(sites.size()), threads)
  {}

  // False if that does not pay or cannot be done, and then nothing is built that is of any use.
  bool run()
  {
    if(!pays())
      return false;
    // As certification leaves these to be inserted anyway.
    const std::vector<int> first = transferred_.take_news();
    const auto insert_first = [&]
    {
      working_.clear(sites_.size());
      working_.insert(first, sites_);
    };
    threads_.run_both(insert_first, [this] { certify_cells(transferred_, sites_, threads_); });
    for(int round = 0; round < most_rounds && pays(); ++round)
    {
      if(!insert_news())
        return false;
      if(!match_border())
        continue;
      if(!find_inside() || !all_vertices_stay())
        return false;
      transplant();
      return true;
    }
    return false;
  }

  int number_of_inserted_vertices() const { return transferred_.number_of_inserted_vertices(); }

private:
  static constexpr int most_rounds = 5;
  static constexpr double most_inserted = 0.7;    // of the vertices

  bool pays() const
  {
    return !transferred_.cells().empty() && transferred_.number_of_inserted_vertices() <= most_inserted * double(sites_.size());
  }

  // False if vertices get hidden.
  bool insert_news()
  {
    working_.insert(transferred_.take_news(), sites_);
    return tr_.dimension() == 3
           && tr_.number_of_vertices() == static_cast<std::size_t>(transferred_.number_of_inserted_vertices());
  }

  // Finds the border of the cells that are transferred among the facets of the triangulation, as seen from those cells.
  // Where that cannot be done or the facet is not strictly regular, the cell is rejected and the answer is false.
  bool match_border()
  {
    border_ = transferred_.border();
    inner_.assign(border_.size(), Facet());
    Tuple_table<std::array<int, 3>, int> numbers;
    numbers.reserve(border_.size());
    for(std::size_t n = 0; n < border_.size(); ++n)
      numbers.insert(rotated(transferred_.indexed().facet(border_[n])), static_cast<int>(n));
    const std::vector<Cell_handle>& cells = working_.cells();
    for_each_in_chunks(static_cast<int>(cells.size()), threads_, [&](int c)
    {
      const std::array<int, 4> v = working_.numbers(cells[c]);
      for(int i = 0; i < 4; ++i)
        if(const int* const n = numbers.find(rotated(facet_vertices(v, i))))
          inner_[*n] = Facet(cells[c], i);
    });
    const auto find_wrong_facets = [this](int n, std::vector<int>& wrong)
    {
      if(!is_border_regular(n))
        wrong.push_back(n);
    };
    const std::vector<int> wrong = collect_in_chunks(static_cast<int>(border_.size()), threads_, find_wrong_facets);
    for(int n : wrong)
      transferred_.reject(border_[n].cell());
    transferred_.update();
    return wrong.empty();
  }

  bool is_border_regular(int n) const
  {
    if(inner_[n].first == Cell_handle())
      return false;
    const Facet outer = tr_.mirror_facet(inner_[n]);
    const Vertex_handle beyond = outer.first->vertex(outer.second);
    return tr_.is_infinite(beyond)
           || Exact_cell_3(sites_, transferred_.indexed().vertices(border_[n].cell())).is_outside(sites_[working_.number(beyond)]);
  }

  // Finds the cells that give way, and marks them; false if the border does not bound them.
  bool find_inside()
  {
    for(const Facet& f : inner_)
    {
      if(f.first->has_flag(BORDERS_TRANSFER + f.second))
        return false;
      f.first->set_flag(BORDERS_TRANSFER + f.second);
    }
    for(const Facet& f : inner_)
      add_inside(f.first);
    for(std::size_t n = 0; n < inside_.size(); ++n)
    {
      if(tr_.is_infinite(inside_[n]))
        return false;
      for(int i = 0; i < 4; ++i)
        if(!inside_[n]->has_flag(BORDERS_TRANSFER + i))
          add_inside(inside_[n]->neighbor(i));
    }
    return std::none_of(inner_.begin(), inner_.end(), [](const Facet& f)
                        { return f.first->neighbor(f.second)->tds_data().is_in_conflict(); });
  }

  void add_inside(Cell_handle c)
  {
    if(c->tds_data().is_in_conflict())
      return;
    c->tds_data().mark_in_conflict();
    inside_.push_back(c);
  }

  // Whether all vertices of cells that give way are vertices of cells that are transferred.
  bool all_vertices_stay() const
  {
    std::vector<char> stays(sites_.size(), false);
    for(int c : transferred_.cells())
      for(int v : transferred_.indexed().cell(c))
        stays[v] = true;
    return std::all_of(inside_.begin(), inside_.end(), [&](Cell_handle c)
    {
      const std::array<int, 4> v = working_.numbers(c);
      return std::all_of(v.begin(), v.end(), [&stays](int w) { return stays[w]; });
    });
  }

  // Puts the cells that are transferred in the place of those that give way.
  void transplant()
  {
    std::vector<Cell_handle> all = working_.cells();
    all.erase(std::remove_if(all.begin(), all.end(), [](Cell_handle c) { return c->tds_data().is_in_conflict(); }), all.end());
    for(std::size_t v = 0; v < sites_.size(); ++v)
      if(transferred_.is_left_out(static_cast<int>(v)))
        working_.create_vertex(static_cast<int>(v), sites_[v]);
    const std::vector<Cell_handle> cells = create_cells();
    for(std::size_t n = 0; n < border_.size(); ++n)
    {
      const Facet outer = tr_.mirror_facet(inner_[n]);
      set_neighbors(Facet(cells[border_[n].cell()], border_[n].index()), outer);
    }
    for(Cell_handle c : inside_)
      tr_.tds().delete_cell(c);
    for(int c : transferred_.cells())
      all.push_back(cells[c]);
    working_.set_cells(std::move(all));
    CGAL_expensive_assertion(tr_.is_valid());
  }

  // Those that are transferred, by their numbers in the indexed mesh, without the neighbors of the border.
  std::vector<Cell_handle> create_cells()
  {
    std::vector<Cell_handle> cells(transferred_.indexed().number_of_cell_slots());
    std::vector<int> cell_of_vertex(sites_.size(), -1);
    for(int c : transferred_.cells())
    {
      cells[c] = tr_.tds().create_cell();
      for(int v : transferred_.indexed().cell(c))
        cell_of_vertex[v] = c;
    }
    for_each_in_chunks(static_cast<int>(transferred_.cells().size()), threads_, [&](int n)
    {
      const int c = transferred_.cells()[n];
      for(int i = 0; i < 4; ++i)
      {
        const Half_facet across = transferred_.mate(Half_facet(c, i));
        cells[c]->set_vertex(i, working_.vertex(transferred_.indexed().vertices(c)[i]));
        cells[c]->set_neighbor(i, across.is_none() ? Cell_handle() : cells[across.cell()]);
      }
    });
    for_each_in_chunks(static_cast<int>(sites_.size()), threads_, [&](int v)
    {
      if(cell_of_vertex[v] >= 0)
        working_.vertex(v)->set_cell(cells[cell_of_vertex[v]]);
    });
    return cells;
  }

  static void set_neighbors(const Facet& f, const Facet& g)
  {
    f.first->set_neighbor(f.second, g.first);
    g.first->set_neighbor(g.second, f.first);
  }

  const std::vector<Site>& sites_;
  const Thread_policy threads_;
  Working_triangulation_3& working_;
  Exact_triangulation_3& tr_;
  Transferred_cells_3 transferred_;
  std::vector<Half_facet> border_;            // facets of cells that are transferred,
  std::vector<Facet> inner_;            // and where they are in the triangulation, on the side that gives way
  std::vector<Cell_handle> inside_;     // the cells that give way
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CELL_TRANSFER_3_H
