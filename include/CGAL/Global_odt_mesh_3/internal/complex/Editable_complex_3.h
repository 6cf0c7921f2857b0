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

#include <CGAL/Global_odt_mesh_3/internal/complex/Candidate_checks_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Exact_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Working_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/sizing/Size_criteria_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Exchangeable_boundary_3.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// A cell with a small dihedral angle, in degrees.
struct Sliver_3
{
  double angle;
  Quadruple vertices;               // sorted
  Cell_handle cell;                 // as long as the complex has it

  bool operator<(const Sliver_3& o) const { return angle != o.angle ? angle < o.angle : vertices < o.vertices; }
};

// A snapshot whose vertices can be moved one by one, in its triangulation, or to which vertices are added. Cells know their
// labels. The boundary alone says which facets are in the complex: what cells know of their facets may be out of date.
struct Editable_complex_3
{
  // A facet of the boundary, as the triangulation has it from its first side.
  struct Found_facet
  {
    std::array<int, 3> key;         // its vertices, sorted
    Boundary_facet of_boundary;
    Facet facet;
  };

  const Complex_snapshot_3& snapshot;
  const Vertex_numbering_3& numbering;
  const Domain_view_3& domain;
  const Facet_bounds_3& bounds;
  bool boundary_moves;
  Thread_policy threads;
  Working_triangulation_3& working;
  std::vector<Site> sites;
  Exchangeable_boundary_3 boundary;
  Circumradius_bound_3 size_bound;              // of cells
  std::map<Triple, Complex_snapshot_3::Surface_center> centers;     // of facets that have come or moved, by sorted vertices

  // In the triangulation of the snapshot, with whose numbering that of the vertices begins. If `moves` is false, the boundary
  // stays. Threads share visits of all cells.
  Editable_complex_3(const Complex_snapshot_3& from, const Vertex_numbering_3& numbers, Working_triangulation_3& triangulation,
                     const Domain_view_3& d, const Facet_bounds_3& b, bool moves, const Thread_policy& policy)
    : snapshot(from)
    , numbering(numbers)
    , domain(d)
    , bounds(b)
    , boundary_moves(moves)
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

  // The label that the vertices off the boundary have; `unknown` if there are none, `mixed` if they have several.
  static constexpr int unknown = -2, mixed = -3;

  int label_of_vertices(const Quadruple& q) const
  {
    if(*std::min_element(q.begin(), q.end()) < 0)
      return Domain_view_3::outside;
    int label;
    if(!numbering.find_label(q, label))
      return mixed;
    return label == Vertex_numbering_3::no_subdomain ? unknown : label;
  }

  // Whether the snapshot does not have the vertex.
  bool is_inserted(int v) const { return v >= static_cast<int>(snapshot.sites.size()); }

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

  // The cell of the complex with these vertices, or none.
  Cell_handle find_cell(const Quadruple& q) const
  {
    Cell_handle c;
    const bool are_visible = std::all_of(q.begin(), q.end(), [this](int v) { return working.is_visible(v); });
    const auto vertex = [&](int i) { return working.vertex(q[i]); };
    return are_visible && triangulation().is_cell(vertex(0), vertex(1), vertex(2), vertex(3), c) && c->label() != Domain_view_3::outside
           ? c : Cell_handle();
  }

  // The slivers below a bound, the worst first, without cells that are kept.
  std::vector<Sliver_3> slivers(double bound) const
  {
    const std::vector<Cell_handle>& cells = working.cells();
    std::vector<Sliver_3> found = collect_in_chunks<Sliver_3>(static_cast<int>(cells.size()), threads,
                                                              [&](int n, std::vector<Sliver_3>& some)
    {
      if(cells[n]->label() != Domain_view_3::outside && !numbering.is_kept(numbers(cells[n])))
        add_sliver(cells[n], bound, some);
    });
    std::sort(found.begin(), found.end());
    return found;
  }

  // Adds a cell of the complex if it is one of them.
  void add_sliver(Cell_handle c, double bound, std::vector<Sliver_3>& found) const
  {
    const Quadruple q = numbers(c);
    double most = 0;
    const std::array<Site, 4> s = {{ sites[q[0]], sites[q[1]], sites[q[2]], sites[q[3]] }};
    Angle_deficit_3(bound).for_each_lack(s, [&most](double lack) { most = (std::max)(most, lack); });
    if(most > 0)
      found.push_back({ bound - most, sorted(q), c });
  }

  // Whether the sliver has not given way to other cells.
  bool has(const Sliver_3& s) const { return triangulation().tds().cells().is_used(s.cell) && sorted(numbers(s.cell)) == s.vertices; }

  // The boundary, in the order of its facets' vertices.
  std::vector<Found_facet> find_boundary() const
  {
    const std::vector<Cell_handle>& cells = working.cells();
    std::vector<Found_facet> found = collect_in_chunks<Found_facet>(static_cast<int>(cells.size()), threads,
                                                                    [&](int n, std::vector<Found_facet>& some)
    {
      cells[n]->clear_flags();
      // Of facets that have been on the boundary, cells around the vertices that moved know it still.
      cells[n]->clear_facets();
      find_facets(cells[n], some);
    });
    threads.sort(found.begin(), found.end(), [](const Found_facet& a, const Found_facet& b) { return a.key < b.key; });
    return found;
  }

  // Hands over cells and boundary to a candidate with the sites.
  void give(Complex_candidate_3& candidate) const
  {
    candidate.found_centers = centers;
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

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_EDITABLE_COMPLEX_3_H
