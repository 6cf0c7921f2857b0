// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_EMPTY_SPHERE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_EMPTY_SPHERE_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Defect_report_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The smallest of the spheres that pass through the vertices of a facet, orthogonally, from which those vertices around it that stay
// are far enough away or, if there is none, the one from which they are the farthest. Powers with respect to these spheres are linear
// along the dual line.
class Empty_sphere_3
{
public:
  Empty_sphere_3(const Complex_candidate_3& candidate, const Triple& facet)
    : facet_(facet)
    , sites_(candidate.sites)
    , dual_(facet, sites_)
    , squared_radius_(squared_distance(sites_[facet[0]], dual_.center) - sites_[facet[0]].weight)
  {
    constexpr int rings = 2;
    Vertex_rings_3 region(candidate.triangulation, facet);
    for(int ring = 0; ring < rings; ++ring)
      region.grow();
    std::copy_if(region.vertices().begin(), region.vertices().end(), std::back_inserter(around_), [&](int v)
                 { return !candidate.numbering.is_movable(v) && std::find(facet.begin(), facet.end(), v) == facet.end(); });
    if(!around_.empty() && power() < least_power())
      find_height();
  }

  Vector_3 center() const { return dual_.point_at(height_); }
  // Also if the facet is flat, and no such sphere exists.
  bool is_empty() const { return around_.empty() || !(power() < least_power() / 2); }

  // What the vertices of the facet have to gain in weight so that the sphere is empty: those on whose side nothing is too close.
  std::array<double, 3> lacking_weights() const
  {
    const Vector_3 p = position(sites_[nearest_[nearest_[0] < 0]]), q = position(sites_[nearest_[nearest_[1] >= 0]]);
    const double a = dual_.height(p), b = dual_.height(q);
    // The point in the plane of the facet of which the power does not depend on the sphere.
    const Vector_3 r = a == b ? p : Vector_3((b * p - a * q) / (b - a));
    std::array<double, 3> shares;
    double sum = 0, positive = 0;
    for(int i = 0; i < 3; ++i)
    {
      const Vector_3 u = position(sites_[facet_[(i + 1) % 3]]), v = position(sites_[facet_[(i + 2) % 3]]);
      sum += shares[i] = dual_.normal.dot((u - r).cross(v - r));
    }
    for(double share : shares)
      positive += (std::max)(0., share / sum);
    for(double& share : shares)
      share = share / sum > 0 ? (least_power() - power()) / positive : 0;
    return shares;
  }

private:
  static constexpr double margin = 1e-3;              // over the squared radius, as all that follow
  static constexpr double most_radii = 1;
  static constexpr int bisections = 40;

  double least_power() const { return margin * dual_.radius * dual_.radius; }
  double slope(int v) const { return -2 * dual_.height(position(sites_[v])); }
  double power(int v) const
  { return squared_distance(sites_[v], dual_.center) - sites_[v].weight - squared_radius_ + height_ * slope(v); }

  int nearest() const
  { return *std::min_element(around_.begin(), around_.end(), [this](int a, int b) { return power(a) < power(b); }); }

  double power() const { return power(nearest()); }

  // Toward where the least power rises, to where it is enough. On either side, one vertex is the nearest in the end.
  void find_height()
  {
    double low = -most_radii * dual_.radius, high = -low;
    for(int n = 0; n < bisections; ++n)
    {
      const int v = nearest();
      const bool rises = slope(v) > 0;
      nearest_[rises] = v;
      // Back toward the facet, if there is room.
      const bool goes_up = power(v) < least_power() ? rises : height_ < 0;
      (goes_up ? low : high) = height_;
      height_ = (low + high) / 2;
    }
  }

  const Triple facet_;
  const std::vector<Site>& sites_;
  const Facet_dual_3 dual_;
  double squared_radius_, height_ = 0;
  std::vector<int> around_;
  std::array<int, 2> nearest_ = {{ -1, -1 }};
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_EMPTY_SPHERE_3_H
