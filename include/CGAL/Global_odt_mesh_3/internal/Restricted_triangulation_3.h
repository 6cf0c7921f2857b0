// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_TRIANGULATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_TRIANGULATION_3_H

#include <CGAL/Global_odt_mesh_3/internal/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Cell_shape_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Domain_oracle_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Facet_dual_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Flat_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Index_table.h>
#include <CGAL/Global_odt_mesh_3/internal/Numbered_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Odt_energy_3.h>

#include <CGAL/number_utils.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// A complex as the restriction of CGAL's exact regular triangulation to the
// domain, and the way from one state of it to the next.
//
// A vertex that no boundary facet touches belongs to one subdomain for good, and
// so do the cells around it. A cell with all vertices on the boundary is labelled
// by the side on which its dual point lies, as seen from its vertices where these
// agree and see it clearly, and else as the domain says.
//
// update() builds the triangulation of new positions, labels it, and compares
// with the state before. Vertices that alter the topology of the boundary, pierce
// it, get hidden, or leave a cell of their subdomain with its dual point in
// another, go back toward where they were, until all is well.
template <class Triangulation, class Mesh_domain>
class Restricted_triangulation_3
{
public:
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Cell_handle Cell_handle;
  typedef typename Triangulation::Facet Facet;
  typedef typename Triangulation::Weighted_point Weighted_point;
  typedef typename Triangulation::Bare_point Bare_point;
  typedef typename Triangulation::Vertex::Index Index;
  typedef typename Mesh_domain::Subdomain_index Subdomain_index;
  typedef typename Mesh_domain::Surface_patch_index Surface_patch_index;
  typedef std::array<double, 3> Vector;

  // What belongs to a boundary facet beside vertices, labels and patch.
  struct Surface_center
  {
    Vector point;
    Bare_point stored;              // what the complex is told
    Index index;
    bool is_exact;                  // on the surface; or else estimated from the normals
  };

  // On what evidence the dual point of a cell is believed to be on one side of the boundary:
  // as the normals tell unless it is close to tangential, unless it is not far from tangential
  // or they were wrong nearby, or never without asking the domain.
  enum Evidence { SOME_EVIDENCE, GOOD_EVIDENCE, ORACLE };

  // How update() is done.
  struct Update
  {
    bool boundary_moves;            // or else all boundary facets stay
    bool projects;                  // moved surface vertices to the surface
    Evidence evidence;
    bool finds_centers;             // of boundary facets; or else these are estimated
  };

  struct Statistics
  {
    std::size_t updates = 0, refused_updates = 0, attempts = 0, sent_back = 0, pushed = 0, peeled = 0;
  };

  // The state, indexed by the numbers of vertices and of boundary facets.
  const Triangulation* triangulation;
  std::vector<Vertex_handle> vertices;
  std::vector<Site> sites;
  std::vector<int> subdomain;               // of a vertex without boundary facets, or no_subdomain
  Boundary_complex_3 boundary;
  std::vector<Facet> facets;                // of the triangulation, on side 0
  std::vector<Surface_center> centers;
  Index_table<Subdomain_index> labels;
  Index_table<Surface_patch_index> patches;
  double farthest_centroid = 0;             // of a facet from the surface, in the input
  int number_of_interior_vertices = 0;      // these come first, followed by
  int number_of_movable_vertices = 0;       // those that move on the surface

  static constexpr int no_subdomain = -1;

  explicit Restricted_triangulation_3(const Mesh_domain& domain)
    : oracle_(domain)
    , outside_(labels.number(Subdomain_index()))
  {}

  // Whether the state is another than the one that was read.
  bool has_changed() const { return triangulation == &current_.triangulation(); }
  Triangulation& own_triangulation() { return current_.triangulation(); }

  const Oracle_statistics& oracle_statistics() const { return oracle_.statistics(); }
  const Statistics& statistics() const { return statistics_; }
  int outside() const { return outside_; }

  // Whether the surface is rough compared with the mesh, as that of an image is: at many
  // of some vertices, going a bit along the tangential plane leads off the surface.
  bool is_rough()
  {
    const int n = number_of_movable_vertices - number_of_interior_vertices;
    const int stride = 1 + n / 200;
    int probed = 0, off = 0;
    for(int v = number_of_interior_vertices; v < number_of_movable_vertices; v += stride, ++probed)
    {
      const Boundary_fan& fan = boundary.fan(v, 0);
      const double step = 0.2 * fan.shortest_edge, tolerance = 0.05 * fan.shortest_edge;
      const double along = fan.toward[0] * fan.normal[0] + fan.toward[1] * fan.normal[1] + fan.toward[2] * fan.normal[2];
      Vector t;
      for(int i = 0; i < 3; ++i)
        t[i] = fan.toward[i] - along * fan.normal[i];
      const double length = std::sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
      const double f = length > 0 ? step / length : 0;
      const Vector from = {{ sites[v].x + f * t[0], sites[v].y + f * t[1], sites[v].z + f * t[2] }};
      Vector p = from;
      const bool found = oracle_.project(p, fan.normal, 4 * tolerance, patches.value(fan.patch));
      const double dx = p[0] - from[0], dy = p[1] - from[1], dz = p[2] - from[2];
      off += !found || dx * dx + dy * dy + dz * dz > tolerance * tolerance;
    }
    return off > 0.1 * probed;
  }

  // Goes to new positions of the movable vertices, as far as possible. False if
  // nothing could be done; the state is as before then, and if anything throws.
  bool update(const std::vector<Site>& target, const Update& mode)
  {
    ++statistics_.updates;
    mode_ = mode;
    next_sites_ = target;
    if(on_surface_.empty())
    {
      on_surface_.resize(number_of_movable_vertices, true);
      last_on_surface_.assign(sites.begin(), sites.begin() + number_of_movable_vertices);
    }
    next_on_surface_ = on_surface_;
    drift_.resize(number_of_movable_vertices, 0);
    next_drift_ = drift_;
    is_settled_.assign(number_of_movable_vertices, false);
    for(int v = number_of_interior_vertices; v < number_of_movable_vertices; ++v)
      next_on_surface_[v] = on_surface_[v] && is_home(v);
    strikes_.assign(number_of_movable_vertices, 0);
    doubted_.assign(sites.size(), false);
    has_doubts_ = false;
    number_of_pushes_.clear();
    found_centers_.clear();
    found_distances_.clear();
    measured_ = boundary;
    if(mode.boundary_moves)
      measured_.measure_fans(next_sites_);
    if(mode.boundary_moves)
      project_all();
    build();
    for(int attempt = 0; attempt < most_attempts; ++attempt)
    {
      ++statistics_.attempts;
      offenders_.clear();
      pushes_.clear();
      is_hopeless_ = false;
      check();
      if(is_fine())
      {
        accept();
        return true;
      }
      if(is_hopeless_ || !send_back(attempt))
        break;
    }
    ++statistics_.refused_updates;
    return false;
  }

  // The signed height of the surface over the plane of a boundary facet, where the
  // dual line crosses both, positive toward side 1.
  double height(const std::array<int, 3>& facet) const
  {
    return Facet_dual_3(facet, sites).height(centers[facet_number_.at(Boundary_complex_3::sorted(facet))].point);
  }

  // The largest distance of a facet's centroid from the surface.
  void measure_fidelity()
  {
    if(!Has_aabb_tree<Mesh_domain>::value)
      return;
    for(const Boundary_facet& f : boundary.facets())
      farthest_centroid = (std::max)(farthest_centroid, oracle_.distance_to_surface(centroid(f.vertices, sites)));
  }

  void add_boundary_cell(const std::array<int, 4>& cell, int label) { boundary_cells_.emplace(sorted(cell), label); }

  // A complex that was not made by the mesher may lack surface centers; then a
  // point of the dual line stands in, without being told to anybody.
  void mend_surface_centers()
  {
    number_facets();
    for(std::size_t n = 0; n < centers.size(); ++n)
    {
      const Triple& t = boundary.facets()[n].vertices;
      std::array<double, 3> power;
      for(int k = 0; k < 3; ++k)
        power[k] = squared_distance(sites[t[k]], centers[n].point) - sites[t[k]].weight;
      const double spread = *std::max_element(power.begin(), power.end()) - *std::min_element(power.begin(), power.end());
      if(!(spread <= 1e-4 * std::abs(power[0])))
        centers[n].point = estimated_surface_center(t, boundary, sites);
    }
  }

private:
  typedef std::array<int, 3> Triple;
  typedef std::array<int, 4> Quadruple;

  struct Hash
  {
    template <class Array>
    std::size_t operator()(const Array& t) const { return boost::hash_range(t.begin(), t.end()); }
  };

  static constexpr int unknown_patch = -2;
  static constexpr double farthest_projection = 1;            // over the shortest edge
  static constexpr double farthest_drift = 0.02;           // over an edge
  static constexpr double step_from_boundary = 0.05;          // over an edge on the boundary
  static constexpr double good_margin = 0.3, some_margin = 0.05;
  static constexpr double sliver_angle = 20, flat_angle = 35;
  static constexpr int most_pushes = 3;
  static constexpr int most_attempts = 40;
  static constexpr int patient_attempts = 10;

  // ---- positions

  bool is_home(int v) const
  {
    const Site& a = next_sites_[v];
    const Site& b = sites[v];
    return a.x == b.x && a.y == b.y && a.z == b.z;
  }

  Weighted_point point(int v) const
  {
    if(v >= number_of_movable_vertices)
      return triangulation->point(vertices[v]);
    const Site& s = next_sites_[v];
    return triangulation->geom_traits().construct_weighted_point_3_object()(Bare_point(s.x, s.y, s.z));
  }

  void build()
  {
    std::vector<Weighted_point> points;
    points.reserve(next_sites_.size());
    for(std::size_t v = 0; v < next_sites_.size(); ++v)
      points.push_back(point(static_cast<int>(v)));
    next_.build(points, next_sites_);
  }

  bool is_on_boundary(int v) const { return subdomain[v] == no_subdomain; }

  bool project(int v, Site& s)
  {
    const Boundary_fan& fan = measured_.fan(v, 0);
    Vector p = {{ s.x, s.y, s.z }};
    if(!oracle_.project(p, fan.normal, farthest_projection * fan.shortest_edge, patches.value(fan.patch)))
      return false;
    s = { p[0], p[1], p[2], s.weight };
    return true;
  }

  // Projects the surface vertices that are not on the surface, or those only that may have
  // got too far from it. One for which that fails stays, or goes back to where it was last on it.
  void project_all()
  {
    for(int v = number_of_interior_vertices; v < number_of_movable_vertices; ++v)
    {
      const bool stays = is_home(v);
      if(stays && on_surface_[v])
        continue;
      next_drift_[v] = drift_[v] + drift(v);
      if(!mode_.projects && next_drift_[v] < farthest_drift)
        continue;
      next_drift_[v] = 0;
      next_on_surface_[v] = project(v, next_sites_[v]);
      if(!next_on_surface_[v])
      {
        // Where it was last on the surface is better than off it.
        next_sites_[v] = on_surface_[v] || !(mode_.evidence != SOME_EVIDENCE) ? sites[v] : last_on_surface_[v];
        next_on_surface_[v] = on_surface_[v] || (mode_.evidence != SOME_EVIDENCE);
      }
      if(stays && next_on_surface_[v] && (mode_.evidence != SOME_EVIDENCE))
        settle_home(v);
    }
  }

  // How far a way along the tangential plane leads off the surface, over the shortest edge,
  // for the curvature that the facets around show.
  double drift(int v) const
  {
    const Boundary_fan& fan = boundary.fan(v, 0);
    const double way = squared_distance(next_sites_[v], {{ sites[v].x, sites[v].y, sites[v].z }});
    return fan.bend * way / (fan.shortest_edge * fan.shortest_edge);
  }

  // What was a tangential plane away from the surface is home on it from now on.
  void settle_home(int v)
  {
    sites[v] = next_sites_[v];
    on_surface_[v] = true;
    is_settled_[v] = true;
  }

  // Whether a boundary facet is where it was.
  bool is_unchanged(const std::array<int, 3>& t) const
  {
    return std::all_of(t.begin(), t.end(), [this](int v)
    { return is_home(v) && (v >= number_of_movable_vertices || !is_settled_[v]); });
  }

  // ---- what is wrong with the next state

  void check()
  {
    if(!next_.is_complete())
    {
      for(std::size_t v = 0; v < next_.number_of_vertices(); ++v)
        if(!next_.is_visible(static_cast<int>(v)))
          blame({ static_cast<int>(v) });
      if(offenders_.empty())
        is_hopeless_ = true;
      return;
    }
    do
    {
      offenders_.clear();
      pushes_.clear();
      is_hopeless_ = false;
      has_new_doubts_ = false;
      label_cells();
    }
    while(has_new_doubts_);
    if(!is_fine())
      return;
    find_candidates();
    find_boundary();
    if(mode_.boundary_moves)
      blame_changes(changes());
    else
      check_facets_stay();
    if(!is_fine())
      return;
    if(mode_.boundary_moves)
      peel();
    find_surface_centers();
    if(mode_.boundary_moves && is_fine())
      check_fidelity();
  }

  bool is_fine() const { return offenders_.empty() && pushes_.empty() && !is_hopeless_; }

  // The vertices at which the next boundary is not what it has to be.
  std::set<int> changes() const
  {
    std::set<int> result = boundary.difference(next_boundary_);
    for(const Boundary_facet& f : next_boundary_.facets())
      if(f.patch == unknown_patch)
        result.insert(f.vertices.begin(), f.vertices.end());
    return result;
  }

  // Where the topology has changed, the vertices of the facets that have come or gone
  // are to blame.
  void blame_changes(const std::set<int>& changed)
  {
    if(changed.empty())
      return;
    std::map<int, std::vector<int> > around;
    for(const Triple& t : boundary.other_facets(next_boundary_))
      for(int v : t)
        if(changed.count(v) > 0)
          around[v].insert(around[v].end(), t.begin(), t.end());
    for(int v : changed)
    {
      around[v].push_back(v);
      blame(around[v]);
    }
  }

  // Boundary facets that are missing have a vertex in their surface Delaunay ball.
  void check_facets_stay()
  {
    std::vector<char> is_found(boundary.facets().size(), false);
    for(std::size_t n = 0; n < old_of_next_.size(); ++n)
      if(old_of_next_[n] >= 0)
        is_found[old_of_next_[n]] = true;
      else
        blame(next_boundary_.facets()[n].vertices);
    for(std::size_t n = 0; n < is_found.size(); ++n)
    {
      if(is_found[n])
        continue;
      const Triple& t = boundary.facets()[n].vertices;
      const double radius = squared_distance(sites[t[0]], centers[n].point) - sites[t[0]].weight;
      std::set<int> region(t.begin(), t.end());
      for(int ring = 0; ring < 2; ++ring)
        next_.grow(region);
      std::vector<int> intruders;
      for(int v : region)
        if(v < number_of_movable_vertices && squared_distance(next_sites_[v], centers[n].point) < radius)
          intruders.push_back(v);
      if(intruders.empty())
        intruders.assign(t.begin(), t.end());
      blame(intruders);
    }
  }

  // What is known of a cell as long as its vertices stay, in the bits that CGAL's optimizers
  // use for facets: the cells that a vertex leaves behind are gone when it moves.
  enum Knowledge { IS_SETTLED, IS_FROM_ORACLE, IS_BOUNDARY_CELL };

  static bool knows(Cell_handle c, Knowledge k) { return c->is_facet_visited(k); }
  static void note(Cell_handle c, Knowledge k) { c->set_facet_visited(k); }

  static void forget(Cell_handle c)
  {
    for(int k = IS_SETTLED; k <= IS_BOUNDARY_CELL; ++k)
      c->reset_visited(k);
  }

  void label_cells()
  {
    Triangulation& tr = next_.triangulation();
    next_boundary_cells_.clear();
    for(auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
    {
      if(!is_settled(c))
      {
        forget(c);
        label_cell(c);
      }
      if(knows(c, IS_BOUNDARY_CELL))
        next_boundary_cells_.emplace_back(c, labels.number(c->subdomain_index()));
    }
  }

  bool is_settled(Cell_handle c) const
  {
    if(!knows(c, IS_SETTLED) || !has_doubts_ || knows(c, IS_FROM_ORACLE) || next_.triangulation().is_infinite(c))
      return knows(c, IS_SETTLED);
    const Quadruple q = numbers(c);
    return std::none_of(q.begin(), q.end(), [this](int v) { return doubted_[v]; });
  }

  void label_cell(Cell_handle c)
  {
    const Triangulation& tr = next_.triangulation();
    Quadruple q;
    int label = no_subdomain;
    for(int i = 0; i < 4; ++i)
    {
      q[i] = tr.is_infinite(c->vertex(i)) ? -1 : next_.number(c->vertex(i));
      const int l = q[i] < 0 ? outside_ : subdomain[q[i]];
      if(l == no_subdomain || l == label)
        continue;
      if(label != no_subdomain)
      {
        blame(q);
        return;
      }
      label = l;
    }
    if(tr.is_infinite(c))
      label = outside_;
    else if(label == no_subdomain)
    {
      label = label_of_boundary_cell(c, q);
      note(c, IS_BOUNDARY_CELL);
    }
    else if(std::any_of(q.begin(), q.end(), [this](int v) { return is_on_boundary(v); })
            && dual_label(c, q) != label && !is_excused(q))
    {
      mend_cell(q, label);
      c->set_subdomain_index(labels.value(label));
      return;
    }
    c->set_subdomain_index(labels.value(label));
    note(c, IS_SETTLED);
  }

  // Whether the cell is one of the input, which may be as it likes.
  bool is_excused(const Quadruple& q)
  {
    if(!std::all_of(q.begin(), q.end(), [this](int v) { return is_home(v); }))
      return false;
    if(has_changed())
      return excused_.count(sorted(q)) > 0;
    Cell_handle c;
    if(!triangulation->is_cell(vertices[q[0]], vertices[q[1]], vertices[q[2]], vertices[q[3]], c))
      return false;
    excused_.insert(sorted(q));
    return true;
  }

  // The dual point of a cell is beyond the surface: its vertices have come too close
  // to the boundary, or else its vertex of the interior is to move away from it.
  void mend_cell(const Quadruple& q, int label)
  {
    const auto has_moved = [this](int v) { return v < number_of_movable_vertices && !is_home(v) && strikes_[v] < 2; };
    const auto v = std::find_if(q.begin(), q.end(), [this](int w) { return w < number_of_interior_vertices; });
    const bool may_go_back = std::any_of(q.begin(), q.end(), has_moved);
    if(may_go_back || v == q.end() || ++number_of_pushes_[*v] > most_pushes)
    {
      blame(q);
      return;
    }
    Vector inward = {{ 0, 0, 0 }};
    double edge = 0;
    for(int w : q)
      for(int n = 0; n < measured_.number_of_fans(w); ++n)
      {
        const Boundary_fan& fan = measured_.fan(w, n);
        const double sign = fan.labels[0] == label ? -1 : fan.labels[1] == label ? 1 : 0;
        for(int i = 0; i < 3; ++i)
          inward[i] += sign * fan.normal[i];
        edge = (std::max)(edge, fan.shortest_edge);
      }
    const double length = std::sqrt(inward[0] * inward[0] + inward[1] * inward[1] + inward[2] * inward[2]);
    if(!(length > 0))
    {
      blame(q);
      return;
    }
    for(double& x : inward)
      x *= step_from_boundary * edge / length;
    pushes_.emplace(*v, inward);
  }

  static Vector coordinates(const Bare_point& p)
  {
    return {{ CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()) }};
  }

  static Quadruple sorted(Quadruple q)
  {
    std::sort(q.begin(), q.end());
    return q;
  }

  int label_of_boundary_cell(Cell_handle c, const Quadruple& q)
  {
    if(std::all_of(q.begin(), q.end(), [this](int v) { return is_home(v); }))
    {
      const auto it = boundary_cells_.find(sorted(q));
      if(it != boundary_cells_.end())
        return it->second;
    }
    return mode_.boundary_moves ? dual_label(c, q)
                                : labels.number(oracle_.subdomain(next_.triangulation().dual(c)));
  }

  // The subdomain in which the dual point of the cell lies: as the normals at its
  // vertices tell, or as the domain says. The domain is asked where the normals are not
  // clear; where it contradicts them nevertheless, they are not believed any more.
  int dual_label(Cell_handle c, const Quadruple& q)
  {
    const double margin = mode_.evidence == SOME_EVIDENCE ? some_margin : good_margin;
    const bool is_doubtful = mode_.evidence == ORACLE
      || std::any_of(q.begin(), q.end(), [this](int v) { return is_on_boundary(v) && doubted_[v]; });
    const int seen = is_doubtful ? int(no_subdomain) : label_seen_from_boundary(q, margin);
    if(seen != no_subdomain)
      return seen;
    const int label = labels.number(oracle_.subdomain(next_.triangulation().dual(c)));
    note(c, IS_FROM_ORACLE);
    if(mode_.evidence == GOOD_EVIDENCE)
    {
      const int expected = label_seen_from_boundary(q, margin / 2);
      if(expected != no_subdomain && expected != label)
        doubt(q);
    }
    return label;
  }

  void doubt(const Quadruple& q)
  {
    for(int v : q)
      if(is_on_boundary(v) && !doubted_[v])
        doubted_[v] = has_doubts_ = has_new_doubts_ = true;
  }

  // The label of the dual point if all vertices on the boundary agree about it.
  int label_seen_from_boundary(const Quadruple& q, double margin) const
  {
    const Site& origin = next_sites_[q[0]];
    const Cell_products t(origin, next_sites_[q[1]], next_sites_[q[2]], next_sites_[q[3]]);
    const double f = 1 / (2 * t.determinant);
    const Vector dual = {{ f * t.nx, f * t.ny, f * t.nz }};       // from the first vertex
    int label = no_subdomain;
    for(int v : q)
    {
      if(!is_on_boundary(v))
        continue;
      const Site& s = next_sites_[v];
      const int l = measured_.label_toward(
        v, {{ dual[0] - (s.x - origin.x), dual[1] - (s.y - origin.y), dual[2] - (s.z - origin.z) }}, margin);
      if(l == no_subdomain || (label != no_subdomain && l != label))
        return no_subdomain;
      label = l;
    }
    return label;
  }

  // Collects the facets that separate subdomains, or may do so once cells with all vertices
  // on the boundary are labelled otherwise, and those that were in the complex without separating any.
  void find_candidates()
  {
    const Triangulation& tr = next_.triangulation();
    candidates_.clear();
    for(auto f = tr.all_facets_begin(); f != tr.all_facets_end(); ++f)
    {
      const Cell_handle c = f->first, d = c->neighbor(f->second);
      if((has_unseparating_facets_ || c->subdomain_index() != d->subdomain_index()
          || knows(c, IS_BOUNDARY_CELL) || knows(d, IS_BOUNDARY_CELL)) && !tr.is_infinite(*f))
        candidates_.push_back(*f);
    }
  }

  // Collects the boundary facets of the labelled triangulation, and their patches.
  void find_boundary()
  {
    std::vector<Boundary_facet> found;
    next_facets_.clear();
    old_of_next_.clear();
    for(const Facet& f : candidates_)
    {
      const Cell_handle c = f.first, d = c->neighbor(f.second);
      const bool separates = c->subdomain_index() != d->subdomain_index();
      if(!separates && !has_unseparating_facets_)
        continue;
      const std::array<int, 3>& k = Flat_triangulation_3::facet_vertices(f.second);
      Boundary_facet b;
      for(int i = 0; i < 3; ++i)
        b.vertices[i] = next_.number(c->vertex(k[i]));
      const auto it = facet_number_.find(Boundary_complex_3::sorted(b.vertices));
      const int old = it == facet_number_.end() ? -1 : it->second;
      if(!separates && (old < 0 || boundary.facets()[old].labels[0] != boundary.facets()[old].labels[1]))
        continue;
      b.labels = {{ labels.number(c->subdomain_index()), labels.number(d->subdomain_index()) }};
      b.patch = old >= 0 ? boundary.facets()[old].patch : patch_of_new_facet(b);
      found.push_back(b);
      next_facets_.push_back(f);
      old_of_next_.push_back(old);
    }
    next_boundary_ = Boundary_complex_3(std::move(found), sites.size());
  }

  // The patch on which all vertices agree.
  int patch_of_new_facet(const Boundary_facet& f)
  {
    std::set<int> common;
    for(int k = 0; k < 3; ++k)
    {
      std::set<int> here;
      for(int n = 0; n < boundary.number_of_fans(f.vertices[k]); ++n)
      {
        const Boundary_fan& fan = boundary.fan(f.vertices[k], n);
        const bool same_labels = (fan.labels[0] == f.labels[0] && fan.labels[1] == f.labels[1])
                                 || (fan.labels[0] == f.labels[1] && fan.labels[1] == f.labels[0]);
        if(same_labels && fan.patch != Boundary_facet::no_patch && (k == 0 || common.count(fan.patch) > 0))
          here.insert(fan.patch);
      }
      common.swap(here);
    }
    if(common.size() <= 1)
      return common.empty() ? int(unknown_patch) : *common.begin();
    const Facet_dual_3 dual(f.vertices, next_sites_);
    Vector p = dual.center;
    Index index;
    if(!oracle_.intersect(p, dual.normal, dual.radius, index))
      return unknown_patch;
    const int patch = patches.number(oracle_.surface_patch(index));
    return common.count(patch) > 0 ? patch : int(unknown_patch);
  }

  // ---- sending vertices back

  // Collects displaced vertices among these or, if there are none, around them.
  template <class Vertices>
  void blame(const Vertices& vertices)
  {
    std::set<int> region(vertices.begin(), vertices.end());
    region.erase(-1);
    for(int ring = 0; ring < 6; ++ring)
    {
      bool found = false;
      for(int v : region)
        if(v < number_of_movable_vertices && !is_home(v))
        {
          offenders_.insert(v);
          found = true;
        }
      if(found)
        return;
      next_.grow(region);
    }
    is_hopeless_ = true;
  }

  void blame(std::initializer_list<int> vertices) { blame(std::vector<int>(vertices)); }

  // What the domain has said holds as long as the vertices stay where they are.
  template <class Answers>
  void forget_moved(Answers& answers) const
  {
    for(auto it = answers.begin(); it != answers.end(); )
    {
      const bool stale = std::any_of(it->first.begin(), it->first.end(),
                                     [this](int v) { return offenders_.count(v) > 0 || pushes_.count(v) > 0; });
      it = stale ? answers.erase(it) : std::next(it);
    }
  }

  // Puts a vertex that was sent back onto the surface, at home if there is no other way.
  bool return_to_surface(int v, bool halfway)
  {
    if(halfway && mode_.projects && project(v, next_sites_[v]))
    {
      next_on_surface_[v] = true;
      return true;
    }
    if(halfway && !mode_.projects)
    {
      next_on_surface_[v] = false;
      next_drift_[v] = drift_[v] + drift(v);
      return true;
    }
    next_sites_[v] = sites[v];
    if(mode_.projects && (mode_.evidence != SOME_EVIDENCE) && !on_surface_[v])
    {
      if(!project(v, next_sites_[v]))
        return false;
      settle_home(v);
    }
    next_on_surface_[v] = on_surface_[v];
    return true;
  }

  // Moves the offenders toward where they were, and home if that does not help.
  bool send_back(int attempt)
  {
    if(offenders_.empty() && pushes_.empty())
      return false;
    for(const auto& p : pushes_)
    {
      if(offenders_.count(p.first) > 0)
        continue;
      Site& s = next_sites_[p.first];
      s = { s.x + p.second[0], s.y + p.second[1], s.z + p.second[2], s.weight };
      ++statistics_.pushed;
    }
    if(attempt >= patient_attempts)
      for(int ring = patient_attempts; ring <= attempt; ring += 3)
        next_.grow(offenders_);
    const bool rebuild = offenders_.size() > sites.size() / 20 || !next_.is_complete();
    for(int v : offenders_)
    {
      if(v >= number_of_movable_vertices || is_home(v))
        continue;
      ++statistics_.sent_back;
      const bool on_surface = v >= number_of_interior_vertices;
      const bool halfway = attempt < patient_attempts && strikes_[v]++ < (on_surface ? 1 : 2);
      Site& s = next_sites_[v];
      const Site& home = sites[v];
      s = halfway ? Site{ (s.x + home.x) / 2, (s.y + home.y) / 2, (s.z + home.z) / 2, home.weight } : home;
      if(on_surface && !return_to_surface(v, halfway))
        return false;
      if(!rebuild)
        next_.move(v, point(v));
    }
    if(rebuild)
      build();
    else
      for(const auto& p : pushes_)
        next_.move(p.first, point(p.first));
    forget_moved(found_centers_);
    forget_moved(found_distances_);
    if(mode_.boundary_moves)
      measured_.measure_fans(next_sites_);
    return true;
  }

  // ---- flat cells on the boundary

  // A sliver with two facets on the boundary stems from four vertices in nearly one
  // plane and on one circle, so that it may as well be on the other side: where that keeps
  // the topology, two boundary facets are replaced by the two others.
  void peel()
  {
    std::set<Cell_handle> refused;
    for(int pass = 0; pass < 4; ++pass)
    {
      std::map<Cell_handle, std::pair<int, int> > peeled;     // old and new label
      std::set<int> used;
      for(const auto& c : next_boundary_cells_)
      {
        const int label = refused.count(c.first) > 0 ? int(no_subdomain) : label_after_peeling(c.first, c.second);
        if(label == no_subdomain)
          continue;
        const Quadruple q = numbers(c.first);
        if(std::any_of(q.begin(), q.end(), [&](int v) { return used.count(v) > 0; }))
          continue;
        used.insert(q.begin(), q.end());
        peeled.emplace(c.first, std::make_pair(c.second, label));
      }
      if(peeled.empty())
        return;
      for(const auto& p : peeled)
      {
        p.first->set_subdomain_index(labels.value(p.second.second));
        p.first->reset_visited(IS_SETTLED);
      }
      find_boundary();
      for(std::set<int> changed; !(changed = changes()).empty(); find_boundary())
      {
        std::size_t number_refused = 0;
        for(auto p = peeled.begin(); p != peeled.end(); )
        {
          const Quadruple q = numbers(p->first);
          if(std::none_of(q.begin(), q.end(), [&](int v) { return changed.count(v) > 0; }))
          {
            ++p;
            continue;
          }
          ++number_refused;
          refused.insert(p->first);
          p->first->set_subdomain_index(labels.value(p->second.first));
          p = peeled.erase(p);
        }
        if(number_refused == 0)
          break;
      }
      for(auto& c : next_boundary_cells_)
      {
        const auto p = peeled.find(c.first);
        if(p != peeled.end())
          c.second = p->second.second;
      }
      statistics_.peeled += peeled.size();
    }
  }

  Quadruple numbers(Cell_handle c) const
  {
    Quadruple q;
    for(int i = 0; i < 4; ++i)
      q[i] = next_.number(c->vertex(i));
    return q;
  }

  // The label beyond both boundary facets of a flat sliver, or no_subdomain.
  int label_after_peeling(Cell_handle c, int label)
  {
    if(label == outside_)
      return no_subdomain;
    std::array<int, 4> facet;
    int count = 0;
    for(int i = 0; i < 4; ++i)
      if(c->neighbor(i)->subdomain_index() != c->subdomain_index())
        facet[count++] = i;
    if(count != 2 || c->neighbor(facet[0])->subdomain_index() != c->neighbor(facet[1])->subdomain_index())
      return no_subdomain;
    const Quadruple q = numbers(c);
    const Cell_shape_3 shape(next_sites_[q[0]], next_sites_[q[1]], next_sites_[q[2]], next_sites_[q[3]]);
    const double between = shape.angles[facet[0] == 0 ? facet[1] - 1 : facet[0] + facet[1]];
    if(between < 180 - flat_angle || *std::min_element(shape.angles.begin(), shape.angles.end()) > sliver_angle)
      return no_subdomain;
    return labels.number(c->neighbor(facet[0])->subdomain_index());
  }

  // ---- surface centers

  // Finds or estimates the points of the surface on the dual lines of the boundary facets.
  void find_surface_centers()
  {
    next_boundary_.measure_fans(next_sites_);
    next_centers_.resize(next_facets_.size());
    for(std::size_t n = 0; n < next_facets_.size(); ++n)
    {
      const Triple& t = next_boundary_.facets()[n].vertices;
      const int old = old_of_next_[n];
      Surface_center& center = next_centers_[n];
      if(old >= 0 && is_unchanged(t))
        center = centers[old];
      else
      {
        const Vector p = estimated_surface_center(t, next_boundary_, next_sites_);
        center = { p, Bare_point(p[0], p[1], p[2]), old >= 0 ? centers[old].index : Index(), false };
      }
      if(mode_.finds_centers && !center.is_exact)
        put_on_surface(n, center);
      if(mode_.finds_centers && center.is_exact)
        check_duals(n);
    }
  }

  void put_on_surface(std::size_t n, Surface_center& center)
  {
    const Triple& t = next_boundary_.facets()[n].vertices;
    const auto known = found_centers_.find(t);
    if(known != found_centers_.end())
    {
      center = known->second;
      return;
    }
    const Facet_dual_3 dual(t, next_sites_);
    for(double h : { 0.3 * dual.radius, dual.radius, 3 * dual.radius })
    {
      Vector p = center.point;
      Index index;
      if(!oracle_.intersect(p, dual.normal, h, index))
        continue;
      center = { p, Bare_point(p[0], p[1], p[2]), index, true };
      break;
    }
    if(!center.is_exact)
      put_on_dual_segment(n, dual, center);
    found_centers_.emplace(t, center);
  }

  // Where the surface is far from the facet, it is crossed between the dual points of its cells.
  void put_on_dual_segment(std::size_t n, const Facet_dual_3& dual, Surface_center& center)
  {
    const Triangulation& tr = next_.triangulation();
    const Cell_handle c = next_facets_[n].first, d = c->neighbor(next_facets_[n].second);
    if(tr.is_infinite(c) || tr.is_infinite(d))
      return;
    const double from = dual.height(coordinates(tr.dual(c))), to = dual.height(coordinates(tr.dual(d)));
    Vector p = dual.point_at((from + to) / 2);
    Index index;
    if(oracle_.intersect(p, dual.normal, std::abs(to - from) / 2, index))
      center = { p, Bare_point(p[0], p[1], p[2]), index, true };
  }

  // The dual points of the cells at a facet lie on the two sides of its center.
  void check_duals(std::size_t n)
  {
    const Triple& t = next_boundary_.facets()[n].vertices;
    const Facet_dual_3 dual(t, next_sites_);
    const Vector& p = next_centers_[n].point;
    const Facet f = next_facets_[n];
    for(int side = 0; side < 2; ++side)
    {
      const Cell_handle c = side == 0 ? f.first : f.first->neighbor(f.second);
      if(next_.triangulation().is_infinite(c))
        continue;
      if(knows(c, IS_BOUNDARY_CELL) || knows(c, IS_FROM_ORACLE))
        continue;
      const Quadruple q = numbers(c);
      const Bare_point d = next_.triangulation().dual(c);
      const double beyond = (dual.height(coordinates(d)) - dual.height(p)) * (side == 0 ? 1 : -1);
      const int label = next_boundary_.facets()[n].labels[side];
      if(beyond > 0 && labels.number(oracle_.subdomain(d)) != label && !is_excused(q))
        mend_cell(q, label);
    }
  }

  // No centroid of a facet may be farther from the surface than the worst of the input,
  // where the domain tells distances.
  void check_fidelity()
  {
    if(!Has_aabb_tree<Mesh_domain>::value)
      return;
    for(std::size_t n = 0; n < next_facets_.size(); ++n)
    {
      const Triple& t = next_boundary_.facets()[n].vertices;
      const int old = old_of_next_[n];
      const bool is_known = old >= 0 && is_unchanged(t) && centers[old].is_exact;
      if(is_known || (mode_.evidence == SOME_EVIDENCE && depth_under_tangential_planes(t, next_boundary_, next_sites_) <= farthest_centroid / 2))
        continue;
      const auto known = found_distances_.find(t);
      const double distance = known != found_distances_.end() ? known->second
                              : oracle_.distance_to_surface(centroid(t, next_sites_));
      found_distances_.emplace(t, distance);
      if(distance > farthest_centroid)
        blame(t);
    }
  }

  // ---- the next state becomes the state

  void accept()
  {
    boundary_cells_.clear();
    for(const auto& c : next_boundary_cells_)
    {
      Quadruple q;
      for(int i = 0; i < 4; ++i)
        q[i] = next_.number(c.first->vertex(i));
      boundary_cells_.emplace(sorted(q), c.second);
    }
    current_.swap(next_);
    for(auto c = current_.triangulation().all_cells_begin(); c != current_.triangulation().all_cells_end(); ++c)
      forget(c);
    triangulation = &current_.triangulation();
    for(std::size_t v = 0; v < vertices.size(); ++v)
      vertices[v] = current_.vertex(static_cast<int>(v));
    sites.swap(next_sites_);
    on_surface_.swap(next_on_surface_);
    drift_.swap(next_drift_);
    for(int v = number_of_interior_vertices; v < number_of_movable_vertices; ++v)
      if(on_surface_[v])
        last_on_surface_[v] = sites[v];
    std::swap(boundary, next_boundary_);
    facets.swap(next_facets_);
    centers.swap(next_centers_);
    number_facets();
    for(std::size_t n = 0; n < facets.size(); ++n)
      if(boundary.facets()[n].patch != Boundary_facet::no_patch)
        for(const Facet& f : { facets[n], triangulation->mirror_facet(facets[n]) })
          f.first->set_surface_patch_index(f.second, patches.value(boundary.facets()[n].patch));
  }

  void number_facets()
  {
    facet_number_.clear();
    has_unseparating_facets_ = false;
    for(std::size_t n = 0; n < boundary.facets().size(); ++n)
    {
      const Boundary_facet& f = boundary.facets()[n];
      facet_number_.emplace(Boundary_complex_3::sorted(f.vertices), static_cast<int>(n));
      has_unseparating_facets_ = has_unseparating_facets_ || f.labels[0] == f.labels[1];
    }
  }

  Domain_oracle_3<Mesh_domain> oracle_;
  int outside_;
  std::unordered_map<Triple, int, Hash> facet_number_;
  bool has_unseparating_facets_ = false;
  std::unordered_map<Quadruple, int, Hash> boundary_cells_;   // labels of cells with all vertices on the boundary

  Numbered_triangulation_3<Triangulation> current_, next_;
  std::vector<Site> next_sites_;
  std::vector<std::pair<Cell_handle, int> > next_boundary_cells_;
  Boundary_complex_3 next_boundary_;
  Boundary_complex_3 measured_;             // the boundary at the new positions
  std::vector<Facet> candidates_, next_facets_;
  std::vector<int> old_of_next_;
  std::vector<int> strikes_;
  std::vector<char> on_surface_, next_on_surface_, is_settled_;       // of the movable vertices
  std::vector<Site> last_on_surface_;
  std::vector<double> drift_, next_drift_;            // over an edge, since a vertex was on the surface
  std::unordered_map<Triple, Surface_center, Hash> found_centers_;
  std::unordered_map<Triple, double, Hash> found_distances_;
  std::vector<Surface_center> next_centers_;
  std::vector<char> doubted_;               // vertices whose normals do not tell sides
  bool has_doubts_ = false, has_new_doubts_ = false;
  std::set<int> offenders_;
  std::map<int, Vector> pushes_;
  std::map<int, int> number_of_pushes_;
  std::set<Quadruple> excused_;
  bool is_hopeless_ = false;
  Update mode_;
  Statistics statistics_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_TRIANGULATION_3_H
