// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_BOUNDARY_FLIPS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_BOUNDARY_FLIPS_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Boundary_extraction_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Candidate_checks_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Exact_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Surface_centers_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Flat cells on the boundary that may as well be on its other side.
//
// A sliver with two facets on the boundary stems from four vertices in nearly one plane and on one circle. Its two other
// facets could take the place of those if they are good, and if their dual lines meet the surface.
class Flat_boundary_cells_3
{
public:
  static constexpr int no_subdomain = Complex_snapshot_3::no_subdomain;

  Flat_boundary_cells_3(Complex_candidate_3& candidate, const Domain_view_3& domain, const Facet_bounds_3& bounds)
    : candidate_(candidate)
    , bounds_(bounds)
    , centers_(candidate, domain)
  {}

  // The label beyond both boundary facets of such a cell, or no_subdomain if it is none.
  int label_beyond(Cell_handle c, int label)
  {
    if(label == Domain_view_3::outside)
      return no_subdomain;
    std::array<int, 4> facet;
    int count = 0;
    for(int i = 0; i < 4; ++i)
      if(c->neighbor(i)->label() != c->label())
        facet[count++] = i;
    if(count != 2 || c->neighbor(facet[0])->label() != c->neighbor(facet[1])->label())
      return no_subdomain;
    const Quadruple q = candidate_.numbers(c);
    const Cell_shape_3 shape(candidate_.sites[q[0]], candidate_.sites[q[1]], candidate_.sites[q[2]], candidate_.sites[q[3]]);
    const double between = shape.angles[facet[0] == 0 ? facet[1] - 1 : facet[0] + facet[1]];
    if(between < 180 - flat_angle || *std::min_element(shape.angles.begin(), shape.angles.end()) > sliver_angle)
      return no_subdomain;
    for(int i = 0; i < 4; ++i)
    {
      const std::array<int, 3> t = {{ q[(i + 1) % 4], q[(i + 2) % 4], q[(i + 3) % 4] }};
      if(i == facet[0] || i == facet[1])
        continue;
      if(!bounds_.permit(candidate_, t) || !has_surface_center(Facet(c, i)))
        return no_subdomain;
    }
    return c->neighbor(facet[0])->label();
  }

  // Spares the boundary facets of these cells the checks of facets.
  void exempt()
  {
    candidate_.exempt_facets.clear();
    for(const auto& c : candidate_.boundary_cells)
      if(label_beyond(c.first, c.second) != no_subdomain)
        for(int i = 0; i < 4; ++i)
          if(c.first->neighbor(i)->label() != c.first->label())
            candidate_.exempt_facets.insert(sorted(candidate_.working.vertices(Facet(c.first, i))));
  }

private:
  static constexpr double sliver_angle = 20, flat_angle = 35; // degrees

  bool has_surface_center(Facet f)
  {
    if(!candidate_.working.is_first_side(f))
      f = candidate_.triangulation().mirror_facet(f);
    const std::array<int, 3> t = candidate_.working.vertices(f);
    Complex_candidate_3::Surface_center center;
    center.point = estimated_surface_center(t, candidate_.measured_boundary, candidate_.sites);
    return centers_.find_center(f, t, center);
  }

  Complex_candidate_3& candidate_;
  const Facet_bounds_3& bounds_;
  Candidate_center_search_3 centers_;
};

// Takes flat cells off the boundary, on the way: they get the label that is on the other side of two of their facets, which
// the two others replace, where that keeps the topology. In the end it is vertices that have to move, lest a cell have
// another label than the domain gives its dual point.
class Boundary_flips_3
{
public:
  Boundary_flips_3(Complex_candidate_3& candidate, const Domain_view_3& domain, Boundary_extraction_3& extraction,
                   const Facet_bounds_3& bounds)
    : candidate_(candidate)
    , extraction_(extraction)
    , flat_cells_(candidate, domain, bounds)
  {}

  // What is not flipped is not exempt from the checks of facets.
  void flip()
  {
    candidate_.exempt_facets.clear();
    for(int pass = 0; pass < most_passes; ++pass)
    {
      Flipped_cells flipped = find_cells();
      if(flipped.empty())
        break;
      const std::shared_ptr<const Boundary_complex_3> before = candidate_.boundary_complex;
      for(const auto& p : flipped)
      {
        p.first->set_label(p.second.second);
        p.first->clear_flag(IS_SETTLED);
      }
      extraction_.find_boundary();
      put_back_harmful(flipped);
      for(auto& c : candidate_.boundary_cells)
      {
        const auto p = flipped.find(c.first);
        if(p == flipped.end())
          continue;
        candidate_.flipped_cells.emplace(sorted(candidate_.numbers(c.first)), p->second.first);
        c.second = p->second.second;
        store_facets(c.first, *before);
      }
    }
  }

private:
  typedef std::map<Cell_handle, std::pair<int, int> > Flipped_cells;     // with old and new label

  static constexpr int most_passes = 4;                       // cells lie upon each other
  static constexpr int no_subdomain = Complex_snapshot_3::no_subdomain;

  // Cells to be flipped that have no vertices in common: the first ones by the numbers of their vertices, since the order
  // of cells depends on how the triangulation has been made.
  Flipped_cells find_cells()
  {
    std::map<Quadruple, typename Flipped_cells::value_type> flat;
    for(const auto& c : candidate_.boundary_cells)
    {
      const int label = refused_.count(c.first) > 0 ? int(no_subdomain) : flat_cells_.label_beyond(c.first, c.second);
      if(label != no_subdomain)
        flat.emplace(sorted(candidate_.numbers(c.first)), std::make_pair(c.first, std::make_pair(c.second, label)));
    }
    Flipped_cells cells;
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
  void put_back_harmful(Flipped_cells& flipped)
  {
    for(std::set<int> changed; !flipped.empty() && !(changed = topology_changes(candidate_)).empty();
        extraction_.find_boundary())
    {
      const auto is_harmful = [&](Cell_handle c)
      {
        const Quadruple q = candidate_.numbers(c);
        return std::any_of(q.begin(), q.end(), [&](int v) { return changed.count(v) > 0; });
      };
      const bool any = std::any_of(flipped.begin(), flipped.end(),
                                   [&](const auto& p) { return is_harmful(p.first); });
      for(auto p = flipped.begin(); p != flipped.end(); )
        if(any && !is_harmful(p->first))
          ++p;
        else
        {
          refused_.insert(p->first);
          p->first->set_label(p->second.first);
          p = flipped.erase(p);
        }
    }
  }

  // Those of a flipped cell that are no longer on the boundary.
  void store_facets(Cell_handle c, const Boundary_complex_3& before)
  {
    // Facets are in the order of their sorted vertices.
    const auto precedes = [](const Boundary_facet& f, const Triple& t) { return sorted(f.vertices) < t; };
    for(int i = 0; i < 4; ++i)
    {
      const Triple t = sorted(candidate_.working.vertices(Facet(c, i)));
      const auto f = std::lower_bound(before.facets().begin(), before.facets().end(), t, precedes);
      if(f != before.facets().end() && sorted(f->vertices) == t)
        candidate_.flipped_facets.emplace(t, f->patch);
    }
  }

  Complex_candidate_3& candidate_;
  Boundary_extraction_3& extraction_;
  Flat_boundary_cells_3 flat_cells_;
  std::set<Cell_handle> refused_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_BOUNDARY_FLIPS_3_H
