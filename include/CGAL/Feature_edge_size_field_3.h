// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_FEATURE_EDGE_SIZE_FIELD_3_H
#define CGAL_FEATURE_EDGE_SIZE_FIELD_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Requirements.h>

#include <CGAL/Global_odt_mesh_3/internal/Parameter_check.h>
#include <CGAL/Global_odt_mesh_3/internal/sizing/Boundary_poles_3.h>
#include <CGAL/Global_odt_mesh_3/internal/sizing/Size_envelope_3.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgGlobalOdtMesh3Fields

The class `Feature_edge_size_field_3` is a sizing field that is computed from the feature edges of a mesh. Where curves come close
to each other, the protecting balls of the mesh generator shrink, and feature edges become much shorter than the edges
beyond. This field lets sizes grow gradually from there: a mesh that is generated a second time, with it as
`cell_size` and `facet_size` of `Mesh_criteria_3`, has room for good cells between curves. With
\f$ h_e \f$ the length of a feature edge and \f$ K \f$ = `gradation`, the size is
\f[ \mu(\mathbf{x}) = \min\left(\min_e \sqrt{h_e^2 + K^2 d_e(\mathbf{x})^2},\ \mathrm{largest\_size}\right), \f]
where \f$ d_e \f$ is the distance to the nearest end of the edge. It changes by at most \f$ K \f$ times the distance of two points.

Copies share the data. Queries may be made from several threads at once.

\tparam C3T3 a model of `MeshComplex_3InTriangulation_3` and `MeshComplexWithFeatures_3InTriangulation_3`, whose coordinates are
converted to `double`

\cgalModels{MeshDomainField_3}

\sa `odt_optimize_mesh_3()`
\sa `Local_feature_size_field_3`
*/
template <class C3T3>
class Feature_edge_size_field_3
{
public:
  /// \name Types
  /// @{

  /// the type of points
  typedef typename C3T3::Triangulation::Bare_point Point_3;
  /// the type of sizes
  typedef typename C3T3::Triangulation::Geom_traits::FT FT;
  /// the type of indices, on which the size does not depend
  typedef typename C3T3::Index Index;

  /// @}

  /// \name Creation
  /// @{

  /*!
  takes the lengths of the feature edges of `c3t3`. The mesh is not needed any longer afterwards.

  \param c3t3 the mesh; without feature edges, all sizes are `largest_size`
  \param largest_size the upper bound of sizes, such as that with which the mesh was made
  \param gradation the Lipschitz constant of the field

  \pre `largest_size` is positive and finite, `gradation` finite and not negative.
  */
  explicit Feature_edge_size_field_3(const C3T3& c3t3, double largest_size, double gradation = 0.45)
  {
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(largest_size > 0 && std::isfinite(largest_size), "largest_size must be positive and finite");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(gradation >= 0 && std::isfinite(gradation), "gradation must be finite and not negative");
    using Global_odt_mesh_3::internal::boundary_sample;
    std::vector<Sample> ends;
    std::vector<double> lengths;
    std::vector<std::pair<typename C3T3::Vertex_handle, typename C3T3::Curve_index> > adjacent;
    for(auto v = c3t3.triangulation().finite_vertices_begin(); v != c3t3.triangulation().finite_vertices_end(); ++v)
    {
      if(v->in_dimension() < 0 || v->in_dimension() > 1)
        continue;
      adjacent.clear();
      c3t3.adjacent_vertices_in_complex(v, std::back_inserter(adjacent));
      double shortest = (std::numeric_limits<double>::infinity)();
      for(const auto& a : adjacent)
        shortest = (std::min)(shortest, distance(boundary_sample(v->point()), boundary_sample(a.first->point())));
      if(!(shortest < largest_size))
        continue;
      ends.push_back(boundary_sample(v->point()));
      lengths.push_back(shortest);
    }
    envelope_ = std::make_shared<Envelope>(ends, lengths, gradation, largest_size);
  }

  /// @}

  /// \name Queries
  /// @{

  /// returns the size at a point, whatever the dimension and the index.
  FT operator()(const Point_3& p, int, const Index&) const
  {
    return FT((*envelope_)(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())));
  }

  /// @}

private:
  typedef Global_odt_mesh_3::internal::Size_envelope_3 Envelope;
  typedef Global_odt_mesh_3::internal::Boundary_sample Sample;

  static double distance(const Sample& p, const Sample& q) { return std::hypot(p.x() - q.x(), p.y() - q.y(), p.z() - q.z()); }

  std::shared_ptr<const Envelope> envelope_;
};

} // namespace CGAL

#endif // CGAL_FEATURE_EDGE_SIZE_FIELD_3_H
