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

// Removal of slivers from a complex: those of the flat mesh first, where a try takes microseconds but facets on
// surfaces are constrained, and then, step by step, those of the exact complex that is made of it.
template <class Complex>
class Sliver_stage_3
  : private Vertex_motion_3
{
public:
  // `bound` is the dihedral angle, in degrees, that cells should exceed, or 0 for as much as can be had. The mesh is
  // that of the complex, with positions that the complex need not have yet.
  Sliver_stage_3(Complex& complex, Moving_triangulation_3& mesh, double bound, unsigned int seed, std::size_t most_tries)
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
    remove_from_mesh(has_time);
    const bool is_stored = complex_.state().has_positions(mesh_.sites);
    if((!is_stored || !complex_.state().is_input()) && !complex_.advance(mesh_.sites, true))
      return false;
    if(may_go_on())
      remove_from_complex(has_time);
    complex_.flatten(mesh_);
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
  static constexpr double bound_of_mesh = 20;   // degrees

  // On rough surfaces, vertices move even where the facets around them bend sharply.
  bool is_rough() const { return complex_.is_surface_rough(); }

  template <class Has_time>
  void remove_from_mesh(const Has_time& has_time)
  {
    Sliver_removal_parameters parameters;
    parameters.most_joint_tries = 0;
    parameters.most_tries = most_tries_;
    Sliver_removal_3(mesh_, bound_of_mesh, seed_, this, parameters).run(has_time);
  }

  template <class Has_time>
  void remove_from_complex(const Has_time& has_time)
  {
    typename Complex::Trial trial = complex_.make_trial();
    Exact_sliver_removal_3<typename Complex::Trial> removal(trial, bound_, seed_ + 1);
    removal.run(most_tries_, has_time);
    if(removal.number_of_moves() > 0)
      complex_.adopt(trial);
  }

  // Displacements on a surface are tangential.
  bool approach(int v, Site& s) override
  {
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
  std::size_t most_tries_;
  std::vector<Slot> star_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_STAGE_3_H
