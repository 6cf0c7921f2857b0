// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_ODT_OBJECTIVE_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_ODT_OBJECTIVE_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The relative rise of an energy, which is negative if weights are large.
inline double relative_rise(double before, double after) { return (after - before) / std::abs(before); }

// Leads a site back to within a distance of another one.
inline void hold_near(const Vector_3& center, double farthest, Site& s)
{
  const Vector_3 way = position(s) - center;
  const double length = way.length();
  if(length > farthest)
    s = site_at(center + farthest / length * way, s.weight);
}

// How a vertex moves on a surface: in the tangential plane through where it is
// when the motion begins, within a disk. Without radius, it stays.
struct Tangential_motion
{
  Vector_3 normal;
  double radius;
  Site center;

  bool is_at_rest() const { return !(radius > 0); }

  // The tangential plane says little of the surface farther away.
  void hold_in_disk(Site& s) const { hold_near(position(center), radius, s); }

  Vector_3 tangential_part(const Vector_3& g) const { return g - normal.dot(g) * normal; }
};

// The energy of a moving triangulation, and perhaps another one, as a function of the coordinates of its
// movable vertices, in the form that the minimizer wants. Frozen vertices are
// held by a zero gradient, those on surfaces by its tangential part.
//
// evaluate() leads from the current point to a trial, of which value(), point(), gradient() and
// diagonal() are then, unless it is not feasible. Either accept() or keep() makes it the current
// point, or reject() goes back, with all four.
class Odt_objective_3
{
public:
  // What another energy adds for these sites; gradient and diagonal grow by its own.
  // Those are of the vertices beyond the interior ones.
  typedef std::function<double(const std::vector<Site>&, Eigen::VectorXd& gradient, Eigen::VectorXd& diagonal)> Term;

  // `motions` are those of the vertices beyond the interior ones. Vertices whose
  // motion has no radius stay.
  explicit Odt_objective_3(Moving_triangulation_3& mesh,
                           std::vector<Tangential_motion> motions = std::vector<Tangential_motion>(),
                           Term term = Term())
    : Odt_objective_3(mesh, std::move(motions), std::move(term), Without_evaluation())
  {
    if(mesh_.quadrature() != nullptr)
      mesh_.mean_edge_lengths(longest_step_);
    mesh_.keep();
    is_feasible_ = mesh_.evaluate();
    if(!is_feasible_)
    {
      mesh_.restore();
      for(int v = 0; v < number_of_vertices(); ++v)
        freeze(v);
    }
    gather();
    keep();
  }

  // The same without evaluation, for a mesh of which gradient(v) is known. The value is not.
  template <class Gradient>
  Odt_objective_3(Moving_triangulation_3& mesh, std::vector<Tangential_motion> motions, Term term, const Gradient& gradient)
    : Odt_objective_3(mesh, std::move(motions), std::move(term), Without_evaluation())
  {
    is_feasible_ = true;
    gather([&](const auto& f)
    {
      for(int v = 0; v < mesh_.number_of_movable_vertices; ++v)
        f(v, gradient(v));
    });
    keep();
  }

  // Whether the triangulation could be made regular where it was. Otherwise it is as before, and all vertices are frozen.
  bool is_feasible() const { return is_feasible_; }
  double value() const { return current_.value; }
  const Eigen::VectorXd& point() const { return current_.point; }
  const Eigen::VectorXd& gradient() const { return current_.gradient; }
  const Eigen::VectorXd& diagonal() const { return current_.diagonal; }

  // The mesh is left with no room for gradients.
  ~Odt_objective_3() { mesh_.release_gradient(); }
  Odt_objective_3(const Odt_objective_3&) = delete;
  Odt_objective_3& operator=(const Odt_objective_3&) = delete;

  bool evaluate(const Eigen::VectorXd& x)
  {
    CGAL_assertion(x.size() == point().size() && !is_on_trial_);
    mesh_.move([&](int v, Site& s)
    {
      if(frozen_[v])
        return;
      s = { x[3 * v], x[3 * v + 1], x[3 * v + 2], s.weight };
      if(v >= mesh_.number_of_interior_vertices)
        motion(v)->hold_in_disk(s);
      else if(!longest_step_.empty())
        hold_near(vector_at(point(), v), longest_step_[v], s);
    });
    if(!mesh_.evaluate())
      return false;
    std::swap(current_, other_);
    is_on_trial_ = true;
    gather();
    return std::isfinite(value());
  }

  // Vertices that are stopped again and again, at a constrained facet, are frozen.
  void accept()
  {
    for(int v : mesh_.stopped_vertices())
      if(++stops_[v] == most_stops)
        freeze(v);
    keep();
  }

  // The same without that.
  void keep()
  {
    mesh_.keep();
    is_on_trial_ = false;
  }

  void reject()
  {
    mesh_.restore();
    if(is_on_trial_)
      std::swap(current_, other_);
    is_on_trial_ = false;
  }

  struct Evaluation
  {
    double value = 0;
    Eigen::VectorXd point, gradient, diagonal;

    explicit Evaluation(int vertices) : point(3 * vertices), gradient(3 * vertices), diagonal(3 * vertices) {}
  };

  // The current point with all that belongs to it.
  struct State
  {
    Moving_triangulation_3 mesh;
    Evaluation evaluation;
    std::vector<char> frozen;
    std::vector<int> stops;
    int number_of_frozen_vertices;
  };

  State state() const { return { mesh_, current_, frozen_, stops_, number_of_frozen_vertices_ }; }

  // Makes it the current point again, whatever has become of it.
  void go_back(const State& s)
  {
    mesh_.go_back(s.mesh);
    current_ = s.evaluation;
    frozen_ = s.frozen;
    stops_ = s.stops;
    number_of_frozen_vertices_ = s.number_of_frozen_vertices;
    keep();
  }

  const Thread_policy& threads() const { return mesh_.threads(); }
  int number_of_vertices() const { return mesh_.number_of_movable_vertices; }
  void mean_edge_lengths(std::vector<double>& length) const { mesh_.mean_edge_lengths(length); }

  // The normal of the plane in which the vertex moves, or null if it moves in space.
  const Vector_3* normal(int v) const
  {
    return v < mesh_.number_of_interior_vertices || motion(v) == nullptr ? nullptr : &motion(v)->normal;
  }

  int number_of_frozen_vertices() const { return number_of_frozen_vertices_; }
  bool is_frozen(int v) const { return frozen_[v]; }
  void freeze(int v)
  {
    if(!frozen_[v])
      ++number_of_frozen_vertices_;
    frozen_[v] = true;
    set_vector(current_.gradient, v, Vector_3());
  }

private:
  static constexpr int most_stops = 3;

  struct Without_evaluation {};

  Odt_objective_3(Moving_triangulation_3& mesh, std::vector<Tangential_motion> motions, Term term, Without_evaluation)
    : mesh_(mesh)
    , motions_(std::move(motions))
    , term_(std::move(term))
    , frozen_(mesh.number_of_movable_vertices, false)
    , stops_(mesh.number_of_movable_vertices, 0)
    , current_(mesh.number_of_movable_vertices)
    , other_(mesh.number_of_movable_vertices)
  {
    for(int v = mesh.number_of_interior_vertices; v < mesh.number_of_movable_vertices; ++v)
      if(motion(v) == nullptr || motion(v)->is_at_rest())
        freeze(v);
  }

  const Tangential_motion* motion(int v) const
  {
    const std::size_t n = v - mesh_.number_of_interior_vertices;
    return n < motions_.size() ? &motions_[n] : nullptr;
  }

  void gather() { gather([this](const auto& f) { mesh_.for_each_gradient(f); }); }

  template <class For_each_gradient>
  void gather(const For_each_gradient& for_each_gradient)
  {
    Eigen::VectorXd &point = current_.point, &gradient = current_.gradient, &diagonal = current_.diagonal;
    current_.value = mesh_.energy();
    for_each_gradient([&](int v, const Site_gradient& g)
    {
      if(v >= mesh_.number_of_movable_vertices)
        return;
      const Site& s = mesh_.sites[v];
      set_vector(point, v, position(s));
      set_vector(diagonal, v, { g.diagonal, g.diagonal, g.diagonal });
      set_vector(gradient, v, frozen_[v] ? Vector_3() : Vector_3(g.x, g.y, g.z));
    });
    if(term_)
      current_.value += term_(mesh_.sites, gradient, diagonal);
    for(int v = mesh_.number_of_interior_vertices; v < mesh_.number_of_movable_vertices; ++v)
      set_vector(gradient, v, frozen_[v] ? Vector_3() : motion(v)->tangential_part(vector_at(gradient, v)));
  }

  Moving_triangulation_3& mesh_;
  std::vector<Tangential_motion> motions_;
  Term term_;
  std::vector<char> frozen_;
  std::vector<int> stops_;
  std::vector<double> longest_step_;    // if there is a density, which may be known near the domain only
  int number_of_frozen_vertices_ = 0;
  Evaluation current_, other_;    // that of the current point is the other one on trial
  bool is_on_trial_ = false;
  bool is_feasible_ = false;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_ODT_OBJECTIVE_3_H
