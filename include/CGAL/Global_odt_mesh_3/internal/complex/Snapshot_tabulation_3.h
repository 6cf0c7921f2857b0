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
#include <CGAL/Global_odt_mesh_3/internal/complex/Exact_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Working_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Index_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The label that a snapshot gives a cell with these vertices.
inline int label_of_cell(const Complex_snapshot_3& snapshot, const Quadruple& q)
{
  if(*std::min_element(q.begin(), q.end()) < 0)
    return Domain_view_3::outside;
  for(int v : q)
    if(!snapshot.numbering->is_on_boundary(v))
      return snapshot.numbering->subdomain[v];
  const int label = snapshot.label_of_boundary_cell(q);
  CGAL_assertion(label != Complex_snapshot_3::no_subdomain);
  return label;
}

// The boundary facets of a snapshot, by their numbers and on side 0, in its triangulation.
inline std::vector<Facet> find_boundary_facets(const Complex_snapshot_3& snapshot, const Working_triangulation_3& working,
                                               const Thread_policy& threads)
{
  const std::vector<Boundary_facet>& boundary = snapshot.boundary.complex().facets();
  std::vector<Facet> facets(boundary.size());
  const std::vector<Cell_handle>& cells = working.cells();
  for_each_in_chunks(static_cast<int>(cells.size()), threads, [&](int c)
  {
    snapshot.numbering->for_each_facet_on_boundary(Working_triangulation_3::numbers(cells[c]), [&](int i)
    {
      const Triple t = working.vertices(Facet(cells[c], i));
      const int n = snapshot.facet_number(t);
      if(n >= 0 && rotated(boundary[n].vertices) == t)
        facets[n] = Facet(cells[c], i);
    });
  });
  return facets;
}

// Makes the triangulation that of a snapshot, whatever has become of it. Symbolic perturbation makes
// the regular triangulation of weighted points unique; its cells are labelled, and boundary facets found, by their vertices.
inline void restore_triangulation(const Complex_snapshot_3& snapshot, const Thread_policy& threads,
                                  Working_triangulation_3& working)
{
  // The input is what it is, be it regular or not, so that its positions do not tell its cells.
  const Vertex_numbering_3& numbering = *snapshot.numbering;
  if(snapshot.is_input)
    working.copy(numbering.input->read(threads), numbering.input_numbers, threads);
  else if(!working.go_to(snapshot.sites))
    working.build(snapshot.sites);
  CGAL_assertion(working.is_complete());
  const std::vector<Cell_handle>& cells = working.cells();
  for_each_in_chunks(static_cast<int>(cells.size()), threads, [&](int n)
  {
    cells[n]->clear_flags();
    cells[n]->clear_facets();
    cells[n]->set_label(label_of_cell(snapshot, Working_triangulation_3::numbers(cells[n])));
  });
  const std::vector<Facet> facets = find_boundary_facets(snapshot, working, threads);
  for(std::size_t n = 0; n < facets.size(); ++n)
    mark_facet(snapshot.boundary.complex().facets()[n], facets[n], working);
}

// Completes a mesh whose topology is that of the snapshot.
inline void load_positions(const Complex_snapshot_3& snapshot, Moving_triangulation_3& mesh)
{
  mesh.sites = snapshot.sites;
  mesh.number_of_interior_vertices = snapshot.numbering->number_of_interior_vertices;
  mesh.number_of_movable_vertices = snapshot.numbering->number_of_movable_vertices;
}

// Loads the snapshot, whose triangulation is given, into a mesh: all cells that are in the complex, in canonical order; the
// boundary facets, and those of cells that are kept, are constrained.
inline void index_snapshot(const Complex_snapshot_3& snapshot, const Working_triangulation_3& working,
                           const Thread_policy& threads, Moving_triangulation_3& mesh)
{
  const auto number = [](Vertex_handle v) { return Working_triangulation_3::number(v); };
  const auto label = [](Cell_handle c) { return c->label(); };
  const auto stays = [&](Cell_handle c, int i)
  { return c->is_facet_in_complex(i) || snapshot.numbering->is_kept(Working_triangulation_3::numbers(c)); };
  index_triangulation_3(working.triangulation(), working.cells(), number, label, stays, threads, mesh.topology);
  load_positions(snapshot, mesh);
}

// Makes a snapshot the table to be written to the mesh from which the first one has come.
class Snapshot_tabulation_3
{
public:
  // The triangulation is that of the snapshot.
  Snapshot_tabulation_3(const Complex_snapshot_3& snapshot, Working_triangulation_3& working, const Thread_policy& threads)
    : snapshot_(snapshot)
    , numbering_(*snapshot.numbering)
    , working_(working)
    , threads_(threads)
    , cells_(working.cells())
    , facets_(find_boundary_facets(snapshot, working, threads))
  {}

  // Afterwards, cells have numbers in the place of their labels.
  Mesh_table_3 operator()()
  {
    restore_orders();
    Mesh_table_3 table;
    table.sites.resize(numbering_.number_in_table);
    table.dimensions.assign(numbering_.number_in_table, int(Mesh_table_3::removed));
    for(std::size_t v = 0; v < snapshot_.sites.size(); ++v)
    {
      table.sites[input_number(static_cast<int>(v))] = snapshot_.sites[v];
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

  // Of the vertices of cells that are in the same subdomain as in the input: on this order depends, by rounding, the dual
  // point of a flat cell, and hence whether the domain finds it in that subdomain.
  void restore_orders()
  {
    std::vector<Vertex_handle> opposite;
    for(const Facet& f : facets_)
      opposite.push_back(f.first->vertex(f.second));
    for(const auto& b : snapshot_.boundary_cells.entries())
    {
      const Vertex_numbering_3::Input_cell* const from = numbering_.input_cell(b.first, snapshot_.sites);
      if(from == nullptr)
        continue;
      std::array<Vertex_handle, 4> v;
      for(int i = 0; i < 4; ++i)
        v[i] = working_.vertex(from->vertices[i]);
      // An input from elsewhere may have inverted cells.
      Cell_handle to;
      if(working_.triangulation().is_cell(v[0], v[1], v[2], v[3], to) && to->label() == from->label
         && Working_triangulation_3::is_positive(v))
        reorder(to, v);
    }
    for(std::size_t n = 0; n < opposite.size(); ++n)
      facets_[n].second = facets_[n].first->index(opposite[n]);
  }

  static void reorder(Cell_handle c, const std::array<Vertex_handle, 4>& v)
  {
    std::array<Cell_handle, 4> neighbors;
    for(int i = 0; i < 4; ++i)
      neighbors[i] = c->neighbor(c->index(v[i]));
    for(int i = 0; i < 4; ++i)
    {
      c->set_vertex(i, v[i]);
      c->set_neighbor(i, neighbors[i]);
    }
  }

  // Of the cells in the complex around each vertex.
  void measure_circumradii(Mesh_table_3& table) const
  {
    constexpr int least_length = 10000, most_chunks = 16;
    const Chunks chunks(static_cast<int>(cells_.size()), least_length, most_chunks);
    Chunked_sums<Circumradii> circumradii;
    circumradii.resize(snapshot_.sites.size(), chunks.number());
    threads_.for_each_chunk(chunks.number(), [&](int k)
    {
      for(int n = chunks.begin(k); n < chunks.end(k); ++n)
        if(cells_[n]->label() != Domain_view_3::outside)
          add_circumradius(cells_[n], circumradii.part(k));
    });
    table.mean_circumradii.assign(numbering_.number_in_table, 0);
    circumradii.for_each_sum(0, circumradii.number_of_blocks(), [&](int v, const Circumradii& r)
    {
      if(r.number > 0)
        table.mean_circumradii[input_number(v)] = r.sum / r.number;
    });
  }

  void add_circumradius(Cell_handle c, const Chunked_sums<Circumradii>::Part& sums) const
  {
    const Vector_3 p = coordinates(working_.triangulation().dual(c));
    for(int v : Working_triangulation_3::numbers(c))
      sums.add(v, { std::sqrt(squared_distance(snapshot_.sites[v], p)), 1 });
  }

  // All that is asked for of cells afterwards is their places, which they have instead of labels.
  void tabulate_cells(Mesh_table_3& table) const
  {
    table.cells.resize(cells_.size());
    for_each_in_chunks(static_cast<int>(cells_.size()), threads_, [&](int n)
    {
      table.cells[n].label = cells_[n]->label();
      cells_[n]->set_label(n);
    });
    for_each_in_chunks(static_cast<int>(cells_.size()), threads_, [&](int n)
    {
      const Quadruple v = Working_triangulation_3::numbers(cells_[n]);
      table.cells[n].is_kept = numbering_.is_kept(v);
      for(int i = 0; i < 4; ++i)
      {
        table.cells[n].vertices[i] = input_number(v[i]);
        table.cells[n].neighbors[i] = cells_[n]->neighbor(i)->label();
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
      table.facets.push_back({ facets_[n].first->label(), facets_[n].second, patch, c.source, c.point, patch_of_center });
    }
  }

  const Complex_snapshot_3& snapshot_;
  const Vertex_numbering_3& numbering_;
  Working_triangulation_3& working_;
  const Thread_policy threads_;
  const std::vector<Cell_handle>& cells_;
  std::vector<Facet> facets_;                 // on the boundary, on side 0
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SNAPSHOT_TABULATION_3_H
