// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_COMPLEX_SNAPSHOT_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_COMPLEX_SNAPSHOT_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Labelled_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/User_field_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The vertices of a complex, numbered along space-filling curves: first the interior vertices that move, then those that move on
// surfaces, then the others. All snapshots of the complex share the numbering.
struct Vertex_numbering_3
{
  static constexpr int no_subdomain = -1;

  // A cell of the input with all vertices on the boundary.
  struct Input_cell
  {
    Quadruple vertices;                     // in the order of the input
    int label;
  };

  Mesh_view_3* input = nullptr;
  std::vector<int> input_numbers;           // of vertices, in the table of the input
  std::vector<Site> input_sites;
  std::vector<int> dimensions;
  int first_inserted = 0;                   // in the table; these are not in the user's mesh
  int number_in_table = 0;                  // of vertices, including removed ones
  // A vertex without boundary facets belongs to one subdomain for good, and so do the cells around it.
  std::vector<int> subdomain;               // its label, or no_subdomain on the boundary
  Tuple_table<Quadruple, Input_cell> input_boundary_cells;
  Tuple_table<std::array<int, 2>, int> feature_edges;       // with their curves; used if vertices may be inserted
  Tuple_table<Triple, int> kept_facets;     // kept in all snapshots, whatever their cells
  Tuple_table<Quadruple, int> kept_cells;   // kept in all snapshots, with their facets; numbered
  int number_of_interior_vertices = 0;
  int number_of_movable_vertices = 0;

  int number_of_vertices() const { return static_cast<int>(input_sites.size()); }
  int number_of_surface_vertices() const { return number_of_movable_vertices - number_of_interior_vertices; }
  bool is_movable(int v) const { return v < number_of_movable_vertices; }
  bool is_interior(int v) const { return v < number_of_interior_vertices; }
  bool is_on_boundary(int v) const { return subdomain[v] == no_subdomain; }
  Vertex_stratum stratum(int v) const
  {
    const bool is_inserted = input_numbers[v] >= first_inserted;
    return { is_inserted ? -1 : input_numbers[v], dimensions[v],
             !is_inserted ? 0 : dimensions[v] == 3 ? subdomain[v] : input_patch(v) };
  }

  // The patch of a vertex of dimension 2 in the input.
  int input_patch(int v) const { return input->patch(input_numbers[v]); }

  // Whether the input fixes the vertex. Others may stay, too, because of what is around them.
  bool is_fixed(int v) const { return input->is_fixed(input_numbers[v]); }

  bool is_kept(const Triple& t) const { return !kept_facets.entries().empty() && kept_facets.find(sorted(t)) != nullptr; }
  bool is_kept(const Quadruple& q) const { return !kept_cells.entries().empty() && kept_cells.find(sorted(q)) != nullptr; }

  // Calls f(i) for the facets of a cell that have all vertices on the boundary.
  template <class F>
  void for_each_facet_on_boundary(const Quadruple& q, const F& f) const
  {
    const auto is_off_boundary = [this](int v) { return v < 0 || !is_on_boundary(v); };
    const auto off_boundary = std::count_if(q.begin(), q.end(), is_off_boundary);
    for(int i = 0; i < 4 && off_boundary <= 1; ++i)
      if(off_boundary == 0 || is_off_boundary(q[i]))
        f(i);
  }

  // Finds the common label of a cell's vertices off the boundary, or no_subdomain if there are none; false, with one of the labels,
  // if they have several. The infinite vertex is outside.
  bool find_label(const Quadruple& q, int& label) const
  {
    label = no_subdomain;
    for(int v : q)
    {
      const int l = v < 0 ? Domain_view_3::outside : subdomain[v];
      if(l == no_subdomain || l == label)
        continue;
      if(label != no_subdomain)
        return false;
      label = l;
    }
    return true;
  }

  // Whether the site is that of the vertex in the input.
  bool is_input_site(int v, const Site& s) const { return same_place(s, input_sites[v]); }

  // The numbering for a regular complex that takes the place of an invalid input: the sites are the new ones, and the labels of
  // boundary cells are dropped.
  Vertex_numbering_3 with_input_at(const std::vector<Site>& sites) const
  {
    Vertex_numbering_3 result = *this;
    result.input_sites = sites;
    result.input_boundary_cells = Tuple_table<Quadruple, Input_cell>();
    return result;
  }

  // Whether the vertices are where they were in the input.
  bool are_at_input(const Quadruple& q, const std::vector<Site>& sites) const
  {
    return std::all_of(q.begin(), q.end(), [&](int v) { return is_input_site(v, sites[v]); });
  }

  // The cell of the input that has these vertices, all on the boundary, at their sites, or null.
  const Input_cell* input_cell(const Quadruple& q, const std::vector<Site>& sites) const
  {
    const Input_cell* const c = input_boundary_cells.find(sorted(q));
    return c != nullptr && are_at_input(q, sites) ? c : nullptr;
  }
};

// A valid complex: the triangulation with the labels of its cells, the boundary, and its surface centers. Once made, it does not
// change.
struct Complex_snapshot_3
{
  static constexpr int no_subdomain = Vertex_numbering_3::no_subdomain;

  // The point of the surface on the dual line of a boundary facet.
  struct Surface_center
  {
    Vector_3 point;
    int patch = Boundary_facet::no_patch;     // that the point is on
    int source = Mesh_table_3::no_facet;      // the facet of the input with this center
    bool is_exact = false;          // on the surface; or else estimated from normals
    bool is_faithful = false;       // the facet's centroid is known to be close enough to the surface
  };

  std::shared_ptr<const Vertex_numbering_3> numbering;
  bool is_input = false;
  Labelled_triangulation_3 triangulation;
  Boundary_geometry_3 boundary;
  std::vector<Surface_center> centers;
  Tuple_table<Triple, int> facet_numbers;
  bool has_unseparating_facets = false;
  bool has_labels_of_domain = false;                // even for cells with all vertices on the boundary

  const std::vector<Site>& sites() const { return triangulation.sites(); }

  // Whether the vertices have these positions and weights.
  bool has_positions(const std::vector<Site>& positions) const
  {
    return std::equal(sites().begin(), sites().end(), positions.begin(), positions.end(),
                      [](const Site& a, const Site& b) { return same_place(a, b) && a.weight == b.weight; });
  }

  // Whether this is the input, and no vertex has moved since.
  bool is_untouched_at(const std::vector<Site>& positions) const { return is_input && has_positions(positions); }

  // The label of a cell, or no_subdomain if there is none.
  int label_of_cell(const Quadruple& cell) const
  {
    const int c = triangulation.find_cell(cell);
    return c < 0 ? int(no_subdomain) : triangulation.label(c);
  }

  // The number of the boundary facet with these vertices, or -1.
  int facet_number(const Triple& facet) const
  {
    const int* const number = facet_numbers.find(sorted(facet));
    return number == nullptr ? -1 : *number;
  }

  // Puts the boundary facets that have a patch into the complex, given their half-facets in the triangulation.
  void mark_facets(const std::vector<Half_facet>& facets)
  {
    for(std::size_t n = 0; n < facets.size(); ++n)
      if(boundary.complex().facets()[n].patch != Boundary_facet::no_patch)
        triangulation.put_in_complex(facets[n]);
  }

  // To be called once `boundary` is final.
  void number_facets()
  {
    const std::vector<Boundary_facet>& boundary_facets = boundary.complex().facets();
    facet_numbers.reserve(boundary_facets.size());
    for(std::size_t n = 0; n < boundary_facets.size(); ++n)
    {
      const Boundary_facet& f = boundary_facets[n];
      facet_numbers.insert(sorted(f.vertices), static_cast<int>(n));
      has_unseparating_facets = has_unseparating_facets || f.labels[0] == f.labels[1];
    }
  }
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_COMPLEX_SNAPSHOT_3_H
