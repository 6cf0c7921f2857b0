// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_FACET_CHECKS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_FACET_CHECKS_3_H

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Defect_report_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The cosine of the smallest angle.
inline double largest_cosine(const std::array<int, 3>& facet, const std::vector<Site>& sites)
{
  double largest = -1;
  for(int k = 0; k < 3; ++k)
  {
    const Eigen::Vector3d apex = position(sites[facet[k]]);
    const Eigen::Vector3d a = position(sites[facet[(k + 1) % 3]]) - apex;
    const Eigen::Vector3d b = position(sites[facet[(k + 2) % 3]]) - apex;
    largest = (std::max)(largest, a.dot(b) / (a.norm() * b.norm()));
  }
  return largest;
}

// Keeps the angles of boundary facets from falling below the smallest one of the input, or below 30 degrees if that
// is less.
class Facet_shape_check_3
{
public:
  void measure(const Boundary_complex_3& input, const std::vector<Site>& sites)
  {
    for(const Boundary_facet& f : input.facets())
      largest_cosine_ = (std::max)(largest_cosine_, largest_cosine(f.vertices, sites));
  }

  // What angles may be, in degrees.
  double smallest_angle() const { return std::acos(largest_cosine_) * 180 / CGAL_PI; }

  // Whether these vertices may be those of a boundary facet.
  bool is_good(const std::array<int, 3>& facet, const std::vector<Site>& sites) const
  {
    return largest_cosine(facet, sites) <= largest_cosine_;
  }

  // Sends back vertices of facets that have become too thin.
  void check(const Complex_candidate_3& candidate, Defect_report_3& report) const
  {
    for(std::size_t n = 0; n < candidate.old_facets.size(); ++n)
    {
      const std::array<int, 3>& t = candidate.boundary_complex->facets()[n].vertices;
      if(!is_good(t, candidate.sites) && !(candidate.old_facets[n] >= 0 && candidate.are_reverted(t))
         && candidate.exempt_facets.count(sorted(t)) == 0)
        report.send_back_around(t);
    }
  }

private:
  double largest_cosine_ = 0.8660254037844386;    // that of 30 degrees
};

// No centroid of a boundary facet may be farther from the surface than the worst of
// the input, where the domain tells distances.
class Fidelity_check_3
{
public:
  explicit Fidelity_check_3(const Domain_view_3& domain)
    : domain_(domain)
  {}

  void measure(const Complex_snapshot_3& input)
  {
    if(!domain_.tells_distances())
      return;
    const std::vector<Boundary_facet>& facets = input.boundary.complex().facets();
    std::vector<double> distances(facets.size());
    domain_.for_each(facets.size(), [&](int n) { distances[n] = distance(sorted(facets[n].vertices), input.sites); });
    for(double d : distances)
      farthest_centroid_ = (std::max)(farthest_centroid_, d);
  }

  // Whether a boundary facet may have its centroid there.
  bool is_close(const Eigen::Vector3d& point) const
  {
    return !domain_.tells_distances() || domain_.distance_to_surface(point) <= farthest_centroid_;
  }

  // Whether these vertices may be those of a boundary facet.
  bool is_faithful(Complex_candidate_3& candidate, const Triple& facet) const
  {
    if(!domain_.tells_distances())
      return true;
    const Triple t = sorted(facet);
    const auto known = candidate.known_distances.find(t);
    if(known != candidate.known_distances.end())
      return known->second <= farthest_centroid_;
    return candidate.known_distances.emplace(t, distance(t, candidate.sites)).first->second <= farthest_centroid_;
  }

  Defect_report_3 check(Complex_candidate_3& candidate) const
  {
    Defect_report_3 report(candidate);
    if(!domain_.tells_distances())
      return report;
    const auto vertices = [&](int n) { return sorted(candidate.boundary_complex->facets()[n].vertices); };
    const int number = static_cast<int>(candidate.facets.size());
    std::vector<double> distances(number, 0);
    const std::vector<int> in_question = collect_in_chunks(number, candidate.threads, [&](int n, std::vector<int>& unknown)
    {
      if(candidate.centers[n].is_faithful)
        return;
      const auto known = candidate.known_distances.find(vertices(n));
      if(known != candidate.known_distances.end())
        distances[n] = known->second;
      else
        unknown.push_back(n);
    });
    domain_.for_each(in_question.size(), [&](int k)
    {
      const int n = in_question[k];
      distances[n] = distance(vertices(n), candidate.sites);
    });
    for(int n : in_question)
      candidate.known_distances.emplace(vertices(n), distances[n]);
    candidate.far_facets.clear();
    for(int n = 0; n < number; ++n)
    {
      if(candidate.centers[n].is_faithful)
        continue;
      candidate.centers[n].is_faithful = distances[n] <= farthest_centroid_;
      if(candidate.centers[n].is_faithful)
        continue;
      const Triple& t = candidate.boundary_complex->facets()[n].vertices;
      if(candidate.exempt_facets.count(sorted(t)) > 0)
        candidate.far_facets.insert(sorted(t));
      else
        report.send_back(t);
    }
    return report;
  }

private:
  double distance(const Triple& facet, const std::vector<Site>& sites) const
  {
    return domain_.distance_to_surface(centroid(facet, sites));
  }

  const Domain_view_3& domain_;
  double farthest_centroid_ = 0;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_FACET_CHECKS_3_H
