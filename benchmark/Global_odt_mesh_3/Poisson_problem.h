// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_POISSON_PROBLEM_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_POISSON_PROBLEM_H

#include "Tetrahedral_mesh.h"

#include <Eigen/Core>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/LU>
#include <Eigen/SparseCore>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

// - laplacian(u) = f in the cube, with the values of a known solution on the boundary.
struct Poisson_problem
{
  std::string name;
  std::function<double(const Eigen::Vector3d&)> solution;
  std::function<Eigen::Vector3d(const Eigen::Vector3d&)> gradient;
  std::function<double(const Eigen::Vector3d&)> right_hand_side;
};

// What the linear finite elements make of it.
struct Finite_element_errors
{
  double l2 = 0, h1 = 0;      // norm of the error and of its gradient
  int iterations = 0;         // of the conjugate gradient method
};

// Points in barycentric coordinates, and their weights, which add up to 1: the rule of Grundmann and Moeller of degree 7.
class Grundmann_moeller_rule
{
public:
  typedef std::pair<Eigen::Vector4d, double> Node;

  Grundmann_moeller_rule()
  {
    const int s = 3, degree = 2 * s + 1;
    for(int i = 0; i <= s; ++i)
    {
      const double denominator = degree + 3 - 2 * i;
      const double weight = 6 * (i % 2 == 0 ? 1 : -1) * std::pow(2., -2 * s) * std::pow(denominator, degree)
                          / (std::tgamma(i + 1.) * std::tgamma(degree + 3 - i + 1.));
      for(int a = 0; a <= s - i; ++a)
        for(int b = 0; a + b <= s - i; ++b)
          for(int c = 0; a + b + c <= s - i; ++c)
          {
            const int d = s - i - a - b - c;
            nodes_.emplace_back(Eigen::Vector4d(2 * a + 1, 2 * b + 1, 2 * c + 1, 2 * d + 1) / denominator, weight);
          }
    }
  }

  const std::vector<Node>& nodes() const { return nodes_; }

private:
  std::vector<Node> nodes_;
};

// One cell, and the gradients of its four basis functions.
struct Finite_element
{
  double volume;
  Eigen::Matrix<double, 3, 4> corners, gradients;

  Finite_element(const Tetrahedral_mesh& mesh, const std::array<int, 4>& c)
    : volume(mesh.determinant(c) / 6)
  {
    Eigen::Matrix4d m;
    for(int i = 0; i < 4; ++i)
    {
      corners.col(i) = mesh.points[c[i]];
      m.row(i) << 1, corners.col(i).transpose();
    }
    gradients = m.inverse().bottomRows<3>();
  }
};

inline Finite_element_errors solve(const Poisson_problem& problem, const Tetrahedral_mesh& mesh)
{
  const Grundmann_moeller_rule rule;
  const std::size_t n = mesh.points.size();
  std::vector<int> unknown(n, -1);
  int number_of_unknowns = 0;
  Eigen::VectorXd u(n);
  for(std::size_t v = 0; v < n; ++v)
    if(mesh.is_on_boundary(v))
      u[v] = problem.solution(mesh.points[v]);
    else
      unknown[v] = number_of_unknowns++;

  std::vector<Eigen::Triplet<double> > entries;
  Eigen::VectorXd b = Eigen::VectorXd::Zero(number_of_unknowns);
  for(const std::array<int, 4>& c : mesh.cells)
  {
    const Finite_element e(mesh, c);
    const Eigen::Matrix4d stiffness = e.volume * e.gradients.transpose() * e.gradients;
    for(const auto& node : rule.nodes())
    {
      const double f = e.volume * node.second * problem.right_hand_side(e.corners * node.first);
      for(int i = 0; i < 4; ++i)
        if(unknown[c[i]] >= 0)
          b[unknown[c[i]]] += f * node.first[i];
    }
    for(int i = 0; i < 4; ++i)
      for(int j = 0; j < 4 && unknown[c[i]] >= 0; ++j)
        if(unknown[c[j]] >= 0)
          entries.emplace_back(unknown[c[i]], unknown[c[j]], stiffness(i, j));
        else
          b[unknown[c[i]]] -= stiffness(i, j) * u[c[j]];
  }
  Eigen::SparseMatrix<double> a(number_of_unknowns, number_of_unknowns);
  a.setFromTriplets(entries.begin(), entries.end());
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower | Eigen::Upper> solver(a);
  solver.setTolerance(1e-10);
  const Eigen::VectorXd x = solver.solve(b);
  for(std::size_t v = 0; v < n; ++v)
    if(unknown[v] >= 0)
      u[v] = x[unknown[v]];

  Finite_element_errors errors;
  for(const std::array<int, 4>& c : mesh.cells)
  {
    const Finite_element e(mesh, c);
    const Eigen::Vector4d values(u[c[0]], u[c[1]], u[c[2]], u[c[3]]);
    const Eigen::Vector3d slope = e.gradients * values;
    for(const auto& node : rule.nodes())
    {
      const Eigen::Vector3d p = e.corners * node.first;
      const double difference = problem.solution(p) - values.dot(node.first);
      errors.l2 += e.volume * node.second * difference * difference;
      errors.h1 += e.volume * node.second * (problem.gradient(p) - slope).squaredNorm();
    }
  }
  errors.l2 = std::sqrt(errors.l2);
  errors.h1 = std::sqrt(errors.h1);
  errors.iterations = static_cast<int>(solver.iterations());
  return errors;
}

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_POISSON_PROBLEM_H
