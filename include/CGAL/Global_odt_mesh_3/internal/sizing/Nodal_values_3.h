// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_NODAL_VALUES_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_NODAL_VALUES_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Values at the vertices of a mesh, interpolated linearly on a copy of it, in which each vertex is found by walking from the cell where
// it was last.
class Nodal_values_3
{
public:
  Nodal_values_3(const Moving_triangulation_3& mesh, std::vector<double> values)
    : topology_(mesh.topology)
    , sites_(mesh.sites)
    , number_of_movable_vertices_(mesh.number_of_movable_vertices)
    , values_(std::move(values))
    , last_cell_(mesh.sites.size())
  {
    for(std::size_t v = 0; v < last_cell_.size(); ++v)
      last_cell_[v] = topology_.incident_cell(static_cast<int>(v));
  }

  // Where vertex v is now; vertices that stay have their own.
  double at(int v, const Site& s) { return v < number_of_movable_vertices_ ? interpolated(last_cell_[v], s) : values_[v]; }

  // At a point of a cell around the vertex.
  double beside(int v, const Site& s) const
  {
    int c = last_cell_[v];
    return interpolated(c, s);
  }

private:
  // Sets `c`, where the search begins, to the cell where it ends.
  double interpolated(int& c, const Site& s) const
  {
    std::array<double, 4> b;
    c = locate(c, s, b);
    double value = 0;
    for(int i = 0; i < 4; ++i)
      value += b[i] * values_[topology_.vertices(c)[i]];
    return value;
  }

  // Visibility walk; a point beyond a constrained facet gets the barycentric coordinates of
  // the last cell, clamped.
  int locate(int c, const Site& s, std::array<double, 4>& b) const
  {
    int previous = -1;
    for(int step = 1; ; ++step)
    {
      const double total = volumes(topology_.vertices(c), s, b);
      int leave = -1;
      double lowest = 0;
      for(int i = 0; i < 4; ++i)
      {
        const Half_facet across = topology_.neighbor(Half_facet(c, i));
        if(b[i] < lowest && !across.is_side() && across.cell() != previous)
        {
          lowest = b[i];
          leave = across.cell();
        }
      }
      if(leave < 0 || step == max_steps)
      {
        double sum = 0;
        for(double& x : b)
        {
          x = total > 0 ? (std::max)(0., x / total) : 0;    // a flat cell of the input may have no volume
          sum += x;
        }
        for(double& x : b)
          x = sum > 0 ? x / sum : 0.25;
        return c;
      }
      previous = c;
      c = leave;
    }
  }

  // The volumes of a cell's parts between its facets and a point, and of the cell, times six.
  double volumes(const int* cell, const Site& s, std::array<double, 4>& parts) const
  {
    const Site& origin = sites_[cell[0]];
    const auto edge = [&origin](const Site& p) { return Vector_3(p.x - origin.x, p.y - origin.y, p.z - origin.z); };
    const Vector_3 a = edge(sites_[cell[1]]), b = edge(sites_[cell[2]]), c = edge(sites_[cell[3]]), d = edge(s);
    const Vector_3 normal = b.cross(c);
    const double all = a.dot(normal);
    parts[1] = d.dot(normal);
    parts[2] = d.dot(c.cross(a));
    parts[3] = d.dot(a.cross(b));
    parts[0] = all - parts[1] - parts[2] - parts[3];
    return all;
  }

  static constexpr int max_steps = 200;

  Indexed_triangulation_3 topology_;
  std::vector<Site> sites_;
  int number_of_movable_vertices_;
  std::vector<double> values_;
  std::vector<int> last_cell_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_NODAL_VALUES_3_H
