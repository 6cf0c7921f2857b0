// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_EXAMPLES_PRINT_SUMMARY_H
#define GLOBAL_ODT_MESH_3_EXAMPLES_PRINT_SUMMARY_H

#include <CGAL/Mesh_optimization_report_3.h>
#include <CGAL/Mesh_quality_report_3.h>

#include <cstddef>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

// Prints a few figures of a mesh before and after a call, one a line.
inline void print_summary(const CGAL::Mesh_quality_report_3& before, const CGAL::Mesh_quality_report_3& after,
                          const CGAL::Mesh_optimization_summary_3& call, double seconds)
{
  std::ostringstream s;
  const auto row = [&s](const std::string& name, double x, double y, int digits)
  {
    s << std::left << std::setw(28) << name << std::right << std::setprecision(digits) << std::setw(12) << x << "  -> "
      << std::setw(12) << y << '\n';
  };
  s << std::fixed;
  row("smallest angle (degrees)", before.smallest_angle, after.smallest_angle, 2);
  for(std::size_t n = 0; n < before.cells_below.size(); ++n)
    row("cells below " + std::to_string(static_cast<int>(before.cells_below[n].first)) + " degrees",
        double(before.cells_below[n].second), double(after.cells_below[n].second), 0);
  const auto between_facets = [](const CGAL::Mesh_quality_report_3& r) { return double(r.cells_below_at_boundary.back().second); };
  if(between_facets(after) > 0)
    row("  of these, between facets", between_facets(before), between_facets(after), 0);
  row("mean radius ratio 3r/R", before.mean_radius_ratio, after.mean_radius_ratio, 4);
  row("vertices", double(before.number_of_vertices), double(after.number_of_vertices), 0);
  row("cells", double(before.number_of_cells), double(after.number_of_cells), 0);
  s << std::defaultfloat;
  row("volume", before.total().volume, after.total().volume, 8);
  s << std::fixed << std::setprecision(2) << call.number_of_inserted_vertices << " vertices inserted, "
    << call.number_of_removed_vertices << " removed; " << seconds << " seconds\n";
  std::cout << s.str();
}

#endif // GLOBAL_ODT_MESH_3_EXAMPLES_PRINT_SUMMARY_H
