// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A domain of the user's own needs no more than what Mesh_3 asks of it: neither the type of segments nor the
// predicate on intersections, and where it has them, it is asked one question, not two.

#include "mesh_contract.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Local_feature_size_field_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/refine_mesh_3.h>
#include <CGAL/remesh_boundary_mesh_3.h>
#include <CGAL/remove_slivers_mesh_3.h>
#include <CGAL/version.h>

#if CGAL_VERSION_NR < 1060000000
#  include <boost/optional.hpp>
#else
#  include <optional>
#endif

#include <cmath>
#include <cstddef>
#include <iostream>
#include <tuple>
#include <utility>

namespace params = CGAL::parameters;

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;

#if CGAL_VERSION_NR < 1060000000
template <class T> using Optional = boost::optional<T>;
#else
template <class T> using Optional = std::optional<T>;
#endif

// The unit ball. Counts how often it is asked for intersections.
class Own_ball
{
public:
  typedef Kernel R;
  typedef Kernel::Point_3 Point_3;
  typedef int Subdomain_index;
  typedef int Surface_patch_index;
  typedef int Index;
  typedef std::tuple<Point_3, Index, int> Intersection;

  struct Construct_initial_points
  {
    template <class Output_iterator>
    Output_iterator operator()(Output_iterator points, int = 0) const
    {
      for(int sign : { -1, 1 })
      {
        *points++ = std::make_pair(Point_3(sign, 0, 0), 1);
        *points++ = std::make_pair(Point_3(0, sign, 0), 1);
        *points++ = std::make_pair(Point_3(0, 0, sign), 1);
      }
      return points;
    }
  };

  struct Is_in_domain
  {
    Optional<Subdomain_index> operator()(const Point_3& p) const
    {
      return CGAL::squared_distance(p, Point_3(CGAL::ORIGIN)) < 1 ? Optional<Subdomain_index>(1) : Optional<Subdomain_index>();
    }
  };

  struct Construct_intersection
  {
    const Own_ball& ball;

    Intersection operator()(const Kernel::Segment_3& s) const
    {
      ++ball.number_of_intersections;
      return first_intersection(s.source(), s.to_vector(), 1);
    }
    Intersection operator()(const Kernel::Ray_3& r) const { return first_intersection(r.source(), r.to_vector(), 1e9); }
    Intersection operator()(const Kernel::Line_3& l) const
    {
      return first_intersection(l.point(0) - 1e3 * l.to_vector(), l.to_vector(), 1e9);
    }
  };

  CGAL::Bbox_3 bbox() const { return CGAL::Bbox_3(-1, -1, -1, 1, 1, 1); }
  Construct_initial_points construct_initial_points_object() const { return {}; }
  Is_in_domain is_in_domain_object() const { return {}; }
  Construct_intersection construct_intersection_object() const { return { *this }; }
  Index index_from_surface_patch_index(Surface_patch_index i) const { return i; }
  Index index_from_subdomain_index(Subdomain_index i) const { return i; }
  Surface_patch_index surface_patch_index(Index i) const { return i; }
  Subdomain_index subdomain_index(Index i) const { return i; }

  mutable std::size_t number_of_intersections = 0;

private:
  // Where p + t v, 0 <= t <= most, is on the unit sphere first.
  static Intersection first_intersection(const Point_3& p, const Kernel::Vector_3& v, double most)
  {
    const Kernel::Vector_3 w = p - CGAL::ORIGIN;
    const double a = v * v, b = v * w, c = w * w - 1, discriminant = b * b - a * c;
    if(a > 0 && discriminant > 0)
      for(double t : { (-b - std::sqrt(discriminant)) / a, (-b + std::sqrt(discriminant)) / a })
        if(t >= 0 && t <= most)
          return Intersection(p + t * v, 1, 2);
    return Intersection();
  }
};

// The same with the rest of the concept MeshDomain_3.
struct Complete_ball : Own_ball
{
  typedef Kernel::Segment_3 Segment_3;

  struct Do_intersect_surface
  {
    const Complete_ball& ball;

    Optional<int> operator()(const Segment_3& s) const
    {
      ++ball.number_of_predicates;
      return std::get<2>(Construct_intersection{ ball }(s)) == 2 ? Optional<int>(1) : Optional<int>();
    }
  };
  Do_intersect_surface do_intersect_surface_object() const { return { *this }; }

  mutable std::size_t number_of_predicates = 0;
};

typedef CGAL::Mesh_triangulation_3<Own_ball>::type Triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> C3t3;
typedef CGAL::Mesh_criteria_3<Triangulation> Criteria;
typedef Mesh_contract<C3t3, Complete_ball> Contract;

static Criteria criteria(double size)
{
  return Criteria(params::facet_angle = 25, params::facet_size = size, params::facet_distance = size / 4,
                  params::cell_radius_edge_ratio = 2.5, params::cell_size = size);
}

static void functions()
{
  const Own_ball ball;
  const Complete_ball complete_ball;
  const C3t3 input = CGAL::make_mesh_3<C3t3>(ball, criteria(0.25), params::no_exude(), params::no_perturb());
  std::cout << input.triangulation().number_of_vertices() << " vertices" << std::endl;
  check::that(input.number_of_cells_in_complex() > 100, "nothing meshed");
  const Contract contract(input, complete_ball, "own domain");
  const auto improved = [&](const C3t3& c3t3, const char* what)
  {
    contract.check_moved(c3t3, 1e-9);
    check::that(Contract::points(c3t3) != Contract::points(input), what, " does nothing");
  };
  C3t3 optimized(input), remeshed(input), freed(input), refined(input);
  CGAL::odt_optimize_mesh_3(optimized, ball);
  improved(optimized, "odt_optimize_mesh_3");
  CGAL::remesh_boundary_mesh_3(remeshed, ball);
  improved(remeshed, "remesh_boundary_mesh_3");
  CGAL::remove_slivers_mesh_3(freed, ball);
  improved(freed, "remove_slivers_mesh_3");
  CGAL::refine_mesh_3(refined, ball, criteria(0.25), params::odt(), params::no_exude(), params::no_perturb());
  check::that(refined.triangulation().is_valid(), "not valid after refine_mesh_3 with odt()");
  const C3t3 made = CGAL::make_mesh_3<C3t3>(ball, criteria(0.25), params::odt(), params::no_exude(), params::no_perturb());
  improved(made, "make_mesh_3 with odt()");

  const CGAL::Local_feature_size_field_3<Own_ball> size(ball);
  check::that(size(Point_3(1, 0, 0), 2, 1) >= size.parameters().smallest_size, "no size from an own domain");
}

// The domain is asked for intersections, and not for the predicate.
static void questions()
{
  const Complete_ball ball;
  C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(ball, criteria(0.3), params::no_exude(), params::no_perturb());
  ball.number_of_intersections = ball.number_of_predicates = 0;
  CGAL::odt_optimize_mesh_3(c3t3, ball);
  std::cout << ball.number_of_intersections << " intersections, " << ball.number_of_predicates << " predicates" << std::endl;
  check::that(ball.number_of_intersections > 0, "the domain is not asked");
  check::that(ball.number_of_predicates == 0, "the predicate is asked ", ball.number_of_predicates, " times");
}

int main()
{
  functions();
  questions();
  return check::result();
}
