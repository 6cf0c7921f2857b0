// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_C3T3_WRITER_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_C3T3_WRITER_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Point_coordinates.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_sums.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunks.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/For_each_in_chunks.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Numbered_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_state_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Triangulation_table_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/All_cells.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Writes a state to the c3t3 from which the first one has come.
//
// Vertices stay, with all that the c3t3 says of them: they get their points. Cells are new, in the memory of the old ones.
// Whatever may throw, as it takes memory, comes before the first change.
template <class C3t3, class Domain>
class C3t3_writer_3
{
public:
  typedef typename C3t3::Triangulation Triangulation;
  typedef Restricted_state_3<typename Domain::Triangulation> State;

  C3t3_writer_3(State state, const Domain& domain, const Thread_policy& threads = Thread_policy())
    : state_(std::move(state))
    , domain_(domain)
    , threads_(threads)
    , numbered_(std::move(state_.numbered))
  {}

  void write(C3t3& c3t3)
  {
    restore_orders();
    measure_circumradii();
    const std::vector<typename Triangulation::Weighted_point> points = state_.points(state_.sites);
    const Triangulation_table_3 table = take_triangulation();
    Triangulation& tr = c3t3.triangulation();
    std::vector<Cell_handle> cells = all_cells(tr);
    add_spare_cells(tr, table.number_of_cells(), cells);

    empty(c3t3, cells);
    renew_cells(tr, table.number_of_cells(), cells);
    table.connect(vertices(), cells, Thread_policy(), tr);
    for(std::size_t v = 0; v < points.size(); ++v)
      vertices()[v]->set_point(points[v]);
    // As CGAL's optimizers leave it there.
    circumradii_.for_each_sum(0, circumradii_.number_of_blocks(), [this](int v, const Circumradii& r)
    {
      if(r.number > 0)
        vertices()[v]->set_meshing_info(r.sum / r.number);
    });
    fill(c3t3, cells);
  }

private:
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Cell_handle Cell_handle;
  typedef typename Triangulation::Facet Facet;
  typedef Numbered_triangulation_3<typename Domain::Triangulation> Numbered_triangulation;
  typedef typename Numbered_triangulation::Vertex_handle Labelled_vertex;
  typedef typename Numbered_triangulation::Cell_handle Labelled_cell;

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

  // Of the c3t3, by number.
  const std::vector<Vertex_handle>& vertices() const { return state_.numbering->input_vertices; }

  // Of the vertices of cells that are in the same subdomain as in the input: on this order depends, by rounding, the dual
  // point of a flat cell, and hence whether the domain finds it in that subdomain.
  void restore_orders()
  {
    std::vector<Labelled_vertex> opposite;
    for(const auto& f : state_.facets)
      opposite.push_back(f.first->vertex(f.second));
    for(const auto& b : state_.boundary_cells.entries())
    {
      const Cell_handle from = state_.numbering->input_cell(b.first, state_.sites);
      if(from == Cell_handle())
        continue;
      std::array<Labelled_vertex, 4> v;
      for(int i = 0; i < 4; ++i)
        v[i] = numbered_->vertex(state_.numbering->input_number[from->vertex(i)]);
      Labelled_cell to;
      if(numbered_->triangulation().is_cell(v[0], v[1], v[2], v[3], to)
         && to->label() == domain_.known_label(from->subdomain_index()))
        reorder(to, v);
    }
    for(std::size_t n = 0; n < opposite.size(); ++n)
      state_.facets[n].second = state_.facets[n].first->index(opposite[n]);
  }

  static void reorder(Labelled_cell c, const std::array<Labelled_vertex, 4>& v)
  {
    std::array<Labelled_cell, 4> neighbors;
    for(int i = 0; i < 4; ++i)
      neighbors[i] = c->neighbor(c->index(v[i]));
    for(int i = 0; i < 4; ++i)
    {
      c->set_vertex(i, v[i]);
      c->set_neighbor(i, neighbors[i]);
    }
  }

  // Of the cells in the complex around each vertex.
  void measure_circumradii()
  {
    constexpr int least_length = 10000, most_chunks = 16;
    const std::vector<Labelled_cell>& cells = numbered_->cells();
    const Chunks chunks(static_cast<int>(cells.size()), least_length, most_chunks);
    circumradii_.resize(state_.sites.size(), chunks.number());
    threads_.for_each_chunk(chunks.number(), [&](int k)
    {
      for(int n = chunks.begin(k); n < chunks.end(k); ++n)
        if(cells[n]->label() != domain_.outside())
          add_circumradius(cells[n], circumradii_.part(k));
    });
  }

  void add_circumradius(Labelled_cell c, const typename Chunked_sums<Circumradii>::Part& sums) const
  {
    const Eigen::Vector3d p = coordinates(numbered_->triangulation().dual(c));
    for(int i = 0; i < 4; ++i)
    {
      const int v = Numbered_triangulation::number(c->vertex(i));
      sums.add(v, { std::sqrt(squared_distance(state_.sites[v], p)), 1 });
    }
  }

  // Keeps the labels of cells and the places of those of the boundary facets, but not the triangulation.
  Triangulation_table_3 take_triangulation()
  {
    const std::unique_ptr<Numbered_triangulation> numbered = std::move(numbered_);
    const std::vector<Labelled_cell>& cells = numbered->cells();
    labels_.resize(cells.size());
    for_each_in_chunks(static_cast<int>(cells.size()), threads_, [&](int n)
    {
      labels_[n] = cells[n]->label();
      cells[n]->set_label(n);               // as all that is asked for now is its place
    });
    const auto place = [](Labelled_cell c) { return c->label(); };
    for(const auto& f : state_.facets)
      facet_cells_.push_back(place(f.first));
    return Triangulation_table_3(numbered->triangulation(), cells, Numbered_triangulation::number, place, threads_);
  }

  // Until there are so many. One at least, as the first one may take memory for the container.
  static void add_spare_cells(Triangulation& tr, std::size_t number, std::vector<Cell_handle>& cells)
  {
    const std::size_t before = cells.size();
    cells.reserve((std::max)(number, before + 1));
    try
    {
      do
        cells.push_back(tr.tds().create_cell());
      while(cells.size() < number);
    }
    catch(...)
    {
      for(std::size_t n = before; n < cells.size(); ++n)
        tr.tds().cells().erase(cells[n]);
      throw;
    }
  }

  // Takes all cells and facets out of the complex.
  static void empty(C3t3& c3t3, const std::vector<Cell_handle>& cells)
  {
    c3t3.clear_manifold_info();
    for(Cell_handle c : cells)
    {
      c3t3.remove_from_complex(c);
      for(int i = 0; i < 4; ++i)
        if(c->is_facet_on_surface(i))
          c3t3.remove_from_complex(c, i);
    }
  }

  // Erased in the opposite order, they come back in the same one.
  static void renew_cells(Triangulation& tr, std::size_t number, std::vector<Cell_handle>& cells)
  {
    std::for_each(cells.rbegin(), cells.rend(), [&tr](Cell_handle c) { tr.tds().cells().erase(c); });
    cells.resize(number);
    for(Cell_handle& c : cells)
      c = tr.tds().create_cell();
  }

  void fill(C3t3& c3t3, const std::vector<Cell_handle>& cells) const
  {
    for(std::size_t n = 0; n < cells.size(); ++n)
      if(labels_[n] != domain_.outside())
        c3t3.add_to_complex(cells[n], domain_.subdomain(labels_[n]));
    for(std::size_t n = 0; n < facet_cells_.size(); ++n)
    {
      const int patch = state_.boundary.complex().facets()[n].patch;
      if(patch == Boundary_facet::no_patch)
        continue;
      const Facet f(cells[facet_cells_[n]], state_.facets[n].second);
      c3t3.add_to_complex(f, domain_.patch(patch));
      for(const Facet& g : { f, c3t3.triangulation().mirror_facet(f) })
      {
        g.first->set_facet_surface_center(g.second, state_.centers[n].stored);
        g.first->set_facet_surface_center_index(g.second, state_.centers[n].index);
      }
    }
  }

  State state_;
  const Domain& domain_;
  const Thread_policy threads_;
  std::unique_ptr<Numbered_triangulation> numbered_;
  Chunked_sums<Circumradii> circumradii_;       // around vertices
  std::vector<int> labels_, facet_cells_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_C3T3_WRITER_3_H
