// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_CPU_SECONDS_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_CPU_SECONDS_H

#include <CGAL/Timer.h>

#include <functional>

// The process CPU time of a call.
inline double seconds(const std::function<void()>& f)
{
  CGAL::Timer timer;
  timer.start();
  f();
  timer.stop();
  return timer.time();
}

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_CPU_SECONDS_H
