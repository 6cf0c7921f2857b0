// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_METHODS_QUASI_NEWTON_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_METHODS_QUASI_NEWTON_H

#include "methods/Method.h"

#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>

#include <string>

// Algorithm 1 of the paper, from the given vertices on: L-BFGS until the gradient is that small.
class Quasi_newton
  : public Method
{
public:
  explicit Quasi_newton(Energy e, double smallest_gradient = 1e-9) : Method(e), smallest_gradient_(smallest_gradient) {}

  std::string name() const override { return "local " + name_of(energy_choice()); }

private:
  typedef CGAL::Global_odt_mesh_3::internal::Limited_memory_bfgs Minimizer;

  void start(unsigned int) override { minimizer_.reset(); }

  bool step() override
  {
    return gradient() > smallest_gradient_ && minimizer_.iterate(objective()) == Minimizer::STEP_TAKEN;
  }

  double smallest_gradient_;
  Minimizer minimizer_;
};

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_METHODS_QUASI_NEWTON_H
