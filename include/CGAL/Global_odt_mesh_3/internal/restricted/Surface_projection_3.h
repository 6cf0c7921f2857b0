// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_SURFACE_PROJECTION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_SURFACE_PROJECTION_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_dual_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Places_on_surface.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>

#include <Eigen/Core>

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

// Keeps the vertices of a candidate that move on surfaces close to these: they are projected, unless that is where they
// have been put, or follow tangential planes until these may have led too far off.
class Surface_projection_3
{
public:
  Surface_projection_3(Restricted_candidate_3& candidate, const Domain_view_3& domain, const Places_on_surface& places)
    : candidate_(candidate)
    , domain_(domain)
    , places_(places)
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
      if(!candidate_.is_home(v) || !candidate_.state.surface_position(v).is_on_surface)
        project(v);
    });
  }

  // Puts a vertex that was sent back onto its surface, at home if there is no other way; false if
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
      position.drift = candidate_.state.surface_position(v).drift + drift(v);
      return true;
    }
    candidate_.sites[v] = candidate_.homes[v];
    position.drift = candidate_.state.surface_position(v).drift;
    if(candidate_.is_thorough() && !is_home_on_surface(v))
    {
      if(!put(v))
        return false;
      candidate_.settle(v);
    }
    position.is_on_surface = is_home_on_surface(v);
    return true;
  }

private:
  static constexpr double farthest_drift = 0.02;              // over an edge

  bool is_home_on_surface(int v) const
  {
    return candidate_.is_home_on_surface[v - candidate_.numbering.number_of_interior_vertices];
  }

  bool put(int v) { return put_on_surface(domain_, candidate_.measured_boundary, v, candidate_.sites[v]); }

  void project(int v)
  {
    const auto& before = candidate_.state.surface_position(v);
    auto& position = candidate_.surface_position(v);
    const bool stays = candidate_.is_home(v);
    if(places_.has(v, candidate_.sites[v]))
    {
      position = { true, 0, candidate_.sites[v] };
      return;
    }
    position.drift = before.drift + drift(v);
    if(!projects_all_ && position.drift < farthest_drift)
      return;
    position.drift = 0;
    position.is_on_surface = put(v);
    if(!position.is_on_surface)
    {
      // Where it was last on the surface is better than off it.
      const bool goes_home = before.is_on_surface || !candidate_.is_thorough();
      candidate_.sites[v] = goes_home ? candidate_.homes[v] : before.last_on_surface;
      position.is_on_surface = before.is_on_surface || candidate_.is_thorough();
    }
    if(stays && position.is_on_surface && candidate_.is_thorough())
      candidate_.settle(v);
  }

  // How far a way along the tangential plane leads off the surface, over the shortest edge,
  // for the curvature that the facets around show.
  double drift(int v) const
  {
    const Umbrella_shape& shape = candidate_.state.boundary.shape(v, 0);
    const double way = squared_distance(candidate_.sites[v], position(candidate_.homes[v]));
    return shape.bend * way / (shape.shortest_edge * shape.shortest_edge);
  }

  Restricted_candidate_3& candidate_;
  const Domain_view_3& domain_;
  const Places_on_surface& places_;
  bool projects_all_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_SURFACE_PROJECTION_3_H
