// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_OPTIMIZE_PERIODIC_MESH_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_OPTIMIZE_PERIODIC_MESH_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Mesh_optimizer_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Odt_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Periodic_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Periodic_mesh_3.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Unrolled_mesh_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Optimization_visitor.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/User_field_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_optimization_return_code.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Optimizes a c3t3 in a periodic triangulation.
//
// In each round, the mesh is cut open along the sides of a cube, and optimized as one that is not periodic, with vertices at the cut
// that stay. The next cut is elsewhere, so that they move then. A round whose result is not a valid periodic mesh is left out.
//
// A mesh that is so coarse that it has a triangulation of one sheet only with the points of the lattice with which the mesh generator
// begins keeps these where they are.
template <class C3t3, class Mesh_domain>
class Periodic_mesh_optimizer_3
{
public:
  // Refers to its arguments.
  Periodic_mesh_optimizer_3(C3t3& c3t3, const Mesh_domain& domain, const Odt_parameters& parameters)
    : domain_of_mesh_(domain, Mesh::cube(c3t3.triangulation()))
    , domain_(domain_of_mesh_)
    , mesh_(c3t3, domain_)
    , parameters_(parameters)
    , random_(parameters.random_seed)
  {
    timer_.start();
  }

  Periodic_mesh_optimizer_3(const Periodic_mesh_optimizer_3&) = delete;
  Periodic_mesh_optimizer_3& operator=(const Periodic_mesh_optimizer_3&) = delete;

  Mesh_optimization_return_code operator()()
  {
    if(!mesh_.is_one_sheeted())
      return CANT_IMPROVE_ANYMORE;
    complex_ = mesh_.read();
    set_input();
    break_ties();
    const double z = random_.uniform(), y = random_.uniform(), x = random_.uniform();
    const Vector_3 first_corner(x, y, z);
    for(round_ = 0; goes_on_ && removals_pay_ && step() < number_of_steps(); ++round_)
      make_round(first_corner);
    // Where the user has ended the optimization that leaves slivers, the first step of their removal keeps it from being in vain.
    if(!goes_on_ && is_changed_)
    {
      optimizations_ = number_of_optimizations;
      for(round_ = 0; round_ < fewest_removals && !result_; ++round_)
        make_round(first_corner);
    }
    if(result_)
      mesh_.write(*result_);
    return code();
  }

private:
  typedef Periodic_mesh_3<C3t3, Mesh_domain> Mesh;

  static constexpr int number_of_optimizations = 2, most_attempts = 4, fewest_removals = 3, most_removals = 7;
  static constexpr double worthwhile = 0.75;                // what a removal that pays leaves of what cells lack of the angle
  static constexpr double volume_tolerance = 0.02;
  static constexpr double size_of_perturbation = 1e-3;      // relative to the shortest edge at a vertex

  // Counts iterations.
  struct Counter
    : public Optimization_visitor
  {
    void end_of_iteration(int) override { ++number; }

    std::size_t number = 0;
  };

  // Of the period, between the first cut and that of a round: as far from all before as can be (van der Corput, 1935).
  static double shift(int round)
  {
    double result = 0;
    for(double digit = 0.5; round > 0; round /= 2, digit /= 2)
      result += round % 2 * digit;
    return result;
  }

  int number_of_steps() const { return number_of_optimizations + (parameters_.do_remove_slivers ? most_removals : 0); }

  // Of the work, in time.
  double share_before(int step) const
  {
    constexpr std::array<double, number_of_optimizations + most_removals + 1> shares
      = {{ 0, 0.35, 0.8, 0.86, 0.91, 0.95, 0.97, 0.98, 0.99, 1 }};
    return shares[step] / shares[number_of_steps()];
  }

  Mesh_optimization_return_code code() const
  {
    if(!goes_on_ || code_ == TIME_LIMIT_REACHED)
      return code_;
    const bool is_failure = !result_ && (is_changed_ || failures_ > 0);
    const bool removes_slivers
      = code_ != MAX_ITERATION_NUMBER_REACHED && parameters_.do_remove_slivers && parameters_.sliver_bound > 0;
    const Periodic_complex_3& last = result_ ? *result_ : complex_;
    return is_failure || (removes_slivers && last.deficit(parameters_.sliver_bound) > 0) ? CANT_IMPROVE_ANYMORE : code_;
  }

  // Or else slivers are removed, and nothing else. Where a result is not valid, another cut may do better.
  bool optimizes() const { return optimizations_ < number_of_optimizations && round_ < most_attempts; }

  // Where the round is in the work.
  int step() const { return optimizes() ? optimizations_ : number_of_optimizations + removals_; }

  void make_round(const Vector_3& first_corner)
  {
    const double s = shift(round_);
    const Vector_3 corner = complex_.cube.corner + complex_.cube.period * (first_corner + Vector_3(s, s, s));
    const bool removes = !optimizes();
    // The removal of slivers moves few vertices, and may succeed where the optimization has not.
    const bool lattice_moves = lattice_moves_ || removes;
    if(!try_round(corner, lattice_moves) && lattice_moves && goes_on_)
    {
      lattice_moves_ = false;
      try_round(corner, false);
    }
    if(!removes)
      return;
    const double before = std::exchange(deficit_, complex_.deficit(parameters_.wanted_angle()));
    removals_pay_ = ++removals_ < fewest_removals || deficit_ < worthwhile * before;
  }

  // False if there is no triangulation of one sheet where the optimizer has led.
  bool try_round(const Vector_3& corner, bool lattice_moves)
  {
    const std::optional<Odt_parameters> p = parameters_of_round();
    if(!p)
      return true;
    Unrolled_mesh_3<Exact_predicates_inexact_constructions_kernel> unrolled(complex_, corner, lattice_moves);
    if(!unrolled.is_faithful())
    {
      ++failures_;
      return true;
    }
    Counter counter;
    const Odt_task task = optimizes() ? Odt_task::OPTIMIZE : Odt_task::REMOVE_SLIVERS;
    const Mesh_optimization_return_code code
      = optimize_mesh(unrolled, domain_, task, *p, User_field_3(), counter, Thread_policy());
    iterations_ += counter.number;
    if(code == TIME_LIMIT_REACHED || (optimizes() && (unrolled.is_changed() || code != CANT_IMPROVE_ANYMORE)))
      code_ = code;
    const int failures = failures_;
    failures_ += unrolled.is_changed() ? !unrolled.may_have_one_sheet() : code == CANT_IMPROVE_ANYMORE;
    const bool is_one_sheeted = !unrolled.is_changed() || (unrolled.may_have_one_sheet() && adopt(unrolled.periodic_sites()));
    optimizations_ += optimizes() && failures_ == failures;
    return is_one_sheeted;
  }

  // None if there is nothing left to do.
  std::optional<Odt_parameters> parameters_of_round()
  {
    Odt_parameters p = parameters_;
    p.random_seed += static_cast<unsigned int>(round_);
    // Nearly all vertices move once more before slivers matter.
    if(optimizes() && optimizations_ + 1 < number_of_optimizations)
      p.do_remove_slivers = false;
    if(p.max_iteration_number > 0 && optimizes())
    {
      const std::size_t until_end = round_ == 0 ? p.max_iteration_number - p.max_iteration_number / 2 : p.max_iteration_number;
      if(until_end <= iterations_)
        return std::nullopt;
      p.max_iteration_number = until_end - iterations_;
    }
    if(p.time_limit > 0)
    {
      const int rebuildings = (std::max)(1, number_of_optimizations + fewest_removals - step());
      const double left = p.time_limit - timer_.time() - rebuilding_ * rebuildings;
      p.time_limit = left * (share_before(step() + 1) - share_before(step())) / (1 - share_before(step()));
      if(!(p.time_limit > 0))
      {
        code_ = TIME_LIMIT_REACHED;
        goes_on_ = false;
        return std::nullopt;
      }
    }
    if(!goes_on_)
    {
      p.callback = nullptr;
      p.sliver_bound = Sliver_steps::angles[1];
    }
    else if(p.callback)
      p.callback = [this](double fraction)
      {
        const double begin = share_before(step()), end = share_before(step() + 1);
        reported_ = (std::max)(reported_, begin + fraction * (end - begin));
        goes_on_ = parameters_.callback(reported_);
        return goes_on_;
      };
    return p;
  }

  // Moves vertices of the interior a little: where cells have a common sphere, as those of the lattice have with which the mesh
  // generator begins, the triangulation of copies may have others. If dual points lie on the surface, or the mesh is so coarse that
  // the mesh generator has missed cells, labels get those of the domain.
  void break_ties()
  {
    const std::vector<double> freedom = complex_.freedom_of_interior();
    std::vector<Site> sites = complex_.sites;
    for(std::size_t v = 0; v < sites.size(); ++v)
      if(freedom[v] > 0)
        sites[v] = site_at(complex_.cube.canonical(position(sites[v]) + size_of_perturbation * freedom[v] * random_.direction()), 0);
    std::optional<Periodic_complex_3> candidate = rebuilt(std::move(sites));
    const bool is_like = candidate && is_like_input(*candidate);
    if(!candidate || (!is_like && mesh_.is_labelled_by_domain(complex_)))
      return;
    complex_ = std::move(*candidate);
    if(!is_like)
      set_input();
  }

  // What is kept is kept of this complex.
  void set_input()
  {
    slivers_of_input_ = complex_.slivers();
    volumes_ = complex_.volumes();
    topology_ = complex_.topology_of_patches();
  }

  // Goes to these vertices if that makes a valid complex that is like the input. False if it makes none at all.
  bool adopt(std::vector<Site> sites)
  {
    std::optional<Periodic_complex_3> candidate = rebuilt(std::move(sites));
    if(!candidate || !is_like_input(*candidate))
    {
      ++failures_;
      return candidate.has_value();
    }
    complex_ = std::move(*candidate);
    is_changed_ = true;
    if(!parameters_.do_remove_slivers || complex_.slivers().may_replace(slivers_of_input_, parameters_.sliver_bound))
      result_ = complex_;
    return true;
  }

  std::optional<Periodic_complex_3> rebuilt(std::vector<Site> sites)
  {
    const double begin = timer_.time();
    std::optional<Periodic_complex_3> result = mesh_.rebuild(complex_, std::move(sites));
    rebuilding_ = timer_.time() - begin;
    return result;
  }

  // In topology and volumes.
  bool is_like_input(const Periodic_complex_3& candidate) const
  {
    const std::map<int, double> volumes = candidate.volumes();
    return candidate.topology_of_patches() == topology_
           && std::equal(volumes.begin(), volumes.end(), volumes_.begin(), volumes_.end(), [](const auto& v, const auto& w)
                         { return v.first == w.first && std::abs(v.second - w.second) <= volume_tolerance * w.second; });
  }

  Periodic_domain_3<Mesh_domain> domain_of_mesh_;
  typename Mesh::Domain_view domain_;
  Mesh mesh_;
  const Odt_parameters& parameters_;
  Random_source random_;
  Real_timer timer_;
  Periodic_complex_3 complex_;              // the last that is valid
  std::optional<Periodic_complex_3> result_;    // the last whose slivers are not worse than those of the input
  Sliver_census_3 slivers_of_input_;
  std::map<int, double> volumes_;           // of the input
  std::map<int, std::array<long, 3> > topology_;
  int round_ = 0, optimizations_ = 0, removals_ = 0, failures_ = 0;
  double deficit_ = (std::numeric_limits<double>::max)();   // after the last removal
  bool removals_pay_ = true, lattice_moves_ = true;
  bool goes_on_ = true, is_changed_ = false;
  std::size_t iterations_ = 0;
  double rebuilding_ = 0;                   // seconds
  double reported_ = 0;                     // of the work
  Mesh_optimization_return_code code_ = CANT_IMPROVE_ANYMORE;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_OPTIMIZE_PERIODIC_MESH_3_H
