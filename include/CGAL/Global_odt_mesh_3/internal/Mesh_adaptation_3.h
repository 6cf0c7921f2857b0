// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_ADAPTATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_ADAPTATION_3_H

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_updater_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Edge_splitting_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Snapshot_reader_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Tabulated_mesh_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Vertex_edits_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Sliver_edits_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The lengths that edges should have: as long as those around are on average, or shorter near short feature edges, with
// which they grow as sqrt(h^2 + K^2 d^2) where d is the distance from an end of a feature edge of length h.
class Graded_length_3
{
public:
  Graded_length_3(const Moving_triangulation_3& mesh, const std::vector<std::array<int, 2> >& feature_edges)
    : sites_(mesh.sites)
    , source_(mesh.sites.size(), none)
    , feature_length_(mesh.sites.size(), (std::numeric_limits<double>::infinity)())
  {
    mesh.mean_edge_lengths(static_cast<int>(mesh.sites.size()), mean_);
    // Edges off the cells of the complex have no length that they should have.
    std::replace(mean_.begin(), mean_.end(), 0., (std::numeric_limits<double>::infinity)());
    std::vector<std::vector<int> > neighbors(mesh.sites.size());
    mesh.for_each_edge([&](int u, int v, double)
    {
      neighbors[u].push_back(v);
      neighbors[v].push_back(u);
    });
    for(const std::array<int, 2>& e : feature_edges)
      for(int v : e)
      {
        source_[v] = v;
        feature_length_[v] = (std::min)(feature_length_[v], (position(sites_[e[0]]) - position(sites_[e[1]])).norm());
      }
    find_sources(neighbors);
  }

  // At the middle of an edge.
  double operator()(int u, int v) const
  {
    const Eigen::Vector3d p = (position(sites_[u]) + position(sites_[v])) / 2;
    return (std::min)({ share_of_mean * (std::max)(mean_[u], mean_[v]), graded(source_[u], p), graded(source_[v], p) });
  }

  // For a vertex that is inserted into an edge.
  void add(const Site& s, int u, int v)
  {
    sites_.push_back(s);
    mean_.push_back((std::min)(mean_[u], mean_[v]));
    source_.push_back(graded(source_[u], position(s)) < graded(source_[v], position(s)) ? source_[u] : source_[v]);
  }

private:
  // K decides on how many vertices come, and how good cells get: couplingdown of CGAL's data ends with 9269, 8802, 8605 vertices
  // and a mean 3r/R of .8405, .8345, .8305 for K = .47, .5, .52.
  static constexpr double share_of_mean = 1.3, share_of_feature_edge = 1.3, gradation = 0.48;
  static constexpr int none = -1;

  double graded(int source, const Eigen::Vector3d& p) const
  {
    return source == none ? (std::numeric_limits<double>::infinity)()
                          : std::hypot(share_of_feature_edge * feature_length_[source], gradation * (position(sites_[source]) - p).norm());
  }

  // By Dijkstra's algorithm: the one of a neighbor that asks for least.
  void find_sources(const std::vector<std::vector<int> >& neighbors)
  {
    typedef std::pair<double, int> Reached;
    std::vector<double> least(sites_.size(), (std::numeric_limits<double>::infinity)());
    std::priority_queue<Reached, std::vector<Reached>, std::greater<Reached> > next;
    const auto reach = [&](int v, int source)
    {
      const double length = graded(source, position(sites_[v]));
      if(!(length < least[v]))
        return;
      least[v] = length;
      source_[v] = source;
      next.push({ length, v });
    };
    for(int v = 0; v < static_cast<int>(source_.size()); ++v)
      if(source_[v] == v)
        reach(v, v);
    while(!next.empty())
    {
      const Reached r = next.top();
      next.pop();
      if(r.first == least[r.second])
        for(int w : neighbors[r.second])
          reach(w, source_[r.second]);
    }
  }

  std::vector<Site> sites_;
  std::vector<double> mean_;              // of the edges at vertices
  std::vector<int> source_;               // the vertices on features that ask for least, or none
  std::vector<double> feature_length_;    // at vertices on features, the shortest
};

// Inserts vertices into a mesh, or removes them, as a stage of its own.
class Mesh_adaptation_3
{
public:
  // Refers to its arguments.
  Mesh_adaptation_3(Tabulated_mesh_3& mesh, const Domain_view_3& domain, Boundary_motion motion, const Thread_policy& threads)
    : mesh_(mesh)
    , complex_(domain, motion, false, threads)
  {
    complex_.start(Snapshot_reader_3(mesh, threads).read(indexed_, motion != Boundary_motion::NONE));
  }

  // Into edges that are long, in view of those around and on features.
  template <class Predicate>
  void split_edges(const Predicate& may_go_on)
  {
    const std::vector<int>& in_table = complex_.snapshot().numbering->input_numbers;
    std::vector<int> number(mesh_.table().sites.size());
    for(std::size_t v = 0; v < in_table.size(); ++v)
      number[in_table[v]] = static_cast<int>(v);
    std::vector<std::array<int, 2> > feature_edges = mesh_.feature_edges();
    for(std::array<int, 2>& e : feature_edges)
      e = {{ number[e[0]], number[e[1]] }};
    Graded_length_3 wanted(indexed_, feature_edges);
    Vertex_edits_3 edits = complex_.make_edits();
    Edge_splitting_3(edits).run(wanted, may_go_on);
    store(edits);
  }

  // Where that makes the small angles of cells larger; whether there are such places.
  template <class Predicate>
  bool edit_slivers(bool inserts, bool removes, int step, unsigned int seed, const Predicate& may_go_on)
  {
    Vertex_edits_3 edits = complex_.make_edits();
    Sliver_edits_3(edits, inserts, removes, seed).run(step, may_go_on);
    return store(edits);
  }

private:
  // Whether something has changed.
  bool store(Vertex_edits_3& edits)
  {
    const std::optional<Mesh_table_3> table = edits.has_changed() ? edits.table() : std::nullopt;
    if(table)
      mesh_.write(*table);
    return table.has_value();
  }

  Tabulated_mesh_3& mesh_;
  Moving_triangulation_3 indexed_;
  Complex_updater_3 complex_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_ADAPTATION_3_H
