// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_TEST_PERIODIC_MESHES_H
#define GLOBAL_ODT_MESH_3_TEST_PERIODIC_MESHES_H

// The headers of Periodic_3_mesh_3 have to come before those of Mesh_3.
#include <CGAL/Periodic_3_mesh_3/config.h>
#include <CGAL/make_periodic_3_mesh_3.h>
#include <CGAL/optimize_periodic_3_mesh_3.h>

#include "check.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Periodic_3_mesh_triangulation_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// Meshes in periodic triangulations, and what the optimizer promises to keep of them.
namespace periodic {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Labeled_mesh_domain_3<Kernel> Domain;
typedef CGAL::Mesh_complex_3_in_triangulation_3<CGAL::Periodic_3_mesh_triangulation_3<Domain>::type> C3t3;
typedef CGAL::Mesh_criteria_3<C3t3::Triangulation> Criteria;

// Functions whose zeros are close to minimal surfaces, in a cube with sides of length 1.
constexpr double turn = 2 * CGAL_PI;

inline double schwarz_p(const Point& p)
{
  return std::cos(turn * p.x()) + std::cos(turn * p.y()) + std::cos(turn * p.z());
}

inline double gyroid(const Point& p)
{
  return std::cos(turn * p.x()) * std::sin(turn * p.y()) + std::cos(turn * p.y()) * std::sin(turn * p.z())
         + std::cos(turn * p.z()) * std::sin(turn * p.x());
}

inline double double_diamond(const Point& p)
{
  const double x = turn * p.x(), y = turn * p.y(), z = turn * p.z();
  return std::sin(x) * std::sin(y) * std::sin(z) + std::sin(x) * std::cos(y) * std::cos(z) + std::cos(x) * std::sin(y) * std::cos(z)
         + std::cos(x) * std::cos(y) * std::sin(z);
}

// Of the nearest copies, in a cube with sides of length 1.
inline double squared_distance(const Point& p, const Point& q)
{
  double d = 0;
  for(int i = 0; i < 3; ++i)
    d += CGAL::square(p[i] - q[i] - std::round(p[i] - q[i]));
  return d;
}

// The number of the nearest of some points.
inline int nearest(const std::vector<Point>& points, const Point& p)
{
  return static_cast<int>(std::min_element(points.begin(), points.end(), [&p](const Point& a, const Point& b)
                                           { return squared_distance(a, p) < squared_distance(b, p); }) - points.begin());
}

// All that is promised to stay, and what should get better.
template <class Mesh>
struct State
{
  typedef typename Mesh::Triangulation Tr;
  typedef typename Tr::Vertex_handle Vertex_handle;
  typedef std::tuple<Vertex_handle, int, typename Mesh::Index> Vertex;

  std::vector<Vertex> vertices;
  std::vector<Point> points;
  std::set<std::pair<std::vector<Point>, int> > cells;
  std::map<int, double> volumes;
  double smallest_angle = 180, mean_ratio = 0;
  std::size_t edges = 0, corners = 0, facets = 0;
  std::size_t slivers = 0;                        // cells with an angle below 10 degrees
  std::set<std::vector<Point> > disagreeing;      // facets that are in the complex without separating subdomains, or the other way round

  explicit State(const Mesh& c3t3)
  {
    const Tr& tr = c3t3.triangulation();
    for(auto v = tr.vertices_begin(); v != tr.vertices_end(); ++v)
    {
      vertices.emplace_back(v, v->in_dimension(), v->index());
      points.push_back(v->point().point());
    }
    std::size_t inside = 0;
    for(auto c = tr.cells_begin(); c != tr.cells_end(); ++c)
    {
      std::vector<Point> key;
      std::array<CGAL::Global_odt_mesh_3::internal::Site, 4> s;
      const auto t = tr.tetrahedron(c);
      for(int i = 0; i < 4; ++i)
      {
        std::vector<Point> facet;
        for(int j = 1; j < 4; ++j)
          facet.push_back(c->vertex((i + j) & 3)->point().point());
        std::sort(facet.begin(), facet.end());
        if(c3t3.is_in_complex(c, i) == (c->subdomain_index() == c->neighbor(i)->subdomain_index()))
          disagreeing.insert(facet);
        key.push_back(c->vertex(i)->point().point());
        s[i] = { t[i].x(), t[i].y(), t[i].z(), 0 };
      }
      std::sort(key.begin(), key.end());
      cells.emplace(key, c->subdomain_index());
      volumes[c->subdomain_index()] += t.volume();
      if(c->subdomain_index() == 0)
        continue;
      const CGAL::Global_odt_mesh_3::internal::Cell_shape_3 shape(s[0], s[1], s[2], s[3]);
      const double angle = *std::min_element(shape.angles.begin(), shape.angles.end());
      smallest_angle = (std::min)(smallest_angle, angle);
      slivers += angle < 10;
      mean_ratio += shape.radius_ratio;
      ++inside;
    }
    mean_ratio /= double(inside);
    edges = c3t3.number_of_edges_in_complex();
    corners = c3t3.number_of_corners();
    facets = c3t3.number_of_facets_in_complex();
  }

  bool operator==(const State& s) const { return vertices == s.vertices && points == s.points && cells == s.cells && facets == s.facets; }
};

// How many cells have another label than the domain gives to their dual points.
template <class Mesh, class D>
std::size_t number_of_wrong_cells(const Mesh& c3t3, const D& domain)
{
  const auto& tr = c3t3.triangulation();
  std::size_t wrong = 0;
  for(auto c = tr.cells_begin(); c != tr.cells_end(); ++c)
    wrong += domain.is_in_domain_object()(tr.dual(c)).value_or(0) != c->subdomain_index();
  return wrong;
}

// Where the mesh generator has seen no facet between two subdomains for what it is, the optimizer does not know better.
template <class Mesh, class D>
void check_labels(const State<Mesh>& before, const Mesh& c3t3, const D& domain, const std::string& name)
{
  const auto& tr = c3t3.triangulation();
  const std::size_t wrong_cells = number_of_wrong_cells(c3t3, domain);
  std::size_t wrong_facets = 0, number_of_facets = 0;
  for(auto c = tr.cells_begin(); c != tr.cells_end(); ++c)
    for(int i = 0; i < 4; ++i)
    {
      const typename Mesh::Cell_handle d = c->neighbor(i);
      const std::pair<int, int> sides = std::minmax(c->subdomain_index(), d->subdomain_index());
      number_of_facets += c3t3.is_in_complex(c, i);
      if(!c3t3.is_in_complex(c, i) || sides.first == sides.second)
        continue;
      const Point center = c->get_facet_surface_center(i);
      const auto patch = c->surface_patch_index(i);
      wrong_facets += patch != sides || d->surface_patch_index(d->index(c)) != patch || center != d->get_facet_surface_center(d->index(c))
                      || c->get_facet_surface_center_index(i) != domain.index_from_surface_patch_index(patch);
    }
  check::that(wrong_cells == 0, name, ": ", wrong_cells, " cells with another label than that of the domain");
  check::that(wrong_facets == 0, name, ": ", wrong_facets, " facets are wrong");
  const auto disagreeing = State<Mesh>(c3t3).disagreeing;
  check::that(disagreeing.empty() || disagreeing == before.disagreeing, name, ": other facets that separate nothing");
  check::that(number_of_facets == 2 * c3t3.number_of_facets_in_complex(), name, ": number of facets");
}

inline bool is_in(const Kernel::Iso_cuboid_3& cube, const Point& p)
{
  return !cube.has_on_unbounded_side(p) && p.x() < cube.xmax() && p.y() < cube.ymax() && p.z() < cube.zmax();
}

// Smaller angles than before are to be of this many degrees at least. If the mesh generator has missed cells, these get the labels
// of the domain, so that volumes and angles are others.
template <class Mesh, class D>
void check_contract(const State<Mesh>& before, const Mesh& c3t3, const D& domain, const std::string& name, double angle = 30,
                    bool is_of_domain = true)
{
  const State<Mesh> after(c3t3);
  check::that(c3t3.triangulation().is_valid(), name, ": not valid");
  check::that(c3t3.triangulation().is_1_cover(), name, ": several sheets");
  check::that(after.vertices == before.vertices, name, ": vertices, dimensions, or indices have changed");
  check::that(after.edges == before.edges && after.corners == before.corners, name, ": features have changed");
  for(const Point& p : after.points)
    check::that(is_in(c3t3.triangulation().domain(), p), name, ": not in the cube: ", p);
  if(is_of_domain)
  {
    check::that(after.volumes.size() == before.volumes.size(), name, ": subdomains");
    for(const auto& v : before.volumes)
      check::that(std::abs(after.volumes.at(v.first) - v.second) <= 0.02 * v.second, name, ": volume of ", v.first);
    // A cell that has stayed may have its vertices in another order, and thus other angles in the last digits.
    constexpr double rounding = 1e-9;
    check::that(after.smallest_angle > (std::min)(before.smallest_angle, angle) - rounding, name, ": smallest angle ", before.smallest_angle,
                " -> ", after.smallest_angle);
  }
  // A mesh that has not changed is as the mesh generator has left it.
  if(after.points != before.points)
    check_labels(before, c3t3, domain, name);
}

} // namespace periodic

#endif // GLOBAL_ODT_MESH_3_TEST_PERIODIC_MESHES_H
