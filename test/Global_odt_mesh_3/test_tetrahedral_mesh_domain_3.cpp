// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The domain that a mesh fills, the completion of its complex, and a call that has no other domain.

#include "../../examples/Global_odt_mesh_3/complex_of_medit_mesh.h"
#include "check.h"
#include "kept_facets.h"
#include "mesh_domains.h"
#include "structured_box.h"

#include <CGAL/Mesh_optimization_report_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Random.h>
#include <CGAL/Tetrahedral_mesh_domain_3.h>
#include <CGAL/complete_mesh_complex_3.h>
#include <CGAL/iterator.h>
#include <CGAL/odt_optimize_tetrahedral_mesh_3.h>
#include <CGAL/property_map.h>
#include <CGAL/remesh_boundary_mesh_3.h>
#include <CGAL/remove_slivers_mesh_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
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

// Some triangles have references, and facets of one patch different subdomains on their sides. The vertices have been moved, but for
// those at corners and on the interface, so that not all facets are those of a Delaunay triangulation.
static Medit_mesh distorted_box(unsigned int seed, int cells_in_hexahedron = 6, double in_faces = 0.12)
{
  constexpr int n = 6;
  Medit_mesh input = structured_box::mesh(n, cells_in_hexahedron, true);
  CGAL::Random random(seed);
  for(std::size_t v = 0; v < input.points.size(); ++v)
  {
    auto& p = input.points[v];
    input.point_references[v] = static_cast<long long>(v);
    const bool is_inside = std::all_of(p.begin(), p.end(), [](double x) { return x > 0 && x < n; });
    const double most = is_inside ? 0.12 : in_faces;
    for(double& x : p)
      if(x > 0 && x < n && p[0] != n / 2)
        x += random.get_double(-most, most);
  }
  for(const auto& t : input.tetrahedra)
    for(int i = 0; i < 4; ++i)
    {
      const auto vertex = [&t, i](int k) { return t.vertices[static_cast<std::size_t>((i + k) % 4)]; };
      const auto z = [&](int k) { return input.points[static_cast<std::size_t>(vertex(k))][2]; };
      if(z(1) == z(2) && z(2) == z(3) && (z(1) == 0 || z(1) == n))
        input.triangles.push_back({ {{ vertex(1), vertex(2), vertex(3) }}, z(1) == 0 ? -4 : 70 });
    }
  return input;
}

template <class C3t3>
std::map<int, double> volumes_of_subdomains(const C3t3& c3t3)
{
  std::map<int, double> result;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    result[c3t3.subdomain_index(c)] += std::abs(c3t3.triangulation().tetrahedron(c).volume());
  return result;
}

// No subdomain may change by more than this share of its volume.
template <class C3t3>
void check_volumes(const std::string& name, const C3t3& c3t3, const std::map<int, double>& before, double share)
{
  const std::map<int, double> after = volumes_of_subdomains(c3t3);
  check::that(after.size() == before.size(), name, ": there are ", after.size(), " subdomains");
  for(const auto& v : before)
    check::that(after.count(v.first) == 1 && std::abs(after.at(v.first) / v.second - 1) <= share, name, ": the volume of subdomain ",
                v.first, " has been ", v.second, " and is ", after.count(v.first) == 1 ? after.at(v.first) : 0);
}

static void check_call()
{
  const Medit_mesh input = distorted_box(1);
  C3t3 c3t3;
  Complex_of_medit_mesh<C3t3> complex(input, c3t3, 60);
  const structured_box::Domain domain(c3t3);
  check_labels(c3t3, domain, "distorted box");
  const Medit_mesh before = complex.to_medit();
  const std::map<int, double> volume = volumes_of_subdomains(c3t3);
  CGAL::Mesh_optimization_report_3<C3t3> report;
  CGAL::odt_optimize_tetrahedral_mesh_3(c3t3, params::optimization_report = std::ref(report));
  std::cout << "distorted box: " << report;
  check::that(report.is_changed(), "a distorted box is not optimized");
  check_volumes("distorted box", c3t3, volume, 1e-12);
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

// A regular triangulation without hidden vertices, in which no vertex inside has a weight. Returns the weights of the others.
static std::map<C3t3::Vertex_handle, double> check_weights(const std::string& name, const C3t3& c3t3)
{
  const auto& tr = c3t3.triangulation();
  check::that(kept_facets::is_regular(tr), name, ": no regular triangulation");
  check::that(tr.tds().is_valid(), name, ": no triangulation");
  std::ptrdiff_t hidden = 0;
  for(auto c : tr.all_cell_handles())
    hidden += std::distance(c->hidden_points_begin(), c->hidden_points_end());
  check::that(hidden == 0, name, ": ", hidden, " hidden vertices");
  std::map<C3t3::Vertex_handle, double> weights;
  std::size_t inside = 0;
  for(C3t3::Vertex_handle v : tr.finite_vertex_handles())
    if(v->point().weight() != 0)
    {
      weights[v] = v->point().weight();
      inside += v->in_dimension() == 3;
    }
  check::that(inside == 0, name, ": ", inside, " vertices inside have a weight");
  return weights;
}

static void check_not_less(const std::string& name, const std::map<C3t3::Vertex_handle, double>& before,
                           const std::map<C3t3::Vertex_handle, double>& after)
{
  for(const auto& w : before)
    check::that(after.count(w.first) == 1 && after.at(w.first) >= w.second, name, ": a weight has become less");
}

// A boundary at rest keeps facets that are none of the Delaunay triangulation of the vertices, which takes weights. These stay.
static void check_fixed_boundary()
{
  for(unsigned int seed = 1; seed <= 3; ++seed)
  {
    const std::string name = "box whose boundary stays, seed " + std::to_string(seed);
    const Medit_mesh input = distorted_box(seed, 5, 0.05);
    C3t3 c3t3;
    const Complex_of_medit_mesh<C3t3> complex(input, c3t3, 60);
    const structured_box::Domain domain(c3t3);
    const auto facets = kept_facets::all(c3t3);
    const std::map<int, double> volume = volumes_of_subdomains(c3t3);
    std::map<C3t3::Vertex_handle, double> weights;
    for(int call = 0; call < 2; ++call)
    {
      const std::string n = name + ", call " + std::to_string(call + 1);
      CGAL::Mesh_optimization_report_3<C3t3> report;
      const double angle = CGAL::mesh_quality_report_3(c3t3).smallest_angle;
      CGAL::odt_optimize_mesh_3(c3t3, domain, params::optimize_boundary = false, params::optimization_report = std::ref(report));
      kept_facets::check_there(n, c3t3, facets);
      check::that(c3t3.number_of_facets_in_complex() == facets.size(), n, ": ", c3t3.number_of_facets_in_complex(), " facets, not ",
                  facets.size());
      check_volumes(n, c3t3, volume, 1e-12);
      const auto weights_now = check_weights(n, c3t3);
      const double angle_now = CGAL::mesh_quality_report_3(c3t3).smallest_angle;
      std::cout << n << ": " << weights_now.size() << " weights, smallest angle " << angle << " -> " << angle_now << "; " << report
                << std::endl;
      check::that(call > 0 || report.is_changed(), n, ": unchanged");
      check::that(call == 0 || angle_now >= (std::min)(angle, 30.), n, ": the smallest angle falls from ", angle, " to ", angle_now);
      check::that(!weights_now.empty(), n, ": no facet has needed a weight");
      check_not_less(n, weights, weights_now);
      weights = weights_now;
    }

    // Where the boundary moves, vertices with weights stay.
    std::map<C3t3::Vertex_handle, Point_3> places;
    for(const auto& w : weights)
      places[w.first] = w.first->point().point();
    CGAL::remove_slivers_mesh_3(c3t3, domain);
    CGAL::odt_optimize_tetrahedral_mesh_3(c3t3, params::number_of_rounds = 1);
    check_not_less(name + ", then moving", weights, check_weights(name + ", then moving", c3t3));
    const auto moved = std::count_if(places.begin(), places.end(), [](const auto& p) { return p.first->point().point() != p.second; });
    check::that(moved == 0, name, ": ", moved, " vertices with weights have moved");
  }
}

// On the boundary of a structured box, all facets are ties.
static void check_structured_boundary(int cells_in_hexahedron)
{
  constexpr int n = 5;
  for(unsigned int seed = 1; seed <= 3; ++seed)
  {
    const std::string name = "structured box of " + std::to_string(cells_in_hexahedron) + " cells a cube, seed " + std::to_string(seed);
    Medit_mesh input = structured_box::mesh(n, cells_in_hexahedron);
    CGAL::Random random(seed);
    for(auto& p : input.points)
      if(std::all_of(p.begin(), p.end(), [](double x) { return x > 0 && x < n; }))
        for(double& x : p)
          x += random.get_double(-0.25, 0.25);
    C3t3 c3t3;
    const Complex_of_medit_mesh<C3t3> complex(input, c3t3, 60);
    const structured_box::Domain domain(c3t3);
    const auto facets = kept_facets::all(c3t3);
    const CGAL::Mesh_quality_report_3 before = CGAL::mesh_quality_report_3(c3t3);
    CGAL::odt_optimize_mesh_3(c3t3, domain, params::optimize_boundary = false);
    kept_facets::check_there(name, c3t3, facets);
    check_weights(name, c3t3);
    const CGAL::Mesh_quality_report_3 after = CGAL::mesh_quality_report_3(c3t3);
    std::cout << name << ": smallest angle " << before.smallest_angle << " -> " << after.smallest_angle << ", mean radius ratio "
              << before.mean_radius_ratio << " -> " << after.mean_radius_ratio << std::endl;
    check::that(after.smallest_angle > (std::max)(before.smallest_angle, 24.), name, ": smallest angle ", after.smallest_angle);
    check::that(after.mean_radius_ratio > before.mean_radius_ratio + 0.03, name, ": mean radius ratio ", after.mean_radius_ratio);
  }
}

// Facets that the user wants to stay, in meshes whose triangulation may not have them if all other vertices stay.
static void check_constrained_facets(int cells_in_hexahedron, double in_faces, double share)
{
  for(unsigned int seed = 1; seed <= 3; ++seed)
  {
    const std::string name = "box with facets that stay, " + std::to_string(cells_in_hexahedron) + " cells a cube, seed "
                             + std::to_string(seed);
    const Medit_mesh input = distorted_box(seed, cells_in_hexahedron, in_faces);
    C3t3 c3t3;
    const Complex_of_medit_mesh<C3t3> complex(input, c3t3, 60);
    std::set<C3t3::Facet> constrained = kept_facets::some(c3t3, share, seed);
    const auto records = kept_facets::records(c3t3, constrained);
    const std::map<int, double> volume = volumes_of_subdomains(c3t3);
    const auto all = kept_facets::all(c3t3);
    for(int call = 0; call < 2; ++call)
    {
      CGAL::Mesh_optimization_report_3<C3t3> report;
      CGAL::odt_optimize_tetrahedral_mesh_3(
        c3t3, params::do_insert_vertices = true, params::do_remove_vertices = true, params::random_seed(seed),
        params::facet_is_constrained_map(CGAL::Boolean_property_map<std::set<C3t3::Facet> >(constrained)),
        params::optimization_report = std::ref(report));
      std::cout << name << ": " << records.size() << " of " << all.size() << " facets stay; " << report;
      kept_facets::check_there(name, c3t3, records);
      check_volumes(name, c3t3, volume, 1e-12);
      check_weights(name, c3t3);
      if(call > 0)
        continue;
      check::that(report.is_changed(), name, ": unchanged");
      const auto gone = std::count_if(all.begin(), all.end(), [&](const auto& f) { return !f.is_there(c3t3); });
      check::that(gone > 0, name, ": no facet has changed");
      // Handles of cells are others now.
      constrained.clear();
      for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
      {
        const kept_facets::Facet_record<C3t3> record(c3t3, *f);
        if(std::find(records.begin(), records.end(), record) != records.end())
          constrained.insert(*f);
      }
      check::that(constrained.size() == records.size(), name, ": ", constrained.size(), " facets are found again, not ", records.size());
    }
  }
}

// Numbers the vertices of all cells the other way round.
static void turn_over(C3t3& c3t3)
{
  for(auto c : c3t3.triangulation().all_cell_handles())
  {
    c->set_vertices(c->vertex(1), c->vertex(0), c->vertex(2), c->vertex(3));
    c->set_neighbors(c->neighbor(1), c->neighbor(0), c->neighbor(2), c->neighbor(3));
    const int patch = c->surface_patch_index(0);
    c->set_surface_patch_index(0, c->surface_patch_index(1));
    c->set_surface_patch_index(1, patch);
    const Point_3 center = c->get_facet_surface_center(0);
    c->set_facet_surface_center(0, c->get_facet_surface_center(1));
    c->set_facet_surface_center(1, center);
    const int index = c->get_facet_surface_center_index(0);
    c->set_facet_surface_center_index(0, c->get_facet_surface_center_index(1));
    c->set_facet_surface_center_index(1, index);
  }
}

// Such a mesh becomes the same as one that is not turned over, and so does its domain.
static void check_turned_over()
{
  std::vector<std::map<std::array<double, 3>, double> > points;
  std::vector<CGAL::Mesh_quality_report_3> qualities;
  for(bool is_turned : { false, true })
  {
    const std::string name = is_turned ? "box turned over" : "box";
    const Medit_mesh input = distorted_box(4);
    C3t3 c3t3;
    const Complex_of_medit_mesh<C3t3> complex(input, c3t3, 60);
    if(is_turned)
      turn_over(c3t3);
    check_labels(c3t3, structured_box::Domain(c3t3), name);
    CGAL::Mesh_optimization_report_3<C3t3> report;
    CGAL::odt_optimize_tetrahedral_mesh_3(c3t3, params::optimization_report = std::ref(report));
    std::cout << name << ": " << report;
    check::that(report.is_changed(), name, ": unchanged");
    check_weights(name, c3t3);
    points.emplace_back();
    for(C3t3::Vertex_handle v : c3t3.triangulation().finite_vertex_handles())
      points.back()[{{ v->point().x(), v->point().y(), v->point().z() }}] = v->point().weight();
    qualities.push_back(CGAL::mesh_quality_report_3(c3t3));
  }
  check::that(points[0] == points[1], "a box that is turned over gets other points");
  check::that(qualities[0].number_of_cells == qualities[1].number_of_cells && qualities[0].smallest_angle == qualities[1].smallest_angle,
              "a box that is turned over has ", qualities[1].number_of_cells, " cells and an angle of ", qualities[1].smallest_angle,
              ", and not ", qualities[0].number_of_cells, " and ", qualities[0].smallest_angle);
}

// How far the surface may be from facets that are all on it: sqrt(3) / 6 times an edge and the angle between the normals there.
static double largest_bend(const Labeled_c3t3& c3t3)
{
  std::map<std::pair<Labeled_c3t3::Vertex_handle, Labeled_c3t3::Vertex_handle>, std::vector<Kernel::Vector_3> > normals;
  for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
  {
    const auto vertex = [&](int k) { return f->first->vertex((f->second + k % 3 + 1) % 4); };
    const auto p = [&](int k) { return vertex(k)->point().point(); };
    const auto normal = CGAL::cross_product(p(1) - p(0), p(2) - p(0));
    for(int k = 0; k < 3; ++k)
      normals[std::minmax(vertex(k), vertex(k + 1))].push_back(normal / std::sqrt(normal * normal));
  }
  double bend = 0;
  for(const auto& e : normals)
  {
    const double angle = std::acos((std::min)(1., std::abs(e.second[0] * e.second[1])));
    const double length = std::sqrt(CGAL::squared_distance(e.first.first->point().point(), e.first.second->point().point()));
    bend = (std::max)(bend, std::sqrt(3.) / 6 * angle * length);
  }
  return bend;
}

// No facet of a coarse ball gets farther from it than it may be.
static void check_facet_distance()
{
  Labeled_c3t3 input = domains::mesh(domains::sphere(), 0.35);
  CGAL::complete_mesh_complex_3(input, 90);
  const CGAL::Tetrahedral_mesh_domain_3<Labeled_c3t3> domain(input);
  const std::map<int, double> volume = volumes_of_subdomains(input);
  const double bend = largest_bend(input), angle = CGAL::mesh_quality_report_3(input).smallest_angle;
  std::cout << "coarse ball: " << input.number_of_facets_in_complex() << " facets, with bends up to " << bend << std::endl;
  for(double share : { 0., 1e-3, 0.3, 1., 3. })
    for(unsigned int seed = 0; seed < 3; ++seed)
    {
      const double distance = share * bend, bound = (share == 0 ? bend : distance) + 2e-6;
      const auto check = [&](const char* what, const auto& call)
      {
        const std::string name = std::string("coarse ball, ") + what + ", facet_distance " + std::to_string(distance) + ", seed "
                                 + std::to_string(seed);
        Labeled_c3t3 c3t3(input);
        CGAL::Mesh_optimization_report_3<Labeled_c3t3> report;
        call(c3t3, report);
        const double farthest = kept_facets::farthest_centroid(c3t3, domain);
        const double angle_now = CGAL::mesh_quality_report_3(c3t3).smallest_angle;
        std::cout << name << ": " << (report.is_changed() ? "" : "unchanged, ") << "farthest facet " << farthest << ", smallest angle "
                  << angle_now << std::endl;
        check::that(farthest <= bound && report.farthest_facet <= bound, name, ": a facet is ", farthest, " from the surface, or ",
                    report.farthest_facet, ", and not ", bound);
        check::that(std::abs(report.farthest_facet - farthest) <= 1e-9, name, ": the report says ", report.farthest_facet, ", not ", farthest);
        check::that(what[0] == 'r' || angle_now >= (std::min)(angle, 30.), name, ": the smallest angle falls from ", angle, " to ", angle_now);
        check_volumes(name, c3t3, volume, 0.07);
        check::that(kept_facets::is_regular(c3t3.triangulation()), name, ": no regular triangulation");
      };
      check("all", [&](Labeled_c3t3& c, auto& report)
      {
        CGAL::odt_optimize_mesh_3(c, domain, params::facet_distance = distance, params::random_seed(seed),
                                  params::do_insert_vertices = seed == 1, params::do_remove_vertices = seed == 1,
                                  params::optimization_report = std::ref(report));
      });
      check("slivers", [&](Labeled_c3t3& c, auto& report)
      {
        CGAL::remove_slivers_mesh_3(c, domain, params::facet_distance = distance, params::random_seed(seed),
                                    params::optimization_report = std::ref(report));
      });
      if(seed == 0)
        check("remeshing", [&](Labeled_c3t3& c, auto& report)
        {
          CGAL::remesh_boundary_mesh_3(c, domain, params::facet_distance = distance, params::optimization_report = std::ref(report));
        });
    }
}

// Of edges on the surface.
static double mean_length_on_surface(const Labeled_c3t3& c3t3)
{
  double sum = 0;
  for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
    for(int k = 1; k < 4; ++k)
      sum += std::sqrt(CGAL::squared_distance(f->first->vertex((f->second + k) % 4)->point().point(),
                                              f->first->vertex((f->second + k % 3 + 1) % 4)->point().point()));
  return sum / (3 * double(c3t3.number_of_facets_in_complex()));
}

// A coarse ball gets edges of a quarter of their length: facets have to follow, and cells must not get worse. Edges are 4/3 of a size.
static void check_finer_sizes()
{
  Labeled_c3t3 input = domains::mesh(domains::sphere(), 0.35);
  CGAL::complete_mesh_complex_3(input, 90);
  // After that, halves of facets have angles below the bound.
  CGAL::odt_optimize_tetrahedral_mesh_3(input);
  const std::map<int, double> volume = volumes_of_subdomains(input);
  const double length = mean_length_on_surface(input) / 4;
  for(unsigned int seed = 0; seed < 3; ++seed)
  {
    const std::string name = "ball with finer sizes, seed " + std::to_string(seed);
    Labeled_c3t3 c3t3(input);
    CGAL::odt_optimize_tetrahedral_mesh_3(c3t3, params::sizing_field = length * 3 / 4, params::do_insert_vertices = true,
                                          params::random_seed(seed));
    const CGAL::Mesh_quality_report_3 q = CGAL::mesh_quality_report_3(c3t3, { 30 });
    const double now = mean_length_on_surface(c3t3);
    std::cout << name << ": " << q.number_of_vertices << " vertices, smallest angle " << q.smallest_angle << ", " << q.cells_below[0].second
              << " of " << q.number_of_cells << " cells below 30 degrees, angles of facets from " << q.smallest_facet_angle
              << ", edges on the surface " << now << " for " << length << std::endl;
    check::that(now < 1.05 * length, name, ": edges on the surface have a length of ", now, ", and not ", length);
    check::that(q.smallest_angle > 20 && q.cells_below[0].second * 1000 < q.number_of_cells, name, ": the smallest angle is ",
                q.smallest_angle, ", and ", q.cells_below[0].second, " of ", q.number_of_cells, " cells are below 30 degrees");
    check::that(q.smallest_facet_angle > 14, name, ": a facet has an angle of ", q.smallest_facet_angle);
    check::that(kept_facets::is_regular(c3t3.triangulation()), name, ": no regular triangulation");
    check_volumes(name, c3t3, volume, 0.01);
  }
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

// Two bars above each other, of which the vertices are close to the middles of the facets of the other one: there is no regular
// triangulation with all of these. Vertices inside are close to facets, too.
static Medit_mesh bars(double gap, double shift)
{
  constexpr int n = 2;
  Medit_mesh result;
  for(int bar = 0; bar < 2; ++bar)
  {
    const Medit_mesh box = structured_box::mesh(n, 6);
    const int first = static_cast<int>(result.points.size());
    for(const auto& p : box.points)
    {
      const double height = p[0] == 1 && p[1] == 1 && p[2] == 1 ? 0.01 : p[2];
      result.points.push_back({{ 4 * p[0] + bar * shift, p[1] + bar * 0.3 * shift, 0.5 * height + bar * (0.5 * n + gap) }});
    }
    for(Medit_mesh::Element<4> t : box.tetrahedra)
    {
      for(int& v : t.vertices)
        v += first;
      t.reference = bar + 1;
      result.tetrahedra.push_back(t);
    }
  }
  result.point_references.resize(result.points.size());
  return result;
}

static std::map<int, double> lengths_of_curves(const C3t3& c3t3)
{
  std::map<int, double> result;
  for(auto e = c3t3.edges_in_complex_begin(); e != c3t3.edges_in_complex_end(); ++e)
  {
    const auto v = e->first->vertex(e->second), w = e->first->vertex(e->third);
    result[c3t3.curve_index(*e)] += std::sqrt(CGAL::squared_distance(v->point().point(), w->point().point()));
    for(const auto u : { v, w })
      check::that(c3t3.in_dimension(u) == 0 || (c3t3.in_dimension(u) == 1 && c3t3.index(u) == c3t3.curve_index(*e)),
                  "a vertex on a curve has dimension ", c3t3.in_dimension(u));
  }
  return result;
}

static std::map<int, double> areas_of_patches(const C3t3& c3t3)
{
  std::map<int, double> result;
  for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
    result[c3t3.surface_patch_index(*f)] += std::sqrt(c3t3.triangulation().triangle(*f).squared_area());
  return result;
}

static void check_equal(const std::string& name, const std::map<int, double>& before, const std::map<int, double>& after)
{
  bool are_equal = before.size() == after.size();
  for(const auto& b : before)
    are_equal = are_equal && after.count(b.first) > 0 && std::abs(after.at(b.first) - b.second) < 1e-4 * b.second;
  if(!are_equal)
    for(const auto& a : after)
      std::cout << a.first << ": " << (before.count(a.first) > 0 ? before.at(a.first) : 0) << " -> " << a.second << std::endl;
  check::that(are_equal, name);
}

struct Measures
{
  std::map<int, double> curves, patches, volumes;

  explicit Measures(const C3t3& c3t3)
    : curves(lengths_of_curves(c3t3))
    , patches(areas_of_patches(c3t3))
    , volumes(volumes_of_subdomains(c3t3))
  {}
};

// With vertices on features and surfaces, the complex is as it was.
static void check_refined(const std::string& name, const Measures& before, const C3t3& c3t3)
{
  check::that(kept_facets::is_regular(c3t3.triangulation()), name, "no regular triangulation");
  const Measures after(c3t3);
  check_equal(name + "curves have other lengths", before.curves, after.curves);
  check_equal(name + "patches have other areas", before.patches, after.patches);
  check_equal(name + "subdomains have other volumes", before.volumes, after.volumes);
  C3t3 rescanned(c3t3);
  rescanned.rescan_after_load_of_triangulation();
  check::that(numbers(rescanned) == numbers(c3t3), name, "counts", printed(numbers(c3t3)), ", after a rescan", printed(numbers(rescanned)));
}

// Edges of features are split, too, where they are too long for the sizes.
static void check_sizes_at_features()
{
  constexpr double size = 0.25, longest = 4 / 3. * size;
  for(unsigned int seed = 1; seed <= 3; ++seed)
  {
    C3t3 c3t3;
    const Complex_of_medit_mesh<C3t3> complex(distorted_box(seed), c3t3, 60);
    const std::string name = "finer box " + std::to_string(seed) + ": ";
    const Measures before(c3t3);
    const std::size_t edges = c3t3.number_of_edges_in_complex(), corners = c3t3.number_of_corners();
    CGAL::odt_optimize_tetrahedral_mesh_3(c3t3, params::sizing_field = size, params::do_insert_vertices = true, params::random_seed(seed));
    const CGAL::Mesh_quality_report_3 q = CGAL::mesh_quality_report_3(c3t3, { 30 });
    check::Largest length;
    for(auto e = c3t3.edges_in_complex_begin(); e != c3t3.edges_in_complex_end(); ++e)
      length.add(std::sqrt(CGAL::squared_distance(e->first->vertex(e->second)->point().point(), e->first->vertex(e->third)->point().point())));
    std::cout << name << edges << " -> " << c3t3.number_of_edges_in_complex() << " edges of features, " << q.number_of_vertices
              << " vertices, smallest angle " << q.smallest_angle << ", " << q.cells_below[0].second << " of " << q.number_of_cells
              << " cells below 30 degrees" << std::endl;
    check::that(c3t3.number_of_edges_in_complex() >= 2 * edges && length < longest + 1e-9, name, "an edge of a feature has a length of ",
                double(length));
    check::that(c3t3.number_of_corners() == corners, name, "there are ", c3t3.number_of_corners(), " corners instead of ", corners);
    check::that(q.smallest_angle > 20 && 1000 * q.cells_below[0].second < q.number_of_cells, name, "cells are bad");
    check_refined(name, before, c3t3);
  }
}

// A prism with a regular base, of three cells for each side.
static Medit_mesh drum(int sides, double radius, double height)
{
  Medit_mesh m;
  const int above = sides + 1;
  for(double z : { 0., height })
  {
    m.points.push_back({{ 0, 0, z }});
    for(int i = 0; i < sides; ++i)
      m.points.push_back({{ radius * std::cos(2 * CGAL_PI * i / sides), radius * std::sin(2 * CGAL_PI * i / sides), z }});
  }
  m.point_references.resize(m.points.size());
  for(int i = 0; i < sides; ++i)
  {
    // The diagonals of faces begin at the vertex with the lower number.
    const auto [a, b] = std::minmax({ 1 + i, 1 + (i + 1) % sides });
    m.tetrahedra.push_back({ {{ 0, a, b, b + above }}, 1 });
    m.tetrahedra.push_back({ {{ 0, a, a + above, b + above }}, 1 });
    m.tetrahedra.push_back({ {{ 0, above, a + above, b + above }}, 1 });
  }
  return m;
}

// All vertices are on features or in the middle of a base, so that finer sizes need vertices on all faces at once: facets between
// features must not get thin, nor cells flat.
static void check_sizes_between_features()
{
  for(int sides : { 10, 16, 24 })
    for(double height : { 0.5, 1.5 })
    {
      C3t3 c3t3;
      const Complex_of_medit_mesh<C3t3> complex(drum(sides, 5, height), c3t3, 60);
      const std::string name = "drum of " + std::to_string(sides) + " sides, height " + std::to_string(height) + ": ";
      const std::map<int, double> curves = lengths_of_curves(c3t3), volume = volumes_of_subdomains(c3t3);
      const double size = height < 1 ? 0.25 : 0.4;
      CGAL::odt_optimize_tetrahedral_mesh_3(c3t3, params::sizing_field = size, params::do_insert_vertices = true);
      const CGAL::Mesh_quality_report_3 q = CGAL::mesh_quality_report_3(c3t3, { 10, 30 });
      std::cout << name << q.number_of_vertices << " vertices, smallest angle " << q.smallest_angle << ", " << q.cells_below[1].second
                << " of " << q.number_of_cells << " cells below 30 degrees" << std::endl;
      check::that(q.cells_below[0].second == 0 && q.cells_below[1].second * 500 < q.number_of_cells, name, "the smallest angle is ",
                  q.smallest_angle, ", and ", q.cells_below[1].second, " of ", q.number_of_cells, " cells are below 30 degrees");
      check::that(kept_facets::is_regular(c3t3.triangulation()), name, "no regular triangulation");
      check_equal(name + "curves have other lengths", curves, lengths_of_curves(c3t3));
      check_volumes(name, c3t3, volume, 0.01);
    }
}

// Where vertices may be inserted, edges and facets of the boundary are split, and otherwise obstacles are named.
static void check_conforming_refinement()
{
  for(unsigned int seed = 1; seed <= 3; ++seed)
  {
    C3t3 c3t3;
    const Complex_of_medit_mesh<C3t3> complex(bars(0.1 * seed, 0.3 + 0.1 * seed), c3t3, 60);
    const std::string name = "bars " + std::to_string(seed) + ": ";
    const Measures measures(c3t3);
    std::map<C3t3::Vertex_handle, std::pair<Point_3, int> > vertices;
    for(const auto v : c3t3.triangulation().finite_vertex_handles())
      vertices[v] = std::make_pair(v->point().point(), c3t3.in_dimension(v));
    CGAL::Mesh_optimization_report_3<C3t3> report;
    CGAL::odt_optimize_tetrahedral_mesh_3(c3t3, params::optimization_report(std::ref(report)), params::random_seed(seed));
    check::that(!report.is_changed() && report.reason == report.NO_VALID_MESH && !report.obstacles.empty(), name, "no obstacles are named");
    std::set<C3t3::Facet> facets(c3t3.facets_in_complex_begin(), c3t3.facets_in_complex_end());
    CGAL::odt_optimize_tetrahedral_mesh_3(c3t3, params::optimization_report(std::ref(report)), params::do_insert_vertices(true),
                                          params::facet_is_constrained_map(CGAL::Boolean_property_map<std::set<C3t3::Facet> >(facets)));
    check::that(!report.is_changed(), name, "facets that are to stay are split");
    const double before = CGAL::mesh_quality_report_3(c3t3).mean_radius_ratio;
    CGAL::odt_optimize_tetrahedral_mesh_3(c3t3, params::optimization_report(std::ref(report)), params::do_insert_vertices(true),
                                          params::random_seed(seed));
    const CGAL::Mesh_quality_report_3 quality = CGAL::mesh_quality_report_3(c3t3);
    std::cout << name << vertices.size() << " vertices, " << report.number_of_inserted_vertices << " inserted, smallest angle "
              << quality.smallest_angle << ", 3r/R " << before << " -> " << quality.mean_radius_ratio << std::endl;
    check::that(report.is_changed() && quality.mean_radius_ratio > before, name, "is not refined");
    if(!report.is_changed())
      continue;
    std::size_t on_curves = 0;
    for(const auto v : c3t3.triangulation().finite_vertex_handles())
      if(const auto old = vertices.find(v); old == vertices.end())
        on_curves += c3t3.in_dimension(v) == 1;
      else
      {
        check::that(c3t3.in_dimension(v) == old->second.second && (old->second.second > 1 || v->point().point() == old->second.first), name,
                    "a vertex on a feature has changed");
        vertices.erase(old);
      }
    check::that(vertices.empty(), name, "vertices are lost");
    check::that(on_curves > 0, name, "no edge of a feature is split");
    check_refined(name, measures, c3t3);
  }
}

int main()
{
  check_conforming_refinement();
  check_box();
  check_generated();
  check_call();
  check_fixed_boundary();
  check_structured_boundary(5);
  check_structured_boundary(6);
  check_constrained_facets(5, 0.05, 0.1);
  check_constrained_facets(5, 0.05, 0.3);
  check_constrained_facets(6, 0.12, 0.1);
  check_turned_over();
  check_facet_distance();
  check_finer_sizes();
  check_sizes_at_features();
  check_sizes_between_features();
  return check::result();
}
