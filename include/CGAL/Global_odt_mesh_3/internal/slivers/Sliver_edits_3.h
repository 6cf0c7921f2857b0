// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_EDITS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_EDITS_3_H

#include <CGAL/Global_odt_mesh_3/internal/complex/Exact_relocation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Vertex_edits_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Facet_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Sliver_steps.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Exchangeable_boundary_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Inserts vertices in and beside the cells with small dihedral angles, or removes vertices of these, the worst first, where
// that makes angles larger.
class Sliver_edits_3
{
public:
  Sliver_edits_3(Vertex_edits_3& edits, bool inserts, bool removes, unsigned int seed)
    : edits_(edits)
    , complex_(edits.complex())
    , inserts_(inserts)
    , removes_(removes)
    , random_(seed)
  {}

  // At most one vertex for each cell below the step.
  template <class Predicate>
  void run(int step, const Predicate& may_go_on)
  {
    Exact_relocation_3& trial = edits_.trial();
    trial.set_goal(Sliver_steps::angles[step], step);
    std::vector<std::pair<double, Quadruple> > slivers;
    for(const Quadruple& q : trial.slivers(Sliver_steps::angles[step]))
      slivers.emplace_back(trial.smallest_angle(q), q);
    std::sort(slivers.begin(), slivers.end());
    number_of_tries_ = 0;
    const std::size_t most_tries = fewest_tries + tries_for_a_cell * complex_.working.cells().size();
    for(const auto& s : slivers)
    {
      Cell_handle c;
      if(number_of_tries_ > most_tries || !may_go_on())
        return;
      if(trial.find_cell(s.second, c))
        improve(s.second, c);
    }
  }

private:
  static constexpr int tries = 8;                         // around each middle of a cell, a facet, or an edge
  static constexpr double farthest = 0.2;                 // over the longest edge of the cell
  static constexpr std::size_t tries_of_removal = 8;      // that take as long
  static constexpr std::size_t fewest_tries = 2000, tries_for_a_cell = 2;       // of the whole mesh
  static constexpr double least_improvement = 1e-6;       // square degrees

  struct Best
  {
    double change = -least_improvement;
    std::optional<New_vertex_3> vertex;
  };

  void improve(const Quadruple& q, Cell_handle c)
  {
    Best best;
    if(inserts_)
      try_insertions(q, c, best);
    if(removes_ && try_removals(q, best.change))
      return;
    // Vertices that have been detached have got other cells.
    if(best.vertex && edits_.trial().find_cell(q, c))
      edits_.insert_for_angles(*best.vertex, 0, c);
  }

  // Whether a vertex has been removed because that is better than any insertion.
  bool try_removals(const Quadruple& q, double most)
  {
    int best = -1;
    for(int v : edits_.trial().movable_vertices(q))
    {
      number_of_tries_ += tries_of_removal;
      const double change = edits_.change_without(v, most);
      if(!(change < most))
        continue;
      most = change;
      best = v;
    }
    return best >= 0 && edits_.remove_for_angles(best, 0);
  }

  void try_insertions(const Quadruple& q, Cell_handle c, Best& best)
  {
    const std::vector<Site>& sites = complex_.sites;
    std::vector<std::pair<double, std::array<int, 2> > > edges;
    for(int i = 0; i < 3; ++i)
      for(int j = i + 1; j < 4; ++j)
        edges.push_back({ -(position(sites[q[i]]) - position(sites[q[j]])).norm(), {{ q[i], q[j] }} });
    std::sort(edges.begin(), edges.end());
    const double length = farthest * -edges.front().first;
    for(int n = 0; n < 2; ++n)
      try_around(middle_of_edge(complex_, edges[n].second[0], edges[n].second[1], c), length, c, best);
    try_around(New_vertex_3{ (position(sites[q[0]]) + position(sites[q[1]]) + position(sites[q[2]]) + position(sites[q[3]])) / 4,
                             3, c->label() }, length, c, best);
    for(int i = 0; i < 4; ++i)
      try_around(middle_of_facet({{ q[(i + 1) % 4], q[(i + 2) % 4], q[(i + 3) % 4] }}), length, c, best);
  }

  std::optional<New_vertex_3> middle_of_facet(const Triple& t) const
  {
    const int n = complex_.boundary.find(sorted(t));
    if(n < 0 || complex_.boundary.facet(n).patch == Boundary_facet::no_patch)
      return std::nullopt;
    return New_vertex_3{ centroid(t, complex_.sites), 2, complex_.boundary.facet(n).patch,
                         Facet_dual_3(t, complex_.sites).normal };
  }

  void try_around(const std::optional<New_vertex_3>& base, double length, Cell_handle c, Best& best)
  {
    for(int n = 0; n < tries && base; ++n)
    {
      New_vertex_3 v = *base;
      if(n > 0)
        v.point += random_.uniform() * length * random_.direction();
      if(v.dimension == 2 && !complex_.domain.project(v.point, v.normal, length, v.place))
        continue;
      ++number_of_tries_;
      const double change = edits_.change_of_angles(v, best.change, c);
      if(change < best.change)
        best = { change, v };
    }
  }

  Vertex_edits_3& edits_;
  const Editable_complex_3& complex_;
  bool inserts_, removes_;
  Random_source random_;
  std::size_t number_of_tries_ = 0;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_EDITS_3_H
