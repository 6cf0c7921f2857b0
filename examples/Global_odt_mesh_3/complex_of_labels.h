// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_EXAMPLES_COMPLEX_OF_LABELS_H
#define GLOBAL_ODT_MESH_3_EXAMPLES_COMPLEX_OF_LABELS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/number_utils.h>
#include <CGAL/version.h>

// In 5.5, read_MEDIT() does not include what it calls.
#if CGAL_VERSION_NR < 1050600000
#  include <CGAL/Mesh_3/tet_soup_to_c3t3.h>
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

// What a mesh complex has beyond cells with labels: patches, which lie between each two labels, features, and the dimensions of vertices.
template <class C3t3, class Domain>
class Complex_of_labels
{
public:
  typedef typename Domain::Polyhedron Polyhedron;
  typedef std::pair<int, int> Labels;       // inside and outside of a surface

  explicit Complex_of_labels(C3t3& c3t3)
    : c3t3_(c3t3)
  {
    Tr& tr = c3t3.triangulation();
    for(auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
      for(int i = 0; i < 4; ++i)
        c->set_surface_patch_index(i, 0);
    c3t3.rescan_after_load_of_triangulation();
    std::map<Labels, std::vector<Facet> > facets;
    for(auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f)
    {
      const Facet g = tr.mirror_facet(*f);
      const int label = f->first->subdomain_index(), other = g.first->subdomain_index();
      if(label != other)
        facets[Labels((std::max)(label, other), (std::min)(label, other))].push_back(label > other ? *f : g);
    }
    for(const auto& f : facets)
    {
      labels_.push_back(f.first);
      patches_.push_back(f.second);
      surfaces_.push_back(surface(f.second));
    }
  }

  // Of the domain that the mesh fills; the index of a patch is its place, from 1.
  const std::vector<Polyhedron>& surfaces() const { return surfaces_; }
  const std::vector<Labels>& labels() const { return labels_; }

  // Edges are features if they bound patches, or if facets meet there at an angle with a cosine below that.
  void complete(const Domain& domain, double smallest_cosine = 0.5)
  {
    Tr& tr = c3t3_.triangulation();
    for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
      set(v, 3, domain.index_from_subdomain_index(v->cell()->subdomain_index()));
    std::map<Edge, Facets_around> around;
    for(std::size_t n = 0; n < patches_.size(); ++n)
      for(const Facet& f : patches_[n])
        add_facet(f, static_cast<int>(n) + 1, domain, around);
    std::map<std::set<int>, int> curves;                  // by the patches that meet there
    std::map<Vertex_handle, std::vector<int> > at_vertex; // the curves of edges
    for(const auto& e : around)
      if(is_feature(e.second, smallest_cosine))
      {
        std::set<int> patches;
        for(const auto& f : e.second)
          patches.insert(f.first);
        const int curve = curves.emplace(patches, static_cast<int>(curves.size()) + 1).first->second;
        c3t3_.add_to_complex(e.first[0], e.first[1], curve);
        for(Vertex_handle v : e.first)
          at_vertex[v].push_back(curve);
      }
    int corner = 0;
    for(const auto& v : at_vertex)
      if(v.second.size() == 2 && v.second[0] == v.second[1])
        set(v.first, 1, domain.index_from_curve_index(v.second[0]));
      else
      {
        c3t3_.add_to_complex(v.first, ++corner);
        set(v.first, 0, domain.index_from_corner_index(corner));
      }
  }

private:
  typedef typename C3t3::Triangulation Tr;
  typedef typename Tr::Facet Facet;
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef typename Domain::Point_3 Point;
  typedef typename Domain::R::Vector_3 Vector;
  typedef std::array<Vertex_handle, 2> Edge;
  typedef std::vector<std::pair<int, Vector> > Facets_around;     // patches and normals

  static const Point& point(Vertex_handle v) { return v->point().point(); }

  template <class Vertex, class Index>
  void set(Vertex v, int dimension, const Index& index)
  {
    c3t3_.set_dimension(v, dimension);
    c3t3_.set_index(v, index);
  }

  void add_facet(const Facet& f, int patch, const Domain& domain, std::map<Edge, Facets_around>& around)
  {
    c3t3_.add_to_complex(f, patch);
    const std::array<Vertex_handle, 3> t = vertices(f);
    const Vector normal = CGAL::cross_product(point(t[1]) - point(t[0]), point(t[2]) - point(t[0]));
    for(int k = 0; k < 3; ++k)
    {
      const Vertex_handle v = t[k], w = t[(k + 1) % 3];
      set(v, 2, domain.index_from_surface_patch_index(patch));
      around[Edge{{ (std::min)(v, w), (std::max)(v, w) }}].emplace_back(patch, normal);
    }
  }

  static bool is_feature(const Facets_around& f, double smallest_cosine)
  {
    if(f.size() != 2 || f[0].first != f[1].first)
      return true;
    const Vector &a = f[0].second, &b = f[1].second;
    return a * b < smallest_cosine * CGAL::sqrt((a * a) * (b * b));
  }

  // Counterclockwise, seen from outside of the cell.
  static std::array<Vertex_handle, 3> vertices(const Facet& f)
  {
    std::array<Vertex_handle, 3> t;
    for(int k = 0; k < 3; ++k)
      t[k] = f.first->vertex((f.second + k + 1) % 4);
    if(CGAL::orientation(point(t[0]), point(t[1]), point(t[2]), point(f.first->vertex(f.second))) == CGAL::POSITIVE)
      std::swap(t[1], t[2]);
    return t;
  }

  static Polyhedron surface(const std::vector<Facet>& facets)
  {
    std::vector<Point> points;
    std::vector<std::vector<std::size_t> > triangles;
    std::map<Vertex_handle, std::size_t> number;
    for(const Facet& f : facets)
    {
      triangles.emplace_back();
      for(Vertex_handle v : vertices(f))
      {
        const auto it = number.emplace(v, points.size());
        if(it.second)
          points.push_back(point(v));
        triangles.back().push_back(it.first->second);
      }
    }
    // Divides edges and vertices where the patch is no manifold.
    CGAL::Polygon_mesh_processing::orient_polygon_soup(points, triangles);
    Polyhedron polyhedron;
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, triangles, polyhedron);
    return polyhedron;
  }

  C3t3& c3t3_;
  std::vector<Labels> labels_;
  std::vector<std::vector<Facet> > patches_;    // seen from the greater label
  std::vector<Polyhedron> surfaces_;
};

#endif // GLOBAL_ODT_MESH_3_EXAMPLES_COMPLEX_OF_LABELS_H
