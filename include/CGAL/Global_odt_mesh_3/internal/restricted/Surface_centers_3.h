// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_SURFACE_CENTERS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_SURFACE_CENTERS_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_dual_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Point_coordinates.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Cell_knowledge.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Dual_side_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Estimated_surface_center_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_report_3.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Finds or, on the way, estimates the surface centers of a candidate: the points of the surface on the
// dual lines of its boundary facets. Reports facets without a center, and cells whose dual points lie beyond one.
template <class Domain>
class Surface_centers_3
{
public:
  typedef Restricted_candidate_3<typename Domain::Triangulation> Candidate;
  typedef Restricted_report_3<Candidate> Report;

  Surface_centers_3(Candidate& candidate, Domain& domain)
    : candidate_(candidate)
    , domain_(domain)
  {}

  Report find_surface_centers()
  {
    Report report(candidate_);
    candidate_.boundary = Boundary_geometry_3(candidate_.boundary_complex, candidate_.sites);
    candidate_.centers.resize(candidate_.facets.size());
    for(std::size_t n = 0; n < candidate_.facets.size(); ++n)
    {
      const Triple& t = candidate_.boundary_complex->facets()[n].vertices;
      Surface_center& center = candidate_.centers[n];
      center = known_center(t, candidate_.old_facets[n]);
      if(!candidate_.is_final)
        continue;
      if(!center.is_exact)
        put_on_surface(n, center);
      // Without a center, the facet is better where it was, if that helps.
      if(center.is_exact)
        check_duals(n, report);
      else
        report.send_back_moved(t);
    }
    return report;
  }

private:
  typedef typename Candidate::Triangulation Triangulation;
  typedef typename Triangulation::Bare_point Bare_point;
  typedef typename Candidate::Cell_handle Cell_handle;
  typedef typename Candidate::Facet Facet;
  typedef typename Candidate::Surface_center Surface_center;
  typedef typename Candidate::Triple Triple;
  typedef typename Candidate::Quadruple Quadruple;
  typedef typename Candidate::State::Index Index;
  typedef Eigen::Vector3d Vector;

  // The middle from where the surface is expected, and half the length, over the radius of the facet.
  // Both ends of a segment across a thin part are outside, hence those to one side only.
  static constexpr double segments_to_search[][2] = { { 0, 0.3 }, { 0, 1 }, { 0.15, 0.15 }, { -0.15, 0.15 },
                                                      { 0.5, 0.5 }, { -0.5, 0.5 }, { 0, 3 } };

  // That of the state if nothing has changed, or else an estimate.
  Surface_center known_center(const Triple& t, int old) const
  {
    if(old >= 0 && candidate_.is_unchanged(t))
      return candidate_.state.centers[old];
    const Vector p = estimated_surface_center(t, candidate_.boundary, candidate_.sites);
    return { p, Bare_point(p[0], p[1], p[2]), old >= 0 ? candidate_.state.centers[old].index : Index(), false };
  }

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
    const Triple& t = candidate_.boundary_complex->facets()[n].vertices;
    const auto known = candidate_.known_centers.find(t);
    if(known != candidate_.known_centers.end())
    {
      center = known->second;
      return;
    }
    const Facet_dual_3 dual(t, candidate_.sites);
    for(const auto& s : segments_to_search)
    {
      Vector p = center.point + s[0] * dual.radius * dual.normal;
      Index index;
      if(!domain_.intersect(p, dual.normal, s[1] * dual.radius, index))
        continue;
      put_at(p, index, center);
      break;
    }
    if(!center.is_exact)
      put_on_dual_segment(n, dual, center);
    candidate_.known_centers.emplace(t, center);
  }

  // Where the surface is far from the facet, it is crossed between the dual points of its cells.
  void put_on_dual_segment(std::size_t n, const Facet_dual_3& dual, Surface_center& center)
  {
    const Triangulation& tr = candidate_.triangulation();
    const Cell_handle c = candidate_.facets[n].first, d = c->neighbor(candidate_.facets[n].second);
    if(tr.is_infinite(c) || tr.is_infinite(d))
      return;
    const double from = dual.height(coordinates(tr.dual(c))), to = dual.height(coordinates(tr.dual(d)));
    Vector p = dual.point_at((from + to) / 2);
    Index index;
    if(domain_.intersect(p, dual.normal, std::abs(to - from) / 2, index))
      put_at(p, index, center);
  }

  // The dual points of the cells at a facet lie on the two sides of its center.
  void check_duals(std::size_t n, Report& report)
  {
    const Triangulation& tr = candidate_.triangulation();
    const Boundary_facet& facet = candidate_.boundary_complex->facets()[n];
    const Facet_dual_3 dual(facet.vertices, candidate_.sites);
    const Vector& p = candidate_.centers[n].point;
    const Facet f = candidate_.facets[n];
    for(int side = 0; side < 2; ++side)
    {
      const Cell_handle c = side == 0 ? f.first : f.first->neighbor(f.second);
      if(tr.is_infinite(c) || knows(c, IS_BOUNDARY_CELL) || knows(c, IS_FROM_ORACLE))
        continue;
      const Quadruple q = candidate_.numbers(c);
      const Bare_point d = tr.dual(c);
      const double beyond = (dual.height(coordinates(d)) - dual.height(p)) * (side == 0 ? 1 : -1);
      const int label = facet.labels[side];
      if(beyond > 0 && domain_.label_at(d) != label && !is_tolerated(candidate_, q))
        report_cell_beyond_surface(candidate_, q, label, report);
    }
  }

  Candidate& candidate_;
  Domain& domain_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_SURFACE_CENTERS_3_H
