// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_C3T3_READER_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_C3T3_READER_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Point_coordinates.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Spatial_order.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Collect_in_chunks.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Estimated_surface_center_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Flatten_state_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_state_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Vertex_numbering_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/All_cells.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flat_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flatten_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Reads a c3t3: the first state, still without a triangulation, and the flat mesh of it.
template <class C3t3, class Domain>
class C3t3_reader_3
{
public:
  typedef typename C3t3::Triangulation Triangulation;
  typedef Restricted_state_3<typename Domain::Triangulation> State;

  C3t3_reader_3(const C3t3& c3t3, Domain& domain, const Thread_policy& threads = Thread_policy())
    : threads_(threads)
    , tr_(c3t3.triangulation())
    , domain_(domain)
    , numbering_(std::make_shared<Vertex_numbering>())
  {
    state_.numbering = numbering_;
    numbering_->input = &tr_;
    state_.is_input = true;
  }

  // Vertices of the interior move, unless a boundary facet touches them; those that surfaces run smoothly
  // through move if `boundary_moves`.
  State read(Moving_triangulation_3& mesh, bool boundary_moves)
  {
    mesh = Moving_triangulation_3();
    mesh.set_threads(threads_);
    if(tr_.dimension() != 3)
      return std::move(state_);
    cells_ = all_cells(tr_);
    for(auto v = tr_.finite_vertices_begin(); v != tr_.finite_vertices_end(); ++v)
      add_vertex(v, weighted_site(tr_.point(v)));
    // Which vertices move is seen from the cells and facets around them.
    const Constrained_facets around = flatten(mesh.topology);
    sort_vertices(boundary(around), mesh.topology, boundary_moves);
    Constrained_facets facets = flatten(mesh.topology);
    for(Constrained_facet& f : facets)
      f.vertices = rotated(f.vertices);
    Constrained_facets in_order = facets;
    threads_.sort(in_order.begin(), in_order.end(), [](const auto& a, const auto& b)
                  { return sorted(a.vertices) < sorted(b.vertices); });
    state_.boundary = Boundary_geometry_3(std::make_shared<const Boundary_complex_3>(boundary(in_order)), state_.sites);
    for(int v = numbering_->number_of_interior_vertices; v < numbering_->number_of_movable_vertices; ++v)
      state_.surface_positions.push_back({ true, 0, state_.sites[v] });
    state_.number_facets();
    read_surface_centers(in_order);
    read_labels();
    load_positions(state_, facets, threads_, mesh);
    return std::move(state_);
  }

private:
  typedef typename State::Vertex_numbering Vertex_numbering;
  typedef internal::Constrained_facet<Triangulation> Constrained_facet;
  typedef std::vector<Constrained_facet> Constrained_facets;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Cell_handle Cell_handle;
  typedef typename Triangulation::Bare_point Bare_point;

  // With the numbers that vertices have.
  Constrained_facets flatten(Flat_triangulation_3& flat) const
  {
    const auto number_of = [this](Vertex_handle v) { return number(v); };
    const auto subdomain = [](Cell_handle c) { return c->subdomain_index(); };
    const auto is_on_surface = [](Cell_handle c, int i) { return c->is_facet_on_surface(i); };
    return flatten_triangulation_3(tr_, cells_, number_of, subdomain, is_on_surface, threads_, flat);
  }

  int number(Vertex_handle v) const { return state_.numbering->input_number[v]; }

  void add_vertex(Vertex_handle v, const Site& s)
  {
    numbering_->input_number[v] = static_cast<int>(numbering_->input_vertices.size());
    numbering_->input_vertices.push_back(v);
    state_.sites.push_back(s);
  }

  Boundary_complex_3 boundary(const Constrained_facets& constrained_facets)
  {
    std::vector<Boundary_facet> facets;
    facets.reserve(constrained_facets.size());
    for(const Constrained_facet& f : constrained_facets)
    {
      const Cell_handle c = f.facet.first;
      const int i = f.facet.second;
      facets.push_back({ f.vertices,
                         {{ domain_.label(c->subdomain_index()), domain_.label(c->neighbor(i)->subdomain_index()) }},
                         c->is_facet_on_surface(i) ? domain_.patch_number(c->surface_patch_index(i))
                                                   : int(Boundary_facet::no_patch) });
    }
    return Boundary_complex_3(std::move(facets), state_.sites.size(), threads_);
  }

  // Numbers the vertices along Hilbert curves, those of the interior first, then
  // those that move on surfaces, then the rest.
  void sort_vertices(const Boundary_complex_3& boundary, const Flat_triangulation_3& flat, bool boundary_moves)
  {
    const std::vector<Vertex_handle> vertices = std::move(numbering_->input_vertices);
    const std::vector<Site> sites = std::move(state_.sites);
    const auto has_dimension = [&](std::size_t v, int dimension)
    { return vertices[v]->in_dimension() == dimension && sites[v].weight == 0; };
    const auto is_interior = [&](std::size_t v)
    {
      const int n = static_cast<int>(v);
      return has_dimension(v, 3) && flat.incident_cell(n) >= 0 && !boundary.has_facets(n);
    };
    const auto slides = [&](std::size_t v)
    {
      const int n = static_cast<int>(v);
      return has_dimension(v, 2) && boundary.number_of_umbrellas(n) == 1 && boundary.umbrella(n, 0).is_disk;
    };
    std::vector<std::size_t> order = hilbert_order(sites);
    const auto boundary_begin = std::stable_partition(order.begin(), order.end(), is_interior);
    const auto fixed_begin = boundary_moves ? std::stable_partition(boundary_begin, order.end(), slides)
                                            : boundary_begin;
    numbering_->number_of_interior_vertices = static_cast<int>(boundary_begin - order.begin());
    numbering_->number_of_movable_vertices = static_cast<int>(fixed_begin - order.begin());
    numbering_->input_vertices.clear();
    state_.sites.clear();
    for(std::size_t n : order)
      add_vertex(vertices[n], sites[n]);
  }

  // A complex that was not made by the mesher, or comes from a file, may lack surface centers, which is seen from their
  // indices: the points are then not even numbers that are the same each time. A point of the dual line stands in,
  // without being told to anybody.
  void read_surface_centers(const Constrained_facets& facets)
  {
    constexpr double most_spread = 1e-4;      // of the powers of the center with respect to the vertices
    for(const Constrained_facet& f : facets)
    {
      const Cell_handle c = f.facet.first;
      const int i = f.facet.second;
      const Bare_point p = c->get_facet_surface_center(i);
      Eigen::Vector3d point = coordinates(p), power;
      for(int k = 0; k < 3; ++k)
      {
        const Site& s = state_.sites[f.vertices[k]];
        power[k] = squared_distance(s, point) - s.weight;
      }
      if(!c->is_facet_on_surface(i)
         || !domain_.is_on_patch(c->get_facet_surface_center_index(i), domain_.patch_number(c->surface_patch_index(i)))
         || !(power.maxCoeff() - power.minCoeff() <= most_spread * std::abs(power[0])))
        point = estimated_surface_center(f.vertices, state_.boundary, state_.sites);
      state_.centers.push_back({ point, p, c->get_facet_surface_center_index(i), true, true });
    }
  }

  void read_labels()
  {
    state_.has_labels_of_domain = true;
    for(int v = 0; v < numbering_->number_of_vertices(); ++v)
      numbering_->subdomain.push_back(state_.boundary.complex().has_facets(v)
                                        ? int(State::no_subdomain)
                                        : domain_.label(numbering_->input_vertices[v]->cell()->subdomain_index()));
    const auto find_boundary_cells = [this](int n, std::vector<int>& found)
    {
      const Cell_handle c = cells_[n];
      if(!tr_.is_infinite(c) && is_on_boundary(numbers(c)))
        found.push_back(n);
    };
    for(int n : collect_in_chunks(static_cast<int>(cells_.size()), threads_, find_boundary_cells))
    {
      const std::array<int, 4> q = sorted(numbers(cells_[n]));
      state_.boundary_cells.insert(q, domain_.label(cells_[n]->subdomain_index()));
      numbering_->input_boundary_cells.insert(q, cells_[n]);
    }
  }

  std::array<int, 4> numbers(Cell_handle c) const
  { return {{ number(c->vertex(0)), number(c->vertex(1)), number(c->vertex(2)), number(c->vertex(3)) }}; }

  bool is_on_boundary(const std::array<int, 4>& q) const
  { return std::all_of(q.begin(), q.end(), [this](int v) { return numbering_->is_on_boundary(v); }); }

  Thread_policy threads_;
  const Triangulation& tr_;
  std::vector<Cell_handle> cells_;
  Domain& domain_;
  std::shared_ptr<Vertex_numbering> numbering_;
  State state_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_C3T3_READER_3_H
