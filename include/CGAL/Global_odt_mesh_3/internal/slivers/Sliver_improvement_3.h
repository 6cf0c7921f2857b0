// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_IMPROVEMENT_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_IMPROVEMENT_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/blocks/Mesh_partition_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Indexed_relocation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Of Sliver_removal_3 and Sliver_improvement_3.
struct Sliver_removal_parameters
{
  double margin = 0.5;              // degrees by which cells should exceed the bound: surfaces may take some away
  int tries_per_vertex = 8;
  double farthest = 0.35, nearest = 0.12;   // the longest tries, over the mean incident edge length, near ones first
  int most_failures = 3;            // for the same cell
  int most_passes = 12;
  double joint_farthest = 0.2;                // the longest of a vertex, over the same
  int joint_tries_per_sliver = 2, most_joint_tries = 20, passes_after_joint_try = 5;
  int vertices_of_part = 5000, partitions = 3;    // how large parts are, and how often others are made
  int free_cells_of_part = 500;                   // by which it may get larger
  std::size_t most_tries = (std::numeric_limits<std::size_t>::max)();     // of single vertices, which are what takes time
};

// Where the vertices of slivers may go. Several threads may ask for vertices of the interior at the same time, and for those
// on surfaces if the removal of slivers is told so.
class Vertex_motion_3
{
public:
  virtual ~Vertex_motion_3() {}

  // Changes a place for the vertex to one as good as allowed, quickly; false if the vertex has to
  // stay.
  virtual bool approach(int v, Site& s) = 0;

  // Changes a place that has been approached, and has turned out to be promising, to one that is
  // allowed, perhaps where it is; false if the vertex has to stay.
  virtual bool settle(int v, Site& s) = 0;
};

// Improves cells one after the other, by moving single vertices of theirs or all at once, in the whole mesh or in a part of it.
class Sliver_improvement_3
{
public:
  Sliver_improvement_3(Constrained_triangulation_3& mesh, double bound, unsigned int seed, Vertex_motion_3* motion,
                       const Sliver_removal_parameters& parameters, const Thread_policy& threads)
    : mesh_(mesh)
    , parameters_(parameters)
    , trial_(mesh, bound + parameters.margin, threads)
    , motion_(motion)
    , random_(seed)
    , records_(std::make_shared<Records>())
  {
    records_->edge_length.assign(mesh.number_of_movable_vertices, 0);
    make_room();
  }

  // In a part of the mesh, where vertices on surfaces may have to stay. Parts may be improved at the same time.
  Sliver_improvement_3(Sliver_improvement_3& whole, Indexed_triangulation_3& topology, const Mesh_parts_3& parts, int part,
                       bool surfaces_move, unsigned int seed, std::size_t most_tries)
    : mesh_(whole.mesh_)
    , parameters_(whole.parameters_)
    , trial_(whole.trial_, topology, parts, part, surfaces_move)
    , motion_(whole.motion_)
    , random_(seed)
    , records_(whole.records_)
    , is_part_(true)
  {
    parameters_.most_tries = most_tries;
  }

  // Lengthens the arrays of cells to the number of cell slots.
  void make_room()
  {
    trial_.make_room();
    records_->failures.resize(mesh_.topology.number_of_cell_slots());
  }

  // Takes over what a part has tried.
  void join(const Sliver_improvement_3& part)
  {
    trial_.join(part.trial_);
    number_of_moves_ += part.number_of_moves_;
    number_of_surface_moves_ += part.number_of_surface_moves_;
    number_of_tries_ += part.number_of_tries_;
  }

  std::size_t number_of_moves() const { return number_of_moves_; }
  std::size_t number_of_surface_moves() const { return number_of_surface_moves_; }
  // Of single vertices, whatever became of them.
  std::size_t number_of_tries() const { return number_of_tries_; }
  bool has_tries() const { return number_of_tries_ < parameters_.most_tries; }

  // Whether the cell lacks more than one angle at the bound does.
  bool is_sliver(int c) const { return trial_.deficit(c) > parameters_.margin * parameters_.margin; }

  // The slivers among the cells, the worst first.
  std::vector<int> sort(std::vector<int> cells) const
  {
    std::vector<std::pair<double, int> > slivers;
    for(int c : cells)
      if(is_sliver(c))
        slivers.emplace_back(-trial_.deficit(c), c);
    std::sort(slivers.begin(), slivers.end());
    slivers.erase(std::unique(slivers.begin(), slivers.end()), slivers.end());
    cells.clear();
    for(const auto& s : slivers)
      cells.push_back(s.second);
    return cells;
  }

  // Whether something has been improved, or may be next time; false once `may_go_on()`, asked before each sliver, says no.
  template <class Predicate>
  bool improve(const std::vector<int>& slivers, const Predicate& may_go_on)
  {
    bool improved = false;
    for(int c : slivers)
    {
      if(!has_tries() || !may_go_on())
        return false;
      if(is_sliver(c) && improve(c))
        improved = true;
    }
    return improved;
  }

  // The same, some times, for these slivers and those that come up on the way.
  template <class Predicate>
  void improve_repeatedly(std::vector<int> slivers, const Predicate& may_go_on)
  {
    changed_cells_.clear();
    for(int n = 0; n < parameters_.most_passes && improve(slivers, may_go_on); ++n)
    {
      slivers.insert(slivers.end(), changed_cells_.begin(), changed_cells_.end());
      slivers = sort(std::move(slivers));
      changed_cells_.clear();
    }
    for(int c : left_cells_)
      records_->failures[c] = Failures();
  }

  // Displaces all vertices of a cell at once; whether that has led to less deficit, or else it is taken back.
  template <class Predicate>
  bool displace_vertices(int cell, const Predicate& may_go_on)
  {
    const std::size_t moves = number_of_moves_, surface_moves = number_of_surface_moves_;
    change_ = 0;
    trial_.set_mark();
    for(int v : movable_vertices(cell))
    {
      Site s = displaced(v, parameters_.joint_farthest);
      if(!approach(v, s) || (is_on_surface(v) && !motion_->settle(v, s)))
        continue;
      const double change = move(v, s);
      if(std::isfinite(change))
        accept(v, change);
      else
        trial_.reject();
    }
    for(int n = 0; n < parameters_.passes_after_joint_try && improve(sort(trial_.cells_since_mark()), may_go_on); ++n) {}
    if(change_ < -least_improvement)
    {
      trial_.accept_since_mark();
      return true;
    }
    trial_.reject_since_mark();
    number_of_moves_ = moves;
    number_of_surface_moves_ = surface_moves;
    return false;
  }

private:
  // How often a cell has been tried in vain.
  struct Failures
  {
    double deficit = 0;
    int number = 0;
  };

  struct Records
  {
    std::vector<Failures> failures;         // of cells
    std::vector<double> edge_length;        // the mean at each movable vertex when it was first asked for, or 0
  };

  static constexpr double least_improvement = 1e-6;     // square degrees

  // Those that may move here. Those of the interior come first: that needs no question to the domain.
  std::vector<int> movable_vertices(int cell)
  {
    std::vector<int> vertices;
    for(int v : mesh_.topology.cell(cell))
      if(v < mesh_.number_of_movable_vertices && trial_.may_move(v))
        vertices.push_back(v);
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  }

  Site displaced(int v, double farthest)
  {
    const Site& s = mesh_.sites[v];
    const Eigen::Vector3d d = edge_length(v) * random_.uniform() * farthest * random_.direction();
    return { s.x + d[0], s.y + d[1], s.z + d[2], s.weight };
  }

  // The mean around the vertex when it is first asked for: few vertices are.
  double edge_length(int v)
  {
    double& length = records_->edge_length[v];
    if(length == 0)
      length = mesh_.mean_edge_length(v);
    return length;
  }

  // Without a motion, no vertex on a surface gets beyond this.
  bool approach(int v, Site& s) { return motion_ != nullptr ? motion_->approach(v, s) : !is_on_surface(v); }

  // A cell that steps toward more do not help gets random positions tried when its turn comes again.
  bool improve(int cell)
  {
    if(records_->failures.size() <= static_cast<std::size_t>(cell))
      make_room();
    Failures& failures = records_->failures[cell];
    if(failures.deficit != trial_.deficit(cell))
      failures = { trial_.deficit(cell), 0 };
    if(failures.number == parameters_.most_failures)
      return false;
    best_change_ = -least_improvement;
    best_vertex_ = -1;
    const std::size_t refusals = trial_.number_of_refusals();
    const std::vector<int> vertices = movable_vertices(cell);
    if(trial_.number_of_refusals() == refusals)
      for(int v : vertices)
        if(failures.number == 0 ? try_steps(v) : try_positions(v))
          return true;
    // What is at a seam is better left to another part, or the whole.
    if(trial_.number_of_refusals() > refusals)
    {
      left_cells_.push_back(cell);
      failures.number = parameters_.most_failures;
      return false;
    }
    if(best_vertex_ < 0)
      return ++failures.number < parameters_.most_failures;
    accept(best_vertex_, move(best_vertex_, best_site_));
    return true;
  }

  // These say whether a position was found, and accepted, that leaves no deficit.
  bool try_steps(int v)
  {
    const Eigen::Vector3d step = trial_.step_to_more(v, parameters_.farthest * edge_length(v));
    for(double factor : { 1., .5, .25 })
      if(try_position(v, site_at(position(mesh_.sites[v]) + factor * step, mesh_.sites[v].weight)) == SOLVED)
        return true;
    return false;
  }

  bool try_positions(int v)
  {
    for(int n = 0; n < parameters_.tries_per_vertex; ++n)
      switch(try_position(v, displaced(v, 2 * n < parameters_.tries_per_vertex ? parameters_.nearest : parameters_.farthest)))
      {
        case SOLVED: return true;
        case STAYS: return false;
        case TRIED: break;
      }
    return false;
  }

  enum Outcome { TRIED, STAYS, SOLVED };

  Outcome try_position(int v, Site s)
  {
    if(!approach(v, s))
      return STAYS;
    double change = move(v, s, best_change_);
    if(is_on_surface(v) && change < best_change_)
    {
      trial_.reject();
      if(!motion_->settle(v, s))
        return STAYS;
      change = move(v, s, best_change_);
    }
    if(change < -least_improvement && trial_.deficit_after() == 0)
    {
      accept(v, change);
      return SOLVED;
    }
    trial_.reject();
    if(change < best_change_)
    {
      best_change_ = change;
      best_vertex_ = v;
      best_site_ = s;
    }
    return TRIED;
  }

  void accept(int v, double change)
  {
    trial_.accept();
    if(is_part_)
      changed_cells_.insert(changed_cells_.end(), trial_.touched_cells().begin(), trial_.touched_cells().end());
    change_ += change;
    ++number_of_moves_;
    number_of_surface_moves_ += is_on_surface(v);
  }

  double move(int v, const Site& s, double most = (std::numeric_limits<double>::infinity)())
  {
    ++number_of_tries_;
    return trial_.move(v, s, most);
  }

  bool is_on_surface(int v) const { return v >= mesh_.number_of_interior_vertices; }

  Constrained_triangulation_3& mesh_;
  Sliver_removal_parameters parameters_;
  Indexed_relocation_3 trial_;
  Vertex_motion_3* motion_;
  Random_source random_;
  std::shared_ptr<Records> records_;        // of the whole mesh
  bool is_part_ = false;
  std::vector<int> left_cells_;             // that not all of their vertices have been tried for
  std::vector<int> changed_cells_;
  double change_ = 0;             // of the deficit by all that has been accepted
  double best_change_ = 0;
  int best_vertex_ = -1;
  Site best_site_ = { 0, 0, 0, 0 };
  std::size_t number_of_moves_ = 0, number_of_surface_moves_ = 0;
  std::size_t number_of_tries_ = 0;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_IMPROVEMENT_3_H
