// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_VERTEX_TRIAL_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_VERTEX_TRIAL_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_step_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/For_each_in_chunks.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flips_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Lawson_flips_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Slot.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// What moving one vertex of a constrained regular triangulation does to the angles of the
// cells, after the flips that it entails; to be accepted or taken back. So may be all that
// has been accepted since a mark was set.
class Vertex_trial_3
{
public:
  // `bound`, in degrees, is what the dihedral angles should reach.
  Vertex_trial_3(Constrained_triangulation_3& mesh, double bound, const Thread_policy& threads = Thread_policy())
    : mesh_(mesh)
    , angle_deficit_(bound)
  {
    make_room();
    for_each_in_chunks(mesh.topology.number_of_cell_slots(), threads, [this](int c) { deficit_[c] = measure(c); });
  }

  // Zero for cells that are not alive.
  double deficit(int cell) const { return deficit_[cell]; }

  // The change of the sum of the deficits if the vertex goes to `s`, or infinity if it cannot
  // or if that would be more than `most`. The mesh stays as tried until accept() or reject().
  double move(int v, const Site& s, double most = (std::numeric_limits<double>::infinity)())
  {
    ++trial_;
    touched_.clear();
    vertex_ = v;
    from_ = mesh_.sites[v];
    before_ = after_ = 0;
    if(!has_mark_)
      mesh_.topology.begin_trial();
    begin_ = mesh_.topology.trial_length();
    mesh_.topology.star(v, star_);
    mesh_.sites[v] = s;
    irregular_.clear();
    for(Slot t : star_)
    {
      if(mesh_.is_inverted(t.cell()))
        return (std::numeric_limits<double>::infinity)();
      touch(t.cell());
      mesh_.push_facets(t.cell(), irregular_);
    }
    if(!Lawson_flips_3<Vertex_trial_3>(mesh_, *this, irregular_).make_regular())
      return (std::numeric_limits<double>::infinity)();
    for(int c : touched_)
      if(mesh_.topology.is_alive(c))
      {
        if(is_beyond_surface(c))
          return (std::numeric_limits<double>::infinity)();
        after_ += measure(c);
        if(after_ - before_ > most)
          return (std::numeric_limits<double>::infinity)();
      }
    return after_ - before_;
  }

  // Of the vertex, toward more for the angles around it, as far as `longest`.
  Eigen::Vector3d step_to_more(int v, double longest)
  {
    Angle_step_3 step(angle_deficit_);
    mesh_.topology.star(v, star_);
    for(Slot t : star_)
      if(deficit_[t.cell()] > 0)
        step.add(mesh_.cell_sites(t.cell()), t.index());
    return step.displacement(longest);
  }

  // The sum of the deficits of the cells that the trial has made.
  double deficit_after() const { return after_; }

  void accept()
  {
    if(has_mark_)
      sites_since_mark_.emplace_back(vertex_, from_);
    else
      mesh_.topology.end_trial();
    for(int c : touched_)
    {
      if(has_mark_)
        deficits_since_mark_.emplace_back(c, deficit_[c]);
      deficit_[c] = measure(c);
    }
  }

  void reject()
  {
    mesh_.topology.undo_trial(begin_);
    mesh_.sites[vertex_] = from_;
    if(!has_mark_)
      mesh_.topology.end_trial();
  }

  void set_mark()
  {
    CGAL_assertion(!has_mark_);
    has_mark_ = true;
    mesh_.topology.begin_trial();
  }

  // The cells that may have got other deficits since the mark, some more than once.
  std::vector<int> cells_since_mark() const
  {
    std::vector<int> cells;
    for(const auto& d : deficits_since_mark_)
      cells.push_back(d.first);
    return cells;
  }

  void accept_since_mark()
  {
    CGAL_assertion(has_mark_);
    mesh_.topology.end_trial();
    forget_mark();
  }

  void reject_since_mark()
  {
    CGAL_assertion(has_mark_);
    mesh_.topology.undo_trial();
    for(auto s = sites_since_mark_.rbegin(); s != sites_since_mark_.rend(); ++s)
      mesh_.sites[s->first] = s->second;
    for(auto d = deficits_since_mark_.rbegin(); d != deficits_since_mark_.rend(); ++d)
      deficit_[d->first] = d->second;
    CGAL_expensive_assertion(mesh_.topology.is_valid());
    accept_since_mark();
  }

private:
  friend class Lawson_flips_3<Vertex_trial_3>;

  std::array<int, 3> flip_2_3(Slot s)
  {
    touch(s.cell());
    touch(mesh_.topology.neighbor(s).cell());
    const std::array<int, 3> cells = internal::flip_2_3(mesh_.topology, s);
    make_room();
    for(int c : cells)
      touch(c);
    return cells;
  }

  std::array<int, 2> flip_3_2(const Edge_ring_3& ring)
  {
    for(Slot s : ring)
      touch(s.cell());
    return internal::flip_3_2(mesh_.topology, ring);
  }

  // Cells that were not there before have no deficit.
  void touch(int c)
  {
    if(trial_of_cell_[c] == trial_)
      return;
    trial_of_cell_[c] = trial_;
    touched_.push_back(c);
    before_ += deficit_[c];
  }

  void forget_mark()
  {
    has_mark_ = false;
    sites_since_mark_.clear();
    deficits_since_mark_.clear();
  }

  void make_room()
  {
    deficit_.resize(mesh_.topology.number_of_cell_slots(), 0);
    trial_of_cell_.resize(mesh_.topology.number_of_cell_slots(), 0);
  }

  double measure(int c) const { return mesh_.deficit(c, angle_deficit_); }

  // Whether a vertex of the interior has pushed the dual point of the cell through the surface.
  bool is_beyond_surface(int c) const
  {
    for(int i = 0; i < 4; ++i)
      if(mesh_.topology.vertices(c)[i] < mesh_.number_of_interior_vertices && mesh_.is_beyond_surface(Slot(c, i)))
        return true;
    return false;
  }

  Constrained_triangulation_3& mesh_;
  Angle_deficit_3 angle_deficit_;
  std::vector<double> deficit_;             // of each cell
  std::vector<std::size_t> trial_of_cell_;
  std::size_t trial_ = 0;
  int vertex_ = -1;
  Site from_;
  double before_ = 0, after_ = 0;
  std::vector<int> touched_;
  std::vector<Slot> star_, irregular_;
  Flat_triangulation_3::Trial_length begin_ = {};   // of the trial, in the history since the mark
  bool has_mark_ = false;
  std::vector<std::pair<int, Site> > sites_since_mark_;         // and where they were
  std::vector<std::pair<int, double> > deficits_since_mark_;    // and what they were
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_VERTEX_TRIAL_3_H
