// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh_domains.h"

#include <CGAL/Random.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/number_type_config.h>

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

Polyhedral_c3t3 mesh(const Polyhedral_domain& domain, double size, bool with_features, double edge_size)
{
  Polyhedral_criteria criteria(params::edge_size = edge_size > 0 ? edge_size : size, params::facet_angle = 25, params::facet_size = size,
                               params::facet_distance = size / 8, params::cell_radius_edge_ratio = 2.5,
                               params::cell_size = size);
  if(with_features)
    return CGAL::make_mesh_3<Polyhedral_c3t3>(domain, criteria, params::no_exude(), params::no_perturb());
  return CGAL::make_mesh_3<Polyhedral_c3t3>(domain, criteria, params::no_exude(), params::no_perturb(),
                                            params::no_features());
}

static void insert(Labeled_c3t3& c3t3, const Point_3& p, int dimension, const Labeled_domain::Index& index)
{
  const auto v = c3t3.triangulation().insert(Labeled_triangulation::Weighted_point(p));
  v->set_dimension(dimension);
  v->set_index(index);
}

// With the surface center at the place on the unit sphere that is nearest to the centroid.
static void add_facet(Labeled_c3t3& c3t3, const Labeled_c3t3::Facet& facet, const Labeled_c3t3::Surface_patch_index& patch,
                      const Labeled_domain::Index& index)
{
  c3t3.add_to_complex(facet, patch);
  const auto point = [&](int k) { return facet.first->vertex((facet.second + k) % 4)->point().point(); };
  const Kernel::Vector_3 v = CGAL::centroid(point(1), point(2), point(3)) - CGAL::ORIGIN;
  for(const auto& side : { facet, c3t3.triangulation().mirror_facet(facet) })
  {
    side.first->set_facet_surface_center(side.second, CGAL::ORIGIN + v / std::sqrt(v.squared_length()));
    side.first->set_facet_surface_center_index(side.second, index);
  }
}

Labeled_c3t3 mesh_of_rings(const Labeled_domain& domain, int fixed_rings)
{
  const int rings = 7, vertices_in_ring = 12, interior_vertices = 40;
  const Labeled_c3t3::Surface_patch_index patch(0, 1);
  const auto index_of_patch = domain.index_from_surface_patch_index(patch);
  Labeled_c3t3 c3t3;
  for(int r = 1; r <= rings; ++r)
    for(int n = 0; n < vertices_in_ring; ++n)
    {
      const double latitude = CGAL_PI * (double(r) / (rings + 1) - 0.5), longitude = 2 * CGAL_PI * n / vertices_in_ring;
      insert(c3t3, Point_3(std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                           std::sin(latitude)), r <= fixed_rings ? 1 : 2, index_of_patch);
    }
  CGAL::Random random(1);
  const auto coordinate = [&] { return random.get_double(-0.4, 0.4); };
  for(int n = 0; n < interior_vertices; ++n)
  {
    const double x = coordinate(), y = coordinate(), z = coordinate();
    insert(c3t3, Point_3(x, y, z), 3, domain.index_from_subdomain_index(1));
  }
  const Labeled_triangulation& tr = c3t3.triangulation();
  for(auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
    if(domain.is_in_domain_object()(tr.dual(c)))
      c3t3.add_to_complex(c, 1);
  for(auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f)
    if(c3t3.is_in_complex(f->first) != c3t3.is_in_complex(tr.mirror_facet(*f).first))
      add_facet(c3t3, *f, patch, index_of_patch);
  return c3t3;
}

} // namespace domains
