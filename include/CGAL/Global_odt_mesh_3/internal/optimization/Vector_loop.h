// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_VECTOR_LOOP_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_VECTOR_LOOP_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <Eigen/Core>

#include <algorithm>

namespace CGAL::Global_odt_mesh_3::internal {

// A loop over the entries of long vectors, on threads, in blocks short enough that those of several vectors stay in the
// fastest cache. Sums do not depend on the number of threads.
class Vector_loop
{
public:
  Vector_loop(const Thread_policy& threads, Eigen::Index size)
    : threads_(threads)
    , chunks_(static_cast<int>(size), least_length, most_chunks)
  {}

  // Calls f(begin, length) for all blocks.
  template <class F>
  void run(const F& f) const
  {
    threads_.for_each_chunk(chunks_.number(), [&](int n) { run_chunk(n, f); });
  }

  // Calls f(begin, length, sums) for all blocks, which adds to its sums; gives those of all.
  template <class F>
  Eigen::VectorXd sums(int number, const F& f) const
  {
    Eigen::MatrixXd parts = Eigen::MatrixXd::Zero(number, chunks_.number());
    threads_.for_each_chunk(chunks_.number(), [&](int n)
    {
      Eigen::VectorXd part = Eigen::VectorXd::Zero(number);
      run_chunk(n, [&](Eigen::Index begin, Eigen::Index length) { f(begin, length, part); });
      parts.col(n) = part;
    });
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(number);
    for(int n = 0; n < chunks_.number(); ++n)
      sum += parts.col(n);
    return sum;
  }

private:
  static constexpr int length_of_block = 256, least_length = 16384, most_chunks = 16;

  template <class F>
  void run_chunk(int n, const F& f) const
  {
    for(int begin = chunks_.begin(n); begin < chunks_.end(n); begin += length_of_block)
      f(Eigen::Index(begin), Eigen::Index((std::min)(length_of_block, chunks_.end(n) - begin)));
  }

  Thread_policy threads_;
  Chunks chunks_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_VECTOR_LOOP_H
