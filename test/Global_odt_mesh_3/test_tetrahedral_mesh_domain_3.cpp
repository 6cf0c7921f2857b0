// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The domain that a mesh fills, the completion of its complex, and a call that has no other domain.

#include "../../examples/Global_odt_mesh_3/complex_of_medit_mesh.h"
#include "check.h"
#include "mesh_domains.h"
#include "structured_box.h"

#include <CGAL/Mesh_optimization_report_3.h>
#include <CGAL/Random.h>
#include <CGAL/Tetrahedral_mesh_domain_3.h>
#include <CGAL/complete_mesh_complex_3.h>
#include <CGAL/iterator.h>
#include <CGAL/odt_optimize_tetrahedral_mesh_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace params = CGAL::parameters;
using domains::Kernel;
using domains::Labeled_c3t3;
using domains::Point_3;
using structured_box::C3t3;

typedef std::array<std::size_t, 4> Numbers;

// Of cells, facets, edges, and corners.
template <class C3t3>
Numbers numbers(const C3t3& c3t3)
{
  return {{ c3t3.number_of_cells_in_complex(), c3t3.number_of_facets_in_complex(), c3t3.number_of_edges_in_complex(),
            c3t3.number_of_corners() }};
}

static std::string printed(const Numbers& n)
{
  std::string s;
  for(std::size_t k : n)
    s += ' ' + std::to_string(k);
  return s;
}

// At centroids, and at random points, of cells inside and outside.
template <class C3t3>
void check_labels(const C3t3& c3t3, const CGAL::Tetrahedral_mesh_domain_3<C3t3>& domain, const std::string& name)
{
  CGAL::Random random(7);
  std::size_t wrong = 0, cells = 0;
  const auto& tr = c3t3.triangulation();
  for(auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c)
    for(int k = 0; k < 3; ++k)
    {
      const auto p = [&c](int i) { return c->vertex(i)->point().point(); };
      const auto weight = [&] { return k == 0 ? 1 : random.get_double(0.02, 1); };
      const double w[] = { weight(), weight(), weight(), weight() };
      const auto label = domain.is_in_domain_object()(CGAL::barycenter(p(0), w[0], p(1), w[1], p(2), w[2], p(3), w[3]));
      wrong += (label ? *label : 0) != c->subdomain_index();
      ++cells;
    }
  check::that(wrong == 0, name, ": the domain is wrong about ", wrong, " of ", cells, " points");
}

// Points far away, at facets, and at vertices, and segments that end at a facet's centroid.
template <class C3t3>
void check_surface(const C3t3& c3t3, const CGAL::Tetrahedral_mesh_domain_3<C3t3>& domain, const std::string& name)
{
  const auto box = domain.bbox();
  check::that(!domain.is_in_domain_object()(Point_3(box.xmax() + 1, box.ymax(), box.zmax())), name, ": far away is inside");
  check::Largest distance;
  std::size_t outside = 0, wrong_patches = 0;
  for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
  {
    const auto p = [&f](int k) { return f->first->vertex((f->second + k) % 4)->point().point(); };
    const Point_3 middle = CGAL::centroid(p(1), p(2), p(3));
    const auto closest = domain.aabb_tree().closest_point_and_primitive(middle);
    distance.add(std::sqrt(CGAL::squared_distance(middle, closest.first)));
    outside += !domain.is_in_domain_object()(p(1));
    const auto across = 1e-3 * CGAL::cross_product(p(2) - p(1), p(3) - p(1));
    const Kernel::Segment_3 s(middle - across, middle + across);
    const auto expected = c3t3.surface_patch_index(*f);
    const auto patch = domain.do_intersect_surface_object()(s);
    const auto i = domain.construct_intersection_object()(s);
    distance.add(std::sqrt(CGAL::squared_distance(middle, std::get<0>(i))));
    wrong_patches += domain.make_surface_index(closest.second) != expected || !patch || *patch != expected
                     || std::get<2>(i) != 2 || domain.surface_patch_index(std::get<1>(i)) != expected;
  }
  check::that(distance < 1e-12, name, ": facets are ", double(distance), " away from the surface");
  check::that(outside == 0, name, ": ", outside, " vertices of facets are outside");
  check::that(wrong_patches == 0, name, ": ", wrong_patches, " patches are wrong");
  std::vector<std::pair<Point_3, typename C3t3::Index> > points;
  domain.construct_initial_points_object()(std::back_inserter(points), 20);
  check::that(points.size() == 20, name, ": ", points.size(), " initial points");
}

// Two labels and no more: three patches, the edges of the box and of the interface, and their corners.
static void check_box()
{
  constexpr int n = 4;
  const Medit_mesh input = structured_box::mesh(n, 5, true);
  C3t3 c3t3;
  Complex_of_medit_mesh<C3t3> complex(input, c3t3, 60);
  const Numbers expected = {{ 5 * n * n * n, 2 * 7 * n * n, 16 * n, 12 }};
  check::that(numbers(c3t3) == expected, "a box has", printed(numbers(c3t3)), " cells, facets, edges, corners");
  std::map<int, int> dimensions, patches;
  for(auto v = c3t3.triangulation().finite_vertices_begin(); v != c3t3.triangulation().finite_vertices_end(); ++v)
    ++dimensions[v->in_dimension()];
  check::that(dimensions == std::map<int, int>{ { 0, 12 }, { 1, 44 }, { 2, 51 }, { 3, 18 } }, "the dimensions of a box");
  for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
    ++patches[c3t3.surface_patch_index(*f)];
  check::that(patches == std::map<int, int>{ { 1, 96 }, { 2, 96 }, { 3, 32 } }, "the patches of a box");

  // Of some facets, one cell does not know.
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    if(c->subdomain_index() == 1)
      for(int i = 0; i < 4; ++i)
        c->set_surface_patch_index(i, 0);
  CGAL::complete_mesh_complex_3(c3t3);
  check::that(numbers(c3t3) == expected, "a box that is completed again has", printed(numbers(c3t3)));
  const structured_box::Domain domain(c3t3);
  check_labels(c3t3, domain, "box");
  check_surface(c3t3, domain, "box");
  std::size_t corners = 0, curves = 0;
  domain.get_corners(CGAL::Counting_output_iterator(&corners));
  domain.get_curves(CGAL::Counting_output_iterator(&curves));
  check::that(corners == 12 && curves == 20, "the domain of a box has ", corners, " corners, and ", curves, " curves");

  // What comes out is what has gone in.
  const Medit_mesh output = complex.to_medit();
  const Numbers written = {{ output.tetrahedra.size(), output.triangles.size(), output.edges.size(),
                             output.corners.size() }};
  check::that(output.points == input.points && written == expected, "a box is not written as it is");
}

// Areas by references, twice.
static std::map<long long, double> areas(const Medit_mesh& m)
{
  std::map<long long, double> result;
  for(const auto& t : m.triangles)
  {
    std::array<Point_3, 3> p;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const auto& q = m.points[static_cast<std::size_t>(t.vertices[k])];
      p[k] = Point_3(q[0], q[1], q[2]);
    }
    const auto normal = CGAL::cross_product(p[1] - p[0], p[2] - p[0]);
    result[t.reference] += std::sqrt(normal * normal);
  }
  return result;
}

// Some triangles have references, and facets of one patch different subdomains on their sides. The inner vertices have been
// moved.
static void check_call()
{
  constexpr int n = 6;
  Medit_mesh input = structured_box::mesh(n, 6, true);
  CGAL::Random random(1);
  for(std::size_t v = 0; v < input.points.size(); ++v)
  {
    auto& p = input.points[v];
    input.point_references[v] = static_cast<long long>(v);
    for(double& x : p)
      if(x > 0 && x < n && p[0] != n / 2)
        x += random.get_double(-0.12, 0.12);
  }
  for(const auto& t : input.tetrahedra)
    for(int i = 0; i < 4; ++i)
    {
      const auto vertex = [&t, i](int k) { return t.vertices[static_cast<std::size_t>((i + k) % 4)]; };
      const auto z = [&](int k) { return input.points[static_cast<std::size_t>(vertex(k))][2]; };
      if(z(1) == z(2) && z(2) == z(3) && (z(1) == 0 || z(1) == n))
        input.triangles.push_back({ {{ vertex(1), vertex(2), vertex(3) }}, z(1) == 0 ? -4 : 70 });
    }
  C3t3 c3t3;
  Complex_of_medit_mesh<C3t3> complex(input, c3t3, 60);
  const structured_box::Domain domain(c3t3);
  check_labels(c3t3, domain, "distorted box");
  const Medit_mesh before = complex.to_medit();
  CGAL::Mesh_optimization_report_3<C3t3> report;
  CGAL::odt_optimize_tetrahedral_mesh_3(c3t3, params::optimization_report = std::ref(report));
  std::cout << "distorted box: " << report;
  check::that(report.is_changed(), "a distorted box is not optimized");
  const Medit_mesh after = complex.to_medit();
  check::that(after.point_references == input.point_references, "references of vertices are lost");
  const std::map<long long, double> area = areas(before), area_after = areas(after);
  check::that(area.size() == 5 && area.count(-4) == 1 && area.count(70) == 1, "there are ", area.size(),
              " references of triangles");
  for(const auto& a : area)
    check::that(area_after.count(a.first) == 1 && std::abs(area_after.at(a.first) / a.second - 1) < 0.01,
                "the area of reference ", a.first, " changes");
  check::that(area_after.size() == area.size(), "there are new references of triangles");
}

// A mesh of the mesh generator, whose patches are pairs, and whose cells outside are finite, too.
static void check_generated()
{
  Labeled_c3t3 c3t3 = domains::mesh(domains::three_subdomains(), 0.15);
  const std::size_t facets = c3t3.number_of_facets_in_complex();
  for(int k = 0; k < 2; ++k)
  {
    CGAL::complete_mesh_complex_3(c3t3, 90);
    std::cout << "three subdomains:" << printed(numbers(c3t3)) << " cells, facets, edges, corners" << std::endl;
    check::that(c3t3.number_of_facets_in_complex() == facets && c3t3.number_of_edges_in_complex() > 10,
                "three subdomains: ", printed(numbers(c3t3)));
  }
  const CGAL::Tetrahedral_mesh_domain_3<Labeled_c3t3> domain(c3t3);
  check_labels(c3t3, domain, "three subdomains");
  check_surface(c3t3, domain, "three subdomains");

  // Without the facets of one patch, subdomains are not divided.
  const auto patch = c3t3.surface_patch_index(*c3t3.facets_in_complex_begin());
  std::vector<Labeled_c3t3::Facet> removed;
  for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
    if(c3t3.surface_patch_index(*f) == patch)
      removed.push_back(*f);
  for(const auto& f : removed)
    c3t3.remove_from_complex(f);
  bool is_refused = false;
  const CGAL::Failure_behaviour old = CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
  try
  {
    const CGAL::Tetrahedral_mesh_domain_3<Labeled_c3t3> open(c3t3);
  }
  catch(const CGAL::Precondition_exception&)
  {
    is_refused = true;
  }
  CGAL::set_error_behaviour(old);
  check::that(is_refused, "a complex that is not complete is not refused");
  CGAL::complete_mesh_complex_3(c3t3, 90);
  check::that(c3t3.number_of_facets_in_complex() == facets, "facets that are missing are not added");
}

int main()
{
  check_box();
  check_generated();
  check_call();
  return check::result();
}
