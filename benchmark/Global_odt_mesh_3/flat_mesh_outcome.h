// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_FLAT_MESH_OUTCOME_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_FLAT_MESH_OUTCOME_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>
#include <CGAL/Mesh_quality_report_3.h>

// What a method has made of a mesh, and in which time. Cells are counted below 10, 13, 15 and 20 degrees.
struct Outcome
  : public CGAL::Mesh_quality_report_3
{
  double energy = 0, time = 0;
};

inline Outcome outcome(const CGAL::Global_odt_mesh_3::internal::Moving_triangulation_3& mesh, double time)
{
  using namespace CGAL::Global_odt_mesh_3::internal;
  Outcome o;
  o.energy = mesh.energy();
  o.time = time;
  o.number_of_vertices = mesh.sites.size();
  for(double angle : { 10, 13, 15, 20 })
    o.cells_below.emplace_back(angle, 0);
  o.cells_below_at_boundary = o.cells_below;
  for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
  {
    if(!mesh.topology.is_alive(c))
      continue;
    const int* const v = mesh.topology.vertices(c);
    const Cell_shape_3 shape(mesh.sites[v[0]], mesh.sites[v[1]], mesh.sites[v[2]], mesh.sites[v[3]]);
    // There is no complex, and no angle between its facets.
    add_shape(o, shape, 180);
    o.mean_radius_ratio += shape.radius_ratio;
    ++o.number_of_cells;
  }
  o.mean_radius_ratio /= double(o.number_of_cells);
  return o;
}

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_FLAT_MESH_OUTCOME_H
