// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_C3T3_BRIDGE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_C3T3_BRIDGE_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_dual_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Point_coordinates.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Spatial_order.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Domain_oracle_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Numbered_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flat_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flatten_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <CGAL/Time_stamper.h>
#include <CGAL/Unique_hash_map.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The way from a c3t3 to the flat problem, and back from new positions to a
// c3t3 that keeps every promise of the first. In between, the complex may go
// through several states. The input is only changed by a swap at the end.
template <class C3t3, class Mesh_domain>
class C3t3_bridge_3
{
  typedef typename C3t3::Triangulation Triangulation;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Cell_handle Cell_handle;
  typedef typename Triangulation::Facet Facet;
  typedef typename Triangulation::Bare_point Bare_point;
  typedef typename C3t3::Subdomain_index Subdomain_index;
  typedef typename C3t3::Surface_patch_index Surface_patch_index;
  typedef CGAL::Unique_hash_map<Vertex_handle, int, CGAL::Hash_handles_with_or_without_timestamps> Site_map;
  typedef std::vector<Constrained_facet<Triangulation> > Constrained_facets;

public:
  typedef Restricted_complex_3<Triangulation, Mesh_domain> Complex;
  typedef Restricted_triangulation_3<Triangulation, Mesh_domain> Restricted_triangulation;
  typedef typename Restricted_triangulation::Update Update;

  C3t3_bridge_3(C3t3& c3t3, const Mesh_domain& domain)
    : c3t3_(c3t3)
    , restricted_triangulation_(domain)
    , complex_(restricted_triangulation_.complex())
  {}

  const Complex& complex() const { return complex_; }
  const Oracle_statistics& oracle_statistics() const { return restricted_triangulation_.oracle_statistics(); }

  // The vertex with this number, in the c3t3.
  Vertex_handle input_vertex(int v) const { return input_vertices_[v]; }

  // Loads the complex. Vertices of the interior move, unless a boundary facet
  // touches them; those that surfaces run smoothly through move if `boundary_moves`.
  void load(Moving_triangulation_3& mesh, bool boundary_moves)
  {
    const Triangulation& tr = c3t3_.triangulation();
    mesh = Moving_triangulation_3();
    if(tr.dimension() != 3)
      return;
    for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
    {
      site_[v] = static_cast<int>(complex_.vertices.size());
      complex_.vertices.push_back(v);
      complex_.sites.push_back(weighted_site(tr.point(v)));
    }
    complex_.triangulation = &tr;
    Constrained_facets constrained_facets = flatten([this](Vertex_handle v) { return site_[v]; }, mesh.topology);
    const std::vector<int> place = sort_vertices(constrained_facets, mesh.topology, boundary_moves);
    mesh.topology.renumber_vertices(place);
    for(Constrained_facet<Triangulation>& w : constrained_facets)
      for(int& v : w.vertices)
        v = place[v];
    input_vertices_ = complex_.vertices;
    complex_.boundary = boundary(constrained_facets);
    complex_.boundary.measure_umbrellas(complex_.sites);
    read_surface_centers(constrained_facets);
    read_labels();
    if(boundary_moves)
      restricted_triangulation_.measure_fidelity();
    finish(constrained_facets, mesh);
  }

  // Loads the state that store() has led to.
  void reload(Moving_triangulation_3& mesh) const
  {
    const bool is_input = !complex_.has_changed();
    const auto number = [&](Vertex_handle v)
    { return is_input ? site_[v] : Numbered_triangulation_3<Triangulation>::number(v); };
    finish(flatten(number, mesh.topology), mesh);
  }

  // Moves a site for a surface vertex to the surface; false if that cannot be done.
  bool put_on_surface(int v, Site& s) { return restricted_triangulation_.put_on_surface(v, s); }

  // Whether that is close enough to a polyhedral surface for the centroid of a boundary facet.
  bool is_close_to_surface(const std::array<double, 3>& point)
  {
    return restricted_triangulation_.is_close_to_surface(point);
  }

  bool is_rough() { return restricted_triangulation_.is_rough(); }

  // Takes the complex to the positions of the movable vertices; false if no valid
  // complex can be made of them, and the complex is as it was.
  bool store(const Moving_triangulation_3& mesh, const Update& mode)
  {
    return restricted_triangulation_.update(mesh.sites, mode);
  }

  // Replaces the c3t3 by the state that store() has led to.
  void commit()
  {
    if(!complex_.has_changed())
      return;
    C3t3 result;
    result.triangulation().swap(complex_.own_triangulation());
    fill(result);
    c3t3_.swap(result);
    c3t3_.clear_manifold_info();
  }

private:
  template <class Number>
  Constrained_facets flatten(const Number& number, Flat_triangulation_3& flat) const
  {
    return flatten_triangulation_3(
      *complex_.triangulation, number,
      [](Cell_handle c) { return c->subdomain_index() != Subdomain_index(); },
      [](const Facet& f)
      {
        return f.first->is_facet_on_surface(f.second)
               || f.first->subdomain_index() != f.first->neighbor(f.second)->subdomain_index();
      },
      flat);
  }

  Boundary_complex_3 boundary(const Constrained_facets& constrained_facets)
  {
    std::vector<Boundary_facet> facets;
    facets.reserve(constrained_facets.size());
    for(const Constrained_facet<Triangulation>& w : constrained_facets)
    {
      const Cell_handle c = w.facet.first;
      const int i = w.facet.second;
      facets.push_back({ w.vertices,
                         {{ complex_.labels.number(c->subdomain_index()),
                            complex_.labels.number(c->neighbor(i)->subdomain_index()) }},
                         c->is_facet_on_surface(i) ? complex_.patches.number(c->surface_patch_index(i))
                                                   : int(Boundary_facet::no_patch) });
    }
    return Boundary_complex_3(std::move(facets), complex_.sites.size());
  }

  // Numbers the vertices along Hilbert curves, those of the interior first, then
  // those that move on surfaces, then the rest. Gives each vertex's new number.
  std::vector<int> sort_vertices(const Constrained_facets& constrained_facets, const Flat_triangulation_3& flat, bool boundary_moves)
  {
    const Boundary_complex_3 b = boundary(constrained_facets);
    const auto is_interior = [&](std::size_t v)
    {
      return complex_.vertices[v]->in_dimension() == 3 && complex_.sites[v].weight == 0
             && flat.incident_cell(static_cast<int>(v)) >= 0 && !b.has_facets(static_cast<int>(v));
    };
    const auto slides = [&](std::size_t v)
    {
      return complex_.vertices[v]->in_dimension() == 2 && complex_.sites[v].weight == 0
             && b.number_of_umbrellas(static_cast<int>(v)) == 1 && b.is_disk(static_cast<int>(v), 0);
    };
    std::vector<std::size_t> order = hilbert_order(complex_.sites);
    const auto boundary_begin = std::stable_partition(order.begin(), order.end(), is_interior);
    const auto fixed_begin = boundary_moves ? std::stable_partition(boundary_begin, order.end(), slides)
                                            : boundary_begin;
    complex_.number_of_interior_vertices = static_cast<int>(boundary_begin - order.begin());
    complex_.number_of_movable_vertices = static_cast<int>(fixed_begin - order.begin());
    std::vector<int> place(order.size());
    std::vector<Vertex_handle> vertices;
    std::vector<Site> sites;
    for(std::size_t n = 0; n < order.size(); ++n)
    {
      place[order[n]] = static_cast<int>(n);
      vertices.push_back(complex_.vertices[order[n]]);
      sites.push_back(complex_.sites[order[n]]);
      site_[vertices.back()] = static_cast<int>(n);
    }
    complex_.vertices.swap(vertices);
    complex_.sites.swap(sites);
    return place;
  }

  void read_surface_centers(const Constrained_facets& constrained_facets)
  {
    for(const Constrained_facet<Triangulation>& w : constrained_facets)
    {
      const Bare_point p = w.facet.first->get_facet_surface_center(w.facet.second);
      complex_.facets.push_back(w.facet);
      complex_.centers.push_back({ coordinates(p), p,
                                   w.facet.first->get_facet_surface_center_index(w.facet.second), true, true });
    }
    complex_.mend_surface_centers();
  }

  void read_labels()
  {
    complex_.subdomain.resize(complex_.vertices.size());
    for(std::size_t v = 0; v < complex_.vertices.size(); ++v)
      complex_.subdomain[v] = complex_.boundary.has_facets(static_cast<int>(v))
                                ? int(Complex::no_subdomain)
                                : complex_.labels.number(complex_.vertices[v]->cell()->subdomain_index());
    const Triangulation& tr = *complex_.triangulation;
    for(auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
    {
      std::array<int, 4> q;
      for(int i = 0; i < 4; ++i)
        q[i] = site_[c->vertex(i)];
      if(std::all_of(q.begin(), q.end(), [this](int v) { return complex_.subdomain[v] == Complex::no_subdomain; }))
        complex_.add_boundary_cell(q, complex_.labels.number(c->subdomain_index()));
    }
  }

  void finish(const Constrained_facets& constrained_facets, Moving_triangulation_3& mesh) const
  {
    mesh.sites = complex_.sites;
    mesh.number_of_interior_vertices = complex_.number_of_interior_vertices;
    mesh.number_of_movable_vertices = complex_.number_of_movable_vertices;
    mesh.surface_heights.clear();
    for(const Constrained_facet<Triangulation>& w : constrained_facets)
      mesh.surface_heights.push_back(complex_.height(w.vertices));
    mesh.topology.compact();
  }

  // Completes the new complex from the labels on its cells and the old complex.
  void fill(C3t3& result) const
  {
    Triangulation& tr = result.triangulation();
    const std::vector<Vertex_handle>& vertices = complex_.vertices;
    std::vector<double> radius_sum(vertices.size(), 0), radius_count(vertices.size(), 0);
    for(auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
    {
      const Subdomain_index label = c->subdomain_index();
      if(label == Subdomain_index())
        continue;
      c->set_subdomain_index(Subdomain_index());
      result.add_to_complex(c, label);
      add_circumradius(tr, c, radius_sum, radius_count);
    }
    for(std::size_t n = 0; n < complex_.facets.size(); ++n)
    {
      const Facet f = complex_.facets[n];
      const Facet mirror = tr.mirror_facet(f);
      f.first->set_surface_patch_index(f.second, Surface_patch_index());
      mirror.first->set_surface_patch_index(mirror.second, Surface_patch_index());
      const int patch = complex_.boundary.facets()[n].patch;
      if(patch == Boundary_facet::no_patch)
        continue;
      result.add_to_complex(f, complex_.patches.value(patch));
      for(const Facet& g : { f, mirror })
      {
        g.first->set_facet_surface_center(g.second, complex_.centers[n].stored);
        g.first->set_facet_surface_center_index(g.second, complex_.centers[n].index);
      }
    }
    const bool has_far_points = c3t3_.number_of_far_points() > 0;
    for(std::size_t v = 0; v < vertices.size(); ++v)
    {
      const Vertex_handle from = input_vertices_[v], to = vertices[v];
      to->set_dimension(from->in_dimension());
      to->set_index(from->index());
      to->set_special(from->is_special());
      to->set_meshing_info(radius_count[v] > 0 ? radius_sum[v] / radius_count[v]
                                               : CGAL::to_double(from->meshing_info()));
      if(has_far_points && from->in_dimension() == -1)
        result.add_far_point(to);
    }
    for(auto v = c3t3_.vertices_in_complex_begin(); v != c3t3_.vertices_in_complex_end(); ++v)
    {
      const Vertex_handle old = v;
      const Vertex_handle to = vertices[site_[old]];
      const bool special = to->is_special();
      result.add_to_complex(to, c3t3_.corner_index(old));
      to->set_special(special);
    }
    if(c3t3_.number_of_edges_in_complex() == 0)
      return;
    std::vector<std::pair<Vertex_handle, typename C3t3::Curve_index> > neighbors;
    for(std::size_t v = 0; v < vertices.size(); ++v)
    {
      if(input_vertices_[v]->in_dimension() >= 2)
        continue;
      neighbors.clear();
      c3t3_.adjacent_vertices_in_complex(input_vertices_[v], std::back_inserter(neighbors));
      for(const auto& n : neighbors)
      {
        const std::size_t w = site_[n.first];
        if(v < w)
          result.add_to_complex(vertices[v], vertices[w], n.second);
      }
    }
  }

  // As CGAL's optimizers do, leave the mean circumradius in meshing_info.
  void add_circumradius(const Triangulation& tr, Cell_handle c,
                        std::vector<double>& sum, std::vector<double>& count) const
  {
    const std::array<double, 3> p = coordinates(tr.dual(c));
    for(int i = 0; i < 4; ++i)
    {
      const int v = Numbered_triangulation_3<Triangulation>::number(c->vertex(i));
      const Site& s = complex_.sites[v];
      sum[v] += std::sqrt(squared_distance(s, p));
      ++count[v];
    }
  }

  C3t3& c3t3_;
  Restricted_triangulation restricted_triangulation_;
  Complex& complex_;
  std::vector<Vertex_handle> input_vertices_;
  Site_map site_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_C3T3_BRIDGE_3_H
