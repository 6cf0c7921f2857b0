// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Slivers removed from a mesh that stays as it is elsewhere: up to an angle that is asked for, or as far as can be had.

#include "torus_mesh.h"

#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/remove_slivers_mesh_3.h>

#include <cstdlib>
#include <iostream>

int main()
{
  const Domain domain = torus_domain();
  const C3t3 input = torus_mesh(domain);
  std::cout << "--- input ---\n" << CGAL::mesh_quality_report_3(input);

  C3t3 some_removed(input);
  if(CGAL::remove_slivers_mesh_3(some_removed, domain, params::sliver_bound = 20) == CGAL::CANT_IMPROVE_ANYMORE)
    std::cout << "cells below 20 degrees are left\n";
  std::cout << "--- up to 20 degrees ---\n" << CGAL::mesh_quality_report_3(some_removed);

  C3t3 all_removed(input);
  CGAL::remove_slivers_mesh_3(all_removed, domain);
  std::cout << "--- as far as can be had ---\n" << CGAL::mesh_quality_report_3(all_removed);
  return EXIT_SUCCESS;
}
