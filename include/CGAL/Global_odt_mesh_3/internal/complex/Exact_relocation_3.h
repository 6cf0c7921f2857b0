// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_EXACT_RELOCATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_EXACT_RELOCATION_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Candidate_checks_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Detached_vertex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Editable_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Facet_exchange_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Working_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Circumradius_bound_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Sliver_steps.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_places.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// What moving one vertex of a complex does to the angles of the cells, with the facets on surfaces that it
// exchanges. A vertex is detached, tried in some places, and then accepted in the last of them or put back.
//
// Vertices of the interior move, and those of dimension 2 that one surface goes around, also if it bends sharply
// there or does not separate subdomains, or through which a line goes where several meet. Without features, such lines
// are known only as well as the surfaces on either side: their vertices move on the one that they are from.
class Exact_relocation_3
{
public:
  // In the triangulation of the snapshot, with whose numbering that of the vertices begins. If `boundary_moves` is false, the
  // boundary stays. Threads share visits of all cells.
  Exact_relocation_3(const Complex_snapshot_3& snapshot, const Vertex_numbering_3& numbering, Working_triangulation_3& triangulation,
                     const Domain_view_3& domain, const Facet_bounds_3& bounds, bool boundary_moves,
                     const Circumradius_bound_3& size_bound, const Thread_policy& threads)
    : complex_(snapshot, numbering, triangulation, domain, threads)
    , detached_(complex_)
    , exchange_(complex_, detached_, bounds, boundary_moves)
    , boundary_moves_(boundary_moves)
    , size_bound_(size_bound)
    , deficit_(Sliver_steps::angles[0] + margin)
    , highest_(deficit_)
  {}

  // The dihedral angle, in degrees, that should be reached in the next trials, and the number of steps of which none
  // may have more cells below it afterwards.
  void set_goal(double bound, int steps)
  {
    steps_ = steps;
    deficit_ = Angle_deficit_3(bound + margin);
    highest_ = Angle_deficit_3((std::max)(bound + margin, steps > 0 ? Sliver_steps::angles[steps - 1] : 0.));
  }

  // For what is to be done with the result.
  Editable_complex_3& complex() { return complex_; }
  const Editable_complex_3& complex() const { return complex_; }
  const Site& site(int v) const { return complex_.sites[v]; }

  // The cells below a bound, by sorted vertices.
  std::vector<Quadruple> slivers(double bound) const
  {
    const std::vector<Cell_handle>& cells = complex_.working.cells();
    return collect_in_chunks<Quadruple>(static_cast<int>(cells.size()), complex_.threads, [&](int n, std::vector<Quadruple>& found)
    {
      const Quadruple q = complex_.numbers(cells[n]);
      if(is_inside(cells[n]->label()) && is_sliver(q, bound))
        found.push_back(sorted(q));
    });
  }

  // Of the triangulation, infinite ones, too.
  std::size_t number_of_cells() const { return complex_.working.cells().size(); }

  // Those among the cells that the last trial has made.
  std::vector<Quadruple> new_slivers(double bound) const
  {
    std::vector<Quadruple> result;
    for(const Cell& c : detached_.new_cells())
      if(is_inside(c.label) && is_sliver(c.vertices, bound))
        result.push_back(sorted(c.vertices));
    return result;
  }

  // The cell of the complex with these vertices.
  bool find_cell(const Quadruple& q, Cell_handle& c) const { return is_cell(q, c) && is_inside(c->label()); }

  // The smallest dihedral angle of a cell, or 90 if there is none with these vertices.
  double smallest_angle(const Quadruple& q) const
  {
    double angle = 90;
    Cell_handle c;
    if(find_cell(q, c))
      Angle_deficit_3(90).for_each_lack(cell_sites(q), [&angle](double lack) { angle = (std::min)(angle, 90 - lack); });
    return angle;
  }

  // Those of a cell or an edge that may move, in order of their numbers: those of the interior come first, as that needs fewer
  // questions to the domain.
  template <class Vertices>
  std::vector<int> movable_vertices(const Vertices& vertices)
  {
    std::vector<int> result;
    std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(result), [this](int v) { return is_movable(v); });
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // Those opposite to a cell in its neighbors that may move.
  std::vector<int> movable_vertices_beyond(const Quadruple& q)
  {
    std::vector<int> beyond;
    Cell_handle c;
    if(is_cell(q, c))
      for(int i = 0; i < 4; ++i)
      {
        const auto v = complex_.triangulation().mirror_vertex(c, i);
        if(!complex_.triangulation().is_infinite(v))
          beyond.push_back(complex_.working.number(v));
      }
    return movable_vertices(beyond);
  }

  // Appends shares of the step of Gauss and Newton toward what the cells around the vertex lack, as far as those promise
  // something; `farthest` is over the mean edge.
  template <class Shares>
  void find_steps(int v, double farthest, const Shares& shares, std::vector<Promising_step>& steps)
  {
    neighborhood_ = Vertex_neighborhood_3(complex_, v, own_patch(v));
    find_star(v);
    Angle_step_3 angle_step(deficit_, neighborhood_.normal);
    for(const Quadruple& q : star_)
      angle_step.add(cell_sites(q), static_cast<int>(std::find(q.begin(), q.end(), v) - q.begin()));
    const Eigen::Vector3d step = angle_step.displacement(farthest * neighborhood_.mean_edge);
    const double before = deficit_of_star();
    const Site from = complex_.sites[v];
    for(double share : shares)
    {
      complex_.sites[v] = site_at(position(from) + share * step, from.weight);
      const double change = deficit_of_star() - before;
      if(change < 0)
        steps.push_back({ v, complex_.sites[v], change });
    }
    complex_.sites[v] = from;
  }

  // Of the detached vertex, in the sphere around a cell.
  std::optional<Site> place_in_sphere(const Quadruple& q, double share) const
  { return internal::place_in_sphere(cell_sites(q), detached_.from(), neighborhood_.normal, share); }

  // Takes a vertex out.
  void detach(int v)
  {
    neighborhood_ = Vertex_neighborhood_3(complex_, v, own_patch(v));
    detached_.detach(v);
  }

  // Begins with a vertex that has been added to the complex, on a patch or inside, near a cell.
  void begin(int v, int patch, Cell_handle start)
  {
    neighborhood_ = Vertex_neighborhood_3();
    detached_.begin(v, patch, start);
  }

  // Whether such a vertex may be where its site is, so far from others, whatever becomes of angles.
  bool fits(double least_distance) { return detached_.find_cells() && detached_.has_room(least_distance) && is_permitted(); }

  // Over which it makes sense to move the detached vertex.
  double mean_edge_length() const { return neighborhood_.mean_edge; }

  // Makes a displacement of the detached vertex one that may be tried: on a surface, it is projected after it has
  // become tangential. False if there is no such place nearby.
  bool place(Site& s)
  {
    constexpr double farthest_projection = 1;         // over the shortest edge
    const int v = detached_.vertex();
    if(complex_.numbering.is_interior(v))
      return true;
    const Eigen::Vector3d& normal = neighborhood_.normal;
    if(normal.isZero())                               // no facet around it is on its own surface
      return false;
    const Eigen::Vector3d way = position(s) - position(detached_.from());
    Eigen::Vector3d p = position(s) - normal.dot(way) * normal;
    if(!complex_.domain.project(p, normal, farthest_projection * neighborhood_.shortest_edge, own_patch(v)))
      return false;
    s = site_at(p, s.weight);
    return true;
  }

  // The change of the sum of the deficits with the detached vertex there, or infinity if it may not be there,
  // if a cell is worse than all that go, or if the change would not be less than `most`.
  double move(const Site& s, double most)
  {
    complex_.sites[detached_.vertex()] = s;
    return detached_.find_cells() && (!detached_.is_new() || detached_.has_room(0)) ? change(most) : infinity;
  }

  // The same if the detached vertex were removed.
  double leave(double most)
  {
    leaves_ = true;
    detached_.find_cells_without();
    return change(most);
  }

  // Whether it may be removed, whatever becomes of angles.
  bool may_leave()
  {
    leaves_ = true;
    detached_.find_cells_without();
    return is_permitted();
  }

  const Detached_vertex_3& detached() const { return detached_; }

  // The sum of the deficits of the new cells.
  double deficit_after() const { return after_.deficit; }

  // The vertex stays where move() has put it, or out if leave() or may_leave() have been called and permit that.
  void accept()
  {
    exchange_.apply();
    if(std::exchange(leaves_, false))
      detached_.leave();
    else
      detached_.attach();
  }

  void reject()
  {
    leaves_ = false;
    detached_.reattach();
  }

private:
  typedef Detached_vertex_3::Cell Cell;
  typedef Exchangeable_boundary_3::Vertex_change Vertex_change;

  static constexpr double margin = 0.25;        // degrees by which steps are to be exceeded: they are no place to get stuck
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  // Whatever becomes of angles.
  bool is_permitted() { return label_cells(infinity) && exchange_.is_permitted(vertex_change()); }

  // Labels that are not known yet count for outside.
  bool is_inside(int label) const { return label >= 0 && label != Domain_view_3::outside; }
  bool is_cell(const Quadruple& q, Cell_handle& c) const
  {
    const Working_triangulation_3& t = complex_.working;
    return std::all_of(q.begin(), q.end(), [&t](int v) { return t.is_visible(v); })
           && t.triangulation().is_cell(t.vertex(q[0]), t.vertex(q[1]), t.vertex(q[2]), t.vertex(q[3]), c);
  }

  bool is_sliver(const Quadruple& q, double bound) const { return Angle_deficit_3(bound)(cell_sites(q)) > 0; }

  std::array<Site, 4> cell_sites(const Quadruple& q) const
  { return {{ site(q[0]), site(q[1]), site(q[2]), site(q[3]) }}; }

  double deficit(const Quadruple& q, const std::array<Site, 4>& s) const { return deficit_(s) + size_bound_.deficit(q.data(), s); }

  // Not one that has been inserted into the snapshot, nor one without which there are no cells.
  bool is_movable(int v)
  {
    if(v >= static_cast<int>(complex_.snapshot.sites.size()) || !complex_.working.keeps_dimension_without(v))
      return false;
    if(!complex_.numbering.is_on_boundary(v) || !boundary_moves_)
      return complex_.numbering.is_interior(v);
    return complex_.numbering.dimensions[v] == 2 && complex_.sites[v].weight == 0
           && complex_.boundary.has_room_to_move(v);
  }

  // The one that the vertex has been on from the beginning, if any.
  int own_patch(int v) const
  { return complex_.numbering.is_on_boundary(v) ? complex_.numbering.input_patch(v) : int(Boundary_facet::no_patch); }

  // Asks the domain about the new cells, those of unknown subdomain with the largest deficits first, which are the most likely
  // to decide; false as soon as one does not fit or the change is not less than `most`.
  bool label_cells(double most)
  {
    double change = change_of_deficit();
    order_.clear();
    for(std::size_t n = 0; n < detached_.new_cells().size(); ++n)
    {
      const Cell& c = detached_.new_cells()[n];
      order_.emplace_back(c.label == Detached_vertex_3::unknown ? -deficit(c.vertices, cell_sites(c.vertices)) : 0., n);
    }
    std::sort(order_.begin(), order_.end());
    for(const auto& o : order_)
    {
      if(!(change < most) || !detached_.label_cell(o.second))
        return false;
      if(is_inside(detached_.new_cells()[o.second].label))
        change -= o.first;
    }
    return true;
  }

  // What becomes of the number of vertices.
  Vertex_change vertex_change() const
  {
    const int v = detached_.vertex();
    return detached_.is_new() ? Vertex_change{ v, true, detached_.patch_of_new() }
         : leaves_ ? Vertex_change{ v, false, own_patch(v) } : Vertex_change();
  }

  // Of the sum of the deficits, by the cells that have been found.
  double change(double most)
  {
    if(!label_cells(most))
      return infinity;
    const double change = change_of_deficit();
    return change < most && after_.is_not_worse_than(before_, steps_) && exchange_.is_permitted(vertex_change())
           ? change : infinity;
  }

  double change_of_deficit()
  {
    before_ = after_ = Sliver_count();
    const Site to = std::exchange(complex_.sites[detached_.vertex()], detached_.from());
    for(const Cell& c : detached_.old_cells())
      add(c, before_);
    complex_.sites[detached_.vertex()] = to;
    for(const Cell& c : detached_.new_cells())
      add(c, after_);
    return after_.deficit - before_.deficit;
  }

  void add(const Cell& c, Sliver_count& count) const
  {
    if(c.label == Detached_vertex_3::mixed)
      count.deficit = infinity;
    if(!is_inside(c.label))
      return;
    const std::array<Site, 4> s = cell_sites(c.vertices);
    count.add(s, highest_, deficit_.bound(), steps_);
    count.deficit += size_bound_.deficit(c.vertices.data(), s);
  }

  // The cells of the complex around a vertex.
  void find_star(int v)
  {
    std::vector<Cell_handle> cells;
    complex_.triangulation().incident_cells(complex_.working.vertex(v), std::back_inserter(cells));
    star_.clear();
    for(Cell_handle c : cells)
      if(is_inside(c->label()))
        star_.push_back(in_canonical_order(complex_.numbers(c)));
    std::sort(star_.begin(), star_.end());
  }

  // Infinite if a cell is turned over.
  double deficit_of_star() const
  {
    double sum = 0;
    for(const Quadruple& q : star_)
    {
      const std::array<Site, 4> s = cell_sites(q);
      if(!(Cell_products(s[0], s[1], s[2], s[3]).determinant > 0))
        return infinity;
      sum += deficit(q, s);
    }
    return sum;
  }

  Editable_complex_3 complex_;
  Detached_vertex_3 detached_;
  Facet_exchange_3 exchange_;
  bool boundary_moves_;
  Circumradius_bound_3 size_bound_;
  int steps_ = 0;
  bool leaves_ = false;                         // whether the detached vertex is to be removed
  Angle_deficit_3 deficit_, highest_;
  std::vector<Quadruple> star_;
  std::vector<std::pair<double, std::size_t> > order_;        // of new cells, by what they may lack
  Vertex_neighborhood_3 neighborhood_;                                 // of the detached vertex
  Sliver_count before_, after_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_EXACT_RELOCATION_3_H
