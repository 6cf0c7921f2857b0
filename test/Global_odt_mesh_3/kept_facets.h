// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_TEST_KEPT_FACETS_H
#define GLOBAL_ODT_MESH_3_TEST_KEPT_FACETS_H

#include "check.h"

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/exceptions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Facets of a complex before and after a call.
namespace kept_facets {

// A facet with its vertices, their positions, the patch, and the subdomains on its sides, as it is before the call.
template <class C3t3>
class Facet_record
{
  typedef typename C3t3::Vertex_handle Vertex_handle;
  typedef typename C3t3::Cell_handle Cell_handle;
  typedef typename C3t3::Facet Facet;

public:
  Facet_record(const C3t3& c3t3, const Facet& f)
    : patch_(c3t3.surface_patch_index(f))
    , subdomains_(subdomains(c3t3, f))
  {
    for(int k = 0; k < 3; ++k)
    {
      vertices_[k] = f.first->vertex((f.second + k + 1) % 4);
      points_[k] = vertices_[k]->point().point();
    }
  }

  bool is_there(const C3t3& c3t3) const
  {
    const auto& tr = c3t3.triangulation();
    for(int k = 0; k < 3; ++k)
      if(!tr.tds().is_vertex(vertices_[k]) || vertices_[k]->point().point() != points_[k])
        return false;
    Cell_handle c;
    int i, j, k;
    if(!tr.is_facet(vertices_[0], vertices_[1], vertices_[2], c, i, j, k))
      return false;
    const Facet f(c, 6 - i - j - k);
    return c3t3.is_in_complex(f) && c3t3.surface_patch_index(f) == patch_
           && c3t3.surface_patch_index(tr.mirror_facet(f)) == patch_ && subdomains(c3t3, f) == subdomains_;
  }

  friend bool operator==(const Facet_record& a, const Facet_record& b)
  {
    return std::is_permutation(a.vertices_.begin(), a.vertices_.end(), b.vertices_.begin()) && a.patch_ == b.patch_
           && a.subdomains_ == b.subdomains_;
  }

private:
  typedef typename C3t3::Subdomain_index Subdomain_index;

  static std::pair<Subdomain_index, Subdomain_index> subdomains(const C3t3& c3t3, const Facet& f)
  { return std::minmax({ c3t3.subdomain_index(f.first), c3t3.subdomain_index(f.first->neighbor(f.second)) }); }

  typename C3t3::Surface_patch_index patch_;
  std::pair<Subdomain_index, Subdomain_index> subdomains_;
  std::array<Vertex_handle, 3> vertices_;
  std::array<typename C3t3::Triangulation::Bare_point, 3> points_;
};

template <class C3t3>
using Records = std::vector<Facet_record<C3t3> >;

// Of all facets of the complex.
template <class C3t3>
Records<C3t3> all(const C3t3& c3t3)
{
  Records<C3t3> result;
  for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
    result.emplace_back(c3t3, *f);
  return result;
}

// Some facets of the complex, each with the same probability, and seen from either side.
template <class C3t3>
std::set<typename C3t3::Facet> some(const C3t3& c3t3, double share, unsigned int seed)
{
  std::mt19937 random(seed);
  std::set<typename C3t3::Facet> result;
  for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
    if(std::uniform_real_distribution<double>(0, 1)(random) < share)
      result.insert(random() % 2 == 0 ? typename C3t3::Facet(*f) : c3t3.triangulation().mirror_facet(*f));
  return result;
}

template <class C3t3>
Records<C3t3> records(const C3t3& c3t3, const std::set<typename C3t3::Facet>& facets)
{
  Records<C3t3> result;
  for(const auto& f : facets)
    result.emplace_back(c3t3, f);
  return result;
}

template <class C3t3>
void check_there(const std::string& name, const C3t3& c3t3, const Records<C3t3>& before)
{
  const auto gone = std::count_if(before.begin(), before.end(), [&](const auto& f) { return !f.is_there(c3t3); });
  check::that(gone == 0, name, ": ", gone, " of ", before.size(), " facets that were to stay have changed");
}

// The largest distance of the centroid of a facet from the surface.
template <class C3t3, class Domain>
double farthest_centroid(const C3t3& c3t3, const Domain& domain)
{
  check::Largest distance;
  for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
  {
    const auto p = [&f](int k) { return f->first->vertex((f->second + k) % 4)->point().point(); };
    distance.add(std::sqrt(CGAL::to_double(domain.aabb_tree().squared_distance(CGAL::centroid(p(1), p(2), p(3))))));
  }
  return distance;
}

// Whether the triangulation is regular, of which an assertion may tell.
template <class Triangulation>
bool is_regular(const Triangulation& tr)
{
  try { return tr.is_valid(); }
  catch(const CGAL::Assertion_exception&) { return false; }
}

} // namespace kept_facets

#endif // GLOBAL_ODT_MESH_3_TEST_KEPT_FACETS_H
