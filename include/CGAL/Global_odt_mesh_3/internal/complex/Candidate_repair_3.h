// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CANDIDATE_REPAIR_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CANDIDATE_REPAIR_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Defect_report_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Working_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Moves a vertex of a candidate to the surface that it moves on; false if there is no such point nearby.
inline bool put_on_surface(Complex_candidate_3& candidate, const Domain_view_3& domain, int v)
{
  constexpr double farthest_projection = 1;       // over the shortest edge
  const Boundary_geometry_3& boundary = candidate.measured_boundary;
  const Umbrella_shape& shape = boundary.shape(v, 0);
  Site& s = candidate.sites[v];
  Eigen::Vector3d p = position(s);
  if(!domain.project(p, shape.normal, farthest_projection * shape.shortest_edge, boundary.complex().umbrella(v, 0).patch))
    return false;
  s = site_at(p, s.weight);
  return true;
}

// The same for all vertices that have moved on surfaces; those for which that fails go back.
inline void put_on_surfaces(Complex_candidate_3& candidate, const Domain_view_3& domain)
{
  domain.for_each(candidate.numbering.number_of_surface_vertices(), [&](int n)
  {
    const int v = candidate.numbering.number_of_interior_vertices + n;
    if(!candidate.is_reverted(v) && !put_on_surface(candidate, domain, v))
      candidate.sites[v] = candidate.revert_sites[v];
  });
}

// Moves the vertices of a candidate at which something is wrong toward where they were.
class Candidate_repair_3
{
public:
  // `rebuild()` makes the triangulation of the candidate anew.
  Candidate_repair_3(Complex_candidate_3& candidate, const Domain_view_3& domain, std::function<void()> rebuild)
    : candidate_(candidate)
    , domain_(domain)
    , rebuild_(std::move(rebuild))
  {}

  void apply(const Defect_report_3& report, int attempt)
  {
    for(int v : report.offending_vertices())
      if(candidate_.is_reverted(v))
        candidate_.revert_to_input(v);
    const std::set<int> offending = offending_vertices(report, attempt);
    const bool rebuilds = !candidate_.working.is_worth_moving(offending.size());
    for(int v : offending)
    {
      if(!candidate_.numbering.is_movable(v) || candidate_.is_reverted(v))
        continue;
      send_back(v, attempt);
      if(!rebuilds)
        candidate_.move(v);
    }
    if(rebuilds)
      rebuild_();
    const auto has_moved = [&](int v) { return offending.count(v) > 0; };
    for(auto it = candidate_.known_distances.begin(); it != candidate_.known_distances.end(); )
      it = std::any_of(it->first.begin(), it->first.end(), has_moved) ? candidate_.known_distances.erase(it) : std::next(it);
    candidate_.measure();
  }

private:
  // In these, vertices go back half way first; then they revert, along with more and more neighbors.
  static constexpr int patient_attempts = 10, attempts_per_ring = 3;
  static constexpr int halfway_returns = 2, halfway_returns_on_surface = 1;

  // Those of the report, and around them.
  std::set<int> offending_vertices(const Defect_report_3& report, int attempt) const
  {
    Vertex_rings_3 region(candidate_.working, report.offending_vertices());
    for(int ring = patient_attempts; ring <= attempt; ring += attempts_per_ring)
      region.grow();
    return std::set<int>(region.vertices().begin(), region.vertices().end());
  }

  void send_back(int v, int attempt)
  {
    const bool on_surface = !candidate_.numbering.is_interior(v);
    const int most = on_surface ? halfway_returns_on_surface : halfway_returns;
    const bool is_halfway = attempt < patient_attempts && candidate_.vertices_sent_back[v]++ < most;
    Site& s = candidate_.sites[v];
    const Site& home = candidate_.revert_sites[v];
    s = is_halfway ? site_at((position(s) + position(home)) / 2, home.weight) : home;
    if(on_surface && is_halfway && !put_on_surface(candidate_, domain_, v))
      s = home;
  }

  Complex_candidate_3& candidate_;
  const Domain_view_3& domain_;
  std::function<void()> rebuild_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CANDIDATE_REPAIR_3_H
