// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_FUSED_PASS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_FUSED_PASS_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/energy/Odt_cell_energies_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Energy, gradient, orientation of the cells and regularity of the facets of a whole mesh in one pass. To test facets in every
// second or third pass of a search only saves nothing: more has to be repaired then. Four cells at once, with AVX, take 8 %
// of the time of a call off on a ball, and 2 to 4 % on parts and images.
//
// Chunks of cells have sums and lists of their own, which are put together in the order of the chunks:
// the result is the same, bit for bit, for any number of threads.
class Fused_pass_3
{
public:
  typedef Chunked_sums<Site_gradient> Gradient;

  Fused_pass_3() {}

  // A copy has no use for the lists of chunks, which are made anew each time.
  Fused_pass_3(const Fused_pass_3&) {}
  Fused_pass_3& operator=(const Fused_pass_3&) { return *this; }

  // Gives the energy, which is a sum over cells: energy(t, cell, v, s) is that of one, given its products, its number and
  // those of its vertices. The gradient has a part more than there are chunks, the last, with nothing in it.
  template <class Energy>
  double run(const Constrained_triangulation_3& mesh, Energy energy, const Thread_policy& threads, Gradient& gradient)
  {
    const Chunks cells(mesh.topology.number_of_cell_slots(), least_cells, most_chunks);
    gradient.resize(mesh.sites.size(), cells.number() + 1);
    gradient.clear(cells.number());
    parts_.resize(cells.number());
    threads.for_each_chunk(cells.number(), [&](int n)
    {
      gradient.clear(n);
      parts_[n].clear();
      parts_[n].energy = add_cells(mesh, energy, 4 * cells.begin(n), 4 * cells.end(n), gradient.part(n), parts_[n]);
    });
    double sum = 0;
    for(const Part& p : parts_)
      sum += p.energy;
    return sum;
  }

  // The cells that are not positive, and slots of the facets that are not locally regular.
  void lists(std::vector<int>& inverted, std::vector<Half_facet>& irregular) const
  {
    inverted.clear();
    irregular.clear();
    for(const Part& p : parts_)
    {
      inverted.insert(inverted.end(), p.inverted.begin(), p.inverted.end());
      irregular.insert(irregular.end(), p.irregular.begin(), p.irregular.end());
    }
  }

private:
  // A chunk is to be worth the trouble of a thread, and vertices between chunks have several sums.
  static constexpr int least_cells = 12000, most_chunks = 16;

  // Facets are tested after some cells.
  static constexpr int slots_in_batch = 256;

  // What one chunk finds.
  struct Part
  {
    double energy = 0;
    std::vector<int> inverted;
    std::vector<Half_facet> irregular;

    void clear()
    {
      inverted.clear();
      irregular.clear();
    }
  };

  // The cells of these slots; gives the sum of their energies.
  template <class Energy>
  static double add_cells(const Constrained_triangulation_3& mesh, Energy energy, int first_slot, int end,
                          const Gradient::Part& gradient, Part& part)
  {
    std::array<Cell_sphere, slots_in_batch / 4> spheres;
    std::array<int, slots_in_batch> facets;
    double sum = 0;
    for(int begin = first_slot; begin < end; begin += slots_in_batch)
    {
      const int number_of_facets = add_batch(mesh, energy, begin, (std::min)(end, begin + slots_in_batch), gradient, part,
                                             spheres.data(), facets.data(), sum);
      test_facets(mesh, begin, spheres.data(), facets.data(), number_of_facets, part.irregular);
    }
    return sum;
  }

  // Gives the number of the facets that are to be tested. Which ones is as good as random, so that
  // branches on that would take longer than the tests.
  template <class Energy>
  static int add_batch(const Constrained_triangulation_3& mesh, Energy energy, int begin, int end,
                       Gradient::Part gradient, Part& part, Cell_sphere* spheres, int* facets, double& sum)
  {
    const int* const vertices = mesh.topology.cell_vertices();
    const int* const neighbors = mesh.topology.neighbors();
    const Site* const s = mesh.sites.data();
    int number_of_facets = 0;
    for(int slot = begin; slot < end; slot += 4)
    {
      const int* const v = vertices + slot;
      if(v[0] == Indexed_triangulation_3::no_vertex)
        continue;
      const Cell_products t(s[v[0]], s[v[1]], s[v[2]], s[v[3]]);
      const Cell_energy e = energy(t, slot / 4, v, s);
      sum += e.energy;
      for(int i = 0; i < 4; ++i)
        gradient.add(v[i], e.gradient[i]);
      if(mesh.is_inverted(t))
      {
        part.inverted.push_back(slot / 4);
        continue;
      }
      spheres[(slot - begin) / 4] = t;
      const int* const across = neighbors + slot;
      // Each facet is tested from its first slot.
      for(int i = 0; i < 4; ++i)
      {
        facets[number_of_facets] = slot + i;
        number_of_facets += across[i] > slot + i;
      }
    }
    return number_of_facets;
  }

  static void test_facets(const Constrained_triangulation_3& mesh, int begin, const Cell_sphere* spheres,
                          const int* facets, int number_of_facets, std::vector<Half_facet>& irregular)
  {
    const int* const vertices = mesh.topology.cell_vertices();
    const int* const neighbors = mesh.topology.neighbors();
    const Site* const s = mesh.sites.data();
    for(int n = 0; n < number_of_facets; ++n)
    {
      const int slot = facets[n];
      const Site& origin = s[vertices[slot & ~3]];
      const Site& q = s[vertices[neighbors[slot]]];
      const double power = spheres[(slot - begin) / 4].power(origin, q);
      if(power < 0 && mesh.is_irregular(power, mesh.squared_distance(origin, q)))
        irregular.push_back(Half_facet(slot));
    }
  }

  std::vector<Part> parts_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_FUSED_PASS_3_H
