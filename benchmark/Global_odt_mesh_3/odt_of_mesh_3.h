// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_ODT_OF_MESH_3_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_ODT_OF_MESH_3_H

#ifdef CGAL_LINKED_WITH_TBB
// Mesh_global_optimizer.h of CGAL 6.0 needs it and does not include it.
#  include <tbb/enumerable_thread_specific.h>
#endif

#include <CGAL/Mesh_3/Mesh_global_optimizer.h>
#include <CGAL/Mesh_3/Mesh_sizing_field.h>
#include <CGAL/Mesh_3/Odt_move.h>
#include <CGAL/odt_optimize_mesh_3.h>

// The optimizer behind the function of CGAL that ours takes the place of, with its constants.
template <class C3t3, class Domain>
void odt_of_mesh_3(C3t3& c3t3, const Domain& domain, double freeze_bound, bool do_freeze, double convergence,
                   int max_iteration_number)
{
  typedef CGAL::Mesh_3::Mesh_sizing_field<typename C3t3::Triangulation> Sizing;
  typedef CGAL::Mesh_3::Odt_move<C3t3, Sizing> Move;
  CGAL::Mesh_3::Mesh_global_optimizer<C3t3, Domain, Move> optimizer(c3t3, domain, freeze_bound, do_freeze, convergence);
  optimizer(max_iteration_number);
}

// As that function does by default.
template <class C3t3, class Domain>
void odt_of_mesh_3(C3t3& c3t3, const Domain& domain)
{
  odt_of_mesh_3(c3t3, domain, 0.01, true, 0.02, 1000);
}

// So many iterations, whatever they gain, each of which a visitor is told of.
template <class C3t3, class Domain, class Visitor>
void odt_of_mesh_3(C3t3& c3t3, const Domain& domain, int iterations, const Visitor& visitor)
{
  typedef CGAL::Mesh_3::Mesh_sizing_field<typename C3t3::Triangulation> Sizing;
  typedef CGAL::Mesh_3::Odt_move<C3t3, Sizing> Move;
  CGAL::Mesh_3::Mesh_global_optimizer<C3t3, Domain, Move, Visitor> optimizer(c3t3, domain, 0., false, 0.);
  optimizer(iterations, visitor);
}

// So many iterations, whatever they gain.
template <class C3t3, class Domain>
void odt_of_mesh_3(C3t3& c3t3, const Domain& domain, int iterations)
{
  odt_of_mesh_3(c3t3, domain, 0., false, 0., iterations);
}

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_ODT_OF_MESH_3_H
