// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_VERTEX_PLACES_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_VERTEX_PLACES_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <optional>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// A place for a vertex, and by how much the deficits of the angles around it change if its cells stay the same.
struct Promising_step
{
  int vertex;
  Site site;
  double change;
};

// On the way from a site outside of the sphere orthogonal to a cell to its center, the place inside by a share of the
// radius; in the plane through the site with that normal, if this is not zero. None if there is no such place.
inline std::optional<Site> place_in_sphere(const std::array<Site, 4>& cell, const Site& from, const Eigen::Vector3d& normal,
                                           double share)
{
  const Cell_products t(cell[0], cell[1], cell[2], cell[3]);
  const Eigen::Vector3d to_center = Eigen::Vector3d(t.nx, t.ny, t.nz) / (2 * t.determinant);
  Eigen::Vector3d way = position(cell[0]) + to_center - position(from);
  const double height = normal.dot(way);
  way -= height * normal;
  const double radius = std::sqrt(to_center.squaredNorm() - cell[0].weight - height * height), length = way.norm();
  if(!(radius > 0) || !std::isfinite(radius) || !(length > radius))
    return std::nullopt;
  return site_at(position(from) + (1 - (1 - share) * radius / length) * way, from.weight);
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_VERTEX_PLACES_H
