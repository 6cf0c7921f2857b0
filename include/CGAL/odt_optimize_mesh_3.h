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
\ingroup PkgGlobalOdtMesh3Macros

The version of this package: 10000 times the major, plus 100 times the minor, plus the patch version. The header of the
same name of the package 3D Mesh Generation does not define it.
*/
#define CGAL_GLOBAL_ODT_MESH_3 100

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Requirements.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Global_odt_mesh_3/internal/door/Named_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Optimize_mesh_3.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Read_parameters.h>
#include <CGAL/Mesh_optimization_return_code.h>

#include <cstddef>

namespace CGAL {

/*!
\ingroup PkgGlobalOdtMesh3Functions

improves the cells of a tetrahedral mesh by global optimization and removal of slivers. The vertices move to a low value of the
optimal Delaunay triangulation energy \f$ E^\rho_{ODT} = \sum_\tau \int_\tau \rho\,(f_I - \mathbf{x}^2) \f$. This is
the \f$ L^1 \f$ error of interpolating \f$ \mathbf{x}^2 \f$ linearly in each cell. A global search and the L-BFGS method
minimize it, as proposed by Chen et al. \cgalCite{cgal:cwlls-rodt-14}. Then the slivers that are left are removed.

The function takes the place of the one of the same name in the package 3D Mesh Generation.

- The page \ref godt_kept lists what is kept: features, corners, topology, subdomains, sizes, and, unless vertices may be inserted
or removed, their number and all handles to them. Section \ref godt_fixed tells how to keep more.
- If the domain, a field, a property map, or the callback throws, `c3t3` is unchanged. The same holds for the visitor, until the
mesh is final.
- Arguments that are no named parameters, that are not listed below, or that occur twice are refused at compile time. Bad values
violate preconditions, which are checked in each build (section \ref godt_errors).
- The page \ref godt_threads tells what runs on several threads.
- Meshes in periodic triangulations of one sheet are optimized, too (page \ref godt_periodic). For them, the parameters are
`time_limit`, `max_iteration_number`, `convergence`, `freeze_bound`, `do_freeze`, `optimize_boundary`, `surface_weight`,
`annealing_schedule`, `number_of_rounds`, `sliver_bound`, `do_remove_slivers`, `random_seed`, `callback`, and `optimization_report`.

\tparam C3T3 a model of the concept `MeshComplex_3InTriangulation_3` whose points have coordinates of type `double`, such as those
of `Exact_predicates_inexact_constructions_kernel`
\tparam MeshDomain a model of the concept `MeshDomain_3`
\tparam NamedParameters a sequence of named parameters, in each of the notations that the
version of %CGAL in use accepts: `parameters::time_limit = 10, parameters::do_freeze = false` in all,
`parameters::time_limit(10).do_freeze(false)` from 5.6 on. In 5.5, the first five may also be numbers, by position.

\param c3t3 the mesh, which is modified
\param domain the domain from which `c3t3` was made
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{time_limit}
    \cgalParamDescription{the wall time, in seconds, that the call may take; 0 means no limit. The schedule is shortened in advance,
                          so that the noise of the search fades away while there is time to make a valid mesh, to remove slivers,
                          and to write. As some steps cannot be interrupted, a call may exceed the limit by 30 %, or by 0.3 seconds
                          for each 10,000 vertices if that is more.}
    \cgalParamType{`double`}
    \cgalParamPrecondition{`time_limit >= 0`}
    \cgalParamDefault{0}
    \cgalParamExtra{From \cgal 5.6 on also called `maximum_running_time`.}
  \cgalParamNEnd
  \cgalParamNBegin{max_iteration_number}
    \cgalParamDescription{the largest number of iterations of all stages together. An iteration is a step of the search, or of the
                          L-BFGS method on cells or surfaces. 0 means 1000 in addition to those of the rounds. If the number is
                          small, the search is shortened in advance, and the surface is remeshed less, or not at all.}
    \cgalParamType{`std::size_t`}
    \cgalParamPrecondition{a number, not negative}
    \cgalParamDefault{0}
    \cgalParamExtra{The removal of slivers and the insertion of vertices do not count. Where no valid mesh results, the optimization
                    starts again, with as many iterations and less freedom for the boundary.}
    \cgalParamExtra{From \cgal 5.6 on also called `number_of_iterations`.}
  \cgalParamNEnd
  \cgalParamNBegin{convergence}
    \cgalParamDescription{a ratio of lengths: the process stops when the mean of the largest 0.2 % of the displacements falls below
                          it. The displacement of a vertex is the length of its move to the volume-weighted mean of the
                          circumcenters around it, relative to its shortest incident edge.}
    \cgalParamType{`double`}
    \cgalParamPrecondition{`0 <= convergence <= 1`}
    \cgalParamDefault{0.02}
  \cgalParamNEnd
  \cgalParamNBegin{freeze_bound}
    \cgalParamDescription{a ratio of lengths: a vertex whose displacement is below it for six iterations in a row is frozen.}
    \cgalParamType{`double`}
    \cgalParamPrecondition{`0 <= freeze_bound <= 1`}
    \cgalParamDefault{0.01}
    \cgalParamExtra{It is ignored if `do_freeze` is `false`.}
  \cgalParamNEnd
  \cgalParamNBegin{do_freeze}
    \cgalParamDescription{whether frozen vertices no longer move. The process stops when all vertices are frozen.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{optimize_boundary}
    \cgalParamDescription{whether vertices of dimension 2 move on the surface. Otherwise they stay, and so do all facets of the
                          complex. Vertices on surfaces then get small weights where facets are not in the Delaunay triangulation
                          of the vertices and, if `domain` is a `Tetrahedral_mesh_domain_3`, where weights remove slivers.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{surface_weight}
    \cgalParamDescription{the weight of the energy of the surfaces' centroidal Voronoi tessellation, relative to the energy of the
                          cells. With a weight of 1, the sums of the second derivatives of both energies are equal. A larger weight
                          leads to better triangles and worse cells, and 0 leaves the triangles to the cells.}
    \cgalParamType{`double`}
    \cgalParamPrecondition{`surface_weight >= 0`, and finite}
    \cgalParamDefault{1.2}
    \cgalParamExtra{It is ignored if `optimize_boundary` is `false`.}
  \cgalParamNEnd
  \cgalParamNBegin{facet_distance}
    \cgalParamDescription{how far the centroid of a facet of the complex may be from the surface, in the unit of the coordinates. If
                          facets of the input are farther, the farthest of them is the bound.}
    \cgalParamType{`double`}
    \cgalParamPrecondition{`facet_distance >= 0`, and finite}
    \cgalParamDefault{0, that is, as far as the farthest of the input. In a mesh that is its own domain, the distance is the error
                      up to which that surface is known: at each vertex, the largest of \f$ \sqrt{3}/6 \f$ times the length of an
                      edge off the features times the angle between the normals of its two facets, which is 0 on planes, or two
                      millionths of the diagonal of the bounding box for rounded coordinates.}
    \cgalParamExtra{It is ignored if `optimize_boundary` is `false`. It is also ignored if the domain has no member function
                    `aabb_tree()`, such as that of `Polyhedral_mesh_domain_3` and `Tetrahedral_mesh_domain_3`, for distances.}
    \cgalParamExtra{The criterion of that name of `Mesh_criteria_3` measures circumcenters.}
  \cgalParamNEnd
  \cgalParamNBegin{sizing_field}
    \cgalParamDescription{the size \f$ \mu \f$ of the cells, in the unit of the coordinates. It goes into the densities \f$ 1/\mu^5
                          \f$ of the volume and \f$ 1/\mu^4 \f$ of surfaces.}
    \cgalParamType{a model of `MeshDomainField_3`, such as the `cell_size` of the criteria with which the mesh was made,
                   `CGAL::Local_feature_size_field_3` or `CGAL::Spline_grid_field_3`, or a number}
    \cgalParamPrecondition{all sizes are positive and finite; not together with `density`}
    \cgalParamDefault{the sizes of the input's cells}
    \cgalParamExtra{Without insertion and removal, and with `number_of_vertices`, only ratios of sizes matter. Near features, whose
                    vertices stay, the sizes of the mesh replace those of the field.}
    \cgalParamExtra{With `do_insert_vertices`, sizes bound circumradii, as those of `Mesh_criteria_3` do: larger cells are split,
                    unless a feature edge, or an edge where surfaces meet, is in the way. In a mesh that is its own domain, feature
                    edges longer than 4/3 of the size are halved. With `do_remove_vertices`, vertices are removed where the mesh is
                    finer.}
    \cgalParamExtra{The field is evaluated at vertices, with their dimension and index, also outside of the domain, no farther from
                    it than the surrounding edges are long. A `quadrature` also evaluates it inside of cells, with dimension and
                    index of the vertex of the highest dimension. Insertion and removal also evaluate it for dimension 3 and the
                    index of each subdomain, inside of its cells and at vertices on its boundary. Two threads never evaluate it at
                    once.}
    \cgalParamExtra{It is copied; pass `std::cref(field)` to avoid that.}
  \cgalParamNEnd
  \cgalParamNBegin{density}
    \cgalParamDescription{the density \f$ \rho \f$ of the volume; that of surfaces is \f$ \rho^{4/5} \f$. Only ratios matter.}
    \cgalParamType{a model of `MeshDensity_3`, such as a lambda, `CGAL::Spline_grid_field_3`, or
                   `CGAL::Quadratic_density_3`}
    \cgalParamPrecondition{all densities are positive and finite, though a `CGAL::Quadratic_density_3` may be zero at
                           points; not together with `sizing_field`}
    \cgalParamDefault{that of the input's cells}
    \cgalParamExtra{It is evaluated and copied like `sizing_field`.}
  \cgalParamNEnd
  \cgalParamNBegin{quadrature}
    \cgalParamDescription{how the density is integrated over cells in energy and gradient (equations (2.5) and (3.1) of
                          \cgalCite{cgal:cwlls-rodt-14}). If a density varies much within cells, more points lead to a lower energy.
                          It is not evaluated again in cells whose vertices have not moved.}
    \cgalParamType{`CGAL::Linear_density_rule_3`, `CGAL::Four_point_rule_3`, `CGAL::Fifteen_point_rule_3` or
                   `CGAL::Adaptive_cubature_3`}
    \cgalParamPrecondition{that of its members}
    \cgalParamDefault{`CGAL::Linear_density_rule_3()`; exact integrals if `density` is a `CGAL::Quadratic_density_3`}
    \cgalParamExtra{It is ignored if neither `sizing_field` nor `density` is passed and the input is uniform, that is, if its sizes,
                    apart from the smallest and the largest 5 %, differ by less than a factor of 1.5.}
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
                          Algorithm 2 has as many as its schedule says. 0 means no search: surfaces are remeshed,
                          and the mesh goes to a local minimum nearby.}
    \cgalParamType{`std::size_t`}
    \cgalParamPrecondition{a number, not negative}
    \cgalParamDefault{4 for momentum annealing, 20 for Algorithm 2}
  \cgalParamNEnd
  \cgalParamNBegin{sliver_bound}
    \cgalParamDescription{the dihedral angle, in degrees, that all cells should exceed at the end. Slivers are removed in steps of
                          20, 30, 35, 40, 45, ... degrees, and the removal stops at the first step that is not below the bound. 0
                          means no bound: then a step above 30 degrees is made only if no cell is left below the step before, and
                          fewer than one cell in twenty-five is below this one. With a bound above 30 degrees, its steps are made in
                          any case, and may reach more. In periodic meshes, steps up to 40 degrees follow as long as cells are left
                          below the bound.}
    \cgalParamType{`double`}
    \cgalParamPrecondition{`0 <= sliver_bound <= 70.5`, the regular tetrahedron having angles of 70.53 degrees}
    \cgalParamDefault{0}
    \cgalParamExtra{If `do_remove_slivers` is `false`, no sliver is removed, and the return code does not tell whether the bound is
                    reached.}
  \cgalParamNEnd
  \cgalParamNBegin{do_remove_slivers}
    \cgalParamDescription{whether slivers are removed; otherwise the mesh is left where its energy has converged.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`true`}
  \cgalParamNEnd
  \cgalParamNBegin{do_insert_vertices}
    \cgalParamDescription{whether vertices may be inserted, inside and on surfaces, but neither on features nor where surfaces meet,
                          except in a mesh that is its own domain, where these are in no regular triangulation of the vertices, or
                          where features have edges that are too long for `sizing_field`.
                          Before vertices move, others are inserted into edges that are long compared with `sizing_field`. Without a
                          field, edges are compared with the surrounding edges and with nearby feature edges. At the end, vertices
                          are inserted into cells whose circumradius exceeds `sizing_field` or, without sizes and densities, the
                          largest of their subdomain in the input. Facets that exceed the largest of the input get vertices, too.
                          Neither is done if it would create more angles below 30 degrees. If `do_remove_slivers` is `true`,
                          vertices are also inserted in and beside cells with angles below `sliver_bound`, or 30 degrees if that is
                          0, if no move helps.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
    \cgalParamExtra{New vertices get the dimension and index of the place where they are. Other data of theirs are constructed by
                    default. Handles to the other vertices stay valid.}
    \cgalParamExtra{Sizes in wrong units do not fill the memory: a call without `number_of_vertices` stops inserting at 100,000
                    vertices, or at ten times those of the input if that is more. No call makes more than \f$ 2^{25} \f$ vertices.
                    The edges and cells that exceed their sizes the most are split first. If insertion has stopped for this reason,
                    the function returns `CGAL::CANT_IMPROVE_ANYMORE`, and another call continues.}
  \cgalParamNEnd
  \cgalParamNBegin{do_remove_vertices}
    \cgalParamDescription{whether vertices inside and on surfaces may be removed. Before vertices move, one end is removed of edges
                          that are short compared with `sizing_field` or, without a field, with the surrounding edges. If
                          `do_remove_slivers` is `true`, vertices are also removed at the end, if that raises the angles of cells
                          below `sliver_bound`, or 30 degrees if that is 0.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
    \cgalParamExtra{Handles to these vertices become invalid. A visitor with a member `before_vertex_removal(Vertex_handle)` is told
                    of each of them, before `c3t3` changes.}
  \cgalParamNEnd
  \cgalParamNBegin{number_of_vertices}
    \cgalParamDescription{how many vertices the mesh gets, those on features included (Algorithm 1 of
                          \cgalCite{cgal:cwlls-rodt-14}). Edges are compared with `sizing_field` or `density` or, without these,
                          with the surrounding edges. The shortest lose vertices and the longest get some until the number is
                          reached, and no insertion exceeds it. The number is met within 1 %, or two vertices, unless features,
                          lines where surfaces meet, topology, or volumes do not permit that. Then the function returns
                          `CGAL::CANT_IMPROVE_ANYMORE`.}
    \cgalParamType{`std::size_t`}
    \cgalParamPrecondition{positive, and at most \f$ 2^{25} \f$; `do_insert_vertices` and `do_remove_vertices` are `true`}
    \cgalParamDefault{none}
    \cgalParamExtra{With \f$ k \f$ times fewer vertices, facets may be \f$ k \f$ times as far from surfaces as those of the input.
                    The volume of a subdomain may change by \f$ 0.003 + 0.1\,(k - 1) \f$ of it, and by 0.3 at most.}
  \cgalParamNEnd
  \cgalParamNBegin{domain_is_thread_safe}
    \cgalParamDescription{whether several threads may query the domain at the same time, as the parallel mesh generation
                          of \cgal does. The result does not depend on it.}
    \cgalParamType{`bool`}
    \cgalParamDefault{`false`}
    \cgalParamExtra{It is ignored if only one thread is used.}
  \cgalParamNEnd
  \cgalParamNBegin{random_seed}
    \cgalParamDescription{the seed of all random choices.}
    \cgalParamType{`unsigned int`}
    \cgalParamDefault{0}
    \cgalParamExtra{It is spelled `parameters::random_seed(n)`; `random_seed = n` does not compile.}
  \cgalParamNEnd
  \cgalParamNBegin{vertex_is_constrained_map}
    \cgalParamDescription{a property map that is `true` for vertices that are to stay: they neither move nor are removed, and they
                          keep their dimension and index. It is read once, before anything else. If no vertex may move, and none is
                          to be inserted, the mesh is left unchanged.}
    \cgalParamType{a class model of `ReadablePropertyMap` with `C3T3::Vertex_handle` as key type and `bool` as value type}
    \cgalParamDefault{a constant property map that is `false` for all vertices}
    \cgalParamExtra{It is ignored at vertices that stay anyway, such as those on features.}
    \cgalParamExtra{It is spelled `parameters::vertex_is_constrained_map(m)` and copied; `vertex_is_constrained_map = m` does not
                    compile.}
  \cgalParamNEnd
  \cgalParamNBegin{facet_is_constrained_map}
    \cgalParamDescription{a property map that is `true` for the facets of the complex that are to stay, with their vertices and
                          patches. Like the one above, it is read once, for each facet from both sides; it suffices that it is
                          `true` from one.}
    \cgalParamType{a class model of `ReadablePropertyMap` with `C3T3::Facet` as key type and `bool` as value type}
    \cgalParamDefault{a constant property map that is `false` for all facets}
    \cgalParamExtra{The cells at such facets change. Vertices of facets that are not in the Delaunay triangulation get small
                    weights.}
    \cgalParamExtra{It is spelled `parameters::facet_is_constrained_map(m)` and copied; `facet_is_constrained_map = m` does not
                    compile.}
  \cgalParamNEnd
  \cgalParamNBegin{cell_is_selected_map}
    \cgalParamDescription{a property map that is `true` for the cells of the complex that may change. All others stay, with their
                          facets and vertices. A vertex moves only if all cells of the complex around it are selected, and vertices
                          are inserted in selected cells only. The map is read once, like those above.}
    \cgalParamType{a class model of `ReadablePropertyMap` with `C3T3::Cell_handle` as key type and `bool` as value type}
    \cgalParamDefault{a constant property map that is `true` for all cells}
    \cgalParamExtra{Some cells of a deformed mesh cannot stay, since no valid mesh has them. They are treated as selected, and named
                    in the report.}
    \cgalParamExtra{Only the angles of selected cells are kept from becoming smaller, and only selected cells below `sliver_bound`
                    are counted for the return code and the visitor. Handles do not remain valid, not even those of cells that
                    stay.}
    \cgalParamExtra{It is spelled `parameters::cell_is_selected_map(m)` and copied; `cell_is_selected_map = m` does not compile.}
  \cgalParamNEnd
  \cgalParamNBegin{callback}
    \cgalParamDescription{a functor that is called with the fraction of the work that is done, before every iteration, and while
                          slivers are removed and vertices are inserted or removed. This fraction never falls, and need not reach 1.
                          When the functor returns `false`, the process stops with the mesh found so far, and the functor is not
                          called again. If it does so before the first iteration, the mesh is left unchanged. If it ends iterations
                          or insertion, the mesh is made valid, and a first step of the removal of slivers follows, for a tenth of
                          the time that has passed or, if that is more, for the time of three valid meshes. A functor that throws an
                          exception ends the call at once, and the mesh is unchanged.}
    \cgalParamType{a model of `bool(double)`}
    \cgalParamDefault{none}
    \cgalParamExtra{It is spelled `parameters::callback(f)`; `callback = f` does not compile.}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{an object that is told of the stages of each iteration. If it has a member
                          `after_sliver_removal(std::size_t)`, it is told of the number of cells that are left below
                          `sliver_bound`.}
    \cgalParamType{a model of `MeshOptimizationVisitor_3`}
    \cgalParamDefault{a visitor that does nothing}
    \cgalParamExtra{It is spelled `parameters::visitor(v)` and copied; pass `std::ref(v)` to keep its state. `visitor = v` does not
                    compile.}
  \cgalParamNEnd
  \cgalParamNBegin{optimization_report}
    \cgalParamDescription{an object that gets what the call has done: whether the mesh has changed, and if not, why; the slivers
                          that are left; the vertices inserted and removed; the change of volumes; the farthest facet; iterations;
                          the time of each stage.}
    \cgalParamType{`std::reference_wrapper<CGAL::Mesh_optimization_report_3<C3T3> >`, as `std::ref(report)` gives it}
    \cgalParamDefault{none}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return a value of type `CGAL::Mesh_optimization_return_code`, which is
- `CGAL::TIME_LIMIT_REACHED` when `time_limit` has passed, or `callback` returned `false`;
- `CGAL::MAX_ITERATION_NUMBER_REACHED` when `max_iteration_number` iterations have been made;
- `CGAL::CONVERGENCE_REACHED` when the largest displacements are below `convergence`;
- `CGAL::ALL_VERTICES_FROZEN` when `do_freeze` is `true` and all vertices that may move are frozen, or there are none;
- `CGAL::CANT_IMPROVE_ANYMORE` when time has not run out, the callback has not returned `false`, and one of the following holds:
  + cells below a positive `sliver_bound` are left, `do_remove_slivers` is `true`, and iterations have not run out;
  + `number_of_vertices` is not met, or `do_insert_vertices` permits no more vertices;
  + no step along the search direction, nor along the gradient, lowers the energy;
  + no valid mesh can be made, or only one with more cells below 10, 20, or 30 degrees, with a smaller angle below 30, or with
    larger cells. In these cases, `c3t3` is unchanged; the report tells which it is. Angles may become smaller if
    `do_remove_slivers` is `false`, or with `sizing_field`, `density`, or `number_of_vertices`.

\pre No vertex of dimension 3 carries a weight, that is, `exude_mesh_3()` has not been called before, nor `make_mesh_3()` without
`no_exude()`. Vertices of dimension 2 may carry some, and stay where they are.
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
  const odt::Named_arguments<odt::Optimization_parameters<C3T3>, NamedParameters...> arguments(np...);
  return odt::optimize(c3t3, domain, odt::Odt_task::OPTIMIZE, odt::read_parameters(arguments), arguments);
}

#ifndef DOXYGEN_RUNNING

// Periodic_3_mesh_3 calls this function.
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
  return odt::optimize(c3t3, domain, odt::Odt_task::OPTIMIZE, parameters, odt::Named_arguments<odt::Parameter_list<> >());
}

#endif // DOXYGEN_RUNNING

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_ODT_OPTIMIZE_MESH_3_H
