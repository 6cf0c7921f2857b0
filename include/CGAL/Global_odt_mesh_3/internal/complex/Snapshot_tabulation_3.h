// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SNAPSHOT_TABULATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SNAPSHOT_TABULATION_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Index_cells_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Labelled_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Trial_predicates_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The boundary facets of a snapshot in its triangulation, by number and on side 0.
inline std::vector<Half_facet> find_boundary_facets(const Complex_snapshot_3& snapshot, const Thread_policy& threads)
{
  const Labelled_triangulation_3& triangulation = snapshot.triangulation;
  const std::vector<Boundary_facet>& boundary = snapshot.boundary.complex().facets();
  std::vector<Half_facet> facets(boundary.size());
  const std::vector<int>& cells = triangulation.cells();
  for_each_in_chunks(static_cast<int>(cells.size()), threads, [&](int c)
  {
    snapshot.numbering->for_each_facet_on_boundary(triangulation.vertices(cells[c]), [&](int i)
    {
      const Triple t = triangulation.facet_vertices(Half_facet(cells[c], i));
      const int n = snapshot.facet_number(t);
      if(n >= 0 && rotated(boundary[n].vertices) == t)
        facets[n] = Half_facet(cells[c], i);
    });
  });
  return facets;
}

// Loads the snapshot into a mesh: the cells of the complex in canonical order. Facets in the complex and those of kept cells are
// constrained.
inline void index_snapshot(const Complex_snapshot_3& snapshot, const Thread_policy& threads, Moving_triangulation_3& mesh)
{
  const Labelled_triangulation_3& tr = snapshot.triangulation;
  const auto stays = [&](Half_facet f) { return tr.is_in_complex(f) || snapshot.numbering->is_kept(tr.vertices(f.cell())); };
  index_cells(tr, stays, threads, mesh.topology);
  mesh.sites = snapshot.sites();
  mesh.number_of_interior_vertices = snapshot.numbering->number_of_interior_vertices;
  mesh.number_of_movable_vertices = snapshot.numbering->number_of_movable_vertices;
}

class Snapshot_tabulation_3
{
public:
  Snapshot_tabulation_3(Complex_snapshot_3 snapshot, const Thread_policy& threads)
    : snapshot_(std::move(snapshot))
    , numbering_(*snapshot_.numbering)
    , triangulation_(snapshot_.triangulation)
    , threads_(threads)
    , cells_(triangulation_.cells())
  {}

  Mesh_table_3 operator()()
  {
    restore_orders();
    facets_ = find_boundary_facets(snapshot_, threads_);
    Mesh_table_3 table;
    table.sites.resize(numbering_.number_in_table);
    table.dimensions.assign(numbering_.number_in_table, int(Mesh_table_3::removed));
    for(std::size_t v = 0; v < snapshot_.sites().size(); ++v)
    {
      table.sites[input_number(static_cast<int>(v))] = snapshot_.sites()[v];
      table.dimensions[input_number(static_cast<int>(v))] = numbering_.dimensions[v];
    }
    measure_circumradii(table);
    tabulate_cells(table);
    tabulate_facets(table);
    return table;
  }

private:
  struct Circumradii
  {
    double sum = 0, number = 0;

    Circumradii& operator+=(const Circumradii& o)
    {
      sum += o.sum;
      number += o.number;
      return *this;
    }
  };

  int input_number(int v) const { return v < 0 ? int(Mesh_table_3::infinite) : numbering_.input_numbers[v]; }

  // Restores the order of the vertices in cells that are in the same subdomain as in the input: by rounding, the dual point of a
  // flat cell depends on this order, and so does the subdomain in which the domain finds it.
  void restore_orders()
  {
    const Trial_predicates_3 predicates(triangulation_.sites());
    for(const auto& entry : numbering_.input_boundary_cells.entries())
    {
      const Vertex_numbering_3::Input_cell& from = entry.second;
      if(!numbering_.are_at_input(from.vertices, snapshot_.sites()))
        continue;
      // The input need not be regular, and may have inverted cells.
      const int to = triangulation_.find_cell(from.vertices);
      if(to >= 0 && triangulation_.label(to) == from.label && predicates.is_positive(from.vertices))
        triangulation_.reorder(to, from.vertices);
    }
  }

  // Measures the mean circumradius of the complex's cells around each vertex.
  void measure_circumradii(Mesh_table_3& table) const
  {
    constexpr int least_length = 10000, most_chunks = 16;
    const Chunks chunks(static_cast<int>(cells_.size()), least_length, most_chunks);
    Chunked_sums<Circumradii> circumradii;
    circumradii.resize(snapshot_.sites().size(), chunks.number());
    threads_.for_each_chunk(chunks.number(), [&](int k)
    {
      for(int n = chunks.begin(k); n < chunks.end(k); ++n)
        if(triangulation_.label(cells_[n]) != Domain_view_3::outside)
          add_circumradius(cells_[n], circumradii.part(k));
    });
    table.mean_circumradii.assign(numbering_.number_in_table, 0);
    circumradii.for_each_sum(0, circumradii.number_of_blocks(), [&](int v, const Circumradii& r)
    {
      if(r.number > 0)
        table.mean_circumradii[input_number(v)] = r.sum / r.number;
    });
  }

  void add_circumradius(int c, const Chunked_sums<Circumradii>::Part& sums) const
  {
    const Vector_3 p = triangulation_.dual_point(c);
    for(int v : triangulation_.vertices(c))
      sums.add(v, { std::sqrt(squared_distance(snapshot_.sites()[v], p)), 1 });
  }

  // In the table, cells are numbered without gaps.
  void tabulate_cells(Mesh_table_3& table)
  {
    places_.assign(cells_.empty() ? 0 : cells_.back() + 1, -1);
    for(std::size_t n = 0; n < cells_.size(); ++n)
      places_[cells_[n]] = static_cast<int>(n);
    table.cells.resize(cells_.size());
    for_each_in_chunks(static_cast<int>(cells_.size()), threads_, [&](int n)
    {
      const Quadruple& v = triangulation_.vertices(cells_[n]);
      table.cells[n].label = triangulation_.label(cells_[n]);
      table.cells[n].is_kept = numbering_.is_kept(v);
      for(int i = 0; i < 4; ++i)
      {
        table.cells[n].vertices[i] = input_number(v[i]);
        table.cells[n].kept_facets |= int(numbering_.is_kept(facet_vertices(v, i))) << i;
        table.cells[n].neighbors[i] = places_[triangulation_.neighbor(cells_[n], i)];
      }
    });
  }

  void tabulate_facets(Mesh_table_3& table) const
  {
    for(std::size_t n = 0; n < facets_.size(); ++n)
    {
      const int patch = snapshot_.boundary.complex().facets()[n].patch;
      if(patch == Boundary_facet::no_patch)
        continue;
      const Complex_snapshot_3::Surface_center& c = snapshot_.centers[n];
      const int patch_of_center = c.patch < 0 || c.patch == Domain_view_3::other_patch ? patch : c.patch;
      table.facets.push_back({ places_[facets_[n].cell()], facets_[n].index(), patch, c.source, c.point, patch_of_center });
    }
  }

  Complex_snapshot_3 snapshot_;
  const Vertex_numbering_3& numbering_;
  Labelled_triangulation_3& triangulation_;
  const Thread_policy threads_;
  const std::vector<int>& cells_;
  std::vector<int> places_;                   // of cells, in the table
  std::vector<Half_facet> facets_;            // on the boundary, on side 0
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SNAPSHOT_TABULATION_3_H
