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
#include <CGAL/Global_odt_mesh_3/internal/complex/Exact_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Patch_of_facet_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>

#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Finds the boundary facets of a labelled candidate, and their patches.
class Boundary_extraction_3
{
public:
  // Collects the facets that separate subdomains, or may do so once cells with all vertices
  // on the boundary are labelled otherwise, and those that were in the complex without separating any. All their vertices
  // are on the boundary, as cells around a vertex that is not have its label.
  Boundary_extraction_3(Complex_candidate_3& candidate, const Domain_view_3& domain)
    : candidate_(candidate)
    , domain_(domain)
  {
    typedef std::pair<Triple, Facet> Found_facet;
    const std::vector<Cell_handle>& cells = candidate.cells_at_boundary;
    std::vector<Found_facet> found = collect_in_chunks<Found_facet>(static_cast<int>(cells.size()), candidate.threads,
                                                                    [&](int n, std::vector<Found_facet>& some)
    {
      for(int i = 0; i < 4; ++i)
        if(const Facet f(cells[n], i); may_be_on_boundary(f) && candidate.working.is_first_side(f))
          some.emplace_back(sorted(candidate.working.vertices(f)), f);
    });
    candidate.threads.sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for(const auto& f : found)
      possible_facets_.push_back(f.second);
  }

  // Collects the boundary facets among them, for the labels that cells have now.
  void find_boundary()
  {
    const std::vector<Boundary_facet>& old_facets = candidate_.snapshot.boundary.complex().facets();
    const bool has_others = candidate_.snapshot.has_unseparating_facets;
    std::vector<Boundary_facet> facets(possible_facets_.size());
    std::vector<int> old_numbers(possible_facets_.size(), -1);
    const auto find_facets = [&](int n, std::vector<int>& found)
    {
      const Facet& f = possible_facets_[n];
      const bool is_separating = separates(f);
      if(!is_separating && !has_others)
        return;
      const Triple t = candidate_.working.vertices(f);
      const int old = candidate_.snapshot.facet_number(t);
      if(!is_separating && (old < 0 || old_facets[old].labels[0] != old_facets[old].labels[1]))
        return;
      old_numbers[n] = old;
      facets[n] = { t, {{ f.first->label(), f.first->neighbor(f.second)->label() }},
                    old >= 0 ? old_facets[old].patch : unknown_patch };
      found.push_back(n);
    };
    std::vector<Boundary_facet> found;
    candidate_.facets.clear();
    candidate_.old_facets.clear();
    for(int n : collect_in_chunks(static_cast<int>(possible_facets_.size()), candidate_.threads, find_facets))
    {
      if(old_numbers[n] < 0)
        facets[n].patch = patch_of_new_facet(facets[n]);
      found.push_back(facets[n]);
      candidate_.facets.push_back(possible_facets_[n]);
      candidate_.old_facets.push_back(old_numbers[n]);
    }
    candidate_.boundary_complex = std::make_shared<const Boundary_complex_3>(std::move(found), candidate_.sites.size(),
                                                                                candidate_.threads);
  }

private:
  static bool separates(const Facet& f) { return f.first->label() != f.first->neighbor(f.second)->label(); }

  bool may_be_on_boundary(const Facet& f) const
  {
    return candidate_.snapshot.has_unseparating_facets || separates(f)
           || f.first->has_flag(IS_BOUNDARY_CELL) || f.first->neighbor(f.second)->has_flag(IS_BOUNDARY_CELL);
  }

  // The patch from which it has been flipped, or else that on which all vertices agree.
  int patch_of_new_facet(const Boundary_facet& f)
  {
    const auto flipped = candidate_.snapshot.flipped_facets.find(sorted(f.vertices));
    if(flipped != candidate_.snapshot.flipped_facets.end())
      return flipped->second;
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
    return patch_of_facet(f.vertices, candidate_.sites, patches, domain_);
  }

  Complex_candidate_3& candidate_;
  const Domain_view_3& domain_;
  std::vector<Facet> possible_facets_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_BOUNDARY_EXTRACTION_3_H
