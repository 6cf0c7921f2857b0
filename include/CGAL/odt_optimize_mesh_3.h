// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_ODT_OPTIMIZE_MESH_3_H
#define CGAL_ODT_OPTIMIZE_MESH_3_H

/*!
\ingroup PkgGlobalOdtMesh3Functions

The version of this package: 10000 times the major, plus 100 times the minor, plus the patch version. The header of the
same name of the package 3D Mesh Generation does not define it.
*/
#define CGAL_GLOBAL_ODT_MESH_3 100

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Requirements.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Global_odt_mesh_3/internal/Odt_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Named_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Optimize_mesh_3.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Read_parameters.h>
#include <CGAL/Mesh_optimization_return_code.h>

#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgGlobalOdtMesh3Functions

improves the cells of a tetrahedral mesh by global optimization and removal of slivers. Vertices move far below a nearby
local minimum of the optimal Delaunay triangulation energy
\f$ E^\rho_{ODT} = \sum_\tau \int_\tau \rho\,(f_I - \mathbf{x}^2) \f$,
the \f$ L^1 \f$ error of interpolating \f$ \mathbf{x}^2 \f$ linearly in each cell,
by a global search and the L-BFGS method, as proposed by Chen et al. \cgalCite{cgal:cwlls-rodt-14}. Then the slivers
that are left are removed. The function takes the place of the one of the same
name in the package 3D Mesh Generation. Section \ref godt_kept tells what is preserved: features, corners, topology, subdomains, sizes, and,
unless vertices may be inserted or removed, their number and all handles to them; section \ref godt_fixed, how more is kept; section \ref godt_threads, what runs on several threads. If the
domain, a field, a property map, the callback, or, until the mesh is final, the visitor throws, `c3t3` is as it was before the call. Meshes in periodic
triangulations of one sheet are optimized, too (section \ref godt_periodic); of the parameters, they have `time_limit`, `max_iteration_number`, `convergence`,
`freeze_bound`, `do_freeze`, `optimize_boundary`, `surface_weight`, `annealing_schedule`, `number_of_rounds`, `sliver_bound`, `do_remove_slivers`,
`random_seed`, and `callback`. An argument that is no named parameter, one that is not listed
below, and one that is given twice are refused at compile time; bad values violate preconditions, which are checked in each build.

\tparam C3T3 a model of the concept `MeshComplex_3InTriangulation_3` whose points have coordinates of type `double`, such as those of
`Exact_predicates_inexact_constructions_kernel`
\tparam MeshDomain a model of the concept `MeshDomain_3`
\tparam NamedParameters a sequence of named parameters, in each of the notations that the
version of %CGAL in use accepts: `parameters::time_limit = 10, parameters::do_freeze = false` in all,
`parameters::time_limit(10).do_freeze(false)` from 5.6 on. In 5.5, the first five may also be given as numbers, by position.

\param c3t3 the mesh, which is modified
\param domain the domain from which `c3t3` was made
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{time_limit}
    \cgalParamDescription{the wall time, in seconds, that the call may take; 0 means no limit. The schedule is shortened in advance, so that the noise of the
                          search fades away while there is time to make a valid mesh, to remove slivers, and to write. What cannot be interrupted may take
                          longer by 30 %, or by 0.3 seconds for each 10,000 vertices if that is more.}
    \cgalParamType{`double`}
    \cgalParamPrecondition{`time_limit >= 0`}
    \cgalParamDefault{0}
    \cgalParamExtra{From \cgal 5.6 on also called `maximum_running_time`.}
  \cgalParamNEnd
  \cgalParamNBegin{max_iteration_number}
    \cgalParamDescription{the number of iterations of all stages together, that is, of accepted evaluations of either
                          energy, at most; 0 means 1000 in addition to those of the rounds. If it is small, the search is
                          shortened in advance, and less or nothing is spent on the CVT of the surface. Removing slivers and
                          inserting vertices does not count. Where no valid mesh results, the optimization begins anew, with as
                          many iterations and less freedom for the boundary.}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{0}
    \cgalParamExtra{From \cgal 5.6 on also called `number_of_iterations`.}
  \cgalParamNEnd
  \cgalParamNBegin{convergence}
    \cgalParamDescription{the process stops when the mean of the largest 0.2 % of the displacements falls below this
                          ratio. The displacement of a vertex is the length of its move to the volume-weighted mean of
                          the circumcenters around it, relative to its shortest incident edge.}
    \cgalParamType{`double`}
    \cgalParamPrecondition{`0 <= convergence <= 1`}
    \cgalParamDefault{0.02}
  \cgalParamNEnd
  \cgalParamNBegin{freeze_bound}
    \cgalParamDescription{a vertex whose displacement is below this ratio for six iterations in a row is frozen, if
                          `do_freeze` is `true`.}
    \cgalParamType{`double`}
    \cgalParamPrecondition{`0 <= freeze_bound <= 1`}
    \cgalParamDefault{0.01}
  \cgalParamNEnd
  \cgalParamNBegin{do_freeze}
    \cgalParamDescription{whether vertices that are frozen stay.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{optimize_boundary}
    \cgalParamDescription{whether vertices of dimension 2 move on the surface.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{surface_weight}
    \cgalParamDescription{the importance of the triangles on surfaces relative to that of the cells: the weight of the
                          energy of the surfaces' centroidal Voronoi tessellation. With a weight of 1, both energies are
                          equally stiff, by the sums of their second derivatives, so that a mesh with few vertices in
                          the interior spends no more on its triangles than the cells can bear. More gives better
                          triangles and worse cells, 0 leaves the triangles to the cells.}
    \cgalParamType{`double`}
    \cgalParamPrecondition{`surface_weight >= 0`, and finite}
    \cgalParamDefault{1.2}
  \cgalParamNEnd
  \cgalParamNBegin{sizing_field}
    \cgalParamDescription{the size \f$ \mu \f$ of the cells, which goes into the densities \f$ 1/\mu^5 \f$ of the volume
                          and \f$ 1/\mu^4 \f$ of surfaces. It is evaluated at vertices, with their dimension and index,
                          also outside of the domain, no farther from it than the edges around are long, and never by two
                          threads at once. A `quadrature` also evaluates it inside of cells, with dimension and index of the vertex of
                          the highest dimension; insertion and removal also evaluate it for dimension 3 and the index of each
                          subdomain, inside of its cells and at vertices on its boundary.}
    \cgalParamType{a model of `MeshDomainField_3`, such as the `cell_size` of the criteria with which the mesh was made,
                   `CGAL::Local_feature_size_field_3` or `CGAL::Spline_grid_field_3`, or a number}
    \cgalParamPrecondition{all sizes are positive and finite; not together with `density`}
    \cgalParamDefault{the sizes of the input's cells}
    \cgalParamExtra{It is copied; pass `std::cref(field)` to avoid that.}
    \cgalParamExtra{By default, only ratios of sizes matter. With `do_insert_vertices`, sizes bound circumradii, as those of
                    `Mesh_criteria_3` do: cells that are larger are split, where no feature edge or junction is in the way.
                    With `do_remove_vertices`, vertices go where the mesh is finer. With `number_of_vertices`, only ratios matter.}
  \cgalParamNEnd
  \cgalParamNBegin{density}
    \cgalParamDescription{the density \f$ \rho \f$ of the volume; that of surfaces is \f$ \rho^{4/5} \f$. It is
                          evaluated and copied like `sizing_field`.}
    \cgalParamType{a model of `MeshDensity_3`, such as a lambda, `CGAL::Spline_grid_field_3`, or
                   `CGAL::Quadratic_density_3`}
    \cgalParamPrecondition{all densities are positive and finite, though a `CGAL::Quadratic_density_3` may be zero at
                           points; not together with `sizing_field`}
    \cgalParamDefault{that of the input's cells}
  \cgalParamNEnd
  \cgalParamNBegin{quadrature}
    \cgalParamDescription{how the density is integrated over cells in energy and gradient (equations (2.5) and (3.1) of
                          \cgalCite{cgal:cwlls-rodt-14}). Where a density varies much within a cell, more points lead to
                          a lower energy. It is not evaluated again in cells whose vertices have not moved.}
    \cgalParamType{`CGAL::Linear_density_rule_3`, `CGAL::Four_point_rule_3`, `CGAL::Fifteen_point_rule_3` or
                   `CGAL::Adaptive_cubature_3`}
    \cgalParamPrecondition{that of its members}
    \cgalParamDefault{`CGAL::Linear_density_rule_3()`; exact integrals if `density` is a `CGAL::Quadratic_density_3`}
  \cgalParamNEnd
  \cgalParamNBegin{annealing_schedule}
    \cgalParamDescription{the method of the global search, with its constants.}
    \cgalParamType{`CGAL::Momentum_annealing_schedule` or `CGAL::Metropolis_annealing_schedule` (Algorithm 2 of
                   \cgalCite{cgal:cwlls-rodt-14})}
    \cgalParamPrecondition{that of their members}
    \cgalParamDefault{`CGAL::Momentum_annealing_schedule()`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_rounds}
    \cgalParamDescription{the length of the global search. A round of momentum annealing has 50 iterations; one of
                          Algorithm 2 has as many as its schedule says. 0 means no search: the mesh goes to a local
                          minimum nearby.}
    \cgalParamType{`std::size_t`}
    \cgalParamDefault{4 for momentum annealing, 20 for Algorithm 2}
  \cgalParamNEnd
  \cgalParamNBegin{sliver_bound}
    \cgalParamDescription{the dihedral angle, in degrees, that all cells should exceed in the end; the removal of
                          slivers stops at the first step that is not below it. 0 means as high as possible, as long as
                          slivers are exceptions: above 30 degrees, no step is taken that requires more than one cell in
                          twenty-five to be improved.}
    \cgalParamType{`double`}
    \cgalParamPrecondition{`0 <= sliver_bound <= 70.5`, the regular tetrahedron having angles of 70.53 degrees}
    \cgalParamDefault{0}
  \cgalParamNEnd
  \cgalParamNBegin{do_remove_slivers}
    \cgalParamDescription{whether slivers are removed; otherwise the mesh is left where its energy has converged.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{do_insert_vertices}
    \cgalParamDescription{whether vertices may be inserted, inside and on surfaces, but neither on features nor where surfaces
                          meet: first into edges that are long compared with `sizing_field` or, without, with the edges
                          around, or with feature edges nearby, before vertices move; then into cells whose circumradius
                          exceeds `sizing_field` or, without sizes and densities, the largest of their subdomain in the input, and
                          into facets that exceed the largest of the input, unless that would create more angles below 30 degrees;
                          and, if `do_remove_slivers` is `true`, in and beside cells with
                          angles below `sliver_bound`, or 30 degrees if that is 0, where no move helps. They get the
                          dimension and index of where they are; what else a vertex of `c3t3` has is constructed by
                          default. Handles to the other vertices stay valid. So that sizes in wrong units do not fill the memory, a
                          call without `number_of_vertices` inserts only as long as there are fewer than 100,000, or than ten times
                          those of the input if that is more, and fewer than \f$ 2^{25} \f$. Where that ends it, the edges and cells
                          that are the largest, compared with their sizes, have been divided, and the function returns
                          `CGAL::CANT_IMPROVE_ANYMORE`; another call goes on.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{do_remove_vertices}
    \cgalParamDescription{whether vertices inside and on surfaces may be removed: before vertices move, at edges that are short
                          compared with `sizing_field` or, without, with the edges around; and, if `do_remove_slivers`
                          is `true`, in the end, where that raises the angles of cells below `sliver_bound`, or 30 degrees
                          if that is 0. Handles to these vertices become invalid. A visitor with a member
                          `before_vertex_removal(Vertex_handle)` is told of each of them, before `c3t3` changes.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_vertices}
    \cgalParamDescription{how many vertices the mesh gets, those on features included, as Algorithm 1 of
                          \cgalCite{cgal:cwlls-rodt-14} is given a number: the edges that are the shortest or longest, compared
                          with `sizing_field` or `density` or, without, with the edges around, lose or get
                          vertices until the number is reached, which no insertion passes. Where there are to be *k* times fewer vertices, facets may be
                          *k* times as far from surfaces as those of the input, and the volume of a subdomain may change by 0.1 (*k* - 1) of
                          it, and 0.3 at most. The number is met within 1 %, or two vertices, unless features, junctions, topology, or
                          volumes do not permit that; then the function returns `CGAL::CANT_IMPROVE_ANYMORE`.}
    \cgalParamType{`std::size_t`}
    \cgalParamPrecondition{positive, and at most \f$ 2^{25} \f$; `do_insert_vertices` and `do_remove_vertices` are `true`}
    \cgalParamDefault{any number}
  \cgalParamNEnd
  \cgalParamNBegin{domain_is_thread_safe}
    \cgalParamDescription{whether several threads may query the domain at the same time, as the parallel mesh generation
                          of \cgal does. It has no effect on the result, nor where only one thread is used.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
  \cgalParamNEnd
  \cgalParamNBegin{random_seed}
    \cgalParamDescription{the seed of all random choices.}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{0}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{a property map that is `true` for vertices that are to stay: they neither move nor are removed, and keep their dimension
                          and index. It is read once, before anything else. Vertices that would stay anyway, such as those on features, may
                          have any value. If no vertex may move, and none is to be inserted, the mesh comes back as it was.}
    \cgalParamType{a class model of `ReadablePropertyMap` with `C3T3::Vertex_handle` as key type and `bool` as value type}
    \cgalParamDefault{a constant property map that is `false` for all vertices}
    \cgalParamExtra{It is spelled `parameters::vertex_is_constrained_map(m)` and copied.}
  \cgalParamNEnd
  \cgalParamNBegin{cell_is_selected_map}
    \cgalParamDescription{a property map that is `true` for the cells of the complex that may change. All others stay, with their facets and
                          vertices: a vertex moves only if all cells of the complex around it are selected, and vertices are inserted in selected
                          cells only. The map is read once, like the one above. The angles that may not become smaller are those of selected cells,
                          while cells below `sliver_bound`, of which the return code tells, may be any.}
    \cgalParamType{a class model of `ReadablePropertyMap` with `C3T3::Cell_handle` as key type and `bool` as value type}
    \cgalParamDefault{a constant property map that is `true` for all cells}
    \cgalParamExtra{It is spelled `parameters::cell_is_selected_map(m)` and copied. Also of cells that stay, handles do not remain valid.}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{a functor called before every iteration, and while slivers are removed and vertices are inserted or
                          removed, with the fraction done, which never falls, and need not reach 1; when it returns `false` the process stops with
                          the mesh found so far. Where it has ended iterations or insertion, a first step of the removal of slivers follows.}
    \cgalParamType{a model of `bool(double)`}
    \cgalParamDefault{none}
    \cgalParamExtra{It is spelled `parameters::callback(f)`.}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{an object that is told of the stages of each iteration, and, if it has a member
                          `after_sliver_removal(std::size_t)`, of the number of cells that are left below
                          `sliver_bound`.}
    \cgalParamType{a model of `MeshOptimizationVisitor_3`}
    \cgalParamDefault{a visitor that does nothing}
    \cgalParamExtra{It is spelled `parameters::visitor(v)` and copied; pass `std::ref(v)` to keep its state.}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return a value of type `CGAL::Mesh_optimization_return_code`, which is
- `CGAL::TIME_LIMIT_REACHED` when `time_limit` has passed, or `callback` returned `false`;
- `CGAL::MAX_ITERATION_NUMBER_REACHED` when `max_iteration_number` iterations have been made;
- `CGAL::CONVERGENCE_REACHED` when the largest displacements are below `convergence`;
- `CGAL::ALL_VERTICES_FROZEN` when `do_freeze` is `true` and all vertices that may move are frozen, also when there are
  none;
- `CGAL::CANT_IMPROVE_ANYMORE` when neither time nor iterations have run out, and cells below a positive `sliver_bound` are left though
  `do_remove_slivers` is `true`, also when no vertex may move, when `number_of_vertices` is not met, when `do_insert_vertices` permits no more vertices,
  when no step along the search direction, nor along the gradient, lowers the energy, or when
  no valid mesh can be made, or only one with more cells below 10, 20, or 30 degrees, or with a smaller angle below 30, in which cases `c3t3` is
  as before. Angles may become smaller if `do_remove_slivers` is `false`, or with `sizing_field`, `density`, or `number_of_vertices`.

\pre No vertex but those on features carries a weight, that is, `exude_mesh_3()` has not been called before.
\pre The triangulation has at most \f$ 2^{28} \f$ cells.

\sa `remesh_boundary_mesh_3()`
\sa `remove_slivers_mesh_3()`
\sa `mesh_quality_report_3()`
\sa `odt_energy_3()`
\sa `make_mesh_3()`
*/
template <class C3T3, class MeshDomain, class... NamedParameters>
Mesh_optimization_return_code
odt_optimize_mesh_3(C3T3& c3t3, const MeshDomain& domain, const NamedParameters&... np)
{
  namespace odt = Global_odt_mesh_3::internal;
  const auto arguments = odt::named_arguments<odt::Optimization_parameters<C3T3> >(np...);
  return odt::optimize(c3t3, domain, odt::Odt_task::OPTIMIZE, odt::read_parameters(arguments), arguments);
}

#ifndef DOXYGEN_RUNNING

// The entry that Periodic_3_mesh_3 uses.
template <class C3T3, class MeshDomain>
Mesh_optimization_return_code
odt_optimize_mesh_3_impl(C3T3& c3t3, const MeshDomain& domain, const double time_limit,
                         std::size_t max_iteration_number, const double convergence,
                         const double freeze_ratio, const bool do_freeze)
{
  namespace odt = Global_odt_mesh_3::internal;
  odt::Odt_parameters parameters;
  parameters.time_limit = time_limit;
  parameters.max_iteration_number = max_iteration_number;
  parameters.convergence = convergence;
  parameters.freeze_bound = freeze_ratio;
  parameters.do_freeze = do_freeze;
  return odt::optimize(c3t3, domain, odt::Odt_task::OPTIMIZE, parameters, odt::named_arguments<odt::Parameter_list<> >());
}

#endif // DOXYGEN_RUNNING

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_ODT_OPTIMIZE_MESH_3_H
