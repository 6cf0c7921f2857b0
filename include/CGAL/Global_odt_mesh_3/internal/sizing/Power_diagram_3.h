// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_POWER_DIAGRAM_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_POWER_DIAGRAM_3_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_with_weighted_circumcenter_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Robust_weighted_circumcenter_filtered_traits_3.h>
#include <CGAL/Triangulation_data_structure_3.h>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// A triangulation whose dual points are computed once each, and exactly in flat cells.
struct Power_diagram_3
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef Robust_weighted_circumcenter_filtered_traits_3<Kernel> Traits;
  typedef Triangulation_data_structure_3<Regular_triangulation_vertex_base_3<Traits>,
                                         Regular_triangulation_cell_base_with_weighted_circumcenter_3<Traits> > Tds;
  typedef Regular_triangulation_3<Traits, Tds> Triangulation;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_POWER_DIAGRAM_3_H
