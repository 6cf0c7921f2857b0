// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_ADAPTIVE_CUBATURE_QUADRATURE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_ADAPTIVE_CUBATURE_QUADRATURE_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/density/Density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Point_rule_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The moments to a tolerance, in the way of Genz and Cools (An adaptive numerical cubature algorithm for
// simplices, ACM TOMS 29, 2003): the rules of Grundmann and Moeller of degree 7, 5 and 3, which share their points,
// give integral and error of a region; the region with the largest error is bisected, along the direction of the
// edge in which the density's fourth differences are largest.
class Adaptive_cubature_quadrature_3
  : public Density_quadrature_3
{
public:
  // The tolerance is that of the sum of all moments' errors, over the integral of the density. Regions are at
  // most so many a cell: a density that is not smooth gets no better then.
  Adaptive_cubature_quadrature_3(Density density, double tolerance, int most_regions)
    : density_(density)
    , fifteen_points_(std::move(density), Point_rule_quadrature_3::fifteen_points())
    , tolerance_(tolerance)
    , most_regions_(most_regions)
  {
    for(int n = 0; n < number_of_rules; ++n)
      for(int k = 0; k <= order - n; ++k)
        weights_[n][k] = weight(order - n, k);
    for(int k = 0; k <= order; ++k)
      for(int a = 0; a <= k; ++a)
        for(int b = 0; a + b <= k; ++b)
          for(int c = 0; a + b + c <= k; ++c)
          {
            const double n = 2 * k + 4;
            points_.push_back({ k, {{ (2 * a + 1) / n, (2 * b + 1) / n, (2 * c + 1) / n,
                                      (2 * (k - a - b - c) + 1) / n }} });
          }
  }

  void set_tolerance(double tolerance) { tolerance_ = tolerance; }

  std::unique_ptr<Density_quadrature_3> part(const std::vector<int>& vertices) const override
  {
    return std::make_unique<Adaptive_cubature_quadrature_3>(renumbered(density_, vertices), tolerance_,
                                                            most_regions_);
  }

  Density_moments_3 moments(int cell, const int* vertices, const Site* sites) override
  {
    const Density_samples_3 samples(density_, vertices, sites);
    const auto has_smaller_error = [](const Region& a, const Region& b) { return a.error < b.error; };
    regions_.clear();
    regions_.push_back(Region());
    for(int i = 0; i < 4; ++i)
    {
      regions_[0].corners[i].fill(0);
      regions_[0].corners[i][i] = 1;
    }
    integrate(samples, regions_[0]);
    double error = regions_[0].error, total_mass = mass(regions_[0].integral);
    while(static_cast<int>(regions_.size()) < most_regions_ && !(error <= tolerance_ * std::abs(total_mass)))
    {
      std::pop_heap(regions_.begin(), regions_.end(), has_smaller_error);
      const std::array<Region, 2> halves = bisect(samples, regions_.back());
      error -= regions_.back().error;
      total_mass -= mass(regions_.back().integral);
      regions_.pop_back();
      for(const Region& half : halves)
      {
        regions_.push_back(half);
        integrate(samples, regions_.back());
        error += regions_.back().error;
        total_mass += mass(regions_.back().integral);
        std::push_heap(regions_.begin(), regions_.end(), has_smaller_error);
      }
    }
    Products sum = {};
    for(const Region& r : regions_)
      for(std::size_t n = 0; n < sum.size(); ++n)
        sum[n] += r.integral[n];
    const Density_moments_3 m = Density_samples_3::moments(sum);
    // The rules have negative weights: too few regions may leave moments that no density has.
    const bool is_positive = *std::min_element(m.first.begin(), m.first.end()) > 0;
    return is_positive ? m : fifteen_points_.moments(cell, vertices, sites);
  }

private:
  typedef Density_samples_3::Barycentric_coordinates Coordinates;
  typedef Density_samples_3::Products Products;

  // A part of the cell; its corners in barycentric coordinates of the cell.
  struct Region
  {
    std::array<Coordinates, 4> corners;
    double volume = 1;                    // over that of the cell
    Products integral;
    double error;
  };

  // A point with odd multiples of 1/(2k + 4) as coordinates.
  struct Point
  {
    int k;
    Coordinates coordinates;
  };

  // The degree of the rule of an order is twice that and one.
  static constexpr int order = 3, number_of_rules = 3;

  // The weight of the points with that k in the rule of an order (Grundmann and Moeller, Invariant integration formulas
  // for the n-simplex by combinatorial methods, SIAM J. Numer. Anal. 15, 1978).
  static double weight(int of_order, int k)
  {
    const int i = of_order - k, degree = 2 * of_order + 1;
    double w = (i % 2 == 0 ? 6 : -6) * std::pow(0.25, of_order) * std::pow(2 * k + 4, degree);
    for(int n = 2; n <= i; ++n)
      w /= n;
    for(int n = 2; n <= degree + 3 - i; ++n)
      w /= n;
    return w;
  }

  static Coordinates place(const Region& r, const Coordinates& l)
  {
    Coordinates p = {};
    for(int i = 0; i < 4; ++i)
      for(int j = 0; j < 4; ++j)
        p[j] += l[i] * r.corners[i][j];
    return p;
  }

  // The sum of all m_ij.
  static double mass(const Products& p)
  {
    double sum = 0;
    for(int n = 0; n < 10; ++n)
      sum += n < 6 ? 2 * p[n] : p[n];
    return sum;
  }

  void integrate(const Density_samples_3& samples, Region& r) const
  {
    std::array<Products, order + 1> sums = {};
    for(const Point& p : points_)
      samples.add(place(r, p.coordinates), 1, sums[p.k]);
    std::array<Products, number_of_rules> rules = {};   // of degree 7, 5 and 3
    for(int n = 0; n < number_of_rules; ++n)
      for(int k = 0; k <= order - n; ++k)
        for(std::size_t m = 0; m < rules[n].size(); ++m)
          rules[n][m] += r.volume * weights_[n][k] * sums[k][m];
    r.integral = rules[0];
    r.error = 0;
    for(std::size_t m = 0; m < r.integral.size(); ++m)
    {
      // The difference is the error of degree 5. Where the differences fall by much from one rule to the
      // next, that of degree 7 is smaller by as much again.
      const double last = std::abs(rules[0][m] - rules[1][m]), before = std::abs(rules[1][m] - rules[2][m]);
      r.error += last < before / 10 ? 10 * last * last / before : last;
    }
  }

  std::array<Region, 2> bisect(const Density_samples_3& samples, const Region& r) const
  {
    const double step = 0.1;
    double largest = -1;
    int edge = 0;
    for(int e = 0; e < 6; ++e)
    {
      double difference = 0;
      for(int n = -2; n <= 2; ++n)
      {
        Coordinates l = {{ 0.25, 0.25, 0.25, 0.25 }};
        l[Density_moments_3::edges[e][0]] += n * step;
        l[Density_moments_3::edges[e][1]] -= n * step;
        difference += (n == 0 ? 6 : n % 2 == 0 ? 1 : -4) * samples.density(place(r, l));
      }
      if(std::abs(difference) > largest)
      {
        largest = std::abs(difference);
        edge = e;
      }
    }
    const int i = Density_moments_3::edges[edge][0], j = Density_moments_3::edges[edge][1];
    Coordinates middle = {};
    middle[i] = middle[j] = 0.5;
    const Coordinates midpoint = place(r, middle);
    std::array<Region, 2> halves = {{ r, r }};
    halves[0].corners[i] = halves[1].corners[j] = midpoint;
    for(Region& half : halves)
      half.volume /= 2;
    return halves;
  }

  Density density_;
  Point_rule_quadrature_3 fifteen_points_;
  double tolerance_;
  int most_regions_;
  std::vector<Point> points_;
  std::array<std::array<double, order + 1>, number_of_rules> weights_ = {};
  std::vector<Region> regions_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_ADAPTIVE_CUBATURE_QUADRATURE_3_H
