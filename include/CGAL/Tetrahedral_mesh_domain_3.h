// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_TETRAHEDRAL_MESH_DOMAIN_3_H
#define CGAL_TETRAHEDRAL_MESH_DOMAIN_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Requirements.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Global_odt_mesh_3/internal/door/Facet_domain_3.h>

#include <CGAL/Mesh_domain_with_polyline_features_3.h>
#include <CGAL/boost/graph/split_graph_into_polylines.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/variant/get.hpp>

#include <map>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgGlobalOdtMesh3Domains

The class `Tetrahedral_mesh_domain_3` is the domain that a tetrahedral mesh fills. It is for meshes that have no other domain, such
as those from files. It copies the cells of the complex with their subdomains, the facets with their patches, and the
curves and corners, so that the mesh may be changed or destroyed afterwards. Facets of one patch may have different subdomains on
their sides, and facets may have the same subdomain on both sides.

The subdomain of a point is that of a cell that contains it, by exact predicates. A point on a facet is in a subdomain beside
the facet. Several threads may query the domain at the same time, so that `domain_is_thread_safe` may be set.

Each polyline between two corners, and each cycle, is a curve of its own of the domain, so that its index is not the one in
the complex.

\tparam C3T3 a model of `MeshComplexWithFeatures_3InTriangulation_3`, not periodic, whose points are those of
`Exact_predicates_inexact_constructions_kernel`

\cgalModels{MeshDomainWithFeatures_3}

\sa `complete_mesh_complex_3()`
\sa `odt_optimize_tetrahedral_mesh_3()`
*/
template <class C3T3>
class Tetrahedral_mesh_domain_3
#ifndef DOXYGEN_RUNNING
  : public Mesh_domain_with_polyline_features_3<Global_odt_mesh_3::internal::Facet_domain_3<C3T3> >
#endif
{
  typedef Mesh_domain_with_polyline_features_3<Global_odt_mesh_3::internal::Facet_domain_3<C3T3> > Base;

public:
  /// \name Types
  /// @{
#ifdef DOXYGEN_RUNNING
  /// the point type of the mesh
  typedef unspecified_type Point_3;
  /// the type of the indices of subdomains, which is that of the mesh
  typedef unspecified_type Subdomain_index;
  /// the type of the indices of patches, which is that of the mesh
  typedef unspecified_type Surface_patch_index;
  /// the type of the indices of vertices, which is that of the mesh
  typedef unspecified_type Index;
  /// the AABB tree of the facets
  typedef unspecified_type AABB_tree;
#else
  typedef typename C3T3::Subdomain_index Subdomain_index;
  typedef typename C3T3::Surface_patch_index Surface_patch_index;
  typedef typename C3T3::Index Index;
  typedef typename Base::Point_3 Point_3;
#endif
  /// @}

  /*!
  copies the boundary, the interfaces, and the features of a mesh.

  \pre All facets between two subdomains are in the complex. `complete_mesh_complex_3()` adds those that are missing.
  */
  explicit Tetrahedral_mesh_domain_3(const C3T3& c3t3)
    : Base(c3t3)
  {
    static_assert(std::is_same<typename C3T3::Triangulation::Periodic_tag, Tag_false>::value,
                  "the mesh must not be periodic");
    static_assert(std::is_same<typename Base::Index, Index>::value,
                  "the indices of the mesh must be those of a domain with features, curves and corners having type int");
    add_curves(c3t3);
    for(auto v = c3t3.vertices_in_complex_begin(); v != c3t3.vertices_in_complex_end(); ++v)
      this->add_corner(v->point().point());
  }

#ifdef DOXYGEN_RUNNING
  /// returns the AABB tree of the facets, for closest points.
  const AABB_tree& aabb_tree() const;
#else
  // `Index` may be the same type as `Surface_patch_index` and the others.
  Surface_patch_index surface_patch_index(const Index& index) const { return value<Surface_patch_index>(index); }
  Subdomain_index subdomain_index(const Index& index) const { return value<Subdomain_index>(index); }
  typename Base::Curve_index curve_index(const Index& index) const { return value<typename Base::Curve_index>(index); }
  typename Base::Corner_index corner_index(const Index& index) const { return value<typename Base::Corner_index>(index); }
#endif

private:
  typedef typename C3T3::Vertex_handle Vertex_handle;
  typedef boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, Vertex_handle> Graph;
  typedef typename boost::graph_traits<Graph>::vertex_descriptor Node;

  template <class T>
  static T value(const Index& index)
  {
    if constexpr (std::is_same<T, Index>::value)
      return index;
    else
    {
      using boost::get;
      using std::get;
      return get<T>(index);
    }
  }

  struct Polyline_collector
  {
    const Graph& graph;
    std::vector<std::vector<Point_3> > polylines = {};

    void start_new_polyline() { polylines.emplace_back(); }
    void add_node(Node n) { polylines.back().push_back(graph[n]->point().point()); }
    void end_polyline() {}
  };

  void add_curves(const C3T3& c3t3)
  {
    Graph graph;
    std::map<Vertex_handle, Node> nodes;
    const auto node = [&](Vertex_handle v)
    {
      const auto it = nodes.find(v);
      return it != nodes.end() ? it->second : nodes.emplace(v, boost::add_vertex(v, graph)).first->second;
    };
    for(auto e = c3t3.edges_in_complex_begin(); e != c3t3.edges_in_complex_end(); ++e)
      boost::add_edge(node(e->first->vertex(e->second)), node(e->first->vertex(e->third)), graph);
    Polyline_collector collector = { graph };
    split_graph_into_polylines(graph, collector, [&c3t3](Node n, const Graph& g) { return c3t3.is_in_complex(g[n]); });
    this->add_features(collector.polylines.begin(), collector.polylines.end());
  }
};

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_TETRAHEDRAL_MESH_DOMAIN_3_H
