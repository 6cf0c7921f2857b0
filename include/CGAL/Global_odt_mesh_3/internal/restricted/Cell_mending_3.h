// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_CELL_MENDING_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_CELL_MENDING_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Guilty_vertices_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_draft_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// What is done about cells whose dual point is beyond the surface.
template <class Triangulation, class Mesh_domain>
class Cell_mending_3
{
public:
  typedef Restricted_draft_3<Triangulation, Mesh_domain> Draft;
  typedef typename Draft::Complex Complex;
  typedef typename Draft::Quadruple Quadruple;
  typedef Guilty_vertices_3<Triangulation, Mesh_domain> Guilty_vertices;

  Cell_mending_3(const Complex& complex, const Draft& draft, Guilty_vertices& guilty)
    : complex_(complex)
    , draft_(draft)
    , guilty_(guilty)
  {}

  // Whether the cell is one of the input, which may be as it likes.
  bool is_excused(const Quadruple& q)
  {
    if(!draft_.are_home(q))
      return false;
    if(complex_.has_changed())
      return excused_.count(sorted(q)) > 0;
    typename Draft::Cell_handle c;
    if(!complex_.triangulation->is_cell(complex_.vertices[q[0]], complex_.vertices[q[1]], complex_.vertices[q[2]],
                                        complex_.vertices[q[3]], c))
      return false;
    excused_.insert(sorted(q));
    return true;
  }

  // The vertices of the cell have come too close to the boundary, or else its vertex of
  // the interior is to move away from it.
  void mend_cell(const Quadruple& q, int label)
  {
    const auto may_go_back = [this](int v)
    { return draft_.is_movable(v) && !draft_.is_home(v) && guilty_.number_of_strikes(v) < 2; };
    const auto v = std::find_if(q.begin(), q.end(),
                                [this](int w) { return w < complex_.number_of_interior_vertices; });
    if(std::any_of(q.begin(), q.end(), may_go_back) || v == q.end() || guilty_.number_of_pushes(*v) >= most_pushes)
    {
      guilty_.blame(q);
      return;
    }
    Vector inward = {{ 0, 0, 0 }};
    double edge = 0;
    for(int w : q)
      for(int n = 0; n < draft_.measured_boundary.number_of_umbrellas(w); ++n)
      {
        const Boundary_umbrella& umbrella = draft_.measured_boundary.umbrella(w, n);
        const double sign = umbrella.labels[0] == label ? -1 : umbrella.labels[1] == label ? 1 : 0;
        for(int i = 0; i < 3; ++i)
          inward[i] += sign * umbrella.normal[i];
        edge = (std::max)(edge, umbrella.shortest_edge);
      }
    const double length = std::sqrt(inward[0] * inward[0] + inward[1] * inward[1] + inward[2] * inward[2]);
    if(!(length > 0))
    {
      guilty_.blame(q);
      return;
    }
    // The more often, the farther.
    const double step = step_from_boundary * edge * (1 + guilty_.number_of_pushes(*v));
    for(double& x : inward)
      x *= step / length;
    guilty_.push(*v, inward);
  }

private:
  typedef std::array<double, 3> Vector;

  static constexpr double step_from_boundary = 0.05;          // over an edge on the boundary
  static constexpr int most_pushes = 5;

  const Complex& complex_;
  const Draft& draft_;
  Guilty_vertices& guilty_;
  std::set<Quadruple> excused_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_CELL_MENDING_3_H
