// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_SITE_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_SITE_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>

#include <CGAL/number_utils.h>

namespace CGAL::Global_odt_mesh_3::internal {

// A vertex as the energy sees it: a point lifted to height |p|^2 - weight.
// The weight is zero except for the protecting balls of features.
struct Site
{
  double x, y, z;
  double weight;
};

inline Vector_3 position(const Site& s) { return Vector_3(s.x, s.y, s.z); }

inline bool same_place(const Site& a, const Site& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

inline Site site_at(const Vector_3& p, double weight) { return { p.x(), p.y(), p.z(), weight }; }

// CGAL's points in double coordinates.
template <class Point>
Vector_3 coordinates(const Point& p)
{
  return Vector_3(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

template <class Weighted_point>
Site weighted_site(const Weighted_point& p)
{
  return { CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()), CGAL::to_double(p.weight()) };
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_SITE_H
