// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SURFACE_CENTERS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SURFACE_CENTERS_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Defect_report_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Labelled_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Finds where the dual line of a facet meets the surface: on the dual segment if that joins two subdomains.
class Surface_center_search_3
{
public:
  typedef Complex_snapshot_3::Surface_center Surface_center;

  // Keeps references to its arguments.
  Surface_center_search_3(const Labelled_triangulation_3& triangulation, const Domain_view_3& domain)
    : triangulation_(triangulation)
    , domain_(domain)
  {}

  // Puts the center of a facet with these vertices, searched for near its present point, onto the surface, or marks it as not
  // exact.
  void search(Half_facet facet, const Triple& t, Surface_center& center) const
  {
    const Facet_dual_3 dual(t, triangulation_.sites());
    if(!search_near(dual, center) || !is_between_subdomains(facet, t, center))
      put_on_dual_segment(facet, dual, center);
    if(!center.is_exact)
      put_on_facet(centroid(t, triangulation_.sites()), center);
  }

  // In a mesh that is its own domain, the centroid of the facet replaces the center, since dual lines of flat facets miss thin
  // parts. Whether the domain is such a mesh.
  bool put_on_facet(const Vector_3& centroid, Surface_center& center) const
  {
    center.is_exact = domain_.has_cells_of_mesh();
    if(!center.is_exact)
      return false;
    center.point = centroid;
    domain_.put_on_surface(center.point, center.patch);
    center.source = Mesh_table_3::no_facet;
    return true;
  }

  // Searches for the center near its present point, whatever the cells beside the facet are; whether it is found.
  bool search_near(const Facet_dual_3& dual, Surface_center& center) const
  {
    center.is_exact = false;
    const Vector_3 expected = center.point;
    return std::any_of(std::begin(segments_to_search), std::end(segments_to_search), [&](const double (&s)[2])
                       { return put_on_segment(expected + s[0] * dual.radius * dual.normal, dual.normal, s[1] * dual.radius, center); });
  }

  // Whether a center is on the dual segment; true if that is infinite or does not join two subdomains.
  bool is_between_subdomains(Half_facet facet, const Triple& t, const Surface_center& center) const
  {
    const int c = facet.cell(), d = triangulation_.mirror(facet).cell();
    if(triangulation_.is_infinite(c) || triangulation_.is_infinite(d) || triangulation_.label(c) == triangulation_.label(d))
      return true;
    const Facet_dual_3 dual(t, triangulation_.sites());
    const auto ends = std::minmax({ dual.height(triangulation_.dual_point(c)), dual.height(triangulation_.dual_point(d)) });
    const double height = dual.height(center.point);
    return ends.first <= height && height <= ends.second;
  }

private:
  // Segments of the dual line: the offset of the middle from the expected point, and half the length, over the radius of the facet.
  // A segment across a thin part may have both ends outside, hence segments to one side only.
  static constexpr double segments_to_search[][2] = { { 0, 0.3 }, { 0, 1 }, { 0.15, 0.15 }, { -0.15, 0.15 },
                                                      { 0.5, 0.5 }, { -0.5, 0.5 }, { 0, 3 } };

  bool put_on_segment(Vector_3 middle, const Vector_3& direction, double half_length, Surface_center& center) const
  {
    int patch;
    if(!domain_.intersect(middle, direction, half_length, patch))
      return false;
    center.point = middle;
    center.patch = patch;
    center.source = Mesh_table_3::no_facet;
    center.is_exact = true;
    return true;
  }

  // If the surface is far from the facet, the search goes between the dual points of its cells.
  void put_on_dual_segment(Half_facet facet, const Facet_dual_3& dual, Surface_center& center) const
  {
    const int c = facet.cell(), d = triangulation_.mirror(facet).cell();
    if(triangulation_.is_infinite(c) || triangulation_.is_infinite(d))
      return;
    const double from = dual.height(triangulation_.dual_point(c)), to = dual.height(triangulation_.dual_point(d));
    put_on_segment(dual.point_at((from + to) / 2), dual.normal, std::abs(to - from) / 2, center);
  }

  const Labelled_triangulation_3& triangulation_;
  const Domain_view_3& domain_;
};

// Finds the surface centers of a candidate, the points of the surface on the dual lines of its boundary facets, or estimates them
// if the candidate is not final. Reports facets without a center.
class Surface_centers_3
{
public:
  Surface_centers_3(Complex_candidate_3& candidate, const Domain_view_3& domain)
    : candidate_(candidate)
    , domain_(domain)
  {}

  Defect_report_3 find_surface_centers()
  {
    Defect_report_3 report(candidate_);
    candidate_.boundary = Boundary_geometry_3(candidate_.boundary_complex, candidate_.sites);
    candidate_.centers.resize(candidate_.facets.size());
    const Surface_center_search_3 search(candidate_.triangulation, domain_);
    std::vector<char> is_lost(candidate_.facets.size(), false);
    domain_.for_each(candidate_.facets.size(), [&](int n)
    {
      Surface_center& center = candidate_.centers[n];
      center = known_center(vertices(n), candidate_.old_facets[n]);
      if(!candidate_.is_final)
        return;
      const bool is_good = center.is_exact && (!candidate_.boundary_moves()
                                               || search.is_between_subdomains(candidate_.facets[n], vertices(n), center));
      if(is_good)
        return;
      // A center that is not found again stays as it was.
      const Surface_center known = center;
      search.search(candidate_.facets[n], vertices(n), center);
      if(!center.is_exact)
        center = known;
      is_lost[n] = !center.is_exact;
    });
    for(std::size_t n = 0; n < candidate_.facets.size(); ++n)
      if(is_lost[n])
        report.revert(vertices(n));
    return report;
  }

private:
  typedef Complex_candidate_3::Surface_center Surface_center;

  const Triple& vertices(std::size_t facet) const { return candidate_.boundary_complex->facets()[facet].vertices; }

  // The center in the snapshot if the facet has not changed, or else one found by trials or an estimate.
  Surface_center known_center(const Triple& t, int old) const
  {
    if(old >= 0 && candidate_.is_unchanged(t))
      return candidate_.snapshot.centers[old];
    const auto found = candidate_.found_centers.find(sorted(t));
    if(found != candidate_.found_centers.end())
      return found->second;
    return { estimated_surface_center(t, candidate_.boundary, candidate_.sites), Boundary_facet::no_patch };
  }

  Complex_candidate_3& candidate_;
  const Domain_view_3& domain_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SURFACE_CENTERS_3_H
