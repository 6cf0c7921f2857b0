// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CERTIFIED_REGION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CERTIFIED_REGION_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Exact_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Half_facet.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Exact tests of a cell.
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

  // Whether the site is strictly outside of the sphere of the cell, which is positive.
  bool is_outside(const Site& s) const
  {
    const auto side = Exact_traits().power_side_of_oriented_power_sphere_3_object();
    return side(points_[0], points_[1], points_[2], points_[3], weighted_point(s)) == ON_NEGATIVE_SIDE;
  }

private:
  std::array<Weighted_point, 4> points_;
};

// The cells of an indexed triangulation that are transferred into an exact one: those around vertices that are left
// out when the others are inserted. Insertion gives all cells that have no such vertex.
class Transferred_cells_3
{
public:
  // At first, nearly all vertices of the interior are left out.
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

  // The slot across the facet, also if the facet is constrained, or none.
  Half_facet mate(Half_facet s) const
  {
    const Half_facet across = indexed_.neighbor(s);
    return across.is_side() && !across.is_none() ? indexed_.constrained_half_facet(across.other_side()) : across;
  }

  // Whether cells that are not transferred follow across the facet.
  bool is_border(Half_facet s) const
  {
    const Half_facet across = mate(s);
    return across.is_none() || !is_transferred(across.cell());
  }

  // Of cells that are transferred.
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

  // The cell is not transferred: its vertices are inserted. The cells that this concerns are
  // known after update().
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

  // The vertices that are not left out any more since this was called last.
  std::vector<int> take_news()
  {
    std::vector<int> news;
    news.swap(news_);
    return news;
  }

private:
  // Of the interior. Vertices of a round surface alone are on one sphere up to rounding, and to triangulate them takes
  // exact numbers; a few points inside of it keep them apart.
  static constexpr int one_inserted_of = 128;

  const Indexed_triangulation_3& indexed_;
  const Thread_policy threads_;
  std::vector<char> is_left_out_;     // of vertices
  std::vector<char> is_transferred_;        // of cells
  std::vector<int> cells_, news_;
  int number_of_inserted_vertices_ = 0;
};

// Rejects the cells that are not positive, and those on both sides of facets that are not strictly locally
// regular. Where spheres pass through five vertices, insertion is to decide.
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

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CERTIFIED_REGION_3_H
