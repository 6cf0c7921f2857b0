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

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The tensor product of C2 cubic splines that interpolates values on a grid, by its coefficients in the basis of B-splines, one
// for each node and for those of a layer around the grid.
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
        const std::string along = std::string(" along ") + "xyz"[axis];
        CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(nodes[axis] >= fewest_nodes,
                                               ("Spline_grid_field_3: fewer than 5 nodes" + along).c_str());
        CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(high[axis] > low[axis] && std::isfinite(high[axis] - low[axis]),
                                               ("Spline_grid_field_3: the box is empty or not finite" + along).c_str());
      }
    }

    std::size_t number_of_nodes() const { return nodes.cast<std::size_t>().prod(); }

    double coordinate(int axis, int i) const
    {
      return i == nodes[axis] - 1 ? high[axis] : low[axis] + i * ((high[axis] - low[axis]) / (nodes[axis] - 1));
    }
  };

  Tricubic_spline_3(const Grid& grid, const std::vector<double>& values)
    : grid_(grid)
  {
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(values.size() == grid.number_of_nodes(),
                                           "Spline_grid_field_3: the number of values is not the product of the numbers of nodes");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); }),
                                           "Spline_grid_field_3: a value is not finite");
    for(int axis = 0; axis < 3; ++axis)
      scale_[axis] = (grid.nodes[axis] - 1) / (grid.high[axis] - grid.low[axis]);
    coefficients_ = Eigen::VectorXd::Zero(stride(3));
    auto value = values.begin();
    for(int k = 0; k < grid.nodes[2]; ++k)
      for(int j = 0; j < grid.nodes[1]; ++j, value += grid.nodes[0])
        std::copy(value, value + grid.nodes[0], coefficients_.data() + place(1, j + 1, k + 1));
    for(int axis = 0; axis < 3; ++axis)
      for(std::ptrdiff_t start = 0; start < coefficients_.size(); ++start)
        if(start / stride(axis) % (grid.nodes[axis] + 2) == 0)
          fit(coefficients_.data() + start, stride(axis), grid.nodes[axis]);
  }

  // Points outside of the box are moved to the closest point of it.
  double value(const Triple& p) const
  {
    const Position q = locate(p);
    return combine(q, values(q.t));
  }

  Triple gradient(const Triple& p) const
  {
    const Position q = locate(p);
    Triple g;
    for(int axis = 0; axis < 3; ++axis)
    {
      Weights w = values(q.t);
      w.col(axis) = slopes(q.t[axis]);
      g[axis] = q.is_clamped[axis] ? 0 : scale_[axis] * combine(q, w);
    }
    return g;
  }

  Bbox_3 bbox() const
  {
    return Bbox_3(grid_.low[0], grid_.low[1], grid_.low[2], grid_.high[0], grid_.high[1], grid_.high[2]);
  }

private:
  typedef Eigen::Vector4d Basis;                // the four B-splines that are not zero, or their slopes
  typedef Eigen::Matrix<double, 4, 3> Weights;  // of the three axes

  struct Position
  {
    Eigen::Vector3i node;               // the lowest of the box
    Triple t;                           // in [0, 1]
    Eigen::Array<bool, 3, 1> is_clamped;
  };

  static Basis values(double t)
  {
    const double s = 1 - t;
    return Basis(s * s * s, 4 - 3 * t * t * (1 + s), 4 - 3 * s * s * (1 + t), t * t * t) / 6;
  }

  static Weights values(const Triple& t)
  {
    Weights w;
    w << values(t[0]), values(t[1]), values(t[2]);
    return w;
  }

  static Basis slopes(double t)
  {
    const double s = 1 - t;
    return Basis(-s * s, t * (3 * t - 4), s * (4 - 3 * s), t * t) / 2;
  }

  Position locate(const Triple& p) const
  {
    Position q;
    for(int axis = 0; axis < 3; ++axis)
    {
      const double u = (p[axis] - grid_.low[axis]) * scale_[axis], last = grid_.nodes[axis] - 1;
      // What is not a number goes to the lower face.
      const double inside = u > 0 ? (std::min)(u, last) : 0;
      q.node[axis] = (std::min)(static_cast<int>(inside), grid_.nodes[axis] - 2);
      q.t[axis] = inside - q.node[axis];
      q.is_clamped[axis] = p[axis] < grid_.low[axis] || p[axis] > grid_.high[axis];
    }
    return q;
  }

  double combine(const Position& q, const Weights& w) const
  {
    double sum = 0;
    for(int k = 0; k < 4; ++k)
      for(int j = 0; j < 4; ++j)
        sum += w(k, 2) * w(j, 1) * w.col(0).dot(coefficients_.segment<4>(place(q.node[0], q.node[1] + j, q.node[2] + k)));
    return sum;
  }

  std::ptrdiff_t place(int i, int j, int k) const { return i + j * stride(1) + k * stride(2); }

  // The distance from a coefficient to the next one along an axis.
  std::ptrdiff_t stride(int axis) const
  {
    std::ptrdiff_t n = 1;
    for(int a = 0; a < axis; ++a)
      n *= grid_.nodes[a] + 2;
    return n;
  }

  // Along a line, values c[1] to c[n] become coefficients c[0] to c[n + 1]: at node i, the spline is (c[i-1] + 4 c[i] + c[i+1])/6,
  // and its slope (c[i+1] - c[i-1])/2, which is given at the ends.
  static void fit(double* line, std::ptrdiff_t stride, int n)
  {
    const auto c = [=](int i) -> double& { return line[i * stride]; };
    const double low = end_slope([&](int i) { return c(1 + i); }), high = -end_slope([&](int i) { return c(n - i); });
    c(1) += low / 3;
    c(n) -= high / 3;
    Eigen::VectorXd above = Eigen::VectorXd::Zero(n + 1);     // the diagonal, in the elimination of Gauss
    for(int i = 1; i <= n; ++i)
    {
      const double left = i == 1 ? 0 : i == n ? 2 : 1, right = i == 1 ? 2 : 1, pivot = 4 - left * above[i - 1];
      above[i] = right / pivot;
      c(i) = (6 * c(i) - left * c(i - 1)) / pivot;
    }
    for(int i = n - 1; i >= 1; --i)
      c(i) -= above[i] * c(i + 1);
    c(0) = c(2) - 2 * low;
    c(n + 1) = c(n - 1) + 2 * high;
  }

  // The slope at an end. It is of fourth order, so that cubic polynomials are reproduced and the spline is as accurate at the ends
  // as elsewhere.
  template <class Values>
  static double end_slope(const Values& f) { return (-25 * f(0) + 48 * f(1) - 36 * f(2) + 16 * f(3) - 3 * f(4)) / 12; }

  Grid grid_;
  Triple scale_;
  Eigen::VectorXd coefficients_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_TRICUBIC_SPLINE_3_H
