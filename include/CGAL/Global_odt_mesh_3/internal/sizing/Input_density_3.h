// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_INPUT_DENSITY_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_INPUT_DENSITY_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/density/Field_density_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/sizing/Nodal_values_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The density that the input mesh stands for, so that a graded mesh stays
// graded: that of the mean lengths of edges at the vertices.
class Input_density_3
  : public Density_3
{
public:
  // Sizes that differ less than this (largest over smallest, the outer 5 %
  // of either side left out) are taken for one size.
  static constexpr double uniform_ratio = 1.5;

  explicit Input_density_3(const Moving_triangulation_3& mesh)
    : sizes_(mesh, sizes_of(mesh))
  {}

  bool is_uniform() const override { return is_uniform_; }
  bool is_safe_for_threads() const override { return true; }

  // The wanted size where vertex v is now; vertices that stay have the one of the input.
  double size(int v, const Site& s) { return sizes_.at(v, s); }

  double in_volume(int v, const Site& s) override { return volume_density(size(v, s) / median_size_); }
  double on_surface(int v, const Site& s) override { return surface_density(size(v, s) / median_size_); }
  double in_cell(int v, const Site& s) override { return volume_density(sizes_.beside(v, s) / median_size_); }

private:
  // Also finds the median, and whether sizes are one.
  std::vector<double> sizes_of(const Moving_triangulation_3& mesh)
  {
    std::vector<double> sizes;
    mesh.mean_edge_lengths(static_cast<int>(mesh.sites.size()), sizes);
    std::vector<double> sorted(sizes.begin(), sizes.begin() + mesh.number_of_movable_vertices);
    if(sorted.empty())
      return sizes;
    std::sort(sorted.begin(), sorted.end());
    const std::size_t margin = sorted.size() / 20;
    is_uniform_ = sorted[sorted.size() - 1 - margin] < uniform_ratio * sorted[margin];
    median_size_ = sorted[sorted.size() / 2];
    // Facets may have vertices that no cell has.
    std::replace(sizes.begin(), sizes.end(), 0., median_size_);
    return sizes;
  }

  double median_size_ = 1;
  bool is_uniform_ = true;
  Nodal_values_3 sizes_;                      // made with the two
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_INPUT_DENSITY_3_H
