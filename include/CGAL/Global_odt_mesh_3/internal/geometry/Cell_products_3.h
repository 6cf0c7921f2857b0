// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_CELL_PRODUCTS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_CELL_PRODUCTS_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The sphere orthogonal to the sites of a cell, relative to the first one.
struct Cell_sphere
{
  double determinant;           // six times the volume
  double nx, ny, nz;

  // Six times the volume times the power of `q` with respect to the sphere
  // orthogonal to the four sites: negative iff `q` destroys the cell.
  // `s0` is the cell's first vertex.
  double power(const Site& s0, const Site& q) const
  {
    const double x = q.x - s0.x, y = q.y - s0.y, z = q.z - s0.z;
    return determinant * (x * x + y * y + z * z - q.weight + s0.weight)
           - (x * nx + y * ny + z * nz);
  }
};

// The products of the edges of one cell from its first vertex, from which
// energy, gradient, orientation and regularity all follow.
//
// With a, b, c the edges to the other vertices and h_a = |a|^2 - w_a + w_0 (and
// so on) their lifted heights, the weighted circumcenter is
//   x_0 + N / (2 det),  N = h_a (b x c) + h_b (c x a) + h_c (a x b).
// N and det are polynomials, so that flat cells need no care, and differences
// only are squared, so that the distance to the origin does not matter.
struct Cell_products
  : public Cell_sphere
{
  double ax, ay, az, bx, by, bz, cx, cy, cz;
  double aa, bb, cc;            // squared lengths

  Cell_products(const Site& s0, const Site& s1, const Site& s2, const Site& s3)
    : ax(s1.x - s0.x), ay(s1.y - s0.y), az(s1.z - s0.z)
    , bx(s2.x - s0.x), by(s2.y - s0.y), bz(s2.z - s0.z)
    , cx(s3.x - s0.x), cy(s3.y - s0.y), cz(s3.z - s0.z)
    , aa(ax * ax + ay * ay + az * az)
    , bb(bx * bx + by * by + bz * bz)
    , cc(cx * cx + cy * cy + cz * cz)
  {
    const double ha = aa - s1.weight + s0.weight;
    const double hb = bb - s2.weight + s0.weight;
    const double hc = cc - s3.weight + s0.weight;
    const double bcx = by * cz - bz * cy, bcy = bz * cx - bx * cz, bcz = bx * cy - by * cx;
    const double cax = cy * az - cz * ay, cay = cz * ax - cx * az, caz = cx * ay - cy * ax;
    const double abx = ay * bz - az * by, aby = az * bx - ax * bz, abz = ax * by - ay * bx;
    determinant = ax * bcx + ay * bcy + az * bcz;
    nx = ha * bcx + hb * cax + hc * abx;
    ny = ha * bcy + hb * cay + hc * aby;
    nz = ha * bcz + hb * caz + hc * abz;
  }

  // Of the longest edge at the first vertex: what to compare the determinant with.
  double cubed_length() const
  {
    const double squared_length = (std::max)({ aa, bb, cc });
    return squared_length * std::sqrt(squared_length);
  }
};


} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_CELL_PRODUCTS_3_H
