// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SURFACE_PROJECTION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SURFACE_PROJECTION_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Moves a site for a vertex on a surface to that surface; false if there is no such point nearby.
inline bool put_on_surface(const Domain_view_3& domain, const Boundary_geometry_3& boundary, int v, Site& s)
{
  constexpr double farthest_projection = 1;       // over the shortest edge
  const Umbrella_shape& shape = boundary.shape(v, 0);
  Eigen::Vector3d p = position(s);
  if(!domain.project(p, shape.normal, farthest_projection * shape.shortest_edge, boundary.complex().umbrella(v, 0).patch))
    return false;
  s = site_at(p, s.weight);
  return true;
}

// Keeps the vertices of a candidate that move on surfaces close to these: they are projected, or follow tangential planes until
// these may have led too far off.
class Surface_projection_3
{
public:
  Surface_projection_3(Complex_candidate_3& candidate, const Domain_view_3& domain)
    : candidate_(candidate)
    , domain_(domain)
    , projects_all_(candidate.is_thorough() || domain.tells_distances())
  {}

  // Projects the vertices that are not on their surface, or those only that may have
  // got too far from it. One for which that fails stays, or goes back to where it was last on it.
  void project_all()
  {
    const auto& numbering = candidate_.numbering;
    domain_.for_each(numbering.number_of_surface_vertices(), [&](int n)
    {
      const int v = numbering.number_of_interior_vertices + n;
      if(!candidate_.is_reverted(v) || !candidate_.snapshot.surface_position(v).is_on_surface)
        project(v);
    });
  }

  // Puts a vertex that was sent back onto its surface, at its revert site if there is no other way; false if
  // even that fails.
  bool return_to_surface(int v, bool is_halfway)
  {
    auto& position = candidate_.surface_position(v);
    if(is_halfway && projects_all_ && put(v))
    {
      position.is_on_surface = true;
      return true;
    }
    if(is_halfway && !projects_all_)
    {
      position.is_on_surface = false;
      position.drift = candidate_.snapshot.surface_position(v).drift + drift(v);
      return true;
    }
    candidate_.sites[v] = candidate_.revert_sites[v];
    position.drift = candidate_.snapshot.surface_position(v).drift;
    if(candidate_.is_thorough() && !is_revert_site_on_surface(v))
    {
      if(!put(v))
        return false;
      candidate_.settle(v);
    }
    position.is_on_surface = is_revert_site_on_surface(v);
    return true;
  }

private:
  static constexpr double farthest_drift = 0.02;              // over an edge

  bool is_revert_site_on_surface(int v) const
  {
    return candidate_.is_revert_site_on_surface[v - candidate_.numbering.number_of_interior_vertices];
  }

  bool put(int v) { return put_on_surface(domain_, candidate_.measured_boundary, v, candidate_.sites[v]); }

  void project(int v)
  {
    const auto& before = candidate_.snapshot.surface_position(v);
    auto& position = candidate_.surface_position(v);
    const bool stays = candidate_.is_reverted(v);
    position.drift = before.drift + drift(v);
    if(!projects_all_ && position.drift < farthest_drift)
      return;
    position.drift = 0;
    position.is_on_surface = put(v);
    if(!position.is_on_surface)
    {
      // Where it was last on the surface is better than off it.
      const bool goes_home = before.is_on_surface || !candidate_.is_thorough();
      candidate_.sites[v] = goes_home ? candidate_.revert_sites[v] : before.last_on_surface;
      position.is_on_surface = before.is_on_surface || candidate_.is_thorough();
    }
    if(stays && position.is_on_surface && candidate_.is_thorough())
      candidate_.settle(v);
  }

  // How far a way along the tangential plane leads off the surface, over the shortest edge,
  // for the curvature that the facets around show.
  double drift(int v) const
  {
    const Umbrella_shape& shape = candidate_.snapshot.boundary.shape(v, 0);
    const double way = squared_distance(candidate_.sites[v], position(candidate_.revert_sites[v]));
    return shape.bend * way / (shape.shortest_edge * shape.shortest_edge);
  }

  Complex_candidate_3& candidate_;
  const Domain_view_3& domain_;
  bool projects_all_;
};

// Whether a bit along the tangential plane of a vertex the surface is far off.
inline bool is_off_surface_after_step(const Complex_snapshot_3& snapshot, const Domain_view_3& domain, int v)
{
  constexpr double step_length = 0.2, most_tolerated = 0.05;      // over the shortest edge
  const Umbrella_shape& shape = snapshot.boundary.shape(v, 0);
  const double step = step_length * shape.shortest_edge, tolerance = most_tolerated * shape.shortest_edge;
  const Eigen::Vector3d tangent = shape.toward - shape.normal.dot(shape.toward) * shape.normal;
  const Eigen::Vector3d from = position(snapshot.sites[v]) + step * tangent.normalized();
  Eigen::Vector3d p = from;
  const int patch = snapshot.boundary.complex().umbrella(v, 0).patch;
  const bool found = domain.project(p, shape.normal, 4 * tolerance, patch);
  return !found || (p - from).norm() > tolerance;
}

// Whether the surface is rough compared with the mesh, as that of an image is: so it is at many
// of some vertices.
inline bool is_surface_rough(const Complex_snapshot_3& snapshot, const Domain_view_3& domain)
{
  constexpr int probes = 200;
  constexpr double most_off = 0.1;
  const int first = snapshot.numbering->number_of_interior_vertices, last = snapshot.numbering->number_of_movable_vertices;
  const int stride = 1 + (last - first) / probes;
  int probed = 0, off = 0;
  for(int v = first; v < last; v += stride, ++probed)
    off += is_off_surface_after_step(snapshot, domain, v);
  return off > most_off * probed;
}

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_SURFACE_PROJECTION_3_H
