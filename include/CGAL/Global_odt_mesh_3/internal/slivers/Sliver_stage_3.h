// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_STAGE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_STAGE_3_H

#include <CGAL/Global_odt_mesh_3/internal/Odt_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Sliver_removal_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flat_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Removal of slivers from a complex. The facets on surfaces follow the vertices only when the
// complex is made anew, which may bring other slivers, so that several rounds are needed.
template <class Bridge>
class Sliver_stage_3
  : private Vertex_motion_3
{
public:
  // On rough surfaces, vertices move even where the facets around them bend sharply, but several at
  // once only as a last resort.
  Sliver_stage_3(Bridge& bridge, const Odt_parameters& parameters, bool is_rough)
    : bridge_(bridge)
    , bound_(parameters.sliver_bound)
    , seed_(parameters.random_seed)
    , is_rough_(is_rough)
  {}

  // Before the complex is made anew, as long as there is time.
  template <class Predicate>
  void remove_from(Moving_triangulation_3& mesh, const Predicate& has_time)
  {
    run(mesh, bound_, has_time, false);
  }

  // Takes the complex, from which the mesh has been loaded, through as many rounds as improve it and
  // as `may_go_on()` permits. Where the bound is beyond reach, lower ones follow: striving for a high
  // bound may leave cells that are worse than need be. (To return to the high one brings them back.)
  template <class Has_time, class May_go_on>
  void remove_from_complex(Moving_triangulation_3& mesh, const Has_time& has_time, const May_go_on& may_go_on)
  {
    mesh.shortest_edges(shortest_edge_);
    for(double bound = bound_; bound > lowest_bound && make_rounds(mesh, bound, has_time, may_go_on); bound *= next_bound) {}
  }

  // The number of cells with an angle below the bound.
  std::size_t number_of_slivers(const Moving_triangulation_3& mesh) const
  {
    std::size_t n = 0;
    for_each_deficit(mesh, bound_, [&n](int, double d) { n += d > 0; });
    return n;
  }

private:
  typedef typename Bridge::Update Update;

  static constexpr int most_rounds = 12, most_rounds_in_vain = 3;
  static constexpr int rounds_of_rest = 2;
  static constexpr double same_place = 1e-3;    // over an edge
  static constexpr double clear_gain = 0.7;     // the factor on the deficit
  static constexpr double lowest_bound = 10, next_bound = 0.75;

  // Whether cells below the bound that moving a vertex may improve are left, and may be improved yet.
  template <class Has_time, class May_go_on>
  bool make_rounds(Moving_triangulation_3& mesh, double bound, const Has_time& has_time, const May_go_on& may_go_on)
  {
    barred_.assign(mesh.number_of_movable_vertices, 0);
    is_patient_ = bound < bound_;
    Deficit best = deficit(mesh, bound);
    std::vector<Site> best_sites = mesh.sites;
    bool is_best = true, goes_on = true;
    int in_vain = 0;
    for(int round = 0; round < most_rounds && in_vain < most_rounds_in_vain && best.improvable > 0; ++round)
    {
      goes_on = may_go_on();
      if(!goes_on)
        break;
      if(!run(mesh, bound, has_time, !is_rough_ || is_patient_))
        break;
      const std::vector<Site> target = mesh.sites;
      const bool is_stored = store(mesh);
      bridge_.reload(mesh);
      bar_returned(target, mesh);
      const Deficit reached = deficit(mesh, bound);
      is_best = reached.all < best.all;
      in_vain = is_stored && reached.improvable < clear_gain * best.improvable ? 0 : in_vain + 1;
      if(is_best)
      {
        best = reached;
        best_sites = mesh.sites;
      }
    }
    if(!is_best)
    {
      mesh.sites = best_sites;
      store(mesh);
      bridge_.reload(mesh);
    }
    return best.improvable > 0 && goes_on;
  }

  // Of all cells, and of those that moving a vertex may improve.
  struct Deficit
  {
    double all = 0, improvable = 0;
  };

  Deficit deficit(const Moving_triangulation_3& mesh, double bound) const
  {
    Deficit sum;
    for_each_deficit(mesh, bound, [&](int c, double d)
    {
      const int* const v = mesh.topology.cell_vertices() + 4 * c;
      sum.all += d;
      if(d > 0 && *std::min_element(v, v + 4) < mesh.number_of_movable_vertices)
        sum.improvable += d;
    });
    return sum;
  }

  // Whether vertices have moved.
  template <class Predicate>
  bool run(Moving_triangulation_3& mesh, double bound, const Predicate& has_time, bool joint_tries)
  {
    Sliver_removal_parameters parameters;
    if(!joint_tries)
      parameters.most_joint_tries = 0;
    mesh_ = &mesh;
    Sliver_removal_3 removal(mesh, bound, seed_++, this, parameters);
    removal.run(has_time);
    return removal.number_of_moves() > 0;
  }

  template <class F>
  void for_each_deficit(const Moving_triangulation_3& mesh, double bound, const F& f) const
  {
    const Angle_deficit_3 angle_deficit(bound);
    for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
      f(c, mesh.deficit(c, angle_deficit));
  }

  bool store(const Moving_triangulation_3& mesh)
  {
    const bool surface_moves = mesh.number_of_movable_vertices > mesh.number_of_interior_vertices;
    return bridge_.store(mesh, Update{ surface_moves, surface_moves,
                                       is_rough_ ? Update::ORACLE : Update::GOOD_EVIDENCE, true });
  }

  // Where a vertex was sent back, others have to move for a while.
  void bar_returned(const std::vector<Site>& target, const Moving_triangulation_3& mesh)
  {
    for(int v = 0; v < mesh.number_of_movable_vertices; ++v)
    {
      const double tolerance = same_place * shortest_edge_[v];
      if(mesh.squared_distance(target[v], mesh.sites[v]) > tolerance * tolerance)
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
    if(v < mesh_->number_of_interior_vertices)
      return true;
    const auto& umbrella = bridge_.complex().boundary.umbrella(v, 0);
    if(!umbrella.is_smooth && !is_rough_)
      return false;
    const Site from = mesh_->sites[v];
    const auto& n = umbrella.normal;
    const double h = n[0] * (s.x - from.x) + n[1] * (s.y - from.y) + n[2] * (s.z - from.z);
    s = { s.x - h * n[0], s.y - h * n[1], s.z - h * n[2], s.weight };
    // On a rough surface, the tangential plane says little of where that will be; and where the surface
    // cannot be found everywhere, vertices are better left alone, unless bad cells remain.
    if(!is_rough_ || bridge_.put_on_surface(v, s))
      return true;
    s = from;
    return is_patient_;
  }

  bool settle(int v, Site& s) override
  {
    if(!is_rough_ && !bridge_.put_on_surface(v, s))
      return false;
    if(!keeps_facets_close(v, s))
      s = mesh_->sites[v];
    return true;
  }

  // Or else the vertex would be sent back.
  bool keeps_facets_close(int v, const Site& s)
  {
    const Moving_triangulation_3& mesh = *mesh_;
    mesh.topology.star(v, star_);
    for(int slot : star_)
      for(int i : Flat_triangulation_3::facet_vertices(slot % 4))
      {
        const int facet = slot - slot % 4 + i, across = mesh.topology.neighbor(facet);
        if(!Flat_triangulation_3::is_constrained(across))
          continue;
        // A constrained facet with cells on both sides is looked at from the first.
        const int first = mesh.topology.constrained_slot(Flat_triangulation_3::constrained_facet(across), 0);
        if(first >= 0 && first != facet)
          continue;
        std::array<double, 3> centroid = {{ 0, 0, 0 }};
        for(int j : Flat_triangulation_3::facet_vertices(i))
        {
          const int w = mesh.topology.vertex(facet - i + j);
          const Site& t = w == v ? s : mesh.sites[w];
          centroid = {{ centroid[0] + t.x / 3, centroid[1] + t.y / 3, centroid[2] + t.z / 3 }};
        }
        if(!bridge_.is_close_to_surface(centroid))
          return false;
      }
    return true;
  }

  Bridge& bridge_;
  Moving_triangulation_3* mesh_ = nullptr;
  double bound_;
  unsigned int seed_;
  bool is_rough_;
  bool is_patient_ = false;               // with a bound below the one wanted
  std::vector<int> barred_;               // for so many rounds
  std::vector<double> shortest_edge_;
  std::vector<int> star_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_STAGE_3_H
