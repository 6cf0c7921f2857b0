// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_REMESH_BOUNDARY_MESH_3_H
#define CGAL_REMESH_BOUNDARY_MESH_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Requirements.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Global_odt_mesh_3/internal/door/Named_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Optimize_mesh_3.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Read_parameters.h>
#include <CGAL/Mesh_optimization_return_code.h>

namespace CGAL {

namespace Global_odt_mesh_3::internal {

// What remesh_boundary_mesh_3() reads.
typedef Parameter_list<tags::time_limit, tags::max_iteration_number, tags::sizing_field, internal_np::density_t,
                       tags::facet_distance, internal_np::domain_is_thread_safe_t, internal_np::vertex_is_constrained_t,
                       internal_np::facet_is_constrained_t, internal_np::cell_selector_t, internal_np::callback_t, internal_np::visitor_t,
                       internal_np::optimization_report_t> Remeshing_parameters;

} // namespace Global_odt_mesh_3::internal

/*!
\ingroup PkgGlobalOdtMesh3Functions

spaces the vertices of a tetrahedral mesh evenly on its surfaces. Vertices of dimension 2 move to a centroidal Voronoi
tessellation restricted to the surface (section 5.1 of \cgalCite{cgal:cwlls-rodt-14}). This is a minimum of
\f$ \sum_i \int_{V_i} \rho\,(\|\mathbf{x} - \mathbf{x}_i\|^2 - w_i) \f$, which the L-BFGS method finds in the tangential planes.
The Voronoi cells \f$ V_i \f$ are taken on the surfaces of the complex, which are reconstructed from
the domain after each round of iterations. The density is \f$ \rho = 1/\mu^4 \f$. Here \f$ \mu \f$ is the `sizing_field` or,
without one, the size of the cells of the input, so that a graded mesh stays graded.
Vertices of the interior follow by a few iterations of `odt_optimize_mesh_3()` in each round.

That function, with `optimize_boundary` set to `false`, completes the procedure of the paper. By default, it
minimizes this energy together with that of the cells (see its parameter `surface_weight`), so that there is no need
to call this function before.

The guarantees are those of `odt_optimize_mesh_3()`, also if the domain, a property map, or the callback throws, except for those on
dihedral angles and on the largest cells: angles may become smaller, as no slivers are removed.

\tparam C3T3 a model of the concept `MeshComplex_3InTriangulation_3`, not periodic
\tparam MeshDomain a model of the concept `MeshDomain_3`
\tparam NamedParameters a sequence of named parameters, in the notations that `odt_optimize_mesh_3()` accepts

\param c3t3 the mesh, which is modified
\param domain the domain from which `c3t3` was made
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{time_limit}
    \cgalParamDescription{the wall time, in seconds, that the call may take; iterations end early enough for the mesh to be written.
                          0 means no limit}
    \cgalParamType{`double`}
    \cgalParamPrecondition{`time_limit >= 0`}
    \cgalParamDefault{0}
  \cgalParamNEnd
  \cgalParamNBegin{max_iteration_number}
    \cgalParamDescription{the largest number of iterations, on surfaces and in the interior; 0 means no limit but that of the
                          rounds, of which there are six at most}
    \cgalParamType{`std::size_t`}
    \cgalParamPrecondition{a number, not negative}
    \cgalParamDefault{0}
  \cgalParamNEnd
  \cgalParamNBegin{sizing_field}
    \cgalParamDescription{as for `odt_optimize_mesh_3()`}
    \cgalParamType{a model of `MeshDomainField_3`, or a number}
    \cgalParamPrecondition{all sizes are positive and finite; not together with `density`}
    \cgalParamDefault{the sizes of the input's cells}
  \cgalParamNEnd
  \cgalParamNBegin{density}
    \cgalParamDescription{as for `odt_optimize_mesh_3()`}
    \cgalParamType{a model of `MeshDensity_3`}
    \cgalParamPrecondition{all densities are positive and finite; not together with `sizing_field`}
    \cgalParamDefault{that of the input's cells}
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
    \cgalParamDescription{a functor called before every iteration with the fraction done; when it returns `false` the
                          process stops with the mesh found so far}
    \cgalParamType{a model of `bool(double)`}
    \cgalParamDefault{none}
    \cgalParamExtra{It is spelled `parameters::callback(f)`; `callback = f` does not compile.}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{as for `odt_optimize_mesh_3()`}
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
- `CGAL::MAX_ITERATION_NUMBER_REACHED` when `max_iteration_number` iterations or all rounds have been made;
- `CGAL::CONVERGENCE_REACHED` when a round lowers the energy by less than 0.02 %, also when no vertex may move;
- `CGAL::CANT_IMPROVE_ANYMORE` when no valid mesh can be made, in which case `c3t3` is unchanged.

\pre No vertex of dimension 3 carries a weight, that is, `exude_mesh_3()` has not been called before, nor `make_mesh_3()` without
`no_exude()`.

\sa `odt_optimize_mesh_3()`
*/
template <class C3T3, class MeshDomain, class... NamedParameters>
Mesh_optimization_return_code
remesh_boundary_mesh_3(C3T3& c3t3, const MeshDomain& domain, const NamedParameters&... np)
{
  namespace odt = Global_odt_mesh_3::internal;
  static_assert(!odt::is_periodic<C3T3>, "only odt_optimize_mesh_3() accepts meshes in periodic triangulations");
  const odt::Named_arguments<odt::Remeshing_parameters, NamedParameters...> arguments(np...);
  return odt::optimize(c3t3, domain, odt::Odt_task::REMESH_BOUNDARY, odt::read_parameters(arguments), arguments);
}

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_REMESH_BOUNDARY_MESH_3_H
