// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_EXACT_SLIVER_REMOVAL_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_EXACT_SLIVER_REMOVAL_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

struct Exact_sliver_removal_parameters
{
  double lowest_bound = 10, step = 5;       // degrees: the bound rises to the one that is wanted
  int tries_per_vertex = 16;
  double farthest = 0.35, nearest = 0.12;   // the longest tries, over the mean incident edge length, in turn
  int most_failures = 2;                    // for the same cell
  int most_passes = 8;                      // with each bound
  std::size_t tries_of_lift = 8;            // to lift a vertex and put it back takes as long as so many tries
};

// Removes the cells with dihedral angles below a bound by trials of single vertices of the exact complex. As the
// facets on surfaces are exchanged along with the cells, it removes those that the flat mesh, where facets are
// constrained, cannot.
//
// Trial is as Restricted_trial_3. Where no vertex of a cell helps, those opposite to it in its neighbors are
// tried: they may get into the cell's circumsphere.
template <class Trial>
class Exact_sliver_removal_3
{
public:
  typedef std::array<int, 4> Quadruple;

  Exact_sliver_removal_3(Trial& trial, double bound, unsigned int seed,
                         const Exact_sliver_removal_parameters& parameters = Exact_sliver_removal_parameters())
    : trial_(trial)
    , bound_(bound)
    , parameters_(parameters)
    , random_(seed)
  {}

  std::size_t number_of_moves() const { return number_of_moves_; }
  // Of places, with what lifting vertices costs.
  std::size_t number_of_tries() const { return number_of_tries_; }

  // Until there are no such cells, nothing improves them any more, the tries are used up, or `may_go_on()`,
  // asked before each cell, says no.
  template <class Predicate>
  void run(std::size_t most_tries, const Predicate& may_go_on)
  {
    const std::vector<Quadruple> slivers = trial_.slivers();
    slivers_.insert(slivers.begin(), slivers.end());
    double bound = (std::min)(parameters_.lowest_bound, bound_);
    while(make_passes(bound, most_tries, may_go_on) && bound < bound_)
      bound = (std::min)(bound + parameters_.step, bound_);
  }

private:
  static constexpr double least_improvement = 1e-6;     // square degrees

  // False if it is to come to an end.
  template <class Predicate>
  bool make_passes(double bound, std::size_t most_tries, const Predicate& may_go_on)
  {
    trial_.set_bound(bound);
    bool improved = true;
    for(int pass = 0; pass < parameters_.most_passes && improved; ++pass)
    {
      improved = false;
      for(const auto& s : sorted_slivers())
      {
        const Quadruple& q = s.second;
        if(trial_.deficit(q) == 0 || failures_[q] == parameters_.most_failures)
          continue;
        if(number_of_tries_ >= most_tries || !may_go_on())
          return false;
        if(improve(trial_.movable_vertices(q)) || improve(trial_.movable_vertices_beyond(q)))
          improved = true;
        else
          ++failures_[q];
      }
    }
    return true;
  }

  // The worst come first.
  std::vector<std::pair<double, Quadruple> > sorted_slivers()
  {
    std::vector<std::pair<double, Quadruple> > result;
    for(const Quadruple& q : slivers_)
    {
      const double d = trial_.deficit(q);
      if(d > 0)
        result.emplace_back(-d, q);
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  // Whether one of the vertices lowers the sum of the deficits: the best place is taken, or the first
  // without deficit.
  bool improve(const std::vector<int>& vertices)
  {
    best_change_ = -least_improvement;
    best_vertex_ = -1;
    for(int v : vertices)
      if(try_places(v))
        return true;
    if(best_vertex_ < 0)
      return false;
    lift(best_vertex_);
    // Only where the dual point of a cell is just on a surface, the domain may answer otherwise now.
    const bool is_accepted = trial_.move(best_site_, 0) < 0;
    if(is_accepted)
      accept();
    else
      trial_.reject();
    return is_accepted;
  }

  // Whether one was found, and accepted, that leaves no deficit.
  bool try_places(int v)
  {
    const Site from = trial_.site(v);
    lift(v);
    for(int n = 0; n < parameters_.tries_per_vertex; ++n)
    {
      const double farthest = n % 2 == 0 ? parameters_.farthest : parameters_.nearest;
      const Eigen::Vector3d d = trial_.mean_edge_length() * random_.uniform() * farthest * random_.direction();
      Site s = site_at(position(from) + d, from.weight);
      ++number_of_tries_;
      if(!trial_.place(s))
        continue;
      const double change = trial_.move(s, best_change_);
      if(!(change < best_change_))
        continue;
      if(trial_.deficit_after() == 0)
      {
        accept();
        return true;
      }
      best_change_ = change;
      best_vertex_ = v;
      best_site_ = s;
    }
    trial_.reject();
    return false;
  }

  void lift(int v)
  {
    number_of_tries_ += parameters_.tries_of_lift;
    trial_.lift(v);
  }

  void accept()
  {
    ++number_of_moves_;
    trial_.accept();
    const std::vector<Quadruple> slivers = trial_.new_slivers();
    slivers_.insert(slivers.begin(), slivers.end());
  }

  Trial& trial_;
  double bound_;
  Exact_sliver_removal_parameters parameters_;
  Random_source random_;
  std::set<Quadruple> slivers_;               // cells below the last bound, and such as have been
  std::map<Quadruple, int> failures_;
  double best_change_ = 0;
  int best_vertex_ = -1;
  Site best_site_ = { 0, 0, 0, 0 };
  std::size_t number_of_moves_ = 0, number_of_tries_ = 0;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_EXACT_SLIVER_REMOVAL_3_H
