// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_BLOCKS_MESH_BLOCKS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_BLOCKS_MESH_BLOCKS_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/blocks/Mesh_partition_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The blocks of a partition as meshes of their own, which threads may load, change and store at the same time, and the mesh
// that is put together of what they have become.
//
// The vertices with all their cells in a block are its own, and move there as they do in the mesh; the others stay.
// Facets between blocks are constrained.
class Mesh_blocks_3
{
public:
  Mesh_blocks_3(Constrained_triangulation_3& mesh, const Mesh_partition_3& partition, const Thread_policy& threads)
    : mesh_(mesh)
    , partition_(partition)
    , threads_(threads)
    , cell_place_(places(partition.cells(), mesh.topology.number_of_cell_slots()))
    , vertex_place_(places(partition.vertices(), static_cast<int>(mesh.sites.size())))
    , blocks_(partition.number_of_blocks())
  {
    for(int v = 0; v < static_cast<int>(vertex_place_.size()); ++v)
      if(vertex_place_[v] < 0)
      {
        vertex_place_[v] = ~static_cast<int>(seam_vertices_.size());
        seam_vertices_.push_back(v);
      }
  }

  // The vertices of the mesh, in the order of the block: its own ones first.
  const std::vector<int>& vertices(int block) const { return blocks_[block].vertices; }

  int number_of_own_vertices(int block) const { return partition_.vertices().size(block); }

  // The place of a vertex of the block there, from when it is loaded to when it is stored.
  int number(int block, int v) const
  {
    const int place = vertex_place_[v];
    const int number = place >= 0 ? place - partition_.vertices().begin(block) : blocks_[block].number_at_seam[~place];
    CGAL_assertion(number >= 0 && vertices(block)[number] == v);
    return number;
  }

  void load(int block, Constrained_triangulation_3& part)
  {
    Block& b = blocks_[block];
    number_vertices(block, b);
    const auto own_end = b.vertices.begin() + partition_.vertices().size(block);
    const auto own_below = [&](int v) { return int(std::lower_bound(b.vertices.begin(), own_end, v) - b.vertices.begin()); };
    part.number_of_interior_vertices = own_below(mesh_.number_of_interior_vertices);
    part.number_of_movable_vertices = own_below(mesh_.number_of_movable_vertices);
    part.sites.clear();
    for(int v : b.vertices)
      part.sites.push_back(mesh_.sites[v]);
    load_cells(block, b, part);
  }

  void store(int block, Constrained_triangulation_3& part)
  {
    Block& b = blocks_[block];
    for(int v = 0; v < part.number_of_movable_vertices; ++v)
      mesh_.sites[b.vertices[v]] = part.sites[v];
    part.topology.compact();
    const std::size_t slots = part.topology.number_of_half_facets();
    b.cell_vertices.assign(part.topology.cell_vertices(), part.topology.cell_vertices() + slots);
    b.neighbors.assign(part.topology.neighbors(), part.topology.neighbors() + slots);
    for(int& v : b.cell_vertices)
      v = b.vertices[v];
    std::vector<int>().swap(b.number_at_seam);      // as long as all seams together
  }

  // When all blocks are stored.
  void assemble()
  {
    int cells = 0;
    for(Block& b : blocks_)
    {
      b.first_cell = cells;
      cells += static_cast<int>(b.neighbors.size() / 4);
    }
    std::vector<int> seam(mesh_.topology.number_of_half_facets());          // where slots at seams are now
    const std::size_t sides = mesh_.topology.number_of_sides();
    std::vector<int> cell_vertices, neighbors;
    mesh_.topology.take_memory(cell_vertices, neighbors);
    cell_vertices.resize(4 * std::size_t(cells));
    neighbors.resize(4 * std::size_t(cells));
    const int number = partition_.number_of_blocks();
    threads_.for_each_chunk(number, [&](int n) { assemble(n, cell_vertices, neighbors, seam); });
    threads_.for_each_chunk(number, [&](int n)
    {
      for(const Facet& f : blocks_[n].facets)
        if(f.is_seam())
          neighbors[seam[f.slot.id()]] = seam[f.beyond.id()];
    });
    mesh_.topology.assign(std::move(cell_vertices), std::move(neighbors), mesh_.sites.size(), sides);
  }

private:
  // A constrained one of the mesh, or one between blocks.
  struct Facet
  {
    int constrained_facet;      // or negative
    Half_facet slot, beyond;          // at a seam, of the mesh before

    bool is_seam() const { return constrained_facet < 0; }
  };

  struct Block
  {
    std::vector<int> vertices;                      // numbers in the mesh
    std::vector<int> number_at_seam;                // in the block, of each vertex at a seam
    std::vector<Facet> facets;                      // the constrained ones
    std::vector<int> cell_vertices;                 // numbers in the mesh
    std::vector<int> neighbors;                     // slots of the block
    int first_cell = 0;
  };

  // What is within the block.
  void assemble(int block, std::vector<int>& cell_vertices, std::vector<int>& neighbors, std::vector<int>& seam) const
  {
    const Block& b = blocks_[block];
    for(int s = 0; s < static_cast<int>(b.neighbors.size()); ++s)
    {
      const int slot = s + 4 * b.first_cell;
      cell_vertices[slot] = b.cell_vertices[s];
      const Half_facet across(b.neighbors[s]);
      if(!across.is_side())
      {
        neighbors[slot] = across.id() + 4 * b.first_cell;
        continue;
      }
      const Facet& f = b.facets[across.constrained_facet()];
      if(f.is_seam())
        seam[f.slot.id()] = slot;
      else
        neighbors[slot] = Half_facet::side(f.constrained_facet, across.side()).id();
    }
  }

  // The place of each number in the buckets, or -1.
  std::vector<int> places(const Buckets& buckets, int size) const
  {
    std::vector<int> place(size, -1);
    for_each_in_chunks(static_cast<int>(buckets.numbers().size()), threads_, [&](int n) { place[buckets.numbers()[n]] = n; });
    return place;
  }

  // The number of the cell in the block; it is negative or too large if the cell is not there.
  int cell_in_block(int block, int cell) const { return cell_place_[cell] - partition_.cells().begin(block); }
  bool is_in_block(int block, int cell) const
  {
    const int c = cell_in_block(block, cell);
    return c >= 0 && c < partition_.cells().size(block);
  }
  Half_facet slot_in_block(int block, Half_facet s) const { return Half_facet(cell_in_block(block, s.cell()), s.index()); }

  template <class F>
  void for_each_cell(int block, const F& f) const
  {
    const Buckets& cells = partition_.cells();
    for(int n = cells.begin(block); n < cells.end(block); ++n)
      f(cells.numbers()[n]);
  }

  // Vertices of its cells that are not its own are at seams.
  void number_vertices(int block, Block& b) const
  {
    const Buckets& own = partition_.vertices();
    b.vertices.assign(own.numbers().begin() + own.begin(block), own.numbers().begin() + own.end(block));
    b.number_at_seam.assign(seam_vertices_.size(), -1);
    for_each_cell(block, [&](int c)
    {
      for(int v : mesh_.topology.cell(c))
        if(vertex_place_[v] < 0)
          b.number_at_seam[~vertex_place_[v]] = 0;
    });
    for(std::size_t n = 0; n < seam_vertices_.size(); ++n)
      if(b.number_at_seam[n] == 0)
      {
        b.number_at_seam[n] = static_cast<int>(b.vertices.size());
        b.vertices.push_back(seam_vertices_[n]);
      }
  }

  void load_cells(int block, Block& b, Constrained_triangulation_3& part) const
  {
    std::vector<int> cell_vertices, neighbors(4 * std::size_t(partition_.cells().size(block)));
    cell_vertices.reserve(neighbors.size());
    b.facets.clear();
    for_each_cell(block, [&](int c)
    {
      for(int i = 0; i < 4; ++i)
      {
        cell_vertices.push_back(number(block, mesh_.topology.vertices(c)[i]));
        load_neighbor(block, Half_facet(c, i), b.facets, neighbors);
      }
    });
    part.topology.assign(std::move(cell_vertices), std::move(neighbors), b.vertices.size(), 2 * b.facets.size());
  }

  void load_neighbor(int block, Half_facet s, std::vector<Facet>& facets, std::vector<int>& neighbors) const
  {
    const Half_facet across = mesh_.topology.neighbor(s), here = slot_in_block(block, s);
    const int number = static_cast<int>(facets.size());
    if(!across.is_side())
    {
      if(is_in_block(block, across.cell()))
        neighbors[here.id()] = slot_in_block(block, across).id();
      else
      {
        neighbors[here.id()] = Half_facet::side(number, 0).id();
        facets.push_back({ -1, s, across });
      }
      return;
    }
    const Half_facet beyond = mesh_.topology.constrained_half_facet(across.other_side());
    const bool has_both = !beyond.is_none() && is_in_block(block, beyond.cell());
    if(has_both && slot_in_block(block, beyond) < here)
      return;
    neighbors[here.id()] = Half_facet::side(number, across.side()).id();
    if(has_both)
      neighbors[slot_in_block(block, beyond).id()] = Half_facet::side(number, across.other_side().side()).id();
    facets.push_back({ across.constrained_facet(), Half_facet(), Half_facet() });
  }

  Constrained_triangulation_3& mesh_;
  const Mesh_partition_3& partition_;
  Thread_policy threads_;
  std::vector<int> cell_place_, vertex_place_;      // in the order of blocks; of a vertex at a seam, ~n if it is the n-th one
  std::vector<int> seam_vertices_;
  std::vector<Block> blocks_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_BLOCKS_MESH_BLOCKS_3_H
