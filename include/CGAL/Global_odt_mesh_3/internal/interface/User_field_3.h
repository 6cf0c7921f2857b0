// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_INTERFACE_USER_FIELD_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_INTERFACE_USER_FIELD_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Quadratic_polynomial_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <functional>
#include <optional>

namespace CGAL::Global_odt_mesh_3::internal {

// What a vertex is on, which does not change while it moves.
struct Vertex_stratum
{
  int number;           // in the user's mesh, or -1
  int dimension;
  int place;            // of vertices that the user's mesh has not got: the subdomain or patch

  static Vertex_stratum inside(int label) { return { -1, 3, label }; }
};

// What the user wants sizes or density to be, if anything.
struct User_field_3
{
  enum Meaning { SIZE, DENSITY };

  // The value at the position of a vertex.
  typedef std::function<double(const Vertex_stratum&, const Site&)> Function;

  Meaning meaning = SIZE;
  Function value;
  std::optional<Quadratic_polynomial_3> polynomial;   // if it is one

  explicit operator bool() const { return static_cast<bool>(value); }
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_INTERFACE_USER_FIELD_3_H
