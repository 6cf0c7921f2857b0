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

#include <CGAL/Global_odt_mesh_3/internal/Mesh_changes_3.h>
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
#include <CGAL/Mesh_optimization_report_3.h>
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

namespace CGAL::Global_odt_mesh_3::internal {

// Optimizes a c3t3 in a periodic triangulation.
//
// In each round, the mesh is cut open along the sides of a cube, and optimized as one that is not periodic, with vertices at the cut
// that stay. The next cut is elsewhere, so that they move then. A round whose result is not a valid periodic mesh is left out.
//
// A mesh that is so coarse that it has a triangulation of one sheet only with points of the lattice with which the mesh generator
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
    round_costs_ = reading_for_round * timer_.time();
    if(parameters_.time_limit > 0 && timer_.time() + 2 * round_costs_ > parameters_.time_limit)
      return TIME_LIMIT_REACHED;
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(mesh_.is_domain_of_mesh(), wrong_domain);
    set_input();
    break_ties();
    const double z = random_.uniform(), y = random_.uniform(), x = random_.uniform();
    first_corner_ = Vector_3(x, y, z);
    const Periodic_complex_3 input = complex_;
    while(goes_on_ && optimizations_ < number_of_optimizations && round_ < most_attempts)
      make_round();
    if(parameters_.do_remove_slivers)
      remove_slivers();
    // Where energies lead to angles that are smaller, the removal begins with the input.
    if(parameters_.do_remove_slivers && !result_ && is_changed_)
    {
      complex_ = input;
      remove_slivers();
    }
    if(result_)
      mesh_.write(*result_);
    return code();
  }

  // The same, with a report.
  Mesh_optimization_return_code operator()(Mesh_optimization_report_3<C3t3>& report)
  {
    report = Mesh_optimization_report_3<C3t3>();
    const Mesh_optimization_return_code code = (*this)();
    const Periodic_complex_3& last = result_ ? *result_ : complex_;
    if(result_)
      report.reason = Mesh_optimization_summary_3::CHANGED;
    else if(!goes_on_ || code == TIME_LIMIT_REACHED)
      report.reason = Mesh_optimization_summary_3::OUT_OF_TIME;
    else if(failures_ > 0 || is_changed_)
      report.reason = is_changed_ ? Mesh_optimization_summary_3::SMALLER_ANGLES : Mesh_optimization_summary_3::NO_VALID_MESH;
    report.sliver_bound = parameters_.sliver_bound > 0 ? parameters_.sliver_bound : Sliver_steps::angles[1];
    report.number_of_slivers = last.number_of_slivers(report.sliver_bound);
    report.number_of_iterations = iterations_;
    report.largest_volume_change = result_ ? largest_change(volumes_, result_->volumes()) : 0.;
    report.seconds.emplace_back("all", timer_.time());
    return code;
  }

private:
  typedef Periodic_mesh_3<C3t3, Mesh_domain> Mesh;

  static constexpr int first_step = 1, common_steps = 4;    // for 20 degrees, and up to 40
  static constexpr int number_of_optimizations = 2, most_attempts = 4, fewest_removals = 3, most_removals = 7;
  static constexpr int most_choices = 3;                    // of points of the lattice that stay
  static constexpr int most_tries = 5;                      // to rebuild a mesh
  static constexpr double worthwhile = 0.75;                // what a removal that pays leaves of what cells lack of the angle
  static constexpr double volume_tolerance = 0.02;
  static constexpr double size_of_perturbation = 1e-3;      // relative to the shortest edge at a vertex
  static constexpr double reading_for_round = 20;           // how many times longer than to read a mesh it takes to rebuild it

  // Counts iterations.
  struct Counter
    : public Optimization_visitor
  {
    void end_of_iteration(int) override { ++number; }

    std::size_t number = 0;
  };

  // The part of the period between the first cut and that of a round: as far from all before as possible (van der Corput, 1935).
  static double shift(int round)
  {
    double result = 0;
    for(double digit = 0.5; round > 0; round /= 2, digit /= 2)
      result += round % 2 * digit;
    return result;
  }

  // The share of the work and the time that are left that the next round may take.
  double share() const
  {
    if(removes())
      return 0.3;
    return optimizations_ + 1 < number_of_optimizations ? 0.4 : parameters_.do_remove_slivers ? 0.7 : 1.;
  }

  Mesh_optimization_return_code code() const
  {
    if(code_ == TIME_LIMIT_REACHED)
      return code_;
    const bool is_failure = !result_ && (is_changed_ || failures_ > 0);
    const bool wants_bound = code_ != MAX_ITERATION_NUMBER_REACHED && parameters_.do_remove_slivers && parameters_.sliver_bound > 0;
    const Periodic_complex_3& last = result_ ? *result_ : complex_;
    return is_failure || (wants_bound && last.deficit(parameters_.sliver_bound) > 0) ? CANT_IMPROVE_ANYMORE : code_;
  }

  // Or else vertices move to lower energies.
  bool removes() const { return step_ > 0; }

  // What a round wants: that of the step, so that a higher bound goes the way of a lower one, and then on. Without a bound, as much as is
  // worth it after the first step.
  double bound_of_round() const
  {
    return step_ > first_step && !(parameters_.sliver_bound > 0) ? 0 : Sliver_steps::angles[(std::max)(step_, first_step)];
  }

  // All steps are made up to that of the bound, and those that more bounds have in common as long as cells are left below it, so that it
  // is met where a higher one would meet it. Where the user has ended the optimization that leaves slivers, the first step keeps it
  // from being in vain.
  void remove_slivers()
  {
    const double bound = parameters_.sliver_bound;
    const int last_step = bound > 0 ? Sliver_steps::last(bound) : first_step + 1;
    const auto is_wanted = [&] { return step_ <= last_step || (step_ <= common_steps && complex_.deficit(bound) > 0); };
    for(step_ = first_step; goes_on_ && is_wanted(); ++step_)
      make_step();
    step_ = first_step;
    if(!goes_on_ && iterations_ > 0)
      make_step();
  }

  // Makes rounds until one has nothing left to do, or does not pay.
  void make_step()
  {
    const bool goes_on = goes_on_;
    const double bound = bound_of_round(), angle = bound > 0 ? bound : parameters_.wanted_angle();
    double before = (std::numeric_limits<double>::max)(), left = complex_.deficit(angle);
    const auto pays = [&](int n) { return n < fewest_removals || (goes_on && n < most_removals && left < worthwhile * before); };
    for(int n = 0; goes_on_ == goes_on && left > 0 && pays(n); ++n)
    {
      make_round();
      before = std::exchange(left, complex_.deficit(angle));
    }
  }

  void make_round()
  {
    const double s = shift(round_);
    const Vector_3 corner = complex_.cube.corner + complex_.cube.period * (first_corner_ + Vector_3(s, s, s));
    end_of_round_ = done_ + share() * (1 - done_);
    // The removal of slivers moves few vertices, and may succeed where the optimization has not.
    std::vector<char> stays = removes() || stays_.empty() ? std::vector<char>(complex_.sites.size(), false) : stays_;
    for(int n = 0; n < most_choices && try_round(corner, stays, n + 2 < most_choices); ++n) {}
    if(!removes())
      stays_ = std::move(stays);
    done_ = end_of_round_;
    ++round_;
  }

  // True if there is no triangulation of one sheet where the optimizer has led: then, points of the lattice stay the next time, if
  // possible `a_few`.
  bool try_round(const Vector_3& corner, std::vector<char>& stays, bool a_few)
  {
    const std::optional<Odt_parameters> p = parameters_of_round();
    if(!p)
      return false;

    Unrolled_mesh_3<Exact_predicates_inexact_constructions_kernel> unrolled(complex_, corner, stays);
    if(!unrolled.is_faithful())
    {
      ++failures_;
      return false;
    }
    Counter counter;
    const Odt_task task = removes() ? Odt_task::REMOVE_SLIVERS : Odt_task::OPTIMIZE;
    const Mesh_optimization_return_code code
      = optimize_mesh(unrolled, domain_, task, *p, User_field_3(), counter, Thread_policy());
    iterations_ += counter.number;
    if(!goes_on_)
      code_ = TIME_LIMIT_REACHED;
    else if(!removes() && code != CANT_IMPROVE_ANYMORE)
      code_ = code;
    if(!unrolled.is_changed())
    {
      failures_ += code == CANT_IMPROVE_ANYMORE;
      optimizations_ += !removes() && code != CANT_IMPROVE_ANYMORE;
      return false;
    }
    const std::vector<int>& large = unrolled.vertices_of_large_cells();
    const int failures = failures_;
    failures_ += !large.empty();
    const bool is_one_sheeted = large.empty() && adopt(unrolled.periodic_sites());
    optimizations_ += !removes() && failures_ == failures;
    return !is_one_sheeted && goes_on_ && choose_to_stay(large, a_few, stays);
  }

  // Points of the lattice: those among `vertices`, or else all. False if they have been chosen before.
  bool choose_to_stay(const std::vector<int>& vertices, bool a_few, std::vector<char>& stays) const
  {
    const std::vector<char> before = stays;
    for(int v : vertices)
      stays[v] = complex_.dimensions[v] < 0;
    if(!a_few || stays == before)
      for(std::size_t v = 0; v < stays.size(); ++v)
        stays[v] = complex_.dimensions[v] < 0;
    return stays != before;
  }

  // The parameters of the next round; none if there is nothing left to do.
  std::optional<Odt_parameters> parameters_of_round()
  {
    Odt_parameters p = parameters_;
    p.random_seed += static_cast<unsigned int>(round_);
    p.sliver_bound = bound_of_round();
    // Nearly all vertices move once more before slivers matter.
    if(!removes() && optimizations_ + 1 < number_of_optimizations)
      p.do_remove_slivers = false;
    if(p.max_iteration_number > 0 && !removes())
    {
      const std::size_t until_end = round_ == 0 ? p.max_iteration_number - p.max_iteration_number / 2 : p.max_iteration_number;
      if(until_end <= iterations_)
        return std::nullopt;
      p.max_iteration_number = until_end - iterations_;
    }
    if(p.time_limit > 0)
    {
      const int rounds = removes() ? 1 : number_of_optimizations - optimizations_ + 1;
      p.time_limit = share() * (p.time_limit - timer_.time() - rounds * round_costs_);
      if(!(p.time_limit > 0))
      {
        code_ = TIME_LIMIT_REACHED;
        goes_on_ = false;
        return std::nullopt;
      }
    }
    if(!goes_on_)
      p.callback = nullptr;
    else if(p.callback)
      p.callback = [this](double fraction)
      {
        reported_ = (std::max)(reported_, done_ + fraction * (end_of_round_ - done_));
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
    if(removes() && !candidate->slivers().is_not_worse_than(complex_.slivers(), true))
      return true;
    complex_ = std::move(*candidate);
    is_changed_ = true;
    if(!parameters_.do_remove_slivers || complex_.slivers().may_replace(slivers_of_input_, parameters_.sliver_bound))
      result_ = complex_;
    return true;
  }

  // If the domain does not fit somewhere, vertices go back, and where all have gone back, those around them.
  std::optional<Periodic_complex_3> rebuilt(std::vector<Site> sites)
  {
    const double begin = timer_.time();
    std::optional<Periodic_complex_3> result;
    std::vector<int> in_doubt;
    int tries = 0;
    do
    {
      revert(std::exchange(in_doubt, {}), sites);
      result = mesh_.rebuild(complex_, sites, in_doubt);
    }
    while(!result && !in_doubt.empty() && ++tries < most_tries);
    round_costs_ = 1.5 * (timer_.time() - begin);
    return result;
  }

  void revert(const std::vector<int>& in_doubt, std::vector<Site>& sites) const
  {
    std::vector<char> reverts(sites.size(), false);
    for(int v : in_doubt)
      reverts[v] = true;
    for(bool has_moved = false, grows = true; !has_moved && grows; grows = complex_.add_neighbors(reverts))
      for(std::size_t v = 0; v < sites.size(); ++v)
        if(reverts[v] && !same_place(sites[v], complex_.sites[v]))
        {
          sites[v] = complex_.sites[v];
          has_moved = true;
        }
  }

  // Compares topology and volumes.
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
  Vector_3 first_corner_;
  int round_ = 0, optimizations_ = 0, failures_ = 0;
  int step_ = 0;                            // of the removal of slivers, if that has begun
  std::vector<char> stays_;                 // of the lattice, when vertices move to lower energies
  bool goes_on_ = true, is_changed_ = false;
  std::size_t iterations_ = 0;
  double round_costs_ = 0;                  // in seconds, besides the optimization: to cut the mesh open, and to rebuild it
  double done_ = 0, end_of_round_ = 0, reported_ = 0;       // of the work
  Mesh_optimization_return_code code_ = CONVERGENCE_REACHED;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_OPTIMIZE_PERIODIC_MESH_3_H
