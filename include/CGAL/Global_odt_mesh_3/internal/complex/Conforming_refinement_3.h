// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CONFORMING_REFINEMENT_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CONFORMING_REFINEMENT_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Exact_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/User_field_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <queue>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Splits edges of a boundary that are too long, or have long thin facets that no regular triangulation contains, until the Delaunay
// triangulation of all vertices conforms to the boundary: it contains the creases and, between these, facets in the same planes.
// Cells are split along with their edges, whatever their shape, since other cells replace them.
//
// Where two edges meet at a small angle, parts of each may come too close to the other. As in Ruppert's method, parts at a vertex
// of the input have a power of two for their length, so that they end on common spheres around it.
class Conforming_refinement_3
{
public:
  // The table is of a mesh that is its own domain.
  explicit Conforming_refinement_3(Mesh_table_3 table)
    : table_(std::move(table))
    , rounding_(rounding_of_coordinates(table_.sites))
    , first_new_(static_cast<int>(table_.sites.size()))
    , cells_at_(table_.sites.size())
    , facets_(table_.cells.size(), {{ none, none, none, none }})
  {
    for(std::size_t n = 0; n < table_.facets.size(); ++n)
      facets_[table_.facets[n].cell][table_.facets[n].index] = static_cast<int>(n);
    for(std::size_t c = 0; c < table_.cells.size(); ++c)
      for(int v : table_.cells[c].vertices)
        if(v >= 0)
          cells_at_[v].push_back(static_cast<int>(c));
    for(const Mesh_table_3::Feature_edge& e : table_.feature_edges)
      if(e.curve != no_curve)
        curves_.emplace(sorted(e.vertices), e.curve);
  }

  // Halves feature edges that are longer than `wanted(stratum, middle)`, as far as they may be split, and edges on surfaces so that
  // facets do not get thin beside them; whether there are any. Those that are the longest for their bounds come first.
  template <class Length, class Predicate>
  bool split_long_edges(const Length& wanted, int most_vertices, const Predicate& may_go_on)
  {
    std::priority_queue<std::pair<double, Edge> > edges;
    const auto push = [&](const Edge& e)
    {
      if(const double ratio = length(e) / longest(e, wanted); ratio > 1)
        edges.emplace(ratio, e);
    };
    const auto push_edges = [&](const std::vector<Triple>& facets, int end)
    {
      std::set<Edge> found;
      for(const Triple& t : facets)
        for(int i = 0; i < 3; ++i)
          if(const Edge e = edge(t, i); end == none || e[0] == end || e[1] == end)
            found.insert(e);
      std::for_each(found.begin(), found.end(), push);
    };
    push_edges(boundary_facets(), none);
    std::set<Edge> staying;
    while(!edges.empty() && static_cast<int>(table_.sites.size()) < most_vertices && may_go_on())
    {
      const Edge e = edges.top().second;
      edges.pop();
      if(cells_around(e).empty())
        continue;
      if(!may_be_split(e) || is_beside_longer_edge(e, staying))
      {
        staying.insert(e);
        continue;
      }
      const int m = static_cast<int>(table_.sites.size());
      split(e);
      push_edges(boundary_facets(cells_at_[m]), m);
    }
    return static_cast<int>(table_.sites.size()) > first_new_;
  }

  // Splits what does not conform. False if an edge that must not be split would have to be, if there would be too many vertices, or if
  // the user stops it.
  template <class Predicate>
  bool run(int most_vertices, const Predicate& may_go_on)
  {
    const int most = (std::min)(most_vertices, most_growth * static_cast<int>(table_.sites.size()) + fewest_permitted);
    for(;;)
    {
      triangulate();
      if(delaunay_.dimension() < 3)
        return false;
      std::set<Edge> edges = missing_creases();
      if(edges.empty())
        edges = longest_edges(pierced_facets());
      if(edges.empty())
        return true;
      const int number = static_cast<int>(table_.sites.size() + edges.size());
      if(number > most || !may_go_on()
         || !std::all_of(edges.begin(), edges.end(), [this](const Edge& e) { return may_be_split(e); }))
        return false;
      for(const Edge& e : edges)
        split(e);
    }
  }

  // To be called last; moves the table out.
  Mesh_table_3 take_table()
  {
    write_facets();
    std::vector<Mesh_table_3::Feature_edge>& edges = table_.feature_edges;
    edges.erase(std::remove_if(edges.begin(), edges.end(), [](const auto& e) { return e.curve != no_curve; }), edges.end());
    for(const auto& c : curves_)
      edges.push_back({ c.first, c.second });
    return std::move(table_);
  }

private:
  typedef std::array<int, 2> Edge;

  static constexpr int most_growth = 8, fewest_permitted = 1000;
  // The bounds on edges on surfaces, with an end on a feature or without one, relative to those on features. What is left gets
  // vertices in better places later on, but none fits into long facets between features with short edges.
  static constexpr double longest_at_feature = 1.5, longest_on_surface = 2;
  static constexpr int none = -1, no_curve = Mesh_table_3::Feature_edge::no_curve;

  bool is_on_boundary(int c, int i) const
  { return facets_[c][i] != none || table_.cells[c].label != table_.cells[table_.cells[c].neighbors[i]].label; }

  std::vector<Triple> boundary_facets() const
  {
    std::vector<int> cells(table_.cells.size());
    std::iota(cells.begin(), cells.end(), 0);
    return boundary_facets(cells);
  }

  // Those of some cells. Facets and their vertices are sorted.
  std::vector<Triple> boundary_facets(const std::vector<int>& cells) const
  {
    std::vector<Triple> result;
    for(int c : cells)
      for(int i = 0; i < 4; ++i)
        if(is_on_boundary(c, i))
          result.push_back(sorted(facet_vertices(table_.cells[c].vertices, i)));
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  void triangulate()
  {
    boundary_ = boundary_facets();
    std::vector<int> vertices;
    for(int v = 0; v < static_cast<int>(table_.sites.size()); ++v)
      if(!cells_at_[v].empty())
        vertices.push_back(v);
    delaunay_.clear();
    delaunay_.insert_sites(vertices, table_.sites);
  }

  std::set<Edge> missing_creases() const
  {
    std::set<Edge> found;
    for(const auto& e : delaunay_.finite_edges())
      found.insert(sorted(Edge{{ e.first->vertex(e.second)->number(), e.first->vertex(e.third)->number() }}));
    std::map<Edge, std::vector<Triple> > around;
    for(const Triple& t : boundary_)
      for(int i = 0; i < 3; ++i)
        around[edge(t, i)].push_back(t);
    std::set<Edge> result;
    for(const auto& a : around)
      if(found.count(a.first) == 0 && is_crease(a.first, a.second))
        result.insert(a.first);
    return result;
  }

  // Edges between two facets in one plane are no creases unless they are on a curve, and may be exchanged.
  bool is_crease(const Edge& e, const std::vector<Triple>& facets) const
  { return curves_.count(e) > 0 || facets.size() != 2 || !(is_in_plane(facets[0], facets[1]) || is_in_plane(facets[1], facets[0])); }

  bool is_in_plane(const Triple& facet, const Triple& of_facet) const
  {
    const Facet_dual_3 plane(of_facet, table_.sites);
    return std::all_of(facet.begin(), facet.end(), [&](int v) { return std::abs(plane.height(position(table_.sites[v]))) <= rounding_; });
  }

  // The boundary facets that are not covered by other facets in the same plane.
  std::vector<Triple> pierced_facets() const
  {
    std::vector<Triple> found;
    for(const auto& f : delaunay_.finite_facets())
      found.push_back(sorted(numbers(f.first, f.second)));
    std::sort(found.begin(), found.end());
    std::vector<Triple> result;
    Exact_triangulation_3::Cell_handle hint;
    for(const Triple& t : boundary_)
      if(!std::binary_search(found.begin(), found.end(), t) && !is_covered(t, hint))
        result.push_back(t);
    return result;
  }

  // Whether facets in the same plane cover the facet, tested at some of its points.
  bool is_covered(const Triple& t, Exact_triangulation_3::Cell_handle& hint) const
  {
    constexpr double shares[][3] = { { 1 / 3., 1 / 3., 1 / 3. }, { .8, .1, .1 }, { .1, .8, .1 }, { .1, .1, .8 }, { .1, .45, .45 },
                                     { .45, .1, .45 }, { .45, .45, .1 } };
    const std::vector<Site>& s = table_.sites;
    return std::all_of(std::begin(shares), std::end(shares), [&](const double (&a)[3])
    {
      const Vector_3 p = a[0] * position(s[t[0]]) + a[1] * position(s[t[1]]) + a[2] * position(s[t[2]]);
      hint = delaunay_.locate(weighted_point(site_at(p, 0)), hint);
      for(int i = 0; i < 4; ++i)
        if(const Triple u = numbers(hint, i); sorted(u)[0] >= 0 && is_in_plane(u, t))
          return true;
      return false;
    });
  }

  static Triple numbers(Exact_triangulation_3::Cell_handle c, int i)
  { return {{ c->vertex((i + 1) % 4)->number(), c->vertex((i + 2) % 4)->number(), c->vertex((i + 3) % 4)->number() }}; }

  std::set<Edge> longest_edges(const std::vector<Triple>& facets) const
  {
    std::set<Edge> result;
    for(const Triple& t : facets)
    {
      int longest = 0;
      for(int i = 1; i < 3; ++i)
        if(length(edge(t, i)) > length(edge(t, longest)))
          longest = i;
      result.insert(edge(t, longest));
    }
    return result;
  }

  static Edge edge(const Triple& t, int i) { return sorted(Edge{{ t[i], t[(i + 1) % 3] }}); }

  double length(const Edge& e) const { return (position(table_.sites[e[1]]) - position(table_.sites[e[0]])).length(); }

  // The bound on the length of an edge of the boundary.
  template <class Length>
  double longest(const Edge& e, const Length& wanted) const
  {
    if(const auto curve = curves_.find(e); curve != curves_.end())
      return wanted(Vertex_stratum{ -1, 1, curve->second }, middle(e));
    const int patch = patch_around(e);
    if(patch == none)
      return (std::numeric_limits<double>::infinity)();
    const bool is_at_feature = table_.dimensions[e[0]] < 2 || table_.dimensions[e[1]] < 2;
    return (is_at_feature ? longest_at_feature : longest_on_surface) * wanted(Vertex_stratum{ -1, 2, patch }, middle(e));
  }

  // Whether a facet of the boundary has this edge and a longer one that stays. Beside that edge, others would be halved for ever.
  bool is_beside_longer_edge(const Edge& e, const std::set<Edge>& staying) const
  {
    const auto is_longer_and_stays = [&](const Edge& f) { return length(f) > length(e) && (staying.count(f) > 0 || !may_be_split(f)); };
    for(const Triple& t : boundary_facets(cells_around(e)))
      if(std::includes(t.begin(), t.end(), e.begin(), e.end())
         && (is_longer_and_stays(edge(t, 0)) || is_longer_and_stays(edge(t, 1)) || is_longer_and_stays(edge(t, 2))))
        return true;
    return false;
  }

  std::vector<int> cells_around(const Edge& e) const
  {
    std::vector<int> result;
    for(int c : cells_at_[e[0]])
      if(index_of(table_.cells[c].vertices, e[1]) < 4)
        result.push_back(c);
    return result;
  }

  // The patch of the facets around an edge; none if there are several or no facets.
  int patch_around(const Edge& e) const
  {
    int patch = none;
    for(int c : cells_around(e))
      for(int i = 0; i < 4; ++i)
        if(const int w = table_.cells[c].vertices[i]; w != e[0] && w != e[1] && facets_[c][i] != none)
        {
          const int other = table_.facets[facets_[c][i]].patch;
          if(patch != none && patch != other)
            return none;
          patch = other;
        }
    return patch;
  }

  // An edge must not be split where the user keeps cells or facets, between protecting balls, where the patch or curve of the new
  // vertex is not clear, or if rounding puts that vertex at an end of the edge.
  bool may_be_split(const Edge& e) const
  {
    if(const Site m = middle(e); same_place(m, table_.sites[e[0]]) || same_place(m, table_.sites[e[1]]))
      return false;
    if(table_.sites[e[0]].weight != 0 || table_.sites[e[1]].weight != 0 || (curves_.count(e) == 0 && patch_around(e) == none))
      return false;
    for(int c : cells_around(e))
      if(table_.cells[c].is_kept || table_.cells[c].kept_facets != 0)
        return false;
    return true;
  }

  Site middle(const Edge& e) const
  {
    const Vector_3 p = position(table_.sites[e[0]]), along = position(table_.sites[e[1]]) - p;
    double share = 0.5;
    if(const double length = along.length(); length > 0 && (e[0] < first_new_) != (e[1] < first_new_))
    {
      const double power = std::exp2(std::floor(std::log2(2 * length / 3)));
      share = e[0] < first_new_ ? power / length : 1 - power / length;
    }
    return site_at(p + share * along, 0);
  }

  void split(const Edge& e)
  {
    const int m = static_cast<int>(table_.sites.size());
    const auto curve = curves_.find(e);
    const bool is_on_curve = curve != curves_.end();
    const int place = is_on_curve ? curve->second : patch_around(e);
    table_.sites.push_back(middle(e));
    table_.dimensions.push_back(is_on_curve ? 1 : 2);
    table_.inserted.push_back(place);
    cells_at_.emplace_back();
    if(is_on_curve)
    {
      curves_.erase(curve);
      for(int v : e)
        curves_.emplace(sorted(Edge{{ v, m }}), place);
    }
    split_cells(e, m);
  }

  // Each cell keeps the first vertex of the edge, and a new cell gets the second.
  void split_cells(const Edge& e, int m)
  {
    std::map<int, int> beyond;
    const std::vector<int> around = cells_around(e);
    for(int c : around)
      beyond.emplace(c, static_cast<int>(table_.cells.size() + beyond.size()));
    table_.cells.resize(table_.cells.size() + around.size());
    facets_.resize(table_.cells.size());
    for(int c : around)
    {
      const int d = beyond[c];
      Mesh_table_3::Cell& first = table_.cells[c];
      Mesh_table_3::Cell& second = table_.cells[d];
      second = first;
      facets_[d] = facets_[c];
      const int u = index_of(first.vertices, e[0]), v = index_of(first.vertices, e[1]);
      first.vertices[v] = second.vertices[u] = m;
      first.neighbors[u] = d;
      second.neighbors[v] = c;
      facets_[c][u] = facets_[d][v] = none;
      const int across = second.neighbors[u];
      Quadruple& back = table_.cells[across].neighbors;
      *std::find(back.begin(), back.end(), c) = d;
      for(int i = 0; i < 4; ++i)
        if(i != u && i != v)
          second.neighbors[i] = beyond.at(first.neighbors[i]);
      for(int w : second.vertices)
        if(w >= 0 && w != e[1])
          cells_at_[w].push_back(d);
      cells_at_[m].push_back(c);
      std::vector<int>& at_second = cells_at_[e[1]];
      *std::find(at_second.begin(), at_second.end(), c) = d;
    }
  }

  // Facets that are parts of others get surface centers in their own planes.
  void write_facets()
  {
    std::vector<Mesh_table_3::Facet> facets;
    for(int c = 0; c < static_cast<int>(table_.cells.size()); ++c)
    {
      table_.cells[c].facets = 0;
      for(int i = 0; i < 4; ++i)
        if(facets_[c][i] != none)
        {
          table_.cells[c].facets |= 1 << i;
          Mesh_table_3::Facet f = table_.facets[facets_[c][i]];
          f.cell = c;
          f.index = i;
          const Triple t = facet_vertices(table_.cells[c].vertices, i);
          if(std::any_of(t.begin(), t.end(), [this](int v) { return v >= first_new_; }))
          {
            f.source = Mesh_table_3::no_facet;
            f.center = centroid(t, table_.sites);
            f.patch_of_center = f.patch;
          }
          facets.push_back(f);
        }
    }
    table_.facets = std::move(facets);
  }

  Mesh_table_3 table_;
  const double rounding_;
  const int first_new_;
  std::vector<std::vector<int> > cells_at_;               // by vertices
  std::vector<std::array<int, 4> > facets_;               // for each facet of a cell, the table's facet it is part of, or none
  std::map<Edge, int> curves_;                            // of feature edges
  std::vector<Triple> boundary_;
  Exact_triangulation_3 delaunay_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CONFORMING_REFINEMENT_3_H
