// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_STAGE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_STAGE_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Exact_sliver_removal_3.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Sliver_removal_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Slot.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Removal of slivers from a complex. The facets on surfaces follow the vertices only when the
// complex is made anew, which may bring other slivers, so that several rounds are needed.
template <class Complex>
class Sliver_stage_3
  : private Vertex_motion_3
{
public:
  // `bound` is the dihedral angle, in degrees, that cells should exceed. The mesh is that of the complex, with
  // positions that the complex need not have yet.
  Sliver_stage_3(Complex& complex, Moving_triangulation_3& mesh, double bound, unsigned int seed)
    : complex_(complex)
    , mesh_(mesh)
    , bound_(bound)
    , seed_(seed)
  {}

  // Takes the complex through as many rounds as improve it, as there is time for and as `may_go_on()` permits; false
  // if no valid complex can be made of the mesh. Where the bound is beyond reach, lower ones follow: striving for a
  // high bound may leave cells that are worse than need be. (To return to the high one brings them back.)
  template <class Has_time, class May_go_on>
  bool run(const Has_time& has_time, const May_go_on& may_go_on)
  {
    remove_from_mesh(bound_, seed_, has_time, false);
    const bool is_stored = complex_.state().has_positions(mesh_.sites);
    if(!is_stored || !complex_.state().is_input())
    {
      if(!complex_.advance(mesh_.sites, true))
        return false;
      complex_.flatten(mesh_);
    }
    mesh_.shortest_edges(shortest_edge_);
    for(double bound = bound_; bound > lowest_bound && make_rounds(bound, has_time, may_go_on); bound *= next_bound) {}
    remove_exactly(has_time);
    return true;
  }

  // The number of cells with an angle below the bound.
  std::size_t number_of_slivers() const
  {
    std::size_t n = 0;
    for_each_deficit(bound_, [&n](int, double d) { n += d > 0; });
    return n;
  }

private:
  static constexpr int most_rounds = 12, most_rounds_in_vain = 3;
  static constexpr int rounds_of_rest = 2;
  static constexpr double same_place = 1e-3;    // over an edge
  static constexpr double clear_gain = 0.7;     // the factor on the deficit
  static constexpr double lowest_bound = 10, next_bound = 0.75;
  static constexpr std::size_t exact_tries = 4000, exact_tries_per_cell = 1;

  // On rough surfaces, vertices move even where the facets around them bend sharply, but several at
  // once only as a last resort.
  bool is_rough() const { return complex_.is_surface_rough(); }

  // Whether cells below the bound that moving a vertex may improve are left, and may be improved yet.
  template <class Has_time, class May_go_on>
  bool make_rounds(double bound, const Has_time& has_time, const May_go_on& may_go_on)
  {
    barred_.assign(mesh_.number_of_movable_vertices, 0);
    is_patient_ = bound < bound_;
    Deficit best = deficit(bound);
    std::vector<Site> best_sites = mesh_.sites;
    bool is_best = true, goes_on = true;
    int in_vain = 0;
    for(int round = 0; round < most_rounds && in_vain < most_rounds_in_vain && best.improvable > 0; ++round)
    {
      goes_on = may_go_on();
      if(!goes_on)
        break;
      if(!remove_from_mesh(bound, seed_++, has_time, !is_rough() || is_patient_))
        break;
      const bool is_stored = store();
      const Deficit reached = deficit(bound);
      is_best = reached.all < best.all;
      in_vain = is_stored && reached.improvable < clear_gain * best.improvable ? 0 : in_vain + 1;
      if(is_best)
      {
        best = reached;
        best_sites = mesh_.sites;
      }
    }
    if(!is_best)
    {
      complex_.advance(best_sites, true);
      complex_.flatten(mesh_);
    }
    return best.improvable > 0 && goes_on;
  }

  // Of all cells, and of those that moving a vertex may improve.
  struct Deficit
  {
    double all = 0, improvable = 0;
  };

  Deficit deficit(double bound) const
  {
    Deficit sum;
    for_each_deficit(bound, [&](int c, double d)
    {
      const int* const v = mesh_.topology.vertices(c);
      sum.all += d;
      if(d > 0 && *std::min_element(v, v + 4) < mesh_.number_of_movable_vertices)
        sum.improvable += d;
    });
    return sum;
  }

  // Whether vertices have moved.
  template <class Predicate>
  bool remove_from_mesh(double bound, unsigned int seed, const Predicate& has_time, bool moves_jointly)
  {
    Sliver_removal_parameters parameters;
    if(!moves_jointly)
      parameters.most_joint_tries = 0;
    Sliver_removal_3 removal(mesh_, bound, seed, this, parameters);
    removal.run(has_time);
    return removal.number_of_moves() > 0;
  }

  template <class F>
  void for_each_deficit(double bound, const F& f) const
  {
    const Angle_deficit_3 angle_deficit(bound);
    for(int c = 0; c < mesh_.topology.number_of_cell_slots(); ++c)
      f(c, mesh_.deficit(c, angle_deficit));
  }

  // Of what is left, what the exact complex, where facets on surfaces follow the vertices, makes it possible to remove.
  template <class Has_time>
  void remove_exactly(const Has_time& has_time)
  {
    if(number_of_slivers() == 0)
      return;
    typename Complex::Trial trial = complex_.make_trial(bound_);
    Exact_sliver_removal_3<typename Complex::Trial> removal(trial, bound_, seed_++);
    removal.run(exact_tries + exact_tries_per_cell * static_cast<std::size_t>(mesh_.topology.number_of_cells()), has_time);
    if(removal.number_of_moves() > 0 && complex_.adopt(trial))
      complex_.flatten(mesh_);
  }

  // The complex, and then the mesh, follow the vertices as far as possible.
  bool store()
  {
    const std::vector<Site> target = mesh_.sites;
    const bool is_stored = complex_.advance(target, true);
    complex_.flatten(mesh_);
    bar_returned(target);
    return is_stored;
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
    return is_patient_;
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
  bool is_patient_ = false;               // with a bound below the one wanted
  std::vector<int> barred_;               // for so many rounds
  std::vector<double> shortest_edge_;
  std::vector<Slot> star_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_STAGE_3_H
