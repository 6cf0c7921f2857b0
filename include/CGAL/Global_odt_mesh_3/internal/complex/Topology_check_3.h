// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_TOPOLOGY_CHECK_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_TOPOLOGY_CHECK_3_H

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Defect_report_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Working_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The vertices at which the boundary of the candidate is not what it has to be.
inline std::set<int> topology_changes(const Complex_candidate_3& candidate)
{
  std::set<int> result = topology_changes(candidate.snapshot.boundary.complex(), *candidate.boundary_complex);
  for(const Boundary_facet& f : candidate.boundary_complex->facets())
    if(f.patch == Complex_candidate_3::unknown_patch)
      result.insert(f.vertices.begin(), f.vertices.end());
  return result;
}

// Whether a boundary that moves has the topology of that of the snapshot. Where it has not, the vertices of
// the facets that have come or gone go back.
inline Defect_report_3 check_topology(const Complex_candidate_3& candidate)
{
  Defect_report_3 report(candidate);
  const std::set<int> changed = topology_changes(candidate);
  if(changed.empty())
    return report;
  std::map<int, std::vector<int> > around;
  for(const std::array<int, 3>& t : exchanged_facets(candidate.snapshot.boundary.complex(), *candidate.boundary_complex))
    for(int v : t)
      if(changed.count(v) > 0)
        around[v].insert(around[v].end(), t.begin(), t.end());
  for(int v : changed)
  {
    around[v].push_back(v);
    report.send_back(around[v]);
  }
  return report;
}

// Those of the vertices around a boundary facet that lie in its surface Delaunay ball.
inline std::vector<int> intruders(const Complex_candidate_3& candidate, const std::array<int, 3>& t, const Eigen::Vector3d& center)
{
  const Site& s = candidate.snapshot.sites[t[0]];
  const double radius = squared_distance(s, center) - s.weight;
  Vertex_rings_3 region(candidate.working, t);
  for(int ring = 0; ring < 2; ++ring)
    region.grow();
  std::vector<int> result;
  for(int v : region.vertices())
    if(candidate.numbering.is_movable(v) && squared_distance(candidate.sites[v], center) < radius)
      result.push_back(v);
  return result;
}

// Whether a boundary at rest has the facets of the snapshot. One that is missing has a vertex in its surface
// Delaunay ball; another has other subdomains on its sides.
inline Defect_report_3 check_facets_stay(const Complex_candidate_3& candidate)
{
  Defect_report_3 report(candidate);
  const std::vector<Boundary_facet>& facets = candidate.snapshot.boundary.complex().facets();
  std::vector<char> is_found(facets.size(), false);
  for(std::size_t n = 0; n < candidate.old_facets.size(); ++n)
  {
    const int old = candidate.old_facets[n];
    const Boundary_facet& f = candidate.boundary_complex->facets()[n];
    if(old >= 0)
      is_found[old] = true;
    if(old < 0 || !Boundary_complex_3::same_labels(f.labels, facets[old].labels))
      report.send_back(f.vertices);
  }
  for(std::size_t n = 0; n < is_found.size(); ++n)
    if(!is_found[n])
    {
      const std::array<int, 3>& t = facets[n].vertices;
      const std::vector<int> inside = intruders(candidate, t, candidate.snapshot.centers[n].point);
      if(inside.empty())
        report.send_back(t);
      else
        report.send_back(inside);
    }
  return report;
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_TOPOLOGY_CHECK_3_H
