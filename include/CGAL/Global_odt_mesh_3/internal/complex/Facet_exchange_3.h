// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_FACET_EXCHANGE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_FACET_EXCHANGE_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Boundary_extraction_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Editable_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Surface_centers_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Vertex_cavity_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Exchangeable_boundary_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Finds how the boundary changes with a vertex that moves, comes, or goes, and whether that is permitted.
class Facet_exchange_3
{
public:
  Facet_exchange_3(const Editable_complex_3& complex, const Vertex_cavity_3& cavity)
    : complex_(complex)
    , cavity_(cavity)
  {}

  // For cells that have been found and labelled: whether the boundary keeps its topology, stays close to the surface, and gets no
  // flatter facets.
  bool is_permitted(const Exchangeable_boundary_3::Vertex_change& change)
  {
    removed_.clear();
    added_.clear();
    moved_.clear();
    if(has_one_label())
      return true;
    if(!find_facets(change))
      return false;
    if(!complex_.boundary_moves)
      return removed_.empty() && added_.empty();
    if(exchanges_kept_facet() || removes_feature_edge())
      return false;
    if(!complex_.boundary.keeps_topology(removed_, added_, change))
      return false;
    // If the number of vertices stays the same, facets that are bad already may stay so.
    const double bound = complex_.bounds.smallest_angle();
    const double least = change.is_inserted ? complex_.share_of_facet_angles * bound
                       : change.vertex >= 0 ? bound : (std::min)((std::max)(bound, small_angle), smallest_angle_before());
    const std::vector<Triple> facets = new_facets();
    return std::all_of(facets.begin(), facets.end(), [&](const Triple& t)
    {
      const std::array<Site, 3> s = cavity_.sites(t);
      return smallest_angle_of_facet(s) >= least && complex_.bounds.is_close(t, complex_.numbering, centroid(s));
    });
  }

  // Adds the surface centers of the new facets and of those that stay at the vertex, by sorted vertices; false if the domain does
  // not find all of them.
  bool find_centers(std::map<Triple, Complex_snapshot_3::Surface_center>& centers) const
  {
    const Surface_center_search_3 search(complex_.triangulation, complex_.domain);
    std::map<Triple, Complex_snapshot_3::Surface_center> found;
    for(const Triple& t : new_facets())
    {
      const Facet_dual_3 dual(cavity_.sites(t));
      Complex_snapshot_3::Surface_center center;
      center.point = dual.center;
      if(!search.search_near(dual, center) && !search.put_on_facet(centroid(cavity_.sites(t)), center))
        return false;
      found.emplace(sorted(t), center);
    }
    for(const auto& f : found)
      centers[f.first] = f.second;
    return true;
  }

  void apply(Editable_complex_3& complex) const { complex.boundary.exchange(removed_, added_); }

private:
  typedef Vertex_cavity_3::Cell Cell;
  typedef Exchangeable_boundary_3::Facet Facet;

  // In degrees. A facet with a smaller angle harms the surface more than a sliver harms the cells, even if the input has worse
  // ones.
  static constexpr double small_angle = 25;

  std::vector<Triple> new_facets() const
  {
    std::vector<Triple> facets = moved_;
    for(const Facet& f : added_)
      facets.push_back(f.vertices);
    return facets;
  }

  // A facet as seen from one of several cells.
  struct Side
  {
    Triple facet;
    int cell, index;
    bool operator<(const Side& o) const { return facet != o.facet ? facet < o.facet : cell < o.cell; }
  };

  // The sorted facets of some cells; the two sides of a facet between two of these cells are adjacent.
  static std::vector<Side> sides(const std::vector<Cell*>& cells)
  {
    std::vector<Side> result;
    for(int n = 0; n < static_cast<int>(cells.size()); ++n)
      for(int i = 0; i < 4; ++i)
      {
        const Triple t = sorted(facet_vertices(cells[n]->vertices, i));
        if(t[0] >= 0)
          result.push_back({ t, n, i });
      }
    std::sort(result.begin(), result.end());
    return result;
  }

  // If all cells have one label, the boundary stays as it is.
  bool has_one_label() const
  {
    const int label = cavity_.old_cells().front()->label;
    const auto has_it = [label](const Cell* c) { return c->label == label; };
    return !complex_.snapshot.has_unseparating_facets
           && std::all_of(cavity_.old_cells().begin(), cavity_.old_cells().end(), has_it)
           && std::all_of(cavity_.new_cells().begin(), cavity_.new_cells().end(), has_it);
  }

  // Finds the boundary facets that go, come, or stay at the vertex; false if a new one has no patch, or if old and new cells have
  // different hulls.
  bool find_facets(const Exchangeable_boundary_3::Vertex_change& change)
  {
    const std::vector<std::pair<Triple, int> > hull = labels_beyond_old_cells();
    const std::vector<Side> after = sides(cavity_.new_cells());
    auto h = hull.begin();
    for(std::size_t n = 0; n < after.size(); ++n)
    {
      const Side& s = after[n];
      const Side* other = n + 1 < after.size() && after[n + 1].facet == s.facet ? &after[++n] : nullptr;
      if(other == nullptr && (h == hull.end() || h->first != s.facet))
        return false;
      const std::array<int, 2> labels = {{ cavity_.new_cells()[s.cell]->label,
                                           other != nullptr ? cavity_.new_cells()[other->cell]->label : (h++)->second }};
      const bool is_on_boundary = labels[0] != labels[1]
                                  || (complex_.snapshot.has_unseparating_facets && crosses_surface(s, other));
      if(is_on_boundary && !add_facet(s.facet, sorted(labels), change))
        return false;
    }
    return true;
  }

  // For each facet of the hull, which old and new cells share, the label beyond it. Marks all boundary facets of the old cells as
  // removed for now.
  std::vector<std::pair<Triple, int> > labels_beyond_old_cells()
  {
    const std::vector<Side> before = sides(cavity_.old_cells());
    std::vector<std::pair<Triple, int> > hull;
    for(std::size_t n = 0; n < before.size(); ++n)
    {
      const Triple& t = before[n].facet;
      const int facet = complex_.boundary.find(t), label = cavity_.old_cells()[before[n].cell]->label;
      if(facet >= 0)
        removed_.push_back(facet);
      if(n + 1 < before.size() && before[n + 1].facet == t)
      {
        ++n;
        continue;
      }
      const std::array<int, 2> labels = facet < 0 ? std::array<int, 2>{{ label, label }}
                                                  : complex_.boundary.facet(facet).labels;
      hull.emplace_back(t, labels[0] == label ? labels[1] : labels[0]);
    }
    return hull;
  }

  // Whether the dual segment between the cells of a facet crosses a surface.
  bool crosses_surface(const Side& s, const Side* other)
  {
    if(std::none_of(s.facet.begin(), s.facet.end(), [this](int v) { return complex_.numbering.is_on_boundary(v); }))
      return false;
    const std::vector<Cell*>& cells = cavity_.new_cells();
    if(cells[s.cell]->is_infinite() || (other != nullptr && cells[other->cell]->is_infinite()))
      return false;
    const Vector_3 from = cells[s.cell]->dual;
    Vector_3 to;
    if(other != nullptr)
      to = cells[other->cell]->dual;
    else
    {
      const int c = cavity_.beyond(s.facet);
      if(complex_.triangulation.is_infinite(c))
        return false;
      to = complex_.triangulation.dual_point(c);
    }
    const double length = (to - from).length();
    Vector_3 middle = (from + to) / 2;
    int patch;
    return length > 0 && complex_.domain.intersect(middle, (to - from) / length, length / 2, patch);
  }

  // Records the facet as one that stays or as a new one; false if it has no patch.
  bool add_facet(const Triple& t, const std::array<int, 2>& labels, const Exchangeable_boundary_3::Vertex_change& change)
  {
    const auto old = std::find_if(removed_.begin(), removed_.end(),
                                  [&](int n) { return complex_.boundary.facet(n).vertices == t; });
    if(old != removed_.end() && complex_.boundary.facet(*old).labels == labels)
    {
      if(std::find(t.begin(), t.end(), cavity_.vertex()) != t.end())
        moved_.push_back(t);
      removed_.erase(old);
      return true;
    }
    const auto patches = [&](int v)
    {
      std::set<int> here;
      if(v == change.vertex && change.is_inserted && change.patch != Boundary_facet::no_patch)
        here.insert(change.patch);
      for(int n : complex_.boundary.around(v))
        if(const Facet& f = complex_.boundary.facet(n); f.labels == labels && f.patch != Boundary_facet::no_patch)
          here.insert(f.patch);
      return here;
    };
    const int patch = patch_of_facet(t, cavity_.sites(t), patches, complex_.domain);
    if(patch != unknown_patch)
      added_.push_back({ t, labels, patch });
    return patch != unknown_patch;
  }

  // Whether the facet belongs to a kept cell.
  bool is_kept(const Triple& t) const
  {
    const int c = cavity_.beyond(t);
    return c >= 0 && complex_.numbering.is_kept(complex_.triangulation.vertices(c));
  }

  bool exchanges_kept_facet() const
  {
    if(std::any_of(removed_.begin(), removed_.end(), [this](int n) { return complex_.numbering.is_kept(complex_.boundary.facet(n).vertices); }))
      return true;
    return !complex_.numbering.kept_cells.entries().empty()
           && (std::any_of(removed_.begin(), removed_.end(), [this](int n) { return is_kept(complex_.boundary.facet(n).vertices); })
               || std::any_of(added_.begin(), added_.end(), [this](const Facet& f) { return is_kept(f.vertices); }));
  }

  // Whether a feature edge would disappear. Patches may have features inside, which the topology does not show.
  bool removes_feature_edge() const
  {
    if(complex_.numbering.feature_edges.entries().empty())
      return false;
    for(int n : removed_)
    {
      const Triple& t = complex_.boundary.facet(n).vertices;
      for(int i = 0; i < 3; ++i)
        if(const std::array<int, 2> e = sorted(std::array<int, 2>{{ t[i], t[(i + 1) % 3] }});
           complex_.numbering.feature_edges.find(e) != nullptr && !stays(e))
          return true;
    }
    return false;
  }

  bool stays(const std::array<int, 2>& edge) const
  {
    const auto has_it = [&](const Triple& t) { return index_of(t, edge[0]) < 3 && index_of(t, edge[1]) < 3; };
    const std::vector<Triple> facets = new_facets();
    const std::vector<int>& around = complex_.boundary.around(edge[0]);
    return std::any_of(facets.begin(), facets.end(), has_it)
           || std::any_of(around.begin(), around.end(), [&](int n)
                          { return std::find(removed_.begin(), removed_.end(), n) == removed_.end() && has_it(complex_.boundary.facet(n).vertices); });
  }

  // The smallest angle of the facets that go or stay at the vertex.
  double smallest_angle_before() const
  {
    double least = 180;
    for(int n : removed_)
      least = (std::min)(least, smallest_angle_of_facet(complex_.boundary.facet(n).vertices, complex_.sites));
    for(const Triple& t : moved_)
      least = (std::min)(least, smallest_angle_of_facet(t, complex_.sites));
    return least;
  }

  const Editable_complex_3& complex_;
  const Vertex_cavity_3& cavity_;
  std::vector<int> removed_;          // numbers of facets
  std::vector<Facet> added_;
  std::vector<Triple> moved_;         // those that stay at the vertex
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_FACET_EXCHANGE_3_H
