// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_EXAMPLES_OPTIMIZE_AND_REPORT_H
#define GLOBAL_ODT_MESH_3_EXAMPLES_OPTIMIZE_AND_REPORT_H

#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Timer.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <fstream>
#include <iomanip>
#include <iostream>
#include <string>

inline const char* to_string(CGAL::Mesh_optimization_return_code code)
{
  switch(code)
  {
  case CGAL::TIME_LIMIT_REACHED: return "time limit reached";
  case CGAL::CANT_IMPROVE_ANYMORE: return "cannot improve any more";
  case CGAL::CONVERGENCE_REACHED: return "convergence reached";
  case CGAL::MAX_ITERATION_NUMBER_REACHED: return "maximal number of iterations reached";
  case CGAL::ALL_VERTICES_FROZEN: return "all vertices frozen";
  default: return "?";
  }
}

// Optimizes a mesh with progress shown, prints its quality before and after, and
// writes both in the format of Medit.
template <class C3t3, class Domain, class... NamedParameters>
void optimize_and_report(C3t3& c3t3, const Domain& domain, const std::string& prefix,
                         const NamedParameters&... parameters)
{
  std::cout << "--- before ---\n" << CGAL::mesh_quality_report_3(c3t3) << std::endl;
  std::ofstream before(prefix + "_before.mesh");
  c3t3.output_to_medit(before);

  CGAL::Timer cpu;
  CGAL::Real_timer wall;
  cpu.start();
  wall.start();
  const auto progress = [](double fraction)
  {
    std::cout << "\roptimizing " << std::setw(3) << static_cast<int>(100 * fraction) << " %" << std::flush;
    return true;
  };
  const auto code = CGAL::odt_optimize_mesh_3(c3t3, domain, parameters..., CGAL::parameters::callback(progress));
  cpu.stop();
  wall.stop();
  std::cout << "\roptimized: " << to_string(code) << ", " << cpu.time() << " s CPU, " << wall.time() << " s\n"
            << "--- after ---\n" << CGAL::mesh_quality_report_3(c3t3) << std::endl;
  std::ofstream after(prefix + "_after.mesh");
  c3t3.output_to_medit(after);
  std::cout << "meshes: " << prefix << "_before.mesh, " << prefix << "_after.mesh\n";
}

#endif // GLOBAL_ODT_MESH_3_EXAMPLES_OPTIMIZE_AND_REPORT_H
