// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_NODAL_DENSITIES_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_NODAL_DENSITIES_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/density/Field_density_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Values at the vertices of a mesh, interpolated linearly on a copy of it, in which each vertex is found by walking from the cell where
// it was last.
class Nodal_values_3
{
public:
  Nodal_values_3(const Moving_triangulation_3& mesh, std::vector<double> values)
    : topology_(mesh.topology)
    , sites_(mesh.sites)
    , number_of_movable_vertices_(mesh.number_of_movable_vertices)
    , values_(std::move(values))
    , last_cell_(mesh.sites.size())
  {
    for(std::size_t v = 0; v < last_cell_.size(); ++v)
      last_cell_[v] = topology_.incident_cell(static_cast<int>(v));
  }

  // The value at the site where vertex v is now; vertices that stay have their own.
  double at(int v, const Site& s) { return v < number_of_movable_vertices_ ? interpolated(last_cell_[v], s) : values_[v]; }

  // The value at a point of a cell around the vertex.
  double beside(int v, const Site& s) const
  {
    int c = last_cell_[v];
    return interpolated(c, s);
  }

private:
  // Sets `c`, where the search begins, to the cell where it ends.
  double interpolated(int& c, const Site& s) const
  {
    std::array<double, 4> b;
    c = locate(c, s, b);
    double value = 0;
    for(int i = 0; i < 4; ++i)
      value += b[i] * values_[topology_.vertices(c)[i]];
    return value;
  }

  // Visibility walk; a point beyond a constrained facet gets the barycentric coordinates of
  // the last cell, clamped.
  int locate(int c, const Site& s, std::array<double, 4>& b) const
  {
    int previous = -1;
    for(int step = 1; ; ++step)
    {
      const double total = volumes(topology_.vertices(c), s, b);
      int leave = -1;
      double lowest = 0;
      for(int i = 0; i < 4; ++i)
      {
        const Half_facet across = topology_.neighbor(Half_facet(c, i));
        if(b[i] < lowest && !across.is_side() && across.cell() != previous)
        {
          lowest = b[i];
          leave = across.cell();
        }
      }
      if(leave < 0 || step == max_steps)
      {
        double sum = 0;
        for(double& x : b)
        {
          x = total > 0 ? (std::max)(0., x / total) : 0;    // a flat cell of the input may have no volume
          sum += x;
        }
        for(double& x : b)
          x = sum > 0 ? x / sum : 0.25;
        return c;
      }
      previous = c;
      c = leave;
    }
  }

  // The volumes of a cell's parts between its facets and a point, and of the cell, times six.
  double volumes(const int* cell, const Site& s, std::array<double, 4>& parts) const
  {
    const Site& origin = sites_[cell[0]];
    const auto edge = [&origin](const Site& p) { return Vector_3(p.x - origin.x, p.y - origin.y, p.z - origin.z); };
    const Vector_3 a = edge(sites_[cell[1]]), b = edge(sites_[cell[2]]), c = edge(sites_[cell[3]]), d = edge(s);
    const Vector_3 normal = b.cross(c);
    const double all = a.dot(normal);
    parts[1] = d.dot(normal);
    parts[2] = d.dot(c.cross(a));
    parts[3] = d.dot(a.cross(b));
    parts[0] = all - parts[1] - parts[2] - parts[3];
    return all;
  }

  static constexpr int max_steps = 200;

  Indexed_triangulation_3 topology_;
  std::vector<Site> sites_;
  int number_of_movable_vertices_;
  std::vector<double> values_;
  std::vector<int> last_cell_;
};

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

  // The factors on the sizes at the vertices.
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

  // The share of the sizes of the input, which is one at and beside features.
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

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_NODAL_DENSITIES_3_H
