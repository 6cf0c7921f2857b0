// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_BOUNDARY_EXTRACTION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_BOUNDARY_EXTRACTION_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_dual_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Cell_knowledge.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Domain_oracle_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_draft_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flat_triangulation_3.h>

#include <array>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Finds the boundary facets of a labelled draft, and their patches.
template <class Triangulation, class Mesh_domain>
class Boundary_extraction_3
{
public:
  typedef Restricted_draft_3<Triangulation, Mesh_domain> Draft;
  typedef typename Draft::Complex Complex;
  typedef Domain_oracle_3<Mesh_domain> Oracle;

  Boundary_extraction_3(Complex& complex, Draft& draft, Oracle& oracle)
    : complex_(complex)
    , draft_(draft)
    , oracle_(oracle)
  {}

  // Collects the facets that separate subdomains, or may do so once cells with all vertices
  // on the boundary are labelled otherwise, and those that were in the complex without separating any.
  void find_candidates()
  {
    const Triangulation& tr = draft_.triangulation();
    candidates_.clear();
    for(auto f = tr.all_facets_begin(); f != tr.all_facets_end(); ++f)
    {
      const Cell_handle c = f->first, d = c->neighbor(f->second);
      if((complex_.has_unseparating_facets() || c->subdomain_index() != d->subdomain_index()
          || knows(c, IS_BOUNDARY_CELL) || knows(d, IS_BOUNDARY_CELL)) && !tr.is_infinite(*f))
        candidates_.push_back(*f);
    }
  }

  // Collects the boundary facets among the candidates.
  void find_boundary()
  {
    const std::vector<Boundary_facet>& old_facets = complex_.boundary.facets();
    std::vector<Boundary_facet> found;
    draft_.facets.clear();
    draft_.old_facets.clear();
    for(const Facet& f : candidates_)
    {
      const Cell_handle c = f.first, d = c->neighbor(f.second);
      const bool separates = c->subdomain_index() != d->subdomain_index();
      if(!separates && !complex_.has_unseparating_facets())
        continue;
      const std::array<int, 3>& k = Flat_triangulation_3::facet_vertices(f.second);
      Boundary_facet b;
      for(int i = 0; i < 3; ++i)
        b.vertices[i] = draft_.numbered.number(c->vertex(k[i]));
      const int old = complex_.facet_number(b.vertices);
      if(!separates && (old < 0 || old_facets[old].labels[0] != old_facets[old].labels[1]))
        continue;
      b.labels = {{ complex_.labels.number(c->subdomain_index()), complex_.labels.number(d->subdomain_index()) }};
      b.patch = old >= 0 ? old_facets[old].patch : patch_of_new_facet(b);
      found.push_back(b);
      draft_.facets.push_back(f);
      draft_.old_facets.push_back(old);
    }
    draft_.boundary = Boundary_complex_3(std::move(found), draft_.sites.size());
  }

private:
  typedef typename Draft::Cell_handle Cell_handle;
  typedef typename Draft::Facet Facet;

  // The patch on which all vertices agree.
  int patch_of_new_facet(const Boundary_facet& f)
  {
    const Boundary_complex_3& boundary = complex_.boundary;
    std::set<int> common;
    for(int k = 0; k < 3; ++k)
    {
      std::set<int> here;
      for(int n = 0; n < boundary.number_of_umbrellas(f.vertices[k]); ++n)
      {
        const Boundary_umbrella& umbrella = boundary.umbrella(f.vertices[k], n);
        if(Boundary_complex_3::same_labels(umbrella.labels, f.labels) && umbrella.patch != Boundary_facet::no_patch
           && (k == 0 || common.count(umbrella.patch) > 0))
          here.insert(umbrella.patch);
      }
      common.swap(here);
    }
    if(common.size() <= 1)
      return common.empty() ? int(Draft::unknown_patch) : *common.begin();
    const Facet_dual_3 dual(f.vertices, draft_.sites);
    std::array<double, 3> p = dual.center;
    typename Complex::Index index;
    if(!oracle_.intersect(p, dual.normal, dual.radius, index))
      return Draft::unknown_patch;
    const int patch = complex_.patches.number(oracle_.surface_patch(index));
    return common.count(patch) > 0 ? patch : int(Draft::unknown_patch);
  }

  Complex& complex_;
  Draft& draft_;
  Oracle& oracle_;
  std::vector<Facet> candidates_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_BOUNDARY_EXTRACTION_3_H
