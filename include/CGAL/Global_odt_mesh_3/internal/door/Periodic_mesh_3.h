// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_PERIODIC_MESH_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_PERIODIC_MESH_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/door/C3t3_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Mesh_domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Periodic_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Mesh_3/config.h>
#include <CGAL/Time_stamper.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/exceptions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// A domain that is known in a cube, repeated in all directions. Segments are asked about where the mesh generator asks: with their
// lowest coordinates in the cube.
template <class Mesh_domain>
class Periodic_domain_3
{
public:
  typedef typename Mesh_domain::Index Index;
  typedef typename Mesh_domain::Subdomain_index Subdomain_index;
  typedef typename Mesh_domain::Surface_patch_index Surface_patch_index;
  typedef typename Mesh_domain::Point_3 Point_3;
  typedef typename Mesh_domain::Intersection Intersection;
  typedef typename Kernel_traits<Point_3>::Kernel::Segment_3 Segment_3;

  Periodic_domain_3(const Mesh_domain& domain, const Periodic_cube_3& cube)
    : domain_(domain)
    , cube_(cube)
  {}

  auto is_in_domain_object() const
  {
    return [this](const Point_3& p) { return domain_.is_in_domain_object()(point(cube_.canonical(coordinates(p)))); };
  }

  auto do_intersect_surface_object() const
  {
    return [this](const Segment_3& s) { return domain_.do_intersect_surface_object()(translated(s, periods(s))); };
  }

  auto construct_intersection_object() const
  {
    return [this](const Segment_3& s) -> Intersection
    {
      const Periods n = periods(s);
      const Intersection i = domain_.construct_intersection_object()(translated(s, n));
      return Intersection(translated(std::get<0>(i), Periods{} - n), std::get<1>(i), std::get<2>(i));
    };
  }

  Index index_from_surface_patch_index(const Surface_patch_index& patch) const { return domain_.index_from_surface_patch_index(patch); }
  Index index_from_subdomain_index(const Subdomain_index& s) const { return domain_.index_from_subdomain_index(s); }
  Surface_patch_index surface_patch_index(const Index& index) const { return domain_.surface_patch_index(index); }

private:
  static Point_3 point(const Vector_3& p) { return Point_3(p[0], p[1], p[2]); }

  Point_3 translated(const Point_3& p, const Periods& n) const { return point(cube_.translated(coordinates(p), n)); }
  Segment_3 translated(const Segment_3& s, const Periods& n) const { return Segment_3(translated(s.source(), n), translated(s.target(), n)); }

  Periods periods(const Segment_3& s) const
  {
    const Vector_3 p = coordinates(s.source()), q = coordinates(s.target());
    return cube_.periods_into(Vector_3((std::min)(p[0], q[0]), (std::min)(p[1], q[1]), (std::min)(p[2], q[2])), cube_.corner);
  }

  const Mesh_domain& domain_;
  Periodic_cube_3 cube_;
};

// Reads, rebuilds, and writes a c3t3 in a periodic triangulation of one sheet.
//
// Vertices stay, with all that the c3t3 says of them, and get their points. Cells are new.
template <class C3t3, class Mesh_domain>
class Periodic_mesh_3
{
public:
  typedef Mesh_domain_view_3<Periodic_domain_3<Mesh_domain> > Domain_view;
  typedef typename C3t3::Triangulation Triangulation;

  Periodic_mesh_3(C3t3& c3t3, Domain_view& domain)
    : c3t3_(c3t3)
    , domain_(domain)
  {}

  static Periodic_cube_3 cube(const Triangulation& tr)
  {
    return { coordinates((tr.domain().min)()), CGAL::to_double(tr.domain().xmax()) - CGAL::to_double(tr.domain().xmin()) };
  }

  bool is_domain_of_mesh() const
  {
    const Triangulation& tr = c3t3_.triangulation();
    return internal::is_domain_of_mesh(c3t3_, domain_, [&tr](Cell_handle c) { return std::array<Vector_3, 1>{{ coordinates(tr.dual(c)) }}; });
  }

  bool is_one_sheeted() const { return c3t3_.triangulation().number_of_vertices() > 0 && c3t3_.triangulation().is_1_cover(); }

  // Whether the domain says now what the mesh generator has been told of the complex that has been read.
  bool is_labelled_by_domain(const Periodic_complex_3& complex) const
  {
    const std::vector<Cell_handle> cells = all_cells(c3t3_.triangulation());
    for(std::size_t n = 0; n < cells.size(); ++n)
      if(complex.cells[n].label != domain_.label(coordinates(c3t3_.triangulation().dual(cells[n]))))
        return false;
    return true;
  }

  Periodic_complex_3 read()
  {
    static_assert(std::is_same<typename Triangulation::Geom_traits::FT, double>::value,
                  "as for Mesh_3, points are to have coordinates of type double");
    const Triangulation& tr = c3t3_.triangulation();
    Periodic_complex_3 complex;
    complex.cube = cube(tr);
    const std::vector<Cell_handle> cells = all_cells(tr);
    for(Cell_handle c : cells)
      domain_.number_subdomain(c->subdomain_index());
    for(auto v = tr.vertices_begin(); v != tr.vertices_end(); ++v)
    {
      vertices_.push_back(v);
      complex.sites.push_back(weighted_site(v->point()));
      complex.dimensions.push_back(is_dummy(*v, 0) ? -1 : v->in_dimension());
    }
    read_cells(tr, vertices_, cells, complex);
    for(std::size_t n = 0; n < cells.size(); ++n)
      complex.cells[n].label = domain_.number_subdomain(cells[n]->subdomain_index());
    read_facets(cells, complex);
    for(std::size_t v = 0; v < vertices_.size(); ++v)
      complex.patches.push_back(complex.dimensions[v] == 2 ? domain_.patch_at(vertices_[v]->index()) : int(Domain_view_3::other_patch));
    // A point of the lattice close to a surface gets dimension 2 from the mesh generator, but no patch.
    for(const Periodic_complex_3::Facet& f : complex.facets)
      for(int v : complex.facet_vertices(f))
        if(complex.dimensions[v] == 2 && complex.patches[v] == Domain_view_3::other_patch)
          complex.patches[v] = f.patch;
    return complex;
  }

  // The complex of these vertices. None if they have no triangulation of one sheet, or if the domain does not fit: where other
  // subdomains or patches than those of the mesh come up, or no surface between two subdomains; `in_doubt` tells the vertices there.
  std::optional<Periodic_complex_3> rebuild(const Periodic_complex_3& before, std::vector<Site> sites, std::vector<int>& in_doubt)
  {
    Triangulation tr(c3t3_.triangulation().domain());
    std::vector<Vertex_handle> vertices;
    if(!triangulate(sites, tr, vertices))
      return std::nullopt;
    Periodic_complex_3 complex;
    complex.cube = before.cube;
    complex.sites = std::move(sites);
    complex.dimensions = before.dimensions;
    complex.patches = before.patches;
    const std::vector<Cell_handle> cells = all_cells(tr);
    read_cells(tr, vertices, cells, complex);
    if(!label_cells(tr, cells, complex) || !find_facets(tr, cells, complex, in_doubt))
      return std::nullopt;
    return complex;
  }

  // Whatever may throw comes before the first change.
  void write(const Periodic_complex_3& complex)
  {
    std::vector<Index> indices;
    for(const Periodic_complex_3::Facet& f : complex.facets)
      indices.push_back(domain_.index(f.patch));
    Triangulation& tr = c3t3_.triangulation();
    const std::vector<Cell_handle> old_cells = all_cells(tr), cells = create_cells(complex.cells.size());
    take_out_of_complex(old_cells, c3t3_);
    for(Cell_handle c : old_cells)
      tr.tds().delete_cell(c);
    for(std::size_t v = 0; v < vertices_.size(); ++v)
      if(const Site& s = complex.sites[v]; !same_place(s, weighted_site(vertices_[v]->point())))
        vertices_[v]->set_point(weighted_point(s));
    for(std::size_t n = 0; n < cells.size(); ++n)
    {
      const Periodic_complex_3::Cell& c = complex.cells[n];
      for(int i = 0; i < 4; ++i)
      {
        cells[n]->set_vertex(i, vertices_[c.vertices[i]]);
        cells[n]->set_neighbor(i, cells[c.neighbors[i]]);
        vertices_[c.vertices[i]]->set_cell(cells[n]);
      }
      cells[n]->set_offsets(bits(c.offsets[0]), bits(c.offsets[1]), bits(c.offsets[2]), bits(c.offsets[3]));
      if(complex.is_inside(c))
        c3t3_.add_to_complex(cells[n], domain_.subdomain(c.label));
    }
    for(std::size_t n = 0; n < complex.facets.size(); ++n)
    {
      const Periodic_complex_3::Facet& f = complex.facets[n];
      write_facet(Facet(cells[f.cell], f.index), domain_.patch(f.patch), Bare_point(f.center[0], f.center[1], f.center[2]), indices[n], c3t3_);
    }
  }

private:
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Cell_handle Cell_handle;
  typedef typename Triangulation::Facet Facet;
  typedef typename Triangulation::Bare_point Bare_point;
  typedef typename Triangulation::Weighted_point Weighted_point;
  typedef typename Domain_view::Index Index;
  typedef typename Mesh_domain::Subdomain_index Subdomain_index;
  typedef CGAL::Hash_handles_with_or_without_timestamps Hash;

  // A facet by its vertices; it has no patch if it is not in the complex.
  struct Kept_facet
  {
    std::array<int, 2> labels;
    int patch;
    Vector_3 center;
  };

  static Weighted_point weighted_point(const Site& s) { return Weighted_point(Bare_point(s.x, s.y, s.z), s.weight); }

  // A point of the lattice with which the mesh generator begins. CGAL 6 gives it dimension 0, since it cannot know better.
  template <class Vertex>
  static auto is_dummy(const Vertex& v, int) -> decltype(bool(v.info().is_dummy_vertex)) { return v.info().is_dummy_vertex; }

  template <class Vertex>
  static bool is_dummy(const Vertex&, long) { return false; }

  // The offsets of a cell: zero or one period.
  static int bits(const Periods& n) { return 4 * n[0] + 2 * n[1] + n[2]; }

  // Reads the cells, without labels and facets.
  static void read_cells(const Triangulation& tr, const std::vector<Vertex_handle>& vertices, const std::vector<Cell_handle>& cells,
                         Periodic_complex_3& complex)
  {
    CGAL::Unique_hash_map<Vertex_handle, int, Hash> vertex_number(-1, vertices.size());
    for(std::size_t v = 0; v < vertices.size(); ++v)
      vertex_number[vertices[v]] = static_cast<int>(v);
    CGAL::Unique_hash_map<Cell_handle, int, Hash> cell_number(-1, cells.size());
    for(std::size_t n = 0; n < cells.size(); ++n)
      cell_number[cells[n]] = static_cast<int>(n);
    complex.cells.resize(cells.size());
    for(std::size_t n = 0; n < cells.size(); ++n)
      for(int i = 0; i < 4; ++i)
      {
        const auto offset = tr.get_offset(cells[n], i);
        complex.cells[n].vertices[i] = vertex_number[cells[n]->vertex(i)];
        complex.cells[n].neighbors[i] = cell_number[cells[n]->neighbor(i)];
        complex.cells[n].offsets[i] = {{ offset.x(), offset.y(), offset.z() }};
      }
  }

  // False if that needs several sheets or hides a vertex. Gives the vertices in the order of the sites.
  static bool triangulate(const std::vector<Site>& sites, Triangulation& tr, std::vector<Vertex_handle>& vertices)
  {
    std::vector<Weighted_point> points;
    std::map<std::array<double, 3>, std::size_t> number;
    for(const Site& s : sites)
    {
      number.emplace(std::array<double, 3>{{ s.x, s.y, s.z }}, points.size());
      points.push_back(weighted_point(s));
    }
    try
    {
      static_cast<typename Triangulation::Base&>(tr).insert(points.begin(), points.end(), true);
    }
    catch(const Failure_exception&)
    {
      return false;
    }
    if(!tr.is_1_cover() || tr.number_of_vertices() != sites.size())
      return false;
    vertices.resize(sites.size());
    for(auto v = tr.vertices_begin(); v != tr.vertices_end(); ++v)
    {
      const Site s = weighted_site(v->point());
      const auto it = number.find({{ s.x, s.y, s.z }});
      if(it == number.end())
        return false;
      vertices[it->second] = v;
    }
    return true;
  }

  bool label_cells(const Triangulation& tr, const std::vector<Cell_handle>& cells, Periodic_complex_3& complex) const
  {
    for(std::size_t n = 0; n < cells.size(); ++n)
    {
      complex.cells[n].label = domain_.label(coordinates(tr.dual(cells[n])));
      if(complex.cells[n].label == Domain_view_3::other_subdomain)
        return false;
    }
    return true;
  }

  // Reads the facets in the complex. Some facets are in the complex without separating subdomains, and some are not though they
  // separate some. These stay, and so do their vertices, unless cells have other labels than those of the domain.
  void read_facets(const std::vector<Cell_handle>& cells, Periodic_complex_3& complex)
  {
    for(std::size_t n = 0; n < cells.size(); ++n)
      for(int i = 0; i < 4; ++i)
      {
        Periodic_complex_3::Facet f = { static_cast<int>(n), i, Domain_view_3::other_patch, Vector_3() };
        const std::array<int, 2> labels = complex.labels(f);
        const bool is_in_complex = cells[n]->is_facet_on_surface(i);
        if(f.cell > complex.cells[n].neighbors[i] || (!is_in_complex && labels[0] == labels[1]))
          continue;
        if(is_in_complex)
        {
          f.patch = patch_between(labels, domain_.number_patch(cells[n]->surface_patch_index(i)));
          f.center = coordinates(cells[n]->get_facet_surface_center(i));
          complex.facets.push_back(f);
        }
        if(is_in_complex != (labels[0] != labels[1]))
          kept_facets_.insert(sorted(complex.facet_vertices(f)), { labels, f.patch, f.center });
      }
    if(!kept_facets_.entries().empty() && !is_labelled_by_domain(complex))
      kept_facets_ = {};
    for(const auto& f : kept_facets_.entries())
      for(int v : f.first)
        complex.dimensions[v] = 0;
  }

  bool find_facets(const Triangulation& tr, const std::vector<Cell_handle>& cells, Periodic_complex_3& complex,
                   std::vector<int>& in_doubt) const
  {
    Tuple_table<Triple, char> found;
    for(std::size_t n = 0; n < cells.size(); ++n)
      for(int i = 0; i < 4; ++i)
      {
        Periodic_complex_3::Facet f = { static_cast<int>(n), i, Domain_view_3::other_patch, Vector_3() };
        if(f.cell > complex.cells[n].neighbors[i])
          continue;
        const std::array<int, 2> labels = complex.labels(f);
        if(const Kept_facet* const k = kept_facets_.find(sorted(complex.facet_vertices(f))); k != nullptr && k->labels == labels)
        {
          found.insert(sorted(complex.facet_vertices(f)), true);
          f.patch = k->patch;
          f.center = k->center;
        }
        else if(labels[0] != labels[1] && !intersect(tr, Facet(cells[n], i), labels, f))
          for(int c : { f.cell, complex.cells[n].neighbors[i] })
            in_doubt.insert(in_doubt.end(), complex.cells[c].vertices.begin(), complex.cells[c].vertices.end());
        if(f.patch != Domain_view_3::other_patch)
          complex.facets.push_back(f);
      }
    for(const auto& k : kept_facets_.entries())
      if(found.find(k.first) == nullptr)
        in_doubt.insert(in_doubt.end(), k.first.begin(), k.first.end());
    return in_doubt.empty();
  }

  // Whether the domain has a patch of the mesh on the dual of a facet between two subdomains.
  bool intersect(const Triangulation& tr, const Facet& facet, const std::array<int, 2>& labels, Periodic_complex_3::Facet& f) const
  {
    Bare_point p, q;
    tr.dual_segment(facet, p, q);
    const Vector_3 from = coordinates(p), to = coordinates(q);
    f.center = (from + to) / 2;
    if(!domain_.intersect(f.center, (to - from).normalized(), (to - from).length() / 2, f.patch))
      return false;
    f.patch = patch_between(labels, f.patch);
    return f.patch != Domain_view_3::other_patch;
  }

  // Between two subdomains of a domain with labels, the patch is their pair: where three meet, the dual of a facet between two may
  // go through the third, and the domain may find a patch of that.
  int patch_between([[maybe_unused]] const std::array<int, 2>& labels, int found) const
  {
    if constexpr(Is_ordered_index<Subdomain_index>::value
                 && std::is_same<typename Mesh_domain::Surface_patch_index, std::pair<Subdomain_index, Subdomain_index> >::value)
      if(labels[0] != labels[1])
        return domain_.number_patch(std::minmax(domain_.subdomain(labels[0]), domain_.subdomain(labels[1])));
    return found;
  }

  // All or none.
  std::vector<Cell_handle> create_cells(std::size_t number)
  {
    std::vector<Cell_handle> cells;
    cells.reserve(number);
    try
    {
      while(cells.size() < number)
        cells.push_back(c3t3_.triangulation().tds().create_cell());
    }
    catch(...)
    {
      for(Cell_handle c : cells)
        c3t3_.triangulation().tds().delete_cell(c);
      throw;
    }
    return cells;
  }

  C3t3& c3t3_;
  Domain_view& domain_;
  std::vector<Vertex_handle> vertices_;
  Tuple_table<Triple, Kept_facet> kept_facets_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_PERIODIC_MESH_3_H
