// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_ANGLE_DEFICIT_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_ANGLE_DEFICIT_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace CGAL::Global_odt_mesh_3::internal {

// How much the dihedral angles of a cell fall short of a bound: the sum of the squares
// of what is missing, in degrees. Only cosines are computed for cells that lack nothing.
class Angle_deficit_3
{
public:
  explicit Angle_deficit_3(double bound)
    : bound_(bound)
    , cosine_(std::cos(bound * CGAL_PI / 180))
  {}

  double bound() const { return bound_; }

  double operator()(const std::array<Site, 4>& cell) const
  {
    double deficit = 0;
    for_each_lack(cell, [&deficit](double lack) { deficit += lack * lack; });
    return deficit;
  }

  // Calls f(lack) for each angle that lacks something.
  template <class F>
  void for_each_lack(const std::array<Site, 4>& cell, const F& f) const
  {
    for_each_lack(Cell_facets_3(cell), [&f](int, int, double lack) { f(lack); });
  }

  // Calls f(lack, gradient) for each angle that lacks something, with the gradient of the angle, in degrees over
  // length, with respect to vertex m.
  template <class F>
  void for_each_gradient(const std::array<Site, 4>& cell, int m, const F& f) const
  {
    const Cell_facets_3 facets(cell);
    for_each_lack(facets, [&](int i, int j, double lack) { f(lack, facets.gradient(i, j, m) * (180 / CGAL_PI)); });
  }

private:
  // Calls f(i, j, lack) for each angle, between the facets opposite to vertices i and j, that lacks something.
  template <class F>
  void for_each_lack(const Cell_facets_3& facets, const F& f) const
  {
    for(int i = 0; i < 3; ++i)
      for(int j = i + 1; j < 4; ++j)
      {
        const double scale = facets.area[i] * facets.area[j], cosine = -facets.normal[i].dot(facets.normal[j]);
        if(scale > 0 && cosine <= cosine_ * scale)
          continue;
        const double angle = scale > 0 ? std::acos((std::min)(1., cosine / scale)) * 180 / CGAL_PI : 0.;
        f(i, j, bound_ - angle);
      }
  }

  double bound_, cosine_;
};

// The displacement of a vertex that makes the deficits of the cells around it zero in first order, in the sense of least
// squares: the damped step of Gauss and Newton.
class Angle_step_3
{
public:
  // Unless the normal is zero, the vertex moves in the plane normal to it.
  explicit Angle_step_3(const Angle_deficit_3& deficit, const Vector_3& normal = Vector_3())
    : deficit_(deficit)
    , normal_(normal)
  {}

  // Adds a cell, of which the vertex is number m.
  void add(const std::array<Site, 4>& cell, int m)
  {
    deficit_.for_each_gradient(cell, m, [this](double lack, const Vector_3& gradient)
    {
      const Vector_3 g = gradient - normal_.dot(gradient) * normal_;
      for(int i = 0; i < 3; ++i)
        normal_equations_[i] += g[i] * g;
      right_side_ += lack * g;
    });
  }

  // The displacement is at most that long.
  Vector_3 displacement(double longest) const
  {
    // Cramer's rule, which compiles in a fraction of the time of a factorization.
    std::array<Vector_3, 3> m = normal_equations_;
    const double trace = m[0][0] + m[1][1] + m[2][2];
    for(int i = 0; i < 3; ++i)
      m[i][i] += damping * trace;
    const Vector_3 minors = m[1].cross(m[2]);
    const Vector_3 step = Vector_3(minors.dot(right_side_), m[2].cross(m[0]).dot(right_side_),
                                   m[0].cross(m[1]).dot(right_side_)) / m[0].dot(minors);
    const double length = step.length();
    if(!std::isfinite(length))
      return Vector_3();
    return length > longest ? longest / length * step : step;
  }

private:
  static constexpr double damping = 1e-2;

  const Angle_deficit_3& deficit_;
  Vector_3 normal_;
  std::array<Vector_3, 3> normal_equations_;
  Vector_3 right_side_;
};

// The dihedral angles, in degrees, that the removal of slivers goes for one after the other. As they do not depend
// on the bound that is wanted, a higher bound goes the way of a lower one, and then on.
struct Sliver_steps
{
  static constexpr int number = 10;
  static constexpr std::array<double, number> angles = {{ 10, 20, 30, 35, 40, 45, 50, 55, 60, 70.5 }};

  // The first that is not below 20 degrees nor the bound; that of 0, which stands for as much as can be had, is the
  // last of all.
  static int last(double bound)
  {
    int n = 1;
    while(n + 1 < number && (!(bound > 0) || angles[n] < bound))
      ++n;
    return n;
  }
};

// What a cell lacks of a goal, in square degrees, and its smallest angle or, if all are above goal and steps, something above these.
struct Cell_lack
{
  double deficit = 0, smallest = 90;
};

// The same of some cells, and how many of them are below each of some steps.
struct Sliver_count
{
  double deficit = 0, smallest = 90;
  std::array<int, Sliver_steps::number> below = {};

  bool is_not_worse_than(const Sliver_count& other, int steps) const
  {
    return smallest >= other.smallest
           && std::equal(below.begin(), below.begin() + steps, other.below.begin(), std::less_equal<int>());
  }

  void add(const Cell_lack& cell, int steps)
  {
    deficit += cell.deficit;
    smallest = (std::min)(smallest, cell.smallest);
    for(int n = 0; n < steps; ++n)
      below[n] += cell.smallest < Sliver_steps::angles[n];
  }
};

// What is counted of the cells of a mesh: smallest angles and numbers below the first steps, up to 30 degrees, as larger angles do
// not count; and how large cells are.
class Sliver_census_3
{
public:
  bool is_of_deformed_mesh = false;           // which is not regular
  bool is_of_moved_mesh = false;              // in a domain that was there before; or of one whose boundary has been split

  void add(const std::array<Site, 4>& cell, int label)
  {
    double& largest = largest_[label];
    largest = (std::max)(largest, squared_circumradius(cell));
    double smallest = Cell_lack().smallest;
    deficit_.for_each_lack(cell, [&](double lack) { smallest = (std::min)(smallest, deficit_.bound() - lack); });
    count_.add({ 0, smallest }, steps);
    ++number_;
  }

  // Compares the smallest angle and, if these matter, the numbers below the steps.
  bool is_not_worse_than(const Sliver_census_3& other, bool counts) const
  { return count_.is_not_worse_than(other.count_, counts ? steps : 0); }

  // Whether cells that are larger than the largest of their subdomain are worth it: if there were angles below 20 degrees, or half of
  // the cells below 30 have gone. Otherwise they are larger by a tenth at most and, if no angle was below 30, not at all.
  bool is_not_coarser_than(const Sliver_census_3& other) const
  {
    if(other.count_.below[1] > 0 || 2 * count_.below[2] < other.count_.below[2])
      return true;
    const double most = other.count_.below[2] > 0 ? 1.1 * 1.1 : 1 + 1e-9;
    return std::all_of(largest_.begin(), largest_.end(), [&](const std::pair<const int, double>& l)
    {
      const auto before = other.largest_.find(l.first);
      return before == other.largest_.end() || !(l.second > most * before->second);
    });
  }

  // Whether it may take the place of the other one. Who wants a bound for angles does not mind sizes. A regular mesh is worth more
  // than one that is not: then sizes do not matter nor, where it has moved, angles above 20 degrees.
  bool may_replace(const Sliver_census_3& other, double sliver_bound) const
  {
    if(other.is_of_moved_mesh)
      return count_.below[1] == 0 || (share_of_slivers() <= other.share_of_slivers() && count_.smallest >= other.count_.smallest);
    return is_not_worse_than(other, true) && (sliver_bound > 0 || other.is_of_deformed_mesh || is_not_coarser_than(other));
  }

private:
  static constexpr int steps = 3;

  // Below 20 degrees.
  double share_of_slivers() const { return double(count_.below[1]) / double((std::max)(1, number_)); }

  int number_ = 0;                    // of cells
  std::map<int, double> largest_;     // the squared circumradius, by label
  Angle_deficit_3 deficit_ = Angle_deficit_3(Sliver_steps::angles[steps - 1]);
  Sliver_count count_;
};

// The dihedral angle, in degrees, that cells should reach, and the number of steps of which none may get more cells below it.
class Sliver_goal
{
public:
  Sliver_goal(double bound, int steps)
    : steps_(steps)
    , wanted_(bound + margin)
    , highest_((std::max)(bound + margin, steps > 0 ? Sliver_steps::angles[steps - 1] : 0.))
  {}

  int steps() const { return steps_; }
  const Angle_deficit_3& wanted() const { return wanted_; }

  Cell_lack lack(const std::array<Site, 4>& cell) const
  {
    Cell_lack result;
    highest_.for_each_lack(cell, [&](double below_highest)
    {
      const double angle = highest_.bound() - below_highest, missing = (std::max)(0., wanted_.bound() - angle);
      result.deficit += missing * missing;
      result.smallest = (std::min)(result.smallest, angle);
    });
    return result;
  }

private:
  static constexpr double margin = 2;           // by which steps are to be exceeded: cells just below a step hold each other there

  int steps_;
  Angle_deficit_3 wanted_, highest_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_GEOMETRY_ANGLE_DEFICIT_3_H
