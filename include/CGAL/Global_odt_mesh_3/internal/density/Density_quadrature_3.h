// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_DENSITY_QUADRATURE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_DENSITY_QUADRATURE_3_H

#include <CGAL/Global_odt_mesh_3/internal/density/Density_moments_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <functional>
#include <memory>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// A way to integrate the density over cells.
class Density_quadrature_3
{
public:
  // The density at a point of a cell around a vertex, given the number of that vertex.
  typedef std::function<double(int, const Site&)> Density;

  virtual ~Density_quadrature_3() {}

  // The moments on a cell, given the numbers of its vertices, into `sites`. The number of the
  // cell is for what is kept of it.
  virtual Density_moments_3 moments(int cell, const int* vertices, const Site* sites) = 0;

  // To be called when vertices have moved, up to that number; those beyond stay for ever.
  virtual void update(const std::vector<Site>&, int /* number_of_movable_vertices */, const Thread_policy&) {}

  // The same for a part of the mesh with some of its vertices, given by their numbers, which stay where they are. While the
  // values are those of the last update, parts may be made, and used, by several threads if the density permits.
  virtual std::unique_ptr<Density_quadrature_3> part(const std::vector<int>& vertices) const = 0;

  // Remembers what update() will change, or goes back to it.
  virtual void keep() {}
  virtual void restore() {}

  // By how much, relatively, the energy may rise in a step of the minimizer: little more than rounding feigns, unless the
  // gradient is not its derivative.
  virtual double energy_tolerance() const { return 1e-9; }

protected:
  static Density renumbered(const Density& density, const std::vector<int>& vertices)
  {
    return [density, &vertices](int v, const Site& s) { return density(vertices[v], s); };
  }

  // For moments of which the energy is not what (4.6) is the derivative of, so that it cannot be asked to fall.
  static constexpr double tolerance_of_rough_moments = 1e-3;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DENSITY_DENSITY_QUADRATURE_3_H
