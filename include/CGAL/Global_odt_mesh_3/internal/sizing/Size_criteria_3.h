// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_SIZE_CRITERIA_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_SIZE_CRITERIA_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/User_field_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// How large cells may be around each vertex, if there is a bound at all. A cell has the least bound of its vertices.
class Circumradius_bound_3
{
public:
  Circumradius_bound_3() {}
  explicit Circumradius_bound_3(std::vector<double> squared_radii) : squared_radii_(std::move(squared_radii)) {}

  // What a cell is too large by, to be added to what its angles lack, hence in square degrees.
  double deficit(const int* vertices, const std::array<Site, 4>& cell) const
  {
    if(squared_radii_.empty())
      return 0;
    double most = squared_radii_[vertices[0]];
    for(int i = 1; i < 4; ++i)
      most = (std::min)(most, squared_radii_[vertices[i]]);
    const double squared_radius = squared_circumradius(cell);
    if(!(squared_radius > most))
      return 0;
    const double excess = (std::min)(degrees * (std::sqrt(squared_radius / most) - 1), most_degrees);
    return excess * excess;
  }

private:
  // What a circumradius of twice the bound would count for. With 60, the largest cells are closer to the bound by one or two
  // percent, but more angles stay below 30 degrees; with 15, twice as many cells stay too large.
  static constexpr double degrees = 30;
  static constexpr double most_degrees = 10;    // flat cells lack angles already

  std::vector<double> squared_radii_;
};

// The largest circumradius in each subdomain of the input, so that no cell need be larger in the end: over the local size and,
// if the sizes are those of the input, as a length, too.
class Largest_cells_3
{
public:
  // `subdomain[v]` is that of a vertex of the interior, or negative. `size(v)` is the local size at a movable vertex in the mesh,
  // which is the input.
  template <class Size>
  Largest_cells_3(const Constrained_triangulation_3& mesh, std::vector<int> subdomain, const Size& size, bool has_sizes_of_input)
    : subdomain_(std::move(subdomain))
    , has_sizes_of_input_(has_sizes_of_input)
  {
    if(!subdomain_.empty())
      largest_.resize(1 + (std::max)(0, *std::max_element(subdomain_.begin(), subdomain_.end())));
    const std::vector<double> sizes = squared_sizes(mesh, size);
    for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
      if(mesh.topology.is_alive(c))
        add(mesh.topology.cell(c), squared_circumradius(mesh.cell_sites(c)), sizes);
  }

  // The bound on the cells around each vertex, where it is in a mesh. Next to vertices on surfaces, each subdomain may have a bound
  // of its own.
  template <class Size>
  Circumradius_bound_3 bound(const Constrained_triangulation_3& mesh, const Size& size) const
  {
    std::vector<double> radii = squared_sizes(mesh, size);
    for(std::size_t v = 0; v < radii.size(); ++v)
    {
      const Largest& largest = subdomain_[v] >= 0 ? largest_[subdomain_[v]] : largest_of_all_;
      // Nothing is known of a subdomain of which no vertex moves.
      if(largest.over_size > 0)
        radii[v] *= largest.over_size;
      if(has_sizes_of_input_)
        radii[v] = (std::min)(radii[v], largest.length);
    }
    return Circumradius_bound_3(std::move(radii));
  }

private:
  // Squares.
  struct Largest
  {
    double length = 0, over_size = 0;

    void add(double squared_radius, double squared_size)
    {
      length = (std::max)(length, squared_radius);
      over_size = (std::max)(over_size, squared_radius / squared_size);
    }
  };

  void add(const std::array<int, 4>& vertices, double squared_radius, const std::vector<double>& sizes)
  {
    double least = (std::numeric_limits<double>::infinity)();
    for(int v : vertices)
      least = (std::min)(least, sizes[v]);
    largest_of_all_.add(squared_radius, least);
    for(int v : vertices)
      if(subdomain_[v] >= 0)
        largest_[subdomain_[v]].add(squared_radius, least);
  }

  // The size of vertices that do not move is infinite.
  template <class Size>
  static std::vector<double> squared_sizes(const Constrained_triangulation_3& mesh, const Size& size)
  {
    std::vector<double> sizes(mesh.sites.size(), (std::numeric_limits<double>::infinity)());
    for(int v = 0; v < mesh.number_of_movable_vertices; ++v)
    {
      const double s = size(v);
      sizes[v] = s * s;
    }
    return sizes;
  }

  std::vector<int> subdomain_;
  bool has_sizes_of_input_;
  std::vector<Largest> largest_;          // by subdomain
  Largest largest_of_all_;
};

// Bounds on the sizes of cells and facets, much as the criteria of the mesh generator have them. Cells are bounded by their
// circumradii, as in each subdomain of the input or as a field says, and facets by theirs, as in the input, since files do not keep
// surface centers. The distances of facets to the surface are not bounded: this would take more vertices and make cells worse.
class Size_criteria_3
{
public:
  // A cell that is too large, or the cell of a facet that is.
  struct Violation
  {
    static constexpr int no_facet = -1;

    double excess;
    Quadruple cell;               // vertices, by their numbers in the table
    int facet = no_facet;         // the index of its opposite vertex

    // The worst first.
    bool operator<(const Violation& o) const { return excess != o.excess ? excess > o.excess : cell < o.cell; }
  };

  // If a field gives sizes, they bound cells.
  Size_criteria_3(const Mesh_table_3& input, const User_field_3& field)
    : field_(field)
  {
    for(const Mesh_table_3::Cell& c : input.cells)
      if(c.label != Domain_view_3::outside)
      {
        double& largest = squared_circumradius_[c.label];
        largest = (std::max)(largest, squared_circumradius(input.cell_sites(c.vertices)));
      }
    for(const Mesh_table_3::Facet& f : input.facets)
      facet_radius_ = (std::max)(facet_radius_, facet_radius(input, f));
  }

  std::vector<Violation> violations(const Mesh_table_3& mesh) const
  {
    std::vector<Violation> result;
    const auto add = [&result](const Violation& v)
    {
      if(v.excess > 1 + tolerance)
        result.push_back(v);
    };
    for(const Mesh_table_3::Cell& c : mesh.cells)
      if(c.label != Domain_view_3::outside)
        add({ std::sqrt(squared_circumradius(mesh.cell_sites(c.vertices)) / squared_bound(mesh, c)), c.vertices });
    for(const Mesh_table_3::Facet& f : mesh.facets)
    {
      const double excess = field_ || facet_radius_ == 0 ? 0 : facet_radius(mesh, f) / facet_radius_;
      const Mesh_table_3::Cell& c = mesh.cells[f.cell];
      // Each facet is in the table from either side.
      if(c.vertices < mesh.cells[c.neighbors[f.index]].vertices)
        continue;
      const bool is_inside = c.label != Domain_view_3::outside;
      add(is_inside ? Violation{ excess, c.vertices, f.index }
                    : Violation{ excess, mesh.cells[c.neighbors[f.index]].vertices, mesh.mirror_index(f.cell, f.index) });
    }
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  static constexpr double tolerance = 1e-6;

  static double facet_radius(const Mesh_table_3& m, const Mesh_table_3::Facet& f)
  {
    const Triple t = facet_vertices(m.cells[f.cell].vertices, f.index);
    const Vector_3 a = position(m.sites[t[1]]) - position(m.sites[t[0]]), b = position(m.sites[t[2]]) - position(m.sites[t[0]]);
    return a.length() * b.length() * (a - b).length() / (2 * a.cross(b).length());
  }

  double squared_bound(const Mesh_table_3& m, const Mesh_table_3::Cell& c) const
  {
    if(!field_)
      return squared_circumradius_.at(c.label);
    // Its circumcenter, where the mesh generator asks, may be outside of the domain.
    Vector_3 centroid;
    for(const Site& s : m.cell_sites(c.vertices))
      centroid += position(s) / 4;
    const double size = field_.value(Vertex_stratum::inside(c.label), site_at(centroid, 0));
    return size * size;
  }

  User_field_3 field_;
  std::map<int, double> squared_circumradius_;            // the largest, by subdomain
  double facet_radius_ = 0;                               // the largest
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_SIZE_CRITERIA_3_H
