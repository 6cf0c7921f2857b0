// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_FACET_SPHERES_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_FACET_SPHERES_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Defect_report_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The pencil of spheres orthogonal to the weighted vertices of a facet, and the vertices around it that stay: the facet is in the
// regular triangulation of all of these iff one of the spheres is empty. Powers with respect to the spheres are linear both along
// the dual line and in the weights.
class Facet_spheres_3
{
public:
  // How much weight, along the normalized gradient, is missing for a sphere to be empty.
  struct Condition
  {
    double lack = 0;
    std::array<int, 5> vertices = {{ -1, -1, -1, -1, -1 }};
    std::array<double, 5> gradient = {{ 0, 0, 0, 0, 0 }};
  };

  Facet_spheres_3(const Complex_candidate_3& candidate, const Triple& facet)
    : facet_(facet)
  {
    constexpr int rings = 2;
    Vertex_rings_3 region(candidate.triangulation, facet);
    for(int ring = 0; ring < rings; ++ring)
      region.grow();
    std::array<Site, 3> corners{{ candidate.sites[facet[0]], candidate.sites[facet[1]], candidate.sites[facet[2]] }};
    for(Site& s : corners)
      s.weight = 0;
    const Facet_dual_3 circle(corners);
    radius_ = circle.radius;
    for(int v : region.vertices())
      if(candidate.stays(v) && std::find(facet.begin(), facet.end(), v) == facet.end())
        around_.push_back(neighbor(v, !candidate.numbering.is_movable(v), position(candidate.sites[v]), corners, circle));
  }

  // The least power that vertices must have, over the squared radius of the facet.
  static constexpr double least_margin = 5e-5;

  bool are_empty(const std::vector<Site>& sites, double margin = least_margin) const
  { return !(bound(-1, sites, margin) > bound(1, sites, margin)); }

  // The center of the smallest empty sphere.
  Vector_3 center(const std::vector<Site>& sites) const
  {
    const double least = bound(-1, sites, least_margin), most = bound(1, sites, least_margin);
    return Facet_dual_3(facet_, sites).point_at((std::max)(least, (std::min)(most, 0.)));
  }

  // The condition violated most among those for pairs of neighbors: a convex function of the weights.
  Condition condition(const std::vector<Site>& sites, double margin) const
  {
    Condition worst;
    const double lowest = bound(-1, sites, margin), highest = bound(1, sites, margin);
    if(!(lowest > highest))
      return worst;
    const Bound bottom = { -most_radii * radius_ }, top = { most_radii * radius_ };
    std::vector<Bound> below, above;
    if(bottom.height > highest)
      below.push_back(bottom);
    if(top.height < lowest)
      above.push_back(top);
    for(const Neighbor& n : around_)
      if(const double h = height_at(n, sites, margin); n.height < 0 && h > highest)
        below.push_back({ h, &n });
      else if(n.height > 0 && h < lowest)
        above.push_back({ h, &n });
    for(const Bound& low : below)
      for(const Bound& high : above)
        if(low.height > high.height)
          if(const Condition c = condition(low, high); c.lack > worst.lack)
            worst = c;
    return worst;
  }

private:
  static constexpr double most_radii = 1;
  static constexpr double rounding = 1e-12;

  // A vertex around the facet: its height over the plane, its barycentric coordinates there, and its power without weights.
  struct Neighbor
  {
    int vertex;
    bool may_gain_weight;
    double height, power;
    std::array<double, 3> shares;
  };

  // A bound on the heights of empty spheres, with the vertex that sets it, if there is one.
  struct Bound
  {
    double height;
    const Neighbor* neighbor = nullptr;
  };

  // The weighted mean of the powers of the two vertices that set the bounds is the same for all spheres; it must reach the margin.
  Condition condition(const Bound& low, const Bound& high) const
  {
    Condition result;
    const double a = low.neighbor == nullptr ? 0 : -low.neighbor->height, b = high.neighbor == nullptr ? 0 : high.neighbor->height;
    const double share = a == 0 ? 0 : b == 0 ? 1 : b / (a + b);
    std::copy(facet_.begin(), facet_.end(), result.vertices.begin());
    double squared = 0;
    for(int n = 0; n < 2; ++n)
      if(const Neighbor* const w = n == 0 ? low.neighbor : high.neighbor; w != nullptr)
      {
        const double s = n == 0 ? share : 1 - share;
        if(w->may_gain_weight)
        {
          result.vertices[3 + n] = w->vertex;
          result.gradient[3 + n] = -s;
        }
        for(int i = 0; i < 3; ++i)
          result.gradient[i] += s * w->shares[i];
      }
    for(double g : result.gradient)
      squared += g * g;
    const double length = std::sqrt(squared);
    for(double& g : result.gradient)
      g /= length;
    result.lack = 2 * (low.height - high.height) * (a == 0 || b == 0 ? a + b : a * b / (a + b)) / length;
    return result;
  }

  static Neighbor neighbor(int v, bool may_gain_weight, const Vector_3& p, const std::array<Site, 3>& corners,
                           const Facet_dual_3& circle)
  {
    Neighbor result = { v, may_gain_weight, circle.height(p), (p - circle.center).squared_length() - circle.radius * circle.radius, {} };
    // A vertex in the plane sets the same bound on either side.
    if(std::abs(result.height) < rounding * circle.radius)
      result.height = rounding * circle.radius;
    double sum = 0;
    for(int i = 0; i < 3; ++i)
    {
      const Vector_3 to_next = position(corners[(i + 1) % 3]) - p, to_last = position(corners[(i + 2) % 3]) - p;
      sum += result.shares[i] = circle.normal.dot(to_next.cross(to_last));
    }
    for(double& share : result.shares)
      share /= sum;
    return result;
  }

  // The height of the sphere at which the power of the vertex equals the margin.
  double height_at(const Neighbor& n, const std::vector<Site>& sites, double margin) const
  {
    double power = n.power - sites[n.vertex].weight - margin * radius_ * radius_;
    for(int i = 0; i < 3; ++i)
      power += n.shares[i] * sites[facet_[i]].weight;
    return power / (2 * n.height);
  }

  // A bound on the heights of empty spheres from the vertices on one side: the lower bound from those below (-1), or the upper
  // bound from those above (1).
  double bound(int side, const std::vector<Site>& sites, double margin) const
  {
    double result = side * most_radii * radius_;
    for(const Neighbor& n : around_)
      if(side * n.height > 0)
        if(const double h = height_at(n, sites, margin); side * h < side * result)
          result = h;
    return result;
  }

  const Triple facet_;
  double radius_ = 0;                                 // of the circumcircle
  std::vector<Neighbor> around_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_FACET_SPHERES_3_H
