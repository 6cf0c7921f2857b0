// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_EXAMPLES_TERMINAL_PROGRESS_H
#define GLOBAL_ODT_MESH_3_EXAMPLES_TERMINAL_PROGRESS_H

#include <cstdio>
#ifdef _WIN32
#  include <io.h>
#else
#  include <unistd.h>
#endif

// A callback that shows the fraction done on standard error if that is a terminal, and never stops the optimizer.
struct Terminal_progress
{
  bool operator()(double fraction)
  {
    const int percent = static_cast<int>(100 * fraction);
    if(is_terminal && percent != shown)
      std::fprintf(stderr, fraction < 1 ? "\roptimizing %3d %%" : "\r                 \r", percent);
    shown = percent;
    return true;
  }

#ifdef _WIN32
  bool is_terminal = _isatty(_fileno(stderr)) != 0;
#else
  bool is_terminal = isatty(fileno(stderr)) != 0;
#endif
  int shown = -1;
};

#endif // GLOBAL_ODT_MESH_3_EXAMPLES_TERMINAL_PROGRESS_H
