// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_FIELD_NEAR_FEATURES_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_FIELD_NEAR_FEATURES_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/density/Field_density_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/sizing/Nodal_values_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The density of a field that gives way near features, whose vertices are as close to each other as they are: there, sizes are
// those of the input, up to a common factor; that matters less with each ring of vertices around.
class Field_near_features_3
  : public Density_3
{
public:
  // `is_on_feature(v)` says which vertices are.
  template <class Is_on_feature>
  Field_near_features_3(std::unique_ptr<Density_3> field, const Moving_triangulation_3& mesh, const Is_on_feature& is_on_feature)
    : field_(std::move(field))
    , factors_(mesh, factors(mesh, is_on_feature))
  {}

  bool is_uniform() const override { return false; }

  double in_volume(int v, const Site& s) override { return field_->in_volume(v, s) * volume_density(factors_.at(v, s)); }
  double on_surface(int v, const Site& s) override { return field_->on_surface(v, s) * surface_density(factors_.at(v, s)); }
  double in_cell(int v, const Site& s) override { return field_->in_cell(v, s) * volume_density(factors_.beside(v, s)); }

private:
  static constexpr int rings = 6;
  static constexpr double share_of_ring = 0.7;

  // Of sizes at the vertices.
  template <class Is_on_feature>
  std::vector<double> factors(const Moving_triangulation_3& mesh, const Is_on_feature& is_on_feature)
  {
    const int number = static_cast<int>(mesh.sites.size());
    std::vector<double> ratios;
    mesh.mean_edge_lengths(number, ratios);
    for(int v = 0; v < number; ++v)
    {
      const double density = ratios[v] > 0 ? field_->in_volume(v, mesh.sites[v]) : 0;
      ratios[v] = density > 0 ? ratios[v] / size_of_density(density) : 0;
    }
    const std::vector<double> shares = shares_of_input(mesh, is_on_feature);
    std::vector<double> sorted(ratios.begin(), ratios.begin() + mesh.number_of_movable_vertices);
    const auto usual = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), usual, sorted.end());
    for(int v = 0; v < number; ++v)
      ratios[v] = ratios[v] > 0 && *usual > 0 ? std::pow(ratios[v] / *usual, shares[v]) : 1.;
    return ratios;
  }

  // One at and beside features.
  template <class Is_on_feature>
  static std::vector<double> shares_of_input(const Moving_triangulation_3& mesh, const Is_on_feature& is_on_feature)
  {
    std::vector<double> shares(mesh.sites.size());
    for(std::size_t v = 0; v < shares.size(); ++v)
      shares[v] = is_on_feature(static_cast<int>(v)) ? 1 : 0;
    for(int ring = 0; ring < rings; ++ring)
    {
      std::vector<double> next = shares;
      for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
        if(mesh.topology.is_alive(c))
        {
          double most = 0;
          for(int v : mesh.topology.cell(c))
            most = (std::max)(most, shares[v]);
          for(int v : mesh.topology.cell(c))
            next[v] = (std::max)(next[v], ring == 0 ? most : share_of_ring * most);
        }
      shares = std::move(next);
    }
    return shares;
  }

  std::unique_ptr<Density_3> field_;
  Nodal_values_3 factors_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_FIELD_NEAR_FEATURES_3_H
