// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_VERTEX_TRIAL_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_VERTEX_TRIAL_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Editable_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Facet_exchange_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Vertex_cavity_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Exchangeable_boundary_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// A place for a vertex, and the change of the deficits of the angles around it if its cells stay the same.
struct Promising_step
{
  int vertex;
  Site site;
  double change;
};

// Tries what moving, inserting, or removing one vertex of a complex does to the angles of the cells, with the exchange of facets on
// surfaces. A vertex is tried in some places and then accepted in the last of them; until then, the complex is unchanged.
//
// Among vertices that are not fixed, interior ones move. So do vertices of dimension 2 if one surface goes all around them, even if
// it bends sharply there or separates no subdomains, or if several surfaces meet there in one line through them. Without features,
// such lines are known only as well as the surfaces beside them: their vertices move on the surface that they are from.
class Vertex_trial_3
{
public:
  typedef Vertex_cavity_3::Cell Cell;

  explicit Vertex_trial_3(Editable_complex_3& complex)
    : complex_(complex)
    , cavity_(complex.triangulation)
    , exchange_(complex, cavity_)
    , goal_(Sliver_steps::angles[0], 0)
  {}

  // The cells refer to each other.
  Vertex_trial_3(const Vertex_trial_3&) = delete;
  Vertex_trial_3& operator=(const Vertex_trial_3&) = delete;

  void set_goal(const Sliver_goal& goal) { goal_ = goal; }

  // The movable vertices of a cell or an edge, in order of their numbers: interior ones come first, as they need fewer questions to
  // the domain.
  template <class Vertices>
  std::vector<int> movable_vertices(const Vertices& vertices) const
  {
    std::vector<int> result;
    std::copy_if(vertices.begin(), vertices.end(), std::back_inserter(result), [this](int v) { return is_movable(v); });
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // The vertex's site with a weight that lets the vertex `beyond` the cell enter its sphere, changed further by a share of the
  // squared mean edge; none if that weight is too large, or less than in the input.
  std::optional<Site> place_with_weight(const Quadruple& q, int beyond, double share) const
  {
    const int v = cavity_.vertex();
    const std::array<Site, 4> cell = cavity_.sites(q);
    const double unit = mean_edge_ * mean_edge_;
    const double gain = gain_on_sphere({{ cell[0], cell[1], cell[2], cell[3], complex_.sites[beyond] }}, index_of(q, v), unit);
    const double weight = from_.weight + gain + (gain < 0 ? -share : share) * unit;
    const bool is_permitted = weight >= complex_.numbering.input_sites[v].weight && weight <= complex_.triangulation.largest_weight(v);
    return is_permitted ? std::make_optional(site_at(position(from_), weight)) : std::nullopt;
  }

  // The movable vertices opposite to a cell in its neighbors.
  std::vector<int> movable_vertices_beyond(int c) const
  {
    return movable_vertices(complex_.triangulation.vertices_beyond(c));
  }

  // Begins with a movable vertex; false if it has too many neighbors.
  bool start(int v)
  {
    leaves_ = false;
    change_ = Vertex_change();
    from_ = complex_.sites[v];
    if(!cavity_.start(v))
      return false;
    for(Cell& c : cavity_.star())
      if(is_inside(c.label))
        lack(c);
    measure_neighborhood();
    return true;
  }

  // Begins with a vertex that has been added to the complex, on a patch or inside, near a cell.
  void start_new(int v, int patch, int nearby)
  {
    leaves_ = false;
    change_ = Vertex_change{ v, true, patch };
    cavity_.start_new(v, nearby);
  }

  int vertex() const { return cavity_.vertex(); }
  const Site& from() const { return from_; }

  // The scale for moves of the vertex.
  double mean_edge_length() const { return mean_edge_; }

  // Appends shares of the Gauss-Newton step that reduces the deficits of the cells around the vertex, as far as they promise an
  // improvement; `farthest` is relative to the mean edge.
  template <class Shares>
  void find_steps(double farthest, const Shares& shares, std::vector<Promising_step>& steps)
  {
    const int v = cavity_.vertex();
    Angle_step_3 angle_step(goal_.wanted(), normal_);
    for(const Cell& c : cavity_.star())
      if(is_inside(c.label))
        angle_step.add(cavity_.sites(c.vertices), index_of(c.vertices, v));
    const Vector_3 step = angle_step.displacement(farthest * mean_edge_);
    double before = 0;
    for(const Cell& c : cavity_.star())
      before += c.lack.deficit;
    for(double share : shares)
    {
      const Site s = site_at(position(from_) + share * step, from_.weight);
      const double change = deficit_of_star(s, before) - before;
      if(change < 0)
        steps.push_back({ v, s, change });
    }
  }

  // A place inside the sphere around a cell, by this share of the radius, and in the tangential plane for a vertex on a surface;
  // none if the vertex is there already.
  std::optional<Site> place_in_sphere(const Quadruple& q, double share) const
  {
    const std::optional<Vector_3> way = way_into_sphere(cavity_.sites(q), position(from_), normal_, share);
    return way ? std::make_optional(site_at(position(from_) + *way, from_.weight)) : std::nullopt;
  }

  // The change of the sum of the deficits with the vertex at this site, or infinity if it may not be there, if a cell is worse than
  // all old ones, or if the change is not less than `most`. The domain is not asked if its answer can be seen from the vertices.
  double move(const Site& s, double most)
  { return find_cells(s) && (!cavity_.is_new() || has_room(0)) ? change(most) : infinity; }

  // Moves the vertex near a site, which is replaced by the one tried: for a vertex on a surface, it is put into the tangential
  // plane and, if the change promises to be less than `most`, onto the surface.
  double move_near(Site& s, double most)
  {
    constexpr double farthest_projection = 1;         // over the shortest edge
    const int v = cavity_.vertex();
    if(complex_.numbering.is_interior(v) || same_place(s, from_))
      return move(s, most);
    if(normal_ == Vector_3())                              // no facet around it is on its own surface
      return infinity;
    Vector_3 p = position(s) - normal_.dot(position(s) - position(from_)) * normal_;
    s = site_at(p, s.weight);
    if(!find_cells(s) || !promises(most)
       || !complex_.domain.project(p, normal_, farthest_projection * shortest_edge_, own_patch(v)))
      return infinity;
    s = site_at(p, s.weight);
    return move(s, most);
  }

  // Whether a new vertex may be at its site, at this distance from others, whatever that does to angles of cells.
  bool fits(double least_distance)
  {
    return find_cells(complex_.sites[cavity_.vertex()]) && has_room(least_distance) && is_permitted();
  }

  // The change of the sum of the deficits if the vertex were removed.
  double leave(double most)
  {
    prepare_to_leave();
    return cavity_.find_cells_without() ? change(most) : infinity;
  }

  // Whether the vertex may be removed, whatever that does to angles.
  bool may_leave()
  {
    prepare_to_leave();
    return cavity_.find_cells_without() && is_permitted();
  }

  // The cells that go and those that come, as tried last.
  const Vertex_cavity_3& cavity() const { return cavity_; }

  // The sum of the deficits of the new cells.
  double deficit_after() const { return after_.deficit; }

  // Puts the vertex where move() or fits() has tried it, or takes it out after leave() or may_leave(), which must have permitted
  // that. False if the domain does not agree, or finds no surface center for a facet.
  bool accept()
  {
    if(!ask_all() || !exchange_.find_centers(complex_.centers))
      return false;
    exchange_.apply(complex_);
    cavity_.replace(complex_.triangulation);
    return true;
  }

private:
  typedef Exchangeable_boundary_3::Vertex_change Vertex_change;

  static constexpr double infinity = (std::numeric_limits<double>::infinity)();

  // Labels not known yet count as outside.
  static bool is_inside(int label) { return label >= 0 && label != Domain_view_3::outside; }

  // Finds the cells for a site; false if a kept cell would go.
  bool find_cells(const Site& s)
  { return cavity_.find_cells(s) && std::none_of(cavity_.old_cells().begin(), cavity_.old_cells().end(),
                                                 [this](const Cell* c) { return complex_.numbering.is_kept(c->vertices); }); }

  // Whether the change is permitted, whatever that does to angles.
  bool is_permitted() { return promises(infinity) && ask_all() && exchange_.is_permitted(change_); }

  void prepare_to_leave()
  {
    leaves_ = true;
    change_ = Vertex_change{ cavity_.vertex(), false, own_patch(cavity_.vertex()) };
  }

  // Inserted vertices do not move, nor does a vertex without which the triangulation loses its dimension.
  bool is_movable(int v) const
  {
    if(v < 0 || complex_.is_inserted(v) || !complex_.triangulation.keeps_dimension_without(v))
      return false;
    if(!complex_.numbering.is_on_boundary(v) || !complex_.boundary_moves)
      return complex_.numbering.is_interior(v);
    return complex_.numbering.dimensions[v] == 2 && !complex_.numbering.is_fixed(v) && complex_.boundary.has_room_to_move(v);
  }

  // The patch of the vertex in the input, if any.
  int own_patch(int v) const
  { return complex_.numbering.is_on_boundary(v) ? complex_.numbering.input_patch(v) : int(Boundary_facet::no_patch); }

  // Measures the lengths of edges and the normal of the surface on the vertex's patch. Sums are rounded the same way for any order
  // of facets.
  void measure_neighborhood()
  {
    const int v = cavity_.vertex();
    const auto distance = [&](int w) { return (position(complex_.sites[w]) - position(from_)).length(); };
    mean_edge_ = 0;
    for(int w : cavity_.link())
      mean_edge_ += distance(w) / double(cavity_.link().size());
    shortest_edge_ = infinity;
    normal_ = Vector_3();
    std::vector<Exchangeable_boundary_3::Facet> around;
    for(int n : complex_.boundary.around(v))
      around.push_back(complex_.boundary.facet(n));
    std::sort(around.begin(), around.end(), [](const auto& a, const auto& b) { return a.vertices < b.vertices; });
    for(const Exchangeable_boundary_3::Facet& facet : around)
    {
      const Triple& t = facet.vertices;
      const Vector_3 origin = position(complex_.sites[t[0]]);
      const Vector_3 area = (position(complex_.sites[t[1]]) - origin).cross(position(complex_.sites[t[2]]) - origin);
      if(facet.patch == own_patch(v))
        normal_ += area.dot(normal_) < 0 ? Vector_3(-area) : area;
      for(int w : t)
        if(w != v)
          shortest_edge_ = (std::min)(shortest_edge_, distance(w));
    }
    normal_ = normal_.normalized();
  }

  // Whether a new vertex has this distance from its neighbors and is in none of their protecting balls.
  bool has_room(double least_distance) const
  {
    const int vertex = cavity_.vertex();
    const Vector_3 p = position(cavity_.site(vertex));
    const auto is_far = [&](int v)
    {
      return v < 0 || v == vertex || squared_distance(complex_.sites[v], p) > (std::max)(least_distance * least_distance, complex_.sites[v].weight);
    };
    const std::vector<Cell*>& cells = cavity_.new_cells();
    return std::all_of(cells.begin(), cells.end(), [&](const Cell* c)
                       { return std::all_of(c->vertices.begin(), c->vertices.end(), is_far); });
  }

  const Cell_lack& lack(Cell& c) const
  {
    if(!c.is_measured)
      c.lack = lack(c.vertices, cavity_.sites(c.vertices));
    c.is_measured = true;
    return c.lack;
  }

  Cell_lack lack(const Quadruple& q, const std::array<Site, 4>& s) const
  {
    Cell_lack result = goal_.lack(s);
    result.deficit += complex_.size_bound.deficit(q.data(), s);
    return result;
  }

  // The change of the sum of the deficits for the cells that have been found. The vertices of a cell nearly always tell its
  // subdomain correctly, so the domain is asked only about places that are good under this assumption.
  double change(double most)
  {
    const bool is_better = has_better_angles(most) && (are_labels_right() || has_better_angles(most));
    return is_better && (!complex_.snapshot.has_unseparating_facets || ask_all()) && exchange_.is_permitted(change_)
           ? after_.deficit - before_.deficit : infinity;
  }

  bool has_better_angles(double most)
  { return promises(most) && ask_in_doubt(most) && after_.is_not_worse_than(before_, goal_.steps()); }

  // Whether the change is less than `most`, leaving out cells whose subdomain is unknown.
  bool promises(double most)
  {
    before_ = after_ = Sliver_count();
    for(Cell* c : cavity_.old_cells())
      if(is_inside(c->label))
        before_.add(lack(*c), goal_.steps());
    for(Cell* c : cavity_.new_cells())
    {
      if(c->label == Vertex_cavity_3::unlabelled)
        find_label(*c);
      if(c->label == Editable_complex_3::mixed || !c->fits)
        return false;
      if(is_inside(c->label))
        after_.add(lack(*c), goal_.steps());
      if(!(after_.deficit - before_.deficit < most))
        return false;
    }
    return true;
  }

  // Adds the cells whose subdomain is unknown, asking the domain; whether the change is still less than `most`.
  bool ask_in_doubt(double most)
  {
    for(Cell* c : cavity_.new_cells())
    {
      if(c->label != Editable_complex_3::unknown)
        continue;
      ask(*c);
      if(is_inside(c->label))
        after_.add(lack(*c), goal_.steps());
      if(!(after_.deficit - before_.deficit < most))
        return false;
    }
    return true;
  }

  void find_label(Cell& c) const
  {
    c.label = complex_.label_of_vertices(c.vertices);
    c.is_guessed = c.label == Editable_complex_3::unknown;
    c.label = c.is_guessed ? guess(c) : c.label;
  }

  bool sees_other_label(const Cell& c) const { return !c.is_infinite() && guess(c) != c.label; }

  // Whether the labels were right; where the vertices leave doubt, the domain is asked and corrects them.
  bool are_labels_right() const
  {
    bool are_right = true;
    for(Cell* c : cavity_.new_cells())
    {
      const int label = c->label;
      if(c->is_guessed || sees_other_label(*c))
        ask(*c);
      are_right = are_right && c->label == label;
    }
    return are_right;
  }

  // The label of the dual point according to the surface at one of the vertices; the cell's label if no surface tells.
  int guess(const Cell& c) const
  {
    constexpr double margin = 0.1;
    const std::array<Site, 4> s = cavity_.sites(c.vertices);
    const Vector_3 dual = position(s[0]) + Cell_products(s[0], s[1], s[2], s[3]).to_dual();
    for(int i = 0; i < 4; ++i)
    {
      if(complex_.is_inserted(c.vertices[i]))
        continue;
      const int label = complex_.snapshot.boundary.label_toward(c.vertices[i], dual - position(s[i]), margin);
      if(label != Boundary_geometry_3::no_label)
        return label;
    }
    return c.label;
  }

  bool ask_all() const
  { return std::all_of(cavity_.new_cells().begin(), cavity_.new_cells().end(), [this](Cell* c) { return ask(*c); }); }

  // Asks the domain for the subdomain of the dual point; false if that does not fit the label.
  bool ask(Cell& c) const
  {
    if(c.is_asked || c.is_infinite())
      return c.fits;
    c.dual = exact_dual_point(cavity_.sites(c.vertices));
    int label = complex_.domain.label(c.dual);
    if(complex_.domain.has_cells_of_mesh() && (c.is_guessed ? !complex_.boundary_moves : label != c.label))
      label = complex_.domain.label(centroid(cavity_.sites(c.vertices)));
    c.fits = c.is_guessed || c.label == label;
    c.label = label;
    c.is_asked = true;
    return c.fits;
  }

  // The deficit of the star with the vertex at a site; infinite if a cell is inverted or the sum is not less than `most`.
  double deficit_of_star(const Site& to, double most) const
  {
    double sum = 0;
    for(const Cell& c : cavity_.star())
    {
      if(!is_inside(c.label))
        continue;
      std::array<Site, 4> s = cavity_.sites(c.vertices);
      s[index_of(c.vertices, cavity_.vertex())] = to;
      if(!(Cell_products(s[0], s[1], s[2], s[3]).determinant > 0))
        return infinity;
      sum += lack(c.vertices, s).deficit;
      if(!(sum < most))
        return infinity;
    }
    return sum;
  }

  Editable_complex_3& complex_;
  Vertex_cavity_3 cavity_;
  Facet_exchange_3 exchange_;
  Sliver_goal goal_;
  bool leaves_ = false;                         // whether the vertex is to be removed
  Vertex_change change_;                        // whether a vertex is inserted or removed
  Site from_ = { 0, 0, 0, 0 };
  double mean_edge_ = 0, shortest_edge_ = 0;    // of all, and on the boundary
  Vector_3 normal_;            // zero if there is no facet of the patch
  Sliver_count before_, after_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_VERTEX_TRIAL_3_H
