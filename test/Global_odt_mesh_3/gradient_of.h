// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_TEST_GRADIENT_OF_H
#define GLOBAL_ODT_MESH_3_TEST_GRADIENT_OF_H

#include <CGAL/Global_odt_mesh_3/internal/energy/Odt_cell_energies_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <vector>

// Of all vertices, as the last evaluation has found it.
inline std::vector<CGAL::Global_odt_mesh_3::internal::Site_gradient>
gradient_of(const CGAL::Global_odt_mesh_3::internal::Moving_triangulation_3& mesh)
{
  typedef CGAL::Global_odt_mesh_3::internal::Site_gradient Site_gradient;
  std::vector<Site_gradient> gradient(mesh.sites.size());
  mesh.for_each_gradient([&](int v, const Site_gradient& g) { gradient[v] = g; });
  return gradient;
}

#endif // GLOBAL_ODT_MESH_3_TEST_GRADIENT_OF_H
