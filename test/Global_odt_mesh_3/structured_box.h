// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_TEST_STRUCTURED_BOX_H
#define GLOBAL_ODT_MESH_3_TEST_STRUCTURED_BOX_H

#include "../../examples/Global_odt_mesh_3/complex_of_medit_mesh.h"
#include "../../examples/Global_odt_mesh_3/medit_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Tetrahedral_mesh_domain_3.h>
#include <CGAL/tags.h>

#include <array>
#include <vector>

// A box of hexahedra that are divided into cells, as other programs make it.
namespace structured_box {

struct Indices
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel R;
  typedef int Subdomain_index;
  typedef int Surface_patch_index;
  typedef int Curve_index;
  typedef int Corner_index;
  typedef int Index;
  typedef CGAL::Tag_true Has_features;
};

typedef CGAL::Mesh_triangulation_3<Indices>::type Triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> C3t3;
typedef CGAL::Tetrahedral_mesh_domain_3<C3t3> Domain;

// Of n^3 unit cubes in five or six cells each, some of which are inverted. If there are two labels, those with x < n / 2
// have label 1, and the others 2.
inline Medit_mesh mesh(int n, int cells_in_hexahedron, bool has_two_labels = false)
{
  Medit_mesh m;
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j)
      for(int k = 0; k <= n; ++k)
        m.points.push_back({{ double(i), double(j), double(k) }});
  m.point_references.resize(m.points.size());
  typedef std::vector<std::array<int, 4> > Cells;
  const Cells five[] = { { { 0, 1, 2, 4 }, { 3, 1, 2, 7 }, { 5, 1, 4, 7 }, { 6, 2, 4, 7 }, { 1, 2, 4, 7 } },
                         { { 1, 0, 3, 5 }, { 2, 0, 3, 6 }, { 4, 0, 5, 6 }, { 7, 3, 5, 6 }, { 0, 3, 5, 6 } } };
  const Cells six = { { 0, 1, 3, 7 }, { 0, 1, 5, 7 }, { 0, 2, 3, 7 }, { 0, 2, 6, 7 }, { 0, 4, 5, 7 }, { 0, 4, 6, 7 } };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      for(int k = 0; k < n; ++k)
        for(std::array<int, 4> t : cells_in_hexahedron == 6 ? six : five[(i + j + k) % 2])
        {
          for(int& v : t)
            v = ((i + (v & 1)) * (n + 1) + j + (v >> 1 & 1)) * (n + 1) + k + (v >> 2);
          m.tetrahedra.push_back({ t, has_two_labels && 2 * i >= n ? 2 : 1 });
        }
  return m;
}

} // namespace structured_box

#endif // GLOBAL_ODT_MESH_3_TEST_STRUCTURED_BOX_H
