// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CANDIDATE_CHECKS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CANDIDATE_CHECKS_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Boundary_extraction_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Defect_report_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Facet_spheres_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Facet_weights_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Labelled_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Bounds on boundary facets during a whole call, taken from the facets of its input: no centroid is farther from the surface than
// the worst one, if the domain can measure distances, and no angle falls below the smallest one, or below 30 degrees if that is
// less. Later meshes do not change the bounds, since sliver removal may leave facets that are worse.
//
// If a mesh is its own domain, its surface is known only up to the distance between its facets and a sphere with the same bend.
class Facet_bounds_3
{
public:
  // A distance of 0 stands for that of the input.
  explicit Facet_bounds_3(const Domain_view_3& domain, double facet_distance = 0)
    : domain_(domain)
    , facet_distance_(facet_distance)
  {}

  // Measures the bounds of the first mesh; later calls do nothing.
  void measure(const Complex_snapshot_3& input)
  {
    if(std::exchange(are_measured_, true))
      return;
    const std::vector<Boundary_facet>& facets = input.boundary.complex().facets();
    // Facets where a mesh has been cut open are on no surface, and they stay.
    const auto is_of_cut = [&](const Boundary_facet& f)
    {
      const std::array<int, 3>& t = f.vertices;
      return f.patch == Boundary_facet::no_patch
             && std::none_of(t.begin(), t.end(), [&](int v) { return input.numbering->is_movable(v); });
    };
    for(const Boundary_facet& f : facets)
      if(!is_of_cut(f))
        smallest_angle_ = (std::min)(smallest_angle_, smallest_angle_of_facet(f.vertices, input.sites()));
    if(!domain_.tells_distances())
      return;
    std::vector<double> distances(facets.size());
    domain_.for_each(facets.size(), [&](int n) { distances[n] = distance(sorted(facets[n].vertices), input.sites()); });
    for(double d : distances)
      farthest_centroid_ = (std::max)(farthest_centroid_, d);
    if(facet_distance_ == 0 && domain_.has_cells_of_mesh())
      measure_bends(input);
    farthest_centroid_ = (std::max)(farthest_centroid_, facet_distance_);
  }

  // The next mesh counts as the first one again.
  void forget()
  {
    are_measured_ = false;
    farthest_centroid_ = largest_bend_ = 0;
    smallest_angle_ = 30;
  }

  // Relaxes the bounds if the number of vertices is to be divided by the factor. With the usual bound on angles, strong coarsening
  // gets stuck at worse cells.
  void permit_coarsening(double factor)
  {
    farthest_centroid_ *= factor;
    coarsening_ = factor;
    smallest_angle_ = (std::min)(smallest_angle_, (std::max)(20., 30 / factor));
  }

  // The smallest angle permitted in facets, in degrees.
  double smallest_angle() const { return smallest_angle_; }

  // Whether a boundary facet with these vertices may have this centroid.
  bool is_close(const Triple& facet, const Vertex_numbering_3& numbering, const Vector_3& centroid) const
  {
    return !domain_.tells_distances() || domain_.distance_to_surface(centroid) <= farthest(facet, numbering);
  }

  // Reverts vertices of facets that have become too thin.
  void check_angles(const Complex_candidate_3& candidate, Defect_report_3& report) const
  {
    for(std::size_t n = 0; n < candidate.old_facets.size(); ++n)
    {
      const std::array<int, 3>& t = candidate.boundary_complex->facets()[n].vertices;
      if(!has_good_angles(t, candidate.sites) && !(candidate.old_facets[n] >= 0 && candidate.are_reverted(t)))
        report.revert_around(t);
    }
  }

  // Reverts vertices of facets that have come too far from the surface.
  Defect_report_3 check_distances(Complex_candidate_3& candidate) const
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
    for(int n = 0; n < number; ++n)
    {
      if(candidate.centers[n].is_faithful)
        continue;
      candidate.centers[n].is_faithful = distances[n] <= farthest(vertices(n), candidate.numbering);
      if(!candidate.centers[n].is_faithful)
        report.revert(candidate.boundary_complex->facets()[n].vertices);
    }
    return report;
  }

private:
  // The largest distance that the centroid may have from the surface.
  double farthest(const Triple& facet, const Vertex_numbering_3& numbering) const
  {
    if(bends_.empty())
      return farthest_centroid_;
    double bend = -1;
    for(int v : facet)
      if(const std::size_t n = numbering.input_numbers[v]; n < bends_.size())
        bend = (std::max)(bend, bends_[n]);
    return (std::max)(farthest_centroid_, coarsening_ * (bend < 0 ? largest_bend_ : bend));
  }

  // Measures the bend at each vertex from the edges and the angles between the normals of adjacent facets: a sphere through the
  // vertices of two regular triangles is sqrt(3) / 6 of their product away from the centroids.
  void measure_bends(const Complex_snapshot_3& input)
  {
    const Boundary_complex_3& boundary = input.boundary.complex();
    const std::vector<Site>& sites = input.sites();
    const double rounding = rounding_of_coordinates(sites);
    bends_.assign(input.numbering->number_in_table, 0);
    for(int corner = 0; corner < 3 * static_cast<int>(boundary.facets().size()); ++corner)
    {
      const int beyond = boundary.facet_beyond(corner);
      if(beyond < corner / 3)
        continue;
      const Triple& t = boundary.facets()[corner / 3].vertices;
      const Facet_dual_3 facet(t, sites), other(boundary.facets()[beyond].vertices, sites);
      const double angle = std::acos((std::min)(1., std::abs(facet.normal.dot(other.normal))));
      const int u = t[(corner + 1) % 3], v = t[(corner + 2) % 3];
      // A feature edge may have one patch on both sides, yet it is sharp.
      const bool is_smooth = input.numbering->dimensions[u] == 2 || input.numbering->dimensions[v] == 2;
      const double bend = rounding + (is_smooth ? std::sqrt(3.) / 6 * angle * (position(sites[u]) - position(sites[v])).length() : 0);
      for(int w : { u, v })
        bends_[input.numbering->input_numbers[w]] = (std::max)(bends_[input.numbering->input_numbers[w]], bend);
      largest_bend_ = (std::max)(largest_bend_, bend);
    }
  }

  bool has_good_angles(const Triple& facet, const std::vector<Site>& sites) const
  {
    return smallest_angle_of_facet(facet, sites) >= smallest_angle_;
  }

  double distance(const Triple& facet, const std::vector<Site>& sites) const
  {
    return domain_.distance_to_surface(centroid(facet, sites));
  }

  const Domain_view_3& domain_;
  double facet_distance_;
  bool are_measured_ = false;
  double farthest_centroid_ = 0, smallest_angle_ = 30, coarsening_ = 1;
  std::vector<double> bends_;           // by vertices' numbers in the input; or empty
  double largest_bend_ = 0;
};

// The vertices at which the boundary of the candidate has another topology than the snapshot's, or a facet without a patch.
inline std::set<int> topology_changes(const Complex_candidate_3& candidate)
{
  std::set<int> result = topology_changes(candidate.snapshot.boundary.complex(), *candidate.boundary_complex);
  for(const Boundary_facet& f : candidate.boundary_complex->facets())
    if(f.patch == unknown_patch)
      result.insert(f.vertices.begin(), f.vertices.end());
  return result;
}

// Checks that a moving boundary has the topology of the snapshot's. Where it does not, the vertices of the facets that have been
// exchanged go back.
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
    report.revert(around[v]);
  }
  return report;
}

// For a boundary facet or cell whose vertices all stay: the vertices nearby that do not stay and lie in the ball around its surface
// center or dual center.
template <class Vertices>
std::vector<int> intruders(const Complex_candidate_3& candidate, const Vertices& around, const Vector_3& center)
{
  const Site& s = candidate.sites[around[0]];
  const double radius = squared_distance(s, center) - s.weight;
  Vertex_rings_3 region(candidate.triangulation, around);
  for(int ring = 0; ring < 2; ++ring)
    region.grow();
  std::vector<int> result;
  for(int v : region.vertices())
    if(!candidate.stays(v) && squared_distance(candidate.sites[v], center) < radius)
      result.push_back(v);
  return result;
}

// Reverts the vertices inside the ball or, if there are none, those of the facet or cell.
template <class Vertices>
void revert_intruders(const Complex_candidate_3& candidate, const std::vector<int>& inside, const Vertices& around,
                      const Vector_3& center, Defect_report_3& report)
{
  if(inside.empty())
    report.revert(around);
  else if(candidate.has_way_back)
    report.revert(inside);
  else
    report.revert_or_retreat(inside, center);
}

// The label on the other side of a cell's facet in the snapshot.
inline int label_beyond(const Complex_snapshot_3& snapshot, const Labelled_triangulation_3& triangulation, Half_facet f)
{
  const int n = snapshot.facet_number(triangulation.facet_vertices(f)), label = triangulation.label(f.cell());
  if(n < 0)
    return label;
  const std::array<int, 2>& labels = snapshot.boundary.complex().facets()[n].labels;
  return labels[0] == label ? labels[1] : labels[0];
}

// Makes room for a facet that stays, given its surface center: vertices in the way that may move go back. False if vertices that
// stay are in the way, too.
inline bool make_room(const Complex_candidate_3& candidate, const Triple& facet, const Vector_3& center, Defect_report_3& report)
{
  if(const std::vector<int> inside = intruders(candidate, facet, center); !inside.empty())
  {
    revert_intruders(candidate, inside, facet, center, report);
    return true;
  }
  const Facet_spheres_3 spheres(candidate, facet);
  if(!spheres.are_empty(candidate.sites))
    return candidate.has_way_back && report.revert_around(facet);
  const Vector_3 p = spheres.center(candidate.sites);
  revert_intruders(candidate, intruders(candidate, facet, p), facet, p, report);
  return true;
}

// Adds weight to vertices where others that stay are in the way of facets. All facets around count, since they must stay, too.
template <class Stays>
void make_heavier(const Complex_candidate_3& candidate, const std::vector<Triple>& facets, const Stays& stays, Defect_report_3& report)
{
  constexpr int rings = 3;
  std::set<int> vertices;
  for(const Triple& f : facets)
    vertices.insert(f.begin(), f.end());
  Vertex_rings_3 region(candidate.triangulation, vertices);
  for(int ring = 0; ring < rings; ++ring)
    region.grow();
  vertices.insert(region.vertices().begin(), region.vertices().end());
  std::vector<Triple> around;
  for(const Boundary_facet& f : candidate.snapshot.boundary.complex().facets())
    if(stays(f) && std::all_of(f.vertices.begin(), f.vertices.end(), [&](int v) { return vertices.count(v) > 0; }))
      around.push_back(f.vertices);
  const std::map<int, double> gains = Facet_weights_3(candidate, around).gains();
  report.add_weights(gains);
  if(gains.empty())
    for(const Triple& f : facets)
      report.revert(f);
}

// Checks the facets that must stay: all facets of a boundary at rest, and those the user wants to keep. If one is missing, each
// sphere through its vertices contains a vertex; one may also have other subdomains on its sides.
inline Defect_report_3 check_facets_stay(const Complex_candidate_3& candidate)
{
  Defect_report_3 report(candidate);
  const bool all_stay = !candidate.boundary_moves();
  if(!all_stay && candidate.numbering.kept_facets.entries().empty())
    return report;
  const std::vector<Boundary_facet>& facets = candidate.snapshot.boundary.complex().facets();
  const auto stays = [&](const Boundary_facet& f) { return all_stay || candidate.numbering.is_kept(f.vertices); };
  std::vector<char> is_found(facets.size(), false);
  for(std::size_t n = 0; n < candidate.old_facets.size(); ++n)
  {
    const int old = candidate.old_facets[n];
    const Boundary_facet& f = candidate.boundary_complex->facets()[n];
    if(old >= 0)
      is_found[old] = true;
    if(stays(f) && (old < 0 || !Boundary_complex_3::same_labels(f.labels, facets[old].labels)))
      report.revert(f.vertices);
  }
  std::vector<Triple> in_need;
  for(std::size_t n = 0; n < is_found.size(); ++n)
    if(!is_found[n] && stays(facets[n]) && !make_room(candidate, facets[n].vertices, candidate.snapshot.centers[n].point, report))
      in_need.push_back(facets[n].vertices);
  if(!in_need.empty())
    make_heavier(candidate, in_need, stays, report);
  return report;
}

// Checks that the kept cells are present, with the same labels beyond their facets. If one is missing, its sphere contains a
// vertex.
inline Defect_report_3 check_kept_cells(const Complex_candidate_3& candidate)
{
  Defect_report_3 report(candidate);
  const auto& kept = candidate.numbering.kept_cells;
  if(kept.entries().empty())
    return report;
  std::vector<char> is_found(kept.entries().size(), false);
  const Labelled_triangulation_3& triangulation = candidate.triangulation;
  for(int c : triangulation.cells())
  {
    const int* const n = kept.find(sorted(triangulation.vertices(c)));
    if(n == nullptr)
      continue;
    is_found[*n] = true;
    for(int i = 0; i < 4; ++i)
      if(const int d = triangulation.neighbor(c, i);
         triangulation.label(d) != label_beyond(candidate.snapshot, triangulation, Half_facet(c, i)))
        report.revert(triangulation.vertices(d));
  }
  for(std::size_t n = 0; n < is_found.size(); ++n)
    if(const Quadruple& q = kept.entries()[n].first; !is_found[n])
    {
      const std::vector<Site>& s = candidate.sites;
      const Cell_products t(s[q[0]], s[q[1]], s[q[2]], s[q[3]]);
      const Vector_3 center = position(s[q[0]]) + t.to_dual();
      revert_intruders(candidate, intruders(candidate, q, center), q, center, report);
    }
  return report;
}

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CANDIDATE_CHECKS_3_H
