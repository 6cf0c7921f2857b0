// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_ANGLE_CHECK_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_ANGLE_CHECK_3_H

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Defect_report_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Keeps slivers from coming where there were none: no cell may get a dihedral angle below a bound that is smaller than the
// smallest angle, up to that bound, that there was around one of its vertices.
class Angle_check_3
{
public:
  // The mesh is that of the snapshot; the bound is in degrees.
  Angle_check_3(const Constrained_triangulation_3& mesh, double bound, const Thread_policy& threads)
    : deficit_(bound)
    , smallest_(mesh.sites.size(), bound)
  {
    const auto find_slivers = [&](int c, std::vector<int>& found)
    {
      if(mesh.topology.is_alive(c) && smallest_angle(mesh.cell_sites(c)) < bound)
        found.push_back(c);
    };
    for(int c : collect_in_chunks(mesh.topology.number_of_cell_slots(), threads, find_slivers))
      for(int v : mesh.topology.cell(c))
        smallest_[v] = (std::min)(smallest_[v], smallest_angle(mesh.cell_sites(c)));
  }

  // Sends back vertices of cells that are worse.
  void check(const Complex_candidate_3& candidate, Defect_report_3& report) const
  {
    const std::vector<Cell_handle>& cells = candidate.working.cells();
    const auto find_worse_cells = [&](int n, std::vector<int>& found)
    {
      if(cells[n]->label() != Domain_view_3::outside && is_worse(candidate.numbers(cells[n]), candidate.sites))
        found.push_back(n);
    };
    for(int n : collect_in_chunks(static_cast<int>(cells.size()), candidate.threads, find_worse_cells))
      report.send_back_around(candidate.numbers(cells[n]));
  }

private:
  // The bound if there is none below.
  double smallest_angle(const std::array<Site, 4>& cell) const
  {
    double most = 0;
    deficit_.for_each_lack(cell, [&most](double lack) { most = (std::max)(most, lack); });
    return deficit_.bound() - most;
  }

  bool is_worse(const std::array<int, 4>& q, const std::vector<Site>& sites) const
  {
    const double angle = smallest_angle({{ sites[q[0]], sites[q[1]], sites[q[2]], sites[q[3]] }});
    return angle < deficit_.bound() && std::any_of(q.begin(), q.end(), [&](int v) { return angle < smallest_[v]; });
  }

  Angle_deficit_3 deficit_;
  std::vector<double> smallest_;      // around vertices
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_ANGLE_CHECK_3_H
