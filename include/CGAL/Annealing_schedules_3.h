// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_ANNEALING_SCHEDULES_3_H
#define CGAL_ANNEALING_SCHEDULES_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Requirements.h>

#include <CGAL/Global_odt_mesh_3/internal/Parameter_check.h>

#include <cmath>

namespace CGAL {

/*!
\ingroup PkgGlobalOdtMesh3Schedules

The class `Momentum_annealing_schedule` is the default type of the named parameter `annealing_schedule` of
`odt_optimize_mesh_3()`. The search makes steps along the gradient, with momentum, and with noise whose amplitude falls
to zero. Each step is taken, whatever the energy.

\sa `Metropolis_annealing_schedule`
*/
struct Momentum_annealing_schedule
{
  /// the fraction of a step that is added to the next one; in [0, 1)
  double momentum = 0.75;
  /// the length of steps, relative to that of the move to the volume-weighted mean of the circumcenters
  /// (equation (2.3) of \cgalCite{cgal:cwlls-rodt-14}); positive and finite
  double step_length = 1.4;
  /// the length of the noise of interior vertices at the beginning, relative to their mean incident edge; in [0, 1]
  double interior_amplitude = 0.14;
  /// the same for vertices on surfaces
  double surface_amplitude = 0.1;
  /// the exponent of the decay: the amplitude is proportional to the fraction of steps that are left, raised to this power;
  /// positive and finite
  double decay = 0.6;
  /// the longest step of a vertex, relative to its mean incident edge; positive and finite
  double longest_step = 0.3;

  /// checks the values of all members. A value out of range violates a precondition that names it.
  void check() const
  {
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(momentum >= 0 && momentum < 1, "annealing_schedule: momentum must be in [0, 1)");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(step_length > 0 && std::isfinite(step_length),
                                           "annealing_schedule: step_length must be positive and finite");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(interior_amplitude >= 0 && interior_amplitude <= 1,
                                           "annealing_schedule: interior_amplitude must be in [0, 1]");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(surface_amplitude >= 0 && surface_amplitude <= 1,
                                           "annealing_schedule: surface_amplitude must be in [0, 1]");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(decay > 0 && std::isfinite(decay),
                                           "annealing_schedule: decay must be positive and finite");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(longest_step > 0 && std::isfinite(longest_step),
                                           "annealing_schedule: longest_step must be positive and finite");
  }
};

/*!
\ingroup PkgGlobalOdtMesh3Schedules

The class `Metropolis_annealing_schedule` is a type of the named parameter `annealing_schedule` of `odt_optimize_mesh_3()`.
It selects Algorithm 2 of \cgalCite{cgal:cwlls-rodt-14} (section 4.3). In each round, all vertices are perturbed in
random directions and move to a minimum nearby. The new state is accepted if its energy is lower, or, with the probability of
Metropolis, if it is a little higher.

\sa `Momentum_annealing_schedule`
*/
struct Metropolis_annealing_schedule
{
  /// the longest perturbation of a vertex, relative to its mean incident edge; in [0, 1]
  double perturbation = 0.2;
  /// the L-BFGS iterations of a round; positive
  int iterations_in_round = 20;
  /// the temperature at the beginning, relative to the energy, so that the scale of the mesh does not matter; positive
  /// and finite
  double temperature = 1e-4;
  /// the factor on the temperature at each rejection; in (0, 1]
  double cooling = 0.9;
  /// the L-BFGS iterations after the last round; not negative
  int final_iterations = 30;

  /// checks the values of all members. A value out of range violates a precondition that names it.
  void check() const
  {
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(perturbation >= 0 && perturbation <= 1,
                                           "annealing_schedule: perturbation must be in [0, 1]");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(iterations_in_round > 0, "annealing_schedule: iterations_in_round must be positive");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(temperature > 0 && std::isfinite(temperature),
                                           "annealing_schedule: temperature must be positive and finite");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(cooling > 0 && cooling <= 1, "annealing_schedule: cooling must be in (0, 1]");
    CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(final_iterations >= 0, "annealing_schedule: final_iterations must not be negative");
  }
};

} // namespace CGAL

#endif // CGAL_ANNEALING_SCHEDULES_3_H
