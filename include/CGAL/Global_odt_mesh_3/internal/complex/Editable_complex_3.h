// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_EDITABLE_COMPLEX_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_EDITABLE_COMPLEX_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Exact_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Working_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Exchangeable_boundary_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// A snapshot whose vertices can be moved one by one, in its triangulation, or to which vertices are added. Cells know their
// labels, but facets are in the boundary alone.
struct Editable_complex_3
{
  // A facet of the boundary, as the triangulation has it from its first side.
  struct Found_facet
  {
    std::array<int, 3> key;         // its vertices, sorted
    Boundary_facet of_boundary;
    Facet facet;
  };

  static constexpr int no_subdomain = Complex_snapshot_3::no_subdomain;

  const Complex_snapshot_3& snapshot;
  const Vertex_numbering_3& numbering;
  const Domain_view_3& domain;
  Thread_policy threads;
  Working_triangulation_3& working;
  std::vector<Site> sites;
  Exchangeable_boundary_3 boundary;

  // The numbering begins with that of the snapshot.
  Editable_complex_3(const Complex_snapshot_3& from, const Vertex_numbering_3& numbers, Working_triangulation_3& triangulation,
                     const Domain_view_3& d, const Thread_policy& policy)
    : snapshot(from)
    , numbering(numbers)
    , domain(d)
    , threads(policy)
    , working(triangulation)
    , sites(from.sites)
    , boundary(from.boundary.complex())
  {}

  Editable_complex_3(const Editable_complex_3&) = delete;
  Editable_complex_3& operator=(const Editable_complex_3&) = delete;

  const Exact_triangulation_3& triangulation() const { return working.triangulation(); }

  // Of the vertices of a cell, -1 for the infinite one.
  Quadruple numbers(Cell_handle c) const { return Working_triangulation_3::numbers(c); }

  Weighted_point point(int v) const { return weighted_point(sites[v]); }

  // The next one, out of the triangulation.
  int add_vertex(const Site& s)
  {
    sites.push_back(s);
    working.add_vertex();
    boundary.add_vertex();
    return static_cast<int>(sites.size()) - 1;
  }

  void remove_last_vertex()
  {
    sites.pop_back();
    working.remove_last_vertex();
    boundary.remove_last_vertex();
  }

  // The boundary, in the order of its facets' vertices. No cell needs a look at the domain afterwards.
  std::vector<Found_facet> find_boundary() const
  {
    const std::vector<Cell_handle>& cells = working.cells();
    std::vector<Found_facet> found = collect_in_chunks<Found_facet>(static_cast<int>(cells.size()), threads,
                                                                    [&](int n, std::vector<Found_facet>& some)
    {
      settle(cells[n]);
      find_facets(cells[n], some);
    });
    threads.sort(found.begin(), found.end(), [](const Found_facet& a, const Found_facet& b) { return a.key < b.key; });
    return found;
  }

  // Hands over cells and boundary to a candidate with the sites.
  void give(Complex_candidate_3& candidate) const
  {
    const std::vector<Found_facet> found = find_boundary();
    for(Cell_handle c : working.cells())
      if(c->has_flag(IS_BOUNDARY_CELL))
        candidate.boundary_cells.emplace_back(c, c->label());
    std::vector<Boundary_facet> facets;
    for(const Found_facet& f : found)
    {
      facets.push_back(f.of_boundary);
      candidate.facets.push_back(f.facet);
      candidate.old_facets.push_back(snapshot.facet_number(f.key));
    }
    candidate.boundary_complex = std::make_shared<const Boundary_complex_3>(std::move(facets), sites.size(), threads);
  }

private:
  // A cell that needs no look at the domain any more.
  void settle(Cell_handle c) const
  {
    c->clear_flags();
    c->set_flag(IS_SETTLED);
    // Of facets that have been on the boundary, cells around the vertices that moved know it still.
    c->clear_facets();
  }

  // Those on the boundary whose first side is this cell, which is told if all its vertices are there.
  void find_facets(Cell_handle c, std::vector<Found_facet>& found) const
  {
    if(numbering.for_each_facet_on_boundary(numbers(c), [&](int i) { find_facet(Facet(c, i), found); }))
      c->set_flag(IS_BOUNDARY_CELL);
  }

  // If it is on the boundary, and this is its first side.
  void find_facet(const Facet& f, std::vector<Found_facet>& found) const
  {
    if(!working.is_first_side(f))
      return;
    Boundary_facet b;
    b.vertices = working.vertices(f);
    const std::array<int, 3> key = sorted(b.vertices);
    const int n = boundary.find(key);
    if(n < 0)
      return;
    b.labels = {{ f.first->label(), f.first->neighbor(f.second)->label() }};
    b.patch = boundary.facet(n).patch;
    found.push_back({ key, b, f });
  }
};

// Lengths of edges at a vertex of a complex, and the direction of its surface, on a patch. Sums are rounded the same way
// whatever the order of cells and facets.
struct Vertex_neighborhood_3
{
  double mean_edge = 0;                                                       // of all
  double shortest_edge = (std::numeric_limits<double>::infinity)();           // on the boundary
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();                           // zero if there is no facet of the patch

  Vertex_neighborhood_3() {}

  Vertex_neighborhood_3(const Editable_complex_3& complex, int v, int patch)
  {
    const std::vector<Site>& sites = complex.sites;
    const auto distance = [&](int w) { return (position(sites[w]) - position(sites[v])).norm(); };
    std::vector<double> lengths;
    for(int w : complex.working.neighbors(v))
      lengths.push_back(distance(w));
    std::sort(lengths.begin(), lengths.end());
    mean_edge = std::accumulate(lengths.begin(), lengths.end(), 0.) / double(lengths.size());
    std::vector<Exchangeable_boundary_3::Facet> around;
    for(int n : complex.boundary.around(v))
      around.push_back(complex.boundary.facet(n));
    std::sort(around.begin(), around.end(), [](const auto& a, const auto& b) { return a.vertices < b.vertices; });
    for(const Exchangeable_boundary_3::Facet& facet : around)
    {
      const std::array<int, 3>& t = facet.vertices;
      const Eigen::Vector3d origin = position(sites[t[0]]);
      const Eigen::Vector3d area = (position(sites[t[1]]) - origin).cross(position(sites[t[2]]) - origin);
      if(facet.patch == patch)
        normal += area.dot(normal) < 0 ? Eigen::Vector3d(-area) : area;
      for(int w : t)
        if(w != v)
          shortest_edge = (std::min)(shortest_edge, distance(w));
    }
    normal.normalize();
  }
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_EDITABLE_COMPLEX_3_H
