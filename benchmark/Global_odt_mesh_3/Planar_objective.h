// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_PLANAR_OBJECTIVE_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_PLANAR_OBJECTIVE_H

#include "methods/Method.h"

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Surface_cvt_objective_3.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesh_vertex_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Planar_kernel;
typedef CGAL::Triangulation_data_structure_2<CGAL::Delaunay_mesh_vertex_base_2<Planar_kernel>,
                                             CGAL::Delaunay_mesh_face_base_2<Planar_kernel> > Planar_data_structure;
typedef CGAL::Constrained_Delaunay_triangulation_2<Planar_kernel, Planar_data_structure> Planar_triangulation;

// The energy of a triangulation of the unit square, whose boundary stays, as a function of the vertices inside; in the form
// that the minimizer and the search for meshes in space want, with a third coordinate of zero. After vertices have moved, edges
// are flipped until the constrained triangulation is Delaunay; where triangles are inverted, it is built anew.
class Planar_objective
{
public:
  typedef Planar_kernel::Point_2 Point;
  typedef CGAL::Global_odt_mesh_3::internal::Thread_policy Thread_policy;
  typedef CGAL::Global_odt_mesh_3::internal::Vector_3 Vector_3;

  // Points inside, and those of the boundary in order.
  Planar_objective(Energy energy, const std::vector<Point>& inside, std::vector<Point> boundary)
    : energy_(energy)
    , boundary_(std::move(boundary))
    , number_(static_cast<int>(inside.size()))
    , normal_(0, 0, 1)
    , current_(number_)
    , kept_(number_)
  {
    for(int v = 0; v < number_; ++v)
      current_.point.segment<3>(3 * v) << inside[v].x(), inside[v].y(), 0;
    build(current_.point);
    evaluate(Eigen::VectorXd(current_.point));
    keep();
  }

  const Planar_triangulation& triangulation() const { return triangulation_; }
  double value() const { return current_.value; }
  const Eigen::VectorXd& point() const { return current_.point; }
  const Eigen::VectorXd& gradient() const { return current_.gradient; }
  const Eigen::VectorXd& diagonal() const { return current_.diagonal; }

  // Another energy of the same vertices.
  void set_energy(Energy energy)
  {
    energy_ = energy;
    sum_up();
    keep();
  }

  bool evaluate(const Eigen::VectorXd& x)
  {
    for(int v = 0; v < number_; ++v)
      if(!(x[3 * v] > 0 && x[3 * v] < 1 && x[3 * v + 1] > 0 && x[3 * v + 1] < 1))
        return false;
    current_.point = x;
    move(x);
    sum_up();
    return std::isfinite(current_.value);
  }

  void accept() { keep(); }
  void keep() { kept_ = current_; }

  void reject()
  {
    if(current_.point != kept_.point)
      move(kept_.point);
    current_ = kept_;
  }

  const Thread_policy& threads() const { return threads_; }
  int number_of_vertices() const { return number_; }
  bool is_frozen(int) const { return false; }
  const Vector_3* normal(int) const { return &normal_; }

  void mean_edge_lengths(std::vector<double>& length) const
  {
    std::vector<int> edges(number_, 0);
    length.assign(number_, 0);
    for(auto e = triangulation_.finite_edges_begin(); e != triangulation_.finite_edges_end(); ++e)
    {
      const Vertex_handle a = e->first->vertex(triangulation_.cw(e->second)), b = e->first->vertex(triangulation_.ccw(e->second));
      for(const Vertex_handle v : { a, b })
        if(const int n = numbers_.at(v); n < number_)
        {
          length[n] += std::sqrt(CGAL::squared_distance(a->point(), b->point()));
          ++edges[n];
        }
    }
    for(int v = 0; v < number_; ++v)
      length[v] /= edges[v];
  }

private:
  typedef Planar_triangulation::Vertex_handle Vertex_handle;

  struct Evaluation
  {
    double value = 0;
    Eigen::VectorXd point, gradient, diagonal;

    explicit Evaluation(int vertices) : point(3 * vertices), gradient(3 * vertices), diagonal(3 * vertices) {}
  };

  static Point planar_point(const Eigen::VectorXd& x, int v) { return Point(x[3 * v], x[3 * v + 1]); }

  void build(const Eigen::VectorXd& x)
  {
    triangulation_.clear();
    vertices_.clear();
    numbers_.clear();
    std::vector<Vertex_handle> on_boundary;
    for(const Point& p : boundary_)
      on_boundary.push_back(triangulation_.insert(p));
    for(std::size_t n = 0; n < on_boundary.size(); ++n)
      triangulation_.insert_constraint(on_boundary[n], on_boundary[(n + 1) % on_boundary.size()]);
    for(int v = 0; v < number_; ++v)
      vertices_.push_back(triangulation_.insert(planar_point(x, v)));
    vertices_.insert(vertices_.end(), on_boundary.begin(), on_boundary.end());
    for(std::size_t n = 0; n < vertices_.size(); ++n)
      numbers_[vertices_[n]] = static_cast<int>(n);
  }

  void move(const Eigen::VectorXd& x)
  {
    for(int v = 0; v < number_; ++v)
      vertices_[v]->set_point(planar_point(x, v));
    for(auto f = triangulation_.finite_faces_begin(); f != triangulation_.finite_faces_end(); ++f)
      if(CGAL::orientation(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point()) != CGAL::LEFT_TURN)
        return build(x);
    flip();
  }

  void flip()
  {
    for(bool has_flipped = true; has_flipped; )
    {
      has_flipped = false;
      for(auto f = triangulation_.finite_faces_begin(); f != triangulation_.finite_faces_end(); ++f)
        for(int i = 0; i < 3; ++i)
          if(triangulation_.is_flipable(f, i, false))
          {
            Planar_triangulation::Face_handle face = f;
            triangulation_.flip(face, i);
            has_flipped = true;
          }
    }
  }

  // Of a triangle, E = A / 12 (sum of squared edges), g_i = 2 A / 3 (x_i - c); or what it adds to the tessellation.
  void sum_up()
  {
    using namespace CGAL::Global_odt_mesh_3::internal;
    current_.value = 0;
    current_.gradient.setZero();
    current_.diagonal.setZero();
    std::vector<Site> sites;
    for(const Vertex_handle v : vertices_)
      sites.push_back({ v->point().x(), v->point().y(), 0, 0 });
    for(auto f = triangulation_.finite_faces_begin(); f != triangulation_.finite_faces_end(); ++f)
    {
      const std::array<int, 3> t = {{ numbers_.at(f->vertex(0)), numbers_.at(f->vertex(1)), numbers_.at(f->vertex(2)) }};
      if(energy_ == Energy::CVT)
      {
        const Surface_cvt_contribution_3 c(t, sites);
        current_.value += c.energy;
        for(int i = 0; i < 3; ++i)
          add(t[i], c.gradient[i], 2 * c.mass[i]);
        continue;
      }
      const double area = std::abs(CGAL::area(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point()));
      const Point c = CGAL::circumcenter(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point());
      for(int i = 0; i < 3; ++i)
      {
        current_.value += area / 12 * CGAL::squared_distance(f->vertex(i)->point(), f->vertex((i + 1) % 3)->point());
        add(t[i], 2 * area / 3 * (position(sites[t[i]]) - Vector_3(c.x(), c.y(), 0)), 2 * area / 3);
      }
    }
  }

  void add(int v, const Vector_3& gradient, double diagonal)
  {
    if(v >= number_)
      return;
    using namespace CGAL::Global_odt_mesh_3::internal;
    set_vector(current_.gradient, v, vector_at(current_.gradient, v) + gradient);
    current_.diagonal.segment<3>(3 * v).array() += diagonal;
  }

  Energy energy_;
  std::vector<Point> boundary_;
  int number_;
  Vector_3 normal_;
  Thread_policy threads_;
  Planar_triangulation triangulation_;
  std::vector<Vertex_handle> vertices_;         // those that move come first
  std::map<Vertex_handle, int> numbers_;
  Evaluation current_, kept_;
};

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_PLANAR_OBJECTIVE_H
