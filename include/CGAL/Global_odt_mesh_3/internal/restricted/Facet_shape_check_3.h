// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_FACET_SHAPE_CHECK_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_FACET_SHAPE_CHECK_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_report_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The cosine of the smallest angle.
inline double largest_cosine(const std::array<int, 3>& facet, const std::vector<Site>& sites)
{
  double largest = -1;
  for(int k = 0; k < 3; ++k)
  {
    const Eigen::Vector3d apex = position(sites[facet[k]]);
    const Eigen::Vector3d a = position(sites[facet[(k + 1) % 3]]) - apex;
    const Eigen::Vector3d b = position(sites[facet[(k + 2) % 3]]) - apex;
    largest = (std::max)(largest, a.dot(b) / (a.norm() * b.norm()));
  }
  return largest;
}

// Keeps the angles of boundary facets from falling below the smallest one of the input, or below 30 degrees if that
// is less.
class Facet_shape_check_3
{
public:
  void measure(const Boundary_complex_3& input, const std::vector<Site>& sites)
  {
    for(const Boundary_facet& f : input.facets())
      largest_cosine_ = (std::max)(largest_cosine_, largest_cosine(f.vertices, sites));
  }

  // What angles may be, in degrees.
  double smallest_angle() const { return std::acos(largest_cosine_) * 180 / CGAL_PI; }

  // Whether these vertices may be those of a boundary facet.
  bool is_good(const std::array<int, 3>& facet, const std::vector<Site>& sites) const
  {
    return largest_cosine(facet, sites) <= largest_cosine_;
  }

  // Sends back vertices of facets that have become too thin.
  void check(const Restricted_candidate_3& candidate, Restricted_report_3& report) const
  {
    for(std::size_t n = 0; n < candidate.old_facets.size(); ++n)
    {
      const std::array<int, 3>& t = candidate.boundary_complex->facets()[n].vertices;
      if(!is_good(t, candidate.sites) && !(candidate.old_facets[n] >= 0 && candidate.are_home(t))
         && candidate.spared_facets.count(sorted(t)) == 0)
        report.send_back_around(t);
    }
  }

private:
  double largest_cosine_ = 0.8660254037844386;    // that of 30 degrees
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_FACET_SHAPE_CHECK_3_H
