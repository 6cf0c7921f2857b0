// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_PROCESS_OF_ITS_OWN_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_PROCESS_OF_ITS_OWN_H

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <type_traits>

// What f() gives in a child process, so that the time of a call does not depend on the memory that earlier calls have used
// and freed; or T() if that process fails.
template <class T, class F>
T in_process_of_its_own(const F& f)
{
  static_assert(std::is_trivially_copyable<T>::value, "the result goes through a pipe");
  T result = T();
  int ends[2];
  if(pipe(ends) != 0)
    return result;
  std::fflush(stdout);
  const pid_t child = fork();
  if(child == 0)
  {
    result = f();
    std::fflush(stdout);
    _exit(write(ends[1], &result, sizeof result) == sizeof result ? EXIT_SUCCESS : EXIT_FAILURE);
  }
  close(ends[1]);
  if(child < 0 || read(ends[0], &result, sizeof result) != sizeof result)
    result = T();
  close(ends[0]);
  if(child > 0)
    waitpid(child, nullptr, 0);
  return result;
}

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_PROCESS_OF_ITS_OWN_H
