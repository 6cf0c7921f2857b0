// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_FUSED_PASS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_FUSED_PASS_3_H

#include <CGAL/Global_odt_mesh_3/internal/energy/Odt_energy_3.h>
#include <CGAL/Global_odt_mesh_3/internal/energy/Partial_gradient.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_products_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunks.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flat_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Slot.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Energy, gradient, orientation of the cells and regularity of the facets of a whole mesh in one pass.
//
// For threads, chunks of cells have sums and lists of their own, which are put together in the order of the chunks:
// the result is the same, bit for bit, for any number of threads. Where there are never more than one, the
// cells are one chunk, as private sums take time; that may differ by rounding.
class Fused_pass_3
{
public:
  Fused_pass_3() {}

  // A copy has no use for the sums of chunks, which are made anew each time.
  Fused_pass_3(const Fused_pass_3&) {}
  Fused_pass_3& operator=(const Fused_pass_3&) { return *this; }

  // The quadrature is that of the mesh, by its type as far as that is faster, or null.
  template <class Quadrature>
  static Cell_energy cell_energy(const Cell_products& t, int cell, const int* v, const Site* s, Quadrature quadrature)
  {
    if constexpr (std::is_same_v<Quadrature, std::nullptr_t>)
      return uniform_odt_energy(t, s[v[0]], s[v[1]], s[v[2]], s[v[3]]);
    else
      return odt_energy(t, s[v[0]], s[v[1]], s[v[2]], s[v[3]], quadrature->moments(cell, v, s));
  }

  // Gives the energy.
  template <class Quadrature>
  double run(const Constrained_triangulation_3& mesh, Quadrature quadrature, const Thread_policy& threads,
             std::vector<Site_gradient>& gradient)
  {
    const Chunks cells(mesh.topology.number_of_cell_slots(), least_cells, threads.is_parallel() ? most_chunks : 1);
    if(cells.number() == 1)
      return run_in_one_piece(mesh, quadrature, gradient);
    const Chunks pages(Partial_gradient::number_of_pages(mesh.sites.size()), least_pages, most_chunks);
    parts_.resize(cells.number());
    gradient.resize(mesh.sites.size());
    page_owners_.resize(Partial_gradient::number_of_pages(mesh.sites.size()));
    const auto for_each = [&threads](const Chunks& chunks, const auto& f)
    {
      threads.for_each_chunk(chunks.number(), [&](int n) { f(n, chunks.begin(n), chunks.end(n)); });
    };
    for_each(pages, [&](int, int first, int end) { prepare_pages(mesh.topology, cells, first, end, gradient); });
    for_each(cells, [&](int n, int first, int end)
    {
      parts_[n].start(n, page_owners_, gradient);
      parts_[n].energy = add_cells(mesh, quadrature, 4 * first, 4 * end, parts_[n].gradient, parts_[n]);
    });
    for_each(pages, [&](int, int first, int end)
    {
      for(const Part& p : parts_)
        p.gradient.add_borrowed_pages(first, end, gradient);
    });
    double energy = 0;
    for(const Part& p : parts_)
      energy += p.energy;
    return energy;
  }

  // The cells that are not positive, slots of the facets that are not locally regular, and vertices of the interior
  // that push dual points through the surface.
  void lists(std::vector<int>& inverted, std::vector<Slot>& irregular, std::vector<int>& intruders) const
  {
    inverted.clear();
    irregular.clear();
    intruders.clear();
    for(const Part& p : parts_)
    {
      inverted.insert(inverted.end(), p.inverted.begin(), p.inverted.end());
      irregular.insert(irregular.end(), p.irregular.begin(), p.irregular.end());
      intruders.insert(intruders.end(), p.intruders.begin(), p.intruders.end());
    }
  }

private:
  // A chunk is to be worth the trouble of a thread.
  static constexpr int least_cells = 10000, least_pages = 256, most_chunks = 16;

  // What one chunk adds.
  struct Part
  {
    double energy = 0;
    Partial_gradient gradient;
    std::vector<int> inverted, intruders;
    std::vector<Slot> irregular;

    void start(int chunk, const std::vector<int>& page_owners, std::vector<Site_gradient>& sum)
    {
      gradient.start(chunk, page_owners, sum);
      clear_lists();
    }

    void clear_lists()
    {
      inverted.clear();
      intruders.clear();
      irregular.clear();
    }
  };

  // As Partial_gradient, where nobody else adds anything.
  struct Whole_gradient
  {
    Site_gradient* gradient;
    Site_gradient& at(int v) const { return gradient[v]; }
  };

  template <class Quadrature>
  double run_in_one_piece(const Constrained_triangulation_3& mesh, Quadrature quadrature, std::vector<Site_gradient>& gradient)
  {
    gradient.assign(mesh.sites.size(), Site_gradient{ 0, 0, 0, 0 });
    parts_.resize(1);
    parts_[0].clear_lists();
    Whole_gradient whole = { gradient.data() };
    return add_cells(mesh, quadrature, 0, mesh.topology.number_of_slots(), whole, parts_[0]);
  }

  // The cells of these slots; gives their energy. Each facet is tested from its first slot.
  template <class Quadrature, class Gradient>
  static double add_cells(const Constrained_triangulation_3& mesh, Quadrature quadrature, int first_slot, int end,
                          Gradient& sum, Part& part)
  {
    const int* const vertices = mesh.topology.cell_vertices();
    const int* const neighbors = mesh.topology.neighbors();
    const Site* const s = mesh.sites.data();
    double energy = 0;
    for(int slot = first_slot; slot < end; slot += 4)
    {
      const int* const v = vertices + slot;
      if(v[0] == Flat_triangulation_3::no_vertex)
        continue;
      // Pages that are opened here do not interrupt what follows.
      Site_gradient* const gradient[4] = { &sum.at(v[0]), &sum.at(v[1]), &sum.at(v[2]), &sum.at(v[3]) };
      const Site& origin = s[v[0]];
      const Cell_products t(origin, s[v[1]], s[v[2]], s[v[3]]);
      const Cell_energy e = cell_energy(t, slot / 4, v, s, quadrature);
      energy += e.energy;
      for(int i = 0; i < 4; ++i)
        *gradient[i] += e.gradient[i];
      if(!(t.determinant > 0))
      {
        part.inverted.push_back(slot / 4);
        continue;
      }
      for(int i = 0; i < 4; ++i)
      {
        const int across = neighbors[slot + i];
        if(across > slot + i)
        {
          const Site& q = s[vertices[across]];
          const double power = t.power(origin, q);
          if(power < 0 && mesh.is_irregular(power, mesh.squared_distance(origin, q)))
            part.irregular.push_back(Slot(slot + i));
        }
        else if(across < 0 && v[i] < mesh.number_of_interior_vertices && mesh.is_beyond_surface(t, v, i, Slot(across)))
          part.intruders.push_back(v[i]);
      }
    }
    return energy;
  }

  // The owner of a page is the chunk of a cell of its first vertex. Nothing depends on it but how much is borrowed and
  // the order of sums.
  void prepare_pages(const Flat_triangulation_3& topology, const Chunks& cells, int first, int end,
                     std::vector<Site_gradient>& gradient)
  {
    for(int p = first; p < end; ++p)
      page_owners_[p] = cells.chunk((std::max)(0, topology.incident_cell(p * Partial_gradient::page_length)));
    const auto begin = gradient.begin(), last = gradient.end();
    const auto place = [&](int p)
    {
      return begin + (std::min)(last - begin, std::ptrdiff_t(p) * Partial_gradient::page_length);
    };
    std::fill(place(first), place(end), Site_gradient{ 0, 0, 0, 0 });
  }

  std::vector<int> page_owners_;
  std::vector<Part> parts_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_FUSED_PASS_3_H
