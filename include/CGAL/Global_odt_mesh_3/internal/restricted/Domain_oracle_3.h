// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_DOMAIN_ORACLE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_DOMAIN_ORACLE_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Point_coordinates.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Shared_counter.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Mesh_3/config.h>

#include <Eigen/Core>

#ifdef CGAL_GLOBAL_ODT_MESH_3_PROFILING
#  include <chrono>
#endif
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Polyhedral domains offer the AABB tree of their facets.
template <class Mesh_domain, class = void>
struct Has_aabb_tree : std::false_type {};

template <class Mesh_domain>
struct Has_aabb_tree<Mesh_domain,
                     std::void_t<typename Mesh_domain::AABB_tree,
                                 decltype(std::declval<const Mesh_domain&>().aabb_tree()),
                                 decltype(std::declval<const Mesh_domain&>().make_surface_index(
                                   std::declval<typename Mesh_domain::AABB_tree::Primitive_id>()))> >
  : std::true_type {};

// How often the domain was asked.
struct Oracle_statistics
{
  Shared_counter locations;         // is_in_domain
  Shared_counter intersections;     // construct_intersection
  Shared_counter projections;       // closest points from the AABB tree
  Shared_counter failures;          // intersections and projections that found nothing of use
  Shared_counter nanoseconds;       // spent in the domain, if CGAL_GLOBAL_ODT_MESH_3_PROFILING is defined

  Oracle_statistics& operator+=(const Oracle_statistics& o)
  {
    locations += o.locations; intersections += o.intersections; projections += o.projections;
    failures += o.failures; nanoseconds += o.nanoseconds;
    return *this;
  }
};

// Adds the time of its life to the statistics.
class Oracle_stopwatch
{
#ifdef CGAL_GLOBAL_ODT_MESH_3_PROFILING
public:
  explicit Oracle_stopwatch(Oracle_statistics& s) : statistics_(s), begin_(std::chrono::steady_clock::now()) {}
  ~Oracle_stopwatch()
  {
    statistics_.nanoseconds += std::chrono::nanoseconds(std::chrono::steady_clock::now() - begin_).count();
  }

private:
  Oracle_statistics& statistics_;
  std::chrono::steady_clock::time_point begin_;
#else
public:
  explicit Oracle_stopwatch(Oracle_statistics&) {}
#endif
};

// All questions to the domain go through here. They are no more than those of Mesh_3 itself, since
// domains need not have all members of the concept MeshDomain_3; where there is an AABB tree, it projects. Several threads
// may ask at once if the domain permits that.
template <class Mesh_domain>
class Domain_oracle_3
{
public:
  typedef typename Mesh_domain::Subdomain_index Subdomain_index;
  typedef typename Mesh_domain::Surface_patch_index Surface_patch_index;
  typedef typename Mesh_domain::Index Index;
  typedef typename Mesh_domain::Point_3 Point_3;
  typedef typename Kernel_traits<Point_3>::Kernel::Segment_3 Segment_3;
  typedef Eigen::Vector3d Vector;

  explicit Domain_oracle_3(const Mesh_domain& domain)
    : domain_(domain)
  {}

  const Oracle_statistics& statistics() const { return statistics_; }

  // Outside, this is Subdomain_index().
  Subdomain_index subdomain(const Point_3& p)
  {
    ++statistics_.locations;
    const Oracle_stopwatch stopwatch(statistics_);
    const auto s = domain_.is_in_domain_object()(p);
    return s ? Subdomain_index(*s) : Subdomain_index();
  }

  Index index(const Surface_patch_index& patch) const { return domain_.index_from_surface_patch_index(patch); }
  Surface_patch_index surface_patch(const Index& index) const { return domain_.surface_patch_index(index); }

  // Moves `p` to the surface patch, by the closest point or along the normal, at
  // most as far as `reach`; false if there is no such point.
  bool project(Vector& p, const Vector& normal, double reach, const Surface_patch_index& patch)
  {
    if constexpr (Has_aabb_tree<Mesh_domain>::value)
    {
      ++statistics_.projections;
      const Oracle_stopwatch stopwatch(statistics_);
      const auto closest = domain_.aabb_tree().closest_point_and_primitive(Point_3(p[0], p[1], p[2]));
      const Vector q = coordinates(closest.first);
      if((p - q).norm() <= reach && domain_.make_surface_index(closest.second) == patch)
      {
        p = q;
        return true;
      }
      ++statistics_.failures;
      return false;
    }
    else
    {
      // Short segments are cut faster, and rarely at another sheet of the surface.
      Index index;
      for(double h : { reach / 4, reach })
      {
        Vector q = p;
        if(!intersect(q, normal, h, index))
          continue;
        if(!(domain_.surface_patch_index(index) == patch))
          break;
        p = q;
        return true;
      }
      return false;
    }
  }

  // How far `p` is from the surface, if that is easily found out, or else 0.
  double distance_to_surface(const Vector& p)
  {
    if constexpr (Has_aabb_tree<Mesh_domain>::value)
    {
      ++statistics_.projections;
      const Oracle_stopwatch stopwatch(statistics_);
      return (p - coordinates(domain_.aabb_tree().closest_point(Point_3(p[0], p[1], p[2])))).norm();
    }
    else
      return 0;
  }

  // Moves `p` to where the segment of that half length and direction around it
  // meets the surface.
  bool intersect(Vector& p, const Vector& direction, double half_length, Index& index)
  {
    ++statistics_.intersections;
    const Oracle_stopwatch stopwatch(statistics_);
    const Vector from = p - half_length * direction, to = p + half_length * direction;
    const Segment_3 s(Point_3(from[0], from[1], from[2]), Point_3(to[0], to[1], to[2]));
    // That of cospherical cells is a point, which domains do not expect.
    const bool is_segment = (to - from).norm() > 0;
    if(is_segment && may_intersect(s))
    {
      const typename Mesh_domain::Intersection i = domain_.construct_intersection_object()(s);
      if(std::get<2>(i) >= 2)
      {
        p = coordinates(std::get<0>(i));
        index = std::get<1>(i);
        return true;
      }
    }
    ++statistics_.failures;
    return false;
  }

private:
  // Where Mesh_3 still asks the predicate first, domains rely on that.
  bool may_intersect([[maybe_unused]] const Segment_3& s) const
  {
#ifdef CGAL_MESH_3_NO_LONGER_CALLS_DO_INTERSECT_3
    return true;
#else
    return bool(domain_.do_intersect_surface_object()(s));
#endif
  }

  const Mesh_domain& domain_;
  Oracle_statistics statistics_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_DOMAIN_ORACLE_3_H
