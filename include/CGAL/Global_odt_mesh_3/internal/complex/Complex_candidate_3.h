// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_COMPLEX_CANDIDATE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_COMPLEX_CANDIDATE_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Cell_transfer_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Labelled_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <CGAL/assertions.h>

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <map>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The next snapshot of a complex while it is being built. It owns all that changes on the way; the snapshot that it starts from
// stays as it is.
struct Complex_candidate_3
{
  typedef Complex_snapshot_3::Surface_center Surface_center;

  const Complex_snapshot_3& snapshot;
  const Vertex_numbering_3& numbering;
  const bool is_final;                        // or else intermediate, with weaker checks
  const bool has_way_back;                    // whether the snapshot is valid
  bool may_retreat = true;                    // whether vertices may go elsewhere instead of back
  const Thread_policy threads;

  Labelled_triangulation_3 triangulation;     // of the candidate's vertices once it has been built
  std::vector<Site> sites;
  // Where vertices go back to: their sites in the snapshot or in the input.
  std::vector<Site> revert_sites;
  Boundary_geometry_3 measured_boundary;      // that of the snapshot, at the positions of the candidate

  std::vector<int> cells_at_boundary;         // finite, with three vertices or more on the boundary
  std::shared_ptr<const Boundary_complex_3> boundary_complex;
  Boundary_geometry_3 boundary;
  std::vector<Half_facet> facets;
  std::vector<int> old_facets;                // the numbers that facets have in the snapshot, or -1
  std::vector<Surface_center> centers;
  std::map<Triple, Surface_center> found_centers;   // of the facets that trials have changed, by sorted vertices

  // The distances of facets' centroids from the surface, until their vertices move.
  std::unordered_map<Triple, double, boost::hash<Triple> > known_distances;
  std::map<int, int> times_reverted;     // by vertex: how often

  Complex_candidate_3(const Complex_snapshot_3& from, const std::vector<Site>& target, bool is_last, bool is_snapshot_valid,
                      const Thread_policy& policy)
    : snapshot(from)
    , numbering(*from.numbering)
    , is_final(is_last)
    , has_way_back(is_snapshot_valid)
    , threads(policy)
    , sites(target)
    , revert_sites(from.sites())
  {
    measure();
  }

  Complex_candidate_3(const Complex_candidate_3&) = delete;
  Complex_candidate_3& operator=(const Complex_candidate_3&) = delete;

  bool boundary_moves() const { return numbering.number_of_surface_vertices() > 0; }

  // To be called when vertices have moved.
  void measure()
  {
    measured_boundary = boundary_moves() ? snapshot.boundary.at(sites) : snapshot.boundary;
  }

  // Builds the triangulation, from the cells of a mesh at nearly these positions if one is given and that succeeds; whether it did.
  bool build(const Moving_triangulation_3* mesh)
  {
    if(mesh != nullptr && Cell_transfer_3(*mesh, sites, threads).run(triangulation))
      return true;
    triangulation.build(sites);
    return false;
  }

  // Whether the vertex must stay: a vertex on a surface cannot retreat.
  bool stays(int v) const { return !numbering.is_movable(v) || (!has_way_back && !numbering.is_interior(v)); }
  bool is_at_input(int v) const { return numbering.is_input_site(v, sites[v]); }
  bool is_reverted(int v) const { return same_place(sites[v], revert_sites[v]); }

  template <class Vertices>
  bool are_reverted(const Vertices& vertices) const
  {
    return std::all_of(vertices.begin(), vertices.end(), [this](int v) { return is_reverted(v); });
  }

  // Whether a facet or cell with these vertices is where it was in the snapshot.
  template <class Vertices>
  bool is_unchanged(const Vertices& vertices) const
  {
    return std::all_of(vertices.begin(), vertices.end(), [this](int v) { return same_place(sites[v], snapshot.sites()[v]); });
  }

  // From now on, the vertex reverts to where it was in the input.
  void revert_to_input(int v) { revert_sites[v] = numbering.input_sites[v]; }

  // Turns the candidate into a snapshot.
  Complex_snapshot_3 finish()
  {
    CGAL_assertion(centers.size() == facets.size() && boundary.complex().facets().size() == facets.size());
    Complex_snapshot_3 next;
    next.numbering = snapshot.numbering;
    next.has_labels_of_domain = is_final;
    for(int c : triangulation.cells())
      triangulation.clear_flags(c);
    next.triangulation = std::move(triangulation);
    next.boundary = std::move(boundary);
    next.centers = std::move(centers);
    next.number_facets();
    next.mark_facets(facets);
    return next;
  }
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_COMPLEX_CANDIDATE_3_H
