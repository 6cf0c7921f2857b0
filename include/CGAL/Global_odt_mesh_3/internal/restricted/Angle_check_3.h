// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_ANGLE_CHECK_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_ANGLE_CHECK_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_report_3.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// What the dihedral angles, in degrees, of new cells have to reach: at one of the vertices, the least angle that is
// there; but no more than `enough`.
struct Least_angles
{
  double enough;
  std::vector<double> at_vertex;
};

// No cell may be worse than all that there has been around each of its vertices.
template <class Domain, class Candidate>
Restricted_report_3<Candidate> check_angles(const Candidate& candidate, Domain& domain, const Least_angles& least)
{
  constexpr double rounding = 1e-6;
  Restricted_report_3<Candidate> report(candidate);
  const Angle_deficit_3 deficit(least.enough);
  const auto& tr = candidate.triangulation();
  for(auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
  {
    if(domain.label(c->subdomain_index()) == domain.outside())
      continue;
    const typename Candidate::Quadruple q = candidate.numbers(c);
    double lack = 0, least_there = least.enough;
    const std::vector<Site>& s = candidate.sites;
    deficit.for_each_lack(std::array<Site, 4>{{ s[q[0]], s[q[1]], s[q[2]], s[q[3]] }}, [&lack](double l) { lack = (std::max)(lack, l); });
    if(!(lack > 0))
      continue;
    for(int v : q)
      least_there = (std::min)(least_there, least.at_vertex[v]);
    if(least.enough - lack < least_there - rounding)
      report.send_back(q);
  }
  return report;
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_ANGLE_CHECK_3_H
