// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_BOUNDARY_EXTRACTION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_BOUNDARY_EXTRACTION_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

constexpr int unknown_patch = -2;       // of a facet whose vertices do not agree on a patch

// The patch of a new facet: the only one its vertices share or, if they share several, the one of these on which its dual line
// meets the surface. `patches(v)` is the set of patches at a vertex between the subdomains of the facet.
template <class Patches>
int patch_of_facet(const Triple& t, const std::array<Site, 3>& sites, const Patches& patches, const Domain_view_3& domain)
{
  std::set<int> common = patches(t[0]);
  for(int v : { t[1], t[2] })
  {
    const std::set<int> before = std::move(common), here = patches(v);
    common.clear();
    std::set_intersection(before.begin(), before.end(), here.begin(), here.end(), std::inserter(common, common.end()));
  }
  if(common.size() <= 1)
    return common.empty() ? unknown_patch : *common.begin();
  const Facet_dual_3 dual(sites);
  Vector_3 p = dual.center;
  int patch;
  return domain.intersect(p, dual.normal, dual.radius, patch) && common.count(patch) > 0 ? patch : unknown_patch;
}

// Finds the boundary facets of a labelled candidate and their patches: facets that separate subdomains, and those of the snapshot
// that separate none. All their vertices are on the boundary, since the cells around an interior vertex have its label, except for
// cells whose vertices are in several subdomains.
class Boundary_extraction_3
{
public:
  Boundary_extraction_3(Complex_candidate_3& candidate, const Domain_view_3& domain)
    : candidate_(candidate)
    , domain_(domain)
  {}

  // Lists the boundary facets for the present cell labels, in the order of their sorted vertices.
  void find_boundary()
  {
    std::vector<Found_facet> found = find_facets();
    candidate_.threads.sort(found.begin(), found.end(), [](const Found_facet& f, const Found_facet& g) { return f.key < g.key; });
    const std::vector<Boundary_facet>& old_facets = candidate_.snapshot.boundary.complex().facets();
    std::vector<Boundary_facet> facets;
    facets.reserve(found.size());
    candidate_.facets.clear();
    candidate_.old_facets.clear();
    for(const Found_facet& f : found)
    {
      const Labelled_triangulation_3& tr = candidate_.triangulation;
      const std::array<int, 2> labels = {{ tr.label(f.facet.cell()), tr.label(tr.mirror(f.facet).cell()) }};
      facets.push_back({ tr.facet_vertices(f.facet), labels, f.old >= 0 ? old_facets[f.old].patch : unknown_patch });
      if(f.old < 0)
        facets.back().patch = patch_of_new_facet(facets.back());
      candidate_.facets.push_back(f.facet);
      candidate_.old_facets.push_back(f.old);
    }
    candidate_.boundary_complex = std::make_shared<const Boundary_complex_3>(std::move(facets), candidate_.sites.size(),
                                                                             candidate_.threads);
  }

private:
  struct Found_facet
  {
    Triple key;                 // its vertices, sorted
    int old;                    // its number in the snapshot, or -1
    Half_facet facet;
  };

  std::vector<Found_facet> find_facets() const
  {
    const Complex_snapshot_3& snapshot = candidate_.snapshot;
    const std::vector<Boundary_facet>& old_facets = snapshot.boundary.complex().facets();
    const std::vector<int>& cells = candidate_.cells_at_boundary;
    const Labelled_triangulation_3& tr = candidate_.triangulation;
    return collect_in_chunks<Found_facet>(static_cast<int>(cells.size()), candidate_.threads,
                                          [&](int n, std::vector<Found_facet>& found)
    {
      // A facet between a subdomain and the outside is found from the side of the subdomain.
      const int label = tr.label(cells[n]);
      if(label == Domain_view_3::outside && !snapshot.has_unseparating_facets)
        return;
      for(int i = 0; i < 4; ++i)
      {
        const int label_beyond = tr.label(tr.neighbor(cells[n], i));
        const bool is_separating = label != label_beyond;
        if(!is_separating && !snapshot.has_unseparating_facets)
          continue;
        Half_facet f(cells[n], i);
        if(!tr.is_first_side(f))
        {
          if(label_beyond != Domain_view_3::outside || snapshot.has_unseparating_facets)
            continue;
          f = tr.mirror(f);
        }
        const Triple t = sorted(tr.facet_vertices(f));
        // The label of a cell with vertices in several subdomains tells nothing about its facets.
        if(!std::all_of(t.begin(), t.end(), [this](int v) { return candidate_.numbering.is_on_boundary(v); }))
          continue;
        const int old = snapshot.facet_number(t);
        if(is_separating || (old >= 0 && old_facets[old].labels[0] == old_facets[old].labels[1]))
          found.push_back({ t, old, f });
      }
    });
  }

  // The patch on which all vertices agree.
  int patch_of_new_facet(const Boundary_facet& f)
  {
    const Boundary_complex_3& boundary = candidate_.snapshot.boundary.complex();
    const auto patches = [&](int v)
    {
      std::set<int> here;
      for(int n = 0; n < boundary.number_of_umbrellas(v); ++n)
      {
        const Boundary_umbrella& umbrella = boundary.umbrella(v, n);
        if(Boundary_complex_3::same_labels(umbrella.labels, f.labels) && umbrella.patch != Boundary_facet::no_patch)
          here.insert(umbrella.patch);
      }
      return here;
    };
    const Triple& t = f.vertices;
    const std::vector<Site>& s = candidate_.sites;
    return patch_of_facet(t, {{ s[t[0]], s[t[1]], s[t[2]] }}, patches, domain_);
  }

  Complex_candidate_3& candidate_;
  const Domain_view_3& domain_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_BOUNDARY_EXTRACTION_3_H
