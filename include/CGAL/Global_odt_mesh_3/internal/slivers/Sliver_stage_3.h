// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_STAGE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_STAGE_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Cell_angles.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Given_up_cells.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Sliver_removal_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Slot.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// What the removal of slivers may cost: tries of single vertices, and checks of the complex.
struct Sliver_budget
{
  std::size_t tries, checks;
};

// Removal of slivers from a complex, by bounds that rise step by step. The facets on surfaces follow the vertices
// only when the complex is made anew, which may bring other slivers, so that a step takes several rounds. What
// a step reaches, no later one gives up; and as a step does not depend on the bound that is wanted, a higher one
// never leads to less.
template <class Complex>
class Sliver_stage_3
  : private Vertex_motion_3
{
public:
  // `bound` is the dihedral angle, in degrees, that cells should exceed: the first step that is not below it is the
  // last; 0 stands for as much as can be had. The mesh is that of the complex, with positions that the complex need
  // not have yet.
  Sliver_stage_3(Complex& complex, Moving_triangulation_3& mesh, double bound, unsigned int seed,
                 const Sliver_budget& budget)
    : complex_(complex)
    , mesh_(mesh)
    , bound_(bound)
    , seed_(seed)
    , budget_(budget)
    , checks_before_(complex.number_of_checks())
  {}

  // Takes the complex through as many steps and rounds as improve it, as there is time for and as `may_go_on()`
  // permits; false if no valid complex can be made of the mesh.
  template <class Has_time, class May_go_on>
  bool run(const Has_time& has_time, const May_go_on& may_go_on)
  {
    remove_from_mesh(Cell_angles::steps[0], has_time, false);
    const bool is_stored = complex_.state().has_positions(mesh_.sites);
    if(!is_stored || !complex_.state().is_input())
    {
      if(!complex_.advance(mesh_.sites, true))
        return false;
      complex_.flatten(mesh_);
    }
    mesh_.shortest_edges(shortest_edge_);
    reached_ = Cell_angles(mesh_);
    for(int step = 0; step <= last_step() && is_worthwhile(step) && climb(step, has_time, may_go_on); ++step) {}
    return true;
  }

  // The number of cells with an angle below the bound.
  std::size_t number_of_slivers() const
  {
    std::size_t n = 0;
    const Angle_deficit_3 angle_deficit(bound_);
    for(int c = 0; c < mesh_.topology.number_of_cell_slots(); ++c)
      n += mesh_.deficit(c, angle_deficit) > 0;
    return n;
  }

private:
  typedef typename Complex::State State;

  static constexpr int most_rounds = 8, most_rounds_in_vain = 3;
  static constexpr int rounds_of_rest = 2;
  static constexpr double same_place = 1e-3;    // over an edge
  static constexpr double clear_gain = 0.7;     // the factor on the deficit
  // Above the angle, no step is taken if no bound is given and more of the cells lie below it.
  static constexpr double always_wanted = 30, most_slivers = 1 / 30.;

  int last_step() const
  {
    int last = 0;
    while(last + 1 < Cell_angles::number_of_steps && (bound_ == 0 || Cell_angles::steps[last] < bound_))
      ++last;
    return last;
  }

  bool is_worthwhile(int step) const
  {
    return bound_ > 0 || Cell_angles::steps[step] <= always_wanted
           || double(reached_.below[step]) < most_slivers * mesh_.topology.number_of_cells();
  }

  // On rough surfaces, vertices move even where the facets around them bend sharply, but several at
  // once only as a last resort.
  bool is_rough() const { return complex_.is_surface_rough(); }

  bool has_budget() const
  {
    return number_of_tries_ < budget_.tries && complex_.number_of_checks() - checks_before_ < budget_.checks;
  }

  // Rounds until no cell is below the step, or nothing is gained any more. Whether the next step may be taken.
  template <class Has_time, class May_go_on>
  bool climb(int step, const Has_time& has_time, const May_go_on& may_go_on)
  {
    if(reached_.below[step] == 0)
      return true;
    barred_.assign(mesh_.number_of_movable_vertices, 0);
    smallest_angles_ = smallest_angles_at_vertices(mesh_);
    std::optional<State> best;          // unless the complex is in it
    bool is_better = false;
    double deficit = reached_.deficit[step];
    for(int round = 0, in_vain = 0; round < most_rounds && in_vain < most_rounds_in_vain && reached_.below[step] > 0; ++round)
    {
      if(!has_budget() || !may_go_on() || !remove_from_mesh(Cell_angles::steps[step], has_time, !is_rough() || round > 0))
        break;
      std::optional<State> replaced = store(step);
      const Cell_angles now(mesh_);
      in_vain = now.deficit[step] < clear_gain * deficit ? 0 : in_vain + 1;
      deficit = now.deficit[step];
      if(now.is_better_than(reached_, step))
      {
        reached_ = now;
        smallest_angles_ = smallest_angles_at_vertices(mesh_);
        best.reset();
        is_better = true;
      }
      else if(replaced && !best)
        best = std::move(replaced);
    }
    if(best)
    {
      complex_.return_to(std::move(*best));
      complex_.flatten(mesh_);
    }
    return is_better;
  }

  // Whether vertices have moved.
  template <class Predicate>
  bool remove_from_mesh(double bound, const Predicate& has_time, bool moves_jointly)
  {
    Sliver_removal_parameters parameters;
    if(!moves_jointly)
      parameters.most_joint_tries = 0;
    parameters.most_tries = budget_.tries - (std::min)(number_of_tries_, budget_.tries);
    Sliver_removal_3 removal(mesh_, given_up_, bound, seed_++, this, parameters);
    removal.run(has_time);
    number_of_tries_ += removal.number_of_tries();
    return removal.number_of_moves() > 0;
  }

  // The complex, and then the mesh, follow the vertices as far as possible. Gives the state that is
  // replaced. Below the step before, no cell gets worse.
  std::optional<State> store(int step)
  {
    const Least_angles least_angles = { Cell_angles::steps[(std::max)(0, step - 1)] * (step > 0 ? 1 : 0.5), smallest_angles_ };
    const std::vector<Site> target = mesh_.sites;
    std::optional<State> replaced = complex_.advance(target, true, &least_angles);
    complex_.flatten(mesh_);
    bar_returned(target);
    return replaced;
  }

  // Where a vertex was sent back, others have to move for a while.
  void bar_returned(const std::vector<Site>& target)
  {
    for(int v = 0; v < mesh_.number_of_movable_vertices; ++v)
    {
      const double tolerance = same_place * shortest_edge_[v];
      if(mesh_.squared_distance(target[v], mesh_.sites[v]) > tolerance * tolerance)
        barred_[v] = rounds_of_rest;
      else if(barred_[v] > 0)
        --barred_[v];
    }
  }

  // Displacements on a surface are tangential.
  bool approach(int v, Site& s) override
  {
    if(!barred_.empty() && barred_[v] > 0)
      return false;
    if(v < mesh_.number_of_interior_vertices)
      return true;
    const Umbrella_shape& shape = complex_.state().boundary.shape(v, 0);
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
    if(!keeps_facets_close(v, s))
      s = mesh_.sites[v];
    return true;
  }

  // Or else the vertex would be sent back.
  bool keeps_facets_close(int v, const Site& s)
  {
    const Moving_triangulation_3& mesh = mesh_;
    mesh.topology.star(v, star_);
    for(Slot slot : star_)
      for(int i : facet_indices(slot.index()))
      {
        const Slot facet = slot.in_cell(i), across = mesh.topology.neighbor(facet);
        if(!across.is_side())
          continue;
        // A constrained facet with cells on both sides is looked at from the first.
        const Slot first = mesh.topology.constrained_slot(across.constrained_facet(), 0);
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

  Complex& complex_;
  Moving_triangulation_3& mesh_;
  double bound_;
  unsigned int seed_;
  Sliver_budget budget_;
  std::size_t checks_before_, number_of_tries_ = 0;
  Cell_angles reached_;
  Given_up_cells given_up_;
  std::vector<int> barred_;               // for so many rounds
  std::vector<double> shortest_edge_, smallest_angles_;
  std::vector<Slot> star_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_STAGE_3_H
