// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_CERTIFIED_REGION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_CERTIFIED_REGION_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Regularity_filter_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Working_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flat_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Slot.h>

#include <CGAL/enum.h>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Exact tests of cells that are named by the numbers of their vertices. What rounded numbers
// prove is not asked again.
class Exact_regularity_3
{
public:
  Exact_regularity_3(const std::vector<Site>& sites, const Working_traits& traits)
    : sites_(sites)
    , traits_(traits)
  {}

  // The tests of one cell.
  class Cell
  {
  public:
    Cell(const Exact_regularity_3& tests, const int* vertices)
      : tests_(tests)
      , vertices_(vertices)
      , filter_(tests.sites_[vertices[0]], tests.sites_[vertices[1]], tests.sites_[vertices[2]], tests.sites_[vertices[3]])
    {}

    bool is_positive() const
    {
      if(filter_.is_positive())
        return true;
      const auto bare = tests_.traits_.construct_point_3_object();
      return tests_.traits_.orientation_3_object()(bare(point(0)), bare(point(1)), bare(point(2)), bare(point(3))) == POSITIVE;
    }

    // Whether the vertex is strictly outside of the sphere of the cell, which is positive.
    bool is_outside(int v) const
    {
      if(filter_.is_outside(tests_.sites_[v]))
        return true;
      return tests_.traits_.power_side_of_oriented_power_sphere_3_object()(point(0), point(1), point(2), point(3),
                                                                           weighted_point(tests_.sites_[v])) == ON_NEGATIVE_SIDE;
    }

  private:
    Weighted_point point(int i) const { return weighted_point(tests_.sites_[vertices_[i]]); }

    const Exact_regularity_3& tests_;
    const int* vertices_;
    Regularity_filter_3 filter_;
  };

private:
  const std::vector<Site>& sites_;
  const Working_traits& traits_;
};

// The cells of a flat triangulation that are taken over into an exact one: those around vertices that are left
// out when the others are inserted. Insertion gives all cells that have no such vertex.
class Taken_cells_3
{
public:
  // At first, nearly all vertices of the interior are left out.
  Taken_cells_3(const Flat_triangulation_3& flat, int number_of_interior_vertices, int number_of_vertices,
                const Thread_policy& threads)
    : flat_(flat)
    , threads_(threads)
    , is_left_out_(number_of_vertices, false)
    , is_taken_(flat.number_of_cell_slots(), false)
  {
    for(int v = 0; v < number_of_vertices; ++v)
    {
      is_left_out_[v] = v < number_of_interior_vertices && v % one_inserted_of != 0 && flat.incident_cell(v) >= 0;
      if(!is_left_out_[v])
        news_.push_back(v);
    }
    cells_ = collect_in_chunks(flat.number_of_cell_slots(), threads_, [this](int c, std::vector<int>& alive)
    {
      if(flat_.is_alive(c))
        alive.push_back(c);
    });
    number_of_inserted_vertices_ = static_cast<int>(news_.size());
    update();
  }

  const Flat_triangulation_3& flat() const { return flat_; }
  const std::vector<int>& cells() const { return cells_; }
  bool is_taken(int cell) const { return is_taken_[cell]; }
  bool is_left_out(int v) const { return is_left_out_[v]; }
  int number_of_inserted_vertices() const { return number_of_inserted_vertices_; }

  // The slot across the facet, also if the facet is constrained, or none.
  Slot mate(Slot s) const
  {
    const Slot across = flat_.neighbor(s);
    return across.is_side() && !across.is_none() ? flat_.constrained_slot(across.other_side()) : across;
  }

  // Whether cells that are not taken over follow across the facet.
  bool is_border(Slot s) const
  {
    const Slot across = mate(s);
    return across.is_none() || !is_taken(across.cell());
  }

  // Of cells that are taken over.
  std::vector<Slot> border() const
  {
    const auto find_border = [this](int n, std::vector<int>& slots)
    {
      for(int i = 0; i < 4; ++i)
        if(const Slot s(cells_[n], i); is_border(s))
          slots.push_back(s.id());
    };
    const std::vector<int> slots = collect_in_chunks(static_cast<int>(cells_.size()), threads_, find_border);
    return std::vector<Slot>(slots.begin(), slots.end());
  }

  // The cell is not taken over: its vertices are inserted. The cells that this concerns are
  // known after update().
  void reject(int cell)
  {
    for(int i = 0; i < 4; ++i)
    {
      const int v = flat_.vertices(cell)[i];
      if(!is_left_out_[v])
        continue;
      is_left_out_[v] = false;
      news_.push_back(v);
      ++number_of_inserted_vertices_;
    }
  }

  void update()
  {
    cells_ = collect_in_chunks(static_cast<int>(cells_.size()), threads_, [this](int n, std::vector<int>& taken)
    {
      const int c = cells_[n];
      is_taken_[c] = std::any_of(flat_.vertices(c), flat_.vertices(c) + 4, [this](int v) { return is_left_out_[v]; });
      if(is_taken_[c])
        taken.push_back(c);
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

  const Flat_triangulation_3& flat_;
  const Thread_policy threads_;
  std::vector<char> is_left_out_;     // of vertices
  std::vector<char> is_taken_;        // of cells
  std::vector<int> cells_, news_;
  int number_of_inserted_vertices_ = 0;
};

// Rejects the cells that are not positive, and those on both sides of facets that are not strictly locally
// regular. Where spheres pass through five vertices, insertion is to decide.
inline void certify_cells(Taken_cells_3& taken, const Exact_regularity_3& tests, const Thread_policy& threads)
{
  const std::vector<int>& cells = taken.cells();
  const auto find_wrong_cells = [&](int n, std::vector<int>& wrong)
  {
    const int c = cells[n];
    const Exact_regularity_3::Cell cell(tests, taken.flat().vertices(c));
    if(!cell.is_positive())
      return wrong.push_back(c);
    for(int i = 0; i < 4; ++i)
    {
      const Slot s(c, i), across = taken.mate(s);
      if(s < across && taken.is_taken(across.cell()) && !cell.is_outside(taken.flat().vertex(across)))
        wrong.insert(wrong.end(), { c, across.cell() });
    }
  };
  for(int c : collect_in_chunks(static_cast<int>(cells.size()), threads, find_wrong_cells))
    taken.reject(c);
  taken.update();
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_CERTIFIED_REGION_3_H
