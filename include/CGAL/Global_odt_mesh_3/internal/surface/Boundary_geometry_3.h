// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_BOUNDARY_GEOMETRY_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_BOUNDARY_GEOMETRY_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The shape of an umbrella.
struct Umbrella_shape
{
  Vector_3 normal;     // of unit length, from labels[0] to labels[1]
  double shortest_edge = (std::numeric_limits<double>::max)();      // from the vertex
  bool is_smooth = false;                           // closed, oriented, of one patch, not bent too much
};

// A boundary complex at given positions of its vertices. All its geometries share the complex.
class Boundary_geometry_3
{
public:
  // The smallest cosine between the normals of a smooth umbrella and its facets, that of 60 degrees.
  static constexpr double smallest_cosine = 0.5;

  static constexpr int no_label = -1;

  Boundary_geometry_3() {}

  Boundary_geometry_3(std::shared_ptr<const Boundary_complex_3> complex, const std::vector<Site>& sites)
    : complex_(std::move(complex))
    , shapes_(complex_->number_of_umbrellas())
  {
    measure(sites);
  }

  // The same complex at other positions.
  Boundary_geometry_3 at(const std::vector<Site>& sites) const { return Boundary_geometry_3(complex_, sites); }

  const Boundary_complex_3& complex() const { return *complex_; }

  const Umbrella_shape& shape(int v, int n) const { return shapes_[complex_->umbrella_number(v, n)]; }

  // The subdomain in direction d from the vertex, according to the tangential plane; no_label if the sine of the angle between d
  // and the plane is less than `margin`, or if the vertex is not on a single smooth surface that separates subdomains.
  int label_toward(int v, const Vector_3& d, double margin) const
  {
    if(complex_->number_of_umbrellas(v) != 1 || !shape(v, 0).is_smooth)
      return no_label;
    const std::array<int, 2>& labels = complex_->umbrella(v, 0).labels;
    const double side = shape(v, 0).normal.dot(d);
    if(labels[0] == labels[1] || !(std::abs(side) >= margin * d.length()))
      return no_label;
    return labels[side > 0 ? 1 : 0];
  }

private:
  void measure(const std::vector<Site>& sites)
  {
    const std::vector<Boundary_facet>& facets = complex_->facets();
    std::vector<Vector_3> area(facets.size());
    for(std::size_t n = 0; n < facets.size(); ++n)
    {
      area[n] = area_vector(facets[n].vertices, sites);
      for(int k = 0; k < 3; ++k)
        add_corner(static_cast<int>(3 * n) + k, area[n], sites);
    }
    for(int n = 0; n < complex_->number_of_umbrellas(); ++n)
    {
      shapes_[n].normal = shapes_[n].normal.normalized();
      shapes_[n].is_smooth = complex_->umbrella(n).is_disk;
    }
    for(std::size_t n = 0; n < facets.size(); ++n)
    {
      area[n] = area[n].normalized();
      for(int k = 0; k < 3; ++k)
        add_bend(static_cast<int>(3 * n) + k, area[n]);
    }
  }

  Umbrella_shape& shape_of_corner(int corner) { return shapes_[complex_->umbrella_of_corner(corner)]; }

  // The sign that tells whether the normals of facet and umbrella point to the same side.
  double orientation(int corner) const
  {
    const Boundary_umbrella& umbrella = complex_->umbrella(complex_->umbrella_of_corner(corner));
    return complex_->facets()[corner / 3].labels[0] == umbrella.labels[0] ? 1 : -1;
  }

  void add_corner(int corner, const Vector_3& area, const std::vector<Site>& sites)
  {
    const std::array<int, 3>& t = complex_->facets()[corner / 3].vertices;
    const Site& s = sites[t[corner % 3]];
    Umbrella_shape& u = shape_of_corner(corner);
    u.normal += orientation(corner) * area;
    for(int m = 1; m < 3; ++m)
    {
      const Vector_3 edge = position(sites[t[(corner + m) % 3]]) - position(s);
      u.shortest_edge = (std::min)(u.shortest_edge, edge.length());
    }
  }

  void add_bend(int corner, const Vector_3& facet_normal)
  {
    Umbrella_shape& u = shape_of_corner(corner);
    if(!(orientation(corner) * facet_normal.dot(u.normal) >= smallest_cosine))
      u.is_smooth = false;
  }

  // Twice the area, pointing to side 1.
  static Vector_3 area_vector(const std::array<int, 3>& t, const std::vector<Site>& s)
  {
    const Vector_3 origin = position(s[t[0]]);
    return (position(s[t[1]]) - origin).cross(position(s[t[2]]) - origin);
  }

  std::shared_ptr<const Boundary_complex_3> complex_;
  std::vector<Umbrella_shape> shapes_;
};

// Estimates the point where the dual line meets the surface from the normals at the vertices: on a sphere, and hence in second
// order, it is half as high over the facet as the tangential planes at the vertices.
inline Vector_3 estimated_surface_center(const std::array<int, 3>& t, const Boundary_geometry_3& boundary,
                                                const std::vector<Site>& sites)
{
  const Facet_dual_3 dual(t, sites);
  double height = 0;
  int count = 0;
  for(int v : t)
  {
    if(boundary.complex().number_of_umbrellas(v) != 1)
      continue;
    const Vector_3& n = boundary.shape(v, 0).normal;
    const double cosine = n.dot(dual.normal);
    if(std::abs(cosine) < Boundary_geometry_3::smallest_cosine)
      continue;
    height += n.dot(position(sites[v]) - dual.center) / (2 * cosine);
    ++count;
  }
  if(count > 0)
    height /= count;
  return dual.point_at((std::max)(-dual.radius, (std::min)(dual.radius, height)));
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_BOUNDARY_GEOMETRY_3_H
