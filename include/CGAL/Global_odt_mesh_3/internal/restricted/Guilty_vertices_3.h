// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_GUILTY_VERTICES_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_GUILTY_VERTICES_3_H

#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_draft_3.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <iterator>
#include <map>
#include <set>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The vertices that keep a draft from being a valid complex: offenders, which are to
// go back toward where they were, and others that are to be pushed somewhere else.
template <class Triangulation, class Mesh_domain>
class Guilty_vertices_3
{
public:
  typedef Restricted_draft_3<Triangulation, Mesh_domain> Draft;
  typedef std::array<double, 3> Vector;

  explicit Guilty_vertices_3(const Draft& draft)
    : draft_(draft)
  {}

  // For a new draft.
  void start()
  {
    strikes_.clear();
    number_of_pushes_.clear();
  }

  // For a new look at the draft.
  void clear()
  {
    offenders_.clear();
    pushes_.clear();
    is_hopeless_ = false;
  }

  // Whether nothing has been found wrong, not even something that nobody can be blamed for.
  bool is_empty() const { return offenders_.empty() && pushes_.empty() && !is_hopeless_; }
  bool is_hopeless() const { return is_hopeless_; }

  const std::set<int>& offenders() const { return offenders_; }
  const std::map<int, Vector>& pushes() const { return pushes_; }
  bool is_offender(int v) const { return offenders_.count(v) > 0; }

  // Collects displaced vertices among these; whether there are any.
  template <class Vertices>
  bool blame_displaced(const Vertices& vertices)
  {
    bool found = false;
    for(int v : vertices)
      if(draft_.is_movable(v) && !draft_.is_home(v))
      {
        offenders_.insert(v);
        found = true;
      }
    return found;
  }

  // Collects displaced vertices among these or, if there are none, around them.
  template <class Vertices>
  void blame(const Vertices& vertices)
  {
    std::set<int> region(vertices.begin(), vertices.end());
    region.erase(-1);
    for(int ring = 0; ring < 6; ++ring)
    {
      if(blame_displaced(region))
        return;
      draft_.numbered.grow(region);
    }
    is_hopeless_ = true;
  }

  void blame(std::initializer_list<int> vertices) { blame(std::vector<int>(vertices)); }

  void give_up() { is_hopeless_ = true; }

  // Blames the neighbors of the offenders, too.
  void grow_offenders() { draft_.numbered.grow(offenders_); }

  // Counts, and says, how often the vertex has been sent back before.
  int add_strike(int v) { return strikes_[v]++; }

  int number_of_strikes(int v) const
  {
    const auto it = strikes_.find(v);
    return it == strikes_.end() ? 0 : it->second;
  }

  // How often the vertex has been pushed.
  int number_of_pushes(int v) const
  {
    const auto it = number_of_pushes_.find(v);
    return it == number_of_pushes_.end() ? 0 : it->second;
  }

  void push(int v, const Vector& by)
  {
    if(pushes_.emplace(v, by).second)
      ++number_of_pushes_[v];
  }

  // What the domain has said of facets holds as long as their vertices stay where they are.
  template <class Answers>
  void erase_from(Answers& answers) const
  {
    for(auto it = answers.begin(); it != answers.end(); )
    {
      const bool stale = std::any_of(it->first.begin(), it->first.end(),
                                     [this](int v) { return is_offender(v) || pushes_.count(v) > 0; });
      it = stale ? answers.erase(it) : std::next(it);
    }
  }

private:
  const Draft& draft_;
  std::set<int> offenders_;
  std::map<int, Vector> pushes_;
  bool is_hopeless_ = false;
  std::map<int, int> strikes_, number_of_pushes_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_GUILTY_VERTICES_3_H
