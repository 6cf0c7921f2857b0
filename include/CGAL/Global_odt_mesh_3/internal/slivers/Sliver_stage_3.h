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

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_updater_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Editable_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Sliver_steps.h>
#include <CGAL/Global_odt_mesh_3/internal/sizing/Largest_cells_3.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Sliver_removal_3.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Removal of slivers from a complex, step by step. What a step has reached is not given up by the next; and as no step depends
// on the bound that is wanted, a higher one never leads to less.
class Sliver_stage_3
{
public:
  // `bound` is the dihedral angle, in degrees, that cells should exceed, or 0 for as much as can be had. The complex is regular.
  Sliver_stage_3(Complex_updater_3& complex, const Circumradius_bound_3& size_bound, double bound, unsigned int seed)
    : complex_(complex)
    , size_bound_(size_bound)
    , bound_(bound)
    , seed_(seed)
  {}

  // As far as there is time for, and `may_go_on()` permits.
  template <class Has_time, class May_go_on>
  void run(const Has_time& has_time, const May_go_on& may_go_on)
  {
    bool goes_on = true;
    for(int step = first_step; goes_on && step <= Sliver_steps::last(bound_) && may_go_on(); ++step)
      goes_on = climb(step, has_time);
  }

private:
  static constexpr int first_step = 1;
  // All tries are in proportion to the cells, and to those that there are to remove in the first step.
  static constexpr std::size_t fewest_tries = 10000, tries_for_two_cells = 5, tries_for_a_sliver = 80;
  static constexpr std::size_t tries_for_a_removed_cell = 100;      // what pays
  static constexpr double share_of_climb = 0.8;         // of the tries; the others are for the worst cells
  // Above the angle, no step is taken if no bound is given, and cells are left below the one before or more of them
  // below this.
  static constexpr double always_wanted = 30, most_slivers = 1 / 25.;

  // Of a step with so many slivers.
  bool is_worthwhile(int step, std::size_t slivers, const Editable_complex_3& complex) const
  {
    return bound_ > 0 || Sliver_steps::angles[step] <= always_wanted
           || (double(slivers) < most_slivers * double(complex.working.cells().size())
               && complex.slivers(Sliver_steps::angles[step - 1]).empty());
  }

  // Whether another step may reach more.
  template <class Has_time>
  bool climb(int step, const Has_time& has_time)
  {
    Editable_complex_3 complex = complex_.edit();
    complex.size_bound = size_bound_;
    Sliver_removal_3 removal(complex, step, seed_++);
    const std::size_t before = removal.number_of_slivers();
    if(!is_worthwhile(step, before, complex))
      return false;
    if(step == first_step)
      most_tries_ = fewest_tries + tries_for_two_cells * complex.working.cells().size() / 2 + tries_for_a_sliver * before;
    const std::size_t left = most_tries_ - (std::min)(number_of_tries_, most_tries_);
    removal.climb(std::size_t(share_of_climb * double(left)), has_time);
    removal.raise_smallest_angle(left - (std::min)(removal.number_of_tries(), left), has_time);
    number_of_tries_ += removal.number_of_tries();
    const std::size_t after = removal.number_of_slivers();
    if(!complex_.adopt(complex))
      return false;
    // A few cells that nothing helps may have taken all tries. Then the next step would do nothing: in four meshes of a cow, 1307
    // cells instead of 932 would be left below 30 degrees.
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

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_STAGE_3_H
