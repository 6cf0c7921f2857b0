// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_BOUNDARY_PRESERVATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_BOUNDARY_PRESERVATION_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_dual_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Guilty_vertices_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_draft_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Whether the boundary of a draft has the topology of that of the complex, or the
// same facets, and who is to blame where it does not.
template <class Triangulation, class Mesh_domain>
class Boundary_preservation_3
{
public:
  typedef Restricted_draft_3<Triangulation, Mesh_domain> Draft;
  typedef typename Draft::Complex Complex;
  typedef Guilty_vertices_3<Triangulation, Mesh_domain> Guilty_vertices;

  Boundary_preservation_3(const Complex& complex, const Draft& draft, Guilty_vertices& guilty)
    : complex_(complex)
    , draft_(draft)
    , guilty_(guilty)
  {}

  // The vertices at which the boundary of the draft is not what it has to be.
  std::set<int> changes() const
  {
    std::set<int> result = complex_.boundary.difference(draft_.boundary);
    for(const Boundary_facet& f : draft_.boundary.facets())
      if(f.patch == Draft::unknown_patch)
        result.insert(f.vertices.begin(), f.vertices.end());
    return result;
  }

  // Where the topology has changed, the vertices of the facets that have come or gone
  // are to blame.
  void check_topology()
  {
    const std::set<int> changed = changes();
    if(changed.empty())
      return;
    std::map<int, std::vector<int> > around;
    for(const Triple& t : complex_.boundary.other_facets(draft_.boundary))
      for(int v : t)
        if(changed.count(v) > 0)
          around[v].insert(around[v].end(), t.begin(), t.end());
    for(int v : changed)
    {
      around[v].push_back(v);
      guilty_.blame(around[v]);
    }
  }

  // Boundary facets that are missing have a vertex in their surface Delaunay ball; others
  // have other subdomains on their sides.
  void check_facets_stay()
  {
    const std::vector<Boundary_facet>& facets = complex_.boundary.facets();
    std::vector<char> is_found(facets.size(), false);
    for(std::size_t n = 0; n < draft_.old_facets.size(); ++n)
    {
      const int old = draft_.old_facets[n];
      const Boundary_facet& f = draft_.boundary.facets()[n];
      if(old >= 0)
        is_found[old] = true;
      if(old < 0 || !Boundary_complex_3::same_labels(f.labels, facets[old].labels))
        guilty_.blame(f.vertices);
    }
    for(std::size_t n = 0; n < is_found.size(); ++n)
      if(!is_found[n])
        blame_intruders(facets[n].vertices, complex_.centers[n].point);
  }

private:
  typedef typename Complex::Triple Triple;

  void blame_intruders(const Triple& t, const std::array<double, 3>& center)
  {
    const Site& s = complex_.sites[t[0]];
    const double radius = squared_distance(s, center) - s.weight;
    std::set<int> region(t.begin(), t.end());
    for(int ring = 0; ring < 2; ++ring)
      draft_.numbered.grow(region);
    std::vector<int> intruders;
    for(int v : region)
      if(draft_.is_movable(v) && squared_distance(draft_.sites[v], center) < radius)
        intruders.push_back(v);
    if(intruders.empty())
      intruders.assign(t.begin(), t.end());
    guilty_.blame(intruders);
  }

  const Complex& complex_;
  const Draft& draft_;
  Guilty_vertices& guilty_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_BOUNDARY_PRESERVATION_3_H
