// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_ODT_OPTIMIZE_TETRAHEDRAL_MESH_3_H
#define CGAL_ODT_OPTIMIZE_TETRAHEDRAL_MESH_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Requirements.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Mesh_optimization_return_code.h>
#include <CGAL/Tetrahedral_mesh_domain_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

namespace CGAL {

/*!
\ingroup PkgGlobalOdtMesh3Functions

improves the cells of a tetrahedral mesh that comes without a domain, for example from a file. The domain is the one that the mesh
fills, a `Tetrahedral_mesh_domain_3`: facets of the complex are its surfaces, and edges and corners its features. This is
`odt_optimize_mesh_3(c3t3, Tetrahedral_mesh_domain_3<C3T3>(c3t3), np...)`.

\tparam C3T3 as for `Tetrahedral_mesh_domain_3`
\tparam NamedParameters a sequence of named parameters, in the notations that `odt_optimize_mesh_3()` accepts

\param c3t3 the mesh, which is modified
\param np an optional sequence of the named parameters of `odt_optimize_mesh_3()`

\return as `odt_optimize_mesh_3()`

\pre All facets between two subdomains are in the complex, and so are all features that are to stay.
`complete_mesh_complex_3()` adds what is missing.
\pre Those of `odt_optimize_mesh_3()`

\sa `complete_mesh_complex_3()`
\sa `odt_optimize_mesh_3()`
*/
template <class C3T3, class... NamedParameters>
Mesh_optimization_return_code
odt_optimize_tetrahedral_mesh_3(C3T3& c3t3, const NamedParameters&... np)
{
  const Tetrahedral_mesh_domain_3<C3T3> domain(c3t3);
  return odt_optimize_mesh_3(c3t3, domain, np...);
}

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_ODT_OPTIMIZE_TETRAHEDRAL_MESH_3_H
