// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_PATCH_OF_FACET_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_PATCH_OF_FACET_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

constexpr int unknown_patch = -2;       // of a facet on whose patch its vertices do not agree

// The patch of a new facet: the one that all its vertices have, or else that of them on which its dual line meets the surface.
// `patches(v)` is the set of those at a vertex, between the subdomains of the facet.
template <class Patches>
int patch_of_facet(const Triple& t, const std::array<Site, 3>& sites, const Patches& patches, const Domain_view_3& domain)
{
  std::set<int> common = patches(t[0]);
  for(int v : { t[1], t[2] })
  {
    const std::set<int> before = std::move(common), here = patches(v);
    common.clear();
    std::set_intersection(before.begin(), before.end(), here.begin(), here.end(), std::inserter(common, common.end()));
  }
  if(common.size() <= 1)
    return common.empty() ? unknown_patch : *common.begin();
  const Facet_dual_3 dual(sites);
  Eigen::Vector3d p = dual.center;
  int patch;
  return domain.intersect(p, dual.normal, dual.radius, patch) && common.count(patch) > 0 ? patch : unknown_patch;
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_PATCH_OF_FACET_3_H
