// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_CONVERGENCE_MONITOR_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_CONVERGENCE_MONITOR_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Tells from the displacements of the interior vertices how far the minimization has come, as CGAL's
// optimizers do. The displacement of a vertex is the length of the AVV move (2.3), |g|/D, over its
// shortest edge.
class Convergence_monitor
{
public:
  // Vertices whose displacement stays below `freeze_bound` are frozen if `do_freeze`.
  Convergence_monitor(double freeze_bound, bool do_freeze)
    : freeze_bound_(freeze_bound)
    , do_freeze_(do_freeze)
  {}

  // The mean of the largest displacements, one in five hundred.
  double measure(const Constrained_triangulation_3& mesh, Odt_objective_3& objective)
  {
    const int n = mesh.number_of_interior_vertices;
    if(n == 0)
      return 0;
    mesh.shortest_edges(shortest_edge_);
    displacement_.resize(n);
    still_.resize(n, 0);
    const Eigen::VectorXd& g = objective.gradient();
    const Eigen::VectorXd& d = objective.diagonal();
    for(int v = 0; v < n; ++v)
    {
      displacement_[v] = g.segment<3>(3 * v).norm() / (d[3 * v] * shortest_edge_[v]);
      // A vertex may come to rest for a moment while those around it still move.
      still_[v] = displacement_[v] < freeze_bound_ ? still_[v] + 1 : 0;
      if(do_freeze_ && still_[v] == iterations_to_freeze)
        objective.freeze(v);
    }
    const std::size_t count = (std::max)(std::size_t(1), static_cast<std::size_t>(n) / 500);
    std::nth_element(displacement_.begin(), displacement_.begin() + (count - 1), displacement_.end(),
                     std::greater<double>());
    const double largest = std::accumulate(displacement_.begin(), displacement_.begin() + count, 0.) / double(count);
    first_ = (std::max)(first_, largest);
    return largest;
  }

  // The fraction of the way to `convergence`, in orders of magnitude.
  double progress(double displacement, double convergence) const
  {
    if(!(convergence > 0 && first_ > convergence && displacement > 0))
      return 0;
    return std::log(first_ / displacement) / std::log(first_ / convergence);
  }

private:
  static constexpr int iterations_to_freeze = 6;

  double freeze_bound_;
  bool do_freeze_;
  double first_ = 0;
  std::vector<double> displacement_, shortest_edge_;
  std::vector<int> still_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_CONVERGENCE_MONITOR_H
