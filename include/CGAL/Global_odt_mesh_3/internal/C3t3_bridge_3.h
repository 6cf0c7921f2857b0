// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_C3T3_BRIDGE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_C3T3_BRIDGE_3_H

#include <CGAL/Global_odt_mesh_3/internal/Flatten_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Moving_triangulation_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/number_utils.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The way from a c3t3 to the flat problem, and back from new positions to a
// c3t3 that keeps every promise of the first.
//
// The way back builds CGAL's exact regular triangulation of the new positions
// and looks for the walls in it. Vertices that stand in the way of a wall, or
// belong to a cell whose dual point the domain places elsewhere than in the
// subdomain enclosed by the walls, go back toward where they came from. The
// input c3t3 is only changed by a swap at the end.
template <class C3t3, class Mesh_domain>
class C3t3_bridge_3
{
  typedef typename C3t3::Triangulation Triangulation;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Cell_handle Cell_handle;
  typedef typename Triangulation::Facet Facet;
  typedef typename Triangulation::Geom_traits Geom_traits;
  typedef typename Triangulation::Bare_point Bare_point;
  typedef typename Triangulation::Weighted_point Weighted_point;
  typedef typename C3t3::Subdomain_index Subdomain_index;
  typedef typename C3t3::Surface_patch_index Surface_patch_index;

public:
  C3t3_bridge_3(C3t3& c3t3, const Mesh_domain& domain)
    : c3t3_(c3t3)
    , domain_(domain)
  {}

  // Loads the complex. Vertices of the interior move, if all around them is
  // inside and no facet of the complex touches them.
  void load(Moving_triangulation_3& mesh)
  {
    const Triangulation& tr = c3t3_.triangulation();
    if(tr.dimension() == 3)
      flat_ = flatten_triangulation_3(
        tr,
        [this](Cell_handle c) { return c3t3_.is_in_complex(c); },
        [this](const Facet& f) { return is_wall(f); },
        [](Vertex_handle v) { return v->in_dimension() == 3; },
        [this](const Facet& f) { return surface_ball(f); },
        mesh);
    else
      mesh = Moving_triangulation_3();
    original_.assign(mesh.sites.begin(), mesh.sites.begin() + mesh.number_of_movable_vertices);
  }

  // Rebuilds the c3t3 from the positions of the movable vertices, or leaves it
  // as it is and returns false if no valid complex can be made of them.
  bool store(const Moving_triangulation_3& mesh)
  {
    Triangulation tr;
    sites_ = mesh.sites;
    number_of_movable_vertices_ = mesh.number_of_movable_vertices;
    strikes_.assign(number_of_movable_vertices_, 0);
    prepare_walls();
    build(tr);
    std::set<int> offenders;
    while(!check(tr, offenders))
    {
      if(!send_back(tr, offenders))
        return false;
      clear_labels(tr);
    }
    C3t3 result;
    result.triangulation().swap(tr);
    fill(result);
    c3t3_.swap(result);
    c3t3_.clear_manifold_info();
    return true;
  }

private:
  typedef std::array<int, 3> Triple;
  typedef std::array<int, 4> Quadruple;

  struct Triple_hash
  {
    template <class Array>
    std::size_t operator()(const Array& t) const { return boost::hash_range(t.begin(), t.end()); }
  };

  static Triple sorted(Triple t)
  {
    std::sort(t.begin(), t.end());
    return t;
  }

  bool is_wall(const Facet& f) const
  {
    return c3t3_.is_in_complex(f)
           || c3t3_.subdomain_index(f.first) != c3t3_.subdomain_index(f.first->neighbor(f.second));
  }

  static Site site(const Weighted_point& p)
  {
    return { CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()),
             CGAL::to_double(p.weight()) };
  }

  // The surface Delaunay ball of a facet. A c3t3 that was not made by the mesher
  // may lack surface centers; then the smallest ball orthogonal to the facet
  // that lies on its dual edge stands in.
  Wall_ball surface_ball(const Facet& f) const
  {
    std::array<Site, 3> s;
    for(int k = 0; k < 3; ++k)
      s[k] = site(c3t3_.triangulation().point(f.first, Flat_triangulation_3::facet_vertices(f.second)[k]));
    const auto& center = f.first->get_facet_surface_center(f.second);
    Wall_ball ball = { CGAL::to_double(center.x()), CGAL::to_double(center.y()),
                       CGAL::to_double(center.z()), 0 };
    const double p0 = ball.power(s[0]), p1 = ball.power(s[1]), p2 = ball.power(s[2]);
    const double spread = (std::max)({ p0, p1, p2 }) - (std::min)({ p0, p1, p2 });
    if(!(spread <= 1e-4 * std::abs(p0)))
      return smallest_ball(f, s);
    ball.squared_radius = (std::min)({ p0, p1, p2 });
    return ball;
  }

  Wall_ball smallest_ball(const Facet& f, const std::array<Site, 3>& s) const
  {
    // With the edges a, b from s0, their lifted heights h_a, h_b and n = a x b, the
    // center is s0 + (h_a (b x n) + h_b (n x a)) / (2 |n|^2).
    const double ax = s[1].x - s[0].x, ay = s[1].y - s[0].y, az = s[1].z - s[0].z;
    const double bx = s[2].x - s[0].x, by = s[2].y - s[0].y, bz = s[2].z - s[0].z;
    const double nx = ay * bz - az * by, ny = az * bx - ax * bz, nz = ax * by - ay * bx;
    const double ha = ax * ax + ay * ay + az * az - s[1].weight + s[0].weight;
    const double hb = bx * bx + by * by + bz * bz - s[2].weight + s[0].weight;
    const double nn = nx * nx + ny * ny + nz * nz;
    Wall_ball ball;
    ball.x = s[0].x + (ha * (by * nz - bz * ny) + hb * (ny * az - nz * ay)) / (2 * nn);
    ball.y = s[0].y + (ha * (bz * nx - bx * nz) + hb * (nz * ax - nx * az)) / (2 * nn);
    ball.z = s[0].z + (ha * (bx * ny - by * nx) + hb * (nx * ay - ny * ax)) / (2 * nn);
    // Slide along the normal to between the dual points of the two cells.
    double lowest = -(std::numeric_limits<double>::max)(), highest = -lowest;
    const Triangulation& tr = c3t3_.triangulation();
    for(Cell_handle c : { f.first, f.first->neighbor(f.second) })
    {
      if(tr.is_infinite(c))
        continue;
      const Bare_point p = tr.dual(c);
      const double t = ((CGAL::to_double(p.x()) - ball.x) * nx + (CGAL::to_double(p.y()) - ball.y) * ny
                        + (CGAL::to_double(p.z()) - ball.z) * nz) / nn;
      // Facet vertices run counterclockwise seen from f.first, so that the
      // normal points to it.
      (c == f.first ? highest : lowest) = t;
    }
    const double t = (std::max)((std::min)(0., highest), (std::min)(lowest, highest));
    ball.x += t * nx; ball.y += t * ny; ball.z += t * nz;
    ball.squared_radius = 0;
    ball.squared_radius = ball.power(s[0]);
    return ball;
  }

  void prepare_walls()
  {
    wall_of_.clear();
    wall_of_.reserve(flat_.walls.size());
    on_wall_.assign(sites_.size(), false);
    for(std::size_t w = 0; w < flat_.walls.size(); ++w)
    {
      const Triple& v = flat_.walls[w].vertices;
      wall_of_.emplace(sorted(v), static_cast<int>(w));
      for(int k : v)
        on_wall_[k] = true;
    }
    fixed_cells_.clear();
    fixed_cells_.insert(flat_.fixed_cells.begin(), flat_.fixed_cells.end());
  }

  Weighted_point point(int v) const
  {
    const Weighted_point& old = c3t3_.triangulation().point(flat_.vertices[v]);
    if(v >= number_of_movable_vertices_ || is_home(v))
      return old;
    const Geom_traits& gt = c3t3_.triangulation().geom_traits();
    return gt.construct_weighted_point_3_object()(Bare_point(sites_[v].x, sites_[v].y, sites_[v].z));
  }

  bool is_home(int v) const
  {
    const Site& a = sites_[v];
    const Site& b = original_[v];
    return a.x == b.x && a.y == b.y && a.z == b.z;
  }

  // The exact regular triangulation. Until the end, a vertex's meshing_info is
  // its number.
  void build(Triangulation& tr)
  {
    handles_.assign(sites_.size(), Vertex_handle());
    typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
    std::vector<Kernel::Point_3> points;
    points.reserve(sites_.size());
    for(const Site& s : sites_)
      points.emplace_back(s.x, s.y, s.z);
    std::vector<std::size_t> order(sites_.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    typedef CGAL::Pointer_property_map<Kernel::Point_3>::type Point_map;
    CGAL::spatial_sort(order.begin(), order.end(),
                       CGAL::Spatial_sort_traits_adapter_3<Kernel, Point_map>(CGAL::make_property_map(points)));
    Cell_handle hint;
    for(std::size_t v : order)
      insert(tr, static_cast<int>(v), hint);
  }

  void insert(Triangulation& tr, int v, Cell_handle& hint)
  {
    const Vertex_handle h = hint == Cell_handle() ? tr.insert(point(v)) : tr.insert(point(v), hint);
    handles_[v] = h;
    if(h == Vertex_handle())
      return;
    h->set_meshing_info(v);
    hint = h->cell();
  }

  static int number(Vertex_handle h) { return static_cast<int>(h->meshing_info()); }

  // Labels the triangulation; collects in `offenders` the displaced vertices
  // that keep it from being what it has to be.
  bool check(Triangulation& tr, std::set<int>& offenders)
  {
    offenders.clear();
    hopeless_ = false;
    if(tr.number_of_vertices() != handles_.size() || has_hidden_vertex())
      blame_hidden_vertices(offenders);
    else if(find_walls(tr, offenders) && label_cells(tr, offenders))
      ask_domain(tr, offenders);
    return offenders.empty() && !hopeless_;
  }

  bool has_hidden_vertex() const
  {
    return std::find(handles_.begin(), handles_.end(), Vertex_handle()) != handles_.end();
  }

  // A vertex without handle is hidden by a weighted one; two that share a handle
  // coincide.
  void blame_hidden_vertices(std::set<int>& offenders)
  {
    for(std::size_t v = 0; v < handles_.size(); ++v)
      if(handles_[v] == Vertex_handle() || number(handles_[v]) != static_cast<int>(v))
        blame(static_cast<int>(v), offenders);
    hopeless_ = offenders.empty();
  }

  void blame(int v, std::set<int>& offenders) const
  {
    if(v < number_of_movable_vertices_ && !is_home(v))
      offenders.insert(v);
  }

  void clear_labels(Triangulation& tr) const
  {
    for(auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
    {
      c->set_subdomain_index(Subdomain_index());
      for(int i = 0; i < 4; ++i)
        c->set_surface_patch_index(i, Surface_patch_index());
    }
  }

  // Finds every wall among the facets of `tr` and marks it on both sides by its
  // patch index.
  bool find_walls(Triangulation& tr, std::set<int>& offenders)
  {
    found_.assign(flat_.walls.size(), Facet(Cell_handle(), -1));
    bare_walls_.clear();
    std::size_t number_found = 0;
    for(auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
    {
      std::array<int, 4> v;
      int on_wall = 0;
      for(int i = 0; i < 4; ++i)
      {
        v[i] = number(c->vertex(i));
        on_wall += on_wall_[v[i]];
      }
      for(int i = 0; i < 4; ++i)
      {
        if(on_wall - on_wall_[v[i]] < 3)
          continue;
        const std::array<int, 3>& f = Flat_triangulation_3::facet_vertices(i);
        const Triple t = {{ v[f[0]], v[f[1]], v[f[2]] }};
        const auto it = wall_of_.find(sorted(t));
        if(it == wall_of_.end() || found_[it->second].second >= 0)
          continue;
        // Of the two sides keep the one of the input's facet.
        const Wall<Triangulation>& wall = flat_.walls[it->second];
        const bool same_side = is_rotation(t, wall.vertices);
        const Facet here(c, i);
        const Facet there = tr.mirror_facet(here);
        found_[it->second] = same_side ? here : there;
        ++number_found;
        const Surface_patch_index patch = c3t3_.surface_patch_index(wall.facet);
        c->set_surface_patch_index(i, patch);
        there.first->set_surface_patch_index(there.second, patch);
        if(!c3t3_.is_in_complex(wall.facet))
        {
          bare_walls_.insert(here);
          bare_walls_.insert(there);
        }
      }
    }
    if(number_found == found_.size())
      return true;
    for(std::size_t w = 0; w < found_.size(); ++w)
      if(found_[w].second < 0)
        blame_around(tr, w, offenders);
    hopeless_ = offenders.empty();
    return false;
  }

  static bool is_rotation(const Triple& a, const Triple& b)
  {
    for(int k = 0; k < 3; ++k)
      if(a[k] == b[0] && a[(k + 1) % 3] == b[1] && a[(k + 2) % 3] == b[2])
        return true;
    return false;
  }

  // A wall is missing: to blame are the vertices in its ball, else the neighbors
  // of its vertices, else their neighbors and so on.
  void blame_around(const Triangulation& tr, std::size_t w, std::set<int>& offenders) const
  {
    const Wall_ball ball = surface_ball(flat_.walls[w].facet);
    std::set<int> region(flat_.walls[w].vertices.begin(), flat_.walls[w].vertices.end());
    for(int ring = 0; ring < 6; ++ring)
    {
      std::set<int> grown = region;
      for(int v : region)
      {
        std::vector<Vertex_handle> neighbors;
        tr.finite_adjacent_vertices(handles_[v], std::back_inserter(neighbors));
        for(Vertex_handle h : neighbors)
          grown.insert(number(h));
      }
      region.swap(grown);
      const std::size_t before = offenders.size();
      for(int v : region)
        if(ball.power(sites_[v]) <= 0)
          blame(v, offenders);
      if(offenders.size() == before && ring > 0)
        for(int v : region)
          blame(v, offenders);
      if(offenders.size() > before)
        return;
    }
  }

  bool is_bounded(Cell_handle c, int i) const
  {
    return c->is_facet_on_surface(i) || (!bare_walls_.empty() && bare_walls_.count(Facet(c, i)) > 0);
  }

  // Floods the parts between the walls with the subdomain that the input has on
  // this side of the wall.
  bool label_cells(Triangulation& tr, std::set<int>& offenders)
  {
    std::vector<Cell_handle> stack, reached;
    bool consistent = true;
    const auto reach = [&](Cell_handle c, const Subdomain_index& label)
    {
      if(c->tds_data().is_clear())
      {
        c->tds_data().mark_in_conflict();
        c->set_subdomain_index(label);
        stack.push_back(c);
        reached.push_back(c);
      }
      if(c->subdomain_index() != label
         || (tr.is_infinite(c) && label != Subdomain_index()))
      {
        consistent = false;
        for(int i = 0; i < 4; ++i)
          if(!tr.is_infinite(c->vertex(i)))
            blame(number(c->vertex(i)), offenders);
      }
    };
    for(std::size_t w = 0; w < found_.size(); ++w)
    {
      const Facet& input = flat_.walls[w].facet;
      const Cell_handle c = found_[w].first;
      reach(c, c3t3_.subdomain_index(input.first));
      reach(c->neighbor(found_[w].second),
            c3t3_.subdomain_index(input.first->neighbor(input.second)));
      while(!stack.empty())
      {
        const Cell_handle d = stack.back();
        stack.pop_back();
        for(int i = 0; i < 4; ++i)
          if(!is_bounded(d, i))
            reach(d->neighbor(i), d->subdomain_index());
      }
    }
    for(Cell_handle c : reached)
      c->tds_data().clear();
    hopeless_ = !consistent && offenders.empty();
    return consistent;
  }

  // A cell that may be near the surface has to have its dual point in the
  // subdomain that it is labelled with. Cells of interior vertices only lie
  // behind these.
  void ask_domain(const Triangulation& tr, std::set<int>& offenders)
  {
    const auto is_in_domain = domain_.is_in_domain_object();
    for(auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
    {
      Quadruple q;
      for(int i = 0; i < 4; ++i)
        q[i] = number(c->vertex(i));
      std::sort(q.begin(), q.end());
      if(q[3] < number_of_movable_vertices_
         || (q[0] >= number_of_movable_vertices_ && fixed_cells_.count(q) > 0))
        continue;
      const auto subdomain = is_in_domain(tr.dual(c));
      const Subdomain_index label = subdomain ? Subdomain_index(*subdomain) : Subdomain_index();
      if(label == c->subdomain_index())
        continue;
      const std::size_t before = offenders.size();
      for(int v : q)
        blame(v, offenders);
      if(offenders.size() > before || q[0] < number_of_movable_vertices_)
        continue;
      for(int i = 0; i < 4; ++i)
        for(int j = 0; j < 4; ++j)
          if(!tr.is_infinite(c->neighbor(i)))
            blame(number(c->neighbor(i)->vertex(j)), offenders);
    }
  }

  // Moves the offenders toward where they were; false if there are none left to
  // move.
  bool send_back(Triangulation& tr, const std::set<int>& offenders)
  {
    if(offenders.empty())
      return false;
    const bool rebuild = offenders.size() > handles_.size() / 20 || has_hidden_vertex()
                         || tr.number_of_vertices() != handles_.size();
    Cell_handle hint;
    for(int v : offenders)
    {
      const double t = strikes_[v]++ < 2 ? 0.5 : 0;
      const Site& home = original_[v];
      Site& s = sites_[v];
      s = t == 0 ? home
                 : Site{ home.x + t * (s.x - home.x), home.y + t * (s.y - home.y),
                         home.z + t * (s.z - home.z), home.weight };
      if(rebuild)
        continue;
      tr.remove(handles_[v]);
      hint = Cell_handle();
      insert(tr, v, hint);
    }
    if(rebuild)
    {
      tr.clear();
      build(tr);
    }
    return true;
  }

  // Completes the new complex from the labels on its cells and the old complex.
  void fill(C3t3& result) const
  {
    Triangulation& tr = result.triangulation();
    std::vector<double> radius_sum(handles_.size(), 0), radius_count(handles_.size(), 0);
    for(auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
    {
      const Subdomain_index label = c->subdomain_index();
      if(label == Subdomain_index())
        continue;
      c->set_subdomain_index(Subdomain_index());
      result.add_to_complex(c, label);
      add_circumradius(tr, c, radius_sum, radius_count);
    }
    for(std::size_t w = 0; w < found_.size(); ++w)
    {
      const Facet& old = flat_.walls[w].facet;
      const Facet f = found_[w];
      const Facet mirror = tr.mirror_facet(f);
      f.first->set_surface_patch_index(f.second, Surface_patch_index());
      mirror.first->set_surface_patch_index(mirror.second, Surface_patch_index());
      if(!c3t3_.is_in_complex(old))
        continue;
      result.add_to_complex(f, c3t3_.surface_patch_index(old));
      for(const Facet& g : { f, mirror })
      {
        g.first->set_facet_surface_center(g.second, old.first->get_facet_surface_center(old.second));
        g.first->set_facet_surface_center_index(g.second, old.first->get_facet_surface_center_index(old.second));
      }
    }
    const bool has_far_points = c3t3_.number_of_far_points() > 0;
    for(std::size_t v = 0; v < handles_.size(); ++v)
    {
      const Vertex_handle from = flat_.vertices[v], to = handles_[v];
      to->set_dimension(from->in_dimension());
      to->set_index(from->index());
      to->set_special(from->is_special());
      to->set_meshing_info(radius_count[v] > 0 ? radius_sum[v] / radius_count[v]
                                               : CGAL::to_double(from->meshing_info()));
      if(has_far_points && from->in_dimension() == -1)
        result.add_far_point(to);
    }
    for(auto v = c3t3_.vertices_in_complex_begin(); v != c3t3_.vertices_in_complex_end(); ++v)
    {
      const Vertex_handle old = v;
      const Vertex_handle to = handles_[flat_.site[old]];
      const bool special = to->is_special();
      result.add_to_complex(to, c3t3_.corner_index(old));
      to->set_special(special);
    }
    if(c3t3_.number_of_edges_in_complex() == 0)
      return;
    std::vector<std::pair<Vertex_handle, typename C3t3::Curve_index> > neighbors;
    for(std::size_t v = 0; v < handles_.size(); ++v)
    {
      if(flat_.vertices[v]->in_dimension() >= 2)
        continue;
      neighbors.clear();
      c3t3_.adjacent_vertices_in_complex(flat_.vertices[v], std::back_inserter(neighbors));
      for(const auto& n : neighbors)
      {
        const std::size_t w = flat_.site[n.first];
        if(v < w)
          result.add_to_complex(handles_[v], handles_[w], n.second);
      }
    }
  }

  // As CGAL's optimizers do, leave the mean circumradius in meshing_info.
  void add_circumradius(const Triangulation& tr, Cell_handle c,
                        std::vector<double>& sum, std::vector<double>& count) const
  {
    const Bare_point p = tr.dual(c);
    const double x = CGAL::to_double(p.x()), y = CGAL::to_double(p.y()), z = CGAL::to_double(p.z());
    for(int i = 0; i < 4; ++i)
    {
      const int v = number(c->vertex(i));
      const Site& s = sites_[v];
      sum[v] += std::sqrt((x - s.x) * (x - s.x) + (y - s.y) * (y - s.y) + (z - s.z) * (z - s.z));
      ++count[v];
    }
  }

  C3t3& c3t3_;
  const Mesh_domain& domain_;
  Flattening<Triangulation> flat_;
  std::vector<Site> original_;

  std::vector<Site> sites_;
  int number_of_movable_vertices_ = 0;
  std::vector<Vertex_handle> handles_;
  std::vector<int> strikes_;
  std::unordered_map<Triple, int, Triple_hash> wall_of_;
  std::unordered_set<Quadruple, Triple_hash> fixed_cells_;
  std::vector<char> on_wall_;
  std::vector<Facet> found_;
  std::set<Facet> bare_walls_;
  bool hopeless_ = false;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_C3T3_BRIDGE_3_H
