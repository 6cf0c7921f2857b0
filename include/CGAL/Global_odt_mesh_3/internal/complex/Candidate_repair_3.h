// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CANDIDATE_REPAIR_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CANDIDATE_REPAIR_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Defect_report_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Vertex_moves_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Moves interior vertices away from a surface to which they are too close. A vertex that retreats in vain, as between surfaces that
// have come close to each other, goes where there is most room in its subdomain.
class Candidate_retreat_3
{
public:
  Candidate_retreat_3(Complex_candidate_3& candidate, const Domain_view_3& domain)
    : candidate_(candidate)
    , domain_(domain)
  {}

  // Changes only the sites; the triangulation stays.
  void move(const std::map<int, Vector_3>& displacements)
  {
    std::vector<std::pair<int, int> > crowded;
    for(const auto& d : displacements)
    {
      Site& s = candidate_.sites[d.first];
      s = site_at(position(s) + d.second, s.weight);
      const int times = ++times_retreated_[d.first];
      if(times > most_retreats)
        crowded.emplace_back(-times, d.first);
    }
    std::sort(crowded.begin(), crowded.end());
    // Once a vertex has gone, there may be room for its neighbors.
    std::set<int> around;
    for(const auto& c : crowded)
      if(around.count(c.second) == 0)
      {
        const std::vector<int> neighbors = candidate_.triangulation.neighbors(c.second);
        around.insert(neighbors.begin(), neighbors.end());
        leave(c.second);
      }
  }

private:
  static constexpr int most_retreats = 4;
  static constexpr double share_of_room = 0.7;          // of the radius of a cell, from its dual point to the surface

  // A place for a vertex, in a cell.
  struct Place
  {
    double squared_radius;
    Vector_3 point;
    Quadruple vertices;
  };

  // Moves the vertex into the largest cell that shares no vertex with a cell taken before.
  void leave(int v)
  {
    const int label = candidate_.numbering.subdomain[v];
    const auto found = places_.find(label);
    std::vector<Place>& places = found != places_.end() ? found->second : places_[label] = places_in(label);
    while(!places.empty())
    {
      const Place p = places.back();
      places.pop_back();
      if(std::any_of(p.vertices.begin(), p.vertices.end(), [this](int w) { return taken_.count(w) > 0; }))
        continue;
      taken_.insert(p.vertices.begin(), p.vertices.end());
      candidate_.sites[v] = site_at(p.point, candidate_.sites[v].weight);
      times_retreated_[v] = 0;
      return;
    }
  }

  // The places in a subdomain, in ascending order of their room.
  std::vector<Place> places_in(int label) const
  {
    std::vector<Place> result;
    const Labelled_triangulation_3& triangulation = candidate_.triangulation;
    for(int c : triangulation.cells())
    {
      const Quadruple q = sorted(triangulation.vertices(c));
      if(triangulation.label(c) != label || q[0] < 0)
        continue;
      // The candidate's sites have moved already; those of the triangulation have not.
      const auto site = [&](int i) { return triangulation.sites()[q[i]]; };
      const Vector_3 to_dual = Cell_products(site(0), site(1), site(2), site(3)).to_dual(), dual = position(site(0)) + to_dual;
      const double squared_radius = to_dual.squared_length();
      if(has_room(dual, label, share_of_room * std::sqrt(squared_radius)))
        result.push_back({ squared_radius, dual, q });
    }
    std::sort(result.begin(), result.end(), [](const Place& a, const Place& b)
              { return a.squared_radius != b.squared_radius ? a.squared_radius < b.squared_radius : a.vertices < b.vertices; });
    return result;
  }

  // Whether a point and those at this distance along the axes are in the subdomain.
  bool has_room(const Vector_3& p, int label, double distance) const
  {
    bool result = domain_.label(p) == label;
    for(int i = 0; i < 6 && result; ++i)
    {
      Vector_3 way;
      way[i / 2] = i % 2 == 0 ? distance : -distance;
      result = domain_.label(p + way) == label;
    }
    return result;
  }

  Complex_candidate_3& candidate_;
  const Domain_view_3& domain_;
  std::map<int, int> times_retreated_;
  std::map<int, std::vector<Place> > places_;           // by label; those not used yet
  std::set<int> taken_;                                 // vertices of cells that a vertex has moved into
};

// Moves vertices of a candidate where something is wrong: elsewhere, or toward where they were.
class Candidate_repair_3
{
public:
  // `rebuild()` rebuilds the triangulation of the candidate.
  Candidate_repair_3(Complex_candidate_3& candidate, const Domain_view_3& domain, std::function<void()> rebuild)
    : candidate_(candidate)
    , domain_(domain)
    , rebuild_(std::move(rebuild))
    , retreat_(candidate, domain)
  {}

  // False if nothing can be done.
  bool apply(const Defect_report_3& report, int attempt)
  {
    const std::map<int, Vector_3>& retreats = report.retreats();
    if(report.is_beyond_repair() && (candidate_.has_way_back || retreats.empty()) && report.weights().empty())
      return false;
    for(int v : report.offending_vertices())
      if(candidate_.is_reverted(v))
        candidate_.revert_to_input(v);
    const std::set<int> offending = offending_vertices(report, attempt);
    retreat_.move(retreats);
    for(int v : offending)
      if(candidate_.numbering.is_movable(v) && !candidate_.is_reverted(v) && retreats.count(v) == 0)
        revert(v, attempt);
    for(const auto& w : report.weights())
    {
      candidate_.sites[w.first].weight += w.second;
      candidate_.revert_sites[w.first].weight += w.second;
    }
    if(!report.weights().empty() || !move_vertices(candidate_.sites, candidate_.triangulation))
      rebuild_();
    const auto has_moved = [&](int v) { return offending.count(v) > 0 || retreats.count(v) > 0; };
    for(auto it = candidate_.known_distances.begin(); it != candidate_.known_distances.end(); )
      it = std::any_of(it->first.begin(), it->first.end(), has_moved) ? candidate_.known_distances.erase(it) : std::next(it);
    candidate_.measure();
    return true;
  }

private:
  // During the patient attempts, vertices first go back half way; later they revert, along with more and more neighbors.
  static constexpr int patient_attempts = 10, attempts_per_ring = 3;
  static constexpr int halfway_returns = 2, halfway_returns_on_surface = 1;

  // The offending vertices of the report and, in later attempts, those around them.
  std::set<int> offending_vertices(const Defect_report_3& report, int attempt) const
  {
    Vertex_rings_3 region(candidate_.triangulation, report.offending_vertices());
    for(int ring = patient_attempts; ring <= attempt; ring += attempts_per_ring)
      region.grow();
    return std::set<int>(region.vertices().begin(), region.vertices().end());
  }

  void revert(int v, int attempt)
  {
    const bool on_surface = !candidate_.numbering.is_interior(v);
    const int most = on_surface ? halfway_returns_on_surface : halfway_returns;
    const bool is_halfway = attempt < patient_attempts && candidate_.times_reverted[v]++ < most;
    Site& s = candidate_.sites[v];
    const Site& home = candidate_.revert_sites[v];
    s = is_halfway ? site_at((position(s) + position(home)) / 2, home.weight) : home;
    if(on_surface && is_halfway && !put_on_surface(candidate_, domain_, v))
      s = home;
  }

  Complex_candidate_3& candidate_;
  const Domain_view_3& domain_;
  std::function<void()> rebuild_;
  Candidate_retreat_3 retreat_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CANDIDATE_REPAIR_3_H
