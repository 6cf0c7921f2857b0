// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_LABELLED_TRIANGULATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_LABELLED_TRIANGULATION_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Exact_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Properties of a cell that last as long as its vertices: they are gone when the cell gives way to others.
enum Cell_flag
{
  IS_LABELLED, MAY_HAVE_BOUNDARY_FACETS,     // while a candidate is labelled
  GIVES_WAY                                                   // while some cells are replaced
};

// Whether all cells of a sorted list can be reached from the first one across facets. They cannot if the input is no triangulation
// of space, but has bodies that touch only at vertices or edges, or not at all.
template <class Neighbor>
bool are_connected(const std::vector<int>& cells, const Neighbor& neighbor)
{
  if(cells.empty())
    return true;
  std::vector<char> is_found(cells.back() + 1, false);
  std::vector<int> found(1, cells.front());
  is_found[cells.front()] = true;
  for(std::size_t n = 0; n < found.size(); ++n)
    for(int i = 0; i < 4; ++i)
      if(const int c = neighbor(found[n], i); !is_found[c])
      {
        is_found[c] = true;
        found.push_back(c);
      }
  return found.size() == cells.size();
}

// The same with the vertices of cells. Mostly, it is enough to look at the infinite cells, which are few and bound each body.
template <class Vertices, class Neighbor>
bool are_connected(const std::vector<int>& cells, const Vertices& vertices, const Neighbor& neighbor)
{
  constexpr int infinite = Mesh_table_3::infinite;
  std::vector<int> infinite_cells;
  for(int c : cells)
    if(index_of(vertices(c), infinite) < 4)
      infinite_cells.push_back(c);
  return are_connected(infinite_cells, [&](int c, int i) { return vertices(c)[i] == infinite ? c : neighbor(c, i); })
         || are_connected(cells, neighbor);
}

// A regular triangulation of numbered sites: all cells, including infinite ones, with their labels and facets in the complex. The
// infinite vertex has number -1. Predicates on a vertex that moves are exact, and ties are broken as in CGAL, so that the cells are
// those CGAL creates for the sites; but a table is taken as it is.
class Labelled_triangulation_3
{
public:
  static constexpr int infinite = -1, no_cell = -1;

  struct Cell
  {
    Quadruple vertices;
    std::array<int, 4> neighbors;               // by half-facet number
    int label = 0;
    unsigned char facets_in_complex = 0, flags = 0;
    unsigned char failures = 0;                 // to improve the cell
  };

  const std::vector<Site>& sites() const { return sites_; }

  // All existing cells, listed on the first request after a change.
  const std::vector<int>& cells() const
  {
    if(list_.empty())
      for(int c = 0; c < static_cast<int>(cells_.size()); ++c)
        if(is_cell(c))
          list_.push_back(c);
    return list_;
  }

  bool is_cell(int c) const { return cells_[c].vertices[0] != no_vertex; }
  const Quadruple& vertices(int c) const { return cells_[c].vertices; }
  int vertex(Half_facet f) const { return cells_[f.cell()].vertices[f.index()]; }
  Half_facet mirror(Half_facet f) const { return Half_facet(cells_[f.cell()].neighbors[f.index()]); }
  int neighbor(int c, int i) const { return mirror(Half_facet(c, i)).cell(); }
  // The vertices opposite to the cell in its neighbors.
  Quadruple vertices_beyond(int c) const
  {
    Quadruple result;
    for(int i = 0; i < 4; ++i)
      result[i] = vertex(mirror(Half_facet(c, i)));
    return result;
  }

  bool is_infinite(int c) const { return index_of(vertices(c), infinite) < 4; }

  std::array<Site, 4> cell_sites(int c) const
  {
    const Quadruple& q = vertices(c);
    return {{ sites_[q[0]], sites_[q[1]], sites_[q[2]], sites_[q[3]] }};
  }

  Vector_3 dual_point(int c) const { return exact_dual_point(cell_sites(c)); }

  int label(int c) const { return cells_[c].label; }
  void set_label(int c, int label) { cells_[c].label = label; }

  bool is_in_complex(Half_facet f) const { return cells_[f.cell()].facets_in_complex & (1 << f.index()); }
  void clear_facets(int c) { cells_[c].facets_in_complex = 0; }
  void put_in_complex(Half_facet f)
  {
    for(Half_facet side : { f, mirror(f) })
      cells_[side.cell()].facets_in_complex |= 1 << side.index();
  }

  bool has_flag(int c, Cell_flag flag) const { return cells_[c].flags & (1 << flag); }
  void set_flag(int c, Cell_flag flag) { cells_[c].flags |= 1 << flag; }
  void clear_flags(int c) { cells_[c].flags = 0; }

  int failures(int c) const { return cells_[c].failures; }
  void add_failure(int c) { ++cells_[c].failures; }

  // The vertices of a finite facet, clockwise as seen from its cell, from the lowest on, which does not depend on the order in the
  // cell.
  Triple facet_vertices(Half_facet f) const { return rotated(internal::facet_vertices(vertices(f.cell()), f.index())); }

  // Whether this is the first side of the facet: that of the cell whose opposite vertex has the higher number.
  bool is_first_side(Half_facet f) const { return vertex(mirror(f)) < vertex(f); }

  // Whether the vertex is in the triangulation, and not hidden.
  bool is_visible(int v) const { return cell_of_vertex_[v] != no_cell; }
  bool is_complete() const { return std::find(cell_of_vertex_.begin(), cell_of_vertex_.end(), int(no_cell)) == cell_of_vertex_.end(); }

  // Finds the cells around a vertex, none if it is hidden; false, with only some cells found, if there are more than `most_cells`.
  bool star(int v, std::size_t most_cells, std::vector<int>& cells) const
  {
    cells.clear();
    if(is_visible(v))
      cells.push_back(cell_of_vertex_[v]);
    for(std::size_t n = 0; n < cells.size() && cells.size() <= most_cells; ++n)
      for(int i = 0; i < 4; ++i)
        if(const int c = neighbor(cells[n], i);
           vertices(cells[n])[i] != v && std::find(cells.begin(), cells.end(), c) == cells.end())
          cells.push_back(c);
    return cells.size() <= most_cells;
  }

  std::vector<int> star(int v) const
  {
    std::vector<int> cells;
    star(v, cells_.size(), cells);
    return cells;
  }

  // The sorted neighbors of a vertex; none if it is hidden.
  std::vector<int> neighbors(int v) const
  {
    std::vector<int> result;
    for(int c : star(v))
      std::copy_if(vertices(c).begin(), vertices(c).end(), std::back_inserter(result), [v](int w) { return w >= 0 && w != v; });
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // The largest weight that a vertex may have: its ball must not contain another vertex.
  double largest_weight(int v) const
  {
    double result = (std::numeric_limits<double>::max)();
    for(int w : neighbors(v))
      result = (std::min)(result, squared_distance(sites()[w], position(sites()[v])));
    return result;
  }

  // A cell with these finite vertices, or no_cell.
  template <std::size_t n>
  int find_cell(const std::array<int, n>& t) const
  {
    const std::vector<int> cells = star(t[0]);
    const auto has_all = [&](int c) { return std::all_of(t.begin(), t.end(), [&](int v) { return index_of(vertices(c), v) < 4; }); };
    const auto it = std::find_if(cells.begin(), cells.end(), has_all);
    return it == cells.end() ? int(no_cell) : *it;
  }

  // Whether the triangulation keeps dimension 3 without the vertex. As a rule, the first cell tells.
  bool keeps_dimension_without(int v) const
  {
    std::vector<int> base;
    const auto point = [this](int w) { return weighted_point(sites_[w]).point(); };
    for(int c = 0; c < static_cast<int>(cells_.size()); ++c)
    {
      if(!is_cell(c) || is_infinite(c))
        continue;
      const int i = index_of(vertices(c), v);
      if(i == 4)
        return true;
      const Triple t = internal::facet_vertices(vertices(c), i);
      if(base.empty())
        base.assign(t.begin(), t.end());
      for(int w : t)
        if(!CGAL::coplanar(point(base[0]), point(base[1]), point(base[2]), point(w)))
          return true;
    }
    return false;
  }

  // Becomes the regular triangulation of these sites, without labels.
  void build(const std::vector<Site>& sites)
  {
    std::vector<int> all(sites.size());
    std::iota(all.begin(), all.end(), 0);
    Exact_triangulation_3 tr;
    tr.insert_sites(all, sites);
    assign(tr, sites);
  }

  // Becomes CGAL's triangulation of those sites that are its vertices. Its cells get numbers from 0 on.
  void assign(Exact_triangulation_3& tr, const std::vector<Site>& sites)
  { assign(tr.dimension() == 3 ? numbered_cells(tr) : std::vector<Cell>(), sites); }

  // Becomes a triangulation of these cells.
  void assign(std::vector<Cell> cells, const std::vector<Site>& sites)
  {
    cells_ = std::move(cells);
    sites_ = sites;
    list_.clear();
    free_.clear();
    cell_of_vertex_.assign(sites_.size(), int(no_cell));
    for(std::size_t c = 0; c < cells_.size(); ++c)
      set_cell_of_vertices(static_cast<int>(c));
  }

  // Becomes the triangulation of a table, which need not be regular.
  void copy(const Mesh_table_3& table)
  {
    std::vector<Cell> cells(table.cells.size());
    for(std::size_t n = 0; n < cells.size(); ++n)
    {
      cells[n].vertices = table.cells[n].vertices;
      cells[n].label = table.cells[n].label;
      for(int i = 0; i < 4; ++i)
        cells[n].neighbors[i] = Half_facet(table.cells[n].neighbors[i], table.mirror_index(static_cast<int>(n), i)).id();
    }
    assign(std::move(cells), table.sites);
  }

  // Adds a vertex with the next number, which has no cells yet.
  void add_vertex(const Site& s)
  {
    sites_.push_back(s);
    cell_of_vertex_.push_back(no_cell);
  }

  // The last vertex must have no cells.
  void remove_last_vertex()
  {
    sites_.pop_back();
    cell_of_vertex_.pop_back();
  }

  // To be called along with replace().
  void set_site(int v, const Site& s) { sites_[v] = s; }

  // Renumbers the vertices: those with cells get these numbers, and the others, marked by -1, are dropped.
  void renumber(const std::vector<int>& numbers, const std::vector<Site>& sites)
  {
    for(Cell& c : cells_)
      for(int& v : c.vertices)
        if(v >= 0)
          v = numbers[v];
    std::vector<Cell> cells = std::move(cells_);
    std::vector<int> free = std::move(free_);
    assign(std::move(cells), sites);
    free_ = std::move(free);
  }

  // Replaces cells by others that fill the same space, with these labels. A vertex left without cells is hidden. Returns the
  // numbers of the new cells.
  std::vector<int> replace(const std::vector<int>& old_cells, const std::vector<std::pair<Quadruple, int> >& new_cells)
  {
    std::vector<std::pair<Triple, Half_facet> > sides;
    const auto add_side = [&](Half_facet f) { sides.emplace_back(sorted(internal::facet_vertices(vertices(f.cell()), f.index())), f); };
    for(int c : old_cells)
      set_flag(c, GIVES_WAY);
    for(int c : old_cells)
      for(int i = 0; i < 4; ++i)
        if(const Half_facet across = mirror(Half_facet(c, i)); !has_flag(across.cell(), GIVES_WAY))
          add_side(across);
    for(int c : old_cells)
      for(int v : vertices(c))
        if(v >= 0)
          cell_of_vertex_[v] = no_cell;
    std::vector<int> created;
    for(const auto& n : new_cells)
    {
      const int c = free_cell();
      cells_[c].vertices = n.first;
      cells_[c].label = n.second;
      set_cell_of_vertices(c);
      created.push_back(c);
      for(int i = 0; i < 4; ++i)
        add_side(Half_facet(c, i));
    }
    std::sort(sides.begin(), sides.end());
    for(std::size_t n = 0; n < sides.size(); n += 2)
    {
      CGAL_assertion(n + 1 < sides.size() && sides[n].first == sides[n + 1].first);
      set_mirror(sides[n].second, sides[n + 1].second);
      set_mirror(sides[n + 1].second, sides[n].second);
    }
    // Old numbers become free only now, so that a new cell with the vertices of an old one gets another number.
    for(int c : old_cells)
      cells_[c].vertices[0] = no_vertex;
    free_.insert(free_.end(), old_cells.begin(), old_cells.end());
    list_.clear();
    return created;
  }

  // Puts the vertices of the cell in another order of the same orientation.
  void reorder(int c, const Quadruple& q)
  {
    const Cell before = cells_[c];
    cells_[c].vertices = q;
    cells_[c].facets_in_complex = 0;
    for(int i = 0; i < 4; ++i)
    {
      const int k = index_of(before.vertices, q[i]);
      cells_[c].neighbors[i] = before.neighbors[k];
      set_mirror(Half_facet(before.neighbors[k]), Half_facet(c, i));
      cells_[c].facets_in_complex |= (before.facets_in_complex >> k & 1) << i;
    }
  }

private:
  static constexpr int no_vertex = -2;

  static std::vector<Cell> numbered_cells(Exact_triangulation_3& tr)
  {
    std::vector<Cell> cells;
    for(Exact_triangulation_3::Cell_handle c : tr.all_cell_handles())
    {
      c->set_number(static_cast<int>(cells.size()));
      cells.emplace_back();
      for(int i = 0; i < 4; ++i)
        cells.back().vertices[i] = c->vertex(i)->number();
    }
    for(Exact_triangulation_3::Cell_handle c : tr.all_cell_handles())
      for(int i = 0; i < 4; ++i)
        cells[c->number()].neighbors[i] = Half_facet(c->neighbor(i)->number(), tr.mirror_index(c, i)).id();
    return cells;
  }

  void set_cell_of_vertices(int c)
  {
    if(!is_cell(c))
      return;
    for(int v : vertices(c))
      if(v >= 0)
        cell_of_vertex_[v] = c;
  }

  void set_mirror(Half_facet f, Half_facet mirror) { cells_[f.cell()].neighbors[f.index()] = mirror.id(); }

  int free_cell()
  {
    int c = static_cast<int>(cells_.size());
    if(free_.empty())
      cells_.emplace_back();
    else
    {
      c = free_.back();
      free_.pop_back();
      cells_[c] = Cell();
    }
    return c;
  }

  std::vector<Site> sites_;
  std::vector<Cell> cells_;
  std::vector<int> cell_of_vertex_, free_;
  mutable std::vector<int> list_;               // or empty
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_LABELLED_TRIANGULATION_3_H
