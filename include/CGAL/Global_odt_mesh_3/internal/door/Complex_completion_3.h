// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_COMPLEX_COMPLETION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_COMPLEX_COMPLETION_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Kernel/global_functions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <map>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Adds what a complex has beside cells: facets, edges, and corners, and what vertices say of these.
template <class C3t3>
class Complex_completion_3
{
public:
  // Facets whose normals are at an angle with a smaller cosine meet at a feature.
  Complex_completion_3(C3t3& c3t3, double smallest_cosine)
    : c3t3_(c3t3)
    , smallest_cosine_(smallest_cosine)
  {}

  void operator()()
  {
    count_facets();
    add_facets();
    add_edges();
    add_corners();
    set_indices();
  }

private:
  typedef typename C3t3::Triangulation Triangulation;
  typedef typename C3t3::Vertex_handle Vertex_handle;
  typedef typename C3t3::Facet Facet;
  typedef typename C3t3::Subdomain_index Subdomain_index;
  typedef typename C3t3::Surface_patch_index Surface_patch_index;
  typedef typename C3t3::Curve_index Curve_index;
  typedef typename C3t3::Corner_index Corner_index;
  typedef typename C3t3::Index Index;
  typedef typename Triangulation::Bare_point Point;
  typedef typename Kernel_traits<Point>::Kernel::Vector_3 Vector;
  typedef std::pair<Vertex_handle, Vertex_handle> Edge;
  // Their patches, and their vertices that are not on the edge.
  typedef std::vector<std::pair<Surface_patch_index, Vertex_handle> > Facets_around;

  static const Point& point(Vertex_handle v) { return v->point().point(); }
  static Edge edge(Vertex_handle v, Vertex_handle w) { return v < w ? Edge(v, w) : Edge(w, v); }

  // Counts what the cells say, of which one may know of a facet that the other does not know of.
  void count_facets()
  {
    const Triangulation& tr = c3t3_.triangulation();
    for(auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f)
    {
      const Facet g = tr.mirror_facet(*f);
      if(f->first->is_facet_on_surface(f->second))
        g.first->set_surface_patch_index(g.second, f->first->surface_patch_index(f->second));
      else if(g.first->is_facet_on_surface(g.second))
        f->first->set_surface_patch_index(f->second, g.first->surface_patch_index(g.second));
    }
    c3t3_.rescan_after_load_of_triangulation();
  }

  // Adds the facets between two subdomains.
  void add_facets()
  {
    const Triangulation& tr = c3t3_.triangulation();
    std::vector<Facet> missing;
    Surface_patch_index last = Surface_patch_index();
    for(auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f)
      if(c3t3_.is_in_complex(*f))
        last = (std::max)(last, c3t3_.surface_patch_index(*f));
      else if(f->first->subdomain_index() != tr.mirror_facet(*f).first->subdomain_index())
        missing.push_back(*f);
    std::map<std::pair<Subdomain_index, Subdomain_index>, Surface_patch_index> patches;
    for(const Facet& f : missing)
      patches[subdomains(f)];
    for(auto& p : patches)
      if constexpr (std::is_integral<Surface_patch_index>::value)
        p.second = ++last;
      else
        p.second = Surface_patch_index(p.first.first, p.first.second);
    for(const Facet& f : missing)
      add_facet(f, patches[subdomains(f)]);
  }

  std::pair<Subdomain_index, Subdomain_index> subdomains(const Facet& f) const
  { return std::minmax({ f.first->subdomain_index(), c3t3_.triangulation().mirror_facet(f).first->subdomain_index() }); }

  void add_facet(const Facet& f, const Surface_patch_index& patch)
  {
    c3t3_.add_to_complex(f, patch);
    const auto p = [&f](int k) { return point(f.first->vertex((f.second + k) % 4)); };
    for(const Facet& g : { f, c3t3_.triangulation().mirror_facet(f) })
    {
      g.first->set_facet_surface_center(g.second, CGAL::centroid(p(1), p(2), p(3)));
      g.first->set_facet_surface_center_index(g.second, Index(patch));
    }
  }

  void add_edges()
  {
    std::map<Edge, Facets_around> around;
    for(auto f = c3t3_.facets_in_complex_begin(); f != c3t3_.facets_in_complex_end(); ++f)
      for(int k = 1; k < 4; ++k)
      {
        const auto vertex = [&f](int n) { return f->first->vertex((f->second + n) % 4); };
        around[edge(vertex(k % 3 + 1), vertex((k + 1) % 3 + 1))].emplace_back(c3t3_.surface_patch_index(*f), vertex(k));
      }
    Curve_index last = Curve_index();
    for(auto e = c3t3_.edges_in_complex_begin(); e != c3t3_.edges_in_complex_end(); ++e)
      last = (std::max)(last, c3t3_.curve_index(*e));
    std::map<std::set<Surface_patch_index>, Curve_index> curves;      // by the patches that meet there
    for(const auto& e : around)
      if(!c3t3_.is_in_complex(e.first.first, e.first.second) && is_feature(e.first, e.second))
      {
        std::set<Surface_patch_index> patches;
        for(const auto& f : e.second)
          patches.insert(f.first);
        const auto curve = curves.emplace(patches, Curve_index());
        if(curve.second)
          curve.first->second = ++last;
        c3t3_.add_to_complex(e.first.first, e.first.second, curve.first->second);
      }
  }

  bool is_feature(const Edge& e, const Facets_around& facets) const
  {
    if(facets.size() != 2 || facets[0].first != facets[1].first)
      return true;
    const Point& p = point(e.first);
    const Vector along = point(e.second) - p;
    const Vector a = CGAL::cross_product(along, point(facets[0].second) - p);
    const Vector b = CGAL::cross_product(point(facets[1].second) - p, along);
    return a * b < smallest_cosine_ * CGAL::sqrt((a * a) * (b * b));
  }

  // Adds the vertices where curves end or meet.
  void add_corners()
  {
    std::map<Vertex_handle, std::vector<Curve_index> > curves;
    for(auto e = c3t3_.edges_in_complex_begin(); e != c3t3_.edges_in_complex_end(); ++e)
      for(int i : { e->second, e->third })
        curves[e->first->vertex(i)].push_back(c3t3_.curve_index(*e));
    Corner_index last = Corner_index();
    for(auto v = c3t3_.vertices_in_complex_begin(); v != c3t3_.vertices_in_complex_end(); ++v)
      last = (std::max)(last, c3t3_.corner_index(v));
    for(const auto& v : curves)
      if((v.second.size() != 2 || v.second[0] != v.second[1]) && !c3t3_.is_in_complex(v.first))
        c3t3_.add_to_complex(v.first, ++last);
  }

  void set(Vertex_handle v, int dimension, const Index& index)
  {
    c3t3_.set_dimension(v, dimension);
    c3t3_.set_index(v, index);
  }

  // Indices of lower dimensions are set last.
  void set_indices()
  {
    const Triangulation& tr = c3t3_.triangulation();
    for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
      set(v, 3, Index(Subdomain_index()));
    for(auto c = c3t3_.cells_in_complex_begin(); c != c3t3_.cells_in_complex_end(); ++c)
      for(int i = 0; i < 4; ++i)
        set(c->vertex(i), 3, Index(c3t3_.subdomain_index(c)));
    for(auto f = c3t3_.facets_in_complex_begin(); f != c3t3_.facets_in_complex_end(); ++f)
      for(int k = 1; k < 4; ++k)
        set(f->first->vertex((f->second + k) % 4), 2, Index(c3t3_.surface_patch_index(*f)));
    for(auto e = c3t3_.edges_in_complex_begin(); e != c3t3_.edges_in_complex_end(); ++e)
      for(int i : { e->second, e->third })
        set(e->first->vertex(i), 1, Index(c3t3_.curve_index(*e)));
    for(auto v = c3t3_.vertices_in_complex_begin(); v != c3t3_.vertices_in_complex_end(); ++v)
      set(v, 0, Index(c3t3_.corner_index(v)));
  }

  C3t3& c3t3_;
  double smallest_cosine_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_COMPLEX_COMPLETION_3_H
