// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_VERTEX_CAVITY_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_VERTEX_CAVITY_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Exact_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Labelled_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Trial_predicates_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The cells that the regular triangulation exchanges when a vertex moves, comes, or goes. The triangulation is unchanged until
// replace() is called, so that threads may examine several vertices at once.
//
// The hole that a vertex leaves is filled once, for all its trial places, by gift wrapping: each facet gets the cell whose sphere
// contains no other vertex of the hole. At a trial place, the cells in conflict, in the hole and around it, give way to cells that
// join the vertex to the boundary of the conflict region. Signs that are uncertain in floating-point numbers are those of the
// triangulation.
class Vertex_cavity_3
  : private Trial_predicates_3
{
public:
  static constexpr int unlabelled = -4;         // the label of a cell not labelled yet

  struct Cell
  {
    Quadruple vertices;                         // -1 for the infinite one
    int label = unlabelled;
    int number = Labelled_triangulation_3::no_cell;     // in the triangulation, if it is there
    bool is_guessed = false;                    // whether only the domain knows the label
    bool is_asked = false, fits = true;         // whether the domain has been asked and agrees with the label
    Vector_3 dual;       // once the domain has been asked
    Cell_lack lack = Cell_lack();
    bool is_measured = false;

    bool is_infinite() const { return *std::min_element(vertices.begin(), vertices.end()) < 0; }
  };

  explicit Vertex_cavity_3(const Labelled_triangulation_3& triangulation)
    : Trial_predicates_3(triangulation.sites())
    , triangulation_(triangulation)
  {}

  using Trial_predicates_3::vertex;
  using Trial_predicates_3::site;
  using Trial_predicates_3::sites;

  bool is_new() const { return is_new_; }

  // The cells around the vertex, in an order independent of the triangulation's, and its finite neighbors.
  std::vector<Cell>& star() { return star_; }
  const std::vector<Cell>& star() const { return star_; }
  const std::vector<int>& link() const { return link_; }

  // Begins with a vertex of the triangulation; false if it has too many neighbors.
  bool start(int v)
  {
    set_vertex(v);
    is_new_ = is_filled_ = false;
    hole_.clear();
    outer_.clear();
    outer_numbers_.clear();
    return find_star();
  }

  // Begins with a vertex that is not in the triangulation, near a cell.
  void start_new(int v, int nearby)
  {
    set_vertex(v);
    is_new_ = is_filled_ = true;
    star_.clear();
    link_.clear();
    hole_.clear();
    outer_.clear();
    outer_.push_back({ known_cell(nearby), Sphere() });
    outer_numbers_.assign(1, nearby);
  }

  // Finds the exchanged cells for a trial place; false if the vertex would be hidden there or is too far away.
  bool find_cells(const Site& s)
  {
    move_vertex(s);
    created_.clear();
    queue_.clear();
    ++search_;
    if(!fill_hole())
      return false;
    for(Hole_cell& h : hole_)
      h.is_in_conflict = is_in_conflict(h.sphere);
    for(std::size_t n = 0; n < hole_.size(); ++n)
      if(hole_[n].is_in_conflict)
        visit_neighbors_of_hole_cell(static_cast<int>(n));
    if(is_new_)
      visit_near();
    for(std::size_t n = 0; n < queue_.size() && outer_.size() < most_cells; ++n)
      visit_neighbors(queue_[n]);
    list_cells();
    return !created_.empty() && outer_.size() < most_cells
           && std::all_of(created_.begin(), created_.end(), [this](const Cell& c) { return is_positive(c.vertices); });
  }

  // Finds the exchanged cells for a removal; false if the vertex cannot be removed.
  bool find_cells_without()
  {
    created_.clear();
    queue_.clear();
    ++search_;
    const bool is_filled = fill_hole();
    for(Hole_cell& h : hole_)
      h.is_in_conflict = false;
    list_cells();
    return is_filled;
  }

  // The cells that go and those that come, as found last.
  const std::vector<Cell*>& old_cells() const { return old_cells_; }
  const std::vector<Cell*>& new_cells() const { return new_cells_; }

  // The cell beyond a facet of the hull of the cells that go, given by its sorted vertices.
  int beyond(const Triple& facet) const
  {
    for(const Cell* c : old_cells_)
      for(int i = 0; i < 4; ++i)
        if(const int n = triangulation_.neighbor(c->number, i); sorted(facet_vertices(c->vertices, i)) == facet && !goes(n))
          return n;
    return Labelled_triangulation_3::no_cell;
  }

  // Puts the new cells into the triangulation, with the vertex at its trial place.
  void replace(Labelled_triangulation_3& triangulation)
  {
    triangulation.set_site(vertex(), site(vertex()));
    std::vector<std::pair<Quadruple, int> > cells;
    for(const Cell* c : new_cells_)
      cells.emplace_back(c->vertices, c->label);
    std::vector<int> old;
    for(const Cell* c : old_cells_)
      old.push_back(c->number);
    const std::vector<int> created = triangulation.replace(old, cells);
    for(std::size_t n = 0; n < created.size(); ++n)
      new_cells_[n]->number = created[n];
  }

private:
  static constexpr std::size_t most_cells = 500;            // around a vertex; with more, trials take too long

  struct Outer_cell
  {
    Cell cell;
    Sphere sphere;
    std::array<int, 4> beyond = {{ unknown, unknown, unknown, unknown }};     // other outer cells, or ~n for cell n of the star
    std::size_t searched = 0;                   // the last search that came here
    bool is_in_conflict = false;
  };

  struct Hole_cell
  {
    Cell cell;
    Sphere sphere;
    std::array<int, 4> beyond;                  // other hole cells, or ~n for what is beyond cell n of the star
    bool is_in_conflict;
  };

  // A facet that still needs a cell of the hole: its vertices, clockwise as seen from that cell.
  struct Open_facet
  {
    Triple key, facet;
    int owner, index;                           // the cell beyond, as above, and its facet
  };

  static constexpr int unknown = (std::numeric_limits<int>::max)();

  Cell known_cell(int c) const
  {
    Cell cell;
    cell.vertices = triangulation_.vertices(c);
    cell.label = triangulation_.label(c);
    cell.number = c;
    return cell;
  }

  bool find_star()
  {
    if(!triangulation_.star(vertex(), most_cells, numbers_) || numbers_.empty())
      return false;
    keys_.clear();
    for(int c : numbers_)
      keys_.emplace_back(sorted(triangulation_.vertices(c)), c);
    std::sort(keys_.begin(), keys_.end());
    std::transform(keys_.begin(), keys_.end(), numbers_.begin(), [](const auto& k) { return k.second; });
    star_.clear();
    link_.clear();
    for(const auto& k : keys_)
    {
      star_.push_back(known_cell(k.second));
      for(int w : k.first)
        if(w != vertex() && std::find(link_.begin(), link_.end(), w) == link_.end())
          link_.push_back(w);
    }
    std::sort(link_.begin(), link_.end());
    has_infinite_ = link_.front() < 0;
    if(has_infinite_)
      link_.erase(link_.begin());
    return true;
  }

  // Fills the hole; false if that is impossible, since the triangulation would lose its dimension.
  bool fill_hole()
  {
    if(is_filled_)
      return is_new_ || !hole_.empty();
    is_filled_ = true;
    hole_of_star_.assign(star_.size(), 0);
    open_.clear();
    for(std::size_t n = 0; n < star_.size(); ++n)
    {
      const Quadruple& q = star_[n].vertices;
      const Triple f = facet_vertices(q, index_of(q, vertex()));
      open_.push_back({ sorted(f), f, ~static_cast<int>(n), 0 });
    }
    while(!open_.empty())
    {
      const Open_facet f = open_.back();
      open_.pop_back();
      if(hole_.size() > 2 * most_cells || !add_hole_cell(f))
      {
        hole_.clear();
        return false;
      }
    }
    return true;
  }

  bool add_hole_cell(const Open_facet& f)
  {
    const int n = static_cast<int>(hole_.size());
    hole_.emplace_back();
    if(!find_apex(f, hole_.back().sphere))
      return false;
    const Quadruple q = hole_.back().sphere.vertices;
    hole_.back().cell.vertices = q;
    glue(n, 0, f.owner, f.index);
    for(int i = 1; i < 4; ++i)
    {
      const Triple& o = facet_indices(i);
      const Triple g = {{ q[o[0]], q[o[2]], q[o[1]] }}, key = sorted(g);
      const auto other = std::find_if(open_.begin(), open_.end(), [&key](const Open_facet& e)
                                      { return e.key[0] == key[0] && e.key[1] == key[1] && e.key[2] == key[2]; });
      if(other == open_.end())
        open_.push_back({ key, g, n, i });
      else
      {
        glue(n, i, other->owner, other->index);
        *other = open_.back();
        open_.pop_back();
      }
    }
    return true;
  }

  void glue(int n, int i, int owner, int index)
  {
    hole_[n].beyond[i] = owner;
    if(owner >= 0)
      hole_[owner].beyond[index] = n;
    else
      hole_of_star_[~owner] = n;
  }

  // Finds the cell on a facet whose sphere contains no neighbor.
  bool find_apex(const Open_facet& open, Sphere& best) const
  {
    const Triple& f = open.facet;
    const bool is_infinite = open.key[0] < 0;
    bool is_found = false;
    for(int d : link_)
    {
      if(d == f[0] || d == f[1] || d == f[2] || (is_found && !is_in_conflict(best, d)))
        continue;
      const Quadruple q = {{ d, f[0], f[1], f[2] }};
      if(!(is_infinite ? continues_hull(open, d) : is_positive(q)))
        continue;
      best = sphere(q);
      is_found = true;
    }
    if(!is_found && !is_infinite && has_infinite_)
    {
      best = sphere({{ -1, f[0], f[1], f[2] }});
      is_found = true;
    }
    return is_found;
  }

  // Whether a vertex and the edge of an infinite facet continue the hull. They do not if they are in a flat part of the hull that
  // is known already.
  bool continues_hull(const Open_facet& open, int d) const
  {
    const bool is_of_star = open.owner < 0;
    const Quadruple q = {{ open.key[1], open.key[2], is_of_star ? vertex() : hole_[open.owner].cell.vertices[open.index], d }};
    const auto p = [&](int i) { return weighted_point(triangulation_.sites()[q[i]]).point(); };
    // The known part lies beyond the edge, as seen from the vertex in the hole, or is a cell of the hole.
    return CGAL::orientation(p(0), p(1), p(2), p(3)) != COPLANAR
           || CGAL::coplanar_orientation(p(0), p(1), p(2), p(3)) == (is_of_star ? POSITIVE : NEGATIVE);
  }

  // The number of a cell among the outer cells, or ~n if it is cell n of the star.
  int local(int c)
  {
    if(!is_new_ && index_of(triangulation_.vertices(c), vertex()) < 4)
      return ~static_cast<int>(std::find(numbers_.begin(), numbers_.end(), c) - numbers_.begin());
    const std::size_t n = std::find(outer_numbers_.begin(), outer_numbers_.end(), c) - outer_numbers_.begin();
    if(n == outer_.size())
    {
      const Cell cell = known_cell(c);
      outer_.push_back({ cell, sphere(cell.vertices) });
      outer_numbers_.push_back(c);
    }
    return static_cast<int>(n);
  }

  // Whether a cell outside the hole is in conflict; if so, its neighbors are queued for visits.
  bool visit(int n)
  {
    Outer_cell& c = outer_[n];
    if(c.searched == search_)
      return c.is_in_conflict;
    c.searched = search_;
    c.is_in_conflict = is_in_conflict(c.sphere);
    if(c.is_in_conflict)
      queue_.push_back(n);
    return c.is_in_conflict;
  }

  void visit_neighbors_of_hole_cell(int n)
  {
    for(int i = 0; i < 4; ++i)
    {
      const int b = hole_[n].beyond[i];
      if(b >= 0 ? !hole_[b].is_in_conflict : !visit(beyond_star(~b)))
        create(hole_[n].cell.vertices, i);
    }
  }

  void visit_neighbors(int n)
  {
    for(int i = 0; i < 4; ++i)
    {
      if(outer_[n].beyond[i] == unknown)
      {
        const int b = local(triangulation_.neighbor(outer_[n].cell.number, i));
        outer_[n].beyond[i] = b;
      }
      const int b = outer_[n].beyond[i];
      if(b >= 0 ? !visit(b) : !hole_[hole_of_star_[~b]].is_in_conflict)
        create(outer_[n].cell.vertices, i);
    }
  }

  // The outer cell beyond cell n of the star, across from the vertex.
  int beyond_star(int n)
  {
    const Cell& c = star_[n];
    return local(triangulation_.neighbor(c.number, index_of(c.vertices, vertex())));
  }

  // Visits the cell near a new vertex and, if it is not in conflict, its neighbors, until one is.
  void visit_near()
  {
    outer_[0].sphere = sphere(outer_[0].cell.vertices);
    if(!visit(0))
      for(int i = 0; i < 4 && queue_.empty(); ++i)
        visit(local(triangulation_.neighbor(outer_[0].cell.number, i)));
  }

  void create(Quadruple q, int i)
  {
    q[i] = vertex();
    created_.emplace_back();
    created_.back().vertices = q;
  }

  void list_cells()
  {
    old_cells_.clear();
    new_cells_.clear();
    for(Cell& c : star_)
      old_cells_.push_back(&c);
    for(int n : queue_)
      old_cells_.push_back(&outer_[n].cell);
    for(Hole_cell& h : hole_)
      if(!h.is_in_conflict)
        new_cells_.push_back(&h.cell);
    for(Cell& c : created_)
      new_cells_.push_back(&c);
  }

  bool goes(int c) const
  { return std::any_of(old_cells_.begin(), old_cells_.end(), [c](const Cell* o) { return o->number == c; }); }

  const Labelled_triangulation_3& triangulation_;
  bool is_new_ = false, is_filled_ = false, has_infinite_ = false;
  std::vector<int> numbers_, outer_numbers_;    // of the star's cells and the outer cells
  std::vector<std::pair<Quadruple, int> > keys_;
  std::vector<Cell> star_, created_;
  std::vector<int> link_, hole_of_star_;        // finite neighbors; for each star cell, the hole cell at its outer facet
  std::vector<Hole_cell> hole_;
  std::vector<Open_facet> open_;
  std::vector<Outer_cell> outer_;               // around the star, as far as they have been visited
  std::vector<int> queue_;                      // outer cells in conflict
  std::size_t search_ = 0;
  std::vector<Cell*> old_cells_, new_cells_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_VERTEX_CAVITY_3_H
