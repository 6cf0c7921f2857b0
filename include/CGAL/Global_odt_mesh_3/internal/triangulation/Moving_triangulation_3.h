// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_MOVING_TRIANGULATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_MOVING_TRIANGULATION_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/density/Density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/energy/Odt_cell_energies_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flips_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Fused_pass_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

struct Position_parameters_3
{
  // The step of a vertex is shortened to a half, to half of that and so on; at this time the vertex stays.
  int times_to_standstill = 4;

  // Where the vertices of the tangled cells stand still, those around them follow, and then those around these. Farther
  // away there is no reason why a step should not be feasible.
  int rings_slowed_down = 3;

  // No shorter steps are tried when that many cells more are tangled than were inverted at first, since the step was much
  // too long.
  std::size_t cells_out_of_reach = 20;
};

// Shortens the steps of vertices from the state that their mesh keeps, a Moving_triangulation_3.
template <class Mesh>
class Position_control_3
{
public:
  explicit Position_control_3(Mesh& mesh, const Position_parameters_3& parameters = Position_parameters_3())
    : mesh_(mesh)
    , parameters_(parameters)
  {}

  // Starts again from the kept state, with shorter steps for the vertices of tangled cells and, once these do not
  // move at all, of the vertices around. False if no such steps are found.
  bool shorten_steps(std::size_t number_of_inverted_cells)
  {
    if(mesh_.tangled_cells().size() > parameters_.cells_out_of_reach + number_of_inverted_cells)
      return false;
    std::map<int, int> times;
    for(int n = 0; n < parameters_.rings_slowed_down * parameters_.times_to_standstill; ++n)
    {
      const std::vector<int> held = vertices_to_slow_down(n / parameters_.times_to_standstill);
      for(int v : held)
        if(v < mesh_.number_of_movable_vertices)
          times[v] = (std::min)(times[v] + 1, parameters_.times_to_standstill);
      std::map<int, Site> sites;
      for(const auto& t : times)
        sites.emplace(t.first, on_the_way(t.first, mesh_.site_asked_for(t.first), part_of_step(t.second)));
      if(!mesh_.untangle_anew(sites))
        continue;
      for(const auto& t : times)
        if(t.second == parameters_.times_to_standstill)
          mesh_.add_stopped(t.first);
      return true;
    }
    return false;
  }

private:
  // The vertices of the tangled cells and of so many rings around. Leads back to the kept topology.
  std::vector<int> vertices_to_slow_down(int rings)
  {
    std::vector<int> vertices;
    for(int c : mesh_.tangled_cells())
      vertices.insert(vertices.end(), mesh_.topology.vertices(c), mesh_.topology.vertices(c) + 4);
    mesh_.topology.undo_trial();
    for(int ring = 0; ; ++ring)
    {
      std::sort(vertices.begin(), vertices.end());
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
      if(ring == rings)
        return vertices;
      add_neighbors(vertices);
    }
  }

  // Appends the neighbors of the movable vertices in `vertices`.
  void add_neighbors(std::vector<int>& vertices)
  {
    for(std::size_t n = 0, end = vertices.size(); n < end; ++n)
    {
      if(vertices[n] >= mesh_.number_of_movable_vertices)
        continue;
      mesh_.topology.star(vertices[n], star_);
      for(Half_facet s : star_)
        vertices.insert(vertices.end(), mesh_.topology.vertices(s.cell()), mesh_.topology.vertices(s.cell()) + 4);
    }
  }

  double part_of_step(int times) const
  {
    return times == parameters_.times_to_standstill ? 0 : std::ldexp(1., -times);
  }

  // The site between the kept position and another one.
  Site on_the_way(int v, const Site& to, double part) const
  {
    const Site& from = mesh_.kept_site(v);
    return { from.x + part * (to.x - from.x), from.y + part * (to.y - from.y), from.z + part * (to.z - from.z), to.weight };
  }

  Mesh& mesh_;
  Position_parameters_3 parameters_;
  std::vector<Half_facet> star_;
};

// A constrained regular triangulation whose vertices move.
//
// evaluate() takes new positions, those of move(), computes energy, gradient, orientation of the
// cells and regularity of the facets in one pass over the cells, and repairs by
// flips what the motion broke. Constrained facets are never flipped. When that does not succeed,
// restore() brings back the state of the last keep().
class Moving_triangulation_3
  : public Constrained_triangulation_3
{
public:
  // The density, null where it is one everywhere. A quadrature serves one mesh at a time.
  void set_quadrature(Density_quadrature_3* quadrature) { choice_.set_quadrature(quadrature); }
  Density_quadrature_3* quadrature() const { return choice_.quadrature(); }

  // Loops run on one thread unless this is called. The result does not depend on the threads.
  void set_threads(const Thread_policy& threads) { threads_ = threads; }
  const Thread_policy& threads() const { return threads_; }

  struct Statistics
  {
    std::size_t evaluations = 0, flips = 0, untangled_cells = 0, restorations = 0, holds = 0;
  };

  double energy() const { return energy_; }
  const Statistics& statistics() const { return statistics_; }

  // Calls f(v, gradient) for all vertices, on threads, as they are after the last evaluation.
  template <class F>
  void for_each_gradient(const F& f) const
  {
    const Chunks blocks(gradient_.number_of_blocks(), least_blocks, most_chunks);
    threads_.for_each_chunk(blocks.number(), [&](int n) { gradient_.for_each_sum(blocks.begin(n), blocks.end(n), f); });
  }

  // Frees the memory for gradients until the next evaluation.
  void release_gradient() { gradient_.resize(0, 0); }

  // Remembers the state for restore(): positions, density, topology and energy.
  void keep()
  {
    kept_sites_ = sites;
    kept_energy_ = energy_;
    choice_.keep();
    topology.begin_trial();
  }

  // Lays the cells out anew, at a state that is to be kept.
  void compact()
  {
    topology.compact(threads_);
    keep();
  }

  // Calls place(v, site) for the movable vertices, on threads, which may change what is not the weight.
  template <class Place>
  void move(const Place& place)
  {
    for_each_in_chunks(number_of_movable_vertices, threads_, [&](int v) { place(v, sites[v]); });
  }

  // There is no gradient after that.
  void restore()
  {
    sites = kept_sites_;
    energy_ = kept_energy_;
    choice_.restore();
    topology.undo_trial();
    CGAL_expensive_assertion(topology.is_valid());
    ++statistics_.restorations;
  }

  // Becomes what it was once, but that the statistics go on.
  void go_back(const Moving_triangulation_3& before)
  {
    const Statistics statistics = statistics_;
    *this = before;
    statistics_ = statistics;
    choice_.update(sites, number_of_movable_vertices, threads_);
  }

  // Energy and gradient at the current positions after repairing the topology; false if some cells
  // stay inverted or flips do not come to an end, whereupon the caller has to restore().
  // Some vertices may be moved in the course, toward where they were when the state was kept.
  bool evaluate()
  {
    ++statistics_.evaluations;
    asked_for_sites_.clear();
    stopped_.clear();
    choice_.update(sites, number_of_movable_vertices, threads_);
    pass();
    const std::size_t number_of_inverted_cells = inverted_.size();
    if(number_of_inverted_cells > most_inverted_cells())
      return false;
    if(number_of_inverted_cells > 0 && !untangle() && !Position_control(*this).shorten_steps(number_of_inverted_cells))
      return false;
    const bool is_regular = make_regular();
    CGAL_expensive_assertion(topology.is_valid());
    return is_regular;
  }

  // Whether all cells are positive and, up to rounding, locally regular; nothing is changed but energy and gradient.
  bool is_regular()
  {
    pass();
    return inverted_.empty() && irregular_.empty();
  }

  // The vertices that the last evaluation did not let go anywhere.
  const std::vector<int>& stopped_vertices() const { return stopped_; }

private:
  typedef Position_control_3<Moving_triangulation_3> Position_control;

  friend class Lawson_flips_3<Moving_triangulation_3>;
  friend class Untangling_flips_3<Moving_triangulation_3>;
  friend class Position_control_3<Moving_triangulation_3>;

  // A step that inverts more is too long to be worth repairing.
  std::size_t most_inverted_cells() const { return 20 + static_cast<std::size_t>(topology.number_of_cells()) / 10; }

  // A chunk is to be worth the trouble of a thread.
  static constexpr int least_blocks = 64, most_chunks = 16;

  void pass()
  {
    const Thread_policy threads = choice_.is_safe_for_threads() ? threads_ : Thread_policy();
    choice_.visit([&](auto energy) { energy_ = pass_.run(*this, energy, threads, gradient_); });
    energy_of_pass_ = energy_;
    pass_.lists(inverted_, irregular_);
  }

  // Adds (or, with sign -1, removes) what a cell contributes.
  void add_cell(int cell, int sign)
  {
    const int* const v = topology.vertices(cell);
    choice_.visit([&](auto energy)
    {
      const Cell_energy e = energy(products(cell), cell, v, sites.data());
      energy_ += sign * e.energy;
      const Fused_pass_3::Gradient::Part repairs = gradient_.part(gradient_.number_of_parts() - 1);
      for(int i = 0; i < 4; ++i)
      {
        const Site_gradient& c = e.gradient[i];
        repairs.add(v[i], { sign * c.x, sign * c.y, sign * c.z, sign * c.diagonal });
      }
    });
  }

  std::array<int, 3> flip_2_3(Half_facet s)
  {
    ++statistics_.flips;
    add_cell(s.cell(), -1);
    add_cell(topology.neighbor(s).cell(), -1);
    const std::array<int, 3> cells = internal::flip_2_3(topology, s);
    for(int c : cells)
      add_cell(c, 1);
    return cells;
  }

  std::array<int, 2> flip_3_2(const Edge_ring_3& ring)
  {
    ++statistics_.flips;
    for(Half_facet s : ring)
      add_cell(s.cell(), -1);
    const std::array<int, 2> cells = internal::flip_3_2(topology, ring);
    for(int c : cells)
      add_cell(c, 1);
    return cells;
  }

  bool make_regular() { return Lawson_flips_3<Moving_triangulation_3>(*this, *this, irregular_).make_regular(); }

  // Gives all cells positive volume by flips. The cells for which this fails are left in tangled_.
  bool untangle()
  {
    statistics_.untangled_cells += inverted_.size();
    Untangling_flips_3<Moving_triangulation_3>(*this, *this, inverted_, irregular_).run(tangled_);
    return tangled_.empty();
  }

  const std::vector<int>& tangled_cells() const { return tangled_; }
  const Site& kept_site(int v) const { return kept_sites_[v]; }

  void add_stopped(int v) { stopped_.push_back(v); }

  const Site& site_asked_for(int v) const
  {
    const auto asked_for = asked_for_sites_.find(v);
    return asked_for == asked_for_sites_.end() ? sites[v] : asked_for->second;
  }

  // Replaces a site in the course of repairs.
  void replace(int v, const Site& s)
  {
    asked_for_sites_.emplace(v, sites[v]);    // unless it has been replaced before
    sites[v] = s;
  }

  // The same from the kept topology on, with other positions for some vertices, in whose stars alone things are
  // not as the pass has found them.
  bool untangle_anew(const std::map<int, Site>& others)
  {
    ++statistics_.holds;
    for(const auto& a : asked_for_sites_)
      sites[a.first] = a.second;
    gradient_.clear(gradient_.number_of_parts() - 1);
    energy_ = energy_of_pass_;
    pass_.lists(inverted_, irregular_);
    std::set<int> cells;
    for(const auto& o : others)
    {
      topology.star(o.first, star_);
      for(Half_facet s : star_)
        cells.insert(s.cell());
    }
    for(int c : cells)
      add_cell(c, -1);
    for(const auto& o : others)
      replace(o.first, o.second);
    inverted_.erase(std::remove_if(inverted_.begin(), inverted_.end(), [&](int c) { return cells.count(c) > 0; }),
                    inverted_.end());
    for(int c : cells)
      add_anew(c);
    return inverted_.empty() || untangle();
  }

  // Adds a cell with all that the pass finds out about it.
  void add_anew(int c)
  {
    add_cell(c, 1);
    push_facets(c, irregular_);
    if(is_inverted(c))
      inverted_.push_back(c);
  }

  Thread_policy threads_;
  Fused_pass_3 pass_;
  Energy_choice_3 choice_;
  Fused_pass_3::Gradient gradient_;   // the last part is what repairs add
  double energy_ = 0, kept_energy_ = 0, energy_of_pass_ = 0;
  std::vector<int> inverted_, tangled_, stopped_;
  std::vector<Half_facet> irregular_, star_;
  std::vector<Site> kept_sites_;
  std::map<int, Site> asked_for_sites_;   // of vertices that repairs have moved
  Statistics statistics_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_MOVING_TRIANGULATION_3_H
