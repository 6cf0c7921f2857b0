// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_MEASURED_CALL_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_MEASURED_CALL_H

#include "cpu_seconds.h"
#include "process_of_its_own.h"

#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Random.h>
#include <CGAL/Real_timer.h>

#include <stdexcept>

// What tables say of a mesh, and the time it took.
struct Measured_mesh
{
  double vertices = 0, radius_ratio = 0, smallest_angle = 0, below_20 = 0, below_30 = 0, facet_angle = 0, mean_facet_angle = 0;
  double cpu = 0, wall = 0;
};

template <class C3t3>
Measured_mesh measured(const C3t3& c3t3)
{
  const CGAL::Mesh_quality_report_3 r = CGAL::mesh_quality_report_3(c3t3, { 20, 30 });
  Measured_mesh m;
  m.vertices = double(r.number_of_vertices);
  m.radius_ratio = r.mean_radius_ratio;
  m.smallest_angle = r.smallest_angle;
  m.below_20 = double(r.cells_below[0].second);
  m.below_30 = double(r.cells_below[1].second);
  m.facet_angle = r.smallest_facet_angle;
  m.mean_facet_angle = r.mean_facet_angle;
  return m;
}

// What `optimize(c3t3)` makes of the mesh in a process of its own, so that it is as before in this one.
template <class C3t3, class Optimize>
Measured_mesh measured_call_on(C3t3& c3t3, const Optimize& optimize)
{
  const Measured_mesh m = in_process_of_its_own<Measured_mesh>([&]
  {
    CGAL::get_default_random() = CGAL::Random(0);
    CGAL::Real_timer timer;
    timer.start();
    const double cpu = seconds([&] { optimize(c3t3); });
    timer.stop();
    Measured_mesh result = measured(c3t3);
    result.cpu = cpu;
    result.wall = timer.time();
    return result;
  });
  if(m.vertices == 0)
    throw std::runtime_error("a call has failed");
  return m;
}

// The same of a copy.
template <class C3t3, class Optimize>
Measured_mesh measured_call(const C3t3& input, const Optimize& optimize)
{
  C3t3 c3t3(input);
  return measured_call_on(c3t3, optimize);
}

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_MEASURED_CALL_H
