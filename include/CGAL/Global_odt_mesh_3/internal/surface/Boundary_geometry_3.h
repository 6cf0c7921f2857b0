// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_BOUNDARY_GEOMETRY_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_BOUNDARY_GEOMETRY_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The shape of an umbrella.
struct Umbrella_shape
{
  std::array<double, 3> normal = {{ 0, 0, 0 }};     // of unit length, from labels[0] to labels[1]
  std::array<double, 3> toward = {{ 0, 0, 0 }};     // from the vertex into the umbrella
  double shortest_edge = (std::numeric_limits<double>::max)();      // from the vertex
  double bend = 0;                                  // the largest sine between facets and normal
  bool is_smooth = false;                           // closed, oriented, of one patch, not bent too much
};

// A boundary complex at certain positions of its vertices. The complex is shared by all its geometries.
class Boundary_geometry_3
{
public:
  typedef std::array<double, 3> Vector;

  // The cosine between a facet of a smooth umbrella and the umbrella's normal: 60 degrees.
  static constexpr double smallest_cosine = 0.5;

  static constexpr int no_label = -1;

  Boundary_geometry_3() {}

  Boundary_geometry_3(std::shared_ptr<const Boundary_complex_3> complex, const std::vector<Site>& sites)
    : complex_(std::move(complex))
    , shapes_(complex_->number_of_umbrellas())
    , creases_(complex_->number_of_vertices())
  {
    measure(sites);
  }

  // The same complex at other positions.
  Boundary_geometry_3 at(const std::vector<Site>& sites) const { return Boundary_geometry_3(complex_, sites); }

  const Boundary_complex_3& complex() const { return *complex_; }

  const Umbrella_shape& shape(int v, int n) const { return shapes_[complex_->umbrella_number(v, n)]; }

  // The subdomain that lies in direction d from the vertex, as the planes of its
  // umbrellas tell; no_label if d is closer to tangential than the sine `margin`, or if
  // the surfaces are not those of a smooth point, a convex or a reflex edge or corner.
  int label_toward(int v, const Vector& d, double margin) const
  {
    if(creases_[v] == UNCLEAR)
      return no_label;
    const double clear = margin * std::sqrt(dot(d, d));
    bool any_above = false, any_below = false, all_above = true, all_below = true;
    for(int n = 0; n < complex_->number_of_umbrellas(v); ++n)
    {
      const double side = dot(shape(v, n).normal, d);
      any_above = any_above || side >= clear;
      any_below = any_below || side <= -clear;
      all_above = all_above && side >= clear;
      all_below = all_below && side <= -clear;
    }
    const std::array<int, 2>& labels = complex_->umbrella(v, 0).labels;
    if(creases_[v] == CONVEX)
      return any_above ? labels[1] : all_below ? labels[0] : int(no_label);
    return any_below ? labels[0] : all_above ? labels[1] : int(no_label);
  }

private:
  // How the umbrellas at a vertex meet, seen from labels[0].
  enum Crease { UNCLEAR, CONVEX, REFLEX };

  void measure(const std::vector<Site>& sites)
  {
    const std::vector<Boundary_facet>& facets = complex_->facets();
    std::vector<Vector> area(facets.size());
    for(std::size_t n = 0; n < facets.size(); ++n)
    {
      area[n] = area_vector(facets[n].vertices, sites);
      for(int k = 0; k < 3; ++k)
        add_corner(static_cast<int>(3 * n) + k, area[n], sites);
    }
    for(int n = 0; n < complex_->number_of_umbrellas(); ++n)
    {
      normalize(shapes_[n].normal);
      shapes_[n].is_smooth = complex_->umbrella(n).is_disk;
    }
    for(std::size_t n = 0; n < facets.size(); ++n)
    {
      normalize(area[n]);
      for(int k = 0; k < 3; ++k)
        add_bend(static_cast<int>(3 * n) + k, area[n]);
    }
    for(int v = 0; v < complex_->number_of_vertices(); ++v)
      creases_[v] = crease(v);
  }

  Umbrella_shape& shape_of_corner(int corner) { return shapes_[complex_->umbrella_of_corner(corner)]; }

  // Whether the normals of facet and umbrella point to the same side, as a sign.
  double orientation(int corner) const
  {
    const Boundary_umbrella& umbrella = complex_->umbrella(complex_->umbrella_of_corner(corner));
    return complex_->facets()[corner / 3].labels[0] == umbrella.labels[0] ? 1 : -1;
  }

  void add_corner(int corner, const Vector& area, const std::vector<Site>& sites)
  {
    const std::array<int, 3>& t = complex_->facets()[corner / 3].vertices;
    const Site& s = sites[t[corner % 3]];
    Umbrella_shape& u = shape_of_corner(corner);
    const double sign = orientation(corner);
    for(int i = 0; i < 3; ++i)
      u.normal[i] += sign * area[i];
    for(int m = 1; m < 3; ++m)
    {
      const Site& to = sites[t[(corner + m) % 3]];
      const Vector edge = {{ to.x - s.x, to.y - s.y, to.z - s.z }};
      for(int i = 0; i < 3; ++i)
        u.toward[i] += edge[i];
      u.shortest_edge = (std::min)(u.shortest_edge, std::sqrt(dot(edge, edge)));
    }
  }

  void add_bend(int corner, const Vector& facet_normal)
  {
    Umbrella_shape& u = shape_of_corner(corner);
    const double cosine = orientation(corner) * dot(facet_normal, u.normal);
    if(!(cosine >= smallest_cosine))
      u.is_smooth = false;
    u.bend = (std::max)(u.bend, std::sqrt((std::max)(0., 1 - cosine * cosine)));
  }

  Crease crease(int v) const
  {
    const int number = complex_->number_of_umbrellas(v);
    bool convex = number > 0, reflex = number > 0;
    for(int n = 0; n < number; ++n)
    {
      const std::array<int, 2>& labels = complex_->umbrella(v, n).labels;
      if(labels != complex_->umbrella(v, 0).labels || labels[0] == labels[1])
        return UNCLEAR;
      for(int m = 0; m < number; ++m)
        if(m != n)
        {
          const double above = dot(shape(v, n).normal, shape(v, m).toward);
          convex = convex && above <= 0;
          reflex = reflex && above >= 0;
        }
    }
    return convex ? CONVEX : reflex ? REFLEX : UNCLEAR;
  }

  static double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

  // Twice the area, pointing to side 1.
  static Vector area_vector(const std::array<int, 3>& t, const std::vector<Site>& s)
  {
    const double ax = s[t[1]].x - s[t[0]].x, ay = s[t[1]].y - s[t[0]].y, az = s[t[1]].z - s[t[0]].z;
    const double bx = s[t[2]].x - s[t[0]].x, by = s[t[2]].y - s[t[0]].y, bz = s[t[2]].z - s[t[0]].z;
    return {{ ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx }};
  }

  static void normalize(Vector& n)
  {
    const double length = std::sqrt(dot(n, n));
    if(length > 0)
      for(double& x : n)
        x /= length;
  }

  std::shared_ptr<const Boundary_complex_3> complex_;
  std::vector<Umbrella_shape> shapes_;
  std::vector<Crease> creases_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SURFACE_BOUNDARY_GEOMETRY_3_H
