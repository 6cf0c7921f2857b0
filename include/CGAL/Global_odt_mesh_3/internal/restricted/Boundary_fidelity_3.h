// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_BOUNDARY_FIDELITY_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_BOUNDARY_FIDELITY_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_dual_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Domain_oracle_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Guilty_vertices_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_draft_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <unordered_map>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// No centroid of a boundary facet may be farther from the surface than the worst of
// the input, where the domain tells distances.
template <class Triangulation, class Mesh_domain>
class Boundary_fidelity_3
{
public:
  typedef Restricted_draft_3<Triangulation, Mesh_domain> Draft;
  typedef typename Draft::Complex Complex;
  typedef Domain_oracle_3<Mesh_domain> Oracle;
  typedef Guilty_vertices_3<Triangulation, Mesh_domain> Guilty_vertices;
  typedef typename Draft::Triple Triple;

  Boundary_fidelity_3(const Complex& complex, Draft& draft, Oracle& oracle, Guilty_vertices& guilty)
    : complex_(complex)
    , draft_(draft)
    , oracle_(oracle)
    , guilty_(guilty)
  {}

  // To be called while the complex is the input.
  void measure_input()
  {
    if(!Has_aabb_tree<Mesh_domain>::value)
      return;
    for(const Boundary_facet& f : complex_.boundary.facets())
      farthest_centroid_ = (std::max)(farthest_centroid_,
                                      oracle_.distance_to_surface(centroid(sorted(f.vertices), complex_.sites)));
  }

  // For a new draft.
  void start() { found_.clear(); }

  // What was found holds until vertices of the facet move.
  void forget_facets_of(const Guilty_vertices& guilty) { guilty.erase_from(found_); }

  void check_fidelity()
  {
    if(!Has_aabb_tree<Mesh_domain>::value)
      return;
    for(std::size_t n = 0; n < draft_.facets.size(); ++n)
    {
      if(draft_.centers[n].is_faithful)
        continue;
      const Triple& t = draft_.boundary.facets()[n].vertices;
      draft_.centers[n].is_faithful = is_faithful(t);
      if(!draft_.centers[n].is_faithful)
        guilty_.blame(t);
    }
  }

  // Whether a boundary facet may have its centroid there.
  bool is_close(const std::array<double, 3>& point)
  {
    return !Has_aabb_tree<Mesh_domain>::value || oracle_.distance_to_surface(point) <= farthest_centroid_;
  }

  // Whether these vertices may be those of a boundary facet.
  bool is_faithful(const Triple& facet)
  {
    if(!Has_aabb_tree<Mesh_domain>::value)
      return true;
    const Triple t = sorted(facet);
    const auto known = found_.find(t);
    const double distance = known != found_.end() ? known->second
                            : oracle_.distance_to_surface(centroid(t, draft_.sites));
    found_.emplace(t, distance);
    return distance <= farthest_centroid_;
  }

private:

  const Complex& complex_;
  Draft& draft_;
  Oracle& oracle_;
  Guilty_vertices& guilty_;
  double farthest_centroid_ = 0;
  std::unordered_map<Triple, double, Hash_vertex_tuple> found_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_BOUNDARY_FIDELITY_3_H
