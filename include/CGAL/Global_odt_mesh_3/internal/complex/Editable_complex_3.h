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
#include <CGAL/Global_odt_mesh_3/internal/complex/Labelled_triangulation_3.h>
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
  int cell;                         // its number, while it exists

  bool operator<(const Sliver_3& o) const { return angle != o.angle ? angle < o.angle : vertices < o.vertices; }
};

// A copy of a snapshot whose vertices can be moved one by one and to which vertices can be added. Cells know their labels, but only
// the boundary tells which facets are in the complex: what cells know of their facets may be out of date.
struct Editable_complex_3
{
  // A facet of the boundary, as the triangulation has it from its first side.
  struct Found_facet
  {
    std::array<int, 3> key;         // its vertices, sorted
    Boundary_facet of_boundary;
    Half_facet facet;
  };

  const Complex_snapshot_3& snapshot;
  const Vertex_numbering_3& numbering;
  const Domain_view_3& domain;
  const Facet_bounds_3& bounds;
  bool boundary_moves;
  Thread_policy threads;
  Labelled_triangulation_3 triangulation;
  const std::vector<Site>& sites;
  Exchangeable_boundary_3 boundary;
  Circumradius_bound_3 size_bound;              // of cells
  double share_of_facet_angles = 1;             // of the bound, which facets around inserted vertices need to have
  std::map<Triple, Complex_snapshot_3::Surface_center> centers;     // of new or moved facets, by sorted vertices

  // `numbers` begins with the numbering of the snapshot. If `moves` is false, the boundary stays. Threads share the visits of all
  // cells.
  Editable_complex_3(const Complex_snapshot_3& from, const Vertex_numbering_3& numbers, const Domain_view_3& d,
                     const Facet_bounds_3& b, bool moves, const Thread_policy& policy)
    : snapshot(from)
    , numbering(numbers)
    , domain(d)
    , bounds(b)
    , boundary_moves(moves)
    , threads(policy)
    , triangulation(from.triangulation)
    , sites(triangulation.sites())
    , boundary(from.boundary.complex())
  {}

  Editable_complex_3(const Editable_complex_3&) = delete;
  Editable_complex_3& operator=(const Editable_complex_3&) = delete;

  // The label of the vertices off the boundary; `unknown` if there are none, `mixed` if they have several labels.
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

  // Whether the vertex is new, that is, not in the snapshot.
  bool is_inserted(int v) const { return v >= static_cast<int>(snapshot.sites().size()); }

  // Whether the vertex may get another weight instead of moving, as vertices of a boundary at rest may; but not if the surface
  // centers are those of a domain.
  bool may_gain_weight(int v) const
  {
    return v >= 0 && !boundary_moves && domain.has_cells_of_mesh() && !is_inserted(v) && numbering.is_on_boundary(v)
           && triangulation.keeps_dimension_without(v);
  }

  // Adds a vertex that is not in the triangulation yet, and returns its number.
  int add_vertex(const Site& s)
  {
    triangulation.add_vertex(s);
    boundary.add_vertex();
    return static_cast<int>(sites.size()) - 1;
  }

  void remove_last_vertex()
  {
    triangulation.remove_last_vertex();
    boundary.remove_last_vertex();
  }

  bool is_inside(int c) const { return triangulation.label(c) != Domain_view_3::outside; }

  // The cell of the complex with these vertices, or none.
  int find_cell(const Quadruple& q) const
  {
    const int c = triangulation.find_cell(q);
    return c >= 0 && is_inside(c) ? c : int(Labelled_triangulation_3::no_cell);
  }

  // The slivers below a bound, the worst first, without kept cells.
  std::vector<Sliver_3> slivers(double bound) const
  {
    const std::vector<int>& cells = triangulation.cells();
    std::vector<Sliver_3> found = collect_in_chunks<Sliver_3>(static_cast<int>(cells.size()), threads,
                                                              [&](int n, std::vector<Sliver_3>& some)
    {
      if(is_inside(cells[n]) && !numbering.is_kept(triangulation.vertices(cells[n])))
        add_sliver(cells[n], bound, some);
    });
    std::sort(found.begin(), found.end());
    return found;
  }

  // Adds the cell if it has a dihedral angle below the bound.
  void add_sliver(int c, double bound, std::vector<Sliver_3>& found) const
  {
    double most = 0;
    Angle_deficit_3(bound).for_each_lack(triangulation.cell_sites(c), [&most](double lack) { most = (std::max)(most, lack); });
    if(most > 0)
      found.push_back({ bound - most, sorted(triangulation.vertices(c)), c });
  }

  // Whether the sliver still exists.
  bool has(const Sliver_3& s) const { return triangulation.is_cell(s.cell) && sorted(triangulation.vertices(s.cell)) == s.vertices; }

  // The boundary, in the order of its facets' vertices.
  std::vector<Found_facet> find_boundary()
  {
    const std::vector<int>& cells = triangulation.cells();
    std::vector<Found_facet> found = collect_in_chunks<Found_facet>(static_cast<int>(cells.size()), threads,
                                                                    [&](int n, std::vector<Found_facet>& some)
    {
      // Cells around moved vertices may still mark facets that have left the boundary.
      triangulation.clear_facets(cells[n]);
      find_facets(cells[n], some);
    });
    threads.sort(found.begin(), found.end(), [](const Found_facet& a, const Found_facet& b) { return a.key < b.key; });
    return found;
  }

  // Hands the cells and the boundary over to a candidate with the same sites.
  void give(Complex_candidate_3& candidate)
  {
    candidate.found_centers = centers;
    const std::vector<Found_facet> found = find_boundary();
    std::vector<Boundary_facet> facets;
    for(const Found_facet& f : found)
    {
      facets.push_back(f.of_boundary);
      candidate.facets.push_back(f.facet);
      candidate.old_facets.push_back(snapshot.facet_number(f.key));
    }
    candidate.boundary_complex = std::make_shared<const Boundary_complex_3>(std::move(facets), sites.size(), threads);
    candidate.triangulation = std::move(triangulation);
  }

private:
  // Finds the boundary facets whose first side is in this cell.
  void find_facets(int c, std::vector<Found_facet>& found) const
  {
    numbering.for_each_facet_on_boundary(triangulation.vertices(c), [&](int i) { find_facet(Half_facet(c, i), found); });
  }

  // Adds the facet if it is on the boundary and this is its first side.
  void find_facet(Half_facet f, std::vector<Found_facet>& found) const
  {
    if(!triangulation.is_first_side(f))
      return;
    Boundary_facet b;
    b.vertices = triangulation.facet_vertices(f);
    const std::array<int, 3> key = sorted(b.vertices);
    const int n = boundary.find(key);
    if(n < 0)
      return;
    b.labels = {{ triangulation.label(f.cell()), triangulation.label(triangulation.mirror(f).cell()) }};
    b.patch = boundary.facet(n).patch;
    found.push_back({ key, b, f });
  }
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_EDITABLE_COMPLEX_3_H
