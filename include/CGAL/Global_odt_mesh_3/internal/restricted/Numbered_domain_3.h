// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_NUMBERED_DOMAIN_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_NUMBERED_DOMAIN_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Index_table.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Collect_in_chunks.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/For_each_in_chunks.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Domain_oracle_3.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The domain, with numbers for subdomains (labels) and surface patches.
template <class Triangulation_, class Mesh_domain>
class Numbered_domain_3
{
public:
  typedef Triangulation_ Triangulation;
  typedef typename Triangulation::Bare_point Bare_point;
  typedef typename Mesh_domain::Index Index;
  typedef typename Mesh_domain::Subdomain_index Subdomain_index;
  typedef typename Mesh_domain::Surface_patch_index Surface_patch_index;
  typedef Eigen::Vector3d Vector;

  // Whether it has an AABB tree, which makes closest points cheap.
  static constexpr bool tells_distances = Has_aabb_tree<Mesh_domain>::value;

  // Threads may ask the domain at the same time if they are given.
  explicit Numbered_domain_3(const Mesh_domain& domain, const Thread_policy& threads = Thread_policy())
    : oracle_(domain)
    , threads_(threads)
    , outside_(labels_.number(Subdomain_index()))
  {}

  int outside() const { return outside_; }
  int label(const Subdomain_index& subdomain) { return labels_.number(subdomain); }
  bool has_label(const Subdomain_index& subdomain) const { return labels_.has(subdomain); }
  // Of a subdomain that has one.
  int known_label(const Subdomain_index& subdomain) const { return labels_.number_of_known(subdomain); }
  const Subdomain_index& subdomain(int label) const { return labels_.value(label); }
  int patch_number(const Surface_patch_index& patch) { return patches_.number(patch); }
  const Surface_patch_index& patch(int number) const { return patches_.value(number); }

  // Calls f(n) for the numbers n below `size`, on threads if these may ask the domain. There, f may call what
  // follows up to statistics(), and what is const.
  template <class F>
  void for_each(std::size_t size, const F& f) const
  {
    for_each_in_chunks(static_cast<int>(size), threads_, f, least_questions);
  }

  // In the same way, collects what f(n, found) appends, in the order of the numbers.
  template <class T, class F>
  std::vector<T> collect(std::size_t size, const F& f) const
  {
    return collect_in_chunks<T>(static_cast<int>(size), threads_, f, least_questions);
  }

  // Those that may ask the domain.
  const Thread_policy& threads() const { return threads_; }

  // As those of the oracle.
  Subdomain_index subdomain_at(const Bare_point& p) { return oracle_.subdomain(p); }
  bool project(Vector& p, const Vector& normal, double reach, int patch_number)
  { return oracle_.project(p, normal, reach, patch(patch_number)); }
  bool intersect(Vector& p, const Vector& direction, double half_length, Index& index)
  { return oracle_.intersect(p, direction, half_length, index); }
  double distance_to_surface(const Vector& p) { return oracle_.distance_to_surface(p); }

  const Oracle_statistics& statistics() const { return oracle_.statistics(); }

  // The label of the subdomain in which the point lies.
  int label_at(const Bare_point& p) { return label(oracle_.subdomain(p)); }

  // Whether that is the index of points on the patch.
  bool is_on_patch(const Index& index, int patch_number) const { return index == oracle_.index(patch(patch_number)); }

  // The patch of a point that intersect() has found.
  int patch_at(const Index& index) { return patch_number(oracle_.surface_patch(index)); }

private:
  static constexpr int least_questions = 64;      // that are worth the trouble of a thread

  Domain_oracle_3<Mesh_domain> oracle_;
  Thread_policy threads_;
  Index_table<Subdomain_index> labels_;
  Index_table<Surface_patch_index> patches_;
  int outside_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_NUMBERED_DOMAIN_3_H
