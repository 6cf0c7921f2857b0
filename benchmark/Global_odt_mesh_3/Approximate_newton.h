// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_APPROXIMATE_NEWTON_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_APPROXIMATE_NEWTON_H

#include <CGAL/Global_odt_mesh_3/internal/density/Field_density_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Point_rule_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <memory>
#include <vector>

// The density at the centroid stands for that of the cell.
inline std::unique_ptr<CGAL::Global_odt_mesh_3::internal::Density_quadrature_3>
one_point_quadrature(CGAL::Global_odt_mesh_3::internal::Density_3& density)
{
  using namespace CGAL::Global_odt_mesh_3::internal;
  return std::make_unique<Point_rule_quadrature_3>(
    [&density](int v, const Site& s) { return density.in_cell(v, s); },
    Point_rule_quadrature_3::Rule{ 1, { { 1, {{ 0.25, 0.25, 0.25, 0.25 }} } } });
}

// The iteration of Chen and Holst (Efficient mesh optimization schemes based on optimal Delaunay triangulations,
// CMAME 200, 2011): x - A^-1 g, g being the gradient by the quadrature of one point and A the graph Laplacian with the
// weight rho |t| / 6 of each cell t on its edges, whose diagonal is that of AVV.
class Approximate_newton
{
public:
  typedef CGAL::Global_odt_mesh_3::internal::Moving_triangulation_3 Mesh;
  typedef CGAL::Global_odt_mesh_3::internal::Odt_objective_3 Objective;

  explicit Approximate_newton(double step_length) : step_length_(step_length) {}

  // False if even the shortest step breaks the triangulation.
  bool iterate(const Mesh& mesh, Objective& f)
  {
    const int n = f.number_of_vertices();
    assemble(mesh, n);
    // Faster than a factorization, which flips would make worthless in each iteration.
    Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver(laplacian_);
    solver.setTolerance(1e-4);
    const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> > g(f.gradient().data(), n, 3);
    const Eigen::Matrix<double, Eigen::Dynamic, 3> solution = solver.solve(g);
    const Eigen::VectorXd x = f.point();
    Eigen::VectorXd step(3 * n);
    for(int v = 0; v < n; ++v)
      step.segment<3>(3 * v) = -step_length_ * solution.row(v).transpose();
    for(int halvings = 0; halvings < 20; ++halvings)
    {
      if(f.evaluate(x + step))
      {
        f.accept();
        return true;
      }
      f.reject();
      step /= 2;
    }
    return false;
  }

private:
  void assemble(const Mesh& mesh, int n)
  {
    using namespace CGAL::Global_odt_mesh_3::internal;
    entries_.clear();
    for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
    {
      if(!mesh.topology.is_alive(c))
        continue;
      const int* const v = mesh.topology.vertices(c);
      const Density_moments_3 moments = mesh.quadrature()->moments(c, v, mesh.sites.data());
      const double rho = moments.first[0] + moments.first[1] + moments.first[2] + moments.first[3];
      const double weight = rho * mesh.products(c).determinant / 36;
      for(int i = 0; i < 4; ++i)
        for(int j = 0; j < 4; ++j)
          if(v[i] < n && (i == j || v[j] < n))
            entries_.emplace_back(v[i], v[j], i == j ? 3 * weight : -weight);
    }
    laplacian_.resize(n, n);
    laplacian_.setFromTriplets(entries_.begin(), entries_.end());
  }

  double step_length_;
  std::vector<Eigen::Triplet<double> > entries_;
  Eigen::SparseMatrix<double> laplacian_;
};

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_APPROXIMATE_NEWTON_H
