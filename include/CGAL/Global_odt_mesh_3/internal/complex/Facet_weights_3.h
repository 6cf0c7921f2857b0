// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_FACET_WEIGHTS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_FACET_WEIGHTS_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Facet_spheres_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Finds weights for vertices that stay, with which given facets belong to their regular triangulation. The weights satisfy linear
// inequalities: Newton's method minimizes the sum of the squared violations, which is convex and piecewise quadratic (Mangasarian,
// A finite Newton method for classification, 2002).
class Facet_weights_3
{
public:
  Facet_weights_3(const Complex_candidate_3& candidate, const std::vector<Triple>& facets)
    : candidate_(candidate)
    , sites_(candidate.sites)
  {
    for(const Triple& f : facets)
      spheres_.emplace_back(candidate, f);
  }

  // The weights that vertices gain. They leave the facets as much margin as possible, so that weights may change later; empty if
  // there are no such weights.
  std::map<int, double> gains()
  {
    std::map<int, double> result;
    for(margin_ = least_margin; margin_ < largest_margin && find(); margin_ *= 4)
    {
      std::map<int, double> gained = permitted_gains();
      if(gained.empty())
        break;
      result = std::move(gained);
    }
    return result;
  }

private:
  static constexpr double least_margin = 2 * Facet_spheres_3::least_margin, largest_margin = 0.02;
  static constexpr double largest_share = 2;          // of the weight that a vertex may have by itself
  static constexpr int most_steps = 30;
  static constexpr double damping = 1e-4, least_gain = 0.2, shortest_step = 1e-3;

  bool find()
  {
    double missing = measure();
    bool is_found = are_empty();
    for(int step = 0; step < most_steps && !is_found && make_step(missing); ++step)
      is_found = are_empty();
    return is_found;
  }

  bool are_empty() const
  {
    return std::all_of(spheres_.begin(), spheres_.end(), [this](const Facet_spheres_3& s) { return s.are_empty(sites_, margin_ / 2); });
  }

  // Finds the violated conditions, and returns the sum of the squared violations.
  double measure()
  {
    conditions_.clear();
    double sum = 0;
    for(const Facet_spheres_3& s : spheres_)
      if(const Facet_spheres_3::Condition c = s.condition(sites_, margin_); c.lack > 0)
      {
        conditions_.push_back(c);
        sum += c.lack * c.lack;
      }
    return sum;
  }

  // Makes a step, shortened until it pays; false if it does not.
  bool make_step(double& missing)
  {
    const Eigen::VectorXd direction = newton_step();
    const double before = missing;
    double length = 1, gone = 0;
    do
    {
      for(std::size_t n = 0; n < vertices_.size(); ++n)
        sites_[vertices_[n]].weight += (length - gone) * direction[Eigen::Index(n)];
      missing = measure();
      gone = length;
      length /= 2;
    } while(missing > (1 - least_gain * gone) * before && length > shortest_step);
    return missing < before;
  }

  Eigen::VectorXd newton_step()
  {
    std::vector<Eigen::Triplet<double> > entries;
    Eigen::VectorXd lacks(Eigen::Index(conditions_.size()));
    for(std::size_t n = 0; n < conditions_.size(); ++n)
    {
      const Facet_spheres_3::Condition& c = conditions_[n];
      lacks[Eigen::Index(n)] = c.lack;
      for(std::size_t i = 0; i < c.vertices.size(); ++i)
        if(c.vertices[i] >= 0)
          entries.emplace_back(static_cast<int>(n), column(c.vertices[i]), c.gradient[i]);
    }
    const Eigen::Index size = Eigen::Index(vertices_.size());
    Eigen::SparseMatrix<double> gradients(lacks.size(), size), damped(size, size);
    gradients.setFromTriplets(entries.begin(), entries.end());
    damped.setIdentity();
    damped = damping * damped + Eigen::SparseMatrix<double>(gradients.transpose() * gradients);
    return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double> >(damped).solve(gradients.transpose() * lacks);
  }

  int column(int v)
  {
    const auto found = columns_.emplace(v, static_cast<int>(vertices_.size()));
    if(found.second)
      vertices_.push_back(v);
    return found.first->second;
  }

  // Gains, shifted by a common amount so that no weight decreases, which leaves the facets as they are. Empty if a vertex would be
  // too heavy.
  std::map<int, double> permitted_gains() const
  {
    const auto gain = [this](int v) { return sites_[v].weight - candidate_.sites[v].weight; };
    double rise = 0;
    for(int v : vertices_)
      rise = (std::max)(rise, -gain(v));
    std::map<int, double> result;
    for(int v : vertices_)
      if(result[v] = gain(v) + rise; candidate_.sites[v].weight + result[v] > largest_share * candidate_.triangulation.largest_weight(v))
        return {};
    return result;
  }

  const Complex_candidate_3& candidate_;
  std::vector<Site> sites_;
  double margin_ = 0;
  std::vector<Facet_spheres_3> spheres_;
  std::vector<Facet_spheres_3::Condition> conditions_;
  std::map<int, int> columns_;
  std::vector<int> vertices_;           // by column
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_FACET_WEIGHTS_3_H
