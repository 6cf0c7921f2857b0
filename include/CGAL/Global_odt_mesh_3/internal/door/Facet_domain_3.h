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
#include <CGAL/Kernel_traits.h>
#include <CGAL/Kernel/global_functions.h>
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
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

#if __has_include(<CGAL/AABB_traits_3.h>)
template <class Kernel, class Iterator>
using Triangle_tree = AABB_tree<AABB_traits_3<Kernel, AABB_triangle_primitive_3<Kernel, Iterator> > >;

template <class Kernel, class Primitive>
using Tree_traits = AABB_traits_3<Kernel, Primitive>;
#else
template <class Kernel, class Iterator>
using Triangle_tree = AABB_tree<AABB_traits<Kernel, AABB_triangle_primitive<Kernel, Iterator> > >;

template <class Kernel, class Primitive>
using Tree_traits = AABB_traits<Kernel, Primitive>;
#endif

#if CGAL_VERSION_NR < 1060000000
template <class T> using Optional_index = boost::optional<T>;
#else
template <class T> using Optional_index = std::optional<T>;
#endif

// A cell of a mesh in an AABB tree.
template <class Kernel>
class Tetrahedron_primitive_3
{
public:
  typedef typename std::vector<typename Kernel::Tetrahedron_3>::const_iterator Id;
  typedef typename Kernel::Point_3 Point;
  typedef typename Kernel::Tetrahedron_3 Datum;
  typedef const Datum& Datum_reference;
  typedef const Point& Point_reference;

  Tetrahedron_primitive_3(Id id) : id_(id) {}

  Id id() const { return id_; }
  Datum_reference datum() const { return *id_; }
  Point_reference reference_point() const { return (*id_)[0]; }

private:
  Id id_;
};

// The domain that is made of the cells of a complex, and divided by its facets, without features.
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
        add_facet<typename C3t3::Triangulation>(*f, c3t3.surface_patch_index(*f));
      else
        CGAL_GLOBAL_ODT_MESH_3_CHECK_PARAMETER(
          f->first->subdomain_index() == f->first->neighbor(f->second)->subdomain_index(),
          "c3t3 must have all facets between two subdomains in its complex: call complete_mesh_complex_3() before");
    for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    {
      const auto vertex = [&](int i) { return c->vertex(i)->point().point(); };
      cells_.emplace_back(vertex(0), vertex(1), vertex(2), vertex(3));
      subdomains_.push_back(c->subdomain_index());
    }
    cell_tree_.rebuild(cells_.cbegin(), cells_.cend());
    cell_tree_.build();
    tree_.rebuild(triangles_.cbegin(), triangles_.cend());
    // The tree is built here, and not when the first thread asks.
    if(!triangles_.empty())
      tree_.accelerate_distance_queries();
  }

  Bbox_3 bbox() const { return triangles_.empty() ? Bbox_3() : tree_.bbox(); }
  const AABB_tree& aabb_tree() const { return tree_; }
  const Surface_patch_index& make_surface_index(AABB_primitive_id id) const { return patch(id); }

  // Points on a facet are in a subdomain beside it, if there is one.
  struct Is_in_domain
  {
    const Facet_domain_3& domain;

    Subdomain operator()(const Point_3& p) const
    {
      const auto cell = domain.cell_tree_.any_intersected_primitive(p);
      return cell ? Subdomain(domain.subdomains_[static_cast<std::size_t>(*cell - domain.cells_.cbegin())]) : Subdomain();
    }
  };

  struct Do_intersect_surface
  {
    const Facet_domain_3& domain;

    // The intersection with a segment, a ray, or a line.
    template <class Query>
    Surface_patch operator()(const Query& query) const
    {
      const auto id = domain.tree_.any_intersected_primitive(query);
      return id ? Surface_patch(domain.patch(*id)) : Surface_patch();
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
      return Intersection(R().construct_projected_point_3_object()(t, p), Index(domain.patch(*id)), 2);
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
        *points++ = std::make_pair(CGAL::centroid(domain.triangles_[f]), Index(domain.patches_[f]));
      }
      return points;
    }
  };

  Is_in_domain is_in_domain_object() const { return { *this }; }
  Do_intersect_surface do_intersect_surface_object() const { return { *this }; }
  Construct_intersection construct_intersection_object() const { return { *this }; }
  Construct_initial_points construct_initial_points_object() const { return { *this }; }

private:
  typedef CGAL::AABB_tree<Tree_traits<R, Tetrahedron_primitive_3<R> > > Cell_tree;

  const Surface_patch_index& patch(AABB_primitive_id id) const { return patches_[static_cast<std::size_t>(id - triangles_.cbegin())]; }

  template <class Triangulation>
  void add_facet(const typename Triangulation::Facet& f, const Surface_patch_index& patch)
  {
    const auto vertex = [&](int k) { return f.first->vertex(Triangulation::vertex_triple_index(f.second, k))->point().point(); };
    triangles_.emplace_back(vertex(0), vertex(1), vertex(2));
    patches_.push_back(patch);
  }

  Triangles triangles_;
  std::vector<Surface_patch_index> patches_;
  AABB_tree tree_;
  std::vector<typename R::Tetrahedron_3> cells_;
  std::vector<Subdomain_index> subdomains_;
  Cell_tree cell_tree_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_DOOR_FACET_DOMAIN_3_H
