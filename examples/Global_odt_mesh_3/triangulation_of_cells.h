// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_EXAMPLES_TRIANGULATION_OF_CELLS_H
#define GLOBAL_ODT_MESH_3_EXAMPLES_TRIANGULATION_OF_CELLS_H

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// A triangulation that has the cells that are given, beside infinite ones: it need neither be Delaunay nor have a convex
// boundary, and the boundary need not be a manifold. Throws std::runtime_error with one line where cells do not fit
// together.
template <class Triangulation>
class Triangulation_of_cells
{
public:
  typedef typename Triangulation::Bare_point Point;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Cell_handle Cell_handle;
  typedef std::array<int, 4> Cell;

  Triangulation_of_cells(const std::vector<Point>& points, const std::vector<Cell>& cells)
    : points_(points)
    , cells_(cells)
    , is_used_(points.size(), false)
  {
    orient_cells();
    check_points();
    match_facets();
    match_edges();
  }

  // Fills the triangulation.
  void build(Triangulation& tr)
  {
    auto& tds = tr.tds();
    tds.clear();
    tds.set_dimension(3);
    tr.set_infinite_vertex(tds.create_vertex());
    vertices.resize(points_.size());
    for(std::size_t v = 0; v < points_.size(); ++v)
      if(is_used_[v])
      {
        vertices[v] = tds.create_vertex();
        vertices[v]->set_point(typename Triangulation::Weighted_point(points_[v]));
      }
    for(const Cell& c : cells_)
    {
      std::array<Vertex_handle, 4> v;
      for(std::size_t i = 0; i < 4; ++i)
        v[i] = c[i] == infinite ? tr.infinite_vertex() : vertices[static_cast<std::size_t>(c[i])];
      cells.push_back(tds.create_cell(v[0], v[1], v[2], v[3]));
      for(Vertex_handle w : v)
        w->set_cell(cells.back());
    }
    for(const auto& n : neighbors_)
      tds.set_adjacency(cells[n.first.cell], n.first.index, cells[n.second.cell], n.second.index);
    cells.resize(number_of_finite_cells_);
  }

  std::vector<Vertex_handle> vertices;    // by number; those of no cell are none
  std::vector<Cell_handle> cells;         // those that have been given

private:
  static constexpr int infinite = -1;

  // Opposite to the vertex with that index.
  struct Side
  {
    std::size_t cell;
    int index;
  };
  template <std::size_t n>
  struct Keyed_side
  {
    std::array<int, n> vertices;          // in ascending order
    Side side;
    bool is_odd;                          // the permutation of the cell that has these first
  };

  const Point& point(int v) const { return points_[static_cast<std::size_t>(v)]; }

  static std::string number(std::size_t n) { return std::to_string(n + 1); }
  static std::string number(int n) { return std::to_string(n + 1); }

  void orient_cells()
  {
    for(std::size_t n = 0; n < cells_.size(); ++n)
    {
      Cell& c = cells_[n];
      const CGAL::Orientation o = CGAL::orientation(point(c[0]), point(c[1]), point(c[2]), point(c[3]));
      if(o == CGAL::COPLANAR)
        throw std::runtime_error("tetrahedron " + number(n) + " is flat");
      if(o == CGAL::NEGATIVE)
        std::swap(c[2], c[3]);
      for(int v : c)
        is_used_[static_cast<std::size_t>(v)] = true;
    }
  }

  void check_points() const
  {
    std::vector<std::size_t> order(points_.size());
    std::iota(order.begin(), order.end(), 0);
    order.erase(std::remove_if(order.begin(), order.end(), [this](std::size_t v) { return !is_used_[v]; }), order.end());
    std::sort(order.begin(), order.end(), [this](std::size_t v, std::size_t w) { return points_[v] < points_[w]; });
    const auto same = std::adjacent_find(order.begin(), order.end(),
                                         [this](std::size_t v, std::size_t w) { return points_[v] == points_[w]; });
    if(same == order.end())
      return;
    const auto both = std::minmax(same[0], same[1]);
    throw std::runtime_error("vertices " + number(both.first) + " and " + number(both.second) + " are at the same place");
  }

  Keyed_side<3> facet(std::size_t cell, int index) const
  {
    Keyed_side<3> f = { {}, { cell, index }, index % 2 == 0 };
    for(int i = 0, k = 0; i < 4; ++i)
      if(i != index)
        f.vertices[static_cast<std::size_t>(k++)] = cells_[cell][static_cast<std::size_t>(i)];
    auto& v = f.vertices;
    for(const int i : { 0, 1, 0 })
      if(const auto k = static_cast<std::size_t>(i); v[k] > v[k + 1])
      {
        std::swap(v[k], v[k + 1]);
        f.is_odd = !f.is_odd;
      }
    return f;
  }

  // Two cells at each facet, or a finite and an infinite one.
  void match_facets()
  {
    number_of_finite_cells_ = cells_.size();
    std::vector<Keyed_side<3> > facets;
    for(std::size_t c = 0; c < cells_.size(); ++c)
      for(int i = 0; i < 4; ++i)
        facets.push_back(facet(c, i));
    std::sort(facets.begin(), facets.end(), [](const auto& a, const auto& b)
              { return std::make_pair(a.vertices, a.side.cell) < std::make_pair(b.vertices, b.side.cell); });
    for(std::size_t n = 0; n < facets.size(); ++n)
    {
      const auto& f = facets[n];
      const auto is_same = [&](std::size_t k) { return k < facets.size() && facets[k].vertices == f.vertices; };
      if(is_same(n + 2))
        throw std::runtime_error("tetrahedra " + number(f.side.cell) + ", " + number(facets[n + 1].side.cell) + ", and "
                                 + number(facets[n + 2].side.cell) + " share a facet");
      if(!is_same(n + 1))
        add_infinite_cell(f.side);
      else if(facets[n + 1].is_odd == f.is_odd)
        throw std::runtime_error("tetrahedra " + number(f.side.cell) + " and " + number(facets[n + 1].side.cell)
                                 + " overlap");
      else
        neighbors_.emplace_back(f.side, facets[++n].side);
    }
  }

  void add_infinite_cell(Side side)
  {
    Cell c = cells_[side.cell];
    const auto i = static_cast<std::size_t>(side.index);
    c[i] = infinite;
    std::swap(c[(i + 1) % 4], c[(i + 2) % 4]);
    neighbors_.emplace_back(side, Side{ cells_.size(), side.index });
    inner_cells_.push_back(side.cell);
    cells_.push_back(c);
  }

  // Infinite cells meet at edges.
  void match_edges()
  {
    std::vector<Keyed_side<2> > edges;
    for(std::size_t c = number_of_finite_cells_; c < cells_.size(); ++c)
      for(int i = 0; i < 4; ++i)
        if(cells_[c][static_cast<std::size_t>(i)] != infinite)
        {
          const Keyed_side<3> f = facet(c, i);      // whose first vertex is infinite
          edges.push_back({ {{ f.vertices[1], f.vertices[2] }}, f.side, f.is_odd });
        }
    std::sort(edges.begin(), edges.end(), [](const auto& a, const auto& b)
              { return std::make_pair(a.vertices, a.side.cell) < std::make_pair(b.vertices, b.side.cell); });
    for(auto begin = edges.begin(); begin != edges.end();)
    {
      const auto end = std::find_if(begin, edges.end(), [&](const auto& e) { return e.vertices != begin->vertices; });
      if(end - begin > 2)
        sort_around_edge(begin, end);
      for(; begin != end; begin += 2)
        neighbors_.emplace_back(begin[0].side, begin[1].side);
    }
  }

  // Around an edge where more than two facets of the boundary meet, so that each two that face each other across the outside
  // follow each other.
  template <class Iterator>
  void sort_around_edge(Iterator begin, Iterator end) const
  {
    const Point &p = point(begin->vertices[0]), &q = point(begin->vertices[1]);
    const auto along = q - p;
    const auto at = [&](const auto& e) { return point(cells_[e.side.cell][static_cast<std::size_t>(e.side.index)]) - p; };
    const auto x = CGAL::cross_product(CGAL::cross_product(along, at(*begin)), along), y = CGAL::cross_product(along, x);
    const double x_length = std::sqrt(x * x), y_length = std::sqrt(y * y);
    const auto angle = [&](const auto& e) { return std::atan2((at(e) * y) / y_length, (at(e) * x) / x_length); };
    // Whether the outside begins there, counterclockwise.
    const auto is_begin = [&](const auto& e)
    {
      const Cell& inner = cells_[inner_cells_[e.side.cell - number_of_finite_cells_]], &outer = cells_[e.side.cell];
      const auto i = static_cast<std::size_t>(std::find(outer.begin(), outer.end(), int(infinite)) - outer.begin());
      const Point& r = point(outer[static_cast<std::size_t>(e.side.index)]);
      return CGAL::orientation(p, q, r, point(inner[i])) == CGAL::NEGATIVE;
    };
    std::sort(begin, end, [&](const auto& a, const auto& b) { return angle(a) < angle(b); });
    std::rotate(begin, std::find_if(begin, end, is_begin), end);
    for(auto e = begin; e != end; ++e)
      if(is_begin(*e) != ((e - begin) % 2 == 0))
        throw std::runtime_error("tetrahedra overlap at the edge between vertices " + number(e->vertices[0]) + " and "
                                 + number(e->vertices[1]));
  }

  const std::vector<Point>& points_;
  std::vector<Cell> cells_;                               // finite ones, and then infinite ones
  std::vector<bool> is_used_;
  std::size_t number_of_finite_cells_ = 0;
  std::vector<std::size_t> inner_cells_;                  // beside the infinite ones
  std::vector<std::pair<Side, Side> > neighbors_;
};

#endif // GLOBAL_ODT_MESH_3_EXAMPLES_TRIANGULATION_OF_CELLS_H
