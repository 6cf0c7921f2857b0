// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_MESH_OPTIMIZATION_REPORT_3_H
#define CGAL_MESH_OPTIMIZATION_REPORT_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Requirements.h>

#include <array>
#include <cstddef>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgGlobalOdtMesh3Quality

The class `Mesh_optimization_summary_3` is the part of a `Mesh_optimization_report_3` that does not depend on the type of the mesh.
*/
struct Mesh_optimization_summary_3
{
  /// tells whether the mesh has changed, and if not, why.
  enum Reason
  {
    CHANGED,            ///< the mesh has changed
    NOTHING_TO_DO,      ///< no vertex may move, or none needs to
    NO_VALID_MESH,      ///< no valid mesh could be made; see `Mesh_optimization_report_3::obstacles`
    SMALLER_ANGLES,     ///< more cells would have angles below 10, 20, or 30 degrees, or the smallest would be smaller
    LARGER_CELLS,       ///< cells would be larger than the largest of their subdomain, and angles not much better
    OUT_OF_TIME         ///< `time_limit` or `callback` has ended the call before there was anything better
  };
  /// `CHANGED`, or the reason why the mesh has not changed
  Reason reason = NOTHING_TO_DO;
  /// the `sliver_bound` of the call, or 20 degrees if that is 0
  double sliver_bound = 0;
  /// the number of cells of the result with a dihedral angle below `sliver_bound`. Cells that are to stay do not count
  std::size_t number_of_slivers = 0;
  /// the number of vertices that have been inserted and are in the result
  std::size_t number_of_inserted_vertices = 0;
  /// the number of vertices of the input that are not in the result
  std::size_t number_of_removed_vertices = 0;
  /// the largest change of the volume of a subdomain, relative to its volume; negative if it has shrunk
  double largest_volume_change = 0;
  /// the largest distance of the centroid of a facet from the surface, in the unit of the coordinates; 0 for periodic meshes
  double farthest_facet = 0;
  /// the number of iterations
  std::size_t number_of_iterations = 0;
  /// the wall time of each stage; for periodic meshes, that of the whole call
  std::vector<std::pair<std::string, double> > seconds;
};

/*!
\ingroup PkgGlobalOdtMesh3Quality

The class template `Mesh_optimization_report_3` tells what a call has done to a mesh. It is filled by a function to which it is
passed as `parameters::optimization_report = std::ref(report)`, and printed in a few lines by `operator<<`.

\tparam C3T3 the type of the mesh

\sa `odt_optimize_mesh_3()`
*/
template <class C3T3>
struct Mesh_optimization_report_3
  : Mesh_optimization_summary_3
{
  /// is the handle to a vertex of the mesh.
  typedef typename C3T3::Vertex_handle Vertex_handle;

  /// the vertices around which no valid mesh could be made, if `reason` is `NO_VALID_MESH`. Cells and facets between them stand in
  /// the way
  std::vector<Vertex_handle> obstacles;
  /// the vertices of each cell of a deformed mesh that was to stay by `cell_is_selected_map`, and could not, since it is not in
  /// the regular triangulation of the vertices, or is near to where no valid mesh could be made
  std::vector<std::array<Vertex_handle, 4> > released_cells;

  /// returns whether the mesh has changed.
  bool is_changed() const { return this->reason == Mesh_optimization_summary_3::CHANGED; }
};

/*!
\ingroup PkgGlobalOdtMesh3Quality

prints what a call has done.
*/
template <class C3T3>
std::ostream& operator<<(std::ostream& out, const Mesh_optimization_report_3<C3T3>& r)
{
  static const char* const reasons[] = { "changed", "unchanged: nothing to do", "unchanged: no valid mesh could be made",
                                         "unchanged: angles would be smaller", "unchanged: cells would be larger",
                                         "unchanged: out of time" };
  std::ostringstream s;   // leaves the format of `out` alone
  s << "mesh " << reasons[r.reason];
  if(!r.obstacles.empty())
    s << " around " << r.obstacles.size() << " vertices";
  s << '\n' << r.number_of_slivers << " cells below " << r.sliver_bound << " degrees; " << r.number_of_inserted_vertices
    << " vertices inserted, " << r.number_of_removed_vertices << " removed\n";
  if(!r.released_cells.empty())
    s << r.released_cells.size() << " cells could not stay\n";
  s << "largest change of a volume " << std::showpos << std::setprecision(3) << 100 * r.largest_volume_change << std::noshowpos
    << " %, farthest facet " << r.farthest_facet << '\n' << r.number_of_iterations << " iterations; seconds:" << std::fixed << std::setprecision(2);
  for(const auto& stage : r.seconds)
    s << ' ' << stage.first << ' ' << stage.second << (&stage == &r.seconds.back() ? "" : ",");
  return out << s.str() << '\n';
}

} // namespace CGAL

#endif // CGAL_MESH_OPTIMIZATION_REPORT_3_H
