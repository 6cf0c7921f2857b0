// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_BOUNDARY_POLES_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_BOUNDARY_POLES_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kd_tree.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_with_weighted_circumcenter_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Robust_weighted_circumcenter_filtered_traits_3.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <set>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Boundary_sample;

template <class Point>
Boundary_sample boundary_sample(const Point& p)
{
  return Boundary_sample(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
}

// The vertices of the surface facets of a mesh, without weights, which are not of the surface.
template <class C3t3>
std::vector<Boundary_sample> samples_of_mesh(const C3t3& c3t3)
{
  std::set<typename C3t3::Vertex_handle> on_surface;
  for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
    for(int i = 0; i < 4; ++i)
      if(i != f->second)
        on_surface.insert(f->first->vertex(i));
  // Samples are in the order of the triangulation, since that of handles differs from run to run.
  std::vector<Boundary_sample> samples;
  samples.reserve(on_surface.size());
  for(auto v : c3t3.triangulation().finite_vertex_handles())
    if(on_surface.count(v) != 0)
      samples.push_back(boundary_sample(v->point()));
  return samples;
}

// A mesh of nothing but the surface.
template <class MeshDomain>
std::vector<Boundary_sample> samples_of_domain(const MeshDomain& domain, double spacing)
{
  typedef typename Mesh_triangulation_3<MeshDomain>::type Tr;
  typedef Mesh_complex_3_in_triangulation_3<Tr> C3t3;
  typedef Mesh_criteria_3<Tr> Criteria;
  const double facet_angle = 25;
  const Criteria criteria(typename Criteria::Facet_criteria(facet_angle, spacing, 0.),
                          typename Criteria::Cell_criteria(0., 0.));
  return samples_of_mesh(make_mesh_3<C3t3>(domain, criteria, parameters::no_exude(), parameters::no_perturb(),
                                           parameters::no_features()));
}

// A triangulation whose dual points are computed once each, and exactly in flat cells.
struct Power_diagram_3
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef Robust_weighted_circumcenter_filtered_traits_3<Kernel> Traits;
  typedef Triangulation_data_structure_3<Regular_triangulation_vertex_base_3<Traits>,
                                         Regular_triangulation_cell_base_with_weighted_circumcenter_3<Traits> > Tds;
  typedef Regular_triangulation_3<Traits, Tds> Triangulation;
};

// The poles of samples of a surface (Amenta and Bern): on either side of the surface, the farthest vertex of a
// sample's Voronoi cell. Unlike the other vertices, which may belong to slivers at the surface, they are
// close to the medial axis.
//
// A pole counts only if two of the samples nearest to it are as far from each other as from it, that is, if it sees them
// under 60 degrees. Others come from noise, or from the edges of triangles that approximate a smooth surface.
class Boundary_poles_3
{
public:
  typedef Power_diagram_3::Kernel Kernel;
  typedef Kernel::Point_3 Point_3;

  explicit Boundary_poles_3(const std::vector<Point_3>& samples)
  {
    const std::vector<Kernel::Weighted_point_3> weighted(samples.begin(), samples.end());
    const Triangulation tr(weighted.begin(), weighted.end());
    if(tr.dimension() < 3)
      return;
    std::vector<Cell_handle> star;
    for(Vertex_handle v : tr.finite_vertex_handles())
    {
      star.clear();
      tr.incident_cells(v, std::back_inserter(star));
      add_poles(tr, v, star);
    }
    std::sort(poles_.begin(), poles_.end());
    poles_.erase(std::unique(poles_.begin(), poles_.end()), poles_.end());
  }

  const std::vector<Point_3>& poles() const { return poles_; }

  // The distances from points to the nearest pole, infinite if there is none.
  std::vector<double> distances(const std::vector<Point_3>& points) const
  {
    std::vector<double> d(points.size(), std::numeric_limits<double>::infinity());
    if(poles_.empty())
      return d;
    Search::Tree tree(poles_.begin(), poles_.end());
    for(std::size_t n = 0; n < points.size(); ++n)
      d[n] = std::sqrt(Search(tree, points[n], 1).begin()->second);
    return d;
  }

private:
  typedef Power_diagram_3::Triangulation Triangulation;
  typedef Triangulation::Vertex_handle Vertex_handle;
  typedef Triangulation::Cell_handle Cell_handle;
  typedef Kernel::Vector_3 Vector_3;
  typedef Orthogonal_k_neighbor_search<Search_traits_3<Kernel> > Search;

  void add_poles(const Triangulation& tr, Vertex_handle v, const std::vector<Cell_handle>& star)
  {
    const Point_3& sample = v->point().point();
    // On the convex hull, the outer pole is at infinity.
    Vector_3 axis = outward_normal(tr, star);
    if(axis == NULL_VECTOR)
      axis = add_farthest(tr, sample, star, [](const Vector_3&) { return true; });
    add_farthest(tr, sample, star, [&axis](const Vector_3& x) { return x * axis < 0; });
  }

  // The sum of the normals of the convex hull's facets; the null vector inside.
  static Vector_3 outward_normal(const Triangulation& tr, const std::vector<Cell_handle>& star)
  {
    Vector_3 sum = NULL_VECTOR;
    for(Cell_handle c : star)
    {
      if(!tr.is_infinite(c))
        continue;
      const int i = c->index(tr.infinite_vertex());
      const auto corner = [&](int j) { return c->vertex(Triangulation::vertex_triple_index(i, j))->point().point(); };
      sum = sum + CGAL::normal(corner(0), corner(1), corner(2));
    }
    return sum;
  }

  // Gives the vector from the sample to the farthest dual point on a side, or the null vector if there is none.
  template <class Side>
  Vector_3 add_farthest(const Triangulation& tr, const Point_3& sample, const std::vector<Cell_handle>& star, const Side& is_on_side)
  {
    Cell_handle farthest;
    Vector_3 way = NULL_VECTOR;
    for(Cell_handle c : star)
    {
      if(tr.is_infinite(c))
        continue;
      const Vector_3 x = tr.dual(c) - sample;
      if(is_on_side(x) && (farthest == Cell_handle() || x.squared_length() > way.squared_length()))
      {
        way = x;
        farthest = c;
      }
    }
    if(farthest != Cell_handle() && sees_samples_apart(tr, farthest))
      poles_.push_back(tr.dual(farthest));
    return way;
  }

  static bool sees_samples_apart(const Triangulation& tr, Cell_handle c)
  {
    double widest = 0;
    for(int i = 0; i < 3; ++i)
      for(int j = i + 1; j < 4; ++j)
        widest = (std::max)(widest, CGAL::squared_distance(tr.point(c, i).point(), tr.point(c, j).point()));
    return widest >= CGAL::squared_distance(tr.dual(c), tr.point(c, 0).point());
  }

  std::vector<Point_3> poles_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_BOUNDARY_POLES_3_H
