// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_DETACHED_VERTEX_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_DETACHED_VERTEX_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Editable_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Exact_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Working_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// A vertex that is taken out of the exact triangulation and looks for a place. The cells around it at a
// place follow from those in conflict with it, so that a place of no use costs no change.
class Detached_vertex_3
{
public:
  // Besides numbers of subdomains, labels tell of new cells that the domain has to be asked, or that there is none.
  static constexpr int unknown = -2, mixed = -3;

  struct Cell
  {
    Quadruple vertices;                                   // -1 for the infinite one
    int label;
    Eigen::Vector3d dual = Eigen::Vector3d::Zero();       // of new cells that are finite
  };

  explicit Detached_vertex_3(Editable_complex_3& complex)
    : complex_(complex)
    , last_on_hull_(1 + complex.sites.size(), 0)
  {}

  bool is_detached() const { return vertex_ >= 0; }
  int vertex() const { return vertex_; }
  const Site& from() const { return from_; }

  // The cells that go and those that come with it, as of find_cells().
  const std::vector<Cell>& old_cells() const { return old_cells_; }
  const std::vector<Cell>& new_cells() const { return new_cells_; }

  // Whether the vertex is to be inserted, and on which patch, if on any.
  bool is_new() const { return is_new_; }
  int patch_of_new() const { return patch_; }

  // Begins with a vertex that is not in the triangulation, near a cell.
  void begin(int v, int patch, Cell_handle start)
  {
    CGAL_assertion(!is_detached());
    is_new_ = true;
    patch_ = patch;
    vertex_ = v;
    from_ = complex_.sites[v];
    last_on_hull_.resize(1 + complex_.sites.size(), 0);
    star_.clear();
    hole_.clear();
    start_ = start;
  }

  // The cells are those without the vertex.
  void find_cells_without()
  {
    conflicts_.clear();
    walls_.clear();
    collect_cells();
  }

  // The vertex does not come back, and the cells without it have been labelled.
  void leave()
  {
    for(const Hole_cell& h : hole_)
    {
      h.handle->set_label(h.label);
      h.handle->clear_flag(IS_IN_HOLE);
    }
    vertex_ = -1;
  }

  void detach(int v)
  {
    CGAL_assertion(!is_detached());
    is_new_ = false;
    patch_ = Boundary_facet::no_patch;
    vertex_ = v;
    from_ = complex_.sites[v];
    std::vector<Cell_handle> star;
    triangulation().incident_cells(complex_.working.vertex(v), std::back_inserter(star));
    std::vector<Facet> around;
    star_.clear();
    for(Cell_handle c : star)
    {
      star_.push_back(Cell{ complex_.numbers(c), c->label() });
      around.push_back(triangulation().mirror_facet({ c, c->index(complex_.working.vertex(v)) }));
    }
    complex_.working.remove(v);
    find_hole(around);
    start_ = hole_.front().handle;
  }

  // To where it was, which is nowhere if it is new; everything is as before.
  void reattach()
  {
    if(is_new_)
    {
      vertex_ = -1;
      return;
    }
    complex_.sites[vertex_] = from_;
    insert(start_, star_);
  }

  // Finds the cells for the place where its site is; false if it would be hidden there or hide another.
  bool find_cells()
  {
    conflicts_.clear();
    walls_.clear();
    const Weighted_point p = complex_.point(vertex_);
    const Cell_handle start = triangulation().locate(p, start_);
    triangulation().find_conflicts(p, start, std::back_inserter(walls_), std::back_inserter(conflicts_));
    if(conflicts_.empty() || hides_vertices())
      return false;
    collect_cells();
    return true;
  }

  // Whether the vertex would be so far from its neighbors, and in no protecting ball of theirs.
  bool has_room(double least_distance) const
  {
    const Site& s = complex_.sites[vertex_];
    const auto is_far = [&](int v)
    {
      return v < 0 || v == vertex_
             || squared_distance(complex_.sites[v], position(s)) > (std::max)(least_distance * least_distance, complex_.sites[v].weight);
    };
    return std::all_of(new_cells_.begin(), new_cells_.end(), [&](const Cell& c)
                       { return std::all_of(c.vertices.begin(), c.vertices.end(), is_far); });
  }

  // Asks the domain for the subdomain in which the dual point of a new cell lies; false if that does not fit.
  bool label_cell(std::size_t n)
  {
    Cell& c = new_cells_[n];
    const Quadruple& q = c.vertices;
    if(*std::min_element(q.begin(), q.end()) < 0)
      return true;
    const Eigen::Vector3d dual = coordinates(triangulation().geom_traits().construct_weighted_circumcenter_3_object()(
      complex_.point(q[0]), complex_.point(q[1]), complex_.point(q[2]), complex_.point(q[3])));
    const int label = complex_.domain.label(dual);
    if(c.label != unknown && c.label != label)
      return false;
    c.label = label;
    c.dual = dual;
    if(n < kept_of_hole_.size())
      hole_[kept_of_hole_[n]].label = label;
    return true;
  }

  // The cell beyond a facet of a new cell, if that is not a new one at the vertex.
  Cell_handle beyond(int new_cell, int index) const
  {
    const std::size_t n = new_cell;
    if(n < kept_of_hole_.size())
      return hole_[kept_of_hole_[n]].handle->neighbor(index);
    const Facet& f = walls_[n - kept_of_hole_.size()];
    return f.first->neighbor(f.second);
  }

  // To the place for which cells have been found and labelled.
  void attach()
  {
    for(const Hole_cell& h : hole_)
      if(h.label >= 0)
        h.handle->set_label(h.label);
    insert(conflicts_.front(), new_cells_);
  }

private:
  struct Hole_cell
  {
    Cell_handle handle;
    int label;
  };

  const Exact_triangulation_3& triangulation() const { return complex_.triangulation(); }

  // The cells that have come where the vertex was, within the facets around it, which are seen from outside.
  void find_hole(const std::vector<Facet>& around)
  {
    hole_.clear();
    const auto add = [this](Cell_handle c)
    {
      if(c->has_flag(IS_IN_HOLE))
        return;
      c->set_flag(IS_IN_HOLE);
      hole_.push_back({ c, label_of_vertices(complex_.numbers(c)) });
    };
    std::set<std::pair<Cell_handle, int> > walls;
    for(const Facet& f : around)
    {
      const Facet inside = triangulation().mirror_facet(f);
      walls.insert({ inside.first, inside.second });
      add(inside.first);
    }
    for(std::size_t n = 0; n < hole_.size(); ++n)
      for(int i = 0; i < 4; ++i)
      {
        const Cell_handle c = hole_[n].handle;
        if(walls.count({ c, i }) == 0)
          add(c->neighbor(i));
      }
  }

  // The one that the vertices off the boundary have.
  int label_of_vertices(const Quadruple& q) const
  {
    if(*std::min_element(q.begin(), q.end()) < 0)
      return Domain_view_3::outside;
    int label = unknown;
    for(int v : q)
    {
      const int l = complex_.numbering.subdomain[v];
      if(l == Editable_complex_3::no_subdomain)
        continue;
      if(label != unknown && label != l)
        return mixed;
      label = l;
    }
    return label;
  }

  // Whether cells in conflict have a vertex that is not one of their hull.
  bool hides_vertices()
  {
    ++search_;
    for(const Facet& f : walls_)
      for(int i = 1; i < 4; ++i)
        last_on_hull(f.first->vertex((f.second + i) % 4)) = search_;
    return std::any_of(conflicts_.begin(), conflicts_.end(), [this](Cell_handle c)
    {
      for(int i = 0; i < 4; ++i)
        if(last_on_hull(c->vertex(i)) != search_)
          return true;
      return false;
    });
  }

  // The last search in which a vertex, perhaps the infinite one, was one of the hull.
  std::size_t& last_on_hull(Vertex_handle v) { return last_on_hull_[1 + Working_triangulation_3::number(v)]; }

  void collect_cells()
  {
    old_cells_ = star_;
    for(Cell_handle c : conflicts_)
    {
      c->set_flag(IS_IN_CONFLICT);
      if(!c->has_flag(IS_IN_HOLE))
        old_cells_.push_back(Cell{ complex_.numbers(c), c->label() });
    }
    new_cells_.clear();
    kept_of_hole_.clear();
    for(std::size_t n = 0; n < hole_.size(); ++n)
      if(!hole_[n].handle->has_flag(IS_IN_CONFLICT))
      {
        new_cells_.push_back(Cell{ complex_.numbers(hole_[n].handle), hole_[n].label });
        kept_of_hole_.push_back(n);
      }
    for(Cell_handle c : conflicts_)
      c->clear_flag(IS_IN_CONFLICT);
    for(const Facet& f : walls_)
    {
      Quadruple q = complex_.numbers(f.first);
      q[f.second] = vertex_;
      new_cells_.push_back(Cell{ q, label_of_vertices(q) });
    }
  }

  // Inserts the vertex at its site; the cells around it get the labels of these.
  void insert(Cell_handle start, const std::vector<Cell>& cells)
  {
    for(const Hole_cell& h : hole_)
      h.handle->clear_flag(IS_IN_HOLE);
    const int v = std::exchange(vertex_, -1);
    complex_.working.insert_near(v, complex_.sites[v], start);
    CGAL_assertion(complex_.working.is_visible(v));
    std::vector<std::pair<Quadruple, int> > labels;
    for(const Cell& c : cells)
      labels.emplace_back(sorted(c.vertices), c.label);
    std::sort(labels.begin(), labels.end());
    std::vector<Cell_handle> star;
    triangulation().incident_cells(complex_.working.vertex(v), std::back_inserter(star));
    for(Cell_handle c : star)
    {
      const Quadruple q = sorted(complex_.numbers(c));
      const auto it = std::lower_bound(labels.begin(), labels.end(), std::make_pair(q, int(mixed)));
      CGAL_assertion(it != labels.end() && it->first == q);
      c->set_label(it->second);
    }
  }

  Editable_complex_3& complex_;
  bool is_new_ = false;
  int patch_ = Boundary_facet::no_patch;
  int vertex_ = -1;
  Site from_ = { 0, 0, 0, 0 };
  Cell_handle start_;                         // near it
  std::vector<Cell> star_;                    // around it before
  std::vector<Hole_cell> hole_;               // in place of these
  std::vector<Cell_handle> conflicts_;
  std::vector<Facet> walls_;                  // of these, seen from them
  std::vector<std::size_t> last_on_hull_;
  std::size_t search_ = 0;
  std::vector<Cell> old_cells_, new_cells_;
  std::vector<std::size_t> kept_of_hole_;     // those of the hole that are the first new cells
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_DETACHED_VERTEX_3_H
