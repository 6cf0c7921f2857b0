// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_WANTED_LENGTH_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_WANTED_LENGTH_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/User_field_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The lengths that edges of a mesh should have: in proportion to those around, or to a size that is wanted; or less near short
// feature edges, with which they grow as sqrt(h^2 + K^2 d^2) where d is the distance from an end of a feature edge of length h.
class Wanted_length_3
{
public:
  // What the lengths of edges are in proportion to, at a vertex, also at one that the user's mesh has not got; or empty for the
  // mean lengths of the mesh.
  typedef User_field_3::Function Size;

  // The labels of vertices between subdomains; empty for others.
  typedef std::vector<std::vector<int> > Labels;

  // The vertices have strata.
  template <class Stratum>
  Wanted_length_3(const Moving_triangulation_3& mesh, const std::vector<std::array<int, 2> >& feature_edges, const Size& size,
                  const Stratum& stratum, Labels labels)
    : sites_(mesh.sites)
    , size_(size)
    , labels_(std::move(labels))
    , source_(mesh.sites.size(), none)
    , feature_length_(mesh.sites.size(), infinity)
  {
    mesh.mean_edge_lengths(static_cast<int>(mesh.sites.size()), mean_);
    // Edges off the cells of the complex have no length that they should have.
    std::replace(mean_.begin(), mean_.end(), 0., infinity);
    for(int v = 0; v < static_cast<int>(mean_.size()); ++v)
      length_.push_back(!size_ || mean_[v] == infinity ? mean_[v] : least_size(stratum(v), sites_[v], labels_[v]));
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
        feature_length_[v] = (std::min)(feature_length_[v], (position(sites_[e[0]]) - position(sites_[e[1]])).length());
      }
    find_sources(neighbors);
  }

  // How many vertices a mesh of these lengths has.
  double number_of_vertices() const
  {
    double number = 0;
    for(std::size_t v = 0; v < mean_.size(); ++v)
      number += mean_[v] == infinity ? 1 : std::pow(mean_[v] / length_[v], 3);
    return number;
  }

  void scale(double factor)
  {
    scale_ *= factor;
    for(double& l : length_)
      l *= factor;
  }

  // The wanted length at the middle of an edge.
  double operator()(int u, int v) const
  {
    const Vector_3 p = (position(sites_[u]) + position(sites_[v])) / 2;
    return (std::min)({ (std::max)(length_[u], length_[v]), graded(source_[u], p), graded(source_[v], p) });
  }

  // Adds what a vertex needs that is inserted into an edge.
  void add(const Vertex_stratum& stratum, const Site& s, int u, int v)
  {
    sites_.push_back(s);
    labels_.emplace_back();
    if(stratum.dimension < 3)
      std::set_intersection(labels_[u].begin(), labels_[u].end(), labels_[v].begin(), labels_[v].end(),
                            std::back_inserter(labels_.back()));
    length_.push_back(size_ ? scale_ * least_size(stratum, s, labels_.back()) : (length_[u] + length_[v]) / 2);
    source_.push_back(graded(source_[u], position(s)) < graded(source_[v], position(s)) ? source_[u] : source_[v]);
  }

private:
  // A smaller gradation leads to more vertices and better cells. CONTRIBUTING.md has measurements.
  static constexpr double share_of_feature_edge = 1.3, gradation = 0.48;
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();
  static constexpr int none = -1;

  // The least of those in the subdomains around.
  double least_size(const Vertex_stratum& stratum, const Site& s, const std::vector<int>& labels) const
  {
    double least = size_(stratum, s);
    for(int l : labels)
      least = (std::min)(least, size_(Vertex_stratum::inside(l), s));
    return least;
  }

  double graded(int source, const Vector_3& p) const
  {
    return source == none ? infinity : std::hypot(share_of_feature_edge * feature_length_[source],
                                                  gradation * (position(sites_[source]) - p).length());
  }

  // Finds, by Dijkstra's algorithm, the source of each vertex: that of the neighbor that asks for the least length.
  void find_sources(const std::vector<std::vector<int> >& neighbors)
  {
    typedef std::pair<double, int> Reached;
    std::vector<double> least(sites_.size(), infinity);
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
  Size size_;
  Labels labels_;
  double scale_ = 1;
  std::vector<double> mean_, length_;     // of the edges at vertices, as they are and as they should be
  std::vector<int> source_;               // the vertices on features that ask for least, or none
  std::vector<double> feature_length_;    // at vertices on features, the shortest
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SIZING_WANTED_LENGTH_3_H
