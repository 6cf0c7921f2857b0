// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SNAPSHOT_READER_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SNAPSHOT_READER_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Labelled_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Snapshot_tabulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Spatial_order.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Whether cells are clearly not those of a regular triangulation, as after a deformation; rounding errors do not count.
inline bool is_deformed(const Mesh_table_3& table, const Thread_policy& threads)
{
  constexpr double tolerance = 1e-6;
  const auto is_finite = [&](int n) { return index_of(table.cells[n].vertices, Mesh_table_3::infinite) == 4; };
  const auto find_wrong = [&](int n, std::vector<int>& wrong)
  {
    if(!is_finite(n))
      return;
    const Mesh_table_3::Cell& c = table.cells[n];
    const std::array<Site, 4> s = table.cell_sites(c.vertices);
    const Cell_products t(s[0], s[1], s[2], s[3]);
    bool is_wrong = t.determinant < -tolerance * t.cubed_length();
    for(int i = 0; i < 4 && !is_wrong; ++i)
      if(const int m = c.neighbors[i]; n < m && is_finite(m))
      {
        const Site& beyond = table.sites[table.cells[m].vertices[table.mirror_index(n, i)]];
        const double length = (std::max)((position(beyond) - position(s[0])).length(), std::cbrt(t.cubed_length()));
        is_wrong = t.power(s[0], beyond) < -tolerance * std::pow(length, 5);
      }
    if(is_wrong)
      wrong.push_back(n);
  };
  std::vector<int> cells(table.cells.size());
  std::iota(cells.begin(), cells.end(), 0);
  return !collect_in_chunks(static_cast<int>(table.cells.size()), threads, find_wrong).empty()
         || !are_connected(cells, [&](int c) { return table.cells[c].vertices; }, [&](int c, int i) { return table.cells[c].neighbors[i]; });
}

// Reads a mesh into a first snapshot, with its triangulation as it is, and into an indexed mesh.
class Snapshot_reader_3
{
public:
  explicit Snapshot_reader_3(Mesh_view_3& input, const Thread_policy& threads = Thread_policy())
    : threads_(threads)
    , table_(input.read(threads))
    , numbering_(std::make_shared<Vertex_numbering_3>())
  {
    snapshot_.numbering = numbering_;
    numbering_->input = &input;
    numbering_->number_in_table = static_cast<int>(table_.sites.size());
    numbering_->first_inserted = static_cast<int>(table_.sites.size() - table_.inserted.size());
    snapshot_.is_input = true;
  }

  const Mesh_table_3& table() const { return table_; }

  // Among the vertices that are not fixed, interior ones without boundary facets move; if `boundary_moves`, so do those that a
  // surface passes through smoothly.
  Complex_snapshot_3 read(Moving_triangulation_3& mesh, bool boundary_moves)
  {
    mesh = Moving_triangulation_3();
    mesh.set_threads(threads_);
    if(table_.cells.empty())
      return std::move(snapshot_);
    Labelled_triangulation_3& tr = snapshot_.triangulation;
    tr.copy(table_);
    // The cells and facets around the vertices tell which of them move.
    number_vertices(Boundary_complex_3(boundary(boundary_facets()), table_.sites.size(), threads_), boundary_moves);
    tr.renumber(numbers_, numbering_->input_sites);
    std::vector<Half_facet> facets = boundary_facets();
    threads_.sort(facets.begin(), facets.end(), [&tr](Half_facet f, Half_facet g)
                  { return sorted(tr.facet_vertices(f)) < sorted(tr.facet_vertices(g)); });
    snapshot_.boundary = Boundary_geometry_3(
      std::make_shared<const Boundary_complex_3>(boundary(facets), snapshot_.sites().size(), threads_), snapshot_.sites());
    snapshot_.number_facets();
    snapshot_.mark_facets(facets);
    read_surface_centers(facets);
    read_labels();
    read_kept_elements();
    index_snapshot(snapshot_, threads_, mesh);
    return std::move(snapshot_);
  }

private:
  const Mesh_table_3::Facet* on_surface(Half_facet f) const { return table_.facet(f.cell(), f.index()); }

  // The boundary facets, from their first sides under the present numbering of vertices.
  std::vector<Half_facet> boundary_facets() const
  {
    const Labelled_triangulation_3& tr = snapshot_.triangulation;
    return collect_in_chunks<Half_facet>(static_cast<int>(table_.cells.size()), threads_, [&](int c, std::vector<Half_facet>& found)
    {
      for(int i = 0; i < 4; ++i)
      {
        const Half_facet f(c, i), across = tr.mirror(f);
        const bool is_in_complex = (table_.cells[c].facets >> i & 1) || (table_.cells[across.cell()].facets >> across.index() & 1);
        if(tr.is_first_side(f) && (is_in_complex || tr.label(c) != tr.label(across.cell())))
          found.push_back(f);
      }
    });
  }

  std::vector<Boundary_facet> boundary(const std::vector<Half_facet>& facets) const
  {
    const Labelled_triangulation_3& tr = snapshot_.triangulation;
    std::vector<Boundary_facet> result;
    for(Half_facet f : facets)
    {
      const Mesh_table_3::Facet* const on_surface = this->on_surface(f);
      result.push_back({ tr.facet_vertices(f), {{ tr.label(f.cell()), tr.label(tr.mirror(f).cell()) }},
                         on_surface != nullptr ? on_surface->patch : int(Boundary_facet::no_patch) });
    }
    return result;
  }

  // Numbers the vertices along Hilbert curves: first the interior ones that move, then those that move on surfaces, then the rest.
  void number_vertices(const Boundary_complex_3& boundary, bool boundary_moves)
  {
    std::vector<char> is_inside(table_.sites.size(), false);
    for(const Mesh_table_3::Cell& c : table_.cells)
      for(int v : c.vertices)
        if(v != Mesh_table_3::infinite && c.label != Domain_view_3::outside)
          is_inside[v] = true;
    const auto may_move = [&](int v, int dimension) { return table_.dimensions[v] == dimension && !numbering_->input->is_fixed(v); };
    const auto is_interior = [&](std::size_t v)
    {
      const int n = static_cast<int>(v);
      return may_move(n, 3) && is_inside[n] && !boundary.has_facets(n);
    };
    const auto slides = [&](std::size_t v)
    {
      const int n = static_cast<int>(v);
      return may_move(n, 2) && boundary.number_of_umbrellas(n) == 1 && boundary.umbrella(n, 0).is_disk;
    };
    std::vector<std::size_t> order = hilbert_order(table_.sites);
    order.erase(std::remove_if(order.begin(), order.end(), [this](std::size_t v)
                               { return table_.dimensions[v] == Mesh_table_3::removed; }), order.end());
    const auto boundary_begin = std::stable_partition(order.begin(), order.end(), is_interior);
    const auto fixed_begin = boundary_moves ? std::stable_partition(boundary_begin, order.end(), slides)
                                            : boundary_begin;
    numbering_->number_of_interior_vertices = static_cast<int>(boundary_begin - order.begin());
    numbering_->number_of_movable_vertices = static_cast<int>(fixed_begin - order.begin());
    numbers_.assign(table_.sites.size(), -1);
    for(std::size_t n : order)
    {
      numbers_[n] = static_cast<int>(numbering_->input_sites.size());
      numbering_->input_numbers.push_back(static_cast<int>(n));
      numbering_->dimensions.push_back(table_.dimensions[n]);
      numbering_->input_sites.push_back(table_.sites[n]);
    }
  }

  // The surface centers of the user's mesh are written back for facets that stay, but are not used: files do not store them, and a
  // complex that was not made by Mesh_3 may lack them. A point of the dual line stands in.
  void read_surface_centers(const std::vector<Half_facet>& facets)
  {
    for(Half_facet f : facets)
    {
      const Mesh_table_3::Facet* const on_surface = this->on_surface(f);
      // A center found since the user's mesh was read is right, even if it is on another patch.
      const bool is_found = on_surface != nullptr && on_surface->source == Mesh_table_3::no_facet;
      const Vector_3 point = is_found ? on_surface->center
                                      : estimated_surface_center(snapshot_.triangulation.facet_vertices(f), snapshot_.boundary, snapshot_.sites());
      const int patch = is_found ? on_surface->patch_of_center
                                 : on_surface != nullptr ? on_surface->patch : int(Boundary_facet::no_patch);
      const int source = on_surface != nullptr ? on_surface->source : int(Mesh_table_3::no_facet);
      snapshot_.centers.push_back({ point, patch, source, true, true });
    }
  }

  void read_labels()
  {
    snapshot_.has_labels_of_domain = true;
    std::vector<int>& subdomain = numbering_->subdomain;
    subdomain.assign(snapshot_.sites().size(), int(Complex_snapshot_3::no_subdomain));
    const Labelled_triangulation_3& tr = snapshot_.triangulation;
    for(std::size_t n = 0; n < table_.cells.size(); ++n)
      for(int v : tr.vertices(static_cast<int>(n)))
        if(v >= 0 && !snapshot_.boundary.complex().has_facets(v))
          subdomain[v] = table_.cells[n].label;
    const auto find_boundary_cells = [&](int n, std::vector<int>& found)
    {
      const Quadruple& q = tr.vertices(n);
      if(std::all_of(q.begin(), q.end(), [this](int v) { return v >= 0 && numbering_->is_on_boundary(v); }))
        found.push_back(n);
    };
    for(int n : collect_in_chunks(static_cast<int>(table_.cells.size()), threads_, find_boundary_cells))
    {
      const Quadruple& q = tr.vertices(n);
      numbering_->input_boundary_cells.insert(sorted(q), { q, table_.cells[n].label });
    }
  }

  void read_kept_elements()
  {
    for(const Mesh_table_3::Feature_edge& e : table_.feature_edges)
      numbering_->feature_edges.insert(sorted(std::array<int, 2>{{ numbers_[e.vertices[0]], numbers_[e.vertices[1]] }}), e.curve);
    for(std::size_t n = 0; n < table_.cells.size(); ++n)
      for(int i = 0; i < 4; ++i)
        if(table_.cells[n].kept_facets >> i & 1)
          numbering_->kept_facets.insert(sorted(snapshot_.triangulation.facet_vertices(Half_facet(static_cast<int>(n), i))), 0);
    for(std::size_t n = 0; n < table_.cells.size(); ++n)
      if(table_.cells[n].is_kept)
        numbering_->kept_cells.insert(sorted(snapshot_.triangulation.vertices(static_cast<int>(n))), static_cast<int>(numbering_->kept_cells.entries().size()));
  }

  Thread_policy threads_;
  const Mesh_table_3 table_;
  std::vector<int> numbers_;                // by vertices of the table
  std::shared_ptr<Vertex_numbering_3> numbering_;
  Complex_snapshot_3 snapshot_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SNAPSHOT_READER_3_H
