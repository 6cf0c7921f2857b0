// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_LAWSON_FLIPS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_LAWSON_FLIPS_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_products_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flat_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Lawson's algorithm: makes a constrained triangulation regular, from the facets (slots) in
// `irregular` on, which is empty in the end. Facets that no flip can remove wait until flips
// nearby have changed their surroundings.
//
// `flips` makes the flips in the triangulation, as Flat_triangulation_3 does, and keeps the
// books that its owner wants.
template <class Flips>
class Lawson_flips_3
{
public:
  Lawson_flips_3(const Constrained_triangulation_3& mesh, Flips& flips, std::vector<int>& irregular)
    : mesh_(mesh)
    , flips_(flips)
    , irregular_(irregular)
  {}

  void make_regular()
  {
    // Each flip lowers the lifted surface; the bound only guards against
    // rounding.
    std::size_t budget = 1000 + 40 * irregular_.size();
    std::vector<int> waiting;
    std::size_t flips = 0;
    for(;;)
    {
      while(!irregular_.empty() && budget-- > 0)
      {
        const int slot = irregular_.back();
        irregular_.pop_back();
        const int c = slot / 4;
        if(!mesh_.topology.is_alive(c))
          continue;
        const int across = mesh_.topology.neighbor(slot);
        if(Flat_triangulation_3::is_constrained(across))
          continue;
        const int origin = mesh_.topology.vertex(4 * c), q = mesh_.topology.vertex(across);
        const Cell_products t = mesh_.products(c);
        if(!mesh_.is_irregular(t.power(mesh_.sites[origin], mesh_.sites[q]), mesh_.squared_distance(origin, q)))
          continue;
        if(mend_facet(slot, t.determinant + mesh_.products(across / 4).determinant))
          ++flips;
        else
          waiting.push_back(slot);
      }
      irregular_.clear();
      if(flips == 0)
        return;
      irregular_.swap(waiting);
      flips = 0;
    }
  }

private:
  bool mend_facet(int slot, double volume)
  {
    const std::array<double, 3> after = mesh_.volumes_after_2_3(slot);
    const double flat = 1e-12 * volume;
    const int k = static_cast<int>(std::min_element(after.begin(), after.end()) - after.begin());
    if(after[k] > flat)
    {
      for(int c : flips_.flip_2_3(slot))
        mesh_.push_facets(c, irregular_);
      return true;
    }
    // The edge across from the k-th vertex of the facet is reflex.
    if(after[(k + 1) % 3] <= flat || after[(k + 2) % 3] <= flat)
      return false;
    const std::array<int, 3>& f = Flat_triangulation_3::facet_vertices(slot % 4);
    const int u = f[(k + 1) % 3], v = f[(k + 2) % 3];
    std::array<int, 3> ring;
    if(mesh_.topology.has_degree_3(slot / 4, u, v, ring))
    {
      for(int c : flips_.flip_3_2(ring))
        mesh_.push_facets(c, irregular_);
      return true;
    }
    return false;
  }

  const Constrained_triangulation_3& mesh_;
  Flips& flips_;
  std::vector<int>& irregular_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_LAWSON_FLIPS_3_H
