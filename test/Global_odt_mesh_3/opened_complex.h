// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_TEST_OPENED_COMPLEX_H
#define GLOBAL_ODT_MESH_3_TEST_OPENED_COMPLEX_H

#include <CGAL/Global_odt_mesh_3/internal/complex/Candidate_checks_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_updater_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Snapshot_reader_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Snapshot_tabulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/door/C3t3_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Mesh_domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

namespace CGAL::Global_odt_mesh_3::internal {

// A complex that has been read from a c3t3, a copy of which it is, and the indexed mesh of it.
template <class C3t3, class Domain>
struct Opened_complex
{
  C3t3 c3t3;
  Mesh_domain_view_3<Domain> domain;
  C3t3_view_3<C3t3, Domain> input;
  Facet_bounds_3 bounds;
  Complex_updater_3 complex;
  Moving_triangulation_3 mesh;

  Opened_complex(const C3t3& from, const Domain& of, bool boundary_moves)
    : c3t3(from)
    , domain(of)
    , input(c3t3, domain)
    , bounds(domain)
    , complex(domain, bounds, boundary_moves)
  {
    complex.start(Snapshot_reader_3(input).read(mesh, boundary_moves));
  }

  // To be called once.
  const C3t3& write()
  {
    input.write(Snapshot_tabulation_3(complex.snapshot(), Thread_policy())());
    return c3t3;
  }
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // GLOBAL_ODT_MESH_3_TEST_OPENED_COMPLEX_H
