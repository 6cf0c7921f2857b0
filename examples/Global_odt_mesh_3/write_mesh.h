// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_EXAMPLES_WRITE_MESH_H
#define GLOBAL_ODT_MESH_3_EXAMPLES_WRITE_MESH_H

#include <CGAL/IO/output_to_vtu.h>

#include <fstream>
#include <iostream>
#include <string>

// Writes a mesh as prefix.mesh, the format of Medit, and as prefix.vtu, that of ParaView.
// Cells have the numbers of their subdomains. CGAL shifts those of patches that are not below the numbers of subdomains.
template <class C3t3>
void write_mesh(const C3t3& c3t3, const std::string& prefix)
{
  std::ofstream medit(prefix + ".mesh");
  c3t3.output_to_medit(medit, false /* rebind */, true /* show_patches: each facet is written once */);
  std::ofstream vtu(prefix + ".vtu", std::ios::binary);
  CGAL::IO::output_to_vtu(vtu, c3t3);
  if(medit && vtu)
    std::cout << "mesh: " << prefix << ".mesh, " << prefix << ".vtu\n";
  else
    std::cerr << prefix << ".mesh and " << prefix << ".vtu cannot be written\n";
}

#endif // GLOBAL_ODT_MESH_3_EXAMPLES_WRITE_MESH_H
