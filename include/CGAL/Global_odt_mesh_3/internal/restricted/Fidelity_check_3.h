// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_FIDELITY_CHECK_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_FIDELITY_CHECK_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_dual_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_report_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// No centroid of a boundary facet may be farther from the surface than the worst of
// the input, where the domain tells distances.
template <class Domain>
class Fidelity_check_3
{
public:
  typedef Restricted_candidate_3<typename Domain::Triangulation> Candidate;
  typedef typename Candidate::State State;
  typedef typename Candidate::Triple Triple;

  explicit Fidelity_check_3(Domain& domain)
    : domain_(domain)
  {}

  void measure(const State& input)
  {
    if(!Domain::tells_distances)
      return;
    for(const Boundary_facet& f : input.boundary.complex().facets())
      farthest_centroid_ = (std::max)(farthest_centroid_,
                                      domain_.distance_to_surface(centroid(sorted(f.vertices), input.sites)));
  }

  // Whether a boundary facet may have its centroid there.
  bool is_close(const Eigen::Vector3d& point) const
  {
    return !Domain::tells_distances || domain_.distance_to_surface(point) <= farthest_centroid_;
  }

  // Whether these vertices may be those of a boundary facet.
  bool is_faithful(Candidate& candidate, const Triple& facet) const
  {
    if(!Domain::tells_distances)
      return true;
    const Triple t = sorted(facet);
    const auto known = candidate.known_distances.find(t);
    if(known != candidate.known_distances.end())
      return known->second <= farthest_centroid_;
    const double distance = domain_.distance_to_surface(centroid(t, candidate.sites));
    candidate.known_distances.emplace(t, distance);
    return distance <= farthest_centroid_;
  }

  Restricted_report_3<Candidate> check(Candidate& candidate) const
  {
    Restricted_report_3<Candidate> report(candidate);
    for(std::size_t n = 0; Domain::tells_distances && n < candidate.facets.size(); ++n)
    {
      if(candidate.centers[n].is_faithful)
        continue;
      const Triple& t = candidate.boundary_complex->facets()[n].vertices;
      candidate.centers[n].is_faithful = is_faithful(candidate, t);
      if(!candidate.centers[n].is_faithful)
        report.send_back(t);
    }
    return report;
  }

private:
  Domain& domain_;
  double farthest_centroid_ = 0;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_FIDELITY_CHECK_3_H
