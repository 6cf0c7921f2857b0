// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_ANNEALING_SCHEDULE_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_ANNEALING_SCHEDULE_H

#include <CGAL/Annealing_schedules_3.h>

#include <variant>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Which way the global search goes, with its constants.
typedef std::variant<Momentum_annealing_schedule, Metropolis_annealing_schedule> Annealing_schedule;


} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_ANNEALING_SCHEDULE_H
