// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_TRIAL_PREDICATES_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_TRIAL_PREDICATES_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Exact_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/enum.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Predicates for existing and possible cells of the exact triangulation, with one vertex moved: evaluated in floating-point numbers
// if the sign is certain, and otherwise as the triangulation does, with its perturbation.
class Trial_predicates_3
{
public:
  // Keeps a reference to the sites.
  explicit Trial_predicates_3(const std::vector<Site>& sites)
    : sites_(sites)
  {}

  int vertex() const { return vertex_; }

  // The site of any vertex; the vertex in question is at its trial place.
  const Site& site(int v) const { return v == vertex_ ? site_ : sites_[v]; }

  template <std::size_t n>
  std::array<Site, n> sites(const std::array<int, n>& vertices) const
  {
    std::array<Site, n> result;
    for(std::size_t i = 0; i < n; ++i)
      result[i] = site(vertices[i]);
    return result;
  }

  // The sphere of a positive cell or, if the cell is infinite, the plane of its finite facet.
  struct Sphere
  {
    Quadruple vertices;
    int infinite;                               // the index of the infinite vertex, or 4
    Cell_sphere products;                       // or the normal of the plane
    double squared_length, length;              // of its edges and weights
  };

  void set_vertex(int v)
  {
    vertex_ = v;
    move_vertex(sites_[v]);
  }

  void move_vertex(const Site& s)
  {
    site_ = s;
    point_ = weighted_point(s);
  }

  Sphere sphere(const Quadruple& q) const
  {
    Sphere result;
    result.vertices = q;
    result.infinite = index_of(q, -1);
    if(result.infinite == 4)
    {
      const std::array<Site, 4> s = sites(q);
      const Cell_products t(s[0], s[1], s[2], s[3]);
      result.products = t;
      result.squared_length = (std::max)({ t.aa, t.bb, t.cc, std::abs(s[0].weight), std::abs(s[1].weight), std::abs(s[2].weight),
                                           std::abs(s[3].weight) });
      result.length = std::sqrt(result.squared_length);
      return result;
    }
    const Triple t = facet_vertices(q, result.infinite);
    const Vector_3 origin = position(site(t[0]));
    const Vector_3 a = position(site(t[1])) - origin, b = position(site(t[2])) - origin, normal = a.cross(b);
    result.products = Cell_sphere{ 0, normal[0], normal[1], normal[2] };
    result.squared_length = (std::max)(a.squared_length(), b.squared_length());
    return result;
  }

  // Whether the vertex in question, or another one, is in conflict with the cell.
  bool is_in_conflict(const Sphere& s) const { return is_in_conflict(s, vertex_); }

  // Without perturbation, a site on the sphere is not in conflict.
  bool is_in_conflict(const Sphere& s, int v, bool perturbs = true) const
  {
    const Site& q = site(v);
    double value, bound;
    if(s.infinite == 4)
    {
      const Site& origin = site(s.vertices[0]);
      const double x = q.x - origin.x, y = q.y - origin.y, z = q.z - origin.z;
      const double r = x * x + y * y + z * z + std::abs(q.weight) + std::abs(origin.weight), l = s.squared_length;
      value = -s.products.power(origin, q);
      // Twice the geometric mean of the two is at most their sum.
      bound = filter * l * s.length * (1.5 * r + 0.5 * l);
    }
    else
    {
      const Vector_3 way = position(site(s.vertices[facet_indices(s.infinite)[0]])) - position(q);
      value = way.dot(Vector_3(s.products.nx, s.products.ny, s.products.nz));
      bound = filter * s.squared_length * way.length();
    }
    return value > bound || (!(value < -bound) && is_exactly_in_conflict(s, point(v), perturbs));
  }

  // Whether the cell is positively oriented; infinite cells count as such.
  bool is_positive(const Quadruple& q) const
  {
    if(*std::min_element(q.begin(), q.end()) < 0)
      return true;
    const std::array<Site, 4> s = sites(q);
    const Cell_products t(s[0], s[1], s[2], s[3]);
    const double bound = filter * t.cubed_length();
    return t.determinant > bound
           || (!(t.determinant < -bound) && CGAL::orientation(point(q[0]).point(), point(q[1]).point(), point(q[2]).point(),
                                                              point(q[3]).point()) == POSITIVE);
  }

private:
  static constexpr double filter = 1e-13;                   // relative error of the filtered expressions

  Weighted_point point(int v) const { return v == vertex_ ? point_ : weighted_point(sites_[v]); }

  bool is_exactly_in_conflict(const Sphere& s, const Weighted_point& p, bool perturbs) const
  {
    const Quadruple& v = s.vertices;
    // Perturbation cannot order two points at one place. Such a trial fails later, since no cell with both is positive.
    if(std::any_of(v.begin(), v.end(), [&](int w) { return w >= 0 && point(w).point() == p.point(); }))
      return false;
    if(s.infinite == 4)
      return exact_.side_of_oriented_power_sphere(point(v[0]), point(v[1]), point(v[2]), point(v[3]), p, perturbs) == ON_POSITIVE_SIDE;
    const Triple t = facet_vertices(v, s.infinite);
    const Weighted_point a = point(t[0]), b = point(t[1]), c = point(t[2]);
    const Orientation side = CGAL::orientation(p.point(), a.point(), b.point(), c.point());
    return side == POSITIVE
           || (side == COPLANAR && exact_.side_of_bounded_power_circle(a, b, c, p, perturbs) == ON_BOUNDED_SIDE);
  }

  const std::vector<Site>& sites_;
  Exact_triangulation_3 exact_;                 // empty
  int vertex_ = -1;
  Site site_ = { 0, 0, 0, 0 };
  Weighted_point point_;                        // at its trial place
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_TRIAL_PREDICATES_3_H
