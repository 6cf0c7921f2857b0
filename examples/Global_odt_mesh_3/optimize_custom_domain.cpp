// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A domain of the user's own: an ellipsoid whose intersections with segments, rays, and lines are computed in closed form.
// What the mesh generator asks of a domain is all that the optimizer asks.

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>
#include <tuple>
#include <utility>

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;

// A model of `MeshDomain_3`: inside, q(p) = (p.x/a)^2 + (p.y/b)^2 + (p.z/c)^2 is below 1.
class Ellipsoid
{
public:
  typedef K R;
  typedef K::Point_3 Point_3;
  typedef int Subdomain_index;
  typedef int Surface_patch_index;
  typedef int Index;
  // The optional index that the version of CGAL in use asks for.
  typedef CGAL::Labeled_mesh_domain_3<K>::Subdomain Subdomain;
  typedef std::tuple<Point_3, Index, int> Intersection;   // the point, its index, and its dimension; 0 for none

  Ellipsoid(double a, double b, double c) : semi_axes_(a, b, c) {}

  struct Construct_initial_points
  {
    const Ellipsoid& ellipsoid;

    template <class OutputIterator>
    OutputIterator operator()(OutputIterator points, int = 0) const
    {
      const K::Vector_3& s = ellipsoid.semi_axes_;
      for(int sign : { -1, 1 })
      {
        *points++ = std::make_pair(Point_3(sign * s.x(), 0, 0), 1);
        *points++ = std::make_pair(Point_3(0, sign * s.y(), 0), 1);
        *points++ = std::make_pair(Point_3(0, 0, sign * s.z()), 1);
      }
      return points;
    }
  };

  struct Is_in_domain
  {
    const Ellipsoid& ellipsoid;

    Subdomain operator()(const Point_3& p) const
    {
      const K::Vector_3 v = ellipsoid.scaled(p - CGAL::ORIGIN);
      return v * v < 1 ? Subdomain(1) : Subdomain();
    }
  };

  struct Construct_intersection
  {
    const Ellipsoid& ellipsoid;

    Intersection operator()(const K::Segment_3& s) const
    {
      return ellipsoid.intersection(s.source(), s.to_vector(), 0, 1);
    }
    Intersection operator()(const K::Ray_3& r) const
    {
      return ellipsoid.intersection(r.source(), r.to_vector(), 0, infinity);
    }
    Intersection operator()(const K::Line_3& l) const
    {
      return ellipsoid.intersection(l.point(0), l.to_vector(), -infinity, infinity);
    }

    static constexpr double infinity = std::numeric_limits<double>::infinity();
  };

  CGAL::Bbox_3 bbox() const
  {
    const K::Vector_3& s = semi_axes_;
    return CGAL::Bbox_3(-s.x(), -s.y(), -s.z(), s.x(), s.y(), s.z());
  }

  Construct_initial_points construct_initial_points_object() const { return { *this }; }
  Is_in_domain is_in_domain_object() const { return { *this }; }
  Construct_intersection construct_intersection_object() const { return { *this }; }
  Index index_from_surface_patch_index(Surface_patch_index i) const { return i; }
  Index index_from_subdomain_index(Subdomain_index i) const { return i; }
  Surface_patch_index surface_patch_index(Index i) const { return i; }
  Subdomain_index subdomain_index(Index i) const { return i; }

private:
  K::Vector_3 scaled(const K::Vector_3& v) const
  {
    return K::Vector_3(v.x() / semi_axes_.x(), v.y() / semi_axes_.y(), v.z() / semi_axes_.z());
  }

  // The first point p + t v on the surface with `least` <= t <= `most`, where q(p + t v) = 1.
  Intersection intersection(const Point_3& p, const K::Vector_3& v, double least, double most) const
  {
    const K::Vector_3 scaled_p = scaled(p - CGAL::ORIGIN), scaled_v = scaled(v);
    const double a = scaled_v * scaled_v, b = scaled_v * scaled_p, c = scaled_p * scaled_p - 1;
    const double discriminant = b * b - a * c;
    if(a > 0 && discriminant > 0)
      for(double t : { (-b - std::sqrt(discriminant)) / a, (-b + std::sqrt(discriminant)) / a })
        if(least <= t && t <= most)
          return Intersection(p + t * v, 1, 2);
    return Intersection(Point_3(CGAL::ORIGIN), 0, 0);
  }

  K::Vector_3 semi_axes_;
};

typedef CGAL::Mesh_triangulation_3<Ellipsoid, K>::type Tr;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Tr> C3t3;
typedef CGAL::Mesh_criteria_3<Tr> Criteria;
namespace params = CGAL::parameters;

int main()
{
  const Ellipsoid domain(1, 0.7, 0.5);
  const Criteria criteria(params::facet_angle = 30, params::facet_size = 0.1, params::facet_distance = 0.01,
                          params::cell_radius_edge_ratio = 2, params::cell_size = 0.1);
  C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::no_exude());
  std::cout << "--- before ---\n" << CGAL::mesh_quality_report_3(c3t3);
  CGAL::odt_optimize_mesh_3(c3t3, domain);
  std::cout << "--- after ---\n" << CGAL::mesh_quality_report_3(c3t3);
  return EXIT_SUCCESS;
}
