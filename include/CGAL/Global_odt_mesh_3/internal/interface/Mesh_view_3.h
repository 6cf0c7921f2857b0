// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_INTERFACE_MESH_VIEW_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_INTERFACE_MESH_VIEW_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/User_field_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// A complex in numbers: what is between the c3t3 of the user and the optimizer, both ways.
struct Mesh_table_3
{
  static constexpr int infinite = -1;           // the number of that vertex
  static constexpr int no_facet = -1;
  static constexpr int removed = -2;            // not -1, the dimension of CGAL's far points

  struct Cell
  {
    Quadruple vertices, neighbors;              // of which each is across the facet that is opposite to the vertex
    int label;                                  // of the subdomain, 0 outside
    int facets = 0;                             // bits of those in the complex; of the input
    int kept_facets = 0;                        // bits of those that the user wants to stay; their vertices are fixed
    bool is_kept = false;                       // because the user wants it so; its vertices are fixed
  };

  // A facet on a surface, seen from one of its cells.
  struct Facet
  {
    int cell, index;
    int patch;
    int source;                                 // the facet of the input whose center it still has, or no_facet
    Vector_3 center;                            // or else where its dual line meets the surface
    int patch_of_center;
  };

  struct Feature_edge
  {
    static constexpr int no_curve = -1;         // of one that is between protecting balls, and not in the complex

    std::array<int, 2> vertices;
    int curve;
  };

  std::vector<Site> sites;
  std::vector<int> dimensions;                  // of what vertices are on; of those that have been removed, `removed`
  std::vector<int> inserted;                    // of vertices that the user's mesh has not got, the last: curve, patch, or subdomain
  std::vector<double> mean_circumradii;         // of the cells in the complex around vertices, or 0; of an optimized mesh
  std::vector<Cell> cells;                      // all of the triangulation
  std::vector<Facet> facets;                    // those in the complex; of the input from both sides, by cell and index
  std::vector<Feature_edge> feature_edges;      // if vertices may be inserted

  Vertex_stratum stratum(int v) const
  {
    const std::size_t first_inserted = sites.size() - inserted.size(), n = v;
    return n < first_inserted ? Vertex_stratum{ v, dimensions[v], 0 } : Vertex_stratum{ -1, dimensions[v], inserted[n - first_inserted] };
  }

  std::array<Site, 4> cell_sites(const Quadruple& v) const { return {{ sites[v[0]], sites[v[1]], sites[v[2]], sites[v[3]] }}; }

  // The index of that facet of a cell in the neighbor across it.
  int mirror_index(int cell, int index) const
  {
    const Quadruple& back = cells[cells[cell].neighbors[index]].neighbors;
    return static_cast<int>(std::find(back.begin(), back.end(), cell) - back.begin());
  }

  // The facet of the input, or null.
  const Facet* facet(int cell, int index) const
  {
    if(!(cells[cell].facets & 1 << index))
      return nullptr;
    const auto precedes = [](const Facet& f, const std::pair<int, int>& key) { return std::make_pair(f.cell, f.index) < key; };
    const auto it = std::lower_bound(facets.begin(), facets.end(), std::make_pair(cell, index), precedes);
    return &*it;
  }
};

// Makes `tr` the triangulation of the table. Its infinite vertex, these finite ones, by their numbers, and these cells,
// by their places, are there already. Nothing throws.
template <class Triangulation>
void connect_cells(const Mesh_table_3& table, const std::vector<typename Triangulation::Vertex_handle>& vertices,
                   const std::vector<typename Triangulation::Cell_handle>& cells, Triangulation& tr)
{
  CGAL_precondition(cells.size() == table.cells.size());
  const auto vertex = [&](int v) { return v == Mesh_table_3::infinite ? tr.infinite_vertex() : vertices[v]; };
  for(std::size_t n = 0; n < cells.size(); ++n)
    for(int i = 0; i < 4; ++i)
    {
      const auto v = vertex(table.cells[n].vertices[i]);
      v->set_cell(cells[n]);
      cells[n]->set_vertex(i, v);
      cells[n]->set_neighbor(i, cells[table.cells[n].neighbors[i]]);
    }
  CGAL_expensive_assertion(tr.tds().is_valid());
}

// The cells of a triangulation, also infinite ones, in their order there, so that chunks of them can be visited.
template <class Triangulation>
std::vector<typename Triangulation::Cell_handle> all_cells(const Triangulation& tr)
{
  std::vector<typename Triangulation::Cell_handle> cells;
  cells.reserve(tr.tds().number_of_cells());
  for(auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
    cells.push_back(c);
  return cells;
}

// A mesh that is optimized. Vertices and facets are numbered as in its table, subdomains and patches as by the view of the
// domain.
class Mesh_view_3
{
public:
  virtual ~Mesh_view_3() {}

  // The same each time until something is written.
  virtual Mesh_table_3 read(const Thread_policy& threads) = 0;

  // The patch of a vertex of dimension 2.
  virtual int patch(int vertex) const = 0;

  // Whether a vertex stays, whatever surrounds it: on a feature or with a weight, or because the user wants it so.
  virtual bool is_fixed(int vertex) const = 0;

  // Writes a table of the same vertices, some of which are removed, and of those that have been inserted. If this throws, nothing
  // has changed.
  virtual void write(const Mesh_table_3& table) = 0;
};

// The mesh of the user, whatever its type.
class User_mesh_view_3
  : public Mesh_view_3
{
public:
  // How many cells of the complex have a dihedral angle below a bound, in degrees.
  virtual std::size_t number_of_slivers(double bound) const = 0;

  // By the numbers of vertices as they have been read.
  virtual std::vector<Mesh_table_3::Feature_edge> feature_edges() = 0;

  // Whether something has been written.
  virtual bool is_changed() const = 0;

  // Whether there are cells that are to stay.
  virtual bool keeps_cells() const { return false; }

  // Names cells that are to stay and cannot: they and their vertices may change as those that are selected.
  virtual void release(const std::vector<Quadruple>&) {}
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_INTERFACE_MESH_VIEW_3_H
