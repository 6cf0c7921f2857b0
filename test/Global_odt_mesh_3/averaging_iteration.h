// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_TEST_AVERAGING_ITERATION_H
#define GLOBAL_ODT_MESH_3_TEST_AVERAGING_ITERATION_H

#include <Eigen/Core>

namespace CGAL::Global_odt_mesh_3::internal {

// The AVV iteration (2.3) of the paper: every vertex goes to the average of the circumcenters
// of its cells, weighted by their volumes, which is the step -g/D.
class Averaging_iteration
{
public:
  // False if even the shortest step breaks the triangulation; it is then where it was. The
  // function is that of Limited_memory_bfgs.
  template <class Function>
  bool iterate(Function& f)
  {
    x_ = f.point();
    step_ = -(f.gradient().array() / f.diagonal().array()).matrix();
    for(int n = 0; n < max_halvings; ++n)
    {
      trial_ = x_ + step_;
      if(f.evaluate(trial_))
      {
        f.accept();
        return true;
      }
      f.reject();
      step_ /= 2;
    }
    return false;
  }

private:
  static constexpr int max_halvings = 20;

  Eigen::VectorXd x_, step_, trial_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // GLOBAL_ODT_MESH_3_TEST_AVERAGING_ITERATION_H
