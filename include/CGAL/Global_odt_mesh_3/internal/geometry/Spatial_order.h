// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_SPATIAL_ORDER_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_SPATIAL_ORDER_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

template <class Sort>
std::vector<std::size_t> sorted_sites(const std::vector<Site>& sites, const Sort& sort)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef CGAL::Pointer_property_map<Kernel::Point_3>::type Point_map;
  std::vector<Kernel::Point_3> points;
  points.reserve(sites.size());
  for(const Site& s : sites)
    points.emplace_back(s.x, s.y, s.z);
  std::vector<std::size_t> order(sites.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  sort(order, CGAL::Spatial_sort_traits_adapter_3<Kernel, Point_map>(CGAL::make_property_map(points)));
  return order;
}

// Along a Hilbert curve: neighbors in space are near each other in memory.
inline std::vector<std::size_t> hilbert_order(const std::vector<Site>& sites)
{
  return sorted_sites(sites, [](std::vector<std::size_t>& order, const auto& traits)
                      { CGAL::hilbert_sort(order.begin(), order.end(), traits); });
}

// The order in which sites are inserted fast: rounds of growing size, each along a Hilbert curve.
inline std::vector<std::size_t> insertion_order(const std::vector<Site>& sites)
{
  return sorted_sites(sites, [](std::vector<std::size_t>& order, const auto& traits)
                      { CGAL::spatial_sort(order.begin(), order.end(), traits); });
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_SPATIAL_ORDER_H
