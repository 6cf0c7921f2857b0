// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_TEST_MESH_CONTRACT_H
#define GLOBAL_ODT_MESH_3_TEST_MESH_CONTRACT_H

#include "check.h"

#include <CGAL/number_utils.h>

#include <array>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// What CGAL promises of a c3t3, and what the optimizer promises to keep of it.
template <class C3t3, class Domain>
class Mesh_contract
{
  typedef typename C3t3::Triangulation Triangulation;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Cell_handle Cell_handle;
  typedef typename Triangulation::Facet Facet;
  typedef typename Triangulation::Edge Edge;
  typedef typename Triangulation::Vertex::Index Index;
  typedef typename C3t3::Subdomain_index Subdomain_index;
  typedef std::array<double, 4> Point;      // with the weight
  typedef std::array<Point, 3> Triangle;
  typedef std::pair<Point, Point> Segment;

public:
  // Remembers the mesh before the call.
  Mesh_contract(const C3t3& c3t3, const Domain& domain, std::string name)
    : domain_(domain)
    , name_(std::move(name))
    , before_(c3t3, domain)
  {}

  std::size_t number_of_interior_vertices() const { return before_.interior; }

  // Checks a mesh made from the one before.
  void check(const C3t3& c3t3) const
  {
    const std::string n = name_ + ": ";
    check::that(c3t3.triangulation().is_valid(), n, "not a valid regular triangulation");
    const State after(c3t3, domain_);
    check::that(after.vertices == before_.vertices, n, "vertices ", before_.vertices, " -> ", after.vertices);
    check::that(after.interior == before_.interior, n, "vertices of dimension 3: ", before_.interior,
                " -> ", after.interior);
    check::that(after.hidden == 0, n, after.hidden, " hidden vertices");
    check::that(after.fixed == before_.fixed, n, "vertices on the boundary or their dimension or index changed");
    check::that(after.facets == before_.facets, n, "facets of the complex, their patches or surface centers changed, ",
                before_.facets.size(), " -> ", after.facets.size());
    check::that(after.stale_duals == 0, n, after.stale_duals, " cells remember the dual point of other vertices");
    check::that(after.one_sided_facets == 0, n, after.one_sided_facets,
                " facets differ in patch or surface center on their two sides");
    check::that(after.centers_off == before_.centers_off, n, after.centers_off,
                " surface centers are not equidistant from their facets, before ", before_.centers_off);
    check::that(after.misplaced_facets <= before_.misplaced_facets, n, after.misplaced_facets,
                " facets are not where subdomains differ, before ", before_.misplaced_facets);
    check::that(after.misplaced_cells <= before_.misplaced_cells, n, after.misplaced_cells,
                " cells have their dual point in another subdomain, before ", before_.misplaced_cells);
    check::that(after.corners == before_.corners, n, "corners changed");
    check::that(after.edges == before_.edges, n, "feature edges changed");
    check::that(after.counters_right, n, "the complex miscounts its cells or facets");
    check::that(after.bad_indices <= before_.bad_indices, n, after.bad_indices,
                " interior vertices have an index other than their subdomain, before ", before_.bad_indices);
    check::that(after.volume.size() == before_.volume.size(), n, "subdomains appeared or vanished");
    for(const auto& v : before_.volume)
    {
      const auto it = after.volume.find(v.first);
      check::that(it != after.volume.end() && std::abs(it->second - v.second) <= 1e-11 * before_.box_volume,
                  n, "volume of a subdomain changed by ",
                  it == after.volume.end() ? -v.second : it->second - v.second, " of ", v.second);
    }
    check::that(after.euler == before_.euler, n, "Euler characteristic ", before_.euler, " -> ", after.euler);
    check::that(after.far_points == before_.far_points, n, "far points changed");
    check_rescan(c3t3, after);
  }

  // Whether `c3t3` is the very mesh before, coordinates of all vertices included.
  void check_untouched(const C3t3& c3t3) const
  {
    const State after(c3t3, domain_);
    check::that(after.all_points == before_.all_points && after.facets == before_.facets
                && after.cells == before_.cells, name_, ": the mesh was touched");
  }

  static std::multiset<std::array<double, 4> > points(const C3t3& c3t3)
  {
    std::multiset<Point> result;
    const Triangulation& tr = c3t3.triangulation();
    for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
      result.insert(point(tr, v));
    return result;
  }

private:
  static Point point(const Triangulation& tr, Vertex_handle v)
  {
    const auto& p = tr.point(v);
    return {{ CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()), CGAL::to_double(p.weight()) }};
  }

  template <class T>
  static std::string to_string(const T& t)
  {
    std::ostringstream out;
    out << t;
    return out.str();
  }

  template <class... Ts>
  static std::string patch_to_string(const std::pair<Ts...>& p)
  {
    return to_string(p.first) + " " + to_string(p.second);
  }
  template <class T>
  static std::string patch_to_string(const T& t) { return to_string(t); }

  struct State
  {
    std::size_t vertices = 0, interior = 0, hidden = 0, one_sided_facets = 0, centers_off = 0,
                misplaced_facets = 0, misplaced_cells = 0, stale_duals = 0, bad_indices = 0, far_points = 0, cells = 0;
    bool counters_right = false;
    long euler = 0;
    double box_volume = 0;
    std::map<Point, std::tuple<int, bool, Index> > fixed;
    std::map<Triangle, std::pair<std::string, std::array<double, 3> > > facets;   // patch and surface center
    std::multiset<std::pair<Point, std::string> > corners;
    std::multiset<std::pair<Segment, std::string> > edges;
    std::map<Subdomain_index, double> volume;
    std::multiset<Point> all_points;

    State(const C3t3& c3t3, const Domain& domain)
    {
      const Triangulation& tr = c3t3.triangulation();
      vertices = tr.number_of_vertices();
      far_points = c3t3.number_of_far_points();
      all_points = points(c3t3);
      if(tr.dimension() == 3)
        for(auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
          hidden += std::distance(c->hidden_points_begin(), c->hidden_points_end());
      read_vertices(c3t3, tr);
      if(tr.dimension() == 3)
      {
        read_cells(c3t3, domain, tr);
        read_facets(c3t3, tr);
      }
      for(auto v = c3t3.vertices_in_complex_begin(); v != c3t3.vertices_in_complex_end(); ++v)
        corners.insert({ point(tr, v), to_string(c3t3.corner_index(v)) });
      for(auto e = c3t3.edges_in_complex_begin(); e != c3t3.edges_in_complex_end(); ++e)
      {
        Point a = point(tr, e->first->vertex(e->second)), b = point(tr, e->first->vertex(e->third));
        if(b < a)
          std::swap(a, b);
        edges.insert({ { a, b }, to_string(c3t3.curve_index(*e)) });
      }
      counters_right = cells == c3t3.number_of_cells_in_complex()
                       && facets.size() == c3t3.number_of_facets_in_complex()
                       && edges.size() == c3t3.number_of_edges_in_complex()
                       && corners.size() == c3t3.number_of_corners();
    }

    void read_vertices(const C3t3& c3t3, const Triangulation& tr)
    {
      std::map<Vertex_handle, std::set<Subdomain_index> > subdomains;
      for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
        for(int i = 0; i < 4; ++i)
          subdomains[c->vertex(i)].insert(c3t3.subdomain_index(c));
      double lo[3] = { 1e300, 1e300, 1e300 }, hi[3] = { -1e300, -1e300, -1e300 };
      for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
      {
        const Point p = point(tr, v);
        for(int k = 0; k < 3; ++k)
        {
          lo[k] = (std::min)(lo[k], p[k]);
          hi[k] = (std::max)(hi[k], p[k]);
        }
        if(v->in_dimension() == 3)
        {
          ++interior;
          const auto s = subdomains.find(v);
          if(s != subdomains.end() && s->second.size() == 1
             && !(v->index() == Index(*s->second.begin())))
            ++bad_indices;
        }
        else
          fixed.emplace(p, std::make_tuple(v->in_dimension(), v->is_special(), v->index()));
      }
      if(vertices > 0)
        box_volume = (hi[0] - lo[0]) * (hi[1] - lo[1]) * (hi[2] - lo[2]);
    }

    void read_cells(const C3t3& c3t3, const Domain& domain, const Triangulation& tr)
    {
      const auto is_in_domain = domain.is_in_domain_object();
      const auto weighted_circumcenter = tr.geom_traits().construct_weighted_circumcenter_3_object();
      for(auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
      {
        const Subdomain_index label = c3t3.subdomain_index(c);
        const auto wanted = is_in_domain(tr.dual(c));
        if(label != (wanted ? Subdomain_index(*wanted) : Subdomain_index()))
          ++misplaced_cells;
        // Cells cache their dual points.
        if(!(tr.dual(c) == weighted_circumcenter(tr.point(c, 0), tr.point(c, 1), tr.point(c, 2), tr.point(c, 3))))
          ++stale_duals;
        if(!c3t3.is_in_complex(c))
          continue;
        ++cells;
        std::array<Point, 4> p;
        for(int i = 0; i < 4; ++i)
          p[i] = point(tr, c->vertex(i));
        double a[3], b[3], d[3];
        for(int k = 0; k < 3; ++k)
        {
          a[k] = p[1][k] - p[0][k];
          b[k] = p[2][k] - p[0][k];
          d[k] = p[3][k] - p[0][k];
        }
        volume[label] += (a[0] * (b[1] * d[2] - b[2] * d[1]) + a[1] * (b[2] * d[0] - b[0] * d[2])
                          + a[2] * (b[0] * d[1] - b[1] * d[0])) / 6;
      }
    }

    void read_facets(const C3t3& c3t3, const Triangulation& tr)
    {
      std::set<Point> surface_vertices;
      std::set<Segment> surface_edges;
      for(auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f)
      {
        const Facet mirror = tr.mirror_facet(*f);
        const bool differ = c3t3.subdomain_index(f->first) != c3t3.subdomain_index(mirror.first);
        if(differ != c3t3.is_in_complex(*f))
          ++misplaced_facets;
        if(c3t3.is_in_complex(*f) != c3t3.is_in_complex(mirror))
          ++one_sided_facets;
        if(!c3t3.is_in_complex(*f))
          continue;
        const auto center = f->first->get_facet_surface_center(f->second);
        if(!(c3t3.surface_patch_index(*f) == c3t3.surface_patch_index(mirror))
           || !(center == mirror.first->get_facet_surface_center(mirror.second)))
          ++one_sided_facets;
        Triangle t;
        double power[3];
        for(int k = 0; k < 3; ++k)
        {
          t[k] = point(tr, f->first->vertex((f->second + 1 + k) % 4));
          power[k] = CGAL::square(t[k][0] - CGAL::to_double(center.x())) + CGAL::square(t[k][1] - CGAL::to_double(center.y()))
                   + CGAL::square(t[k][2] - CGAL::to_double(center.z())) - t[k][3];
        }
        if((std::max)({ power[0], power[1], power[2] }) - (std::min)({ power[0], power[1], power[2] })
           > 1e-4 * std::abs(power[0]))
          ++centers_off;
        std::sort(t.begin(), t.end());
        facets.emplace(t, std::make_pair(patch_to_string(c3t3.surface_patch_index(*f)),
                                         std::array<double, 3>{{ CGAL::to_double(center.x()), CGAL::to_double(center.y()),
                                                                 CGAL::to_double(center.z()) }}));
        for(int k = 0; k < 3; ++k)
        {
          surface_vertices.insert(t[k]);
          surface_edges.insert({ t[k == 2 ? 0 : k], t[k == 2 ? 2 : k + 1] });
        }
      }
      euler = static_cast<long>(surface_vertices.size()) - static_cast<long>(surface_edges.size())
              + static_cast<long>(facets.size());
    }
  };

  // CGAL's own rescan must find what the complex says.
  void check_rescan(const C3t3& c3t3, const State& after) const
  {
    C3t3 copy(c3t3);
    copy.rescan_after_load_of_triangulation();
    check::that(copy.number_of_cells_in_complex() == after.cells
                && copy.number_of_facets_in_complex() == after.facets.size(),
                name_, ": a rescan finds other cells or facets");
  }

  const Domain& domain_;
  std::string name_;
  State before_;
};

#endif // GLOBAL_ODT_MESH_3_TEST_MESH_CONTRACT_H
