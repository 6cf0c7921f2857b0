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
#include <CGAL/Global_odt_mesh_3/internal/complex/Defect_report_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Exact_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Surface_center_search_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Finds or, on the way, estimates the surface centers of a candidate: the points of the surface on the
// dual lines of its boundary facets. Reports facets without a center.
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
    const Surface_center_search_3 search(candidate_.sites, candidate_.triangulation(), domain_);
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
      // One that is not found anew stays as it was.
      const Surface_center known = center;
      search.search(candidate_.facets[n], vertices(n), center);
      if(!center.is_exact)
        center = known;
      is_lost[n] = !center.is_exact;
    });
    for(std::size_t n = 0; n < candidate_.facets.size(); ++n)
      if(is_lost[n])
        report.send_back(vertices(n));
    return report;
  }

private:
  typedef Complex_candidate_3::Surface_center Surface_center;

  const Triple& vertices(std::size_t facet) const { return candidate_.boundary_complex->facets()[facet].vertices; }

  // That of the snapshot if nothing has changed, or else an estimate.
  Surface_center known_center(const Triple& t, int old) const
  {
    if(old >= 0 && candidate_.is_unchanged(t))
      return candidate_.snapshot.centers[old];
    return { estimated_surface_center(t, candidate_.boundary, candidate_.sites), Boundary_facet::no_patch };
  }

  Complex_candidate_3& candidate_;
  const Domain_view_3& domain_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SURFACE_CENTERS_3_H
