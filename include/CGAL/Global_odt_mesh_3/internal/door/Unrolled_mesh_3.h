// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_UNROLLED_MESH_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_UNROLLED_MESH_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/door/Periodic_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// A periodic complex, cut open along the sides of a cube anywhere and surrounded by copies, as one that is not periodic.
//
// The first vertices are those of the periodic complex, moved into the cube. Those of cells that the sides of the cube cut stay, so
// that the copies beyond are where they have to be as long as others move. The complex consists of the cells around vertices
// that may move, and of those that touch one of these, so that what moves is surrounded by cells that have neighbors; all else is
// outside.
template <class Kernel>
class Unrolled_mesh_3
  : public User_mesh_view_3
{
public:
  // Refers to the complex. Points that were there before the mesh, and have no dimension, move unless they are chosen to stay.
  Unrolled_mesh_3(const Periodic_complex_3& complex, const Vector_3& corner, const std::vector<char>& stays)
    : complex_(complex)
    , corner_(corner)
    , stays_(stays)
    , size_(complex.sites.size())
  {
    place_vertices();
    find_cut_vertices();
    place_copies();
    triangulate();
  }

  // Whether all cells around vertices that may move are there.
  bool is_faithful() const { return is_faithful_; }

  // The sites of the periodic complex, where the optimizer has moved them.
  std::vector<Site> periodic_sites() const
  {
    std::vector<Site> sites = complex_.sites;
    for(std::size_t v = 0; v < size_; ++v)
      if(!same_place(moved_[v], table_.sites[v]))
        sites[v] = site_at(complex_.cube.canonical(position(moved_[v])), sites[v].weight);
    return sites;
  }

  bool is_changed() const override { return !moved_.empty(); }

  // The vertices of cells around vertices that have moved that are so large that they take several sheets. CGAL takes long to find
  // that out.
  const std::vector<int>& vertices_of_large_cells() const { return vertices_of_large_cells_; }

  Mesh_table_3 read(const Thread_policy&) override { return table_; }
  int patch(int v) const override { return complex_.patches[original_[v]]; }
  bool is_fixed(int v) const override { return static_cast<std::size_t>(v) >= size_ || !is_movable_[v]; }
  std::vector<Mesh_table_3::Feature_edge> feature_edges() override { return {}; }

  void write(const Mesh_table_3& table) override
  {
    moved_ = table.sites;
    for(const Mesh_table_3::Cell& c : table.cells)
      if(has_movable_vertex(c.vertices) && index_of(c.vertices, Mesh_table_3::infinite) == 4)
        if(!(squared_orthoradius(table.cell_sites(c.vertices)) < CGAL::square(complex_.cube.period) / 64))
          for(int v : c.vertices)
            vertices_of_large_cells_.push_back(original_[v]);
  }

  // They are counted in the periodic complex.
  std::size_t number_of_slivers(double) const override { return 0; }

private:
  typedef CGAL::Triangulation_vertex_base_with_info_3<int, Kernel, CGAL::Regular_triangulation_vertex_base_3<Kernel> > Vertex_base;
  typedef CGAL::Triangulation_cell_base_with_info_3<int, Kernel, CGAL::Regular_triangulation_cell_base_3<Kernel> > Cell_base;
  typedef CGAL::Regular_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Vertex_base, Cell_base> > Triangulation;

  static constexpr int interior = 3;

  // The square of the radius of the sphere that CGAL compares: with weights, it is smaller than that through the vertices.
  static double squared_orthoradius(const std::array<Site, 4>& s)
  {
    return Cell_products(s[0], s[1], s[2], s[3]).to_dual().squared_length() - s[0].weight;
  }

  void place_vertices()
  {
    for(std::size_t v = 0; v < size_; ++v)
      add_vertex(v, complex_.cube.periods_into(position(complex_.sites[v]), corner_));
  }

  void add_vertex(std::size_t v, const Periods& periods)
  {
    const Site& s = complex_.sites[v];
    original_.push_back(static_cast<int>(v));
    periods_.push_back(periods);
    table_.sites.push_back(site_at(complex_.cube.translated(position(s), periods), s.weight));
    table_.dimensions.push_back(complex_.dimensions[v] < 0 && !stays_[v] ? int(interior) : complex_.dimensions[v]);
  }

  // Whether the sides of the cube cut a cell.
  bool is_cut(const Periodic_complex_3::Cell& c) const
  {
    const Periods first = periods_[c.vertices[0]] - c.offsets[0];
    for(int i = 1; i < 4; ++i)
      if(periods_[c.vertices[i]] - c.offsets[i] != first)
        return true;
    return false;
  }

  void find_cut_vertices()
  {
    is_movable_.assign(size_, true);
    is_near_.assign(size_, false);
    for(const Periodic_complex_3::Cell& c : complex_.cells)
      if(complex_.is_inside(c) && is_cut(c))
        for(int v : c.vertices)
          is_movable_[v] = false;
    for(const Periodic_complex_3::Cell& c : complex_.cells)
      if(complex_.is_inside(c) && has_movable_vertex(c.vertices))
        for(int v : c.vertices)
          is_near_[v] = true;
    for(std::size_t v = 0; v < size_; ++v)
      if(table_.dimensions[v] < 2 || table_.sites[v].weight != 0)
        is_movable_[v] = false;
  }

  bool has_movable_vertex(const Quadruple& q) const
  {
    return std::any_of(q.begin(), q.end(), [this](int v) { return v != Mesh_table_3::infinite && !is_fixed(v); });
  }

  // Whether the cell is to be in the complex.
  bool is_near(const Quadruple& q) const
  {
    return std::any_of(q.begin(), q.end(), [this](int v) { return static_cast<std::size_t>(v) < size_ && is_near_[v]; });
  }

  // All that may be in the spheres of cells with a vertex in the cube.
  void place_copies()
  {
    double squared_radius = 0;
    for(const Periodic_complex_3::Cell& c : complex_.cells)
      if(complex_.is_inside(c) && is_near(c.vertices))
      {
        const std::array<Site, 4> s = complex_.cell_sites(c);
        squared_radius = (std::max)(squared_radius, squared_circumradius(s));
      }
    const double period = complex_.cube.period, margin = (std::min)(period, 2.1 * std::sqrt(squared_radius));
    const auto is_close = [&](const Vector_3& p)
    {
      for(int i = 0; i < 3; ++i)
        if(p[i] < corner_[i] - margin || p[i] > corner_[i] + period + margin)
          return false;
      return true;
    };
    for(std::size_t v = 0; v < size_; ++v)
      for(int n = 0; n < 27; ++n)
      {
        const Periods periods = {{ n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1 }};
        if(periods != Periods{{ 0, 0, 0 }} && is_close(complex_.cube.translated(position(table_.sites[v]), periods)))
          add_vertex(v, periods_[v] + periods);
      }
  }

  void triangulate()
  {
    typedef typename Kernel::Weighted_point_3 Weighted_point_3;
    std::vector<std::pair<Weighted_point_3, int> > points;
    for(std::size_t v = 0; v < table_.sites.size(); ++v)
    {
      const Site& s = table_.sites[v];
      points.emplace_back(Weighted_point_3(typename Kernel::Point_3(s.x, s.y, s.z), s.weight), static_cast<int>(v));
    }
    Triangulation tr;
    tr.insert(points.begin(), points.end());
    if(tr.number_of_vertices() != table_.sites.size())
      return;
    tr.infinite_vertex()->info() = Mesh_table_3::infinite;
    const std::vector<typename Triangulation::Cell_handle> cells = all_cells(tr);
    for(std::size_t n = 0; n < cells.size(); ++n)
      cells[n]->info() = static_cast<int>(n);
    for(typename Triangulation::Cell_handle c : cells)
    {
      Mesh_table_3::Cell cell;
      for(int i = 0; i < 4; ++i)
      {
        cell.vertices[i] = c->vertex(i)->info();
        cell.neighbors[i] = c->neighbor(i)->info();
      }
      cell.label = Domain_view_3::outside;
      table_.cells.push_back(cell);
    }
    is_faithful_ = label_cells();
    read_facets();
  }

  Quadruple originals(const Quadruple& q) const
  {
    Quadruple result;
    for(int i = 0; i < 4; ++i)
      result[i] = original_[q[i]];
    return result;
  }

  // Whether all cells with vertices that may move have been found.
  bool label_cells()
  {
    Tuple_table<Quadruple, int> numbers;
    numbers.reserve(complex_.cells.size());
    std::ptrdiff_t missing = 0;
    for(std::size_t n = 0; n < complex_.cells.size(); ++n)
      if(const Periodic_complex_3::Cell& c = complex_.cells[n]; complex_.is_inside(c) && is_near(c.vertices))
      {
        numbers.insert(sorted(c.vertices), static_cast<int>(n));
        missing += has_movable_vertex(c.vertices);
      }
    for(Mesh_table_3::Cell& c : table_.cells)
    {
      if(!is_near(c.vertices) || std::count(c.vertices.begin(), c.vertices.end(), int(Mesh_table_3::infinite)) > 0)
        continue;
      const int* const n = numbers.find(sorted(originals(c.vertices)));
      if(n == nullptr || !is_copy(complex_.cells[*n], c.vertices))
        continue;
      c.label = complex_.cells[*n].label;
      missing -= has_movable_vertex(c.vertices);
    }
    return missing == 0;
  }

  // Whether these vertices are those of the cell, translated together.
  bool is_copy(const Periodic_complex_3::Cell& cell, const Quadruple& q) const
  {
    Periods shift = {};
    for(int i = 0; i < 4; ++i)
    {
      const int k = index_of(cell.vertices, original_[q[i]]);
      const Periods here = periods_[q[i]] - cell.offsets[k];
      if(i > 0 && here != shift)
        return false;
      shift = here;
    }
    return true;
  }

  // Reads the facets of cells in the complex, from both sides.
  void read_facets()
  {
    Tuple_table<Triple, int> numbers;
    for(std::size_t n = 0; n < complex_.facets.size(); ++n)
      numbers.insert(sorted(complex_.facet_vertices(complex_.facets[n])), static_cast<int>(n));
    for(std::size_t n = 0; n < table_.cells.size(); ++n)
      for(int i = 0; i < 4; ++i)
      {
        Mesh_table_3::Cell& c = table_.cells[n];
        if(c.label == Domain_view_3::outside && table_.cells[c.neighbors[i]].label == Domain_view_3::outside)
          continue;
        const Triple t = {{ c.vertices[(i + 1) & 3], c.vertices[(i + 2) & 3], c.vertices[(i + 3) & 3] }};
        const int* const f = numbers.find(sorted(Triple{{ original_[t[0]], original_[t[1]], original_[t[2]] }}));
        if(f == nullptr)
          continue;
        c.facets |= 1 << i;
        table_.facets.push_back({ static_cast<int>(n), i, complex_.facets[*f].patch, static_cast<int>(table_.facets.size()),
                                  Vector_3(), 0 });
      }
  }

  const Periodic_complex_3& complex_;
  Vector_3 corner_;
  const std::vector<char>& stays_;
  std::size_t size_;                        // number of vertices of the periodic complex
  std::vector<char> is_movable_, is_near_;  // of these
  std::vector<int> original_;               // of which vertices are copies
  std::vector<Periods> periods_;            // from these
  Mesh_table_3 table_;
  std::vector<Site> moved_;
  std::vector<int> vertices_of_large_cells_;
  bool is_faithful_ = false;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_UNROLLED_MESH_3_H
