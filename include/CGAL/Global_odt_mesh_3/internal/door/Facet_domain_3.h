// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_FACET_DOMAIN_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_FACET_DOMAIN_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Parameter_check.h>

#include <CGAL/AABB_tree.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Filtered_predicate.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/enum.h>
#include <CGAL/Kernel/global_functions.h>
#include <CGAL/number_utils.h>
#include <CGAL/version.h>

// Named otherwise from 6.0 on.
#if __has_include(<CGAL/AABB_traits_3.h>)
#  include <CGAL/AABB_traits_3.h>
#  include <CGAL/AABB_triangle_primitive_3.h>
#else
#  include <CGAL/AABB_traits.h>
#  include <CGAL/AABB_triangle_primitive.h>
#endif

#include <boost/optional.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

#if __has_include(<CGAL/AABB_traits_3.h>)
template <class Kernel, class Iterator>
using Triangle_tree = AABB_tree<AABB_traits_3<Kernel, AABB_triangle_primitive_3<Kernel, Iterator> > >;
#else
template <class Kernel, class Iterator>
using Triangle_tree = AABB_tree<AABB_traits<Kernel, AABB_triangle_primitive<Kernel, Iterator> > >;
#endif

#if CGAL_VERSION_NR < 1060000000
template <class T> using Optional_index = boost::optional<T>;
#else
template <class T> using Optional_index = std::optional<T>;
#endif

// Which of two triangles a segment from p to q crosses first. It crosses both, and lies in the plane of neither.
template <class Kernel>
struct Compare_crossings_3
{
  typedef typename Kernel::Comparison_result result_type;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Triangle_3 Triangle_3;

  result_type operator()(const Point_3& p, const Point_3& q, const Triangle_3& s, const Triangle_3& t) const
  {
    const auto u = heights(p, q, s), v = heights(p, q, t);
    return CGAL::compare(u.first * v.second, v.first * u.second);
  }

private:
  // Of p, and of p over q, above the plane.
  static auto heights(const Point_3& p, const Point_3& q, const Triangle_3& t)
  {
    const auto normal = CGAL::cross_product(t[1] - t[0], t[2] - t[0]);
    return std::make_pair(CGAL::abs(normal * (p - t[0])), CGAL::abs(normal * (q - p)));
  }
};

// The numbers of a sequence that fills the unit square evenly.
inline std::array<double, 2> quasi_random_pair(int n)
{
  double whole;
  return {{ std::modf(0.5 + 0.7548776662466927 * n, &whole), std::modf(0.5 + 0.5698402909980532 * n, &whole) }};
}

// The domain that is divided by the facets of a complex, without features.
template <class C3t3>
class Facet_domain_3
{
public:
  typedef typename C3t3::Triangulation::Bare_point Point_3;
  typedef typename Kernel_traits<Point_3>::Kernel R;
  typedef typename R::FT FT;
  typedef typename R::Vector_3 Vector_3;
  typedef typename R::Segment_3 Segment_3;
  typedef typename R::Ray_3 Ray_3;
  typedef typename R::Line_3 Line_3;
  typedef typename C3t3::Subdomain_index Subdomain_index;
  typedef typename C3t3::Surface_patch_index Surface_patch_index;
  typedef typename C3t3::Index Index;
  typedef Optional_index<Subdomain_index> Subdomain;
  typedef Optional_index<Surface_patch_index> Surface_patch;
  typedef std::tuple<Point_3, Index, int> Intersection;
  // A mesh with these facets has no cell that passes through one.
  typedef Tag_true Has_facets_of_mesh;

private:
  typedef typename R::Triangle_3 Triangle_3;
  typedef std::vector<Triangle_3> Triangles;

public:
  typedef Triangle_tree<R, typename Triangles::const_iterator> AABB_tree;
  typedef typename AABB_tree::Primitive_id AABB_primitive_id;

  explicit Facet_domain_3(const C3t3& c3t3)
  {
    const auto& tr = c3t3.triangulation();
    for(auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f)
      if(c3t3.is_in_complex(*f))
        add_facet(*f, tr, c3t3.surface_patch_index(*f));
      else
        CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(
          f->first->subdomain_index() == f->first->neighbor(f->second)->subdomain_index(),
          "c3t3 must have all facets between two subdomains in its complex: call complete_mesh_complex_3() before");
    tree_.rebuild(triangles_.cbegin(), triangles_.cend());
    // Not when the first thread asks.
    if(!triangles_.empty())
      tree_.accelerate_distance_queries();
  }

  Bbox_3 bbox() const { return triangles_.empty() ? Bbox_3() : tree_.bbox(); }
  const AABB_tree& aabb_tree() const { return tree_; }
  const Surface_patch_index& make_surface_index(AABB_primitive_id id) const { return facet(id).patch; }

  // Points on a facet are in a subdomain beside it, if there is one.
  struct Is_in_domain
  {
    const Facet_domain_3& domain;

    Subdomain operator()(const Point_3& p) const
    {
      const Subdomain_index s = domain.subdomain_at(p);
      return s == Subdomain_index() ? Subdomain() : Subdomain(s);
    }
  };

  struct Do_intersect_surface
  {
    const Facet_domain_3& domain;

    // Of a segment, a ray, or a line.
    template <class Query>
    Surface_patch operator()(const Query& query) const
    {
      const auto id = domain.tree_.any_intersected_primitive(query);
      return id ? Surface_patch(domain.facet(*id).patch) : Surface_patch();
    }
  };

  struct Construct_intersection
  {
    const Facet_domain_3& domain;

    template <class Query>
    Intersection operator()(const Query& query) const
    {
      const auto id = domain.tree_.any_intersected_primitive(query);
      if(!id)
        return Intersection(Point_3(CGAL::ORIGIN), Index(), 0);
      const Triangle_3& t = **id;
      const Vector_3 normal = CGAL::cross_product(t[1] - t[0], t[2] - t[0]), along = query.to_vector();
      const FT slope = normal * along;
      const Point_3 from = query.point(0), p = slope == 0 ? from : from + along * (normal * (t[0] - from) / slope);
      return Intersection(R().construct_projected_point_3_object()(t, p), Index(domain.facet(*id).patch), 2);
    }
  };

  // Evenly among the facets.
  struct Construct_initial_points
  {
    const Facet_domain_3& domain;

    template <class OutputIterator>
    OutputIterator operator()(OutputIterator points, int n = 8) const
    {
      const std::size_t facets = domain.triangles_.size(), most = (std::min)(facets, static_cast<std::size_t>(n));
      for(std::size_t k = 0; k < most; ++k)
      {
        const std::size_t f = k * facets / most;
        *points++ = std::make_pair(CGAL::centroid(domain.triangles_[f]), Index(domain.facets_[f].patch));
      }
      return points;
    }
  };

  Is_in_domain is_in_domain_object() const { return { *this }; }
  Do_intersect_surface do_intersect_surface_object() const { return { *this }; }
  Construct_intersection construct_intersection_object() const { return { *this }; }
  Construct_initial_points construct_initial_points_object() const { return { *this }; }

private:
  typedef Filtered_predicate<Compare_crossings_3<typename R::Exact_kernel>,
                             Compare_crossings_3<typename R::Approximate_kernel>,
                             typename R::C2E, typename R::C2F> Compare_crossings;
  enum class Crossing { NONE, FOUND, UNCLEAR };

  struct Facet
  {
    Surface_patch_index patch;
    Subdomain_index positive, negative;     // on the two sides of the triangle

    const Subdomain_index& inside() const { return positive != Subdomain_index() ? positive : negative; }
  };

  const Facet& facet(AABB_primitive_id id) const { return facets_[static_cast<std::size_t>(id - triangles_.cbegin())]; }

  template <class Triangulation>
  void add_facet(const typename Triangulation::Facet& f, const Triangulation& tr, const Surface_patch_index& patch)
  {
    const auto g = tr.is_infinite(f.first) ? tr.mirror_facet(f) : f;
    const auto vertex = [&](int k) { return g.first->vertex(Triangulation::vertex_triple_index(g.second, k))->point().point(); };
    triangles_.emplace_back(vertex(0), vertex(1), vertex(2));
    facets_.push_back({ patch, g.first->subdomain_index(), g.first->neighbor(g.second)->subdomain_index() });
    // Cells need not be positive.
    const Point_3 apex = g.first->vertex(g.second)->point().point();
    if(CGAL::orientation(vertex(0), vertex(1), vertex(2), apex) == NEGATIVE)
      std::swap(facets_.back().positive, facets_.back().negative);
  }

  // Towards the closest facet, and a bit beyond, few others are in the way. Other directions follow, if the point is in its
  // plane, say.
  Subdomain_index subdomain_at(const Point_3& p) const
  {
    if(triangles_.empty() || !CGAL::do_overlap(tree_.bbox(), p.bbox()))
      return Subdomain_index();
    const AABB_primitive_id closest = tree_.closest_point_and_primitive(p).second;
    Subdomain_index subdomain;
    for(int n = 0; n < 4; ++n)
      if(find_subdomain(p, p + 1.1 * (inner_point(*closest, n) - p), subdomain) == Crossing::FOUND)
        return subdomain;
    constexpr int most_directions = 100;
    for(int n = 0; n < most_directions; ++n)
      switch(find_subdomain(p, p + way_out(n), subdomain))
      {
        case Crossing::FOUND: return subdomain;
        case Crossing::NONE: return Subdomain_index();
        case Crossing::UNCLEAR: break;
      }
    return facet(closest).inside();
  }

  static Point_3 inner_point(const Triangle_3& t, int n)
  {
    std::array<double, 2> w = quasi_random_pair(n);
    if(w[0] + w[1] > 1)
      w = {{ 1 - w[0], 1 - w[1] }};
    for(double& weight : w)
      weight = 0.1 + 0.7 * weight;
    return CGAL::barycenter(t[0], w[0], t[1], w[1], t[2], 1 - w[0] - w[1]);
  }

  // A vector that is longer than the domain.
  Vector_3 way_out(int n) const
  {
    const std::array<double, 2> w = quasi_random_pair(n);
    const Bbox_3 box = tree_.bbox();
    const double length = 2 * (box.xmax() - box.xmin() + box.ymax() - box.ymin() + box.zmax() - box.zmin());
    const double z = 2 * w[0] - 1, r = std::sqrt(1 - z * z), angle = 2 * CGAL_PI * w[1];
    return length * Vector_3(r * std::cos(angle), r * std::sin(angle), z);
  }

  // The side of the first facet on the way from p to q, exactly, unless an edge or a vertex is in the way.
  Crossing find_subdomain(const Point_3& p, const Point_3& q, Subdomain_index& subdomain) const
  {
    std::vector<AABB_primitive_id> crossed;
    tree_.all_intersected_primitives(Segment_3(p, q), std::back_inserter(crossed));
    const Triangle_3* first = nullptr;
    for(AABB_primitive_id id : crossed)
    {
      const Triangle_3& t = *id;
      const Orientation side = CGAL::orientation(t[0], t[1], t[2], p), turn = CGAL::orientation(p, q, t[0], t[1]);
      if(side == COPLANAR && CGAL::orientation(t[0], t[1], t[2], q) != COPLANAR)
      {
        subdomain = facet(id).inside();
        return Crossing::FOUND;
      }
      if(side == COPLANAR || turn == COPLANAR || CGAL::orientation(p, q, t[1], t[2]) != turn
         || CGAL::orientation(p, q, t[2], t[0]) != turn)
        return Crossing::UNCLEAR;
      const Subdomain_index& beside = side == POSITIVE ? facet(id).positive : facet(id).negative;
      const Comparison_result order = first ? Compare_crossings()(p, q, t, *first) : SMALLER;
      // Both faces of a crack may be at the same place.
      if(order == SMALLER || (order == EQUAL && beside != Subdomain_index()))
      {
        first = &t;
        subdomain = beside;
      }
    }
    return first ? Crossing::FOUND : Crossing::NONE;
  }

  Triangles triangles_;
  std::vector<Facet> facets_;
  AABB_tree tree_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_FACET_DOMAIN_3_H
