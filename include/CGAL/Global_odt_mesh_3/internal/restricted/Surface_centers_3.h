// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_SURFACE_CENTERS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_SURFACE_CENTERS_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_dual_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Point_coordinates.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Cell_knowledge.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Cell_mending_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Domain_oracle_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Estimated_surface_center_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Guilty_vertices_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_draft_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <unordered_map>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Finds or estimates the surface centers of a draft: the points of the surface on the
// dual lines of its boundary facets.
template <class Triangulation, class Mesh_domain>
class Surface_centers_3
{
public:
  typedef Restricted_draft_3<Triangulation, Mesh_domain> Draft;
  typedef typename Draft::Complex Complex;
  typedef Domain_oracle_3<Mesh_domain> Oracle;
  typedef Guilty_vertices_3<Triangulation, Mesh_domain> Guilty_vertices;
  typedef Cell_mending_3<Triangulation, Mesh_domain> Cell_mending;

  Surface_centers_3(Complex& complex, Draft& draft, Oracle& oracle, Guilty_vertices& guilty,
                    Cell_mending& mending)
    : complex_(complex)
    , draft_(draft)
    , oracle_(oracle)
    , guilty_(guilty)
    , mending_(mending)
  {}

  // For a new draft.
  void start() { found_.clear(); }

  // What was found holds until vertices of the facet move.
  void forget_facets_of(const Guilty_vertices& guilty) { guilty.erase_from(found_); }

  void find_surface_centers()
  {
    draft_.boundary.measure_umbrellas(draft_.sites);
    draft_.centers.resize(draft_.facets.size());
    for(std::size_t n = 0; n < draft_.facets.size(); ++n)
    {
      const Triple& t = draft_.boundary.facets()[n].vertices;
      const int old = draft_.old_facets[n];
      Surface_center& center = draft_.centers[n];
      if(old >= 0 && draft_.is_unchanged(t))
        center = complex_.centers[old];
      else
      {
        const Vector p = estimated_surface_center(t, draft_.boundary, draft_.sites);
        center = { p, Bare_point(p[0], p[1], p[2]), old >= 0 ? complex_.centers[old].index : Index(), false };
      }
      if(!draft_.mode.finds_centers)
        continue;
      if(!center.is_exact)
        put_on_surface(n, center);
      // Without a center, the facet is better where it was, if that helps.
      if(center.is_exact)
        check_duals(n);
      else
        guilty_.blame_displaced(t);
    }
  }

private:
  typedef typename Triangulation::Bare_point Bare_point;
  typedef typename Draft::Cell_handle Cell_handle;
  typedef typename Draft::Facet Facet;
  typedef typename Draft::Surface_center Surface_center;
  typedef typename Draft::Triple Triple;
  typedef typename Draft::Quadruple Quadruple;
  typedef typename Complex::Index Index;
  typedef std::array<double, 3> Vector;

  // The middle from where the surface is expected, and half the length, over the radius of the facet.
  // Both ends of a segment across a thin part are outside, hence those to one side only.
  static constexpr double segments_to_search[][2] = { { 0, 0.3 }, { 0, 1 }, { 0.15, 0.15 }, { -0.15, 0.15 },
                                                      { 0.5, 0.5 }, { -0.5, 0.5 }, { 0, 3 } };

  // Leaves what is known of the facet's centroid.
  static void put_at(const Vector& p, const Index& index, Surface_center& center)
  {
    center.point = p;
    center.stored = Bare_point(p[0], p[1], p[2]);
    center.index = index;
    center.is_exact = true;
  }

  void put_on_surface(std::size_t n, Surface_center& center)
  {
    const Triple& t = draft_.boundary.facets()[n].vertices;
    const auto known = found_.find(t);
    if(known != found_.end())
    {
      center = known->second;
      return;
    }
    const Facet_dual_3 dual(t, draft_.sites);
    for(const auto& s : segments_to_search)
    {
      Vector p = center.point;
      for(int i = 0; i < 3; ++i)
        p[i] += s[0] * dual.radius * dual.normal[i];
      Index index;
      if(!oracle_.intersect(p, dual.normal, s[1] * dual.radius, index))
        continue;
      put_at(p, index, center);
      break;
    }
    if(!center.is_exact)
      put_on_dual_segment(n, dual, center);
    found_.emplace(t, center);
  }

  // Where the surface is far from the facet, it is crossed between the dual points of its cells.
  void put_on_dual_segment(std::size_t n, const Facet_dual_3& dual, Surface_center& center)
  {
    const Triangulation& tr = draft_.triangulation();
    const Cell_handle c = draft_.facets[n].first, d = c->neighbor(draft_.facets[n].second);
    if(tr.is_infinite(c) || tr.is_infinite(d))
      return;
    const double from = dual.height(coordinates(tr.dual(c))), to = dual.height(coordinates(tr.dual(d)));
    Vector p = dual.point_at((from + to) / 2);
    Index index;
    if(oracle_.intersect(p, dual.normal, std::abs(to - from) / 2, index))
      put_at(p, index, center);
  }

  // The dual points of the cells at a facet lie on the two sides of its center.
  void check_duals(std::size_t n)
  {
    const Triangulation& tr = draft_.triangulation();
    const Boundary_facet& facet = draft_.boundary.facets()[n];
    const Facet_dual_3 dual(facet.vertices, draft_.sites);
    const Vector& p = draft_.centers[n].point;
    const Facet f = draft_.facets[n];
    for(int side = 0; side < 2; ++side)
    {
      const Cell_handle c = side == 0 ? f.first : f.first->neighbor(f.second);
      if(tr.is_infinite(c) || knows(c, IS_BOUNDARY_CELL) || knows(c, IS_FROM_ORACLE))
        continue;
      const Quadruple q = draft_.numbers(c);
      const Bare_point d = tr.dual(c);
      const double beyond = (dual.height(coordinates(d)) - dual.height(p)) * (side == 0 ? 1 : -1);
      const int label = facet.labels[side];
      if(beyond > 0 && complex_.labels.number(oracle_.subdomain(d)) != label && !mending_.is_excused(q))
        mending_.mend_cell(q, label);
    }
  }

  Complex& complex_;
  Draft& draft_;
  Oracle& oracle_;
  Guilty_vertices& guilty_;
  Cell_mending& mending_;
  std::unordered_map<Triple, Surface_center, Hash_vertex_tuple> found_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_SURFACE_CENTERS_3_H
