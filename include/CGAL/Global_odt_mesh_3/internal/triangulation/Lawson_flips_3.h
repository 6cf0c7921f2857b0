// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_LAWSON_FLIPS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_LAWSON_FLIPS_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_products_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flips_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Half_facet.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Lawson's algorithm: makes a constrained triangulation regular, from the facets in
// `irregular` on, which is empty in the end. Facets that no flip can remove wait until flips
// nearby have changed their surroundings.
//
// `flips` makes the flips in the triangulation, as the functions of Flips_3.h do, and keeps the
// books that its owner wants. It is asked before whether it permits them.
template <class Flips>
class Lawson_flips_3
{
public:
  Lawson_flips_3(const Constrained_triangulation_3& mesh, Flips& flips, std::vector<Half_facet>& irregular)
    : mesh_(mesh)
    , flips_(flips)
    , irregular_(irregular)
  {}

  // False if facets are left because a flip is not permitted or there were too many flips: each lowers the lifted surface,
  // so that only rounding can make them go on.
  bool make_regular()
  {
    std::size_t budget = 1000 + 40 * irregular_.size();
    std::vector<Half_facet> waiting;
    for(bool has_flipped = true; has_flipped; irregular_.swap(waiting))
    {
      has_flipped = false;
      for( ; !irregular_.empty(); --budget)
      {
        if(budget == 0)
          return give_up();
        const Half_facet s = irregular_.back();
        irregular_.pop_back();
        if(!is_irregular(s))
          continue;
        if(remove_facet(s))
          has_flipped = true;
        else if(is_refused_)
          return give_up();
        else
          waiting.push_back(s);
      }
    }
    irregular_.clear();
    return true;
  }

private:
  bool give_up()
  {
    irregular_.clear();
    return false;
  }

  bool is_irregular(Half_facet s)
  {
    const int c = s.cell();
    if(!mesh_.topology.is_alive(c))
      return false;
    const Half_facet across = mesh_.topology.neighbor(s);
    if(across.is_side())
      return false;
    const int origin = mesh_.topology.vertex(Half_facet(c, 0)), q = mesh_.topology.vertex(across);
    const Cell_products t = mesh_.products(c);
    determinant_ = t.determinant;
    return mesh_.is_irregular(t.power(mesh_.sites[origin], mesh_.sites[q]), mesh_.squared_distance(origin, q));
  }

  // By a flip, if there is one. The facets between the cells that it makes are regular.
  bool remove_facet(Half_facet s)
  {
    const double volume = determinant_ + mesh_.products(mesh_.topology.neighbor(s).cell()).determinant;
    const std::array<double, 3> after = mesh_.volumes_after_2_3(s);
    const double flat = 1e-12 * volume;
    const int k = static_cast<int>(std::min_element(after.begin(), after.end()) - after.begin());
    if(after[k] > flat)
    {
      if(!is_permitted(flips_.permits_2_3(s)))
        return false;
      for(int c : flips_.flip_2_3(s))
        for(int i : outer_facets_2_3)
          mesh_.push_facet(Half_facet(c, i), irregular_);
      return true;
    }
    // The edge across from the k-th vertex of the facet is reflex.
    if(after[(k + 1) % 3] <= flat || after[(k + 2) % 3] <= flat)
      return false;
    const std::array<int, 3>& f = facet_indices(s.index());
    const std::optional<Edge_ring_3> ring
      = ring_of_degree_3(mesh_.topology, s.cell(), f[(k + 1) % 3], f[(k + 2) % 3]);
    if(!ring || !is_permitted(flips_.permits_3_2(*ring)))
      return false;
    for(int c : flips_.flip_3_2(*ring))
      for(int i : outer_facets_3_2)
        mesh_.push_facet(Half_facet(c, i), irregular_);
    return true;
  }

  bool is_permitted(bool permits)
  {
    is_refused_ = !permits;
    return permits;
  }

  const Constrained_triangulation_3& mesh_;
  Flips& flips_;
  std::vector<Half_facet>& irregular_;
  bool is_refused_ = false;
  double determinant_ = 0;        // of the cell of the facet that was last looked at
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_LAWSON_FLIPS_3_H
