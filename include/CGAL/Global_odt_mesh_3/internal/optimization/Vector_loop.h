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

#include <Eigen/Core>

namespace CGAL::Global_odt_mesh_3::internal {

// A loop over the entries of long vectors, on threads. Sums do not depend on the number of threads.
class Vector_loop
{
public:
  Vector_loop(const Thread_policy& threads, Eigen::Index size)
    : threads_(threads)
    , chunks_(static_cast<int>(size), least_length, most_chunks)
  {}

  // Calls f(begin, length) for all chunks.
  template <class F>
  void run(const F& f) const
  {
    threads_.for_each_chunk(chunks_.number(), [&](int n) { f(begin(n), begin(n + 1) - begin(n)); });
  }

  double dot(const Eigen::VectorXd& x, const Eigen::VectorXd& y) const
  {
    Eigen::VectorXd sums(chunks_.number());
    threads_.for_each_chunk(chunks_.number(), [&](int n)
    {
      sums[n] = x.segment(begin(n), begin(n + 1) - begin(n)).dot(y.segment(begin(n), begin(n + 1) - begin(n)));
    });
    return sums.sum();
  }

private:
  static constexpr int least_length = 16384, most_chunks = 16;

  Eigen::Index begin(int chunk) const { return chunks_.begin(chunk); }

  Thread_policy threads_;
  Chunks chunks_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_VECTOR_LOOP_H
