// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_BOUNDARY_PEELING_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_BOUNDARY_PEELING_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Boundary_extraction_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Cell_knowledge.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Facet_shape_check_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Fidelity_check_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Flat_boundary_cells_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Topology_check_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Takes flat cells off the boundary, on the way: they get the label that is on the other side of two of their facets, which
// the two others replace, where that keeps the topology. In the end it is vertices that have to move, lest a cell have
// another label than the domain gives its dual point.
class Boundary_peeling_3
{
public:
  Boundary_peeling_3(Restricted_candidate_3& candidate, const Domain_view_3& domain, Boundary_extraction_3& extraction,
                     const Fidelity_check_3& fidelity, const Facet_shape_check_3& shapes)
    : candidate_(candidate)
    , extraction_(extraction)
    , flat_cells_(candidate, domain, fidelity, shapes)
  {}

  void peel()
  {
    for(int pass = 0; pass < most_passes; ++pass)
    {
      Peeled_cells peeled = find_cells();
      if(peeled.empty())
        break;
      const std::shared_ptr<const Boundary_complex_3> before = candidate_.boundary_complex;
      for(const auto& p : peeled)
      {
        p.first->set_label(p.second.second);
        forget(p.first, IS_SETTLED);
      }
      extraction_.find_boundary();
      put_back_harmful(peeled);
      for(auto& c : candidate_.boundary_cells)
      {
        const auto p = peeled.find(c.first);
        if(p == peeled.end())
          continue;
        candidate_.peeled_cells.emplace(sorted(candidate_.numbers(c.first)), p->second.first);
        c.second = p->second.second;
        store_facets(c.first, *before);
      }
    }
  }

private:
  typedef std::map<Cell_handle, std::pair<int, int> > Peeled_cells;     // with old and new label

  static constexpr int most_passes = 4;                       // cells lie upon each other
  static constexpr int no_subdomain = Restricted_state_3::no_subdomain;

  // Cells to be peeled that have no vertices in common: the first ones by the numbers of their vertices, since the order
  // of cells depends on how the triangulation has been made.
  Peeled_cells find_cells()
  {
    std::map<Quadruple, typename Peeled_cells::value_type> flat;
    for(const auto& c : candidate_.boundary_cells)
    {
      const int label = refused_.count(c.first) > 0 ? int(no_subdomain) : flat_cells_.label_beyond(c.first, c.second);
      if(label != no_subdomain)
        flat.emplace(sorted(candidate_.numbers(c.first)), std::make_pair(c.first, std::make_pair(c.second, label)));
    }
    Peeled_cells cells;
    std::set<int> used;
    for(const auto& f : flat)
    {
      const Quadruple& q = f.first;
      if(std::any_of(q.begin(), q.end(), [&](int v) { return used.count(v) > 0; }))
        continue;
      used.insert(q.begin(), q.end());
      cells.insert(f.second);
    }
    return cells;
  }

  // Cells that change the topology of the boundary stay where they were: those at vertices where
  // it has changed or, if there are none, all.
  void put_back_harmful(Peeled_cells& peeled)
  {
    for(std::set<int> changed; !peeled.empty() && !(changed = topology_changes(candidate_)).empty();
        extraction_.find_boundary())
    {
      const auto is_harmful = [&](Cell_handle c)
      {
        const Quadruple q = candidate_.numbers(c);
        return std::any_of(q.begin(), q.end(), [&](int v) { return changed.count(v) > 0; });
      };
      const bool any = std::any_of(peeled.begin(), peeled.end(),
                                   [&](const auto& p) { return is_harmful(p.first); });
      for(auto p = peeled.begin(); p != peeled.end(); )
        if(any && !is_harmful(p->first))
          ++p;
        else
        {
          refused_.insert(p->first);
          p->first->set_label(p->second.first);
          p = peeled.erase(p);
        }
    }
  }

  // Those of a peeled cell that are no longer on the boundary.
  void store_facets(Cell_handle c, const Boundary_complex_3& before)
  {
    // Facets are in the order of their sorted vertices.
    const auto precedes = [](const Boundary_facet& f, const Triple& t) { return sorted(f.vertices) < t; };
    for(int i = 0; i < 4; ++i)
    {
      const Triple t = sorted(candidate_.numbered.vertices(Facet(c, i)));
      const auto f = std::lower_bound(before.facets().begin(), before.facets().end(), t, precedes);
      if(f != before.facets().end() && sorted(f->vertices) == t)
        candidate_.peeled_facets.emplace(t, f->patch);
    }
  }

  Restricted_candidate_3& candidate_;
  Boundary_extraction_3& extraction_;
  Flat_boundary_cells_3 flat_cells_;
  std::set<Cell_handle> refused_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_BOUNDARY_PEELING_3_H
