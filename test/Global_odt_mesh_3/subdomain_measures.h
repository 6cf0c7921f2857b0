// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_TEST_SUBDOMAIN_MEASURES_H
#define GLOBAL_ODT_MESH_3_TEST_SUBDOMAIN_MEASURES_H

#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

// What the optimizer may change a little, of each subdomain.
template <class C3t3>
using Subdomain_measures = std::map<typename C3t3::Subdomain_index, double>;

template <class C3t3>
Subdomain_measures<C3t3> volumes(const C3t3& c3t3)
{
  Subdomain_measures<C3t3> volumes;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    volumes[c3t3.subdomain_index(c)] += c3t3.triangulation().tetrahedron(c).volume();
  return volumes;
}

template <class C3t3>
Subdomain_measures<C3t3> median_edges(const C3t3& c3t3)
{
  typedef typename C3t3::Vertex_handle Vertex_handle;
  std::map<typename C3t3::Subdomain_index, std::set<std::pair<Vertex_handle, Vertex_handle> > > edges;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    for(int i = 0; i < 4; ++i)
      for(int j = 0; j < i; ++j)
        edges[c3t3.subdomain_index(c)].insert(std::minmax({ c->vertex(i), c->vertex(j) }));
  Subdomain_measures<C3t3> medians;
  for(const auto& e : edges)
  {
    std::vector<double> lengths;
    for(const auto& edge : e.second)
      lengths.push_back(std::sqrt(CGAL::squared_distance(edge.first->point().point(), edge.second->point().point())));
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    medians[e.first] = *middle;
  }
  return medians;
}

// Of the cells.
template <class C3t3>
Subdomain_measures<C3t3> largest_circumradii(const C3t3& c3t3)
{
  Subdomain_measures<C3t3> radii;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
  {
    const auto p = [&](int i) { return c->vertex(i)->point().point(); };
    double& largest = radii[c3t3.subdomain_index(c)];
    largest = (std::max)(largest, std::sqrt(CGAL::squared_radius(p(0), p(1), p(2), p(3))));
  }
  return radii;
}

#endif // GLOBAL_ODT_MESH_3_TEST_SUBDOMAIN_MEASURES_H
