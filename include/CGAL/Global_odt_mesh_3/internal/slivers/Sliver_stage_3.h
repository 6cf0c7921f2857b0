// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_STAGE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_STAGE_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Candidate_checks_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_updater_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Exact_relocation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Sliver_steps.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Cell_angles.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Exact_sliver_removal_3.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Sliver_improvement_3.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Sliver_removal_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Half_facet.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Removal of slivers from a complex, step by step: those of the indexed mesh first, where a try takes microseconds but
// facets on surfaces are constrained, and then those of the exact complex that is made of it. What a step has reached
// is not given up by the next; and as no step depends on the bound that is wanted, a higher one never leads to less.
class Sliver_stage_3
  : private Vertex_motion_3
{
public:
  // `bound` is the dihedral angle, in degrees, that cells should exceed, or 0 for as much as can be had. The mesh is
  // that of the complex, with positions that the complex need not have yet.
  Sliver_stage_3(Complex_updater_3& complex, Moving_triangulation_3& mesh, double bound, unsigned int seed,
                 std::size_t most_tries)
    : complex_(complex)
    , mesh_(mesh)
    , bound_(bound)
    , seed_(seed)
    , most_tries_(most_tries)
  {}

  // As far as there is time for, and `may_go_on()` permits; false if no valid complex can be made of the mesh.
  template <class Has_time, class May_go_on>
  bool run(const Has_time& has_time, const May_go_on& may_go_on)
  {
    // The repair of a rough surface would bring slivers back: in an image of separate balls, twice as many cells below 30 degrees
    // would be left.
    if(!is_rough())
      remove_from_mesh(first_step, has_time);
    if(complex_.snapshot().is_untouched_at(mesh_.sites) ? !complex_.make_regular() : !complex_.advance(mesh_, true))
      return false;
    complex_.load_into(mesh_);
    measure(first_step);
    const std::size_t slivers = reached_.below[first_step];
    bool goes_on = may_go_on() && climb_in_complex(first_step, 0, has_time);
    // A few cells that nothing helps may have taken all tries. Then the next step would do nothing: in four meshes of a cow, 1307
    // cells instead of 932 would be left below 30 degrees.
    most_tries_ = (std::max)(most_tries_, number_of_tries_ + tries_for_a_removed_cell * number_removed(first_step, slivers));
    int repetitions = most_repetitions;
    for(int step = first_step + 1; step <= Sliver_steps::last(bound_) && goes_on; ++step)
    {
      if(step > reached_.last_step)
        measure(step);
      if(!may_go_on() || !is_worthwhile(step, reached_))
        return true;
      const std::size_t before = reached_.below[step];
      const std::optional<int> climbed = climb(step, has_time);
      goes_on = climbed.has_value();
      const std::size_t removed = number_removed(step, before);
      most_tries_ += tries_for_a_removed_cell * removed;
      step = climbed.value_or(step);
      // Other random numbers remove cells that the first ones have not; so they are tried as long as that pays, and where
      // cells are left far below, since another step would do less for these.
      const bool pays = Sliver_steps::angles[step] <= always_wanted && removed > 0
                        && double(removed) >= least_share_removed * double(before);
      if(goes_on && (pays || (reached_.below[first_step] > 0 && repetitions-- > 0)))
      {
        failures_.clear();
        --step;
      }
    }
    return true;
  }

private:
  // What a step has led to in the mesh.
  struct Removal
  {
    int step;
    double smallest_angle;                      // before it, or 0 for the first step
    std::vector<Site> sites;
    unsigned int seed;                          // of what follows
    std::size_t number_of_tries;
  };

  static constexpr int first_step = 1, most_repetitions = 2;
  static constexpr std::size_t tries_for_an_exact_one = 3;
  // What pays, so that all tries are in proportion to the cells that there are to remove.
  static constexpr std::size_t tries_for_a_removed_cell = 100;
  static constexpr double least_share_removed = 0.2;
  static constexpr double share_of_climb = 0.8;         // of the exact ones; the others are for the worst cells
  // Above the angle, no step is taken if no bound is given, and cells are left below the one before or more of them
  // below this.
  static constexpr double always_wanted = 30, most_slivers = 1 / 25.;

  // Of so many cells below the step.
  std::size_t number_removed(int step, std::size_t before) const { return before - (std::min)(before, reached_.below[step]); }

  void measure(int last_step) { reached_ = Cell_angles(mesh_, last_step, mesh_.threads()); }

  // Of a mesh with these angles.
  bool is_worthwhile(int step, const Cell_angles& angles) const
  {
    return bound_ > 0 || Sliver_steps::angles[step] <= always_wanted
           || (angles.below[step - 1] == 0
               && double(angles.below[step]) < most_slivers * mesh_.topology.number_of_cells());
  }

  // Goes through a step and, while that leaves no cells in the mesh, through the next ones there before a complex is made of it.
  // Gives the last step that is transferred: one fewer where the smallest angle of the complex is less than that of the mesh was
  // before the last, so that a higher bound does not lead to less. None if nothing is reached.
  template <class Has_time>
  std::optional<int> climb(int step, const Has_time& has_time)
  {
    if(reached_.below[step] == 0)
      return step;
    const Angle_check_3 angles(mesh_, Sliver_steps::angles[step - 1], mesh_.threads());
    const Exact_sliver_removal_3::Failures failures = failures_;
    std::vector<Removal> removals = remove_in_steps_from_mesh(step, has_time);
    for(bool is_in_mesh = true; !removals.empty(); is_in_mesh = false, removals.pop_back())
    {
      const Removal& removal = removals.back();
      seed_ = removal.seed;
      number_of_tries_ = removal.number_of_tries;
      failures_ = failures;
      std::optional<Complex_snapshot_3> replaced
        = is_in_mesh ? complex_.advance(mesh_, angles) : complex_.advance(removal.sites, angles);
      if(climb_in_complex(removal.step, removal.smallest_angle, has_time))
        return removal.step;
      if(replaced)
        complex_.return_to(std::move(*replaced));
    }
    return climb_in_complex(step, 0, has_time) ? std::make_optional(step) : std::nullopt;
  }

  // Whether more is reached than before, or the smallest angle if one is given.
  template <class Has_time>
  bool climb_in_complex(int step, double smallest_angle, const Has_time& has_time)
  {
    remove_from_complex(step, has_time);
    complex_.load_into(mesh_);
    const Cell_angles now(mesh_, (std::min)(step + 1, Sliver_steps::number - 1), mesh_.threads());
    const bool is_better = smallest_angle > 0 ? now.smallest >= smallest_angle : now.is_better_than(reached_, step);
    if(is_better)
      reached_ = now;
    return is_better || (!(smallest_angle > 0) && reached_.below[step] == 0);
  }

  // On rough surfaces, vertices move even where the facets around them bend sharply.
  bool is_rough() const { return complex_.motion() == Boundary_motion::BY_DOMAIN; }

  // The first step may take them all. If half of them are kept for 30 degrees, an image of thin layers has 134 cells below 20
  // degrees instead of 60, and a CAD part with half as many below 30 takes half as long again.
  std::size_t tries_left() const { return most_tries_ - (std::min)(number_of_tries_, most_tries_); }

  // From a step on, until one leaves cells or the next is not worthwhile. Nothing if no vertex has moved.
  template <class Has_time>
  std::vector<Removal> remove_in_steps_from_mesh(int first, const Has_time& has_time)
  {
    std::vector<Removal> removals;
    bool have_moved = false;
    double smallest_angle = 0;
    for(int step = first; step <= Sliver_steps::last(bound_); ++step)
    {
      have_moved = remove_from_mesh(step, has_time) || have_moved;
      removals.push_back({ step, smallest_angle, mesh_.sites, seed_, number_of_tries_ });
      const Cell_angles now(mesh_, (std::min)(step + 1, Sliver_steps::number - 1), mesh_.threads());
      if(now.below[step] > 0 || !is_worthwhile(now.last_step, now))
        break;
      smallest_angle = (std::min)(now.smallest, Sliver_steps::angles[now.last_step]);
    }
    return have_moved ? removals : std::vector<Removal>();
  }

  // Whether vertices have moved.
  template <class Has_time>
  bool remove_from_mesh(int step, const Has_time& has_time)
  {
    Sliver_removal_parameters parameters;
    parameters.most_tries = tries_left() / 2;     // the rest is for what can be removed in the complex only
    Sliver_removal_3 removal(mesh_, Sliver_steps::angles[step], seed_++, this, parameters, mesh_.threads(),
                             complex_.domain().threads());
    removal.run(has_time);
    number_of_tries_ += removal.number_of_tries();
    return removal.number_of_moves() > 0;
  }

  template <class Has_time>
  void remove_from_complex(int step, const Has_time& has_time)
  {
    Exact_relocation_3 trial = complex_.make_trial(mesh_.size_bound);
    Exact_sliver_removal_3 removal(trial, failures_, seed_++);
    const std::size_t most_tries = tries_left() / tries_for_an_exact_one;
    removal.climb(step, std::size_t(share_of_climb * double(most_tries)), has_time);
    const std::size_t left = most_tries - (std::min)(removal.number_of_tries(), most_tries);
    removal.raise_smallest_angle(step, Sliver_steps::angles[step], left, has_time);
    number_of_tries_ += tries_for_an_exact_one * removal.number_of_tries();
    complex_.adopt(trial);
  }

  // Displacements on a surface are tangential.
  bool approach(int v, Site& s) override
  {
    if(v < mesh_.number_of_interior_vertices)
      return true;
    const Umbrella_shape& shape = complex_.snapshot().boundary.shape(v, 0);
    if(!shape.is_smooth && !is_rough())
      return false;
    const Site from = mesh_.sites[v];
    const double height = shape.normal.dot(position(s) - position(from));
    s = site_at(position(s) - height * shape.normal, s.weight);
    // On a rough surface, the tangential plane says little of where that will be; and where the surface
    // cannot be found everywhere, vertices are better left alone, unless bad cells remain.
    if(!is_rough() || complex_.put_on_surface(v, s))
      return true;
    s = from;
    return false;
  }

  bool settle(int v, Site& s) override
  {
    if(!is_rough() && !complex_.put_on_surface(v, s))
      return false;
    if(keeps_facets_close(v, s))
      complex_.keep_on_surface(v, s);
    else
      s = mesh_.sites[v];
    return true;
  }

  // Or else the vertex would be sent back.
  bool keeps_facets_close(int v, const Site& s)
  {
    const Moving_triangulation_3& mesh = mesh_;
    std::vector<Half_facet> star;
    mesh.topology.star(v, star);
    for(Half_facet slot : star)
      for(int i : facet_indices(slot.index()))
      {
        const Half_facet facet = slot.in_cell(i), across = mesh.topology.neighbor(facet);
        if(!across.is_side())
          continue;
        // A constrained facet with cells on both sides is looked at from the first.
        const Half_facet first = mesh.topology.constrained_half_facet(across.constrained_facet(), 0);
        if(!first.is_none() && first != facet)
          continue;
        Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
        for(int w : mesh.topology.facet(facet))
          centroid += position(w == v ? s : mesh.sites[w]) / 3;
        if(!complex_.is_close_to_surface(centroid))
          return false;
      }
    return true;
  }

  Complex_updater_3& complex_;
  Moving_triangulation_3& mesh_;
  double bound_;
  unsigned int seed_;
  std::size_t most_tries_, number_of_tries_ = 0;
  Cell_angles reached_;
  Exact_sliver_removal_3::Failures failures_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_STAGE_3_H
