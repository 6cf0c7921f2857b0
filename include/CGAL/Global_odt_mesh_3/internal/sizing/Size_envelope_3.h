// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_SIZE_ENVELOPE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_SIZE_ENVELOPE_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/sizing/Boundary_poles_3.h>

#include <CGAL/Dimension.h>
#include <CGAL/Euclidean_distance.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits.h>
#include <CGAL/Splitters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The lower envelope of the sizes sqrt(h^2 + K^2 |x - s|^2) that samples s with sizes h ask for, and of a largest one.
//
// Up to the square of the least h, its square is the squared distance of (K x, 0) to the closest of the points
// (K s, sqrt(h^2 - least^2)) in four dimensions, or else the power distance to the points K s in three.
// Scaling by K, and not by 1/K, lets K be as small as one likes.
class Size_envelope_3
{
public:
  typedef Power_diagram_3::Kernel Kernel;
  typedef Kernel::Point_3 Point_3;

  // There is one size for each sample.
  Size_envelope_3(const std::vector<Point_3>& samples, const std::vector<double>& sizes, double gradation, double largest)
    : gradation_(gradation)
    , largest_(largest)
    , least_(largest)
  {
    for(double h : sizes)
      least_ = (std::min)(least_, h);
    std::vector<Weighted_point> sites;
    for(std::size_t n = 0; n < samples.size(); ++n)
      if(sizes[n] < largest)
        sites.emplace_back(Point_3(gradation * samples[n].x(), gradation * samples[n].y(), gradation * samples[n].z()),
                           -(sizes[n] - least_) * (sizes[n] + least_));
    // Hidden sites, often most of them, are nowhere the closest.
    const Power_diagram_3::Triangulation power(sites.begin(), sites.end());
    for(const auto v : power.finite_vertex_handles())
    {
      const Weighted_point& s = v->point();
      tree_.insert({{ s.x(), s.y(), s.z(), std::sqrt(-s.weight()) }});
    }
    // A tree that is built by the first query would not be safe for threads.
    if(tree_.size() != 0)
      tree_.build();
  }

  double operator()(double x, double y, double z) const
  {
    if(tree_.size() == 0)
      return largest_;
    const Point_4 query = {{ gradation_ * x, gradation_ * y, gradation_ * z, 0 }};
    return (std::min)(largest_, std::sqrt(least_ * least_ + Search(tree_, query, 1).begin()->second));
  }

private:
  typedef Kernel::Weighted_point_3 Weighted_point;
  typedef std::array<double, 4> Point_4;

  struct Coordinates
  {
    typedef const double* result_type;
    const double* operator()(const Point_4& p) const { return p.data(); }
    const double* operator()(const Point_4& p, int) const { return p.data() + p.size(); }
  };

  typedef CGAL::Search_traits<double, Point_4, const double*, Coordinates, Dimension_tag<4> > Traits;
  typedef Sliding_midpoint<Traits> Splitter;
  typedef CGAL::Kd_tree<Traits, Splitter> Tree;
  typedef Orthogonal_k_neighbor_search<Traits, Euclidean_distance<Traits>, Splitter, Tree> Search;

  // Queries are fastest with larger leaves than by default.
  static constexpr unsigned int leaf_size = 20;

  double gradation_, largest_, least_;
  Tree tree_{Splitter(leaf_size)};
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_SIZE_ENVELOPE_3_H
