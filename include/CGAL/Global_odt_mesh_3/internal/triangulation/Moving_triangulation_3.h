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
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Flat_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Lawson_flips_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// A constrained regular triangulation whose vertices move.
//
// evaluate() takes new positions, computes energy, gradient, orientation of the
// cells and regularity of the facets in one pass over the cells, and mends by
// flips what the motion broke. Constrained_facets are never flipped. When a motion cannot be
// mended, restore() brings back the state of the last keep().
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
    sites = kept_sites_;
    energy_ = kept_energy_;
    if(!has_kept_gradient_)
      gradient_.swap(kept_gradient_);
    has_kept_gradient_ = true;
    if(quadrature_ != nullptr)
      quadrature_->restore();
    topology.undo_trial();
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

  // Energy and gradient at the current positions after mending the topology; false if some cells
  // stay inverted or flips do not come to an end, whereupon the caller has to restore().
  // Some vertices may be moved in the course.
  bool evaluate()
  {
    ++statistics_.evaluations;
    retreated_.clear();
    if(quadrature_ != nullptr)
      quadrature_->update(sites, number_of_movable_vertices);
    pass();
    // A step that inverts so much is too long to be worth mending.
    if(inverted_.size() > 20 + static_cast<std::size_t>(topology.number_of_cells()) / 10)
      return false;
    if(!inverted_.empty())
    {
      const std::size_t damage = inverted_.size();
      if(!untangle() && (stuck_.size() > 20 + damage || !hold_back()))
        return false;
    }
    return make_regular() && retreat_from_surfaces();
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
  friend class Lawson_flips_3<Moving_triangulation_3>;

  // The quadrature is that of the mesh, by its type as far as that is faster, or null.
  template <class Quadrature>
  static Cell_energy cell_energy(const Cell_products& t, int cell, const int* v, const Site* s, Quadrature quadrature)
  {
    if constexpr (std::is_same_v<Quadrature, std::nullptr_t>)
      return uniform_odt_energy(t, s[v[0]], s[v[1]], s[v[2]], s[v[3]]);
    else
      return odt_energy(t, s[v[0]], s[v[1]], s[v[2]], s[v[3]], quadrature->moments(cell, v, s));
  }

  void pass()
  {
    if(has_kept_gradient_)
      gradient_.swap(kept_gradient_);
    has_kept_gradient_ = false;
    gradient_.assign(sites.size(), Site_gradient{ 0, 0, 0, 0 });
    inverted_.clear();
    irregular_.clear();
    intruders_.clear();
    energy_ = quadrature_ == nullptr ? fused_pass(nullptr)
            : linear_quadrature_ != nullptr ? fused_pass(linear_quadrature_) : fused_pass(quadrature_);
  }

  // Energy, gradient, orientation and regularity of everything at once; each
  // facet is tested from its first slot.
  template <class Quadrature>
  double fused_pass(Quadrature quadrature)
  {
    const int* const vertices = topology.cell_vertices();
    const int* const neighbors = topology.neighbors();
    const Site* const s = sites.data();
    Site_gradient* const g = gradient_.data();
    double energy = 0;
    for(int slot = 0, end = topology.number_of_slots(); slot < end; slot += 4)
    {
      const int* const v = vertices + slot;
      if(v[0] == Flat_triangulation_3::no_vertex)
        continue;
      const Site& origin = s[v[0]];
      const Cell_products t(origin, s[v[1]], s[v[2]], s[v[3]]);
      const Cell_energy e = cell_energy(t, slot / 4, v, s, quadrature);
      energy += e.energy;
      for(int i = 0; i < 4; ++i)
        g[v[i]] += e.gradient[i];
      if(!(t.determinant > 0))
      {
        inverted_.push_back(slot / 4);
        continue;
      }
      for(int i = 0; i < 4; ++i)
      {
        const int across = neighbors[slot + i];
        if(across > slot + i)
        {
          const Site& q = s[vertices[across]];
          const double power = t.power(origin, q);
          if(power < 0 && is_irregular(power, squared_distance(origin, q)))
            irregular_.push_back(slot + i);
        }
        else if(Flat_triangulation_3::is_constrained(across) && v[i] < number_of_interior_vertices
                && is_beyond_surface(t, v, i, across))
          intruders_.push_back(v[i]);
      }
    }
    return energy;
  }

  // Adds (or, with sign -1, removes) what a cell contributes.
  void add_cell(int cell, int sign)
  {
    const int* const v = topology.cell_vertices() + 4 * cell;
    const Cell_products t = products(cell);
    const Site* const s = sites.data();
    const Cell_energy e = quadrature_ == nullptr ? cell_energy(t, cell, v, s, nullptr)
                        : linear_quadrature_ != nullptr ? cell_energy(t, cell, v, s, linear_quadrature_)
                                                        : cell_energy(t, cell, v, s, quadrature_);
    energy_ += sign * e.energy;
    for(int i = 0; i < 4; ++i)
    {
      const Site_gradient& c = e.gradient[i];
      gradient_[v[i]] += { sign * c.x, sign * c.y, sign * c.z, sign * c.diagonal };
    }
  }

  std::array<int, 3> flip_2_3(int slot)
  {
    ++statistics_.flips;
    add_cell(slot / 4, -1);
    add_cell(topology.neighbor(slot) / 4, -1);
    const std::array<int, 3> cells = topology.flip_2_3(slot);
    for(int c : cells)
      add_cell(c, 1);
    return cells;
  }

  std::array<int, 2> flip_3_2(const std::array<int, 3>& ring)
  {
    ++statistics_.flips;
    for(int s : ring)
      add_cell(s / 4, -1);
    const std::array<int, 2> cells = topology.flip_3_2(ring);
    for(int c : cells)
      add_cell(c, 1);
    return cells;
  }

  bool make_regular() { return Lawson_flips_3<Moving_triangulation_3>(*this, *this, irregular_).make_regular(); }

  // Gives all cells positive volume, first by flips that lower the sum of the
  // negative volumes, then, if much is left, by moving vertices into the kernel
  // of their star. The cells for which this fails are left in stuck_.
  bool untangle()
  {
    statistics_.untangled_cells += inverted_.size();
    std::size_t budget = 100 + 8 * inverted_.size();
    stuck_.clear();
    for( ; !inverted_.empty() && budget > 0; --budget)
    {
      const int c = inverted_.back();
      inverted_.pop_back();
      if(is_inverted(c) && !best_untangling_flip(c))
        stuck_.push_back(c);
    }
    stuck_.insert(stuck_.end(), inverted_.begin(), inverted_.end());
    inverted_.clear();
    // Such a move is a jump of the energy, out of place once the steps are small.
    const bool may_jump = stuck_.size() > most_cells_held_back;
    stuck_.erase(std::remove_if(stuck_.begin(), stuck_.end(), [&](int c)
                                { return !is_inverted(c) || (may_jump && move_into_kernel(c)); }),
                 stuck_.end());
    stuck_.erase(std::remove_if(stuck_.begin(), stuck_.end(), [this](int c)
                                { return !is_inverted(c); }),
                 stuck_.end());
    return stuck_.empty();
  }

  void find_inverted_cells()
  {
    inverted_.clear();
    for(int c = 0; c < topology.number_of_cell_slots(); ++c)
      if(is_inverted(c))
        inverted_.push_back(c);
  }

  bool is_inverted(int c) const
  {
    return topology.is_alive(c) && !(products(c).determinant > 0);
  }

  // After untangle() failed: starts again from the kept state, with shorter
  // steps for the vertices of the cells that got stuck and, once these do not
  // move at all, of the vertices around.
  bool hold_back()
  {
    trial_sites_ = sites;
    std::vector<unsigned char> level(sites.size(), 0);
    const int standstill = 4;
    for(int round = 0; round < 12; ++round)
    {
      std::vector<int> held;
      for(int c : stuck_)
      {
        const int* const v = topology.cell_vertices() + 4 * c;
        held.insert(held.end(), v, v + 4);
      }
      topology.undo_trial();
      for(int ring = 0; ring < round / standstill; ++ring)
        add_neighbors(held);
      std::sort(held.begin(), held.end());
      held.erase(std::unique(held.begin(), held.end()), held.end());
      for(int v : held)
        if(level[v] < standstill)
          ++level[v];
      for(int v = 0; v < number_of_movable_vertices; ++v)
      {
        const double t = level[v] == standstill ? 0 : std::ldexp(1., -level[v]);
        const Site& from = kept_sites_[v];
        const Site& to = trial_sites_[v];
        if(t == 1)
          sites[v] = to;
        else
          sites[v] = { from.x + t * (to.x - from.x), from.y + t * (to.y - from.y),
                       from.z + t * (to.z - from.z), to.weight };
      }
      ++statistics_.holds;
      find_inverted_cells();
      irregular_.clear();
      if(inverted_.empty() || untangle())
      {
        // Where flips have been made, Lawson's are to come first: the others get stuck less often.
        const std::vector<int> flipped = irregular_;
        pass();
        irregular_.insert(irregular_.end(), flipped.begin(), flipped.end());
        for(int v = 0; v < number_of_movable_vertices; ++v)
          if(level[v] == standstill)
            retreated_.push_back(v);
        return true;
      }
    }
    return false;
  }

  // Appends the neighbors of the movable vertices in `vertices`.
  void add_neighbors(std::vector<int>& vertices)
  {
    for(std::size_t n = 0, end = vertices.size(); n < end; ++n)
    {
      if(vertices[n] >= number_of_movable_vertices)
        continue;
      topology.star(vertices[n], star_);
      for(int slot : star_)
        for(int i = 0; i < 4; ++i)
          vertices.push_back(topology.vertex(4 * (slot / 4) + i));
    }
  }

  bool best_untangling_flip(int c)
  {
    const auto negative = [](double volume) { return (std::max)(0., -volume); };
    // Flips that gain next to nothing go on forever.
    double best_gain = 0.1 * negative(products(c).determinant);
    int best_slot = -1;
    std::array<int, 3> best_ring;
    for(int i = 0; i < 4; ++i)
    {
      const int slot = 4 * c + i, across = topology.neighbor(slot);
      if(Flat_triangulation_3::is_constrained(across)
         || topology.vertex(across) == topology.vertex(slot))
        continue;
      const std::array<double, 3> after = volumes_after_2_3(slot);
      const double gain = negative(products(c).determinant)
                        + negative(products(across / 4).determinant)
                        - negative(after[0]) - negative(after[1]) - negative(after[2]);
      if(gain > best_gain)
      {
        best_gain = gain;
        best_slot = slot;
      }
    }
    for(int i = 0; i < 3; ++i)
      for(int j = i + 1; j < 4; ++j)
      {
        std::array<int, 3> ring;
        if(!topology.has_degree_3(c, i, j, ring))
          continue;
        const double gain = gain_of_3_2(ring);
        if(gain > best_gain)
        {
          best_gain = gain;
          best_slot = -2;
          best_ring = ring;
        }
      }
    if(best_slot == -1)
      return false;
    if(best_slot >= 0)
      collect_flipped(flip_2_3(best_slot));
    else
      collect_flipped(flip_3_2(best_ring));
    return true;
  }

  double gain_of_3_2(const std::array<int, 3>& ring) const
  {
    const auto negative = [](double volume) { return (std::max)(0., -volume); };
    double gain = 0;
    for(int s : ring)
      gain += negative(products(s / 4).determinant);
    const int p0 = topology.vertex(ring[0]), p1 = topology.vertex(ring[1]), p2 = topology.vertex(ring[2]);
    // The edge's ends a, b with (a, b, p0, p1) positive in the first cell.
    const int first = 4 * (ring[0] / 4);
    const std::array<int, 3>& f = Flat_triangulation_3::facet_vertices(ring[0] % 4);
    int m = 0;
    while(topology.vertex(first + f[m]) != p1)
      ++m;
    const int a = topology.vertex(first + f[(m + 1) % 3]), b = topology.vertex(first + f[(m + 2) % 3]);
    if(p0 == p2 || p1 == p2)
      return -1;
    return gain - negative(determinant(a, p0, p1, p2)) - negative(determinant(b, p0, p2, p1));
  }

  template <class Cells>
  void collect_flipped(const Cells& cells)
  {
    for(int c : cells)
    {
      if(!(products(c).determinant > 0))
        inverted_.push_back(c);
      push_facets(c, irregular_);
    }
  }

  bool move_into_kernel(int c)
  {
    for(int i = 0; i < 4; ++i)
    {
      const int v = topology.vertex(4 * c + i);
      if(v >= number_of_interior_vertices)
        continue;
      topology.star(v, star_);
      Site centroid = { 0, 0, 0, sites[v].weight };
      for(int slot : star_)
        for(int j = 0; j < 4; ++j)
          if(j != slot % 4)
          {
            const Site& s = sites[topology.vertex(4 * (slot / 4) + j)];
            centroid.x += s.x; centroid.y += s.y; centroid.z += s.z;
          }
      const double n = 3. * static_cast<double>(star_.size());
      centroid.x /= n; centroid.y /= n; centroid.z /= n;
      if(relocate(v, centroid))
        return true;
    }
    return false;
  }

  // Moves `v`, whose star is in star_, if all its cells become positive.
  bool relocate(int v, const Site& s)
  {
    const Site old = sites[v];
    for(int slot : star_)
      add_cell(slot / 4, -1);
    sites[v] = s;
    const bool positive = std::all_of(star_.begin(), star_.end(), [this](int slot)
                                      { return products(slot / 4).determinant > 0; });
    if(!positive)
      sites[v] = old;
    for(int slot : star_)
    {
      add_cell(slot / 4, 1);
      if(positive)
        push_facets(slot / 4, irregular_);
    }
    return positive;
  }

  // A vertex that has pushed the dual point of its cell beyond a constrained facet goes back
  // toward where it was. False if the flips that follow do not come to an end.
  bool retreat_from_surfaces()
  {
    // Flips change which vertices face constrained facets: look again around the flips only
    // at the next evaluation.
    for(int v : intruders_)
    {
      const Site& from = kept_sites_[v];
      const Site to = sites[v];
      topology.star(v, star_);
      for(double t : { 0.5, 0.25, 0. })
      {
        const Site s = { from.x + t * (to.x - from.x), from.y + t * (to.y - from.y),
                         from.z + t * (to.z - from.z), to.weight };
        if(relocate(v, s) && !is_beyond_any_surface())
          break;
      }
      ++statistics_.retreats;
      retreated_.push_back(v);
    }
    return make_regular();
  }

  // The same for all cells of star_.
  bool is_beyond_any_surface() const
  {
    return std::any_of(star_.begin(), star_.end(), [this](int slot)
    {
      const int across = topology.neighbor(slot);
      return Flat_triangulation_3::is_constrained(across)
             && is_beyond_surface(products(slot / 4), topology.cell_vertices() + slot - slot % 4, slot % 4, across);
    });
  }

  static constexpr std::size_t most_cells_held_back = 16;

  Density_quadrature_3* quadrature_ = nullptr;
  Linear_density_quadrature_3* linear_quadrature_ = nullptr;    // the same, if it is one
  std::vector<Site_gradient> gradient_, kept_gradient_;
  bool has_kept_gradient_ = false;    // whether the gradient is that of the kept state
  double energy_ = 0, kept_energy_ = 0;
  std::vector<int> inverted_, irregular_, intruders_, stuck_, star_, retreated_;
  std::vector<Site> kept_sites_, trial_sites_;
  Statistics statistics_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_MOVING_TRIANGULATION_3_H
