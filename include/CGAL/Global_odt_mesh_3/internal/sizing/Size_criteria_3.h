// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_SIZE_CRITERIA_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_SIZE_CRITERIA_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/User_field_3.h>
#include <CGAL/Global_odt_mesh_3/internal/sizing/Largest_cells_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// How large cells and facets may be, in the sense of the criteria of the mesh generator: cells by their circumradii, as in each
// subdomain of the input or as a field says; facets by the distances from their surface centers to their vertices, as in the
// input. The distances to their circumcenters are not bounded: on an elephant of 1768 vertices, that takes 300 more and makes
// cells worse.
class Size_criteria_3
{
public:
  // A cell that is too large, or the cell of a facet that is.
  struct Violation
  {
    static constexpr int no_facet = -1;

    double excess;
    Quadruple cell;               // vertices, by their numbers in the table
    int facet = no_facet;         // the index of its opposite vertex

    // The worst first.
    bool operator<(const Violation& o) const { return excess != o.excess ? excess > o.excess : cell < o.cell; }
  };

  // If a field gives sizes, they bound cells.
  Size_criteria_3(const Mesh_table_3& input, const User_field_3& field)
    : field_(field)
  {
    for(const Mesh_table_3::Cell& c : input.cells)
      if(c.label != Domain_view_3::outside)
      {
        double& largest = squared_circumradius_[c.label];
        largest = (std::max)(largest, squared_circumradius(sites(input, c)));
      }
    for(const Mesh_table_3::Facet& f : input.facets)
      if(f.patch_of_center != Mesh_table_3::no_patch)
        facet_radius_ = (std::max)(facet_radius_, facet_radius(input, f));
  }

  std::vector<Violation> violations(const Mesh_table_3& mesh) const
  {
    std::vector<Violation> result;
    const auto add = [&result](double excess, const Violation& v)
    {
      if(excess > 1 + tolerance)
        result.push_back(v);
    };
    for(const Mesh_table_3::Cell& c : mesh.cells)
      if(c.label != Domain_view_3::outside)
      {
        const double excess = std::sqrt(squared_circumradius(sites(mesh, c)) / squared_bound(mesh, c));
        add(excess, { excess, c.vertices });
      }
    for(const Mesh_table_3::Facet& f : mesh.facets)
    {
      const double excess = field_ || facet_radius_ == 0 ? 0 : facet_radius(mesh, f) / facet_radius_;
      const Mesh_table_3::Cell& c = mesh.cells[f.cell];
      // Each facet is in the table from either side.
      if(c.vertices < mesh.cells[c.neighbors[f.index]].vertices)
        continue;
      const bool is_inside = c.label != Domain_view_3::outside;
      add(excess, is_inside ? Violation{ excess, c.vertices, f.index }
                            : Violation{ excess, mesh.cells[c.neighbors[f.index]].vertices, mesh.mirror_index(f.cell, f.index) });
    }
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  static constexpr double tolerance = 1e-6;

  static std::array<Site, 4> sites(const Mesh_table_3& m, const Mesh_table_3::Cell& c)
  { return {{ m.sites[c.vertices[0]], m.sites[c.vertices[1]], m.sites[c.vertices[2]], m.sites[c.vertices[3]] }}; }

  static Triple vertices(const Mesh_table_3& m, const Mesh_table_3::Facet& f)
  {
    const Quadruple& q = m.cells[f.cell].vertices;
    return {{ q[(f.index + 1) % 4], q[(f.index + 2) % 4], q[(f.index + 3) % 4] }};
  }

  // To the nearest of its vertices, which differ if they have weights.
  static double facet_radius(const Mesh_table_3& m, const Mesh_table_3::Facet& f)
  {
    double least = (std::numeric_limits<double>::infinity)();
    for(int v : vertices(m, f))
      least = (std::min)(least, std::sqrt(squared_distance(m.sites[v], f.center)));
    return least;
  }

  double squared_bound(const Mesh_table_3& m, const Mesh_table_3::Cell& c) const
  {
    if(!field_)
      return squared_circumradius_.at(c.label);
    double most = 0;
    int highest = 0;
    for(int v : c.vertices)
      highest = (std::max)(highest, m.dimensions[v]);
    for(int v : c.vertices)
      if(m.dimensions[v] == highest)
        most = (std::max)(most, field_.value(m.stratum(v), m.sites[v]));
    return most * most;
  }

  User_field_3 field_;
  std::map<int, double> squared_circumradius_;            // the largest, by subdomain
  double facet_radius_ = 0;                               // the largest
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_SIZE_CRITERIA_3_H
