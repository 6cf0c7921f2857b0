// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_MESH_DOMAIN_VIEW_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_MESH_DOMAIN_VIEW_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/door/Index_table.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Mesh_3/config.h>

#include <boost/variant/get.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>

namespace CGAL::Global_odt_mesh_3::internal {

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

// Domains that are made of a mesh say so.
template <class Mesh_domain, class = void>
struct Has_facets_of_mesh : std::false_type {};

template <class Mesh_domain>
struct Has_facets_of_mesh<Mesh_domain, std::void_t<typename Mesh_domain::Has_facets_of_mesh> > : std::true_type {};

// Domains with features have curves.
template <class Mesh_domain, class = void>
struct Curve_index_of { typedef int type; };

template <class Mesh_domain>
struct Curve_index_of<Mesh_domain, std::void_t<typename Mesh_domain::Curve_index> > { typedef typename Mesh_domain::Curve_index type; };

// What cannot be a domain, such as criteria.
template <class T, class = void>
struct Is_mesh_domain : std::false_type {};

template <class T>
struct Is_mesh_domain<T, std::void_t<typename T::Index, typename T::Subdomain_index, typename T::Surface_patch_index,
                                     decltype(std::declval<const T&>().is_in_domain_object())> > : std::true_type {};

// Whether the domain agrees about the subdomains of most cells of a mesh, of which a thousand are asked about at most. `points(c)` are
// those of which one at least has to be in the subdomain of a cell; it does not count if the first one is not finite.
template <class C3t3, class Domain_view, class Points>
bool is_domain_of_mesh(const C3t3& c3t3, Domain_view& domain, const Points& points)
{
  constexpr std::size_t most_questions = 1000;
  const std::size_t step = c3t3.number_of_cells_in_complex() / most_questions + 1;
  std::size_t number = 0, questions = 0, agreements = 0;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    if(number++ % step == 0)
    {
      const int label = domain.number_subdomain(c->subdomain_index());
      const auto p = points(c);
      if(!std::isfinite(p.front().squared_length()))
        continue;
      agreements += std::any_of(p.begin(), p.end(), [&](const Vector_3& q) { return domain.label(q) == label; });
      ++questions;
    }
  return 2 * agreements >= questions;
}

// Whether facets of the mesh, a thousand of them at most, are those of the domain.
template <class C3t3>
bool has_facets_of_mesh(const Domain_view_3& domain, const C3t3& c3t3)
{
  constexpr std::size_t most_questions = 1000;
  constexpr double tolerance = 1e-6;             // over an edge
  const std::size_t step = c3t3.number_of_facets_in_complex() / most_questions + 1;
  std::size_t number = 0;
  return domain.tells_distances() && c3t3.number_of_facets_in_complex() > 0
         && std::all_of(c3t3.facets_in_complex_begin(), c3t3.facets_in_complex_end(), [&](const auto& f)
  {
    const auto vertex = [&](int i) { return weighted_site(f.first->vertex((f.second + i) % 4)->point()); };
    const std::array<Site, 3> s = {{ vertex(1), vertex(2), vertex(3) }};
    return number++ % step != 0 || domain.distance_to_surface(centroid(s)) <= tolerance * (position(s[1]) - position(s[0])).length();
  });
}

// Domains need not have all members of the concept MeshDomain_3.
template <class Mesh_domain>
class Mesh_domain_view_3
  : public Domain_view_3
{
public:
  typedef typename Mesh_domain::Index Index;
  typedef typename Mesh_domain::Subdomain_index Subdomain_index;
  typedef typename Mesh_domain::Surface_patch_index Surface_patch_index;
  typedef typename Curve_index_of<Mesh_domain>::type Curve_index;

  // If threads are given, they may query the domain at the same time.
  explicit Mesh_domain_view_3(const Mesh_domain& domain, const Thread_policy& threads = Thread_policy())
    : Domain_view_3(Has_aabb_tree<Mesh_domain>::value, threads)
    , domain_(domain)
  {
    subdomains_.number(Subdomain_index());            // outside
  }

  // What a mesh has gets numbers. This must not be called while threads query the domain.
  int number_subdomain(const Subdomain_index& subdomain) { return subdomains_.number(subdomain); }
  int number_patch(const Surface_patch_index& patch) { return patches_.number(patch); }
  int number_curve(const Curve_index& curve) { return curves_.number(curve); }

  const Subdomain_index& subdomain(int label) const { return subdomains_.value(label); }
  const Surface_patch_index& patch(int number) const { return patches_.value(number); }
  const Curve_index& curve(int number) const { return curves_.value(number); }

  // The index of points on the patch.
  Index index(int patch_number) const { return domain_.index_from_surface_patch_index(patch(patch_number)); }

  // The index of points on a curve, on a patch, or in a subdomain.
  Index index(int dimension, int place) const
  {
    if constexpr (Has_facets_of_mesh<Mesh_domain>::value)
      if(dimension == 1)
        return domain_.index_from_curve_index(curve(place));
    CGAL_assertion(dimension > 1);
    return dimension == 3 ? domain_.index_from_subdomain_index(subdomain(place)) : index(place);
  }

  // The patch of a point with that index, on a surface. In a mesh that the mesh generator has not made, the index need not be
  // that of a patch.
  int patch_at(const Index& index) const
  {
    try
    {
      return patches_.number_or(domain_.surface_patch_index(index), other_patch);
    }
    catch(const boost::bad_get&) {}
    catch(const std::bad_variant_access&) {}
    return other_patch;
  }

  int label(const Vector& p) const override
  {
    const auto s = domain_.is_in_domain_object()(point(p));
    return s ? subdomains_.number_or(Subdomain_index(*s), other_subdomain) : outside;
  }

protected:
  bool find_intersection(const Vector& from, const Vector& to, Vector& p, int& patch) const override
  {
    const Segment_3 s(point(from), point(to));
    if(!may_intersect(s))
      return false;
    const typename Mesh_domain::Intersection i = domain_.construct_intersection_object()(s);
    if(std::get<2>(i) < 2)
      return false;
    p = coordinates(std::get<0>(i));
    patch = patch_at(std::get<1>(i));
    return true;
  }

  Vector closest_point(const Vector& p, int& patch) const override
  {
    if constexpr (Has_aabb_tree<Mesh_domain>::value)
    {
      const auto closest = domain_.aabb_tree().closest_point_and_primitive(point(p));
      patch = patches_.number_or(domain_.make_surface_index(closest.second), other_patch);
      return coordinates(closest.first);
    }
    else
    {
      patch = other_patch;
      return p;
    }
  }

private:
  typedef typename Mesh_domain::Point_3 Point_3;
  typedef typename Kernel_traits<Point_3>::Kernel::Segment_3 Segment_3;

  static Point_3 point(const Vector& p) { return Point_3(p[0], p[1], p[2]); }

  // Versions of Mesh_3 that ask the predicate first have domains that rely on it.
  bool may_intersect([[maybe_unused]] const Segment_3& s) const
  {
#ifdef CGAL_MESH_3_NO_LONGER_CALLS_DO_INTERSECT_3
    return true;
#else
    return bool(domain_.do_intersect_surface_object()(s));
#endif
  }

  const Mesh_domain& domain_;
  Index_table<Subdomain_index> subdomains_;
  Index_table<Surface_patch_index> patches_;
  Index_table<Curve_index> curves_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_MESH_DOMAIN_VIEW_3_H
