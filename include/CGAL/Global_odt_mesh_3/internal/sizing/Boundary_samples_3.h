// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_BOUNDARY_SAMPLES_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_BOUNDARY_SAMPLES_3_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/number_utils.h>

#include <set>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Boundary_sample;

template <class Point>
Boundary_sample boundary_sample(const Point& p)
{
  return Boundary_sample(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

// The vertices of the surface facets of a mesh, without weights, which are not of the surface.
template <class C3t3>
std::vector<Boundary_sample> samples_of_mesh(const C3t3& c3t3)
{
  std::set<typename C3t3::Vertex_handle> on_surface;
  for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
    for(int i = 0; i < 4; ++i)
      if(i != f->second)
        on_surface.insert(f->first->vertex(i));
  // In the order of the triangulation, since that of handles is left to chance.
  std::vector<Boundary_sample> samples;
  samples.reserve(on_surface.size());
  for(auto v : c3t3.triangulation().finite_vertex_handles())
    if(on_surface.count(v) != 0)
      samples.push_back(boundary_sample(v->point()));
  return samples;
}

// A mesh of nothing but the surface.
template <class MeshDomain>
std::vector<Boundary_sample> samples_of_domain(const MeshDomain& domain, double spacing)
{
  typedef typename Mesh_triangulation_3<MeshDomain>::type Tr;
  typedef Mesh_complex_3_in_triangulation_3<Tr> C3t3;
  typedef Mesh_criteria_3<Tr> Criteria;
  const double facet_angle = 25;
  const Criteria criteria(typename Criteria::Facet_criteria(facet_angle, spacing, 0.),
                          typename Criteria::Cell_criteria(0., 0.));
  return samples_of_mesh(make_mesh_3<C3t3>(domain, criteria, parameters::no_exude(), parameters::no_perturb(),
                                           parameters::no_features()));
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_BOUNDARY_SAMPLES_3_H
