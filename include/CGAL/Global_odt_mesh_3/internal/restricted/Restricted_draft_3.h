// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_DRAFT_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_DRAFT_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Cell_knowledge.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Numbered_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_update.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The next state of a restricted complex while it is being made, until the
// complex accepts it.
template <class Triangulation, class Mesh_domain>
class Restricted_draft_3
{
public:
  typedef Restricted_complex_3<Triangulation, Mesh_domain> Complex;
  typedef typename Complex::Surface_center Surface_center;
  typedef typename Complex::Triple Triple;
  typedef typename Complex::Quadruple Quadruple;
  typedef typename Triangulation::Cell_handle Cell_handle;
  typedef typename Triangulation::Facet Facet;

  static constexpr int unknown_patch = -2;    // of a facet on whose patch its vertices do not agree

  Restricted_update mode;
  Numbered_triangulation_3<Triangulation> numbered;
  std::vector<Site> sites;
  std::vector<std::pair<Cell_handle, int> > boundary_cells;   // with all vertices on the boundary, and labels
  Boundary_complex_3 boundary;
  std::vector<Facet> facets;
  std::vector<int> old_facets;                // the numbers that facets have in the complex, or -1
  std::vector<Surface_center> centers;
  Boundary_complex_3 measured_boundary;       // that of the complex, at the positions of the draft

  explicit Restricted_draft_3(Complex& complex)
    : complex_(complex)
  {}

  void start(const std::vector<Site>& target, const Restricted_update& how)
  {
    mode = how;
    sites = target;
    is_settled_.assign(complex_.number_of_movable_vertices, false);
    left_homes_.clear();
    measured_boundary = complex_.boundary;
    measure();
  }

  // To be called when vertices have moved.
  void measure()
  {
    if(mode.boundary_moves)
      measured_boundary.measure_umbrellas(sites);
  }

  void build()
  {
    std::vector<Weighted_point> points;
    points.reserve(sites.size());
    for(std::size_t v = 0; v < sites.size(); ++v)
      points.push_back(point(static_cast<int>(v)));
    numbered.build(points, sites);
  }

  // Moves the vertex in the triangulation to where its site is.
  void move(int v) { numbered.move(v, point(v)); }

  const Triangulation& triangulation() const { return numbered.triangulation(); }

  Quadruple numbers(Cell_handle c) const
  {
    Quadruple q;
    for(int i = 0; i < 4; ++i)
      q[i] = numbered.number(c->vertex(i));
    return q;
  }

  bool is_movable(int v) const { return v < complex_.number_of_movable_vertices; }

  bool is_home(int v) const
  {
    const Site& a = sites[v];
    const Site& b = complex_.sites[v];
    return a.x == b.x && a.y == b.y && a.z == b.z;
  }

  template <class Vertices>
  bool are_home(const Vertices& vertices) const
  {
    return std::all_of(vertices.begin(), vertices.end(), [this](int v) { return is_home(v); });
  }

  // Where the vertex is now is its home from now on.
  void settle_home(int v)
  {
    left_homes_.emplace_back(v, complex_.sites[v]);
    complex_.sites[v] = sites[v];
    is_settled_[v] = true;
  }

  // The draft is given up; vertices are at home where they were.
  void discard()
  {
    for(auto h = left_homes_.rbegin(); h != left_homes_.rend(); ++h)
      complex_.sites[h->first] = h->second;
    left_homes_.clear();
  }

  // Whether a boundary facet is where it was.
  bool is_unchanged(const Triple& t) const
  {
    return std::all_of(t.begin(), t.end(), [this](int v)
    { return is_home(v) && (!is_movable(v) || !is_settled_[v]); });
  }

  // The draft becomes the state of the complex.
  void accept()
  {
    complex_.clear_boundary_cells();
    for(const auto& c : boundary_cells)
      complex_.add_boundary_cell(numbers(c.first), c.second);
    complex_.swap_triangulation(numbered);
    Triangulation& tr = complex_.own_triangulation();
    for(auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
      forget(Cell_handle(c));
    complex_.sites.swap(sites);
    std::swap(complex_.boundary, boundary);
    complex_.facets.swap(facets);
    complex_.centers.swap(centers);
    complex_.number_facets();
    store_patches();
  }

private:
  typedef typename Triangulation::Weighted_point Weighted_point;
  typedef typename Triangulation::Bare_point Bare_point;

  Weighted_point point(int v) const
  {
    if(!is_movable(v))
      return complex_.triangulation->point(complex_.vertices[v]);
    const Site& s = sites[v];
    return complex_.triangulation->geom_traits().construct_weighted_point_3_object()(Bare_point(s.x, s.y, s.z));
  }

  void store_patches()
  {
    for(std::size_t n = 0; n < complex_.facets.size(); ++n)
    {
      const int patch = complex_.boundary.facets()[n].patch;
      if(patch == Boundary_facet::no_patch)
        continue;
      for(const Facet& f : { complex_.facets[n], complex_.triangulation->mirror_facet(complex_.facets[n]) })
        f.first->set_surface_patch_index(f.second, complex_.patches.value(patch));
    }
  }

  Complex& complex_;
  std::vector<char> is_settled_;              // of the movable vertices
  std::vector<std::pair<int, Site> > left_homes_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_DRAFT_3_H
