// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_MOVING_TRIANGULATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_MOVING_TRIANGULATION_3_H

#include <CGAL/Global_odt_mesh_3/internal/density/Density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Linear_density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/energy/Odt_energy_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_products_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flat_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flips_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Fused_pass_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Lawson_flips_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Position_control_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Slot.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Untangling_flips_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// A constrained regular triangulation whose vertices move.
//
// evaluate() takes new positions, computes energy, gradient, orientation of the
// cells and regularity of the facets in one pass over the cells, and repairs by
// flips what the motion broke. Constrained facets are never flipped. When that does not succeed,
// restore() brings back the state of the last keep().
class Moving_triangulation_3
  : public Constrained_triangulation_3
{
public:
  // The density, null where it is one everywhere. A quadrature serves one mesh at a time.
  void set_quadrature(Density_quadrature_3* quadrature)
  {
    quadrature_ = quadrature;
    linear_quadrature_ = dynamic_cast<Linear_density_quadrature_3*>(quadrature);
  }

  Density_quadrature_3* quadrature() const { return quadrature_; }

  // One thread, unless this is called. How many there are then does not matter.
  void set_threads(const Thread_policy& threads) { threads_ = threads; }
  const Thread_policy& threads() const { return threads_; }

  struct Statistics
  {
    std::size_t evaluations = 0, flips = 0, untangled_cells = 0, restorations = 0, holds = 0, retreats = 0;
  };

  double energy() const { return energy_; }
  const std::vector<Site_gradient>& gradient() const { return gradient_; }
  const Statistics& statistics() const { return statistics_; }

  // Remembers the state for restore(): positions, density, topology, energy and gradient.
  void keep()
  {
    kept_sites_ = sites;
    kept_energy_ = energy_;
    has_kept_gradient_ = true;
    if(quadrature_ != nullptr)
      quadrature_->keep();
    topology.begin_trial();
  }

  void restore()
  {
    CGAL_assertion(kept_sites_.size() == sites.size());
    sites = kept_sites_;
    energy_ = kept_energy_;
    if(!has_kept_gradient_)
      gradient_.swap(kept_gradient_);
    has_kept_gradient_ = true;
    if(quadrature_ != nullptr)
      quadrature_->restore();
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
    if(quadrature_ != nullptr)
      quadrature_->update(sites, number_of_movable_vertices);
  }

  // Energy and gradient at the current positions after repairing the topology; false if some cells
  // stay inverted or flips do not come to an end, whereupon the caller has to restore().
  // Some vertices may be moved in the course.
  bool evaluate()
  {
    ++statistics_.evaluations;
    retreated_.clear();
    if(quadrature_ != nullptr)
      quadrature_->update(sites, number_of_movable_vertices);
    pass();
    const std::size_t number_of_inverted_cells = inverted_.size();
    if(number_of_inverted_cells > most_inverted_cells())
      return false;
    if(number_of_inverted_cells > 0)
    {
      asked_for_sites_ = sites;
      asked_for_gradient_ = gradient_;
      asked_for_energy_ = energy_;
      if(!untangle() && !Position_control(*this).hold_back(number_of_inverted_cells))
        return false;
    }
    if(!make_regular())
      return false;
    retreat_from_surfaces();
    const bool is_regular = make_regular();
    CGAL_expensive_assertion(topology.is_valid());
    return is_regular;
  }

  // Whether all cells are positive and, up to rounding, locally regular, and their
  // dual points on their side of constrained facets; nothing is changed but energy and gradient.
  bool is_regular()
  {
    pass();
    return inverted_.empty() && irregular_.empty() && intruders_.empty();
  }

  // The vertices that the last evaluation kept from going where they were sent.
  const std::vector<int>& retreated_vertices() const { return retreated_; }

private:
  typedef Position_control_3<Moving_triangulation_3> Position_control;

  friend class Lawson_flips_3<Moving_triangulation_3>;
  friend class Untangling_flips_3<Moving_triangulation_3>;
  friend class Position_control_3<Moving_triangulation_3>;

  // A step that inverts more is too long to be worth repairing.
  std::size_t most_inverted_cells() const { return 20 + static_cast<std::size_t>(topology.number_of_cells()) / 10; }

  void pass()
  {
    if(has_kept_gradient_)
      gradient_.swap(kept_gradient_);
    has_kept_gradient_ = false;
    if(quadrature_ == nullptr)
      energy_ = pass_.run(*this, nullptr, threads_, gradient_);
    else if(linear_quadrature_ != nullptr)
      energy_ = pass_.run(*this, linear_quadrature_->view(), threads_, gradient_);
    else                        // which may ask the user
      energy_ = pass_.run(*this, quadrature_, Thread_policy(), gradient_);
    pass_.lists(inverted_, irregular_, intruders_);
  }

  // Adds (or, with sign -1, removes) what a cell contributes.
  void add_cell(int cell, int sign)
  {
    const int* const v = topology.vertices(cell);
    const Cell_products t = products(cell);
    const Site* const s = sites.data();
    const Cell_energy e
      = quadrature_ == nullptr ? Fused_pass_3::cell_energy(t, cell, v, s, nullptr)
      : linear_quadrature_ != nullptr ? Fused_pass_3::cell_energy(t, cell, v, s, linear_quadrature_->view())
                                      : Fused_pass_3::cell_energy(t, cell, v, s, quadrature_);
    energy_ += sign * e.energy;
    for(int i = 0; i < 4; ++i)
    {
      const Site_gradient& c = e.gradient[i];
      gradient_[v[i]] += { sign * c.x, sign * c.y, sign * c.z, sign * c.diagonal };
    }
  }

  std::array<int, 3> flip_2_3(Slot s)
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
    for(Slot s : ring)
      add_cell(s.cell(), -1);
    const std::array<int, 2> cells = internal::flip_3_2(topology, ring);
    for(int c : cells)
      add_cell(c, 1);
    return cells;
  }

  bool make_regular() { return Lawson_flips_3<Moving_triangulation_3>(*this, *this, irregular_).make_regular(); }

  // Gives all cells positive volume, first by flips, then, if many are left, by moving vertices into the kernel
  // of their star. The cells for which this fails are left in stuck_.
  bool untangle()
  {
    statistics_.untangled_cells += inverted_.size();
    Untangling_flips_3<Moving_triangulation_3>(*this, *this, inverted_, irregular_).run(stuck_);
    Position_control(*this).jump_into_kernels(stuck_);
    return stuck_.empty();
  }

  const std::vector<int>& stuck_cells() const { return stuck_; }
  const Site& kept_site(int v) const { return kept_sites_[v]; }
  const Site& site_asked_for(int v) const { return asked_for_sites_[v]; }
  void add_retreated(int v) { retreated_.push_back(v); }

  // The same from the kept topology on, with other positions for some vertices, in whose stars alone things are
  // not as the pass has found them.
  bool untangle_anew(const std::map<int, Site>& others)
  {
    ++statistics_.holds;
    sites = asked_for_sites_;
    gradient_ = asked_for_gradient_;
    energy_ = asked_for_energy_;
    pass_.lists(inverted_, irregular_, intruders_);
    std::set<int> cells;
    for(const auto& o : others)
    {
      topology.star(o.first, star_);
      for(Slot s : star_)
        cells.insert(s.cell());
    }
    for(int c : cells)
      add_cell(c, -1);
    for(const auto& o : others)
      sites[o.first] = o.second;
    inverted_.erase(std::remove_if(inverted_.begin(), inverted_.end(), [&](int c) { return cells.count(c) > 0; }),
                    inverted_.end());
    for(int c : cells)
      add_anew(c);
    return inverted_.empty() || untangle();
  }

  // With all that the pass finds out about a cell.
  void add_anew(int c)
  {
    add_cell(c, 1);
    push_facets(c, irregular_);
    if(is_inverted(c))
      inverted_.push_back(c);
    else
      for(int i = 0; i < 4; ++i)
        if(topology.vertices(c)[i] < number_of_interior_vertices && is_beyond_surface(Slot(c, i)))
          intruders_.push_back(topology.vertices(c)[i]);
  }

  // Moves `v` if all its cells, those of its star, become positive.
  bool relocate(int v, const std::vector<Slot>& star, const Site& s)
  {
    CGAL_assertion(std::all_of(star.begin(), star.end(), [&](Slot t) { return topology.vertex(t) == v; }));
    const Site old = sites[v];
    for(Slot t : star)
      add_cell(t.cell(), -1);
    sites[v] = s;
    const bool positive = std::all_of(star.begin(), star.end(), [this](Slot t)
                                      { return products(t.cell()).determinant > 0; });
    if(!positive)
      sites[v] = old;
    for(Slot t : star)
    {
      add_cell(t.cell(), 1);
      if(positive)
        push_facets(t.cell(), irregular_);
    }
    return positive;
  }

  // Flips change which vertices face constrained facets: around them, that is seen
  // at the next evaluation only.
  void retreat_from_surfaces()
  {
    statistics_.retreats += intruders_.size();
    for(int v : intruders_)
      Position_control(*this).retreat_from_surface(v);
  }

  Thread_policy threads_;
  Fused_pass_3 pass_;
  Density_quadrature_3* quadrature_ = nullptr;
  Linear_density_quadrature_3* linear_quadrature_ = nullptr;    // the same, if it is one
  std::vector<Site_gradient> gradient_, kept_gradient_;
  bool has_kept_gradient_ = false;    // whether the gradient is that of the kept state
  double energy_ = 0, kept_energy_ = 0, asked_for_energy_ = 0;
  std::vector<int> inverted_, intruders_, stuck_, retreated_;
  std::vector<Slot> irregular_, star_;
  std::vector<Site> kept_sites_;
  // Where vertices are sent, and what the pass finds there, before any flip.
  std::vector<Site> asked_for_sites_;
  std::vector<Site_gradient> asked_for_gradient_;
  Statistics statistics_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_MOVING_TRIANGULATION_3_H
