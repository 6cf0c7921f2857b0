// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_SURFACE_PROJECTION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_SURFACE_PROJECTION_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_dual_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Domain_oracle_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_draft_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_update.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>

#include <array>
#include <cmath>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Keeps the vertices that move on the surface close to it: they are projected, or follow
// tangential planes until these may have led too far from it.
template <class Triangulation, class Mesh_domain>
class Surface_projection_3
{
public:
  typedef Restricted_draft_3<Triangulation, Mesh_domain> Draft;
  typedef typename Draft::Complex Complex;
  typedef Domain_oracle_3<Mesh_domain> Oracle;

  Surface_projection_3(const Complex& complex, Draft& draft, Oracle& oracle)
    : complex_(complex)
    , draft_(draft)
    , oracle_(oracle)
  {}

  // For a new draft.
  void start()
  {
    const int n = complex_.number_of_movable_vertices;
    if(on_surface_.empty())
    {
      on_surface_.resize(n, true);
      last_on_surface_.assign(complex_.sites.begin(), complex_.sites.begin() + n);
    }
    next_on_surface_ = on_surface_;
    drift_.resize(n, 0);
    next_drift_ = drift_;
    for(int v = complex_.number_of_interior_vertices; v < n; ++v)
      next_on_surface_[v] = on_surface_[v] && draft_.is_home(v);
  }

  // Moves a site for a surface vertex of the complex to the surface; false if that cannot be done.
  bool put_on_surface(int v, Site& s)
  {
    return put_on_surface(complex_.boundary.umbrella(v, 0), s);
  }

  // Projects the surface vertices that are not on the surface, or those only that may have
  // got too far from it. One for which that fails stays, or goes back to where it was last on it.
  void project_all()
  {
    for(int v = complex_.number_of_interior_vertices; v < complex_.number_of_movable_vertices; ++v)
    {
      const bool stays = draft_.is_home(v);
      if(stays && on_surface_[v])
        continue;
      next_drift_[v] = drift_[v] + drift(v);
      if(!draft_.mode.projects && next_drift_[v] < farthest_drift)
        continue;
      next_drift_[v] = 0;
      next_on_surface_[v] = project(v);
      if(!next_on_surface_[v])
      {
        // Where it was last on the surface is better than off it.
        draft_.sites[v] = on_surface_[v] || !is_careful() ? complex_.sites[v] : last_on_surface_[v];
        next_on_surface_[v] = on_surface_[v] || is_careful();
      }
      if(stays && next_on_surface_[v] && is_careful())
        settle_home(v);
    }
  }

  // Puts a vertex that was sent back onto the surface, at home if there is no other way.
  bool return_to_surface(int v, bool halfway)
  {
    if(halfway && draft_.mode.projects && project(v))
    {
      next_on_surface_[v] = true;
      return true;
    }
    if(halfway && !draft_.mode.projects)
    {
      next_on_surface_[v] = false;
      next_drift_[v] = drift_[v] + drift(v);
      return true;
    }
    draft_.sites[v] = complex_.sites[v];
    next_drift_[v] = drift_[v];
    if(draft_.mode.projects && is_careful() && !on_surface_[v])
    {
      if(!project(v))
        return false;
      settle_home(v);
    }
    next_on_surface_[v] = on_surface_[v];
    return true;
  }

  // To be called when the complex has accepted the draft.
  void accept()
  {
    on_surface_.swap(next_on_surface_);
    drift_.swap(next_drift_);
    for(int v = complex_.number_of_interior_vertices; v < complex_.number_of_movable_vertices; ++v)
      if(on_surface_[v])
        last_on_surface_[v] = complex_.sites[v];
  }

  // Whether the surface is rough compared with the mesh, as that of an image is: at many
  // of some vertices, going a bit along the tangential plane leads off the surface.
  bool is_rough()
  {
    const int first = complex_.number_of_interior_vertices, last = complex_.number_of_movable_vertices;
    const int stride = 1 + (last - first) / 200;
    int probed = 0, off = 0;
    for(int v = first; v < last; v += stride, ++probed)
      off += is_off_after_step(v);
    return off > 0.1 * probed;
  }

private:
  typedef std::array<double, 3> Vector;

  static constexpr double farthest_projection = 1;            // over the shortest edge
  static constexpr double farthest_drift = 0.02;              // over an edge

  bool is_careful() const { return draft_.mode.evidence != Restricted_update::SOME_EVIDENCE; }

  bool project(int v)
  {
    return put_on_surface(draft_.measured_boundary.umbrella(v, 0), draft_.sites[v]);
  }

  bool put_on_surface(const Boundary_umbrella& umbrella, Site& s)
  {
    Vector p = {{ s.x, s.y, s.z }};
    if(!oracle_.project(p, umbrella.normal, farthest_projection * umbrella.shortest_edge, complex_.patches.value(umbrella.patch)))
      return false;
    s = { p[0], p[1], p[2], s.weight };
    return true;
  }

  // How far a way along the tangential plane leads off the surface, over the shortest edge,
  // for the curvature that the facets around show.
  double drift(int v) const
  {
    const Boundary_umbrella& umbrella = complex_.boundary.umbrella(v, 0);
    const Site& s = complex_.sites[v];
    const double way = squared_distance(draft_.sites[v], {{ s.x, s.y, s.z }});
    return umbrella.bend * way / (umbrella.shortest_edge * umbrella.shortest_edge);
  }

  // What was a tangential plane away from the surface is home on it from now on.
  void settle_home(int v)
  {
    draft_.settle_home(v);
    on_surface_[v] = true;
  }

  bool is_off_after_step(int v)
  {
    const Boundary_umbrella& umbrella = complex_.boundary.umbrella(v, 0);
    const Site& s = complex_.sites[v];
    const double step = 0.2 * umbrella.shortest_edge, tolerance = 0.05 * umbrella.shortest_edge;
    const double along = umbrella.toward[0] * umbrella.normal[0] + umbrella.toward[1] * umbrella.normal[1] + umbrella.toward[2] * umbrella.normal[2];
    Vector t;
    for(int i = 0; i < 3; ++i)
      t[i] = umbrella.toward[i] - along * umbrella.normal[i];
    const double length = std::sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]);
    const double f = length > 0 ? step / length : 0;
    const Vector from = {{ s.x + f * t[0], s.y + f * t[1], s.z + f * t[2] }};
    Vector p = from;
    const bool found = oracle_.project(p, umbrella.normal, 4 * tolerance, complex_.patches.value(umbrella.patch));
    const double dx = p[0] - from[0], dy = p[1] - from[1], dz = p[2] - from[2];
    return !found || dx * dx + dy * dy + dz * dz > tolerance * tolerance;
  }

  const Complex& complex_;
  Draft& draft_;
  Oracle& oracle_;
  // Of the movable vertices, in the complex and in the draft.
  std::vector<char> on_surface_, next_on_surface_;
  std::vector<double> drift_, next_drift_;            // over an edge, since a vertex was on the surface
  std::vector<Site> last_on_surface_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_SURFACE_PROJECTION_3_H
