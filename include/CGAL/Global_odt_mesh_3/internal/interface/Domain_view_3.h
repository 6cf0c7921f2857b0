// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_INTERFACE_DOMAIN_VIEW_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_INTERFACE_DOMAIN_VIEW_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The domain of the user, whatever its type, with numbers for subdomains (labels) and surface patches: those that the mesh
// has, and one for all others, in which no cell and on which no facet of a valid mesh can be.
//
// Several threads may ask at once if the domain permits that.
class Domain_view_3
{
public:
  typedef Vector_3 Vector;

  static constexpr int outside = 0;
  static constexpr int other_subdomain = (std::numeric_limits<int>::max)(), other_patch = other_subdomain;

  virtual ~Domain_view_3() {}

  // Whether closest points are cheap: where there is an AABB tree, it projects.
  bool tells_distances() const { return has_tree_; }

  // The threads that may query the domain.
  const Thread_policy& threads() const { return threads_; }

  // Calls f(n) for the numbers n below `size`, on threads if these may query the domain.
  template <class F>
  void for_each(std::size_t size, const F& f) const
  {
    for_each_in_chunks(static_cast<int>(size), threads_, f, least_questions);
  }

  // Collects what f(n, found) appends, in the same way, in the order of the numbers.
  template <class T, class F>
  std::vector<T> collect(std::size_t size, const F& f) const
  {
    return collect_in_chunks<T>(static_cast<int>(size), threads_, f, least_questions);
  }

  // The label of the subdomain in which the point lies.
  virtual int label(const Vector& p) const = 0;

  // Whether the mesh is its own domain. Then no cell passes through the surface, which need not be sampled well enough for a restricted
  // Delaunay triangulation, and the centroid of a cell tells its subdomain as well as the dual point does.
  bool has_cells_of_mesh() const { return has_cells_of_mesh_; }
  void set_cells_of_mesh() { has_cells_of_mesh_ = true; }

  // Moves `p` to the surface patch, by the closest point or along the normal, at
  // most as far as `reach`; false if there is no such point.
  bool project(Vector& p, const Vector& normal, double reach, int patch) const
  {
    Vector q = p;
    int found;
    if(has_tree_)
    {
      q = closest_point(p, found);
      if((p - q).length() > reach)
        return false;
    }
    // Short segments are cut faster, and rarely at another sheet of the surface.
    else if(!intersect(q, normal, reach / 4, found) && !intersect(q, normal, reach, found))
      return false;
    if(found != patch || patch == other_patch)
      return false;
    p = q;
    return true;
  }

  // Moves `p` to the closest point of the surface, where there is a tree.
  void put_on_surface(Vector& p, int& patch) const { p = closest_point(p, patch); }

  // How far `p` is from the surface, if that is easily found out, or else 0.
  double distance_to_surface(const Vector& p) const
  {
    int patch;
    return has_tree_ ? (p - closest_point(p, patch)).length() : 0;
  }

  // Moves `p` to where the segment of that half length and direction around it
  // meets the surface, and tells on which patch.
  bool intersect(Vector& p, const Vector& direction, double half_length, int& patch) const
  {
    const Vector from = p - half_length * direction, to = p + half_length * direction;
    // The dual segment of cospherical cells is a point, which domains do not expect.
    return (to - from).length() > 0 && find_intersection(from, to, p, patch);
  }

protected:
  Domain_view_3(bool has_tree, const Thread_policy& threads)
    : has_tree_(has_tree)
    , threads_(threads)
  {}

private:
  static constexpr int least_questions = 64;      // that are worth the trouble of a thread

  virtual bool find_intersection(const Vector& from, const Vector& to, Vector& p, int& patch) const = 0;
  // This is called only if there is a tree.
  virtual Vector closest_point(const Vector& p, int& patch) const = 0;

  bool has_tree_, has_cells_of_mesh_ = false;
  Thread_policy threads_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_INTERFACE_DOMAIN_VIEW_3_H
