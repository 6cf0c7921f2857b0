// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_KEPT_SITES_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_KEPT_SITES_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>

#include <CGAL/assertions.h>

#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Sites as they were, next to those on trial. Nothing is copied that is written anyway: sites that move change places
// with those that were kept before.
class Kept_sites
{
public:
  const Site& operator[](int v) const
  {
    CGAL_assertion(v < static_cast<int>(sites_.size()));
    return sites_[v];
  }

  // The current ones are to be kept. From then on, they change by move(), or after prepare_changes().
  void keep() { are_current_ = true; }

  void restore(std::vector<Site>& sites)
  {
    if(!are_current_)
      sites.swap(sites_);
    are_current_ = true;
  }

  void prepare_changes(const std::vector<Site>& sites)
  {
    if(are_current_)
      sites_ = sites;
    are_current_ = false;
  }

  // Calls place(v, site), which may change the site, for the first ones.
  template <class Place>
  void move(std::vector<Site>& sites, int number_to_move, const Thread_policy& threads, const Place& place)
  {
    if(are_current_)
    {
      sites_.resize(sites.size());
      sites_.swap(sites);
    }
    const std::vector<Site>& from = are_current_ ? sites_ : sites;
    are_current_ = false;
    const Chunks chunks(static_cast<int>(sites.size()), least_sites, most_chunks);
    threads.for_each_chunk(chunks.number(), [&](int n)
    {
      for(int v = chunks.begin(n); v < chunks.end(n); ++v)
      {
        Site s = from[v];
        if(v < number_to_move)
          place(v, s);
        sites[v] = s;
      }
    });
  }

private:
  // A chunk is to be worth the trouble of a thread.
  static constexpr int least_sites = 4000, most_chunks = 16;

  std::vector<Site> sites_;
  bool are_current_ = false;      // that is, the current ones have not been copied yet
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_TRIANGULATION_KEPT_SITES_H
