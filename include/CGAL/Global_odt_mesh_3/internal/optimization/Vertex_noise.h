// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_VERTEX_NOISE_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_VERTEX_NOISE_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>

#include <Eigen/Core>

#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Random displacements of the vertices, in the scale of their mean incident edges (section 4.3
// of the paper). Those of one vertex do not depend on whether and when others are asked for. The function is
// Odt_objective_3 or what offers the same.
class Vertex_noise
{
public:
  explicit Vertex_noise(unsigned int seed) : seeds_(seed) { draw(); }

  // To be called first and when the edges have got other lengths.
  template <class Function>
  void measure_edges(const Function& f) { f.mean_edge_lengths(edge_length_); }
  // The same with lengths that have been measured.
  void set_edges(std::vector<double> lengths) { edge_length_ = std::move(lengths); }
  double mean_edge_length(int v) const { return edge_length_[v]; }

  // To be called when all vertices are to get other displacements.
  void draw() { seed_ = seeds_(); }

  // In a random direction, its tangential part on surfaces, of a length uniform between zero and
  // the amplitude times the mean edge. Frozen vertices stay.
  template <class Function>
  Eigen::Vector3d displacement(const Function& f, int v, double interior_amplitude, double surface_amplitude) const
  {
    if(f.is_frozen(v))
      return Eigen::Vector3d::Zero();
    Random_numbers<Split_mix_engine> random(Split_mix_engine(seed_, v));
    const Eigen::Vector3d direction = random.direction();
    const double length = edge_length_[v] * random.uniform();
    const Eigen::Vector3d* normal = f.normal(v);
    if(normal == nullptr)
      return interior_amplitude * length * direction;
    return surface_amplitude * length * (direction - normal->dot(direction) * *normal);
  }

private:
  Split_mix_engine seeds_;
  std::uint64_t seed_ = 0;
  std::vector<double> edge_length_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_VERTEX_NOISE_H
