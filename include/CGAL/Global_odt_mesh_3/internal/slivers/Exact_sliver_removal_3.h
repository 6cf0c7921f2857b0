// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_EXACT_SLIVER_REMOVAL_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_EXACT_SLIVER_REMOVAL_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Exact_relocation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Sliver_steps.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_places.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

struct Exact_sliver_removal_parameters
{
  std::size_t tries_per_vertex = 8;
  double farthest = 0.35, nearest = 0.12;   // the longest tries, over the mean incident edge length, near ones first
  int scales = 3;                           // of these, the longest for as many failures as there are at least
  double ratio_of_scales = 1 / 4.;
  std::array<double, 3> shares_of_step = {{ 1, 0.5, 0.25 }};
  std::size_t most_steps = 3;               // tried for a cell
  std::array<double, 3> shares_of_radius = {{ 0.005, 0.05, 0.2 }};   // by how much a vertex enters a circumsphere
  int fewest_failures = 4, most_failures = 24;      // for the same cell: more where few cells are left
  double share_of_failures = 0.2;                   // of the tries
  std::size_t tries_of_failure = 40;
  int most_passes = 30;                     // with each bound
  int most_failures_of_worst = 120;         // for the cell with the smallest angle, which should rise by so many degrees:
  double rise_of_worst = 2;
  std::size_t tries_of_detachment = 8;            // to detach a vertex and put it back takes as long as so many tries
};

// Removes the cells with small dihedral angles by trials of single vertices of the exact complex, by bounds that rise
// step by step. As the facets on surfaces are exchanged along with the cells, it removes those that the indexed mesh, where
// facets are constrained, cannot. No trial is accepted that makes the smallest angle around it smaller, or more
// cells fall below one of the steps before; so that a higher bound never leads to less.
//
// A cell is helped by steps that promise more in first order; then by the vertices opposite
// to it in its neighbors, whose way into its circumsphere makes it go; then by random positions of its vertices and of
// these. A cell that nothing helps is left alone until it changes.
class Exact_sliver_removal_3
{
public:
  // The failures of cells, by their vertices.
  typedef std::map<Quadruple, int> Failures;

  // Cells that have failed often enough are left alone. The trial is to be moved by this object only.
  Exact_sliver_removal_3(Exact_relocation_3& trial, Failures& failures, unsigned int seed,
                         const Exact_sliver_removal_parameters& parameters = Exact_sliver_removal_parameters())
    : trial_(trial)
    , failures_(failures)
    , parameters_(parameters)
    , random_(seed)
  {}

  std::size_t number_of_moves() const { return number_of_moves_; }
  // Of places, with what detaching vertices costs.
  std::size_t number_of_tries() const { return number_of_tries_; }

  // Until there are no cells below the step, nothing improves them any more, the tries are used up, or `may_go_on()`,
  // asked before each cell, says no.
  template <class Predicate>
  void climb(int last_step, std::size_t most_tries, const Predicate& may_go_on)
  {
    find_slivers(Sliver_steps::angles[last_step]);
    most_tries += number_of_tries_;
    for(int step = 0; step <= last_step && make_passes(step, most_tries, may_go_on); ++step) {}
  }

  // Raises the smallest angle as far as `highest`, as long as the worst cell can be made better and there are tries.
  // No more cells than before are below the steps before the last.
  template <class Predicate>
  void raise_smallest_angle(int last_step, double highest, std::size_t most_tries, const Predicate& may_go_on)
  {
    find_slivers(highest);
    most_tries += number_of_tries_;
    int failures = 0;
    while(!slivers_.empty() && failures < parameters_.most_failures_of_worst)
    {
      const Sliver worst = *slivers_.begin();
      if(!is_still_there(worst))
        continue;
      if(number_of_tries_ >= most_tries || !may_go_on())
        return;
      trial_.set_goal((std::min)(worst.first + parameters_.rise_of_worst, highest_), last_step);
      failures = improve(worst.second, failures) ? 0 : failures + 1;
    }
  }

private:
  typedef std::pair<double, Quadruple> Sliver;          // with its smallest angle

  static constexpr double least_improvement = 1e-6;     // square degrees

  // False if it is to come to an end.
  template <class Predicate>
  bool make_passes(int step, std::size_t most_tries, const Predicate& may_go_on)
  {
    trial_.set_goal(Sliver_steps::angles[step], step);
    const double share = parameters_.share_of_failures * double(most_tries - (std::min)(number_of_tries_, most_tries));
    bool goes_on = true;
    for(int pass = 0; pass < parameters_.most_passes && goes_on; ++pass)
    {
      goes_on = false;
      const std::vector<Sliver> slivers(slivers_.begin(), slivers_.lower_bound({ Sliver_steps::angles[step], Quadruple() }));
      const int most_failures = failures_for_each(slivers.size(), share);
      for(const Sliver& s : slivers)
      {
        if(!is_still_there(s))
          continue;
        int& failures = failures_[s.second];
        if(failures >= most_failures)
          continue;
        if(number_of_tries_ >= most_tries || !may_go_on())
          return false;
        goes_on = true;
        if(!improve(s.second, failures))
          ++failures;
      }
    }
    return true;
  }

  // How often each of some cells may fail before the tries are used up.
  int failures_for_each(std::size_t number_of_slivers, double tries) const
  {
    const double failures = tries / double(parameters_.tries_of_failure * (std::max)(number_of_slivers, std::size_t(1)));
    return static_cast<int>((std::min)((std::max)(failures, double(parameters_.fewest_failures)),
                                       double(parameters_.most_failures)));
  }

  void find_slivers(double highest)
  {
    if(highest == highest_)                             // all trials since then have been followed
      return;
    highest_ = highest;
    slivers_.clear();
    for(const Quadruple& q : trial_.slivers(highest_))
      slivers_.emplace(trial_.smallest_angle(q), q);
  }

  // Those that are not any more are forgotten.
  bool is_still_there(const Sliver& s)
  {
    const double angle = trial_.smallest_angle(s.second);
    if(angle == s.first)
      return true;
    slivers_.erase(s);
    if(angle < highest_)
      slivers_.emplace(angle, s.second);
    return false;
  }

  bool improve(const Quadruple& q, int failures)
  {
    if(failures == 0)
      return try_steps(trial_.movable_vertices(q)) || try_entering(q);
    const bool is_beyond = failures % 2 == 0;
    return try_vertices(is_beyond ? trial_.movable_vertices_beyond(q) : trial_.movable_vertices(q), scale(failures));
  }

  // Of the places, over the longest: after the first failures, two with each scale.
  double scale(int failures) const
  {
    const int n = (std::max)(failures - parameters_.fewest_failures, 0) / 2;
    return std::pow(parameters_.ratio_of_scales, n % parameters_.scales);
  }

  // Whether a step is accepted: those that promise most come first.
  bool try_steps(const std::vector<int>& vertices)
  {
    std::vector<Promising_step> steps;
    for(int v : vertices)
      trial_.find_steps(v, parameters_.farthest, parameters_.shares_of_step, steps);
    std::sort(steps.begin(), steps.end(), [](const Promising_step& a, const Promising_step& b) { return a.change < b.change; });
    for(std::size_t n = 0; n < (std::min)(steps.size(), parameters_.most_steps); ++n)
    {
      Site s = steps[n].site;
      detach(steps[n].vertex);
      ++number_of_tries_;
      if(trial_.place(s) && trial_.move(s, -least_improvement) < -least_improvement)
      {
        accept();
        return true;
      }
      trial_.reject();
    }
    return false;
  }

  // Whether a vertex in the circumsphere lowers the sum of the deficits.
  bool try_entering(const Quadruple& q)
  {
    const auto& shares = parameters_.shares_of_radius;
    start_search();
    for(int v : trial_.movable_vertices_beyond(q))
      if(try_places(v, shares.size(), [&](std::size_t n) { return trial_.place_in_sphere(q, shares[n]); }))
        return true;
    return take_best();
  }

  // Whether a random place of one of the vertices does.
  bool try_vertices(const std::vector<int>& vertices, double scale)
  {
    start_search();
    for(int v : vertices)
    {
      const Site from = trial_.site(v);
      const auto random_place = [&](std::size_t n) -> std::optional<Site>
      {
        const double farthest = scale * (2 * n < parameters_.tries_per_vertex ? parameters_.nearest : parameters_.farthest);
        const Eigen::Vector3d d = trial_.mean_edge_length() * random_.uniform() * farthest * random_.direction();
        return site_at(position(from) + d, from.weight);
      };
      if(try_places(v, parameters_.tries_per_vertex, random_place))
        return true;
    }
    return take_best();
  }

  // The best place of those that are tried is taken, or the first without deficit.
  void start_search()
  {
    best_change_ = -least_improvement;
    best_vertex_ = -1;
  }

  bool take_best()
  {
    if(best_vertex_ < 0)
      return false;
    detach(best_vertex_);
    // Only where the dual point of a cell is just on a surface, the domain may answer otherwise now.
    const bool is_accepted = trial_.move(best_site_, 0) < 0;
    if(is_accepted)
      accept();
    else
      trial_.reject();
    return is_accepted;
  }

  // Whether one was found, and accepted, that leaves no deficit. `place(n)`, asked when the vertex is detached, gives one or none.
  template <class Place>
  bool try_places(int v, std::size_t number, const Place& place)
  {
    detach(v);
    for(std::size_t n = 0; n < number; ++n)
    {
      std::optional<Site> wanted = place(n);
      ++number_of_tries_;
      if(!wanted || !trial_.place(*wanted))
        continue;
      const Site& s = *wanted;
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

  void detach(int v)
  {
    number_of_tries_ += parameters_.tries_of_detachment;
    trial_.detach(v);
  }

  void accept()
  {
    ++number_of_moves_;
    trial_.accept();
    for(const Quadruple& q : trial_.new_slivers(highest_))
    {
      slivers_.emplace(trial_.smallest_angle(q), q);
      failures_.erase(q);
    }
  }

  Exact_relocation_3& trial_;
  Failures& failures_;
  Exact_sliver_removal_parameters parameters_;
  Random_source random_;
  double highest_ = 0;
  std::set<Sliver> slivers_;                  // cells below the highest angle, the worst first, and such as have been
  double best_change_ = 0;
  int best_vertex_ = -1;
  Site best_site_ = { 0, 0, 0, 0 };
  std::size_t number_of_moves_ = 0, number_of_tries_ = 0;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_EXACT_SLIVER_REMOVAL_3_H
