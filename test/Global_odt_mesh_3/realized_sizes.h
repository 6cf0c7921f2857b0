// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_TEST_REALIZED_SIZES_H
#define GLOBAL_ODT_MESH_3_TEST_REALIZED_SIZES_H

#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

// How the mean lengths of the edges around vertices compare with the sizes wanted there.
struct Realized_sizes
{
  double deviation = 0;     // the standard deviation of log(length / size)
  double slope = 0;         // of log(length) over log(size): one if the ratios of sizes are as wanted
  double ratio = 1;         // of the largest mean length to the smallest

  // For vertices of this dimension or more.
  template <class C3t3, class Field>
  Realized_sizes(const C3t3& c3t3, const Field& field, int least_dimension = 0)
  {
    typedef typename C3t3::Vertex_handle Vertex_handle;
    std::map<Vertex_handle, std::map<Vertex_handle, double> > edges;
    for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
      for(int i = 0; i < 4; ++i)
        for(int j = 0; j < 4; ++j)
          if(i != j)
            edges[c->vertex(i)][c->vertex(j)]
              = std::sqrt(CGAL::squared_distance(c->vertex(i)->point().point(), c->vertex(j)->point().point()));
    double n = 0, x = 0, y = 0, xx = 0, xy = 0, d = 0, dd = 0;
    double smallest = (std::numeric_limits<double>::max)(), largest = 0;
    for(const auto& e : edges)
    {
      if(e.first->in_dimension() < least_dimension)
        continue;
      double length = 0;
      for(const auto& neighbor : e.second)
        length += neighbor.second / double(e.second.size());
      const double lx = std::log(field(e.first->point().point(), e.first->in_dimension(), e.first->index()));
      const double ly = std::log(length);
      smallest = (std::min)(smallest, length);
      largest = (std::max)(largest, length);
      ++n;
      x += lx;
      y += ly;
      xx += lx * lx;
      xy += lx * ly;
      d += ly - lx;
      dd += (ly - lx) * (ly - lx);
    }
    slope = (n * xy - x * y) / (n * xx - x * x);
    deviation = std::sqrt(dd / n - d / n * d / n);
    ratio = largest / smallest;
  }
};

#endif // GLOBAL_ODT_MESH_3_TEST_REALIZED_SIZES_H
