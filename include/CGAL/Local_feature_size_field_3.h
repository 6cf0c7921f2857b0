// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_LOCAL_FEATURE_SIZE_FIELD_3_H
#define CGAL_LOCAL_FEATURE_SIZE_FIELD_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Requirements.h>

#include <CGAL/Global_odt_mesh_3/internal/Parameter_check.h>
#include <CGAL/Global_odt_mesh_3/internal/sizing/Boundary_poles_3.h>
#include <CGAL/Global_odt_mesh_3/internal/sizing/Size_envelope_3.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgGlobalOdtMesh3Fields

The class `Local_feature_size_parameters_3` holds the parameters of `Local_feature_size_field_3`. Lengths are in the
unit of the coordinates. A length of 0 is replaced by a fraction of the diagonal of the bounding box of the domain, of the
mesh's surface, or of the points.
*/
struct Local_feature_size_parameters_3
{
  /// the size at the boundary, relative to the local feature size; positive
  double size_factor = 0.5;
  /// the Lipschitz constant of the field: the largest increase of size by distance; not negative
  double gradation = 0.3;
  /// the lower bound of sizes, which matters at sharp edges, where the local feature size falls to zero;
  /// 0: half of `sample_spacing`
  double smallest_size = 0;
  /// the upper bound of sizes, not below `smallest_size`; 0: a tenth of the diagonal
  double largest_size = 0;
  /// the bound on the radii of the surface Delaunay balls when the boundary of a domain is sampled, which does not
  /// resolve thinner parts; 0: a hundredth of the diagonal
  double sample_spacing = 0;

  /// checks the values of all members. A value out of range violates a precondition that names it.
  void check() const
  {
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(size_factor > 0 && std::isfinite(size_factor), "size_factor must be positive and finite");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(gradation >= 0 && std::isfinite(gradation), "gradation must be finite and not negative");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(smallest_size >= 0 && std::isfinite(smallest_size),
                                           "smallest_size must be finite and not negative");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(largest_size >= 0 && std::isfinite(largest_size),
                                           "largest_size must be finite and not negative");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(largest_size == 0 || largest_size >= smallest_size,
                                           "largest_size must not be below smallest_size");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(sample_spacing >= 0 && std::isfinite(sample_spacing),
                                           "sample_spacing must be finite and not negative");
  }
};

/*!
\ingroup PkgGlobalOdtMesh3Fields

The class `Local_feature_size_field_3` is a sizing field that is computed from the boundary of a domain. Sizes are
small where the boundary is curved or close to another part of itself, and grow with the distance from there. The same
object serves as `cell_size` and `facet_size` of `Mesh_criteria_3` and as `sizing_field` of
`odt_optimize_mesh_3()`, so that mesh and optimizer agree.

The boundary is sampled. The poles of a sample are the farthest vertices of its Voronoi cell on either side of the
boundary. They are near the medial axis \cgalCite{cgal:ab-srvf-99}. The distance
from a sample \f$ s \f$ to the nearest pole is the local feature size there. A pole counts only if it sees two of the
samples that are nearest to it under an angle of 60 degrees at least. Hence neither noise nor the edges of a finely
triangulated surface are taken for features. With \f$ h_s \f$ = `size_factor` times the local feature size, but
not less than `smallest_size`, and \f$ K \f$ = `gradation`, the size is
\f[ \mu(\mathbf{x}) = \min\left(\min_s \sqrt{h_s^2 + K^2 |\mathbf{x} - s|^2},\ \mathrm{largest\_size}\right). \f]
It changes by at most \f$ K \f$ times the distance of two points. With \f$ K = 0 \f$ it is constant.

`Mesh_criteria_3` takes sizes for bounds on radii. Edges hence become longer than the size, by a third with the default
parameters.

At sharp edges and corners the local feature size is zero; the samples nearest to them decide how small the size gets,
down to `smallest_size`. Noise of the samples in the direction of the normal must be small compared with their distances.

Copies share the samples. Queries may be made from several threads at once.

\tparam MeshDomain a model of the concept `MeshDomain_3`, whose coordinates are converted to `double`

\cgalModels{MeshDomainField_3}

\sa `odt_optimize_mesh_3()`
\sa `Spline_grid_field_3`
*/
template <class MeshDomain>
class Local_feature_size_field_3
{
public:
  /// \name Types
  /// @{

  /// the type of sizes
  typedef typename MeshDomain::R::FT FT;
  /// the type of points
  typedef typename MeshDomain::Point_3 Point_3;
  /// the type of indices, on which the size does not depend
  typedef typename MeshDomain::Index Index;

  /// @}

  /// \name Creation
  /// @{

  /*!
  samples the boundary of `domain` by the vertices of a surface mesh without features. `make_mesh_3()` makes it with a `facet_size`
  of `sample_spacing`; components of the boundary that it misses are missed here, too. A domain with a random generator of its own,
  such as `Labeled_mesh_domain_3`, draws from it.

  \pre The parameters pass `Local_feature_size_parameters_3::check()`, and the domain has a boundary.
  */
  explicit Local_feature_size_field_3(const MeshDomain& domain, const Local_feature_size_parameters_3& parameters
                                                                  = Local_feature_size_parameters_3())
    : parameters_(with_defaults(parameters, domain.bbox()))
  {
    initialize(Global_odt_mesh_3::internal::samples_of_domain(domain, parameters_.sample_spacing));
  }

  /*!
  takes the vertices of the surface facets of `c3t3` for samples, those on features included; weights are left out.

  \tparam C3T3 a model of `MeshComplex_3InTriangulation_3`

  \pre The parameters pass `Local_feature_size_parameters_3::check()`, and the mesh has surface facets.
  */
  template <class C3T3>
  static Local_feature_size_field_3
  from_mesh(const C3T3& c3t3, const Local_feature_size_parameters_3& parameters = Local_feature_size_parameters_3())
  {
    return Local_feature_size_field_3(Global_odt_mesh_3::internal::samples_of_mesh(c3t3), parameters);
  }

  /*!
  takes points on the boundary for samples. Their distances should be half of the local feature size at the most.

  \tparam PointRange a range of points with coordinates `x()`, `y()`, `z()`

  \pre The parameters pass `Local_feature_size_parameters_3::check()`, and there are two different points at least, all
  finite.
  */
  template <class PointRange>
  static Local_feature_size_field_3
  from_points(const PointRange& points,
              const Local_feature_size_parameters_3& parameters = Local_feature_size_parameters_3())
  {
    Samples samples;
    for(const auto& p : points)
      samples.push_back(Global_odt_mesh_3::internal::boundary_sample(p));
    return Local_feature_size_field_3(samples, parameters);
  }

  /// @}

  /// \name Queries
  /// @{

  /// returns the size at a point, whatever the dimension and the index.
  FT operator()(const Point_3& p, int, const Index&) const
  {
    return FT((*envelope_)(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())));
  }

  /// returns the parameters, with derived lengths in the place of zeros.
  const Local_feature_size_parameters_3& parameters() const { return parameters_; }

  /// @}

private:
  typedef Global_odt_mesh_3::internal::Size_envelope_3 Envelope;
  typedef std::vector<Global_odt_mesh_3::internal::Boundary_sample> Samples;

  Local_feature_size_field_3(const Samples& samples, const Local_feature_size_parameters_3& parameters)
    : parameters_(with_defaults(parameters, checked_bbox(samples)))
  {
    initialize(samples);
  }

  static Bbox_3 checked_bbox(const Samples& samples)
  {
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(!samples.empty(), "Local_feature_size_field_3: no samples of the boundary");
    for(const auto& s : samples)
      CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(std::isfinite(s.x()) && std::isfinite(s.y()) && std::isfinite(s.z()),
                                             "Local_feature_size_field_3: a sample is not finite");
    const Bbox_3 box = bbox_3(samples.begin(), samples.end());
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(box.x_span() > 0 || box.y_span() > 0 || box.z_span() > 0,
                                           "Local_feature_size_field_3: all samples are the same point");
    return box;
  }

  static Local_feature_size_parameters_3 with_defaults(Local_feature_size_parameters_3 p, const Bbox_3& box)
  {
    p.check();
    const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span());
    if(p.sample_spacing == 0)
      p.sample_spacing = diagonal / 100;
    // A bound that is derived gives way to one that is not.
    if(p.smallest_size == 0)
      p.smallest_size = p.largest_size == 0 ? p.sample_spacing / 2 : (std::min)(p.sample_spacing / 2, p.largest_size);
    if(p.largest_size == 0)
      p.largest_size = (std::max)(diagonal / 10, p.smallest_size);
    return p;
  }

  void initialize(const Samples& samples)
  {
    checked_bbox(samples);
    const Global_odt_mesh_3::internal::Boundary_poles_3 poles(samples);
    std::vector<double> sizes = poles.distances(samples);
    for(double& h : sizes)
      h = (std::min)((std::max)(parameters_.size_factor * h, parameters_.smallest_size), parameters_.largest_size);
    envelope_ = std::make_shared<Envelope>(samples, sizes, parameters_.gradation, parameters_.largest_size);
  }

  Local_feature_size_parameters_3 parameters_;
  std::shared_ptr<const Envelope> envelope_;
};

} // namespace CGAL

#endif // CGAL_LOCAL_FEATURE_SIZE_FIELD_3_H
