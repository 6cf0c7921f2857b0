// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_TEST_FUNCTION_DENSITY_3_H
#define GLOBAL_ODT_MESH_3_TEST_FUNCTION_DENSITY_3_H

#include <CGAL/Global_odt_mesh_3/internal/density/Field_density_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <functional>
#include <utility>

// A density that is a function of the place alone.
class Function_density_3
  : public CGAL::Global_odt_mesh_3::internal::Density_3
{
public:
  typedef CGAL::Global_odt_mesh_3::internal::Site Site;

  explicit Function_density_3(std::function<double(const Site&)> function) : function_(std::move(function)) {}

  bool is_uniform() const override { return false; }
  double in_volume(int, const Site& s) override { return function_(s); }
  double on_surface(int, const Site& s) override { return function_(s); }

private:
  std::function<double(const Site&)> function_;
};

#endif // GLOBAL_ODT_MESH_3_TEST_FUNCTION_DENSITY_3_H
