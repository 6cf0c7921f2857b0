// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_METHODS_AVERAGING_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_METHODS_AVERAGING_H

#include "averaging_iteration.h"
#include "methods/Method.h"

#include <string>

// Every vertex goes to the volume-weighted mean of the circumcenters around it (AVV, (2.3) of the paper) or, with the energy
// of the centroidal Voronoi tessellation, to the centroid of its Voronoi cell, which is Lloyd's method.
class Averaging
  : public Method
{
public:
  explicit Averaging(Energy e) : Method(e) {}

  std::string name() const override { return energy_choice() == Energy::ODT ? "AVV" : "Lloyd"; }

private:
  bool step() override { return iteration_.iterate(objective()); }

  CGAL::Global_odt_mesh_3::internal::Averaging_iteration iteration_;
};

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_METHODS_AVERAGING_H
