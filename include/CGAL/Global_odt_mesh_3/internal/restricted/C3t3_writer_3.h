// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_C3T3_WRITER_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_C3T3_WRITER_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_dual_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Point_coordinates.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_state_3.h>

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Writes a state, which has come from a c3t3, to that c3t3: cells, facets, features and vertices, with what the
// first one says of them. The c3t3 is only changed by a swap at the end.
template <class C3t3, class Domain>
class C3t3_writer_3
{
public:
  typedef typename C3t3::Triangulation Triangulation;
  typedef Restricted_state_3<Triangulation> State;

  C3t3_writer_3(State state, const Domain& domain)
    : state_(std::move(state))
    , domain_(domain)
  {}

  void write(C3t3& c3t3)
  {
    result_.triangulation().swap(state_.own->triangulation());
    restore_orders();
    add_cells();
    add_facets();
    add_vertices(c3t3);
    add_features(c3t3);
    c3t3.swap(result_);
    c3t3.clear_manifold_info();
  }

private:
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Cell_handle Cell_handle;
  typedef typename Triangulation::Facet Facet;
  typedef typename C3t3::Subdomain_index Subdomain_index;
  typedef typename C3t3::Surface_patch_index Surface_patch_index;

  Triangulation& triangulation() { return result_.triangulation(); }
  Vertex_handle input_vertex(int v) const { return state_.numbering->input_vertices[v]; }
  // Of the result, for one of the input.
  Vertex_handle vertex(Vertex_handle of_input) const { return state_.vertex(state_.numbering->input_number[of_input]); }
  int number_of_vertices() const { return state_.numbering->number_of_vertices(); }

  // Of the vertices of cells that are in the same subdomain as in the input: on this order depends, by rounding, the dual
  // point of a flat cell, and hence whether the domain finds it in that subdomain.
  void restore_orders()
  {
    std::vector<Vertex_handle> opposite;
    for(const Facet& f : state_.facets)
      opposite.push_back(f.first->vertex(f.second));
    for(const auto& b : state_.boundary_cells)
    {
      const Cell_handle from = state_.numbering->input_cell(b.first, state_.sites);
      if(from == Cell_handle())
        continue;
      std::array<Vertex_handle, 4> v;
      for(int i = 0; i < 4; ++i)
        v[i] = vertex(from->vertex(i));
      Cell_handle to;
      if(triangulation().is_cell(v[0], v[1], v[2], v[3], to) && to->subdomain_index() == from->subdomain_index())
        reorder(to, v);
    }
    for(std::size_t n = 0; n < opposite.size(); ++n)
      state_.facets[n].second = state_.facets[n].first->index(opposite[n]);
  }

  // Facets lose their patches.
  static void reorder(Cell_handle c, const std::array<Vertex_handle, 4>& v)
  {
    std::array<Cell_handle, 4> neighbors;
    for(int i = 0; i < 4; ++i)
      neighbors[i] = c->neighbor(c->index(v[i]));
    for(int i = 0; i < 4; ++i)
    {
      c->set_vertex(i, v[i]);
      c->set_neighbor(i, neighbors[i]);
      c->set_surface_patch_index(i, Surface_patch_index());
    }
  }

  // From the labels that cells have got.
  void add_cells()
  {
    radius_sum_.assign(number_of_vertices(), 0);
    radius_count_.assign(number_of_vertices(), 0);
    for(auto c = triangulation().finite_cells_begin(); c != triangulation().finite_cells_end(); ++c)
    {
      const Subdomain_index label = c->subdomain_index();
      if(label == Subdomain_index())
        continue;
      c->set_subdomain_index(Subdomain_index());
      result_.add_to_complex(c, label);
      add_circumradius(c);
    }
  }

  void add_facets()
  {
    for(std::size_t n = 0; n < state_.facets.size(); ++n)
    {
      const Facet f = state_.facets[n];
      const Facet mirror = triangulation().mirror_facet(f);
      f.first->set_surface_patch_index(f.second, Surface_patch_index());
      mirror.first->set_surface_patch_index(mirror.second, Surface_patch_index());
      const int patch = state_.boundary.complex().facets()[n].patch;
      if(patch == Boundary_facet::no_patch)
        continue;
      result_.add_to_complex(f, domain_.patch(patch));
      for(const Facet& g : { f, mirror })
      {
        g.first->set_facet_surface_center(g.second, state_.centers[n].stored);
        g.first->set_facet_surface_center_index(g.second, state_.centers[n].index);
      }
    }
  }

  void add_vertices(const C3t3& c3t3)
  {
    const bool has_far_points = c3t3.number_of_far_points() > 0;
    for(int v = 0; v < number_of_vertices(); ++v)
    {
      const Vertex_handle from = input_vertex(v), to = state_.vertex(v);
      to->set_dimension(from->in_dimension());
      to->set_index(from->index());
      to->set_special(from->is_special());
      // As CGAL's optimizers leave it there.
      to->set_meshing_info(radius_count_[v] > 0 ? radius_sum_[v] / radius_count_[v]
                                                : CGAL::to_double(from->meshing_info()));
      if(has_far_points && from->in_dimension() == -1)
        result_.add_far_point(to);
    }
  }

  void add_features(const C3t3& c3t3)
  {
    for(auto v = c3t3.vertices_in_complex_begin(); v != c3t3.vertices_in_complex_end(); ++v)
    {
      const Vertex_handle old = v, to = vertex(old);
      const bool special = to->is_special();
      result_.add_to_complex(to, c3t3.corner_index(old));
      to->set_special(special);
    }
    if(c3t3.number_of_edges_in_complex() == 0)
      return;
    std::vector<std::pair<Vertex_handle, typename C3t3::Curve_index> > neighbors;
    for(int v = 0; v < number_of_vertices(); ++v)
    {
      if(input_vertex(v)->in_dimension() >= 2)
        continue;
      neighbors.clear();
      c3t3.adjacent_vertices_in_complex(input_vertex(v), std::back_inserter(neighbors));
      for(const auto& n : neighbors)
      {
        const int w = state_.numbering->input_number[n.first];
        if(v < w)
          result_.add_to_complex(state_.vertex(v), state_.vertex(w), n.second);
      }
    }
  }

  // The mean of the circumradii around a vertex.
  void add_circumradius(Cell_handle c)
  {
    const Eigen::Vector3d p = coordinates(triangulation().dual(c));
    for(int i = 0; i < 4; ++i)
    {
      const int v = state_.number(c->vertex(i));
      radius_sum_[v] += std::sqrt(squared_distance(state_.sites[v], p));
      ++radius_count_[v];
    }
  }

  State state_;
  const Domain& domain_;
  C3t3 result_;
  std::vector<double> radius_sum_, radius_count_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_C3T3_WRITER_3_H
