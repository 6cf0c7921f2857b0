// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_EXAMPLES_READ_SURFACE_H
#define GLOBAL_ODT_MESH_3_EXAMPLES_READ_SURFACE_H

#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/helpers.h>

#include <fstream>
#include <iostream>
#include <string>

// Reads a surface in OFF that bounds a volume. If there is none, says why, and gives false. Says if the surface intersects
// itself, which the mesh generator does not ask for, but most often survives.
template <class Polyhedron>
bool read_surface(const std::string& file, Polyhedron& polyhedron)
{
  const char* complaint = nullptr;
  std::ifstream in(file);
  if(!in)
    complaint = "cannot be opened";
  else if(!(in >> polyhedron))
    complaint = "is not a 2-manifold surface in OFF";
  else if(num_faces(polyhedron) == 0)
    complaint = "has no facets";
  else if(!CGAL::is_triangle_mesh(polyhedron))
    complaint = "has facets that are not triangles";
  else if(!CGAL::is_closed(polyhedron))
    complaint = "is not closed";
  if(complaint != nullptr)
    std::cerr << file << ' ' << complaint << '\n';
  else if(CGAL::Polygon_mesh_processing::does_self_intersect(polyhedron))
    std::cerr << file << " intersects itself, so that some of the domain may be inside out\n";
  return complaint == nullptr;
}

#endif // GLOBAL_ODT_MESH_3_EXAMPLES_READ_SURFACE_H
