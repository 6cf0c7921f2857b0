// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_PLANAR_ENERGIES_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_PLANAR_ENERGIES_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Surface_cvt_objective_3.h>

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

// The three energies of Figure 3 of the paper, of the Delaunay triangulation of points in the plane, for a density that is linear
// everywhere, so that all integrals are exact.
struct Planar_energies
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef Kernel::Point_2 Point;

  double cvt = 0;
  double discrete = 0;        // (2.4), in which the density weighs the distances to the vertices
  double continuous = 0;      // (2.5)
  std::set<std::pair<Point, Point> > edges;   // between fixed vertices, which tell triangulations apart

  // The last point is the one that moves.
  template <class Density>
  Planar_energies(const std::vector<Point>& points, const Density& density)
  {
    using namespace CGAL::Global_odt_mesh_3::internal;
    const CGAL::Delaunay_triangulation_2<Kernel> tr(points.begin(), points.end());
    for(auto f = tr.finite_faces_begin(); f != tr.finite_faces_end(); ++f)
    {
      std::array<Point, 3> p;
      std::vector<Site> sites;
      std::array<double, 3> rho;
      for(int i = 0; i < 3; ++i)
      {
        p[i] = f->vertex(i)->point();
        sites.push_back({ p[i].x(), p[i].y(), 0, 0 });
        rho[i] = density(p[i]);
        const Point &a = p[i], &b = f->vertex((i + 1) % 3)->point();
        if(a != points.back() && b != points.back())
          edges.insert((std::minmax)(a, b));
      }
      cvt += Surface_cvt_contribution_3({{ 0, 1, 2 }}, sites, rho).energy;
      add_odt(p, rho, std::abs(CGAL::area(p[0], p[1], p[2])));
    }
  }

private:
  void add_odt(const std::array<Point, 3>& p, const std::array<double, 3>& rho, double area)
  {
    const double sum = rho[0] + rho[1] + rho[2];
    for(int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      continuous += area / 60 * CGAL::squared_distance(p[i], p[j]) * (sum + rho[i] + rho[j]);
      // The integral of the density times |x - x_i|^2, by moments of barycentric coordinates.
      const double jj = CGAL::squared_distance(p[i], p[j]), kk = CGAL::squared_distance(p[i], p[k]);
      const double jk = (p[j] - p[i]) * (p[k] - p[i]);
      discrete += area / 30 / 5 * (jj * (sum + 2 * rho[j]) + kk * (sum + 2 * rho[k]) + jk * (sum + rho[j] + rho[k]));
    }
  }
};

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_PLANAR_ENERGIES_H
