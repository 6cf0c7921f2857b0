// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_COMPLEX_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_COMPLEX_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_dual_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Index_table.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Estimated_surface_center_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Numbered_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// A complex as the restriction of a regular triangulation to the domain: the
// vertices, the labels of their cells, and the boundary facets between them.
//
// A vertex that no boundary facet touches belongs to one subdomain for good, and
// so do the cells around it. The cells with all vertices on the boundary have labels
// of their own.
template <class Triangulation_, class Mesh_domain>
class Restricted_complex_3
{
public:
  typedef Triangulation_ Triangulation;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  typedef typename Triangulation::Facet Facet;
  typedef typename Triangulation::Bare_point Bare_point;
  typedef typename Triangulation::Vertex::Index Index;
  typedef typename Mesh_domain::Subdomain_index Subdomain_index;
  typedef typename Mesh_domain::Surface_patch_index Surface_patch_index;
  typedef std::array<double, 3> Vector;
  typedef std::array<int, 3> Triple;
  typedef std::array<int, 4> Quadruple;

  static constexpr int no_subdomain = -1;

  // What belongs to a boundary facet beside vertices, labels and patch.
  struct Surface_center
  {
    Vector point;
    Bare_point stored;              // what the complex is told
    Index index;
    bool is_exact;                  // on the surface; or else estimated from the normals
    bool is_faithful = false;       // the facet's centroid is known to be close enough to the surface
  };

  // Indexed by the numbers of vertices and of boundary facets.
  const Triangulation* triangulation;
  std::vector<Vertex_handle> vertices;
  std::vector<Site> sites;
  std::vector<int> subdomain;               // of a vertex without boundary facets, or no_subdomain
  Boundary_complex_3 boundary;
  std::vector<Facet> facets;                // of the triangulation, on side 0
  std::vector<Surface_center> centers;
  Index_table<Subdomain_index> labels;
  Index_table<Surface_patch_index> patches;
  int number_of_interior_vertices = 0;      // these come first, followed by
  int number_of_movable_vertices = 0;       // those that move on the surface

  Restricted_complex_3()
    : outside_(labels.number(Subdomain_index()))
  {}

  int outside() const { return outside_; }
  bool is_on_boundary(int v) const { return subdomain[v] == no_subdomain; }

  // Whether the triangulation is another than the one that was read.
  bool has_changed() const { return triangulation == &own_.triangulation(); }
  Triangulation& own_triangulation() { return own_.triangulation(); }

  // Takes over a triangulation of the same vertices, and gives its own one away.
  void swap_triangulation(Numbered_triangulation_3<Triangulation>& other)
  {
    own_.swap(other);
    triangulation = &own_.triangulation();
    for(std::size_t v = 0; v < vertices.size(); ++v)
      vertices[v] = own_.vertex(static_cast<int>(v));
  }

  // The label of a cell with all vertices on the boundary, or no_subdomain if there is none.
  int label_of_boundary_cell(const Quadruple& cell) const
  {
    const auto it = boundary_cells_.find(sorted(cell));
    return it == boundary_cells_.end() ? int(no_subdomain) : it->second;
  }

  void add_boundary_cell(const Quadruple& cell, int label) { boundary_cells_.emplace(sorted(cell), label); }
  void clear_boundary_cells() { boundary_cells_.clear(); }

  // The number of the boundary facet with these vertices, or -1.
  int facet_number(const Triple& facet) const
  {
    const auto it = facet_number_.find(sorted(facet));
    return it == facet_number_.end() ? -1 : it->second;
  }

  bool has_unseparating_facets() const { return has_unseparating_facets_; }

  // To be called when the boundary has been replaced.
  void number_facets()
  {
    facet_number_.clear();
    has_unseparating_facets_ = false;
    for(std::size_t n = 0; n < boundary.facets().size(); ++n)
    {
      const Boundary_facet& f = boundary.facets()[n];
      facet_number_.emplace(sorted(f.vertices), static_cast<int>(n));
      has_unseparating_facets_ = has_unseparating_facets_ || f.labels[0] == f.labels[1];
    }
  }

  // The signed height of the surface over the plane of a boundary facet, where the
  // dual line crosses both, positive toward side 1.
  double height(const Triple& facet) const
  {
    return Facet_dual_3(facet, sites).height(centers[facet_number_.at(sorted(facet))].point);
  }

  // A complex that was not made by the mesher may lack surface centers; then a
  // point of the dual line stands in, without being told to anybody.
  void mend_surface_centers()
  {
    number_facets();
    for(std::size_t n = 0; n < centers.size(); ++n)
    {
      const Triple& t = boundary.facets()[n].vertices;
      std::array<double, 3> power;
      for(int k = 0; k < 3; ++k)
        power[k] = squared_distance(sites[t[k]], centers[n].point) - sites[t[k]].weight;
      const double spread = *std::max_element(power.begin(), power.end())
                            - *std::min_element(power.begin(), power.end());
      if(!(spread <= 1e-4 * std::abs(power[0])))
        centers[n].point = estimated_surface_center(t, boundary, sites);
    }
  }

private:
  int outside_;
  std::unordered_map<Triple, int, Hash_vertex_tuple> facet_number_;
  bool has_unseparating_facets_ = false;
  std::unordered_map<Quadruple, int, Hash_vertex_tuple> boundary_cells_;
  Numbered_triangulation_3<Triangulation> own_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_COMPLEX_3_H
