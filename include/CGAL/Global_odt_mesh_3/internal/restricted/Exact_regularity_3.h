// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_EXACT_REGULARITY_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_EXACT_REGULARITY_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Regularity_filter_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Working_triangulation_3.h>

#include <CGAL/enum.h>

#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Exact tests of cells that are named by the numbers of their vertices. What rounded numbers
// prove is not asked again.
class Exact_regularity_3
{
public:
  Exact_regularity_3(const std::vector<Site>& sites, const Working_traits& traits)
    : sites_(sites)
    , traits_(traits)
  {}

  // The tests of one cell.
  class Cell
  {
  public:
    Cell(const Exact_regularity_3& tests, const int* vertices)
      : tests_(tests)
      , vertices_(vertices)
      , filter_(tests.sites_[vertices[0]], tests.sites_[vertices[1]], tests.sites_[vertices[2]], tests.sites_[vertices[3]])
    {}

    bool is_positive() const
    {
      if(filter_.is_positive())
        return true;
      const auto bare = tests_.traits_.construct_point_3_object();
      return tests_.traits_.orientation_3_object()(bare(point(0)), bare(point(1)), bare(point(2)), bare(point(3))) == POSITIVE;
    }

    // Whether the vertex is strictly outside of the sphere of the cell, which is positive.
    bool is_outside(int v) const
    {
      if(filter_.is_outside(tests_.sites_[v]))
        return true;
      return tests_.traits_.power_side_of_oriented_power_sphere_3_object()(point(0), point(1), point(2), point(3),
                                                                           weighted_point(tests_.sites_[v])) == ON_NEGATIVE_SIDE;
    }

  private:
    Weighted_point point(int i) const { return weighted_point(tests_.sites_[vertices_[i]]); }

    const Exact_regularity_3& tests_;
    const int* vertices_;
    Regularity_filter_3 filter_;
  };

private:
  const std::vector<Site>& sites_;
  const Working_traits& traits_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_EXACT_REGULARITY_3_H
