// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_TRICUBIC_SPLINE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_TRICUBIC_SPLINE_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Parameter_check.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>

#include <CGAL/Bbox_3.h>

#include <Eigen/Core>

#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The tensor product of C2 cubic splines that interpolates values on a grid.
//
// At each node the spline and its mixed derivatives of order one in each variable are stored, in units
// of nodes. They determine the spline in each box of eight nodes, as its Hermite interpolant.
class Tricubic_spline_3
{
public:
  typedef Vector_3 Triple;

  // The formula for derivatives at the ends of a line takes that many.
  static constexpr int fewest_nodes = 5;

  // A uniform grid over a box, nodes on the faces of the box included, numbered with x fastest.
  struct Grid
  {
    Triple low, high;
    Eigen::Vector3i nodes;

    Grid(const Bbox_3& box, int nx, int ny, int nz)
      : low(box.xmin(), box.ymin(), box.zmin())
      , high(box.xmax(), box.ymax(), box.zmax())
      , nodes(nx, ny, nz)
    {
      for(int axis = 0; axis < 3; ++axis)
      {
        CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(nodes[axis] >= fewest_nodes, too_few_nodes(axis));
        CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(high[axis] > low[axis] && std::isfinite(high[axis] - low[axis]), bad_extent(axis));
      }
    }

    static const char* too_few_nodes(int axis)
    {
      return axis == 0 ? "Spline_grid_field_3: fewer than 5 nodes along x"
           : axis == 1 ? "Spline_grid_field_3: fewer than 5 nodes along y"
                       : "Spline_grid_field_3: fewer than 5 nodes along z";
    }

    static const char* bad_extent(int axis)
    {
      return axis == 0 ? "Spline_grid_field_3: the box is empty or not finite along x"
           : axis == 1 ? "Spline_grid_field_3: the box is empty or not finite along y"
                       : "Spline_grid_field_3: the box is empty or not finite along z";
    }

    std::size_t number_of_nodes() const { return stride(3); }

    // From a node to the next one along an axis.
    std::size_t stride(int axis) const
    {
      std::size_t n = 1;
      for(int a = 0; a < axis; ++a)
        n *= static_cast<std::size_t>(nodes[a]);
      return n;
    }

    double coordinate(int axis, int i) const
    {
      return i == nodes[axis] - 1 ? high[axis] : low[axis] + i * ((high[axis] - low[axis]) / (nodes[axis] - 1));
    }
  };

  Tricubic_spline_3(const Grid& grid, const std::vector<double>& values)
    : grid_(grid)
    , data_(values.size())
  {
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(values.size() == grid.number_of_nodes(),
                                           "Spline_grid_field_3: the number of values is not the product of the numbers of nodes");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }),
                                           "Spline_grid_field_3: a value is not finite");
    for(int axis = 0; axis < 3; ++axis)
      scale_[axis] = (grid.nodes[axis] - 1) / (grid.high[axis] - grid.low[axis]);
    for(std::size_t n = 0; n < values.size(); ++n)
      data_[n][0] = values[n];
    // Linear operators in different variables commute, so the order does not matter.
    for(int axis = 0; axis < 3; ++axis)
      for(int derivative = 0; derivative < 1 << axis; ++derivative)
        differentiate(axis, derivative, derivative | 1 << axis);
  }

  // Points outside of the box are moved to the closest point of it.
  double value(const Triple& p) const
  {
    const Position q = locate(p);
    return combine(q.node, values(q.t));
  }

  Triple gradient(const Triple& p) const
  {
    const Position q = locate(p);
    Triple g;
    for(int axis = 0; axis < 3; ++axis)
    {
      Weights w = values(q.t);
      w.col(axis) = slopes(q.t[axis]);
      g[axis] = q.is_clamped[axis] ? 0 : scale_[axis] * combine(q.node, w);
    }
    return g;
  }

  Bbox_3 bbox() const
  {
    return Bbox_3(grid_.low[0], grid_.low[1], grid_.low[2], grid_.high[0], grid_.high[1], grid_.high[2]);
  }

private:
  // The bits of the index: in x, y, and z.
  typedef Eigen::Array<double, 8, 1> Derivatives;

  // Factors of value and derivative at the lower end of an interval, and of those at the upper one.
  typedef Eigen::Vector4d Hermite;
  typedef Eigen::Matrix<double, 4, 3> Weights;      // of the three axes

  struct Position
  {
    std::size_t node;                   // the lowest of the box
    Triple t;                           // in [0, 1]
    Eigen::Array<bool, 3, 1> is_clamped;
  };

  static Hermite values(double t)
  {
    const double s = 1 - t;
    return { (1 + 2 * t) * s * s, t * s * s, t * t * (3 - 2 * t), -t * t * s };
  }

  static Weights values(const Triple& t)
  {
    Weights w;
    w << values(t[0]), values(t[1]), values(t[2]);
    return w;
  }

  static Hermite slopes(double t)
  {
    const double s = 1 - t;
    return { -6 * t * s, s * (1 - 3 * t), 6 * t * s, t * (3 * t - 2) };
  }

  Position locate(const Triple& p) const
  {
    Position q;
    q.node = 0;
    for(int axis = 0; axis < 3; ++axis)
    {
      const double u = (p[axis] - grid_.low[axis]) * scale_[axis], last = grid_.nodes[axis] - 1;
      // What is not a number goes to the lower face.
      const double inside = u > 0 ? (std::min)(u, last) : 0;
      const int i = (std::min)(static_cast<int>(inside), grid_.nodes[axis] - 2);
      q.node += static_cast<std::size_t>(i) * grid_.stride(axis);
      q.t[axis] = inside - i;
      q.is_clamped[axis] = p[axis] < grid_.low[axis] || p[axis] > grid_.high[axis];
    }
    return q;
  }

  double combine(std::size_t node, const Weights& w) const
  {
    double sum = 0;
    for(int up = 0; up < 2; ++up)
      for(int back = 0; back < 2; ++back)
      {
        const std::size_t n = node + (up == 0 ? 0 : grid_.stride(2)) + (back == 0 ? 0 : grid_.stride(1));
        const Derivatives& left = data_[n];
        const Derivatives& right = data_[n + 1];
        const auto along_x = [&](int d)
        { return w(0, 0) * left[d] + w(1, 0) * left[d + 1] + w(2, 0) * right[d] + w(3, 0) * right[d + 1]; };
        const auto along_y = [&](int d) { return w(2 * back, 1) * along_x(d) + w(2 * back + 1, 1) * along_x(d + 2); };
        sum += w(2 * up, 2) * along_y(0) + w(2 * up + 1, 2) * along_y(4);
      }
    return sum;
  }

  void differentiate(int axis, int from, int to)
  {
    const std::size_t stride = grid_.stride(axis), length = static_cast<std::size_t>(grid_.nodes[axis]);
    std::vector<double> line(length);
    for(std::size_t start = 0; start < data_.size(); ++start)
    {
      if(start / stride % length != 0)
        continue;
      for(std::size_t i = 0; i < length; ++i)
        line[i] = data_[start + i * stride][from];
      // Some versions of Boost get the derivative at the upper end wrong when it is left to them.
      const boost::math::interpolators::cardinal_cubic_b_spline<double>
        spline(line.data(), length, 0., 1., end_slope(line.begin()), -end_slope(line.rbegin()));
      for(std::size_t i = 0; i < length; ++i)
        data_[start + i * stride][to] = spline.prime(double(i));
    }
  }

  // Of fourth order, so that cubic polynomials are reproduced and the spline is as accurate at the ends as elsewhere.
  template <class Iterator>
  static double end_slope(Iterator f)
  {
    return (-25 * f[0] + 48 * f[1] - 36 * f[2] + 16 * f[3] - 3 * f[4]) / 12;
  }

  Grid grid_;
  Triple scale_;
  std::vector<Derivatives> data_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_TRICUBIC_SPLINE_3_H
