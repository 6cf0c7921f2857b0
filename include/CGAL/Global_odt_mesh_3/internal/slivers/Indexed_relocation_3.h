// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_INDEXED_RELOCATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_INDEXED_RELOCATION_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/blocks/Mesh_partition_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flips_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Half_facet.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// What moving one vertex of a constrained regular triangulation does to the angles of the
// cells, after the flips that it entails; to be accepted or taken back. So may be all that
// has been accepted since a mark was set.
//
// Threads may try vertices in several parts of the mesh at the same time.
class Indexed_relocation_3
{
public:
  // `bound`, in degrees, is what the dihedral angles should reach.
  Indexed_relocation_3(Constrained_triangulation_3& mesh, double bound, const Thread_policy& threads = Thread_policy())
    : mesh_(mesh)
    , topology_(mesh.topology)
    , angle_deficit_(bound)
    , cells_(std::make_shared<Cells>())
  {
    make_room();
    for_each_in_chunks(topology_.number_of_cell_slots(), threads, [this](int c) { cells_->deficit[c] = measure(c); });
  }

  // In one of the parts that the topology of the whole has been split into.
  Indexed_relocation_3(Indexed_relocation_3& whole, Indexed_triangulation_3& topology, const Mesh_parts_3& parts, int part, bool surfaces_move)
    : mesh_(whole.mesh_)
    , topology_(topology)
    , angle_deficit_(whole.angle_deficit_)
    , parts_(&parts)
    , part_(part)
    , surfaces_move_(surfaces_move)
    , cells_(whole.cells_)
    , trial_(whole.trial_)
  {}

  Indexed_relocation_3(const Indexed_relocation_3&) = delete;
  Indexed_relocation_3& operator=(const Indexed_relocation_3&) = delete;

  // Lengthens the arrays of cells to the number of cell slots.
  void make_room()
  {
    cells_->deficit.resize(topology_.number_of_cell_slots(), 0);
    cells_->trial.resize(topology_.number_of_cell_slots(), 0);
  }

  // Takes over what a part has tried.
  void join(const Indexed_relocation_3& part) { trial_ = (std::max)(trial_, part.trial_); }

  // Zero for cells that are not alive.
  double deficit(int cell) const { return cells_->deficit[cell]; }

  // In a part, whether all cells of the vertex are in it, and those on its surface move if it has one.
  bool may_move(int v)
  {
    if(parts_ == nullptr)
      return true;
    topology_.star(v, star_);
    return permits((surfaces_move_ || v < mesh_.number_of_interior_vertices)
                   && std::all_of(star_.begin(), star_.end(), [this](Half_facet t) { return is_in_part(t.cell()); }));
  }

  // How often a vertex or a flip has been refused because of the part.
  std::size_t number_of_refusals() const { return number_of_refusals_; }

  // The cells that the last trial has touched, alive or not.
  const std::vector<int>& touched_cells() const { return touched_; }

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
      topology_.begin_trial();
    begin_ = topology_.trial_length();
    topology_.star(v, star_);
    mesh_.sites[v] = s;
    irregular_.clear();
    for(Half_facet t : star_)
    {
      if(mesh_.is_inverted(t.cell()))
        return (std::numeric_limits<double>::infinity)();
      touch(t.cell());
      mesh_.push_facets(t.cell(), irregular_);
    }
    if(!Lawson_flips_3<Indexed_relocation_3>(mesh_, *this, irregular_).make_regular())
      return (std::numeric_limits<double>::infinity)();
    for(int c : touched_)
      if(topology_.is_alive(c))
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
    topology_.star(v, star_);
    for(Half_facet t : star_)
      if(deficit(t.cell()) > 0)
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
      topology_.end_trial();
    for(int c : touched_)
    {
      if(has_mark_)
        deficits_since_mark_.emplace_back(c, deficit(c));
      cells_->deficit[c] = measure(c);
    }
  }

  void reject()
  {
    topology_.undo_trial(begin_);
    mesh_.sites[vertex_] = from_;
    if(!has_mark_)
      topology_.end_trial();
  }

  void set_mark()
  {
    CGAL_assertion(!has_mark_);
    has_mark_ = true;
    topology_.begin_trial();
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
    topology_.end_trial();
    forget_mark();
  }

  void reject_since_mark()
  {
    CGAL_assertion(has_mark_);
    topology_.undo_trial();
    for(auto s = sites_since_mark_.rbegin(); s != sites_since_mark_.rend(); ++s)
      mesh_.sites[s->first] = s->second;
    for(auto d = deficits_since_mark_.rbegin(); d != deficits_since_mark_.rend(); ++d)
      cells_->deficit[d->first] = d->second;
    CGAL_expensive_assertion(topology_.is_valid());
    accept_since_mark();
  }

private:
  friend class Lawson_flips_3<Indexed_relocation_3>;

  struct Cells
  {
    std::vector<double> deficit;
    std::vector<std::size_t> trial;         // the last that has touched the cell
  };

  bool is_in_part(int c) const { return parts_->part(topology_.cell(c)) == part_; }

  bool permits(bool is_permitted)
  {
    number_of_refusals_ += !is_permitted;
    return is_permitted;
  }

  bool permits_2_3(Half_facet s)
  {
    return parts_ == nullptr
           || permits(topology_.has_free_cell() && is_in_part(s.cell()) && is_in_part(topology_.neighbor(s).cell()));
  }

  bool permits_3_2(const Edge_ring_3& ring)
  {
    return parts_ == nullptr
           || permits(std::all_of(ring.begin(), ring.end(), [this](Half_facet s) { return is_in_part(s.cell()); }));
  }

  std::array<int, 3> flip_2_3(Half_facet s)
  {
    touch(s.cell());
    touch(topology_.neighbor(s).cell());
    const std::array<int, 3> cells = internal::flip_2_3(topology_, s);
    make_room();
    for(int c : cells)
      touch(c);
    return cells;
  }

  std::array<int, 2> flip_3_2(const Edge_ring_3& ring)
  {
    for(Half_facet s : ring)
      touch(s.cell());
    return internal::flip_3_2(topology_, ring);
  }

  // Cells that were not there before have no deficit.
  void touch(int c)
  {
    if(cells_->trial[c] == trial_)
      return;
    cells_->trial[c] = trial_;
    touched_.push_back(c);
    before_ += deficit(c);
  }

  void forget_mark()
  {
    has_mark_ = false;
    sites_since_mark_.clear();
    deficits_since_mark_.clear();
  }

  double measure(int c) const { return mesh_.deficit(c, angle_deficit_); }

  // Whether a vertex of the interior has pushed the dual point of the cell through the surface.
  bool is_beyond_surface(int c) const
  {
    for(int i = 0; i < 4; ++i)
      if(topology_.vertices(c)[i] < mesh_.number_of_interior_vertices && mesh_.is_beyond_surface(Half_facet(c, i)))
        return true;
    return false;
  }

  Constrained_triangulation_3& mesh_;
  Indexed_triangulation_3& topology_;          // that of the mesh, or a part of it
  Angle_deficit_3 angle_deficit_;
  const Mesh_parts_3* parts_ = nullptr;     // null for the whole
  int part_ = Mesh_parts_3::none;
  bool surfaces_move_ = true;
  std::shared_ptr<Cells> cells_;            // of the whole mesh
  std::size_t trial_ = 0, number_of_refusals_ = 0;
  int vertex_ = -1;
  Site from_;
  double before_ = 0, after_ = 0;
  std::vector<int> touched_;
  std::vector<Half_facet> star_, irregular_;
  Indexed_triangulation_3::Trial_length begin_ = {};   // of the trial, in the history since the mark
  bool has_mark_ = false;
  std::vector<std::pair<int, Site> > sites_since_mark_;         // and where they were
  std::vector<std::pair<int, double> > deficits_since_mark_;    // and what they were
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_INDEXED_RELOCATION_3_H
