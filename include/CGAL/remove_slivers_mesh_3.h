// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_REMOVE_SLIVERS_MESH_3_H
#define CGAL_REMOVE_SLIVERS_MESH_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Requirements.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Global_odt_mesh_3/internal/door/Named_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Optimize_mesh_3.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Read_parameters.h>
#include <CGAL/Mesh_optimization_return_code.h>

namespace CGAL {
namespace Global_odt_mesh_3::internal {

// What remove_slivers_mesh_3() reads.
typedef Parameter_list<tags::time_limit, tags::sliver_bound, internal_np::optimize_boundary_t, tags::facet_distance,
                       internal_np::domain_is_thread_safe_t, internal_np::random_seed_t, internal_np::vertex_is_constrained_t,
                       internal_np::facet_is_constrained_t, internal_np::cell_selector_t, internal_np::callback_t, internal_np::visitor_t,
                       internal_np::optimization_report_t> Sliver_removal_arguments;

} // namespace Global_odt_mesh_3::internal

/*!
\ingroup PkgGlobalOdtMesh3Functions

removes the slivers of a tetrahedral mesh and leaves the rest as it is. This is what `odt_optimize_mesh_3()` does at its
end, without minimizing an energy before. Like `perturb_mesh_3()`, it moves vertices of cells with small dihedral
angles and keeps the triangulation regular; few vertices move.

The bound on the angles rises in steps of 20, 30, 35, 40, ... degrees, as described in section \ref godt_slivers. In a mesh from
Delaunay refinement, every tenth cell may be a sliver. For such a mesh, `odt_optimize_mesh_3()` is the better choice, since it
enlarges the angles of all other cells, too.

The guarantees are those of `odt_optimize_mesh_3()`, also if the domain, a property map, or the callback throws.

\tparam C3T3 a model of the concept `MeshComplex_3InTriangulation_3`, not periodic
\tparam MeshDomain a model of the concept `MeshDomain_3`
\tparam NamedParameters a sequence of named parameters, in the notations that `odt_optimize_mesh_3()` accepts

\param c3t3 the mesh, which is modified
\param domain the domain from which `c3t3` was made
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{time_limit}
    \cgalParamDescription{the wall time, in seconds, that the call may take; the removal ends early enough for the mesh to be
                          written. 0 means no limit}
    \cgalParamType{`double`}
    \cgalParamPrecondition{`time_limit >= 0`}
    \cgalParamDefault{0}
  \cgalParamNEnd
  \cgalParamNBegin{sliver_bound}
    \cgalParamDescription{the dihedral angle, in degrees, that all cells should exceed; as for `odt_optimize_mesh_3()`}
    \cgalParamType{`double`}
    \cgalParamPrecondition{`0 <= sliver_bound <= 70.5`}
    \cgalParamDefault{0, that is, no bound}
  \cgalParamNEnd
  \cgalParamNBegin{optimize_boundary}
    \cgalParamDescription{whether vertices of dimension 2 move on the surface; as for `odt_optimize_mesh_3()`}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{facet_distance}
    \cgalParamDescription{how far the centroid of a facet may be from the surface; as for `odt_optimize_mesh_3()`}
    \cgalParamType{`double`}
    \cgalParamPrecondition{`facet_distance >= 0`, and finite}
    \cgalParamDefault{0, that is, as far as in the input}
  \cgalParamNEnd
  \cgalParamNBegin{domain_is_thread_safe}
    \cgalParamDescription{as for `odt_optimize_mesh_3()`}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{random_seed}
    \cgalParamDescription{the seed of all random choices}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{0}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{as for `odt_optimize_mesh_3()`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `C3T3::Vertex_handle` as key type and `bool` as value type}
    \cgalParamDefault{a constant property map that is `false` for all vertices}
  \cgalParamNEnd
  \cgalParamNBegin{facet_is_constrained_map}
    \cgalParamDescription{as for `odt_optimize_mesh_3()`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `C3T3::Facet` as key type and `bool` as value type}
    \cgalParamDefault{a constant property map that is `false` for all facets}
  \cgalParamNEnd
  \cgalParamNBegin{cell_is_selected_map}
    \cgalParamDescription{as for `odt_optimize_mesh_3()`}
    \cgalParamType{a class model of `ReadablePropertyMap` with `C3T3::Cell_handle` as key type and `bool` as value type}
    \cgalParamDefault{a constant property map that is `true` for all cells}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{a functor called before each step of the removal (20, 30, 35, ... degrees) with the fraction done. When it
                          returns `false`, the process stops before that step, with the mesh found so far.}
    \cgalParamType{a model of `bool(double)`}
    \cgalParamDefault{none}
    \cgalParamExtra{It is spelled `parameters::callback(f)`; `callback = f` does not compile.}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{as for `odt_optimize_mesh_3()`, without iterations}
    \cgalParamType{a model of `MeshOptimizationVisitor_3`}
    \cgalParamDefault{a visitor that does nothing}
  \cgalParamNEnd
  \cgalParamNBegin{optimization_report}
    \cgalParamDescription{as for `odt_optimize_mesh_3()`}
    \cgalParamType{`std::reference_wrapper<CGAL::Mesh_optimization_report_3<C3T3> >`}
    \cgalParamDefault{none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return a value of type `CGAL::Mesh_optimization_return_code`, which is
- `CGAL::TIME_LIMIT_REACHED` when `time_limit` has passed, or `callback` returned `false`;
- `CGAL::CANT_IMPROVE_ANYMORE` when cells below a positive `sliver_bound` are left, also when no vertex may move;
- `CGAL::CANT_IMPROVE_ANYMORE`, too, when no valid mesh can be made, in which case `c3t3` is unchanged;
- `CGAL::CONVERGENCE_REACHED` otherwise.

\pre No vertex of dimension 3 carries a weight, that is, `exude_mesh_3()` has not been called before, nor `make_mesh_3()` without
`no_exude()`.

\sa `odt_optimize_mesh_3()`
*/
template <class C3T3, class MeshDomain, class... NamedParameters>
Mesh_optimization_return_code
remove_slivers_mesh_3(C3T3& c3t3, const MeshDomain& domain, const NamedParameters&... np)
{
  namespace odt = Global_odt_mesh_3::internal;
  static_assert(!odt::is_periodic<C3T3>, "only odt_optimize_mesh_3() accepts meshes in periodic triangulations");
  const odt::Named_arguments<odt::Sliver_removal_arguments, NamedParameters...> arguments(np...);
  return odt::optimize(c3t3, domain, odt::Odt_task::REMOVE_SLIVERS, odt::read_parameters(arguments), arguments);
}

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_REMOVE_SLIVERS_MESH_3_H
