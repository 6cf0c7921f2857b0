// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_RANDOM_COMPOSITE_DOMAINS_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_RANDOM_COMPOSITE_DOMAINS_H

#include "random_draw.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Polyhedral_complex_mesh_domain_3.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/make_mesh_3.h>

#include <array>
#include <iterator>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// Random domains composed of several: surfaces inside of a volume, polyhedral complexes, and a domain of the user's own
// that is the union of two of CGAL's.
namespace random_domains {

// A model, perhaps with holes, in a box: facets that separate nothing.
struct Surface_inside_input : Random_input
{
  typedef Polyhedral_domain Domain;
  typedef Polyhedral_c3t3 C3t3;

  double radius;
  Polyhedron inside, box;
  Domain domain;

  explicit Surface_inside_input(Draw& draw)
    : Random_input(random_model(draw), draw)
    , inside(perhaps_open(read_model(name), draw))
    , box(box_around(inside, draw.uniform(0.05, 0.5)))
    , domain(inside, box)
  {
    radius = radius_of(domain.bbox());
    domain.detect_features();
    name = "box around " + name;
  }

  Polyhedral_criteria criteria() const { return criteria_with_features<Polyhedral_criteria>(sizes, radius); }
  C3t3 mesh() const { return CGAL::make_mesh_3<C3t3>(domain, criteria(), params::no_exude(), params::no_perturb()); }

private:
  // Larger by a fraction of its extent to every side.
  static Polyhedron box_around(const Polyhedron& p, double fraction)
  {
    CGAL::Bbox_3 b;
    for(auto v = p.points_begin(); v != p.points_end(); ++v)
      b += v->bbox();
    const double w = fraction * radius_of(b);
    Polyhedron result;
    CGAL::make_hexahedron(Point_3(b.xmin() - w, b.ymin() - w, b.zmin() - w), Point_3(b.xmax() + w, b.ymin() - w, b.zmin() - w),
                          Point_3(b.xmax() + w, b.ymax() + w, b.zmin() - w), Point_3(b.xmin() - w, b.ymax() + w, b.zmin() - w),
                          Point_3(b.xmin() - w, b.ymax() + w, b.zmax() + w), Point_3(b.xmin() - w, b.ymin() - w, b.zmax() + w),
                          Point_3(b.xmax() + w, b.ymin() - w, b.zmax() + w), Point_3(b.xmax() + w, b.ymax() + w, b.zmax() + w),
                          result);
    CGAL::Polygon_mesh_processing::triangulate_faces(result);
    return result;
  }

  // Half of the models lose some facets.
  static Polyhedron perhaps_open(Polyhedron p, Draw& draw)
  {
    for(int holes = draw.chance(0.5) ? draw.integer(1, 4) : 0; holes > 0 && p.size_of_facets() > 8; --holes)
    {
      auto f = p.facets_begin();
      std::advance(f, draw.integer(0, static_cast<int>(p.size_of_facets()) - 1));
      p.erase_facet(f->halfedge());
    }
    return p;
  }
};

// The walls of the boxes of a crooked grid, whose labels are random.
class Random_walls
{
public:
  explicit Random_walls(Draw& draw)
    : n_({{ draw.integer(1, 3), draw.integer(1, 3), draw.integer(1, 3) }})
    , labels_(n_[0] * n_[1] * n_[2])
    , points_((n_[0] + 1) * (n_[1] + 1) * (n_[2] + 1))
  {
    const double scale = draw.chance(0.3) ? draw.power(1e-6, 1e6) : 1, crookedness = draw.chance(0.5) ? 0 : draw.uniform(0, 0.25);
    for(int& l : labels_)
      l = draw.integer(0, 3);
    labels_[0] = 1;
    for_each_node({{ n_[0] + 1, n_[1] + 1, n_[2] + 1 }}, [&](const Node& k)
    {
      const auto coordinate = [&](int d) { return scale * (k[d] + crookedness * draw.uniform(-1, 1)); };
      const double x = coordinate(0), y = coordinate(1), z = coordinate(2);
      points_[number(k)] = Point_3(x, y, z);
    });
    for(int d = 0; d < 3; ++d)
    {
      Node end = n_;
      ++end[d];
      for_each_node(end, [&](const Node& k) { add_wall(d, k); });
    }
  }

  std::vector<Polyhedron> surfaces;
  std::vector<std::pair<int, int> > subdomains;             // below and above each surface

private:
  typedef std::array<int, 3> Node;

  template <class F>
  static void for_each_node(const Node& end, const F& f)
  {
    for(int i = 0; i < end[0]; ++i)
      for(int j = 0; j < end[1]; ++j)
        for(int k = 0; k < end[2]; ++k)
          f(Node{{ i, j, k }});
  }

  int number(const Node& k) const { return (k[0] * (n_[1] + 1) + k[1]) * (n_[2] + 1) + k[2]; }

  // Of the box from the node on, or 0 beyond the grid.
  int label(const Node& k) const
  {
    for(int d = 0; d < 3; ++d)
      if(k[d] < 0 || k[d] >= n_[d])
        return 0;
    return labels_[(k[0] * n_[1] + k[1]) * n_[2] + k[2]];
  }

  // The lower one of the box in direction d, if it separates anything.
  void add_wall(int d, const Node& k)
  {
    Node below = k;
    --below[d];
    if(label(below) == label(k))
      return;
    const int u = (d + 1) % 3, v = (d + 2) % 3;
    std::array<Node, 4> corners = {{ k, k, k, k }};
    ++corners[1][u];
    ++corners[2][u];
    ++corners[2][v];
    ++corners[3][v];
    Polyhedron p;
    CGAL::make_quad(points_[number(corners[0])], points_[number(corners[1])], points_[number(corners[2])],
                    points_[number(corners[3])], p);
    CGAL::Polygon_mesh_processing::triangulate_faces(p);
    surfaces.push_back(p);
    subdomains.emplace_back(label(below), label(k));
  }

  Node n_;
  std::vector<int> labels_;
  std::vector<Point_3> points_;
};

// Many corners and junctions.
struct Polyhedral_complex_input : Random_input
{
  typedef CGAL::Polyhedral_complex_mesh_domain_3<Kernel, Polyhedron> Domain;
  typedef CGAL::Mesh_triangulation_3<Domain, CGAL::Default, Concurrency_tag>::type Triangulation;
  typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index, Domain::Curve_index> C3t3;
  typedef CGAL::Mesh_criteria_3<Triangulation> Criteria;

  double radius;
  Random_walls walls;
  Domain domain;

  explicit Polyhedral_complex_input(Draw& draw)
    : Random_input("polyhedral complex", draw)
    , walls(draw)
    , domain(walls.surfaces.begin(), walls.surfaces.end(), walls.subdomains.begin(), walls.subdomains.end())
  {
    radius = radius_of(domain.bbox());
    domain.detect_features();
  }

  Criteria criteria() const { return criteria_with_features<Criteria>(sizes, radius); }
  C3t3 mesh() const { return CGAL::make_mesh_3<C3t3>(domain, criteria(), params::no_exude(), params::no_perturb()); }
};

// The union of a ball, subdomain 2, and of the rest of a polyhedron, subdomain 1, whose surfaces are patches with the same
// numbers.
class Hybrid_domain
{
public:
  typedef Kernel R;
  typedef domains::Point_3 Point_3;
  typedef Kernel::Segment_3 Segment_3;
  typedef int Subdomain_index;
  typedef int Surface_patch_index;
  typedef int Index;
  typedef std::tuple<Point_3, Index, int> Intersection;
  typedef Labeled_domain::Subdomain Subdomain;                // optional integers
  typedef Subdomain Surface_patch;

  Hybrid_domain(const Polyhedral_domain& polyhedron, const Labeled_domain& ball)
    : polyhedron_(polyhedron)
    , ball_(ball)
  {}

  struct Is_in_domain
  {
    const Hybrid_domain& domain;

    Subdomain operator()(const Point_3& p) const
    {
      return domain.is_in_ball(p) ? Subdomain(2) : domain.polyhedron_.is_in_domain_object()(p) ? Subdomain(1) : Subdomain();
    }
  };

  struct Construct_intersection
  {
    const Hybrid_domain& domain;

    // The surface of the polyhedron ends at the ball.
    template <class Query>
    Intersection operator()(const Query& query) const
    {
      const auto on_ball = domain.ball_.construct_intersection_object()(query);
      if(std::get<2>(on_ball) != 0)
        return Intersection(std::get<0>(on_ball), 2, 2);
      const auto on_polyhedron = domain.polyhedron_.construct_intersection_object()(query);
      if(std::get<2>(on_polyhedron) != 0 && !domain.is_in_ball(std::get<0>(on_polyhedron)))
        return Intersection(std::get<0>(on_polyhedron), 1, 2);
      return Intersection();
    }
  };

  struct Do_intersect_surface
  {
    const Hybrid_domain& domain;

    Surface_patch operator()(const Segment_3& s) const
    {
      const Intersection i = Construct_intersection{ domain }(s);
      return std::get<2>(i) == 2 ? Surface_patch(std::get<1>(i)) : Surface_patch();
    }
  };

  struct Construct_initial_points
  {
    const Hybrid_domain& domain;

    template <class Output_iterator>
    Output_iterator operator()(Output_iterator points, int n = 20) const
    {
      std::vector<std::pair<Point_3, Labeled_domain::Index> > on_ball;
      domain.ball_.construct_initial_points_object()(std::back_inserter(on_ball), n);
      for(const auto& p : on_ball)
        *points++ = std::make_pair(p.first, 2);
      std::vector<std::pair<Point_3, Polyhedral_domain::Index> > on_polyhedron;
      domain.polyhedron_.construct_initial_points_object()(std::back_inserter(on_polyhedron), n);
      for(const auto& p : on_polyhedron)
        if(!domain.is_in_ball(p.first))
          *points++ = std::make_pair(p.first, 1);
      return points;
    }
  };

  CGAL::Bbox_3 bbox() const { return polyhedron_.bbox() + ball_.bbox(); }
  Construct_initial_points construct_initial_points_object() const { return { *this }; }
  Is_in_domain is_in_domain_object() const { return { *this }; }
  Do_intersect_surface do_intersect_surface_object() const { return { *this }; }
  Construct_intersection construct_intersection_object() const { return { *this }; }
  Index index_from_surface_patch_index(Surface_patch_index i) const { return i; }
  Index index_from_subdomain_index(Subdomain_index i) const { return i; }
  Surface_patch_index surface_patch_index(Index i) const { return i; }
  Subdomain_index subdomain_index(Index i) const { return i; }

private:
  bool is_in_ball(const Point_3& p) const { return bool(ball_.is_in_domain_object()(p)); }

  const Polyhedral_domain& polyhedron_;
  const Labeled_domain& ball_;
};

struct Hybrid_input : Random_input
{
  typedef Hybrid_domain Domain;
  typedef CGAL::Mesh_triangulation_3<Domain, CGAL::Default, Concurrency_tag>::type Triangulation;
  typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> C3t3;
  typedef CGAL::Mesh_criteria_3<Triangulation> Criteria;

  double radius;
  Polyhedron polyhedron;
  Polyhedral_domain polyhedral_domain;
  Labeled_domain ball;
  Domain domain;

  explicit Hybrid_input(Draw& draw)
    : Random_input(random_model(draw), draw)
    , polyhedron(read_model(name))
    , polyhedral_domain(polyhedron)
    , ball(make_ball(draw, polyhedral_domain.bbox()))
    , domain(polyhedral_domain, ball)
  {
    radius = radius_of(domain.bbox());
    name += " and a ball";
  }

  Criteria criteria() const { return criteria_without_features<Criteria>(sizes, radius); }
  C3t3 mesh() const { return CGAL::make_mesh_3<C3t3>(domain, criteria(), params::no_exude(), params::no_perturb()); }

private:
  // Somewhere in the box.
  static Labeled_domain make_ball(Draw& draw, const CGAL::Bbox_3& box)
  {
    const double r = radius_of(box) * draw.uniform(0.1, 0.7);
    const double x = draw.uniform(box.xmin(), box.xmax()), y = draw.uniform(box.ymin(), box.ymax()),
                 z = draw.uniform(box.zmin(), box.zmax());
    const Point_3 c(x, y, z);
    return Labeled_domain([=](const Point_3& p) { return CGAL::squared_distance(p, c) < r * r ? 1 : 0; },
                          Sphere_3(c, 4 * r * r), 1e-4);
  }
};

} // namespace random_domains

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_RANDOM_COMPOSITE_DOMAINS_H
