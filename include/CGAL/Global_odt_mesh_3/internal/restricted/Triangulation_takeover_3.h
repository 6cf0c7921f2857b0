// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_TRIANGULATION_TAKEOVER_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_TRIANGULATION_TAKEOVER_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Certified_region_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Numbered_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Slot.h>

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
// Those cells are certified, and the other vertices inserted; the border of the cells that are taken over is then found
// among the facets of that triangulation, and what is inside of it gives way. As the border of
// a part of the triangulation bounds that part, cells that are positive cover all once; and where all
// facets are locally regular, the whole is regular. So the result is what insertion of all gives.
class Triangulation_takeover_3
{
public:
  // The flat mesh may be at other positions.
  Triangulation_takeover_3(const Constrained_triangulation_3& mesh, const std::vector<Site>& sites,
                           const Thread_policy& threads, Numbered_triangulation_3& numbered)
    : sites_(sites)
    , threads_(threads)
    , numbered_(numbered)
    , tr_(numbered.triangulation())
    , tests_(sites, tr_.geom_traits())
    , taken_(mesh.topology, mesh.number_of_interior_vertices, static_cast<int>(sites.size()), threads)
  {}

  // False if that does not pay or cannot be done, and then nothing is built that is of any use.
  bool run()
  {
    if(!pays())
      return false;
    // As certification leaves these to be inserted anyway.
    const std::vector<int> first = taken_.take_news();
    const auto insert_first = [&]
    {
      numbered_.clear(sites_.size());
      numbered_.insert(first, sites_);
    };
    threads_.run_both(insert_first, [this] { certify_cells(taken_, tests_, threads_); });
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

  int number_of_inserted_vertices() const { return taken_.number_of_inserted_vertices(); }

private:
  typedef Exact_regularity_3::Cell Tested_cell;

  static constexpr int most_rounds = 5;
  static constexpr double most_inserted = 0.7;    // of the vertices

  bool pays() const
  {
    return !taken_.cells().empty() && taken_.number_of_inserted_vertices() <= most_inserted * double(sites_.size());
  }

  // False if vertices get hidden.
  bool insert_news()
  {
    numbered_.insert(taken_.take_news(), sites_);
    return tr_.dimension() == 3
           && tr_.number_of_vertices() == static_cast<std::size_t>(taken_.number_of_inserted_vertices());
  }

  // Finds the border of the cells that are taken over among the facets of the triangulation, as seen from those cells.
  // Where that cannot be done or the facet is not strictly regular, the cell is rejected and the answer is false.
  bool match_border()
  {
    border_ = taken_.border();
    inner_.assign(border_.size(), Facet());
    Tuple_table<std::array<int, 3>, int> numbers;
    numbers.reserve(border_.size());
    for(std::size_t n = 0; n < border_.size(); ++n)
      numbers.insert(rotated(taken_.flat().facet(border_[n])), static_cast<int>(n));
    const std::vector<Cell_handle>& cells = numbered_.cells();
    for_each_in_chunks(static_cast<int>(cells.size()), threads_, [&](int c)
    {
      const std::array<int, 4> v = numbered_.numbers(cells[c]);
      for(int i = 0; i < 4; ++i)
      {
        const std::array<int, 3>& f = facet_indices(i);
        if(const int* const n = numbers.find(rotated({{ v[f[0]], v[f[1]], v[f[2]] }})))
          inner_[*n] = Facet(cells[c], i);
      }
    });
    const auto find_wrong_facets = [this](int n, std::vector<int>& wrong)
    {
      if(!is_border_regular(n))
        wrong.push_back(n);
    };
    const std::vector<int> wrong = collect_in_chunks(static_cast<int>(border_.size()), threads_, find_wrong_facets);
    for(int n : wrong)
      taken_.reject(border_[n].cell());
    taken_.update();
    return wrong.empty();
  }

  bool is_border_regular(int n) const
  {
    if(inner_[n].first == Cell_handle())
      return false;
    const Facet outer = tr_.mirror_facet(inner_[n]);
    const Vertex_handle beyond = outer.first->vertex(outer.second);
    return tr_.is_infinite(beyond)
           || Tested_cell(tests_, taken_.flat().vertices(border_[n].cell())).is_outside(numbered_.number(beyond));
  }

  // Finds the cells that give way, and marks them; false if the border does not bound them.
  bool find_inside()
  {
    for(const Facet& f : inner_)
    {
      if(f.first->is_marked(f.second))
        return false;
      f.first->mark(f.second);
    }
    for(const Facet& f : inner_)
      add_inside(f.first);
    for(std::size_t n = 0; n < inside_.size(); ++n)
    {
      if(tr_.is_infinite(inside_[n]))
        return false;
      for(int i = 0; i < 4; ++i)
        if(!inside_[n]->is_marked(i))
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

  // Whether all vertices of cells that give way are vertices of cells that are taken over.
  bool all_vertices_stay() const
  {
    std::vector<char> stays(sites_.size(), false);
    for(int c : taken_.cells())
      for(int v : taken_.flat().cell(c))
        stays[v] = true;
    return std::all_of(inside_.begin(), inside_.end(), [&](Cell_handle c)
    {
      const std::array<int, 4> v = numbered_.numbers(c);
      return std::all_of(v.begin(), v.end(), [&stays](int w) { return stays[w]; });
    });
  }

  // Puts the cells that are taken over in the place of those that give way.
  void transplant()
  {
    std::vector<Cell_handle> all = numbered_.cells();
    all.erase(std::remove_if(all.begin(), all.end(), [](Cell_handle c) { return c->tds_data().is_in_conflict(); }), all.end());
    for(std::size_t v = 0; v < sites_.size(); ++v)
      if(taken_.is_left_out(static_cast<int>(v)))
        numbered_.create_vertex(static_cast<int>(v), sites_[v]);
    const std::vector<Cell_handle> cells = create_cells();
    for(std::size_t n = 0; n < border_.size(); ++n)
    {
      const Facet outer = tr_.mirror_facet(inner_[n]);
      set_neighbors(Facet(cells[border_[n].cell()], border_[n].index()), outer);
    }
    for(Cell_handle c : inside_)
      tr_.tds().delete_cell(c);
    for(int c : taken_.cells())
      all.push_back(cells[c]);
    numbered_.set_cells(std::move(all));
    CGAL_expensive_assertion(tr_.is_valid());
  }

  // Those that are taken over, by their numbers in the flat mesh, without the neighbors of the border.
  std::vector<Cell_handle> create_cells()
  {
    std::vector<Cell_handle> cells(taken_.flat().number_of_cell_slots());
    std::vector<int> cell_of_vertex(sites_.size(), -1);
    for(int c : taken_.cells())
    {
      cells[c] = tr_.tds().create_cell();
      for(int v : taken_.flat().cell(c))
        cell_of_vertex[v] = c;
    }
    for_each_in_chunks(static_cast<int>(taken_.cells().size()), threads_, [&](int n)
    {
      const int c = taken_.cells()[n];
      for(int i = 0; i < 4; ++i)
      {
        const Slot across = taken_.mate(Slot(c, i));
        cells[c]->set_vertex(i, numbered_.vertex(taken_.flat().vertices(c)[i]));
        cells[c]->set_neighbor(i, across.is_none() ? Cell_handle() : cells[across.cell()]);
      }
    });
    for_each_in_chunks(static_cast<int>(sites_.size()), threads_, [&](int v)
    {
      if(cell_of_vertex[v] >= 0)
        numbered_.vertex(v)->set_cell(cells[cell_of_vertex[v]]);
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
  Numbered_triangulation_3& numbered_;
  Working_triangulation_3& tr_;
  Exact_regularity_3 tests_;
  Taken_cells_3 taken_;
  std::vector<Slot> border_;            // facets of cells that are taken over,
  std::vector<Facet> inner_;            // and where they are in the triangulation, on the side that gives way
  std::vector<Cell_handle> inside_;     // the cells that give way
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_TRIANGULATION_TAKEOVER_3_H
