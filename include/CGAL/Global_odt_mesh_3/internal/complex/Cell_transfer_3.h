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

#include <CGAL/Global_odt_mesh_3/internal/complex/Exact_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Labelled_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>

#include <CGAL/assertions.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Exact predicates of one cell.
class Exact_cell_3
{
public:
  Exact_cell_3(const std::vector<Site>& sites, const int* v)
    : points_{{ weighted_point(sites[v[0]]), weighted_point(sites[v[1]]), weighted_point(sites[v[2]]), weighted_point(sites[v[3]]) }}
  {}

  bool is_positive() const
  {
    const auto bare = Exact_traits().construct_point_3_object();
    return Exact_traits().orientation_3_object()(bare(points_[0]), bare(points_[1]), bare(points_[2]), bare(points_[3])) == POSITIVE;
  }

  // Whether the site is strictly outside the sphere of the cell, which is positive.
  bool is_outside(const Site& s) const
  {
    const auto side = Exact_traits().power_side_of_oriented_power_sphere_3_object();
    return side(points_[0], points_[1], points_[2], points_[3], weighted_point(s)) == ON_NEGATIVE_SIDE;
  }

private:
  std::array<Weighted_point, 4> points_;
};

// The cells of an indexed triangulation that are transferred into an exact one: those around the vertices that are left out when
// the others are inserted. Insertion creates all other cells.
class Transferred_cells_3
{
public:
  // At first, nearly all interior vertices are left out.
  Transferred_cells_3(const Indexed_triangulation_3& flat, int number_of_interior_vertices, int number_of_vertices,
                      const Thread_policy& threads)
    : indexed_(flat)
    , threads_(threads)
    , is_left_out_(number_of_vertices, false)
    , is_transferred_(flat.number_of_cell_slots(), false)
  {
    for(int v = 0; v < number_of_vertices; ++v)
    {
      is_left_out_[v] = v < number_of_interior_vertices && v % one_inserted_of != 0 && flat.incident_cell(v) >= 0;
      if(!is_left_out_[v])
        news_.push_back(v);
    }
    cells_ = collect_in_chunks(flat.number_of_cell_slots(), threads_, [this](int c, std::vector<int>& alive)
    {
      if(indexed_.is_alive(c))
        alive.push_back(c);
    });
    number_of_inserted_vertices_ = static_cast<int>(news_.size());
    update();
  }

  const Indexed_triangulation_3& indexed() const { return indexed_; }
  const std::vector<int>& cells() const { return cells_; }
  bool is_transferred(int cell) const { return is_transferred_[cell]; }
  bool is_left_out(int v) const { return is_left_out_[v]; }
  int number_of_inserted_vertices() const { return number_of_inserted_vertices_; }

  // The slot across the facet, even if the facet is constrained; or none.
  Half_facet mate(Half_facet s) const
  {
    const Half_facet across = indexed_.neighbor(s);
    return across.is_side() && !across.is_none() ? indexed_.constrained_half_facet(across.other_side()) : across;
  }

  // Whether the cell across the facet is missing or not transferred.
  bool is_border(Half_facet s) const
  {
    const Half_facet across = mate(s);
    return across.is_none() || !is_transferred(across.cell());
  }

  // The border facets of the transferred cells.
  std::vector<Half_facet> border() const
  {
    const auto find_border = [this](int n, std::vector<int>& slots)
    {
      for(int i = 0; i < 4; ++i)
        if(const Half_facet s(cells_[n], i); is_border(s))
          slots.push_back(s.id());
    };
    const std::vector<int> slots = collect_in_chunks(static_cast<int>(cells_.size()), threads_, find_border);
    return std::vector<Half_facet>(slots.begin(), slots.end());
  }

  // Gives up the transfer of the cell: its vertices are to be inserted. The other cells this affects are known after update().
  void reject(int cell)
  {
    for(int i = 0; i < 4; ++i)
    {
      const int v = indexed_.vertices(cell)[i];
      if(!is_left_out_[v])
        continue;
      is_left_out_[v] = false;
      news_.push_back(v);
      ++number_of_inserted_vertices_;
    }
  }

  void update()
  {
    cells_ = collect_in_chunks(static_cast<int>(cells_.size()), threads_, [this](int n, std::vector<int>& transferred)
    {
      const int c = cells_[n];
      is_transferred_[c] = std::any_of(indexed_.vertices(c), indexed_.vertices(c) + 4, [this](int v) { return is_left_out_[v]; });
      if(is_transferred_[c])
        transferred.push_back(c);
    });
  }

  // The vertices that have ceased to be left out since the last call.
  std::vector<int> take_news()
  {
    std::vector<int> news;
    news.swap(news_);
    return news;
  }

private:
  // One in so many interior vertices is inserted. Without any, the vertices of a round surface lie on one sphere up to rounding,
  // and triangulating them takes exact arithmetic; a few points inside avoid that.
  static constexpr int one_inserted_of = 128;

  const Indexed_triangulation_3& indexed_;
  const Thread_policy threads_;
  std::vector<char> is_left_out_;     // of vertices
  std::vector<char> is_transferred_;        // of cells
  std::vector<int> cells_, news_;
  int number_of_inserted_vertices_ = 0;
};

// Rejects cells that are not positive, and those on both sides of facets that are not strictly locally regular. If a sphere passes
// through five vertices, insertion decides.
inline void certify_cells(Transferred_cells_3& transferred, const std::vector<Site>& sites, const Thread_policy& threads)
{
  const std::vector<int>& cells = transferred.cells();
  const auto find_wrong_cells = [&](int n, std::vector<int>& wrong)
  {
    const int c = cells[n];
    const Exact_cell_3 cell(sites, transferred.indexed().vertices(c));
    if(!cell.is_positive())
      return wrong.push_back(c);
    for(int i = 0; i < 4; ++i)
    {
      const Half_facet s(c, i), across = transferred.mate(s);
      if(s < across && transferred.is_transferred(across.cell()) && !cell.is_outside(sites[transferred.indexed().vertex(across)]))
        wrong.insert(wrong.end(), { c, across.cell() });
    }
  };
  for(int c : collect_in_chunks(static_cast<int>(cells.size()), threads, find_wrong_cells))
    transferred.reject(c);
  transferred.update();
}

// Builds the exact regular triangulation of points without inserting all of them: most cells of a flat triangulation that is nearly
// regular belong to it.
//
// Those cells are certified, and the other vertices are inserted. The border of the transferred cells is then found among the
// facets of the exact triangulation, and the cells inside that border give way. Since the border bounds that part of the
// triangulation, positive cells cover it exactly once; and since all facets are locally regular, the whole is regular. So the
// result is the same as if all vertices were inserted.
class Cell_transfer_3
{
public:
  // The positions of the indexed mesh may differ from the sites.
  Cell_transfer_3(const Constrained_triangulation_3& mesh, const std::vector<Site>& sites, const Thread_policy& threads)
    : sites_(sites)
    , threads_(threads)
    , transferred_(mesh.topology, mesh.number_of_interior_vertices, static_cast<int>(sites.size()), threads)
  {}

  // False if the transfer does not pay or is impossible.
  bool run(Labelled_triangulation_3& result)
  {
    if(!pays())
      return false;
    // These vertices are inserted whatever certification finds, so both run at once.
    const std::vector<int> first = transferred_.take_news();
    threads_.run_both([&] { tr_.insert_sites(first, sites_); }, [this] { certify_cells(transferred_, sites_, threads_); });
    for(int round = 0; round < most_rounds && pays(); ++round)
    {
      if(!insert_news())
        return false;
      if(!match_border())
        continue;
      if(!find_inside() || !all_vertices_stay())
        return false;
      transplant(result);
      return true;
    }
    return false;
  }

  int number_of_inserted_vertices() const { return transferred_.number_of_inserted_vertices(); }

private:
  typedef Labelled_triangulation_3::Cell Cell;

  static constexpr int most_rounds = 5;
  static constexpr double most_inserted = 0.7;    // of the vertices

  bool pays() const
  {
    return !transferred_.cells().empty() && transferred_.number_of_inserted_vertices() <= most_inserted * double(sites_.size());
  }

  // Inserts the vertices that are no longer left out; false if some are hidden.
  bool insert_news()
  {
    tr_.insert_sites(transferred_.take_news(), sites_);
    if(tr_.dimension() < 3 || tr_.number_of_vertices() != static_cast<std::size_t>(transferred_.number_of_inserted_vertices()))
      return false;
    inserted_.assign(tr_, sites_);
    return true;
  }

  // Finds the border of the transferred cells among the facets of the triangulation, as seen from those cells. If a facet is not
  // found or not strictly regular, its cell is rejected and the answer is false.
  bool match_border()
  {
    border_ = transferred_.border();
    inner_.assign(border_.size(), Half_facet());
    Tuple_table<std::array<int, 3>, int> numbers;
    numbers.reserve(border_.size());
    for(std::size_t n = 0; n < border_.size(); ++n)
      numbers.insert(rotated(transferred_.indexed().facet(border_[n])), static_cast<int>(n));
    for_each_in_chunks(static_cast<int>(inserted_.cells().size()), threads_, [&](int c)
    {
      for(int i = 0; i < 4; ++i)
        if(const int* const n = numbers.find(rotated(facet_vertices(inserted_.vertices(c), i))))
          inner_[*n] = Half_facet(c, i);
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
    if(inner_[n].is_none())
      return false;
    const int beyond = inserted_.vertex(inserted_.mirror(inner_[n]));
    return beyond < 0 || Exact_cell_3(sites_, transferred_.indexed().vertices(border_[n].cell())).is_outside(sites_[beyond]);
  }

  // Finds the cells that give way; false if the border does not bound them.
  bool find_inside()
  {
    std::vector<char> is_border(4 * inserted_.cells().size(), false);
    gives_way_.assign(inserted_.cells().size(), false);
    for(Half_facet f : inner_)
      if(std::exchange(is_border[f.id()], true))
        return false;
    std::vector<int> inside;
    const auto add = [&](int c)
    {
      if(!std::exchange(gives_way_[c], true))
        inside.push_back(c);
    };
    for(Half_facet f : inner_)
      add(f.cell());
    for(std::size_t n = 0; n < inside.size(); ++n)
      for(int i = 0; i < 4; ++i)
      {
        if(inserted_.vertices(inside[n])[i] < 0)
          return false;
        if(const Half_facet f(inside[n], i); !is_border[f.id()])
          add(inserted_.mirror(f).cell());
      }
    return std::none_of(inner_.begin(), inner_.end(), [this](Half_facet f) { return gives_way_[inserted_.mirror(f).cell()]; });
  }

  // Whether all vertices of the cells that give way are vertices of transferred cells.
  bool all_vertices_stay() const
  {
    std::vector<char> stays(sites_.size(), false);
    for(int c : transferred_.cells())
      for(int v : transferred_.indexed().cell(c))
        stays[v] = true;
    for(int c = 0; c < static_cast<int>(inserted_.cells().size()); ++c)
      for(int v : inserted_.vertices(c))
        if(gives_way_[c] && !stays[v])
          return false;
    return true;
  }

  // Replaces the cells that give way with the transferred ones.
  void transplant(Labelled_triangulation_3& result) const
  {
    std::vector<int> place(inserted_.cells().size(), -1), place_of_transferred(transferred_.indexed().number_of_cell_slots(), -1);
    int number = 0;
    for(int c = 0; c < static_cast<int>(inserted_.cells().size()); ++c)
      if(!gives_way_[c])
        place[c] = number++;
    const int first = number;
    for(int c : transferred_.cells())
      place_of_transferred[c] = number++;
    std::vector<Cell> cells(number);
    for_each_in_chunks(static_cast<int>(inserted_.cells().size()), threads_, [&](int c)
    {
      for(int i = 0; place[c] >= 0 && i < 4; ++i)
      {
        const Half_facet across = inserted_.mirror(Half_facet(c, i));
        cells[place[c]].vertices[i] = inserted_.vertices(c)[i];
        if(place[across.cell()] >= 0)
          cells[place[c]].neighbors[i] = Half_facet(place[across.cell()], across.index()).id();
      }
    });
    for_each_in_chunks(static_cast<int>(transferred_.cells().size()), threads_, [&](int n)
    {
      for(int i = 0; i < 4; ++i)
      {
        const Half_facet s(transferred_.cells()[n], i), across = transferred_.mate(s);
        cells[first + n].vertices[i] = transferred_.indexed().vertex(s);
        if(!transferred_.is_border(s))
          cells[first + n].neighbors[i] = Half_facet(place_of_transferred[across.cell()], across.index()).id();
      }
    });
    for(std::size_t n = 0; n < border_.size(); ++n)
    {
      const Half_facet outer = inserted_.mirror(inner_[n]), here(place_of_transferred[border_[n].cell()], border_[n].index()),
                       there(place[outer.cell()], outer.index());
      cells[here.cell()].neighbors[here.index()] = there.id();
      cells[there.cell()].neighbors[there.index()] = here.id();
    }
    result.assign(std::move(cells), sites_);
  }

  const std::vector<Site>& sites_;
  const Thread_policy threads_;
  Exact_triangulation_3 tr_;
  Transferred_cells_3 transferred_;
  Labelled_triangulation_3 inserted_;   // `tr_` with numbered cells
  std::vector<char> gives_way_;         // of the cells of `inserted_`
  std::vector<Half_facet> border_;      // border facets of transferred cells,
  std::vector<Half_facet> inner_;       // and the same facets in `inserted_`, on the side that gives way
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CELL_TRANSFER_3_H
