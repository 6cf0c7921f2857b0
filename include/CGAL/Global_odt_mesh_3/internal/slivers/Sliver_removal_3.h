// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_REMOVAL_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_REMOVAL_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_updater_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Editable_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Vertex_cavity_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Vertex_trial_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/sizing/Size_criteria_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <iterator>
#include <optional>
#include <unordered_map>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

struct Sliver_removal_parameters
{
  std::size_t tries_per_vertex = 32;
  double farthest = 0.35, nearest = 0.12;   // the longest moves, over the mean incident edge length, near ones first
  std::array<double, 3> shares_of_step = {{ 1, 0.5, 0.25 }};
  std::size_t most_steps = 3;               // tried for a cell
  std::array<double, 3> shares_of_radius = {{ 0.005, 0.05, 0.2 }};   // by how much a vertex enters a circumsphere
  std::array<double, 3> shares_of_weight = {{ 0.001, 0.01, 0.05 }};  // beyond what lets another vertex enter, over the squared edge
  int fewest_failures = 2, most_failures = 8;      // for each cell: more if few cells are left
  double share_of_failures = 0.2;                   // of the tries
  std::size_t tries_of_failure = 150;
  int most_passes = 30;                     // for each step
  int most_trials_of_worst = 120;          // of the worst cell, until its angle has risen by so many degrees:
  double least_rise = 0.1;
  double rise_of_worst = 2;                // the rise that is aimed at
  std::size_t tries_of_start = 4;                 // starting with another vertex costs this many tries
};

// Removes cells with small dihedral angles by trials of single vertices, with bounds that rise step by step. No trial is accepted
// if it makes the smallest angle around it smaller, or makes more cells fall below one of the steps before, so a higher bound never
// leads to a worse mesh.
//
// For each cell, steps that promise more in first order are tried first; then vertices opposite to it in its neighbors, since it
// goes when they enter its circumsphere; then random positions of all these vertices. Vertices of a boundary at rest may get
// another weight instead. A cell that nothing helps is left alone until it gives way to another.
//
// Proposals are made for several cells at once, by threads if these may ask the domain, and then accepted one by one.
class Sliver_removal_3
{
public:
  // Starts with the cells below the step's angle.
  Sliver_removal_3(Editable_complex_3& complex, int step, unsigned int seed,
                   const Sliver_removal_parameters& parameters = Sliver_removal_parameters())
    : complex_(complex)
    , step_(step)
    , seed_(seed)
    , parameters_(parameters)
    , trial_(complex)
    , slivers_(complex.slivers(Sliver_steps::angles[step]))
  {
    for(int n = 0; n < chunks_of_batch; ++n)
      trials_.emplace_back(complex);
  }

  // The number of slivers that are left.
  std::size_t number_of_slivers() const
  {
    return std::count_if(slivers_.begin(), slivers_.end(), [this](const Sliver_3& s) { return complex_.has(s); });
  }

  std::size_t number_of_moves() const { return number_of_moves_; }
  // The number of places tried, plus the cost of starting with vertices.
  std::size_t number_of_tries() const { return number_of_tries_; }

  // Goes on until there are no slivers, nothing improves them, the tries are used up, or `may_go_on()`, asked now and then, says
  // no.
  template <class Predicate>
  void raise_angles(std::size_t most_tries, const Predicate& may_go_on)
  {
    most_tries += number_of_tries_;
    for(int step = 0; step <= step_ && make_passes(step, most_tries, may_go_on); ++step) {}
  }

  // Raises the smallest angle up to the step's angle, as long as it makes progress and tries are left: cells that only take turns
  // as the worst would use up all tries. No more cells than before fall below the steps before.
  template <class Predicate>
  void raise_smallest_angle(std::size_t most_tries, const Predicate& may_go_on)
  {
    most_tries += number_of_tries_;
    const auto is_better = [](const Sliver_3& a, const Sliver_3& b) { return b < a; };
    std::make_heap(slivers_.begin(), slivers_.end(), is_better);
    double reached = 0;
    for(int failures = 0, trials = 0; !slivers_.empty(); )
    {
      const Sliver_3 worst = slivers_.front();
      if(!complex_.has(worst))
      {
        std::pop_heap(slivers_.begin(), slivers_.end(), is_better);
        slivers_.pop_back();
        continue;
      }
      if(worst.angle >= reached + parameters_.least_rise)
      {
        reached = worst.angle;
        trials = 0;
      }
      if(trials++ >= parameters_.most_trials_of_worst || number_of_tries_ >= most_tries || !may_go_on())
        return;
      set_goal(Sliver_goal((std::min)(worst.angle + parameters_.rise_of_worst, Sliver_steps::angles[step_]), step_));
      const Proposal proposal = propose(trial_, worst, failures);
      number_of_tries_ += proposal.tries;
      failures = accept(proposal) ? 0 : failures + 1;
      if(failures == 0)
        std::make_heap(slivers_.begin(), slivers_.end(), is_better);
    }
  }

private:
  typedef Random_numbers<Split_mix_engine> Random;

  // A place for a vertex that improves a cell, if there is one.
  struct Proposal
  {
    double change = -least_improvement;
    int vertex = -1;
    Site site = { 0, 0, 0, 0 };
    std::size_t tries = 0;
  };

  static constexpr double least_improvement = 1e-6;     // square degrees
  static constexpr int cells_of_batch = 32, chunks_of_batch = 8;

  void set_goal(const Sliver_goal& goal)
  {
    trial_.set_goal(goal);
    for(Vertex_trial_3& trial : trials_)
      trial.set_goal(goal);
  }

  // False if the removal has to end.
  template <class Predicate>
  bool make_passes(int step, std::size_t most_tries, const Predicate& may_go_on)
  {
    set_goal(Sliver_goal(Sliver_steps::angles[step], step_));
    const double share = parameters_.share_of_failures * double(most_tries - (std::min)(number_of_tries_, most_tries));
    bool goes_on = true;
    for(int pass = 0; pass < parameters_.most_passes && goes_on; ++pass)
    {
      const std::vector<Sliver_3> slivers = slivers_to_try(step, share);
      goes_on = !slivers.empty();
      for(const std::vector<Sliver_3>& disjoint : disjoint_slivers(slivers))
        for(std::size_t begin = 0; begin < disjoint.size(); begin += cells_of_batch)
        {
          if(number_of_tries_ >= most_tries || !may_go_on())
            return false;
          improve(disjoint, begin, (std::min)(begin + cells_of_batch, disjoint.size()));
        }
    }
    return true;
  }

  // The slivers below the step that have not failed too often, the worst first.
  std::vector<Sliver_3> slivers_to_try(int step, double tries)
  {
    slivers_.erase(std::remove_if(slivers_.begin(), slivers_.end(), [this](const Sliver_3& s) { return !complex_.has(s); }),
                   slivers_.end());
    std::sort(slivers_.begin(), slivers_.end());
    const auto end = std::find_if(slivers_.begin(), slivers_.end(), [step](const Sliver_3& s) { return s.angle >= Sliver_steps::angles[step]; });
    std::vector<Sliver_3> result(slivers_.begin(), end);
    const int most_failures = failures_for_each(result.size(), tries);
    result.erase(std::remove_if(result.begin(), result.end(), [=](const Sliver_3& s) { return complex_.triangulation.failures(s.cell) >= most_failures; }),
                 result.end());
    return result;
  }

  // How often each of the slivers may fail before the tries are used up.
  int failures_for_each(std::size_t number_of_slivers, double tries) const
  {
    const double failures = tries / double(parameters_.tries_of_failure * (std::max)(number_of_slivers, std::size_t(1)));
    return static_cast<int>((std::min)((std::max)(failures, double(parameters_.fewest_failures)),
                                       double(parameters_.most_failures)));
  }

  // Sets of slivers without common vertices: helping one changes what would help the others at its vertices.
  static std::vector<std::vector<Sliver_3>> disjoint_slivers(const std::vector<Sliver_3>& slivers)
  {
    std::vector<std::vector<Sliver_3>> result;
    std::unordered_map<int, std::size_t> sets_at_vertex;
    for(const Sliver_3& s : slivers)
    {
      std::size_t n = 0;
      for(int v : s.vertices)
        n = (std::max)(n, sets_at_vertex[v]);
      for(int v : s.vertices)
        sets_at_vertex[v] = n + 1;
      result.resize((std::max)(result.size(), n + 1));
      result[n].push_back(s);
    }
    return result;
  }

  // Improves some of the slivers, as far as they still exist.
  void improve(const std::vector<Sliver_3>& slivers, std::size_t begin, std::size_t end)
  {
    std::vector<Sliver_3> batch;
    std::copy_if(slivers.begin() + begin, slivers.begin() + end, std::back_inserter(batch),
                 [this](const Sliver_3& s) { return complex_.has(s); });
    std::vector<Proposal> proposals(batch.size());
    const Chunks chunks(static_cast<int>(batch.size()), 1, chunks_of_batch);
    complex_.domain.threads().for_each_chunk(chunks.number(), [&](int k)
    {
      for(int n = chunks.begin(k); n < chunks.end(k); ++n)
        proposals[n] = propose(trials_[k], batch[n], complex_.triangulation.failures(batch[n].cell));
    });
    for(std::size_t n = 0; n < batch.size(); ++n)
    {
      number_of_tries_ += proposals[n].tries;
      if(complex_.has(batch[n]) && !accept(proposals[n]))
        complex_.triangulation.add_failure(batch[n].cell);
    }
  }

  // Moves the vertex if that still helps, as other vertices may have moved since the proposal; whether it was moved.
  bool accept(const Proposal& p)
  {
    if(p.vertex < 0 || !trial_.start(p.vertex) || !(trial_.move(p.site, -least_improvement) < -least_improvement)
       || !trial_.accept())
      return false;
    ++number_of_moves_;
    for(const Vertex_cavity_3::Cell* c : trial_.cavity().new_cells())
      if(c->label != Domain_view_3::outside)
        complex_.add_sliver(c->number, Sliver_steps::angles[step_], slivers_);
    return true;
  }

  Proposal propose(Vertex_trial_3& trial, const Sliver_3& s, int failures) const
  {
    Proposal best;
    if(failures == 0)
    {
      if(!find_step(trial, s, best))
        enter_sphere(trial, s, best);
      if(best.vertex < 0)
        change_weight(trial, s, best);
      return best;
    }
    const std::vector<int> vertices = failures % 2 == 0 ? trial.movable_vertices_beyond(s.cell) : trial.movable_vertices(s.vertices);
    std::uint64_t seed = seed_;
    for(int v : s.vertices)
      seed = Split_mix_engine(seed, v)();
    Random random(Split_mix_engine(seed, failures));
    for(int v : vertices)
    {
      const auto random_place = [&](std::size_t n) -> std::optional<Site>
      {
        const double farthest = 2 * n < parameters_.tries_per_vertex ? parameters_.nearest : parameters_.farthest;
        const Vector_3 direction = random.direction();
        const Vector_3 d = trial.mean_edge_length() * random.uniform() * farthest * direction;
        return site_at(position(trial.from()) + d, trial.from().weight);
      };
      if(try_places(trial, v, parameters_.tries_per_vertex, random_place, best))
        return best;
    }
    return best;
  }

  // Finds the first step that reduces the deficits, among the most promising ones.
  bool find_step(Vertex_trial_3& trial, const Sliver_3& s, Proposal& best) const
  {
    std::vector<Promising_step> steps;
    for(int v : trial.movable_vertices(s.vertices))
      if(trial.start(v))
        trial.find_steps(parameters_.farthest, parameters_.shares_of_step, steps);
    std::sort(steps.begin(), steps.end(), [](const Promising_step& a, const Promising_step& b) { return a.change < b.change; });
    steps.resize((std::min)(steps.size(), parameters_.most_steps));
    for(const Promising_step& step : steps)
    {
      Site to = step.site;
      ++best.tries;
      // Shares of the same step usually follow each other.
      if(step.vertex != trial.vertex())
      {
        best.tries += parameters_.tries_of_start;
        trial.start(step.vertex);
      }
      if(!(trial.move_near(to, best.change) < best.change))
        continue;
      best.vertex = step.vertex;
      best.site = to;
      return true;
    }
    return false;
  }

  // Proposes a vertex that enters the circumsphere of the cell.
  void enter_sphere(Vertex_trial_3& trial, const Sliver_3& s, Proposal& best) const
  {
    const auto& shares = parameters_.shares_of_radius;
    const Quadruple q = complex_.triangulation.vertices(s.cell);
    for(int v : trial.movable_vertices_beyond(s.cell))
      if(try_places(trial, v, shares.size(), [&](std::size_t n) { return trial.place_in_sphere(q, shares[n]); }, best))
        return;
  }

  // Lets a vertex enter the circumsphere by another weight of a vertex that stays.
  void change_weight(Vertex_trial_3& trial, const Sliver_3& s, Proposal& best) const
  {
    const auto& shares = parameters_.shares_of_weight;
    const Quadruple q = complex_.triangulation.vertices(s.cell);
    for(int beyond : complex_.triangulation.vertices_beyond(s.cell))
      for(int v : { q[0], q[1], q[2], q[3], beyond })
        if(beyond >= 0 && complex_.may_gain_weight(v)
           && try_places(trial, v, shares.size(), [&](std::size_t n) { return trial.place_with_weight(q, beyond, shares[n]); }, best))
          return;
  }

  // Finds the best of some places, or the first without deficit; whether the latter was found. `place(n)` is a site or none.
  template <class Place>
  bool try_places(Vertex_trial_3& trial, int v, std::size_t number, const Place& place, Proposal& best) const
  {
    best.tries += parameters_.tries_of_start;
    if(!trial.start(v))
      return false;
    for(std::size_t n = 0; n < number; ++n)
    {
      std::optional<Site> s = place(n);
      ++best.tries;
      const double change = s ? trial.move_near(*s, best.change) : 0.;
      if(!(change < best.change))
        continue;
      best.change = change;
      best.vertex = v;
      best.site = *s;
      if(trial.deficit_after() == 0)
        return true;
    }
    return false;
  }

  Editable_complex_3& complex_;
  int step_;
  unsigned int seed_;
  Sliver_removal_parameters parameters_;
  Vertex_trial_3 trial_;
  std::deque<Vertex_trial_3> trials_;         // of the chunks of a batch
  std::vector<Sliver_3> slivers_;             // cells below the step, also former ones
  std::size_t number_of_moves_ = 0, number_of_tries_ = 0;
};

// Removes slivers from a complex step by step. No step gives up what an earlier one has reached, and no step depends on the wanted
// bound, so a higher bound never leads to a worse mesh.
class Sliver_stage_3
{
public:
  // `bound` is the dihedral angle, in degrees, that cells should exceed, or 0 for as large an angle as possible. The complex is
  // regular.
  Sliver_stage_3(Complex_updater_3& complex, const Circumradius_bound_3& size_bound, double bound, unsigned int seed)
    : complex_(complex)
    , size_bound_(size_bound)
    , bound_(bound)
    , seed_(seed)
  {}

  // Makes steps as long as there is time and `may_go_on()` permits.
  template <class Has_time, class May_go_on>
  void run(const Has_time& has_time, const May_go_on& may_go_on)
  {
    bool goes_on = true;
    for(int step = first_step; goes_on && step <= Sliver_steps::last(bound_) && may_go_on(); ++step)
      goes_on = make_step(step, has_time);
  }

private:
  static constexpr int first_step = 1;
  // The number of tries is proportional to the cells and to the slivers at the first step.
  static constexpr std::size_t fewest_tries = 10000, tries_for_two_cells = 5, tries_for_a_sliver = 80;
  static constexpr std::size_t tries_for_a_removed_cell = 100;      // for each removed cell, more tries pay
  static constexpr double share_of_passes = 0.8;         // of the tries; the others are for the worst cells
  // Without a bound, a step above this angle is not taken if cells are left below the step before, or too many below its own.
  static constexpr double always_wanted = 30, most_slivers = 1 / 25.;

  // Whether a step with this many slivers is worthwhile.
  bool is_worthwhile(int step, std::size_t slivers, const Editable_complex_3& complex) const
  {
    return bound_ > 0 || Sliver_steps::angles[step] <= always_wanted
           || (double(slivers) < most_slivers * double(complex.triangulation.cells().size())
               && complex.slivers(Sliver_steps::angles[step - 1]).empty());
  }

  // Whether another step may reach more.
  template <class Has_time>
  bool make_step(int step, const Has_time& has_time)
  {
    Editable_complex_3 complex = complex_.edit();
    complex.size_bound = size_bound_;
    Sliver_removal_3 removal(complex, step, seed_++);
    const std::size_t before = removal.number_of_slivers();
    if(!is_worthwhile(step, before, complex))
      return false;
    if(step == first_step)
      most_tries_ = fewest_tries + tries_for_two_cells * complex.triangulation.cells().size() / 2 + tries_for_a_sliver * before;
    const std::size_t left = most_tries_ - (std::min)(number_of_tries_, most_tries_);
    removal.raise_angles(std::size_t(share_of_passes * double(left)), has_time);
    removal.raise_smallest_angle(left - (std::min)(removal.number_of_tries(), left), has_time);
    number_of_tries_ += removal.number_of_tries();
    const std::size_t after = removal.number_of_slivers();
    if(!complex_.adopt(complex))
      return false;
    // A few cells that nothing helps may use up all tries. Removed cells earn more tries, or else the next step would do nothing.
    const std::size_t tries_for_removed = tries_for_a_removed_cell * (before - (std::min)(before, after));
    most_tries_ = (step == first_step ? (std::max)(most_tries_, number_of_tries_) : most_tries_) + tries_for_removed;
    return removal.number_of_moves() > 0 || after == 0;
  }

  Complex_updater_3& complex_;
  Circumradius_bound_3 size_bound_;
  double bound_;
  unsigned int seed_;
  std::size_t most_tries_ = 0, number_of_tries_ = 0;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_REMOVAL_3_H
