// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_CELL_GEOMETRY_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_CELL_GEOMETRY_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

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

  // The vector from the first site to the dual point, which is the circumcenter if there are no weights.
  Vector_3 to_dual() const { return Vector_3(nx, ny, nz) / (2 * determinant); }

  // The cube of the longest edge at the first vertex, with which the determinant is compared.
  double cubed_length() const
  {
    const double squared_length = (std::max)({ aa, bb, cc });
    return squared_length * std::sqrt(squared_length);
  }
};

// From a point into the sphere around a cell, by so much of the radius of the circle in the plane with the normal, if there is one; none if
// it is inside.
inline std::optional<Vector_3> way_into_sphere(const std::array<Site, 4>& cell, const Vector_3& from, const Vector_3& normal, double share)
{
  const Vector_3 to_center = Cell_products(cell[0], cell[1], cell[2], cell[3]).to_dual();
  Vector_3 way = position(cell[0]) + to_center - from;
  const double height = normal.dot(way);
  way -= height * normal;
  const double radius = std::sqrt(to_center.squared_length() - cell[0].weight - height * height), length = way.length();
  if(!(radius > 0) || !std::isfinite(radius) || !(length > radius))
    return std::nullopt;
  return Vector_3((1 - (1 - share) * radius / length) * way);
}

// What one of five sites has to gain in weight so that all are on one sphere. Powers are linear in weights; the unit is any change of
// a weight.
inline double gain_on_sphere(std::array<Site, 5> s, int i, double unit)
{
  const auto power = [&s] { return Cell_products(s[0], s[1], s[2], s[3]).power(s[0], s[4]); };
  const double before = power();
  s[std::size_t(i)].weight += unit;
  return before / (before - power()) * unit;
}

// The facets opposite to each vertex, by their outward normals, which are as long as twice the areas.
struct Cell_facets_3
{
  std::array<Vector_3, 4> x, normal;
  std::array<double, 4> area;

  explicit Cell_facets_3(const std::array<Site, 4>& s)
    : x{{ position(s[0]), position(s[1]), position(s[2]), position(s[3]) }}
  {
    const Vector_3 a = x[1] - x[0], b = x[2] - x[0], c = x[3] - x[0];
    normal[1] = c.cross(b);
    normal[2] = a.cross(c);
    normal[3] = b.cross(a);
    normal[0] = -(normal[1] + normal[2] + normal[3]);
    for(int i = 0; i < 4; ++i)
      area[i] = normal[i].length();
  }

  // The gradient of the angle between the facets opposite to i and j, with respect to vertex m. A vertex off their
  // common edge opens the angle along the normal of its facet; an end of the edge does the opposite, by its share of
  // the lever.
  Vector_3 gradient(int i, int j, int m) const
  {
    const int k = m != i && m != j ? m : other_than(i, j, -1), l = other_than(i, j, k);
    const Vector_3 edge = x[k] - x[l];
    const double length = edge.length();
    const Vector_3 of_i = length / (area[j] * area[j]) * normal[j], of_j = length / (area[i] * area[i]) * normal[i];
    if(m == i)
      return of_i;
    if(m == j)
      return of_j;
    return -((x[i] - x[l]).dot(edge) * of_i + (x[j] - x[l]).dot(edge) * of_j) / (length * length);
  }

  static int other_than(int i, int j, int k)
  {
    int n = 0;
    while(n == i || n == j || n == k)
      ++n;
    return n;
  }
};

// The six dihedral angles, in degrees, and 3 r / R of a tetrahedron.
struct Cell_shape_3
{
  std::array<double, 6> angles;     // between the facets opposite to vertices 01, 02, 03, 12, 13, 23
  double radius_ratio;

  Cell_shape_3(const Site& s0, const Site& s1, const Site& s2, const Site& s3)
  {
    const Cell_facets_3 facets(std::array<Site, 4>{{ s0, s1, s2, s3 }});
    int n = 0;
    // The angle between the facets is the supplement of that of the normals.
    for(int i = 0; i < 3; ++i)
      for(int j = i + 1; j < 4; ++j)
      {
        const Vector_3 &a = facets.normal[i], &b = facets.normal[j];
        angles[n++] = std::atan2(a.cross(b).length(), -a.dot(b)) * 180 / CGAL_PI;
      }
    // r = 3 V / area; R = |N| / (2 det) of the unweighted sites.
    const auto unweighted = [](Site p) { p.weight = 0; return p; };
    const Cell_products t(unweighted(s0), unweighted(s1), unweighted(s2), unweighted(s3));
    const double area = (facets.area[0] + facets.area[1] + facets.area[2] + facets.area[3]) / 2;
    const double numerator = std::sqrt(t.nx * t.nx + t.ny * t.ny + t.nz * t.nz);
    radius_ratio = numerator > 0 && area > 0
                 ? (std::min)(1., 3 * t.determinant * t.determinant / (area * numerator)) : 0.;
  }
};

// The dual line of a facet: through the weighted circumcenter, along the normal,
// which points to side 1.
struct Facet_dual_3
{
  Vector_3 center, normal;
  double radius;

  // With the edges a, b from s0, their lifted heights h_a, h_b and n = a x b, the
  // center is s0 + (h_a (b x n) + h_b (n x a)) / (2 |n|^2).
  Facet_dual_3(const Triple& t, const std::vector<Site>& sites)
    : Facet_dual_3(std::array<Site, 3>{{ sites[t[0]], sites[t[1]], sites[t[2]] }})
  {}

  explicit Facet_dual_3(const std::array<Site, 3>& s)
  {
    const Site &s0 = s[0], &s1 = s[1], &s2 = s[2];
    const Vector_3 a = position(s1) - position(s0), b = position(s2) - position(s0), n = a.cross(b);
    const double ha = a.squared_length() - s1.weight + s0.weight;
    const double hb = b.squared_length() - s2.weight + s0.weight;
    const Vector_3 d = (ha * b.cross(n) + hb * n.cross(a)) / (2 * n.squared_length());
    center = position(s0) + d;
    normal = n / n.length();
    radius = d.length();
  }

  // The signed height of a point over the plane of the facet, positive on side 1.
  double height(const Vector_3& p) const { return normal.dot(p - center); }

  Vector_3 point_at(double height) const { return center + height * normal; }
};

inline Vector_3 centroid(const std::array<Site, 3>& s) { return (position(s[0]) + position(s[1]) + position(s[2])) / 3; }

inline Vector_3 centroid(const std::array<Site, 4>& s) { return (position(s[0]) + position(s[1]) + position(s[2]) + position(s[3])) / 4; }

inline Vector_3 centroid(const Triple& t, const std::vector<Site>& s)
{ return centroid(std::array<Site, 3>{{ s[t[0]], s[t[1]], s[t[2]] }}); }

// How far points of a plane may be from it where files have rounded coordinates to six digits.
inline double rounding_of_coordinates(const std::vector<Site>& sites)
{
  constexpr double rounding = 2e-6;               // of the diagonal of the bounding box
  Vector_3 least = sites.empty() ? Vector_3() : position(sites[0]), most = least;
  for(const Site& s : sites)
    for(int i = 0; i < 3; ++i)
    {
      least[i] = (std::min)(least[i], position(s)[i]);
      most[i] = (std::max)(most[i], position(s)[i]);
    }
  return rounding * (most - least).length();
}

inline double squared_distance(const Site& s, const Vector_3& p) { return (position(s) - p).squared_length(); }

// The angle is in degrees.
inline double smallest_angle_of_facet(const std::array<Site, 3>& s)
{
  double smallest = 180;
  for(std::size_t i = 0; i < 3; ++i)
  {
    const Vector_3 a = position(s[(i + 1) % 3]) - position(s[i]);
    const Vector_3 b = position(s[(i + 2) % 3]) - position(s[i]);
    smallest = (std::min)(smallest, std::atan2(a.cross(b).length(), a.dot(b)) * 180 / CGAL_PI);
  }
  return smallest;
}

inline double smallest_angle_of_facet(const Triple& t, const std::vector<Site>& sites)
{
  return smallest_angle_of_facet({{ sites[t[0]], sites[t[1]], sites[t[2]] }});
}

// The square of the circumradius of a cell, infinite or not a number if it is flat. Weights do not count, as they do not for
// CGAL's criterion.
inline double squared_circumradius(const std::array<Site, 4>& s)
{
  const Vector_3 a = position(s[1]) - position(s[0]), b = position(s[2]) - position(s[0]), c = position(s[3]) - position(s[0]);
  const Vector_3 bc = b.cross(c);
  const double twice_determinant = 2 * a.dot(bc);
  const Vector_3 center = a.squared_length() * bc + b.squared_length() * c.cross(a) + c.squared_length() * a.cross(b);
  return center.squared_length() / (twice_determinant * twice_determinant);
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_CELL_GEOMETRY_3_H
