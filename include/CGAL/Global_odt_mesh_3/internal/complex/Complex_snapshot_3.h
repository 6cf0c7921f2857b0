// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_COMPLEX_SNAPSHOT_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_COMPLEX_SNAPSHOT_3_H

#include <CGAL/Global_odt_mesh_3/internal/complex/Vertex_numbering_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_table_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// A valid complex, as far as the exact regular triangulation of its positions does not tell it: the restriction to the
// domain, and where the vertices on surfaces are. Once made, it does not change.
struct Complex_snapshot_3
{
  static constexpr int no_subdomain = Vertex_numbering_3::no_subdomain;

  // The point of the surface on the dual line of a boundary facet.
  struct Surface_center
  {
    Eigen::Vector3d point;
    int patch = Boundary_facet::no_patch;     // on which it is
    int source = Mesh_table_3::no_facet;      // the facet of the input whose center it is
    bool is_exact = false;          // on the surface; or else estimated from the normals
    bool is_faithful = false;       // the facet's centroid is known to be close enough to the surface
  };

  // Of a vertex that moves on a surface.
  struct Surface_position
  {
    bool is_on_surface;
    double drift;                   // how far tangential planes may have led off it, over an edge
    Site last_on_surface;
  };

  std::shared_ptr<const Vertex_numbering_3> numbering;
  bool is_input = false;
  std::vector<Site> sites;
  std::vector<Surface_position> surface_positions;  // of the vertices that move on surfaces
  Boundary_geometry_3 boundary;
  std::vector<Surface_center> centers;
  Tuple_table<Triple, int> facet_numbers;
  Tuple_table<Quadruple, int> boundary_cells;       // with all vertices on the boundary; labels
  std::map<Quadruple, int> flipped_cells;            // that have another label than their dual points, which is given
  std::map<Triple, int> flipped_facets;              // of these cells, that are no longer on the boundary; their patches
  std::set<Triple> far_facets;                      // of flat boundary cells, farther from the surface than permitted
  bool has_unseparating_facets = false;
  bool has_labels_of_domain = false;                // also of the boundary cells

  // Whether the vertices are there.
  bool has_positions(const std::vector<Site>& positions) const
  {
    return std::equal(sites.begin(), sites.end(), positions.begin(), positions.end(), same_place);
  }

  // Of a vertex that moves on a surface.
  const Surface_position& surface_position(int v) const
  {
    CGAL_assertion(numbering->is_movable(v) && !numbering->is_interior(v));
    return surface_positions[v - numbering->number_of_interior_vertices];
  }

  // The label of a cell with all vertices on the boundary, or no_subdomain if there is none.
  int label_of_boundary_cell(const Quadruple& cell) const
  {
    const int* const label = boundary_cells.find(sorted(cell));
    return label == nullptr ? int(no_subdomain) : *label;
  }

  // The same for that of its dual point, as far as that is known.
  int label_of_dual(const Quadruple& cell) const
  {
    const auto it = flipped_cells.find(sorted(cell));
    return it == flipped_cells.end() ? label_of_boundary_cell(cell) : it->second;
  }

  // The number of the boundary facet with these vertices, or -1.
  int facet_number(const Triple& facet) const
  {
    const int* const number = facet_numbers.find(sorted(facet));
    return number == nullptr ? -1 : *number;
  }

  // To be called when `boundary` is what it will be.
  void number_facets()
  {
    const std::vector<Boundary_facet>& boundary_facets = boundary.complex().facets();
    facet_numbers.reserve(boundary_facets.size());
    for(std::size_t n = 0; n < boundary_facets.size(); ++n)
    {
      const Boundary_facet& f = boundary_facets[n];
      facet_numbers.insert(sorted(f.vertices), static_cast<int>(n));
      has_unseparating_facets = has_unseparating_facets || f.labels[0] == f.labels[1];
    }
  }

  // The signed height of the surface over the plane of a boundary facet, where the
  // dual line crosses both, positive toward side 1.
  double height(const Triple& facet) const
  {
    return Facet_dual_3(facet, sites).height(centers[facet_number(facet)].point);
  }
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_COMPLEX_SNAPSHOT_3_H
