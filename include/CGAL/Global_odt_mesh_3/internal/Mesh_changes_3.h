// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_CHANGES_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_CHANGES_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace CGAL::Global_odt_mesh_3::internal {

// Six times the volume of each subdomain.
inline std::map<int, double> volumes(const Mesh_table_3& mesh)
{
  std::map<int, double> result;
  for(const Mesh_table_3::Cell& c : mesh.cells)
    if(c.label != Domain_view_3::outside)
    {
      const std::array<Site, 4> s = mesh.cell_sites(c.vertices);
      result[c.label] += Cell_products(s[0], s[1], s[2], s[3]).determinant;
    }
  return result;
}

// The largest relative change of a measure of subdomains, such as the volume.
template <class Measures>
double largest_change(const Measures& before, const Measures& after)
{
  double largest = 0;
  for(const auto& b : before)
  {
    const auto a = after.find(b.first);
    const double change = (a == after.end() ? 0 : a->second) / b.second - 1;
    if(std::abs(change) > std::abs(largest))
      largest = change;
  }
  return largest;
}

// The largest distance of a facet's centroid from the surface, measured along the facet's normal unless the domain can measure
// distances. Facets for which no point of the surface is found do not count.
inline double farthest_facet(const Mesh_table_3& mesh, const Domain_view_3& domain)
{
  double farthest = 0;
  for(const Mesh_table_3::Facet& f : mesh.facets)
  {
    const Quadruple& q = mesh.cells[f.cell].vertices;
    const Triple t = facet_vertices(q, f.index);
    const Vector_3 middle = centroid(t, mesh.sites);
    const Facet_dual_3 dual(t, mesh.sites);
    Vector_3 p = middle;
    if(domain.tells_distances())
      farthest = (std::max)(farthest, domain.distance_to_surface(middle));
    else if(domain.project(p, dual.normal, dual.radius, f.patch))
      farthest = (std::max)(farthest, (p - middle).length());
  }
  return farthest;
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_CHANGES_3_H
