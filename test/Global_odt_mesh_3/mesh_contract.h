// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_TEST_MESH_CONTRACT_H
#define GLOBAL_ODT_MESH_3_TEST_MESH_CONTRACT_H

#include "check.h"

#include <CGAL/Kernel/global_functions.h>
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

  struct State;

public:
  // Remembers the mesh before the call.
  Mesh_contract(const C3t3& c3t3, const Domain& domain, std::string name)
    : domain_(domain)
    , name_(std::move(name))
    , before_(c3t3, domain)
  {}

  std::size_t number_of_interior_vertices() const { return before_.interior; }

  // From now on, vertices may be inserted or removed, inside and on surfaces, but not where surfaces meet. If there are to
  // be so many times fewer, facets may be as many times farther from surfaces.
  void permit(bool insertion, bool removal, double times_fewer = 1)
  {
    coarsening_ = (std::max)(1., times_fewer);
    may_insert_ = insertion;
    may_remove_ = removal;
  }

  // Facets may have half of the angles they would have to have, since vertices are inserted for other sizes.
  void permit_finer_surfaces() { share_of_facet_angle_ = 0.5; }

  // Checks a mesh made from the one before with the boundary fixed.
  void check(const C3t3& c3t3) const
  {
    const State after(c3t3, domain_);
    check_common(c3t3, after);
    const std::string n = name_ + ": ";
    check::that(after.fixed == before_.fixed && after.sliding == before_.sliding, n,
                "vertices on the boundary or their dimension or index changed");
    check::that(after.facets == before_.facets, n, "facets of the complex, their patches or surface centers changed, ",
                before_.facets.size(), " -> ", after.facets.size());
    check_volume(after, 1e-11);
  }

  // Checks a mesh made from the one before with vertices moving on the surfaces. Vertices and surface centers are within
  // `tolerance`, relative to the size of the mesh, of the surface. No facet gets an angle below that of the input or
  // `facet_angle`. The volume of a subdomain changes by at most this share of the layer of cells along its surface.
  void check_moved(const C3t3& c3t3, double tolerance, double facet_angle = 30, double share_of_layer = 0.03) const
  {
    const State after(c3t3, domain_);
    check_common(c3t3, after);
    const std::string n = name_ + ": ";
    check::that(after.fixed == before_.fixed, n, "vertices on features or outside moved, or their dimension or index changed");
    check::that(keeps_indices(after), n, "vertices of dimension 2 or their indices changed");
    check::that(keeps_patches(after), n, "number of facets, Euler characteristic or components of patches changed");
    check::that(degrees(after.junctions) == degrees(before_.junctions), n, "edges where patches meet changed, ",
                before_.junctions.size(), " -> ", after.junctions.size());
    const int stray = stray_ends(after.junctions, before_.junctions);
    check::that(stray == 0, n, stray, " edges where patches meet are farther than an edge from those before");
    check::that(after.interior_on_boundary <= before_.interior_on_boundary, n, after.interior_on_boundary,
                " vertices of dimension 3 on facets of the complex, before ", before_.interior_on_boundary);
    check::that(after.surface_off_boundary <= before_.surface_off_boundary, n, after.surface_off_boundary,
                " vertices of dimension 2 off the facets of the complex, before ", before_.surface_off_boundary);
    const double reach = tolerance * std::cbrt(before_.box_volume);
    const std::size_t off = vertices_off_surface(after, reach), off_before = vertices_off_surface(before_, reach);
    check::that(off <= off_before, n, off, " vertices are off the surface, before ", off_before);
    const std::size_t centers_off = centers_off_surface(after, reach), centers_off_before = centers_off_surface(before_, reach);
    check::that(centers_off <= centers_off_before, n, centers_off, " surface centers are off the surface, before ",
                centers_off_before);
    check::that(after.farthest_centroid_off_slivers <= 1.01 * coarsening_ * before_.farthest_centroid + 1e-12, n, "a facet's centroid is ",
                after.farthest_centroid_off_slivers, " from the surface, before ", before_.farthest_centroid, ", times ", coarsening_);
    check::that(after.smallest_facet_angle >= share_of_facet_angle_ * (std::min)(before_.smallest_facet_angle, facet_angle) - 1e-3, n,
                "a facet has an angle of ", after.smallest_facet_angle, " degrees, before ", before_.smallest_facet_angle);
    check_volume(after, share_of_layer);
  }

  // How many of some edges there are at each of their ends.
  static std::vector<int> degrees(const std::set<Segment>& edges)
  {
    std::map<Point, int> at;
    for(const Segment& e : edges)
    {
      ++at[e.first];
      ++at[e.second];
    }
    std::vector<int> result;
    for(const auto& a : at)
      result.push_back(a.second);
    std::sort(result.begin(), result.end());
    return result;
  }

  // The number of ends of edges that are farther from all ends of others than the longest of these.
  static int stray_ends(const std::set<Segment>& edges, const std::set<Segment>& others)
  {
    double longest = 0;
    for(const Segment& e : others)
      longest = (std::max)(longest, length(e.first, e.second));
    int stray = 0;
    for(const Segment& e : edges)
      for(const Point& p : { e.first, e.second })
        stray += std::none_of(others.begin(), others.end(), [&](const Segment& o)
                              { return (std::min)(length(p, o.first), length(p, o.second)) <= longest; });
    return stray;
  }

  static double length(const Point& p, const Point& q) { return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]); }

  static std::multiset<std::array<double, 4> > points(const C3t3& c3t3)
  {
    std::multiset<Point> result;
    const Triangulation& tr = c3t3.triangulation();
    for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
      result.insert(point(tr, v));
    return result;
  }

  // Whether `c3t3` is the very mesh before, coordinates of all vertices included.
  void check_untouched(const C3t3& c3t3) const
  {
    const State after(c3t3, domain_);
    check::that(after.all_points == before_.all_points && after.facets == before_.facets
                && after.cells == before_.cells, name_, ": the mesh was touched");
  }

private:
  void check_common(const C3t3& c3t3, const State& after) const
  {
    const std::string n = name_ + ": ";
    check::that(c3t3.triangulation().is_valid(), n, "not a valid regular triangulation");
    check::that(after.vertices == after.fixed.size() + after.sliding.size() + after.interior && after.fixed.size() == before_.fixed.size()
                && is_kept(after.sliding.size(), before_.sliding.size()), n, "vertices ", before_.vertices, " -> ", after.vertices);
    check::that(is_kept(after.interior, before_.interior), n, "vertices of dimension 3: ", before_.interior,
                " -> ", after.interior);
    check::that(after.hidden == 0, n, after.hidden, " hidden vertices");
    check::that(after.stale_duals == 0, n, after.stale_duals, " cells remember the dual point of other vertices");
    check::that(after.one_sided_facets == 0, n, after.one_sided_facets,
                " facets differ in patch or surface center on their two sides");
    check::that(after.centers_off <= before_.centers_off, n, after.centers_off,
                " surface centers are not equidistant from their facets, before ", before_.centers_off);
    check::that(after.missing_facets <= before_.missing_facets, n, after.missing_facets,
                " facets between subdomains are missing, before ", before_.missing_facets);
    for(const auto& u : after.unseparating)
    {
      const auto b = before_.unseparating.find(u.first);
      check::that(b != before_.unseparating.end() && (may_insert_ || u.second <= b->second), n, u.second, " facets of patch ",
                  u.first, " are inside of a subdomain, before ", b == before_.unseparating.end() ? 0 : b->second);
    }
    check::that(after.misplaced_cells <= before_.misplaced_cells, n, after.misplaced_cells,
                " cells have their dual point in another subdomain, before ", before_.misplaced_cells);
    check::that(after.corners == before_.corners, n, "corners changed");
    check::that(after.edges == before_.edges, n, "feature edges changed");
    check::that(after.counters_right, n, "the complex miscounts its cells or facets");
    check::that(after.bad_indices <= before_.bad_indices, n, after.bad_indices,
                " interior vertices have an index other than their subdomain, before ", before_.bad_indices);
    check::that(after.euler == before_.euler, n, "Euler characteristic ", before_.euler, " -> ", after.euler);
    check::that(after.far_points == before_.far_points, n, "far points changed");
    check_rescan(c3t3, after);
  }

  template <class Number>
  bool is_kept(Number after, Number before) const
  { return (may_insert_ || after <= before) && (may_remove_ || after >= before); }

  // Whether as many vertices of dimension 2 have each index. Patches between features may get their first ones.
  bool keeps_indices(const State& after) const
  {
    auto b = count_indices(before_.sliding), a = count_indices(after.sliding);
    std::set<Index> indices;
    for(const auto& count : { b, a })
      for(const auto& c : count)
        indices.insert(c.first);
    return std::all_of(indices.begin(), indices.end(), [&](const Index& i) { return is_kept(a[i], b[i]); });
  }

  bool keeps_patches(const State& after) const
  {
    return std::equal(before_.patches.begin(), before_.patches.end(), after.patches.begin(), after.patches.end(),
                      [this](const auto& x, const auto& y)
    {
      return x.first == y.first && is_kept(y.second[0], x.second[0]) && y.second[1] == x.second[1]
             && y.second[2] == x.second[2];
    });
  }

  void check_volume(const State& after, double share_of_layer) const
  {
    check::that(after.volume.size() == before_.volume.size(), name_, ": subdomains appeared or vanished");
    for(const auto& v : before_.volume)
    {
      const auto it = after.volume.find(v.first);
      const double change = (it == after.volume.end() ? 0 : it->second) - v.second, layer = before_.layer.at(v.first);
      check::that(std::abs(change) <= share_of_layer * layer + 1e-11 * before_.box_volume, name_,
                  ": the volume of a subdomain changed by ", change, " of ", v.second, ", with ", layer, " along its surface");
    }
  }

  std::size_t vertices_off_surface(const State& s, double reach) const
  {
    std::size_t off = 0;
    for(const auto& v : s.sliding)
      off += !is_on_surface(domain_, v.first, reach);
    return off;
  }

  std::size_t centers_off_surface(const State& s, double reach) const
  {
    std::size_t off = 0;
    for(const auto& f : s.facets)
    {
      const std::array<double, 3>& c = f.second.second;
      off += !is_on_surface(domain_, {{ c[0], c[1], c[2], 0 }}, reach);
    }
    return off;
  }

  // Whether the surface crosses one of some short segments around the point: along the
  // axes and, for points just off a sharp edge, along the diagonals between them. Longer ones may have both ends beside a
  // speck of noise.
  static bool is_on_surface(const Domain& domain, const Point& p, double reach)
  {
    typedef typename Domain::Point_3 Point_3;
    for(double r : { reach, reach / 8, reach / 64, reach / 512 })
      for(const std::array<int, 3>& d : { std::array<int, 3>{{ 1, 0, 0 }}, {{ 0, 1, 0 }}, {{ 0, 0, 1 }},
                                          {{ 1, 1, 1 }}, {{ 1, 1, -1 }}, {{ 1, -1, 1 }}, {{ -1, 1, 1 }} })
      {
        const Point_3 a(p[0] - r * d[0], p[1] - r * d[1], p[2] - r * d[2]),
                      b(p[0] + r * d[0], p[1] + r * d[1], p[2] + r * d[2]);
        if(domain.do_intersect_surface_object()(typename Domain::Segment_3(a, b)))
          return true;
      }
    return false;
  }

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

  // How many vertices have each index.
  static std::map<Index, std::size_t> count_indices(const std::map<Point, std::tuple<int, bool, Index> >& vertices)
  {
    std::map<Index, std::size_t> count;
    for(const auto& v : vertices)
      ++count[std::get<2>(v.second)];
    return count;
  }

  struct State
  {
    std::size_t vertices = 0, interior = 0, hidden = 0, one_sided_facets = 0, centers_off = 0,
                missing_facets = 0, misplaced_cells = 0,
                interior_on_boundary = 0, surface_off_boundary = 0, stale_duals = 0, bad_indices = 0, far_points = 0, cells = 0;
    bool counters_right = false;
    long euler = 0;
    double box_volume = 0;
    // Of a facet from the surface, of polyhedral domains: of all, and of those that are not of slivers on the surface.
    check::Largest farthest_centroid, farthest_centroid_off_slivers;
    double smallest_facet_angle = 60;             // of the facets of the complex, in degrees
    std::map<Point, std::tuple<int, bool, Index> > fixed, sliding;    // of dimensions -1, 0, 1, and 2
    std::map<std::string, std::size_t> unseparating;                  // facets inside of a subdomain, by their patches
    std::map<std::string, std::array<long, 3> > patches;              // facets, Euler characteristic, components
    std::set<Segment> junctions;                  // edges without just two facets of one patch
    std::map<Triangle, std::pair<std::string, std::array<double, 3> > > facets;   // patch and surface center
    std::multiset<std::pair<Point, std::string> > corners;
    std::multiset<std::pair<Segment, std::string> > edges;
    std::map<Subdomain_index, double> volume;
    std::map<Subdomain_index, double> layer;      // the sum over the boundary of the area of facets times their mean edge
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
        read_surfaces(c3t3, domain, tr);
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
          (v->in_dimension() == 2 ? sliding : fixed).emplace(p, std::make_tuple(v->in_dimension(), v->is_special(), v->index()));
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
        const auto q = tr.dual(c);
        const auto wanted = is_in_domain(q);
        const bool is_misplaced = label != (wanted ? Subdomain_index(*wanted) : Subdomain_index());
        // Where the dual point is just on the surface, the domain may say this or that.
        const auto is_ambiguous = [&]
        {
          return is_on_surface(domain, {{ CGAL::to_double(q.x()), CGAL::to_double(q.y()), CGAL::to_double(q.z()), 0 }},
                               1e-9 * std::cbrt(box_volume));
        };
        if(is_misplaced && !is_ambiguous())
          ++misplaced_cells;
        // Cells cache their dual points.
        if(!(q == weighted_circumcenter(tr.point(c, 0), tr.point(c, 1), tr.point(c, 2), tr.point(c, 3))))
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
        for(int i = 0; i < 4; ++i)
          if(c3t3.is_in_complex(c, i))
            layer[label] += area_times_mean_edge(p[(i + 1) % 4], p[(i + 2) % 4], p[(i + 3) % 4]);
      }
    }

    // Whether the cell of the facet has an angle below 20 degrees, and two facets on surfaces that nearly are in one plane.
    static bool is_of_sliver(const C3t3& c3t3, const Facet& facet)
    {
      const Cell_handle c = facet.first;
      if(!c3t3.is_in_complex(c))
        return false;
      double smallest = 180, between = 0;
      for(int i = 0; i < 3; ++i)
        for(int j = i + 1; j < 4; ++j)
        {
          // The facets opposite to i and j share the edge of the two others.
          const int k = (i + 1) % 4 == j ? (i + 2) % 4 : (i + 1) % 4, l = 6 - i - j - k;
          const auto at = [&](int n)
          {
            const Point p = point(c3t3.triangulation(), c->vertex(n));
            return typename Triangulation::Bare_point(p[0], p[1], p[2]);
          };
          const double angle = std::abs(CGAL::to_double(CGAL::approximate_dihedral_angle(at(k), at(l), at(i), at(j))));
          smallest = (std::min)(smallest, angle);
          if(c3t3.is_in_complex(c, i) && c3t3.is_in_complex(c, j))
            between = (std::max)(between, angle);
        }
      return smallest < 20 && between > 145;
    }

    // The patches as triangulated surfaces.
    void read_surfaces(const C3t3& c3t3, const Domain& domain, const Triangulation& tr)
    {
      struct Patch
      {
        std::set<Point> vertices;
        std::set<Segment> edges;
        std::vector<std::array<Segment, 3> > facets;
      };
      std::map<std::string, Patch> surfaces;
      std::map<Segment, std::vector<std::string> > around;
      std::set<Vertex_handle> on_boundary;
      for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
      {
        const std::string name = patch_to_string(c3t3.surface_patch_index(*f));
        Patch& patch = surfaces[name];
        std::array<Point, 3> t;
        for(int k = 0; k < 3; ++k)
        {
          const Vertex_handle v = f->first->vertex((f->second + 1 + k) % 4);
          t[k] = point(tr, v);
          on_boundary.insert(v);
          patch.vertices.insert(t[k]);
        }
        std::array<Segment, 3> edges;
        for(int k = 0; k < 3; ++k)
        {
          edges[k] = std::minmax(t[k], t[(k + 1) % 3]);
          patch.edges.insert(edges[k]);
          around[edges[k]].push_back(name);
        }
        patch.facets.push_back(edges);
        smallest_facet_angle = (std::min)(smallest_facet_angle, smallest_angle(t));
        const double d = distance(domain, t);
        farthest_centroid.add(d);
        if(!is_of_sliver(c3t3, *f) && !is_of_sliver(c3t3, tr.mirror_facet(*f)))
          farthest_centroid_off_slivers.add(d);
      }
      for(const auto& e : around)
        if(e.second.size() != 2 || e.second[0] != e.second[1])
          junctions.insert(e.first);
      for(const auto& s : surfaces)
        patches[s.first] = {{ static_cast<long>(s.second.facets.size()),
                              static_cast<long>(s.second.vertices.size()) - static_cast<long>(s.second.edges.size())
                                + static_cast<long>(s.second.facets.size()),
                              components(s.second.facets) }};
      for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
      {
        interior_on_boundary += v->in_dimension() == 3 && on_boundary.count(v) > 0;
        surface_off_boundary += v->in_dimension() == 2 && on_boundary.count(v) == 0;
      }
    }

    // Facets that share an edge are in one component.
    static long components(const std::vector<std::array<Segment, 3> >& facets)
    {
      std::map<Segment, std::vector<std::size_t> > at;
      for(std::size_t n = 0; n < facets.size(); ++n)
        for(const Segment& e : facets[n])
          at[e].push_back(n);
      std::vector<char> seen(facets.size(), false);
      std::vector<std::size_t> stack;
      long count = 0;
      for(std::size_t n = 0; n < facets.size(); ++n)
      {
        if(seen[n])
          continue;
        ++count;
        seen[n] = true;
        stack.assign(1, n);
        while(!stack.empty())
        {
          const std::size_t m = stack.back();
          stack.pop_back();
          for(const Segment& e : facets[m])
            for(std::size_t k : at[e])
              if(!seen[k])
              {
                seen[k] = true;
                stack.push_back(k);
              }
        }
      }
      return count;
    }

    // By Heron's formula.
    static double area_times_mean_edge(const Point& p, const Point& q, const Point& r)
    {
      const double a = length(p, q), b = length(q, r), c = length(r, p), h = (a + b + c) / 2;
      return std::sqrt((std::max)(0., h * (h - a) * (h - b) * (h - c))) * 2 * h / 3;
    }

    static double smallest_angle(const Triangle& t)
    {
      double smallest = 180;
      for(int k = 0; k < 3; ++k)
      {
        const auto at = [&](int n) { return typename Domain::Point_3(t[(k + n) % 3][0], t[(k + n) % 3][1], t[(k + n) % 3][2]); };
        smallest = (std::min)(smallest, CGAL::to_double(CGAL::approximate_angle(at(1), at(0), at(2))));
      }
      return smallest;
    }

    template <class D>
    static auto distance(const D& domain, const std::array<Point, 3>& t) -> decltype(domain.aabb_tree(), double())
    {
      const typename D::Point_3 c((t[0][0] + t[1][0] + t[2][0]) / 3, (t[0][1] + t[1][1] + t[2][1]) / 3,
                                  (t[0][2] + t[1][2] + t[2][2]) / 3);
      return std::sqrt(CGAL::to_double(domain.aabb_tree().squared_distance(c)));
    }
    template <class... Ds>
    static double distance(const Ds&...) { return 0; }

    void read_facets(const C3t3& c3t3, const Triangulation& tr)
    {
      std::set<Point> surface_vertices;
      std::set<Segment> surface_edges;
      for(auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f)
      {
        const Facet mirror = tr.mirror_facet(*f);
        const bool differ = c3t3.subdomain_index(f->first) != c3t3.subdomain_index(mirror.first);
        missing_facets += differ && !c3t3.is_in_complex(*f);
        if(!differ && c3t3.is_in_complex(*f))
          ++unseparating[patch_to_string(c3t3.surface_patch_index(*f))];
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
        check::Largest spread;
        for(int k = 0; k < 3; ++k)
          spread.add(std::abs(power[k] - power[(k + 1) % 3]));
        centers_off += !(spread <= 1e-4 * std::abs(power[0]));
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
  bool may_insert_ = false, may_remove_ = false;
  double coarsening_ = 1, share_of_facet_angle_ = 1;
};

#endif // GLOBAL_ODT_MESH_3_TEST_MESH_CONTRACT_H
