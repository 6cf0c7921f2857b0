// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_EXACT_SLIVER_REMOVAL_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_EXACT_SLIVER_REMOVAL_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Removes slivers from the exact triangulation of a complex, one vertex at a time.
template <class Complex>
class Exact_sliver_removal_3
{
public:
  typedef typename Complex::Trial Trial;
  typedef std::array<int, 4> Quadruple;

  Exact_sliver_removal_3(Complex& complex, double bound, unsigned int seed)
    : complex_(complex)
    , trial_(complex.make_trial(bound))
    , random_(seed)
  {}

  std::size_t number_of_moves() const { return number_of_moves_; }
  std::size_t number_of_tries() const { return number_of_tries_; }
  bool adopt() { return complex_.adopt(trial_); }
  const std::vector<Site>& sites() const { return trial_.sites(); }

  template <class Predicate>
  void run(std::size_t most_tries, const Predicate& has_time)
  {
    most_tries_ = most_tries;
    for(int pass = 0; pass < most_passes; ++pass)
    {
      bool improved = false;
      for(const auto& s : trial_.slivers())
      {
        if(number_of_tries_ >= most_tries_ || !has_time())
          return;
        if(trial_.deficit_of_cell(s.second) > 0 && failures_[s.second] < most_failures)
        {
          if(improve(s.second))
            improved = true;
          else
            ++failures_[s.second];
        }
      }
      if(!improved)
        return;
    }
  }

private:
  static constexpr int most_passes = 8, tries_per_vertex = 16, most_failures = 3;
  static constexpr double farthest = 0.35, nearest = 0.12;
  static constexpr double least_improvement = 1e-6;
  static constexpr int tries_of_lift = 8;

  bool improve(const Quadruple& q)
  {
    if(improve(q, movable({ q[0], q[1], q[2], q[3] })))
      return true;
    return improve(q, movable(trial_.opposite_vertices(q)));
  }

  std::vector<int> movable(std::vector<int> vertices) const
  {
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    vertices.erase(std::remove_if(vertices.begin(), vertices.end(), [this](int v) { return !trial_.is_movable(v); }),
                   vertices.end());
    return vertices;
  }

  bool improve(const Quadruple&, const std::vector<int>& vertices)
  {
    double best_change = -least_improvement;
    int best = -1;
    Site best_site = { 0, 0, 0, 0 };
    for(int v : vertices)
    {
      const Site from = trial_.sites()[v];
      const double edge = trial_.mean_edge_length(v);
      if(!trial_.is_interior(v))
      {
        double shortest = 1e300;
        normal_ = trial_.surface_normal(v, shortest);
      }
      trial_.lift(v);
      number_of_tries_ += tries_of_lift;
      for(int n = 0; n < tries_per_vertex; ++n)
      {
        Site s = displaced(from, edge * (n % 2 == 0 ? farthest : nearest));
        if(!place(v, from, s))
          continue;
        ++number_of_tries_;
        const double change = trial_.move(s, best_change);
        if(!(change < best_change))
          continue;
        best_change = change;
        best = v;
        best_site = s;
        if(trial_.deficit_after() == 0)
        {
          trial_.accept();
          ++number_of_moves_;
          return true;
        }
      }
      trial_.put_back();
    }
    if(best < 0)
      return false;
    trial_.lift(best);
    if(trial_.move(best_site, 0) < 0)
    {
      trial_.accept();
      ++number_of_moves_;
      return true;
    }
    std::cerr << "NOT AGAIN" << std::endl;
    trial_.put_back();
    return false;
  }

  Site displaced(const Site& s, double farthest)
  {
    const Eigen::Vector3d d = random_.uniform() * farthest * random_.direction();
    return { s.x + d[0], s.y + d[1], s.z + d[2], s.weight };
  }

  bool place(int v, const Site& from, Site& s)
  {
    if(trial_.is_interior(v))
      return true;
    const Eigen::Vector3d normal = normal_;
    const double height = normal.dot(position(s) - position(from));
    s = site_at(position(s) - height * normal, s.weight);
    return trial_.put_on_surface(v, s);
  }

  Eigen::Vector3d normal_;
  Complex& complex_;
  Trial trial_;
  Random_source random_;
  std::map<Quadruple, int> failures_;
  std::size_t number_of_moves_ = 0, number_of_tries_ = 0, most_tries_ = 0;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_EXACT_SLIVER_REMOVAL_3_H
