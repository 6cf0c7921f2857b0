// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_TRIAL_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_TRIAL_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_dual_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Point_coordinates.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Cell_knowledge.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Fidelity_check_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Numbered_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_state_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Exchangeable_boundary_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Slot.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

#ifdef TRIAL_STATS
struct Trial_stats { std::size_t lifts=0, tries=0, hidden=0, deficit=0, worse=0, labels=0, labels2=0, topology=0, unknown=0, fidelity=0, angle=0, ok=0, accepted=0; double t_lift=0,t_try=0,t_check=0,t_insert=0; };
inline Trial_stats& trial_stats() { static Trial_stats s; return s; }
#define TRIAL_COUNT(x) ++trial_stats().x
#else
#define TRIAL_COUNT(x)
#endif

// What moving one vertex of a complex does to the angles of its cells and to its boundary.
//
// The vertex is taken out of a copy of the exact triangulation, and put back where it was or
// where it is better. For each place in between, the cells around it follow from those in
// conflict with it, so that nothing need be changed for a place that is of no use.
template <class Domain>
class Restricted_trial_3
{
public:
  typedef typename Domain::Triangulation Triangulation;
  typedef Restricted_state_3<Triangulation> State;
  typedef typename State::Triple Triple;
  typedef typename State::Quadruple Quadruple;

  // `bound`, in degrees, is what dihedral angles should reach.
  Restricted_trial_3(const State& state, Domain& domain, const Fidelity_check_3<Domain>& fidelity, double bound)
    : state_(state)
    , domain_(domain)
    , fidelity_(fidelity)
    , angle_deficit_(bound)
    , sites_(state.sites)
    , boundary_(state.boundary.complex())
  {
    tr_.copy(state.triangulation(), [&state](Vertex_handle v) { return state.number(v); });
  }

  const std::vector<Site>& sites() const { return sites_; }
  const Exchangeable_boundary_3& boundary() const { return boundary_; }
  const Triangulation& triangulation() const { return tr_.triangulation(); }

  // The cells of the complex that lack something, the worst first.
  std::vector<std::pair<double, Quadruple> > slivers() const
  {
    std::vector<std::pair<double, Quadruple> > result;
    const Triangulation& tr = triangulation();
    for(auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
    {
      if(domain_.label(c->subdomain_index()) == domain_.outside())
        continue;
      const Quadruple q = numbers(c);
      const double d = deficit(q);
      if(d > 0)
        result.emplace_back(-d, sorted(q));
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  // Of a cell of the complex, or 0 if there is none with these vertices.
  double deficit_of_cell(const Quadruple& q) const
  {
    Cell_handle c;
    return is_cell(q, c) && domain_.label(c->subdomain_index()) != domain_.outside() ? deficit(q) : 0;
  }

  // The vertices opposite to the cell in its neighbors.
  std::vector<int> opposite_vertices(const Quadruple& q) const
  {
    std::vector<int> result;
    Cell_handle c;
    if(is_cell(q, c))
      for(int i = 0; i < 4; ++i)
      {
        const Vertex_handle v = triangulation().mirror_vertex(c, i);
        if(!triangulation().is_infinite(v))
          result.push_back(tr_.number(v));
      }
    return result;
  }

  // Whether the vertex may be moved: if it is one of the interior, or on surfaces.
  bool is_movable(int v) const
  {
    return state_.numbering->is_interior(v)
           || (state_.numbering->is_on_boundary(v) && sites_[v].weight == 0
               && state_.numbering->input_vertices[v]->in_dimension() == 2);
  }

  bool is_interior(int v) const { return state_.numbering->is_interior(v); }

  // Moves a site for a vertex on a surface to the surface; false if there is no such point nearby.
  bool put_on_surface(int v, Site& s) const
  {
    constexpr double farthest_projection = 1;       // over the shortest edge
    double shortest = infinity;
    const Eigen::Vector3d normal = surface_normal(v, shortest);
    Eigen::Vector3d p = position(s);
    const int patch = domain_.patch_at(state_.numbering->input_vertices[v]->index());
    if(!domain_.project(p, normal, farthest_projection * shortest, patch))
      return false;
    s = site_at(p, s.weight);
    return true;
  }

  // The direction in which the facets of the patch that the vertex is on look, and the shortest edge.
  Eigen::Vector3d surface_normal(int v, double& shortest) const
  {
    const int patch = domain_.patch_at(state_.numbering->input_vertices[v]->index());
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for(int n : boundary_.around(v))
    {
      const Triple& t = boundary_.facet(n).vertices;
      for(int w : t)
        if(w != v)
          shortest = (std::min)(shortest, (position(sites_[w]) - position(sites_[v])).norm());
      if(boundary_.facet(n).patch != patch)
        continue;
      const Eigen::Vector3d o = position(sites_[t[0]]),
                            area = (position(sites_[t[1]]) - o).cross(position(sites_[t[2]]) - o);
      normal += area.dot(normal) < 0 ? Eigen::Vector3d(-area) : area;
    }
    return normal.normalized();
  }

  double mean_edge_length(int v) const
  {
    std::vector<Vertex_handle> neighbors;
    triangulation().finite_adjacent_vertices(tr_.vertex(v), std::back_inserter(neighbors));
    double sum = 0;
    for(Vertex_handle w : neighbors)
      sum += std::sqrt(squared_distance(sites_[v], position(sites_[tr_.number(w)])));
    return sum / double(neighbors.size());
  }

  // Takes the vertex out, until accept() or put_back().
  void lift(int v)
  {
    TRIAL_COUNT(lifts);
    CGAL_assertion(lifted_ < 0);
    lifted_ = v;
    from_ = sites_[v];
    std::vector<Cell_handle> star;
    triangulation().incident_cells(tr_.vertex(v), std::back_inserter(star));
    std::vector<std::pair<Cell_handle, int> > around;
    star_.clear();
    for(Cell_handle c : star)
    {
      star_.push_back(Cell{ numbers(c), domain_.label(c->subdomain_index()) });
      around.push_back(triangulation().mirror_facet({ c, c->index(tr_.vertex(v)) }));
    }
    tr_.remove(v);
    fill_hole(around);
  }

  void put_back()
  {
    sites_[lifted_] = from_;
    insert(hole_.front().handle, star_);
  }

  // The change of the sum of the deficits if the vertex goes there, or infinity if it may not or
  // the change would not be less than `most`.
  double move(const Site& s, double most)
  {
    TRIAL_COUNT(tries);
    sites_[lifted_] = s;
    if(!find_conflicts())
    {
      TRIAL_COUNT(hidden);
      return infinity;
    }
    collect_cells();
    double change = change_of_deficit();
    if(!(change < most))
    {
      TRIAL_COUNT(deficit);
      return infinity;
    }
    if(!label_cells())
    {
      TRIAL_COUNT(labels);
      return infinity;
    }
    change = change_of_deficit();
    if(!(change < most) || !(worst_after_ <= worst_before_))
    {
      TRIAL_COUNT(worse);
      return infinity;
    }
    if(!is_boundary_fine())
      return infinity;
    TRIAL_COUNT(ok);
    return change;
  }

  double deficit_after() const { return after_; }

  // Goes to where it has been tried last.
  void accept()
  {
    TRIAL_COUNT(accepted);
    const Cell_handle start = conflicts_.front();
    std::vector<Cell> cells = new_cells_;
    for(const Hole_cell& h : hole_)
      if(h.label != unknown)
        h.handle->set_subdomain_index(domain_.subdomain(h.label));
    boundary_.exchange(removed_, added_);
    insert(start, cells);
  }

  // The cells around the vertex that is moved that lack something.
  std::vector<Quadruple> slivers_after() const
  {
    std::vector<Quadruple> result;
    for(const Cell& c : new_cells_)
      if(deficit_in_complex(c) > 0)
        result.push_back(sorted(c.vertices));
    return result;
  }

  // Hands over the triangulation to a candidate with the sites, and the boundary facets.
  template <class Candidate>
  void give(Candidate& candidate)
  {
    Triangulation& tr = tr_.triangulation();
    for(auto h = tr.all_cells_begin(); h != tr.all_cells_end(); ++h)
    {
      const Cell_handle c = h;
      forget(c);
      const Quadruple q = numbers(c);
      note(c, IS_SETTLED);
      if(std::all_of(q.begin(), q.end(), [this](int v) { return v >= 0 && state_.numbering->is_on_boundary(v); }))
      {
        note(c, IS_BOUNDARY_CELL);
        candidate.boundary_cells.emplace_back(c, domain_.label(c->subdomain_index()));
      }
    }
    std::vector<Boundary_facet> found;
    for(auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f)
    {
      const std::array<int, 3>& k = facet_indices(f->second);
      Boundary_facet b;
      for(std::size_t i = 0; i < 3; ++i)
        b.vertices[i] = tr_.number(f->first->vertex(k[i]));
      const int n = boundary_.find(sorted(b.vertices));
      if(n < 0)
        continue;
      b.labels = {{ domain_.label(f->first->subdomain_index()),
                    domain_.label(f->first->neighbor(f->second)->subdomain_index()) }};
      b.patch = boundary_.facet(n).patch;
      found.push_back(b);
      candidate.facets.push_back(*f);
      candidate.old_facets.push_back(state_.facet_number(b.vertices));
    }
    candidate.boundary_complex = std::make_shared<const Boundary_complex_3>(std::move(found), sites_.size());
    candidate.numbered->swap(tr_);
  }

private:
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Cell_handle Cell_handle;
  typedef typename Triangulation::Facet Facet;
  typedef typename Triangulation::Bare_point Bare_point;
  typedef typename Triangulation::Weighted_point Weighted_point;
  typedef Exchangeable_boundary_3::Facet Boundary_facet_;

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr int unknown = -2, no_subdomain = State::no_subdomain;
  static constexpr double small_facet_angle = 30;

  struct Cell
  {
    Quadruple vertices;             // -1 for the infinite one
    int label;
    Eigen::Vector3d dual = Eigen::Vector3d::Zero();     // of a new cell at the boundary
  };

  struct Hole_cell
  {
    Cell_handle handle;
    Quadruple vertices;
    int label;
  };

  Quadruple numbers(Cell_handle c) const
  {
    Quadruple q;
    for(int i = 0; i < 4; ++i)
      q[i] = triangulation().is_infinite(c->vertex(i)) ? -1 : tr_.number(c->vertex(i));
    return q;
  }

  bool is_cell(const Quadruple& q, Cell_handle& c) const
  {
    return triangulation().is_cell(tr_.vertex(q[0]), tr_.vertex(q[1]), tr_.vertex(q[2]), tr_.vertex(q[3]), c);
  }

  double deficit(const Quadruple& q) const { return angle_deficit_(sites_[q[0]], sites_[q[1]], sites_[q[2]], sites_[q[3]]); }

  double deficit_in_complex(const Cell& c) const
  {
    return c.label == domain_.outside() || c.label == unknown ? 0 : deficit(c.vertices);
  }

  Weighted_point point(int v) const
  {
    const Site& s = sites_[v];
    if(same_place(s, state_.sites[v]))
      return state_.triangulation().point(state_.vertex(v));
    return triangulation().geom_traits().construct_weighted_point_3_object()(Bare_point(s.x, s.y, s.z));
  }

  // The cells that have come where the vertex was.
  void fill_hole(const std::vector<std::pair<Cell_handle, int> >& around)
  {
    hole_.clear();
    const auto add = [this](Cell_handle c)
    {
      if(c->is_facet_visited(0))
        return;
      c->set_facet_visited(0);
      const Quadruple q = numbers(c);
      hole_.push_back({ c, q, label_without_domain(q) });
    };
    std::set<std::pair<Cell_handle, int> > walls;
    for(const auto& f : around)
    {
      const Facet inside = triangulation().mirror_facet(Facet(f.first, f.second));
      walls.insert({ inside.first, inside.second });
    }
    for(const auto& f : around)
      add(f.first->neighbor(f.second));
    for(std::size_t n = 0; n < hole_.size(); ++n)
      for(int i = 0; i < 4; ++i)
        if(walls.count({ hole_[n].handle, i }) == 0)
          add(hole_[n].handle->neighbor(i));
  }

  // Or unknown.
  int label_without_domain(const Quadruple& q) const
  {
    int label = unknown;
    for(int v : q)
    {
      if(v < 0)
        return domain_.outside();
      const int l = state_.numbering->subdomain[v];
      if(l != no_subdomain && label != unknown && label != l)
        return mixed;
      if(l != no_subdomain)
        label = l;
    }
    return label;
  }
  static constexpr int mixed = -3;

  void insert(Cell_handle near, const std::vector<Cell>& cells)
  {
    const int v = lifted_;
    for(const Hole_cell& h : hole_)
      h.handle->reset_visited(0);
    lifted_ = -1;
    tr_.insert_near(v, point(v), near);
    CGAL_assertion(tr_.is_visible(v));
    std::vector<Cell_handle> star;
    triangulation().incident_cells(tr_.vertex(v), std::back_inserter(star));
    std::vector<std::pair<Quadruple, int> > labels;
    for(const Cell& c : cells)
      labels.emplace_back(sorted(c.vertices), c.label);
    std::sort(labels.begin(), labels.end());
    for(Cell_handle c : star)
    {
      const Quadruple q = sorted(numbers(c));
      const auto l = std::lower_bound(labels.begin(), labels.end(), std::make_pair(q, -10));
      CGAL_assertion(l != labels.end() && l->first == q);
      if(l == labels.end() || l->first != q) { std::cerr << "LOST" << std::endl; continue; }
      c->set_subdomain_index(domain_.subdomain(l->second));
    }
  }

  // False if the vertex would be hidden, or hide another.
  bool find_conflicts()
  {
    conflicts_.clear();
    walls_.clear();
    const Weighted_point p = point(lifted_);
    const Cell_handle start = triangulation().locate(p, hole_.front().handle);
    triangulation().find_conflicts(p, start, std::back_inserter(walls_), std::back_inserter(conflicts_));
    if(conflicts_.empty())
      return false;
    std::vector<Vertex_handle> on_wall, in_conflict;
    for(const Facet& f : walls_)
      for(int i = 1; i < 4; ++i)
        on_wall.push_back(f.first->vertex((f.second + i) % 4));
    for(Cell_handle c : conflicts_)
      for(int i = 0; i < 4; ++i)
        in_conflict.push_back(c->vertex(i));
    for(auto* vertices : { &on_wall, &in_conflict })
    {
      std::sort(vertices->begin(), vertices->end());
      vertices->erase(std::unique(vertices->begin(), vertices->end()), vertices->end());
    }
    return on_wall == in_conflict;
  }

  // Those that would go and come.
  void collect_cells()
  {
    for(Cell_handle c : conflicts_)
      c->set_facet_visited(1);
    old_cells_ = star_;
    for(Cell_handle c : conflicts_)
      if(!c->is_facet_visited(0))
        old_cells_.push_back(Cell{ numbers(c), domain_.label(c->subdomain_index()) });
    new_cells_.clear();
    new_hole_.clear();
    for(const Hole_cell& h : hole_)
      if(!h.handle->is_facet_visited(1))
        {
        new_cells_.push_back(Cell{ h.vertices, h.label });
        new_hole_.push_back(h.handle);
      }
    for(Cell_handle c : conflicts_)
      c->reset_visited(1);
    for(const Facet& f : walls_)
    {
      Quadruple q = numbers(f.first);
      q[f.second] = lifted_;
      new_cells_.push_back(Cell{ q, label_without_domain(q) });
    }
  }

  double change_of_deficit()
  {
    const Site to = sites_[lifted_];
    double before = 0;
    worst_before_ = worst_after_ = after_ = 0;
    sites_[lifted_] = from_;
    for(const Cell& c : old_cells_)
    {
      const double d = deficit_in_complex(c);
      before += d;
      worst_before_ = (std::max)(worst_before_, d);
    }
    sites_[lifted_] = to;
    for(const Cell& c : new_cells_)
    {
      const double d = c.label == mixed ? infinity : deficit_in_complex(c);
      after_ += d;
      worst_after_ = (std::max)(worst_after_, d);
    }
    return after_ - before;
  }

  bool label_cells()
  {
    for(Cell& c : new_cells_)
    {
      if(c.label == domain_.outside() && *std::min_element(c.vertices.begin(), c.vertices.end()) < 0)
        continue;
      const bool touches_boundary = std::any_of(c.vertices.begin(), c.vertices.end(),
                                                [this](int v) { return state_.numbering->is_on_boundary(v); });
      if(!touches_boundary)
        continue;
      const Quadruple& q = c.vertices;
      const Bare_point dual = triangulation().geom_traits().construct_weighted_circumcenter_3_object()(
        point(q[0]), point(q[1]), point(q[2]), point(q[3]));
      const int label = domain_.label_at(dual);
      c.dual = coordinates(dual);
      if(c.label != unknown && label != c.label)
        return false;
      c.label = label;
    }
    for(std::size_t n = 0, m = 0; n < new_hole_.size(); ++n, ++m)
    {
      while(hole_[m].handle != new_hole_[n])
        ++m;
      hole_[m].label = new_cells_[n].label;
    }
    return true;
  }

  // A facet of one of some cells.
  struct Side
  {
    Triple facet;
    int cell, index;
    bool operator<(const Side& o) const { return facet != o.facet ? facet < o.facet : cell < o.cell; }
  };

  static std::vector<Side> sides(const std::vector<Cell>& cells)
  {
    std::vector<Side> result;
    for(int n = 0; n < static_cast<int>(cells.size()); ++n)
      for(int i = 0; i < 4; ++i)
      {
        const Quadruple& q = cells[n].vertices;
        const Triple t = sorted(Triple{{ q[(i + 1) % 4], q[(i + 2) % 4], q[(i + 3) % 4] }});
        if(t[0] >= 0)
          result.push_back({ t, n, i });
      }
    std::sort(result.begin(), result.end());
    return result;
  }

  // The cell beyond a facet of a new cell that is not one of them.
  Cell_handle beyond(const Side& s) const
  {
    const std::size_t n = s.cell;
    if(n < new_hole_.size())
      return new_hole_[n]->neighbor(s.index);
    const Facet& f = walls_[n - new_hole_.size()];
    return f.first->neighbor(f.second);
  }

  // Whether the dual segment of a facet crosses a surface, where such facets need not separate subdomains.
  bool crosses_surface(const Triple& t, const Eigen::Vector3d& from, const Eigen::Vector3d& to)
  {
    if(std::none_of(t.begin(), t.end(), [this](int v) { return state_.numbering->is_on_boundary(v); }))
      return false;
    const double length = (to - from).norm();
    if(!(length > 0))
      return false;
    Eigen::Vector3d p = (from + to) / 2;
    typename State::Index index;
    return domain_.intersect(p, (to - from) / length, length / 2, index);
  }

  // Of new cells, or the cell beyond. Cells without a vertex on the boundary have none, nor need they.
  bool crosses_surface(const Side& s, const Side* other)
  {
    const Eigen::Vector3d from = new_cells_[s.cell].dual;
    if(other != nullptr)
      return crosses_surface(s.facet, from, new_cells_[other->cell].dual);
    const Cell_handle c = beyond(s);
    return !triangulation().is_infinite(c) && crosses_surface(s.facet, from, coordinates(triangulation().dual(c)));
  }

  // Whether the facets of the boundary would keep the topology, be close to the surface and not be flat.
  bool is_boundary_fine()
  {
    removed_.clear();
    added_.clear();
    moved_.clear();
    if(!exchange_facets())
    {
      TRIAL_COUNT(unknown);
      return false;
    }
    if(!boundary_.keeps_topology(removed_, added_))
    {
      TRIAL_COUNT(topology);
      return false;
    }
    double least = small_facet_angle;
    const Site to = sites_[lifted_];
    sites_[lifted_] = from_;
    for(int n : removed_)
      least = (std::min)(least, smallest_angle(boundary_.facet(n).vertices));
    for(const Triple& t : moved_)
      least = (std::min)(least, smallest_angle(t));
    sites_[lifted_] = to;
    for(const Boundary_facet_& f : added_)
      moved_.push_back(f.vertices);
    for(const Triple& t : moved_)
      if(smallest_angle(t) < least)
      {
        TRIAL_COUNT(angle);
        return false;
      }
    for(const Triple& t : moved_)
      if(!fidelity_.is_close(centroid(t, sites_)))
      {
        TRIAL_COUNT(fidelity);
        return false;
      }
    return true;
  }

  double smallest_angle(const Triple& t) const
  {
    double least = 180;
    for(int k = 0; k < 3; ++k)
    {
      const Eigen::Vector3d o = position(sites_[t[k]]), a = position(sites_[t[(k + 1) % 3]]) - o,
                            b = position(sites_[t[(k + 2) % 3]]) - o;
      least = (std::min)(least, std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / CGAL_PI);
    }
    return least;
  }

  // Finds the boundary facets that would go, come and stay at the vertex; false if one has no patch.
  bool exchange_facets()
  {
    const std::vector<Side> before = sides(old_cells_), after = sides(new_cells_);
    std::vector<std::pair<Triple, int> > beyond;    // the labels beyond the region
    for(std::size_t n = 0; n < before.size(); ++n)
    {
      const Triple& t = before[n].facet;
      const int old = boundary_.find(t), label = old_cells_[before[n].cell].label;
      if(old >= 0)
        removed_.push_back(old);
      if(n + 1 < before.size() && before[n + 1].facet == t)
        ++n;
      else if(old < 0)
        beyond.emplace_back(t, label);
      else
      {
        const std::array<int, 2>& l = boundary_.facet(old).labels;
        beyond.emplace_back(t, l[0] == label ? l[1] : l[0]);
      }
    }
    auto wall = beyond.begin();
    for(std::size_t n = 0; n < after.size(); ++n)
    {
      const Side& s = after[n];
      const Side* other = n + 1 < after.size() && after[n + 1].facet == s.facet ? &after[++n] : nullptr;
      if(other == nullptr && (wall == beyond.end() || wall->first != s.facet))
        return false;
      const std::array<int, 2> labels = {{ new_cells_[s.cell].label,
                                           other != nullptr ? new_cells_[other->cell].label : (wall++)->second }};
      if((labels[0] != labels[1] || (state_.has_unseparating_facets && crosses_surface(s, other)))
         && !add_facet(s.facet, sorted(labels)))
        return false;
    }
    return true;
  }

  // Takes it for one that stays, or else for one that comes; false if it has no patch.
  bool add_facet(const Triple& t, const std::array<int, 2>& labels)
  {
    const auto old = std::find_if(removed_.begin(), removed_.end(), [&](int f) { return boundary_.facet(f).vertices == t; });
    if(old != removed_.end() && boundary_.facet(*old).labels == labels)
    {
      if(std::find(t.begin(), t.end(), lifted_) != t.end())
        moved_.push_back(t);
      removed_.erase(old);
      return true;
    }
    const int patch = patch_of_new_facet(t, labels);
    if(patch != unknown)
      added_.push_back({ t, labels, patch });
    return patch != unknown;
  }

  // The patch on which all vertices agree.
  int patch_of_new_facet(const Triple& t, const std::array<int, 2>& labels)
  {
    std::set<int> common;
    for(std::size_t k = 0; k < 3; ++k)
    {
      std::set<int> here;
      for(int n : boundary_.around(t[k]))
      {
        const Boundary_facet_& f = boundary_.facet(n);
        if(f.labels == labels && f.patch != Boundary_facet::no_patch && (k == 0 || common.count(f.patch) > 0))
          here.insert(f.patch);
      }
      common.swap(here);
    }
    if(common.size() <= 1)
      return common.empty() ? int(unknown) : *common.begin();
    const Facet_dual_3 dual(t, sites_);
    Eigen::Vector3d p = dual.center;
    typename State::Index index;
    if(!domain_.intersect(p, dual.normal, dual.radius, index))
      return unknown;
    const int patch = domain_.patch_at(index);
    return common.count(patch) > 0 ? patch : int(unknown);
  }

  const State& state_;
  Domain& domain_;
  const Fidelity_check_3<Domain>& fidelity_;
  Angle_deficit_3 angle_deficit_;
  Numbered_triangulation_3<Triangulation> tr_;
  std::vector<Site> sites_;
  Exchangeable_boundary_3 boundary_;
  int lifted_ = -1;
  Site from_ = { 0, 0, 0, 0 };
  std::vector<Cell> star_;                  // of the vertex before it is lifted
  std::vector<Hole_cell> hole_;             // the cells in its place
  std::vector<Cell_handle> conflicts_;
  std::vector<Facet> walls_;
  std::vector<Cell> old_cells_, new_cells_; // the first of these are of the hole
  std::vector<Cell_handle> new_hole_;
  double worst_before_ = 0, worst_after_ = 0, after_ = 0;
  std::vector<int> removed_;
  std::vector<Boundary_facet_> added_;
  std::vector<Triple> moved_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_TRIAL_3_H
