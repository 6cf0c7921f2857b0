// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_EXAMPLES_COMPLEX_OF_MEDIT_MESH_H
#define GLOBAL_ODT_MESH_3_EXAMPLES_COMPLEX_OF_MEDIT_MESH_H

#include "medit_mesh.h"
#include "triangulation_of_cells.h"

#include <CGAL/complete_mesh_complex_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

// The positive indices that stand for references: these themselves if they are such indices, which 0 is not, or else others.
class Reference_table
{
public:
  typedef Medit_mesh::Reference Reference;

  Reference_table() = default;

  // Of elements that are given along with their references.
  template <class Element>
  explicit Reference_table(const std::vector<std::pair<Element, Reference> >& elements)
  {
    std::set<Reference> references;
    for(const auto& e : elements)
      references.insert(e.second);
    constexpr Reference most = 1000000000;
    const bool are_indices = references.empty() || (*references.begin() > 0 && *references.rbegin() <= most);
    for(Reference r : references)
    {
      last_ = are_indices ? static_cast<int>(r) : last_ + 1;
      indices_[r] = last_;
      references_[last_] = r;
    }
    if(!references.empty())
      last_reference_ = (std::max)(last_reference_, *references.rbegin());
  }

  int index(Reference r) const { return indices_.at(r); }

  // Indices that have been added to a complex stand for references greater than all there are.
  Reference reference(int index) const
  { return index > last_ ? last_reference_ + (index - last_) : references_.at(index); }

private:
  std::map<Reference, int> indices_;
  std::map<int, Reference> references_;
  int last_ = 0;
  Reference last_reference_ = 0;
};

// The complex of a mesh from a file of Medit, and the file that is made of it later.
template <class C3t3>
class Complex_of_medit_mesh
{
public:
  typedef typename C3t3::Vertex_handle Vertex_handle;

  // Keeps references to both. Throws std::runtime_error if cells do not fit together.
  Complex_of_medit_mesh(const Medit_mesh& mesh, C3t3& c3t3, double feature_angle)
    : mesh_(mesh)
    , c3t3_(c3t3)
  {
    build();
    add_triangles();
    add_edges();
    int corner = 0;
    for(int v : mesh.corners)
      if(const Vertex_handle w = vertex(v); w != Vertex_handle() && !c3t3.is_in_complex(w))
        c3t3.add_to_complex(w, ++corner);
    CGAL::complete_mesh_complex_3(c3t3, feature_angle);
    for(int v : mesh.required_vertices)
      require(v);
    for(int e : mesh.required_edges)
      for(int v : mesh.edges[static_cast<std::size_t>(e)].vertices)
        require(v);
    for(int t : mesh.required_triangles)
      for(int v : mesh.triangles[static_cast<std::size_t>(t)].vertices)
        require(v);
    find_required_facets();
  }

  // The vertices that have to stay where they are, since the file says so of them, or of edges or triangles.
  const std::set<Vertex_handle>& required_vertices() const { return required_; }

  // The facets that have to stay. Each is there once, and as long as its cell is.
  const std::set<typename C3t3::Facet>& required_facets() const { return required_facets_; }

  // The index of the patch of the triangles with this reference; such triangles must be in the complex.
  int patch_index(Medit_mesh::Reference reference) const { return patches_.index(reference); }

  // How many triangles and edges of the file the complex does not have.
  std::size_t number_of_lost_triangles() const { return lost_triangles_; }
  std::size_t number_of_lost_edges() const { return lost_edges_; }

  // Has to be told before a vertex goes.
  void before_vertex_removal(Vertex_handle v)
  {
    const auto it = numbers_.find(v);
    if(it == numbers_.end())
      return;
    vertices_[it->second] = Vertex_handle();
    numbers_.erase(it);
  }

  // What the complex is now. Vertices are in the order of the file, and those that have been inserted follow.
  Medit_mesh to_medit() const
  {
    Medit_mesh out;
    std::map<Vertex_handle, int> numbers;
    const std::vector<int> renumbered = write_vertices(out, numbers);
    for(auto c = c3t3_.cells_in_complex_begin(); c != c3t3_.cells_in_complex_end(); ++c)
    {
      out.tetrahedra.push_back({ {}, labels_.reference(c3t3_.subdomain_index(c)) });
      for(int i = 0; i < 4; ++i)
        out.tetrahedra.back().vertices[static_cast<std::size_t>(i)] = numbers[c->vertex(i)];
    }
    write_triangles(out, numbers);
    for(auto e = c3t3_.edges_in_complex_begin(); e != c3t3_.edges_in_complex_end(); ++e)
      out.edges.push_back({ {{ numbers[e->first->vertex(e->second)], numbers[e->first->vertex(e->third)] }},
                            curves_.reference(c3t3_.curve_index(*e)) });
    for(auto v = c3t3_.vertices_in_complex_begin(); v != c3t3_.vertices_in_complex_end(); ++v)
      out.corners.push_back(numbers[v]);
    std::sort(out.corners.begin(), out.corners.end());
    for(int v : mesh_.required_vertices)
      if(renumbered[static_cast<std::size_t>(v)] >= 0)
        out.required_vertices.push_back(renumbered[static_cast<std::size_t>(v)]);
    out.ridges = find(mesh_.ridges, mesh_.edges, renumbered, out.edges);
    out.required_edges = find(mesh_.required_edges, mesh_.edges, renumbered, out.edges);
    out.required_triangles = find(mesh_.required_triangles, mesh_.triangles, renumbered, out.triangles);
    return out;
  }

private:
  typedef typename C3t3::Triangulation Triangulation;
  typedef typename C3t3::Facet Facet;
  typedef typename Triangulation::Bare_point Point;

  Vertex_handle vertex(int n) const { return vertices_[static_cast<std::size_t>(n)]; }
  int number(Vertex_handle v) const { return static_cast<int>(numbers_.at(v)); }

  void require(int n)
  {
    if(vertex(n) != Vertex_handle())
      required_.insert(vertex(n));
  }

  template <std::size_t n>
  static std::array<int, n> sorted(std::array<int, n> vertices)
  {
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  }

  // By their vertices.
  template <std::size_t n>
  static std::map<std::array<int, n>, Medit_mesh::Reference>
  references_of(const std::vector<Medit_mesh::Element<n> >& elements)
  {
    std::map<std::array<int, n>, Medit_mesh::Reference> result;
    for(const auto& e : elements)
      result.emplace(sorted(e.vertices), e.reference);
    return result;
  }

  // The numbers of its vertices, sorted.
  std::array<int, 3> vertices(const Facet& f) const
  {
    const auto at = [&](int k) { return number(f.first->vertex((f.second + k) % 4)); };
    return sorted(std::array<int, 3>{{ at(1), at(2), at(3) }});
  }

  std::set<std::array<int, 3> > required_triangles() const
  {
    std::set<std::array<int, 3> > required;
    for(int t : mesh_.required_triangles)
      required.insert(sorted(mesh_.triangles[static_cast<std::size_t>(t)].vertices));
    return required;
  }

  void find_required_facets()
  {
    const std::set<std::array<int, 3> > required = required_triangles();
    if(required.empty())
      return;
    for(auto f = c3t3_.facets_in_complex_begin(); f != c3t3_.facets_in_complex_end(); ++f)
      if(required.count(vertices(*f)) > 0)
        required_facets_.insert(*f);
  }

  void build()
  {
    std::vector<Point> points;
    for(const auto& p : mesh_.points)
      points.emplace_back(p[0], p[1], p[2]);
    std::vector<std::array<int, 4> > vertices;
    for(const auto& t : mesh_.tetrahedra)
      vertices.push_back(t.vertices);
    Triangulation_of_cells<Triangulation> builder(points, vertices);
    builder.build(c3t3_.triangulation());
    std::vector<std::pair<typename C3t3::Cell_handle, Medit_mesh::Reference> > cells;
    for(std::size_t n = 0; n < vertices.size(); ++n)
      cells.emplace_back(builder.cells[n], mesh_.tetrahedra[n].reference);
    labels_ = Reference_table(cells);
    for(const auto& c : cells)
      c3t3_.add_to_complex(c.first, labels_.index(c.second));
    vertices_ = std::move(builder.vertices);
    for(std::size_t v = 0; v < vertices_.size(); ++v)
      if(vertices_[v] != Vertex_handle())
        numbers_[vertices_[v]] = v;
  }

  // Triangles and edges of no tetrahedron are left out. So are triangles of reference 0 that divide nothing, of which TetGen
  // writes all there are.
  void add_triangles()
  {
    const auto references = references_of(mesh_.triangles);
    const std::set<std::array<int, 3> > required = required_triangles();
    std::vector<std::pair<Facet, Medit_mesh::Reference> > facets;
    const Triangulation& tr = c3t3_.triangulation();
    for(auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f)
    {
      const auto it = references.find(vertices(*f));
      const bool divides = f->first->subdomain_index() != tr.mirror_facet(*f).first->subdomain_index();
      if(it != references.end() && (it->second != 0 || divides || required.count(it->first) > 0))
        facets.emplace_back(*f, it->second);
    }
    lost_triangles_ = references.size() - facets.size();
    patches_ = Reference_table(facets);
    for(const auto& f : facets)
      c3t3_.add_to_complex(f.first, patches_.index(f.second));
  }

  void add_edges()
  {
    const auto references = references_of(mesh_.edges);
    std::vector<std::pair<std::pair<Vertex_handle, Vertex_handle>, Medit_mesh::Reference> > edges;
    const Triangulation& tr = c3t3_.triangulation();
    for(auto e = tr.finite_edges_begin(); e != tr.finite_edges_end(); ++e)
    {
      const Vertex_handle v = e->first->vertex(e->second), w = e->first->vertex(e->third);
      const auto it = references.find(sorted(std::array<int, 2>{{ number(v), number(w) }}));
      if(it != references.end())
        edges.emplace_back(std::make_pair(v, w), it->second);
    }
    lost_edges_ = references.size() - edges.size();
    curves_ = Reference_table(edges);
    for(const auto& e : edges)
      c3t3_.add_to_complex(e.first.first, e.first.second, curves_.index(e.second));
  }

  // Returns the numbers that vertices of the file have now, or -1. Points that no tetrahedron has stay.
  std::vector<int> write_vertices(Medit_mesh& out, std::map<Vertex_handle, int>& numbers) const
  {
    std::vector<int> renumbered(vertices_.size(), -1);
    const auto add = [&](const std::array<double, 3>& p, Medit_mesh::Reference reference)
    {
      out.points.push_back(p);
      out.point_references.push_back(reference);
      return static_cast<int>(out.points.size()) - 1;
    };
    const auto position = [](Vertex_handle v)
    {
      const Point& p = v->point().point();
      return std::array<double, 3>{{ p.x(), p.y(), p.z() }};
    };
    std::vector<bool> has_cell(mesh_.points.size(), false);
    for(const auto& t : mesh_.tetrahedra)
      for(int v : t.vertices)
        has_cell[static_cast<std::size_t>(v)] = true;
    for(std::size_t v = 0; v < vertices_.size(); ++v)
      if(!has_cell[v])
        renumbered[v] = add(mesh_.points[v], mesh_.point_references[v]);
      else if(vertices_[v] != Vertex_handle())
        renumbered[v] = numbers[vertices_[v]] = add(position(vertices_[v]), mesh_.point_references[v]);
    const Triangulation& tr = c3t3_.triangulation();
    for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
      if(numbers.count(v) == 0)
        numbers[v] = add(position(v), 0);
    return renumbered;
  }

  // Counterclockwise as seen from outside, or from the side of the greater index.
  void write_triangles(Medit_mesh& out, std::map<Vertex_handle, int>& numbers) const
  {
    for(auto f = c3t3_.facets_in_complex_begin(); f != c3t3_.facets_in_complex_end(); ++f)
    {
      const Facet g = c3t3_.triangulation().mirror_facet(*f);
      const int label = f->first->subdomain_index(), other = g.first->subdomain_index();
      const bool is_inside = label > 0 && (other <= 0 || label <= other);
      const Facet& seen = is_inside ? *f : g;
      std::array<int, 3> v;
      for(int k = 0; k < 3; ++k)
        v[static_cast<std::size_t>(k)] = numbers[seen.first->vertex(Triangulation::vertex_triple_index(seen.second, 2 - k))];
      out.triangles.push_back({ v, patches_.reference(c3t3_.surface_patch_index(*f)) });
    }
  }

  // The numbers that some elements have among others.
  template <std::size_t n>
  static std::vector<int> find(const std::vector<int>& some, const std::vector<Medit_mesh::Element<n> >& elements,
                               const std::vector<int>& renumbered, const std::vector<Medit_mesh::Element<n> >& others)
  {
    std::map<std::array<int, n>, int> numbers;
    if(!some.empty())
      for(std::size_t k = 0; k < others.size(); ++k)
        numbers[sorted(others[k].vertices)] = static_cast<int>(k);
    std::vector<int> result;
    for(int k : some)
    {
      std::array<int, n> v = elements[static_cast<std::size_t>(k)].vertices;
      for(int& w : v)
        w = renumbered[static_cast<std::size_t>(w)];
      const auto it = numbers.find(sorted(v));
      if(it != numbers.end())
        result.push_back(it->second);
    }
    return result;
  }

  const Medit_mesh& mesh_;
  C3t3& c3t3_;
  Reference_table labels_, patches_, curves_;
  std::vector<Vertex_handle> vertices_;               // by their numbers in the file, if there are any
  std::map<Vertex_handle, std::size_t> numbers_;
  std::set<Vertex_handle> required_;
  std::set<Facet> required_facets_;
  std::size_t lost_triangles_ = 0, lost_edges_ = 0;
};

#endif // GLOBAL_ODT_MESH_3_EXAMPLES_COMPLEX_OF_MEDIT_MESH_H
