// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_TANGENTIAL_MOTION_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_TANGENTIAL_MOTION_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <Eigen/Core>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// How a vertex moves on a surface: in the tangential plane through where it is
// when the motion begins, within a disk. Without radius, it stays.
struct Tangential_motion
{
  Eigen::Vector3d normal;
  double radius;
  Site center;

  bool is_at_rest() const { return !(radius > 0); }

  // The tangential plane says little of the surface farther away.
  void hold_in_disk(Site& s) const
  {
    const Eigen::Vector3d way = position(s) - position(center);
    const double length = way.norm();
    if(length > radius)
      s = site_at(position(center) + radius / length * way, s.weight);
  }

  Eigen::Vector3d tangential_part(const Eigen::Vector3d& g) const
  {
    return g - normal.dot(g) * normal;
  }
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_TANGENTIAL_MOTION_H
