// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_C3T3_VIEW_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_C3T3_VIEW_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/door/Created_elements.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Mesh_domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/door/User_constraints_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>

#include <CGAL/Time_stamper.h>
#include <CGAL/Unique_hash_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <set>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Takes cells with their facets out of the complex.
template <class C3t3>
void take_out_of_complex(const std::vector<typename C3t3::Cell_handle>& cells, C3t3& c3t3)
{
  c3t3.clear_manifold_info();
  for(typename C3t3::Cell_handle c : cells)
  {
    c3t3.remove_from_complex(c);
    for(int i = 0; i < 4; ++i)
      if(c->is_facet_on_surface(i))
        c3t3.remove_from_complex(c, i);
  }
}

// Adds a facet with its surface center, of which either cell knows.
template <class C3t3>
void write_facet(const typename C3t3::Facet& f, const typename C3t3::Surface_patch_index& patch,
                 const typename C3t3::Triangulation::Bare_point& center, const typename C3t3::Index& index, C3t3& c3t3)
{
  c3t3.add_to_complex(f, patch);
  for(const typename C3t3::Facet& g : { f, c3t3.triangulation().mirror_facet(f) })
  {
    g.first->set_facet_surface_center(g.second, center);
    g.first->set_facet_surface_center_index(g.second, index);
  }
}

template <class Cell>
std::array<Site, 4> sites_of(const Cell& c)
{
  std::array<Site, 4> s;
  for(int i = 0; i < 4; ++i)
    s[i] = weighted_site(c.vertex(i)->point());
  return s;
}

// Reads and writes a c3t3.
//
// Vertices and cells are read in an order that depends on positions alone, since files do not keep that of the triangulation.
// Vertices stay, with all that the c3t3 says of them, unless the table has removed them: they get their points. Those that have
// been inserted are created. Cells are new, in the memory of the old ones.
template <class C3t3, class Mesh_domain>
class C3t3_view_3
  : public User_mesh_view_3
{
public:
  typedef typename C3t3::Triangulation Triangulation;
  typedef typename Triangulation::Vertex_handle Vertex_handle;

  // `before_removal` is told of the vertices that are removed.
  C3t3_view_3(C3t3& c3t3, Mesh_domain_view_3<Mesh_domain>& domain, const User_constraints_3<C3t3>& constraints = User_constraints_3<C3t3>(),
              std::function<void(Vertex_handle)> before_removal = [](Vertex_handle) {})
    : c3t3_(c3t3)
    , domain_(domain)
    , constraints_(constraints)
    , before_removal_(std::move(before_removal))
  {
    static_assert(std::is_same<typename Triangulation::Geom_traits::FT, double>::value,
                  "as for Mesh_3, points are to have coordinates of type double");
  }

  // The vertex of that number in the table.
  Vertex_handle vertex(int n) const { return vertices_[n]; }
  bool has_vertex(int n) const { return static_cast<std::size_t>(n) < vertices_.size(); }

  Mesh_table_3 read(const Thread_policy& threads) override
  {
    Mesh_table_3 table;
    vertices_.clear();
    centers_.clear();
    kept_cells_.clear();
    const Triangulation& tr = c3t3_.triangulation();
    if(tr.dimension() != 3)
      return table;
    read_vertices(threads, table);
    const std::vector<Cell_handle> cells = read_cells(threads, table);
    for(std::size_t n = 0; n < cells.size(); ++n)
    {
      table.cells[n].label = domain_.number_subdomain(cells[n]->subdomain_index());
      table.cells[n].is_kept = constraints_.has(cells[n]);
      if(table.cells[n].is_kept)
        kept_cells_.push_back(sites_of(*cells[n]));
      for(int i = 0; i < 4; ++i)
        if(const Facet f(cells[n], is_mirrored_ && i < 2 ? 1 - i : i); f.first->is_facet_on_surface(f.second))
        {
          table.cells[n].facets |= 1 << i;
          table.cells[n].kept_facets |= int(constraints_.has(f)) << i;
          table.facets.push_back(read_facet(f, static_cast<int>(n), i));
        }
    }
    return table;
  }

  bool is_fixed(int vertex) const override
  {
    const Vertex_handle v = vertices_[vertex];
    return v->in_dimension() < 2 || weighted_site(v->point()).weight != 0 || constraints_.has(v);
  }

  int patch(int vertex) const override { return domain_.patch_at(vertices_[vertex]->index()); }

  bool is_changed() const override { return is_changed_; }
  bool keeps_cells() const override { return constraints_.has_cells(); }

  void release(const std::vector<Quadruple>& cells) override
  {
    std::vector<Cell_handle> handles;
    for(const Quadruple& v : cells)
    {
      released_cells_.push_back({{ vertices_[v[0]], vertices_[v[1]], vertices_[v[2]], vertices_[v[3]] }});
      const auto& w = released_cells_.back();
      handles.emplace_back();
      c3t3_.triangulation().is_cell(w[0], w[1], w[2], w[3], handles.back());
    }
    constraints_.release(handles);
  }

  // The cells that could not stay, by their vertices.
  const std::vector<std::array<Vertex_handle, 4> >& released_cells() const { return released_cells_; }

  // But for those that stay.
  std::size_t number_of_slivers(double bound) const override
  {
    const Angle_deficit_3 deficit(bound);
    const auto is_sliver = [&](const std::array<Site, 4>& sites) { return deficit(sites) > 0; };
    return std::count_if(c3t3_.cells_in_complex_begin(), c3t3_.cells_in_complex_end(), [&](const auto& c) { return is_sliver(sites_of(c)); })
           - std::count_if(kept_cells_.begin(), kept_cells_.end(), is_sliver);
  }

  // Files do not keep them, but the mesh generator protects features by balls, which overlap where they follow each other.
  std::vector<Mesh_table_3::Feature_edge> feature_edges() override
  {
    typedef Mesh_table_3::Feature_edge Feature_edge;
    const Vertex_numbers number = vertex_numbers();
    std::vector<Feature_edge> edges;
    std::vector<Vertex_handle> adjacent;
    for(std::size_t n = 0; n < vertices_.size(); ++n)
    {
      const Vertex_handle v = vertices_[n];
      adjacent.clear();
      if(is_on_feature(v))
        c3t3_.triangulation().finite_adjacent_vertices(v, std::back_inserter(adjacent));
      for(Vertex_handle w : adjacent)
      {
        if(number[w] < static_cast<int>(n) || !is_on_feature(w))
          continue;
        const std::array<int, 2> e = {{ static_cast<int>(n), number[w] }};
        if(c3t3_.is_in_complex(v, w))
          edges.push_back({ e, domain_.number_curve(c3t3_.curve_index(v, w)) });
        else if(do_balls_overlap(weighted_site(v->point()), weighted_site(w->point())))
          edges.push_back({ e, Feature_edge::no_curve });
      }
    }
    std::sort(edges.begin(), edges.end(), [](const Feature_edge& a, const Feature_edge& b) { return a.vertices < b.vertices; });
    return edges;
  }

  // Whatever may throw comes before the first change, and the visitor before anything else.
  void write(const Mesh_table_3& table) override
  {
    for(std::size_t v = 0; v < vertices_.size(); ++v)
      if(table.dimensions[v] == Mesh_table_3::removed)
        before_removal_(vertices_[v]);
    const std::vector<Center> centers = centers_of(table);
    Triangulation& tr = c3t3_.triangulation();
    std::vector<Cell_handle> cells = all_cells(tr);
    vertices_.reserve(table.sites.size());
    Created_elements<C3t3> created(c3t3_);
    create_inserted(table, created);
    const std::vector<Edge> split = split_edges(table, created);
    // At least one cell is made, since the first may make the container allocate memory.
    do
      created.create_cell();
    while(cells.size() + created.cells().size() < table.cells.size());
    cells.reserve(cells.size() + created.cells().size());

    created.keep();
    is_changed_ = true;
    for(const Edge& e : split)
      c3t3_.remove_from_complex(e.first, e.second);
    vertices_.insert(vertices_.end(), created.vertices().begin(), created.vertices().end());
    cells.insert(cells.end(), created.cells().begin(), created.cells().end());
    take_out_of_complex(cells, c3t3_);
    renew_cells(table.cells.size(), cells);
    connect_cells(table, vertices_, cells, tr);
    for(std::size_t v = 0; v < vertices_.size(); ++v)
      if(table.dimensions[v] != Mesh_table_3::removed)
        write_vertex(vertices_[v], table.sites[v], table.mean_circumradii[v]);
      else if(vertices_[v] != Vertex_handle())
        tr.tds().delete_vertex(vertices_[v]);
    for(std::size_t n = 0; n < cells.size(); ++n)
      if(table.cells[n].label != Domain_view_3::outside)
        c3t3_.add_to_complex(cells[n], domain_.subdomain(table.cells[n].label));
    for(std::size_t n = 0; n < centers.size(); ++n)
      write_facet(Facet(cells[table.facets[n].cell], table.facets[n].index), domain_.patch(table.facets[n].patch), centers[n].first,
                  centers[n].second, c3t3_);
  }

private:
  typedef typename Triangulation::Cell_handle Cell_handle;
  typedef typename Triangulation::Facet Facet;
  typedef typename Triangulation::Bare_point Bare_point;
  typedef typename Mesh_domain_view_3<Mesh_domain>::Index Index;
  typedef CGAL::Hash_handles_with_or_without_timestamps Hash;
  typedef CGAL::Unique_hash_map<Vertex_handle, int, Hash> Vertex_numbers;
  // The surface center of a facet, as a cell has it.
  typedef std::pair<Bare_point, Index> Center;
  typedef std::pair<Vertex_handle, Vertex_handle> Edge;

  void create_inserted(const Mesh_table_3& table, Created_elements<C3t3>& created) const
  {
    for(std::size_t n = vertices_.size(); n < table.sites.size(); ++n)
    {
      const Vertex_handle v = created.create_vertex(table.dimensions[n] == Mesh_table_3::removed);
      if(v == Vertex_handle())
        continue;
      const int place = table.inserted[n - vertices_.size()];
      c3t3_.set_dimension(v, table.dimensions[n]);
      c3t3_.set_index(v, domain_.index(table.dimensions[n], place));
    }
  }

  // Adds the parts of feature edges that have been split, and tells which edges these are.
  std::vector<Edge> split_edges(const Mesh_table_3& table, Created_elements<C3t3>& created) const
  {
    const int first_created = static_cast<int>(vertices_.size());
    const auto vertex = [&](int v) { return v < first_created ? vertices_[v] : created.vertices()[v - first_created]; };
    std::set<Edge> edges;
    bool are_split = false;
    for(const Mesh_table_3::Feature_edge& e : table.feature_edges)
    {
      const Vertex_handle v = vertex(e.vertices[0]), w = vertex(e.vertices[1]);
      edges.insert(std::minmax(v, w));
      if(e.vertices[1] < first_created)
        continue;
      are_split = true;
      created.create_edge(v, w, domain_.curve(e.curve));
    }
    std::vector<Edge> split;
    if(are_split)
      for(auto e = c3t3_.edges_in_complex_begin(); e != c3t3_.edges_in_complex_end(); ++e)
        if(const Edge whole = std::minmax(e->first->vertex(e->second), e->first->vertex(e->third)); edges.count(whole) == 0)
          split.push_back(whole);
    return split;
  }

  static bool is_on_feature(Vertex_handle v) { return v->in_dimension() == 0 || v->in_dimension() == 1; }

  static bool do_balls_overlap(const Site& a, const Site& b)
  { return squared_distance(a, position(b)) < std::pow(std::sqrt(a.weight) + std::sqrt(b.weight), 2); }

  static Bare_point point(const Vector_3& p) { return Bare_point(p[0], p[1], p[2]); }

  void read_vertices(const Thread_policy& threads, Mesh_table_3& table)
  {
    std::vector<std::pair<Site, Vertex_handle> > vertices;
    for(auto v = c3t3_.triangulation().finite_vertices_begin(); v != c3t3_.triangulation().finite_vertices_end(); ++v)
      vertices.emplace_back(weighted_site(v->point()), v);
    threads.sort(vertices.begin(), vertices.end(), [](const auto& a, const auto& b)
                 { return std::tie(a.first.x, a.first.y, a.first.z) < std::tie(b.first.x, b.first.y, b.first.z); });
    for(const auto& v : vertices)
    {
      vertices_.push_back(v.second);
      table.sites.push_back(v.first);
      table.dimensions.push_back(v.second->in_dimension());
    }
  }

  Vertex_numbers vertex_numbers() const
  {
    Vertex_numbers number(int(Mesh_table_3::infinite), vertices_.size());
    for(std::size_t v = 0; v < vertices_.size(); ++v)
      number[vertices_[v]] = static_cast<int>(v);
    return number;
  }

  // Their vertices keep the order that they have there, on which dual points of flat cells depend.
  std::vector<Cell_handle> read_cells(const Thread_policy& threads, Mesh_table_3& table)
  {
    const Vertex_numbers vertex_number = vertex_numbers();
    std::vector<Cell_handle> cells = all_cells(c3t3_.triangulation());
    const auto vertices = [&](Cell_handle c)
    {
      const Vertex_numbers& number = vertex_number;
      return Quadruple{{ number[c->vertex(0)], number[c->vertex(1)], number[c->vertex(2)], number[c->vertex(3)] }};
    };
    std::vector<std::pair<Quadruple, Cell_handle> > order(cells.size());
    for_each_in_chunks(static_cast<int>(cells.size()), threads, [&](int n) { order[n] = { sorted(vertices(cells[n])), cells[n] }; });
    threads.sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    CGAL::Unique_hash_map<Cell_handle, int, Hash> numbers(-1, cells.size());
    for(std::size_t n = 0; n < cells.size(); ++n)
    {
      cells[n] = order[n].second;
      numbers[cells[n]] = static_cast<int>(n);
    }
    table.cells.resize(cells.size());
    for_each_in_chunks(static_cast<int>(cells.size()), threads, [&, &number = std::as_const(numbers)](int n)
    {
      table.cells[n].vertices = vertices(cells[n]);
      for(int i = 0; i < 4; ++i)
        table.cells[n].neighbors[i] = number[cells[n]->neighbor(i)];
    });
    turn_over_mirrored(table);
    return cells;
  }

  // Some programs number the vertices of their tetrahedra the other way round.
  void turn_over_mirrored(Mesh_table_3& table)
  {
    double volume = 0;
    for(const Mesh_table_3::Cell& c : table.cells)
      if(index_of(c.vertices, int(Mesh_table_3::infinite)) == 4)
      {
        const std::array<Site, 4> s = table.cell_sites(c.vertices);
        volume += Cell_products(s[0], s[1], s[2], s[3]).determinant;
      }
    is_mirrored_ = volume < 0;
    for(Mesh_table_3::Cell& c : table.cells)
      if(is_mirrored_)
      {
        std::swap(c.vertices[0], c.vertices[1]);
        std::swap(c.neighbors[0], c.neighbors[1]);
      }
  }

  Mesh_table_3::Facet read_facet(const Facet& f, int n, int i)
  {
    centers_.emplace_back(f.first->get_facet_surface_center(f.second), f.first->get_facet_surface_center_index(f.second));
    return { n, i, domain_.number_patch(f.first->surface_patch_index(f.second)), static_cast<int>(centers_.size()) - 1, Vector_3(), 0 };
  }

  std::vector<Center> centers_of(const Mesh_table_3& table) const
  {
    std::vector<Center> centers;
    for(const Mesh_table_3::Facet& f : table.facets)
      centers.push_back(f.source != Mesh_table_3::no_facet ? centers_[f.source]
                                                           : Center(point(f.center), domain_.index(f.patch_of_center)));
    return centers;
  }

  // Erased in the opposite order, they come back in the same one.
  void renew_cells(std::size_t number, std::vector<Cell_handle>& cells)
  {
    auto& tds = c3t3_.triangulation().tds();
    std::for_each(cells.rbegin(), cells.rend(), [&tds](Cell_handle c) { tds.cells().erase(c); });
    cells.resize(number);
    for(Cell_handle& c : cells)
      c = tds.create_cell();
  }

  // A vertex that has not moved keeps its point. The radius is what CGAL's optimizers leave there.
  static void write_vertex(Vertex_handle v, const Site& s, double mean_circumradius)
  {
    if(const Site before = weighted_site(v->point()); !same_place(s, before) || s.weight != before.weight)
      v->set_point(typename Triangulation::Weighted_point(Bare_point(s.x, s.y, s.z), s.weight));
    if(mean_circumradius > 0)
      v->set_meshing_info(mean_circumradius);
  }

  C3t3& c3t3_;
  Mesh_domain_view_3<Mesh_domain>& domain_;
  User_constraints_3<C3t3> constraints_;
  std::function<void(Vertex_handle)> before_removal_;
  bool is_mirrored_ = false;                  // the input
  std::vector<Vertex_handle> vertices_;
  std::vector<Center> centers_;               // by the numbers of facets in the table
  std::vector<std::array<Site, 4> > kept_cells_;
  std::vector<std::array<Vertex_handle, 4> > released_cells_;
  bool is_changed_ = false;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_C3T3_VIEW_3_H
