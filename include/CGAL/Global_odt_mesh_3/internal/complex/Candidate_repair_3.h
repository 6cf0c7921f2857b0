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
#include <CGAL/Global_odt_mesh_3/internal/complex/Defect_report_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Surface_projection_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Working_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <Eigen/Core>

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>
#include <utility>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Moves the vertices of a candidate at which something is wrong toward where they were, and those that are to be pushed.
class Candidate_repair_3
{
public:
  // `rebuild()` makes the triangulation of the candidate anew.
  Candidate_repair_3(Complex_candidate_3& candidate, Surface_projection_3& projection, std::function<void()> rebuild)
    : candidate_(candidate)
    , projection_(projection)
    , rebuild_(std::move(rebuild))
  {}

  // False if a vertex cannot be put back onto its surface.
  bool apply(const Defect_report_3& report, int attempt)
  {
    for(int v : report.offending_vertices())
      if(candidate_.is_reverted(v))
        candidate_.revert_to_input(v);
    const std::set<int> offending = offending_vertices(report, attempt);
    for(const auto& p : report.pushes())
      push(p.first, p.second, offending.count(p.first) > 0);
    const bool rebuilds = !candidate_.working.is_worth_moving(offending.size());
    for(int v : offending)
    {
      if(!candidate_.numbering.is_movable(v) || candidate_.is_reverted(v))
        continue;
      if(!send_back(v, attempt))
        return false;
      if(!rebuilds)
        candidate_.move(v);
    }
    if(rebuilds)
      rebuild_();
    else
      for(const auto& p : report.pushes())
        candidate_.move(p.first);
    const auto has_moved = [&](int v) { return offending.count(v) > 0 || report.pushes().count(v) > 0; };
    clear_facets(candidate_.known_centers, has_moved);
    clear_facets(candidate_.known_distances, has_moved);
    candidate_.measure();
    return true;
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

  void push(int v, const Eigen::Vector3d& by, bool goes_back)
  {
    ++candidate_.pushed_vertices[v];
    if(goes_back)
      return;
    Site& s = candidate_.sites[v];
    if(candidate_.numbering.is_interior(v))
    {
      s = site_at(position(s) + by, s.weight);
      return;
    }
    const Eigen::Vector3d& normal = candidate_.measured_boundary.shape(v, 0).normal;
    s = site_at(position(s) + by - normal.dot(by) * normal, s.weight);
    projection_.return_to_surface(v, true);
  }

  bool send_back(int v, int attempt)
  {
    const bool on_surface = !candidate_.numbering.is_interior(v);
    // On the way, few attempts matter more than long ways.
    const bool is_patient = attempt < patient_attempts && (!on_surface || candidate_.is_thorough());
    const int most = on_surface ? halfway_returns_on_surface : halfway_returns;
    const bool is_halfway = is_patient && candidate_.vertices_sent_back[v]++ < most;
    Site& s = candidate_.sites[v];
    const Site& home = candidate_.revert_sites[v];
    s = is_halfway ? site_at((position(s) + position(home)) / 2, home.weight) : home;
    return !on_surface || projection_.return_to_surface(v, is_halfway);
  }

  template <class Answers, class Predicate>
  static void clear_facets(Answers& answers, const Predicate& has_moved)
  {
    for(auto it = answers.begin(); it != answers.end(); )
      it = std::any_of(it->first.begin(), it->first.end(), has_moved) ? answers.erase(it) : std::next(it);
  }

  Complex_candidate_3& candidate_;
  Surface_projection_3& projection_;
  std::function<void()> rebuild_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CANDIDATE_REPAIR_3_H
