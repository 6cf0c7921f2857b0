// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_domains.h"

#include <CGAL/make_mesh_3.h>

#include <algorithm>
#include <cmath>

namespace domains {

Labeled_c3t3 mesh(const Labeled_domain& domain, double size)
{
  Labeled_criteria criteria(params::facet_angle = 25, params::facet_size = size,
                            params::facet_distance = size / 4, params::cell_radius_edge_ratio = 2.5,
                            params::cell_size = size);
  return CGAL::make_mesh_3<Labeled_c3t3>(domain, criteria, params::no_exude(), params::no_perturb());
}

struct Graded_size
{
  typedef domains::FT FT;
  typedef domains::Point_3 Point_3;
  typedef Labeled_domain::Index Index;
  FT smallest;
  FT operator()(const Point_3& p, const int, const Index&) const
  {
    return smallest * (1 + 4 * (std::max)(FT(0), 1 - std::sqrt(squared(p))));
  }
};

Labeled_c3t3 graded_mesh(const Labeled_domain& domain, double smallest)
{
  Labeled_criteria criteria(params::facet_angle = 25, params::facet_size = smallest,
                            params::facet_distance = smallest / 4, params::cell_radius_edge_ratio = 2.5,
                            params::cell_size = Graded_size{ smallest });
  return CGAL::make_mesh_3<Labeled_c3t3>(domain, criteria, params::no_exude(), params::no_perturb());
}

Polyhedral_c3t3 mesh(const Polyhedral_domain& domain, double size, bool with_features)
{
  Polyhedral_criteria criteria(params::edge_size = size, params::facet_angle = 25, params::facet_size = size,
                               params::facet_distance = size / 8, params::cell_radius_edge_ratio = 2.5,
                               params::cell_size = size);
  if(with_features)
    return CGAL::make_mesh_3<Polyhedral_c3t3>(domain, criteria, params::no_exude(), params::no_perturb());
  return CGAL::make_mesh_3<Polyhedral_c3t3>(domain, criteria, params::no_exude(), params::no_perturb(),
                                            params::no_features());
}

} // namespace domains
