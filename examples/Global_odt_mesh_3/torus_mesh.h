// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TORUS_MESH_H
#define TORUS_MESH_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>

#include <cmath>

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Labeled_mesh_domain_3<K> Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type Tr;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Tr> C3t3;
typedef CGAL::Mesh_criteria_3<Tr> Criteria;
namespace params = CGAL::parameters;

inline double torus(const K::Point_3& p)
{
  const double ring = std::sqrt(p.x() * p.x() + p.y() * p.y()) - 1;
  return ring * ring + p.z() * p.z() - 0.16;
}

inline Domain torus_domain()
{
  return Domain::create_implicit_mesh_domain(torus, K::Sphere_3(CGAL::ORIGIN, 4.));
}

// As it comes from refinement, with slivers.
inline C3t3 torus_mesh(const Domain& domain)
{
  const Criteria criteria(params::facet_angle = 30, params::facet_size = 0.1, params::facet_distance = 0.01,
                          params::cell_radius_edge_ratio = 2, params::cell_size = 0.1);
  return CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::no_exude());
}

#endif // TORUS_MESH_H
