// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_SPLINE_GRID_FIELD_3_H
#define CGAL_SPLINE_GRID_FIELD_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Requirements.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/sizing/Tricubic_spline_3.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/number_utils.h>

#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgGlobalOdtMesh3Fields

The class `Spline_grid_field_3` interpolates values on a uniform axis-aligned grid by a trivariate cubic spline, the tensor
product of cubic splines that are twice continuously differentiable. This is how Chen et al. reconstruct a density
(section 5.2 of
\cgalCite{cgal:cwlls-rodt-14}).

If its values are sizes, in the unit of the coordinates, an object serves as `sizing_field` of `odt_optimize_mesh_3()` and as a
size of `Mesh_criteria_3`. If they are densities, it serves as `density`.

Polynomials of degree three in each variable are reproduced. The error at smooth functions is of the fourth order in the
distance of nodes. Where values jump, a spline overshoots, possibly below zero; sizes and densities should change
little from one node to the next. Points outside of the box have the value of the closest point of the box.

Copies share the values. Queries may be made from several threads at once.

\tparam Kernel a model of the concept `Kernel`, whose coordinates are converted to `double`

\cgalModels{MeshDomainField_3,MeshDensity_3}

\sa `odt_optimize_mesh_3()`
\sa `Local_feature_size_field_3`
*/
template <class Kernel>
class Spline_grid_field_3
{
  typedef Global_odt_mesh_3::internal::Tricubic_spline_3 Spline;

public:
  /// \name Types
  /// @{

  /// the type of values
  typedef typename Kernel::FT FT;
  /// the type of points
  typedef typename Kernel::Point_3 Point_3;
  /// the type of gradients
  typedef typename Kernel::Vector_3 Vector_3;
  /// the index that the concept asks for; others do as well, since the value does not depend on it
  typedef int Index;

  /// @}

  /// \name Creation
  /// @{

#ifdef DOXYGEN_RUNNING

  /*!
  interpolates `values`.

  \tparam ValueRange a range of values convertible to `FT`

  \param box the box with nodes at its corners
  \param nx,ny,nz the numbers of nodes along the axes
  \param values the values at the nodes, x running fastest: that of node `(i, j, k)` is at place `i + nx * (j + ny * k)`

  \pre `nx`, `ny`, and `nz` are at least five.
  \pre The box has a positive, finite extent along each axis.
  \pre There are `nx * ny * nz` values, which are finite.
  */
  template <class ValueRange>
  Spline_grid_field_3(const Bbox_3& box, int nx, int ny, int nz, const ValueRange& values);

  /*!
  interpolates the values of `function` at the nodes, where it is called once each, x running fastest.

  \tparam Function a model of `FT(Point_3)`

  \pre The box and the numbers of nodes are as above, and the values of the function are finite.
  */
  template <class Function>
  Spline_grid_field_3(const Bbox_3& box, int nx, int ny, int nz, const Function& function);

#else

  template <class Values>
  Spline_grid_field_3(const Bbox_3& box, int nx, int ny, int nz, const Values& values)
  {
    const Spline::Grid grid(box, nx, ny, nz);
    spline_ = std::make_shared<Spline>(grid, values_at_nodes(grid, values));
  }

#endif

  /// @}

  /// \name Queries
  /// @{

  /// returns the value at a point.
  FT operator()(const Point_3& p) const { return FT(spline_->value(Global_odt_mesh_3::internal::coordinates(p))); }

  /// returns the value at a point, whatever the dimension and the index, which may be that of any domain.
  template <class AnyIndex>
  FT operator()(const Point_3& p, int, const AnyIndex&) const { return (*this)(p); }

  /// returns the gradient at a point. The derivative along an axis is zero where a point is beyond the box along that axis.
  Vector_3 gradient(const Point_3& p) const
  {
    const Spline::Triple g = spline_->gradient(Global_odt_mesh_3::internal::coordinates(p));
    return Vector_3(FT(g[0]), FT(g[1]), FT(g[2]));
  }

  /// returns the box of the grid.
  Bbox_3 bbox() const { return spline_->bbox(); }

  /// @}

private:
  // `source` is a function or a range.
  template <class Source>
  static std::vector<double> values_at_nodes(const Spline::Grid& grid, const Source& source)
  {
    std::vector<double> values;
    values.reserve(grid.number_of_nodes());
    if constexpr (std::is_invocable<const Source&, const Point_3&>::value)
    {
      for(int k = 0; k < grid.nodes[2]; ++k)
        for(int j = 0; j < grid.nodes[1]; ++j)
          for(int i = 0; i < grid.nodes[0]; ++i)
            values.push_back(CGAL::to_double(source(Point_3(grid.coordinate(0, i), grid.coordinate(1, j),
                                                            grid.coordinate(2, k)))));
    }
    else
    {
      for(const auto& value : source)
        values.push_back(CGAL::to_double(value));
    }
    return values;
  }

  std::shared_ptr<const Spline> spline_;
};

} // namespace CGAL

#endif // CGAL_SPLINE_GRID_FIELD_3_H
