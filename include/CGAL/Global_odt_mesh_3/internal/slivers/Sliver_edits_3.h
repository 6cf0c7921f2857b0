// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_EDITS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_EDITS_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Editable_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Vertex_edits_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Exchangeable_boundary_3.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Inserts vertices in and beside cells with small dihedral angles, or removes their vertices, the worst cells first, where that
// makes the angles larger.
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

  // Inserts or removes at most one vertex for each cell below the step's angle.
  template <class Predicate>
  void run(int step, const Predicate& may_go_on)
  {
    edits_.trial().set_goal(Sliver_goal(Sliver_steps::angles[step], step));
    const std::vector<Sliver_3> slivers = complex_.slivers(Sliver_steps::angles[step]);
    number_of_tries_ = 0;
    const std::size_t most_tries = fewest_tries + tries_for_a_cell * complex_.triangulation.cells().size();
    const std::size_t places = places_in_cell * (std::max)(slivers.size(), std::size_t(1));
    tries_ = (std::min)((std::max)(int(fewest_tries_around), int(most_tries / places)), int(most_tries_around));
    for(const Sliver_3& s : slivers)
    {
      if(number_of_tries_ > most_tries || !may_go_on())
        return;
      if(complex_.has(s))
        improve(s);
    }
  }

  // Inserts a vertex into a cell or, if given, into its facet on a surface, where the angles get best, as long as no more angles
  // fall below those of the steps before.
  void split(const Quadruple& q, int facet, int step)
  {
    const int c = complex_.find_cell(q);
    if(c < 0 || complex_.numbering.is_kept(q))
      return;
    edits_.trial().set_goal(Sliver_goal(Sliver_steps::angles[step], step));
    Best best;
    best.change = (std::numeric_limits<double>::infinity)();
    const double length = edges(q).front().length;
    if(facet < 0)
    {
      try_around(New_vertex_3{ complex_.triangulation.dual_point(c), 3, complex_.triangulation.label(c) }, farthest * length, c, best);
      try_insertions(q, c, best);
    }
    else
      try_around(middle_of_facet({{ q[(facet + 1) % 4], q[(facet + 2) % 4], q[(facet + 3) % 4] }}), farthest * length, c, best);
    if(best.vertex)
      edits_.insert_for_angles(*best.vertex, (std::numeric_limits<double>::infinity)(), c, true);
  }

private:
  // Tries around each middle of a cell, a facet, or an edge: more if few slivers are left.
  static constexpr int fewest_tries_around = 8, most_tries_around = 40, places_in_cell = 7;
  static constexpr double farthest = 0.2;                 // over the longest edge of the cell
  static constexpr std::size_t tries_of_removal = 8;      // as many tries take as long as one removal
  static constexpr std::size_t fewest_tries = 2000, tries_for_a_cell = 2;       // for the whole mesh
  static constexpr double least_improvement = 1e-6;       // square degrees

  struct Edge
  {
    double length;
    int u, v;
  };

  struct Best
  {
    double change = -least_improvement;
    std::optional<New_vertex_3> vertex;
  };

  void improve(const Sliver_3& s)
  {
    Best best;
    if(inserts_ && !edits_.is_full())
      try_insertions(s.vertices, s.cell, best);
    if(removes_ && try_removals(s.vertices, best.change))
      return;
    if(best.vertex)
      edits_.insert_for_angles(*best.vertex, 0, s.cell, true);
  }

  // Removes a vertex if that is better than any insertion; whether one was removed.
  bool try_removals(const Quadruple& q, double most)
  {
    int best = -1;
    for(int v : edits_.trial().movable_vertices(q))
    {
      number_of_tries_ += tries_of_removal;
      const double change = edits_.remove_for_angles(v, most, false);
      if(!(change < most))
        continue;
      most = change;
      best = v;
    }
    return best >= 0 && edits_.remove_for_angles(best, 0, true) < 0;
  }

  void try_insertions(const Quadruple& q, int c, Best& best)
  {
    const std::vector<Edge> longest = edges(q);
    const double length = farthest * longest.front().length;
    for(int n = 0; n < 2; ++n)
      try_around(middle_of_edge(complex_, longest[n].u, longest[n].v, c), length, c, best);
    try_around(middle_of_cell(q, c), length, c, best);
    for(int i = 0; i < 4; ++i)
      try_around(middle_of_facet({{ q[(i + 1) % 4], q[(i + 2) % 4], q[(i + 3) % 4] }}), length, c, best);
  }

  // The edges of a cell, the longest first.
  std::vector<Edge> edges(const Quadruple& q) const
  {
    std::vector<Edge> result;
    for(int i = 0; i < 3; ++i)
      for(int j = i + 1; j < 4; ++j)
        result.push_back({ (position(complex_.sites[q[i]]) - position(complex_.sites[q[j]])).length(), q[i], q[j] });
    std::sort(result.begin(), result.end(), [](const Edge& a, const Edge& b)
              { return a.length != b.length ? a.length > b.length : std::make_pair(a.u, a.v) < std::make_pair(b.u, b.v); });
    return result;
  }

  New_vertex_3 middle_of_cell(const Quadruple& q, int c) const
  {
    const std::vector<Site>& s = complex_.sites;
    return { (position(s[q[0]]) + position(s[q[1]]) + position(s[q[2]]) + position(s[q[3]])) / 4, 3, complex_.triangulation.label(c) };
  }

  // The centroid of a facet, put onto the surface; none if the facet is not on one.
  std::optional<New_vertex_3> middle_of_facet(const Triple& t) const
  {
    const int n = complex_.boundary.find(sorted(t));
    if(n < 0 || complex_.boundary.facet(n).patch == Boundary_facet::no_patch)
      return std::nullopt;
    const Facet_dual_3 dual(t, complex_.sites);
    New_vertex_3 v{ centroid(t, complex_.sites), 2, complex_.boundary.facet(n).patch, dual.normal };
    return complex_.domain.project(v.point, v.normal, dual.radius, v.place) ? std::make_optional(v) : std::nullopt;
  }

  void try_around(const std::optional<New_vertex_3>& base, double length, int c, Best& best)
  {
    for(int n = 0; n < tries_ && base; ++n)
    {
      New_vertex_3 v = *base;
      if(n > 0)
      {
        const Vector_3 direction = random_.direction();
        v.point += random_.uniform() * length * direction;
      }
      if(v.dimension == 2 && !complex_.domain.project(v.point, v.normal, length, v.place))
        continue;
      ++number_of_tries_;
      const double change = edits_.insert_for_angles(v, best.change, c, false);
      if(change < best.change)
        best = { change, v };
    }
  }

  Vertex_edits_3& edits_;
  const Editable_complex_3& complex_;
  bool inserts_, removes_;
  Random_source random_;
  int tries_ = fewest_tries_around;
  std::size_t number_of_tries_ = 0;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_EDITS_3_H
