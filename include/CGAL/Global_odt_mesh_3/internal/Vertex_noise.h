// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_VERTEX_NOISE_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_VERTEX_NOISE_H

#include <CGAL/Global_odt_mesh_3/internal/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Random_source.h>

#include <Eigen/Core>

#include <array>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Random displacements of the vertices, in the scale of their mean incident edges (section 4.3
// of the paper).
class Vertex_noise
{
public:
  explicit Vertex_noise(unsigned int seed) : random_(seed) {}

  // To be called before draw() and when the edges have got other lengths.
  void measure_edges(const Odt_objective_3& f) { f.mean_edge_lengths(edge_length_); }
  double mean_edge_length(int v) const { return edge_length_[v]; }

  // Random directions, their tangential part on surfaces, of a length uniform between zero and
  // the amplitude times the mean edge. Frozen vertices get none.
  const Eigen::VectorXd& draw(const Odt_objective_3& f, double interior_amplitude, double surface_amplitude)
  {
    noise_.setZero(f.point().size());
    for(int v = 0; v < f.number_of_vertices(); ++v)
    {
      if(f.is_frozen(v))
        continue;
      Eigen::Vector3d direction = random_.direction();
      double amplitude = interior_amplitude;
      if(const std::array<double, 3>* normal = f.normal(v))
      {
        const Eigen::Map<const Eigen::Vector3d> n(normal->data());
        direction -= n.dot(direction) * n;
        amplitude = surface_amplitude;
      }
      noise_.segment<3>(3 * v) = amplitude * edge_length_[v] * random_.uniform() * direction;
    }
    return noise_;
  }

  // The source of the noise, for whatever else is left to chance.
  Random_source& random() { return random_; }

private:
  Random_source random_;
  std::vector<double> edge_length_;
  Eigen::VectorXd noise_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_VERTEX_NOISE_H
