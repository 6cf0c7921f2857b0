// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_COMPLETE_MESH_COMPLEX_3_H
#define CGAL_COMPLETE_MESH_COMPLEX_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Requirements.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Global_odt_mesh_3/internal/Parameter_check.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Complex_completion_3.h>

#include <cmath>
#include <type_traits>

namespace CGAL {

/*!
\ingroup PkgGlobalOdtMesh3Domains

makes a complete complex of a triangulation whose cells have subdomain indices, where 0 means outside. Most files have no more than
that. Some facets may have patches, some edges may have curves, and some vertices may be corners; all of these stay. The function
adds

- the facets whose two sides are in different subdomains. Those between the same two subdomains get the same new patch:
an index greater than all there are or, if patches are pairs, the pair of subdomains;
- the edges around which there are one, or more than two, facets of the complex, or two of different patches, or two whose
normals are at an angle above `angle_bound`. Those where the same patches meet get the same new curve;
- the vertices where curves end, branch, or meet, as corners.

It sets dimension and index of all vertices. A second call changes nothing.

\tparam C3T3 a model of `MeshComplexWithFeatures_3InTriangulation_3`, not periodic, whose curves and corners have integral
indices, and whose patches have integral indices or pairs of subdomain indices. It suffices that one of the two cells of a
facet has the patch.

\param c3t3 the mesh, whose complex is completed
\param angle_bound the angle, in degrees, as for `Polyhedral_mesh_domain_with_features_3::detect_features()`

\pre `c3t3.triangulation().dimension() == 3`
\pre `0 <= angle_bound <= 180`; 180 finds no edges inside of patches

\sa `Tetrahedral_mesh_domain_3`
\sa `odt_optimize_tetrahedral_mesh_3()`
*/
template <class C3T3>
void complete_mesh_complex_3(C3T3& c3t3, double angle_bound = 60)
{
  namespace odt = Global_odt_mesh_3::internal;
  static_assert(std::is_same<typename C3T3::Triangulation::Periodic_tag, Tag_false>::value, "the mesh must not be periodic");
  CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(c3t3.triangulation().dimension() == 3,
                                         "c3t3 must have a triangulation of dimension 3");
  CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(angle_bound >= 0 && angle_bound <= 180, "angle_bound must be in [0, 180] degrees");
  // Even a rounded cosine is not smaller than -2.
  odt::Complex_completion_3<C3T3>(c3t3, angle_bound == 180 ? -2 : std::cos(angle_bound * CGAL_PI / 180))();
}

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_COMPLETE_MESH_COMPLEX_3_H
