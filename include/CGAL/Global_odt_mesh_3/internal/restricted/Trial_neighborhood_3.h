// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_TRIAL_NEIGHBORHOOD_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_TRIAL_NEIGHBORHOOD_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Exchangeable_boundary_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Lengths of edges at a vertex of a complex, and the direction of its surface, on a patch. Sums are rounded the same way
// whatever the order of cells and facets.
struct Trial_neighborhood_3
{
  double mean_edge = 0;                                                       // of all
  double shortest_edge = (std::numeric_limits<double>::infinity)();           // on the boundary
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();                           // zero if there is no facet of the patch

  Trial_neighborhood_3() {}

  Trial_neighborhood_3(const Trial_complex_3& complex, int v, int patch)
  {
    const std::vector<Site>& sites = complex.sites;
    const auto distance = [&](int w) { return (position(sites[w]) - position(sites[v])).norm(); };
    std::vector<double> lengths;
    for(int w : complex.numbered.neighbors(v))
      lengths.push_back(distance(w));
    std::sort(lengths.begin(), lengths.end());
    mean_edge = std::accumulate(lengths.begin(), lengths.end(), 0.) / double(lengths.size());
    std::vector<Exchangeable_boundary_3::Facet> around;
    for(int n : complex.boundary.around(v))
      around.push_back(complex.boundary.facet(n));
    std::sort(around.begin(), around.end(), [](const auto& a, const auto& b) { return a.vertices < b.vertices; });
    for(const Exchangeable_boundary_3::Facet& facet : around)
    {
      const std::array<int, 3>& t = facet.vertices;
      const Eigen::Vector3d origin = position(sites[t[0]]);
      const Eigen::Vector3d area = (position(sites[t[1]]) - origin).cross(position(sites[t[2]]) - origin);
      if(facet.patch == patch)
        normal += area.dot(normal) < 0 ? Eigen::Vector3d(-area) : area;
      for(int w : t)
        if(w != v)
          shortest_edge = (std::min)(shortest_edge, distance(w));
    }
    normal.normalize();
  }
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_TRIAL_NEIGHBORHOOD_3_H
