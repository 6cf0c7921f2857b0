// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_METHODS_METHOD_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_METHODS_METHOD_H

#include "cpu_seconds.h"
#include "voronoi_energy.h"

#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Cell_order.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// The energy that is lowered: that of the optimal Delaunay triangulation or that of the centroidal Voronoi tessellation.
enum class Energy { ODT, CVT };

inline std::string name_of(Energy e) { return e == Energy::ODT ? "ODT" : "CVT"; }

// A way to lower either energy of a mesh, whose boundary stays, in iterations.
class Method
{
public:
  typedef CGAL::Global_odt_mesh_3::internal::Moving_triangulation_3 Mesh;
  typedef CGAL::Global_odt_mesh_3::internal::Odt_objective_3 Objective;

  explicit Method(Energy e) : energy_choice_(e) {}
  virtual ~Method() {}
  Method(const Method&) = delete;
  Method& operator=(const Method&) = delete;

  virtual std::string name() const = 0;

  // To be called first. The mesh is to live as long as this is used.
  void prepare(Mesh& mesh, unsigned int seed)
  {
    mesh_ = &mesh;
    Objective::Term term;
    if(energy_choice_ == Energy::CVT)
      term = CGAL::Global_odt_mesh_3::internal::Voronoi_term(mesh);
    objective_ = std::make_unique<Objective>(mesh, std::vector<CGAL::Global_odt_mesh_3::internal::Tangential_motion>(), term);
    order_ = std::make_unique<CGAL::Global_odt_mesh_3::internal::Cell_order>(mesh);
    start(seed);
  }

  // False if nothing has been done and nothing is left to do.
  bool iterate()
  {
    const bool is_done = !step();
    order_->maintain(*mesh_);
    return !is_done;
  }

  double energy() const { return objective_->value(); }
  double gradient() const { return objective_->gradient().norm(); }

protected:
  Energy energy_choice() const { return energy_choice_; }
  Mesh& mesh() { return *mesh_; }
  Objective& objective() { return *objective_; }
  CGAL::Global_odt_mesh_3::internal::Cell_order& order() { return *order_; }

private:
  virtual void start(unsigned int /* seed */) {}
  virtual bool step() = 0;

  Energy energy_choice_;
  Mesh* mesh_ = nullptr;
  std::unique_ptr<Objective> objective_;
  std::unique_ptr<CGAL::Global_odt_mesh_3::internal::Cell_order> order_;
};

// What a method has done to a mesh.
struct Run
{
  int iterations = 0;
  double time = 0;      // of the process
};

// At most so many iterations on the mesh, which ends with the energy of the optimal Delaunay triangulation.
// `after(run)` is called after each, and is not timed.
inline Run run(Method& method, Method::Mesh& mesh, unsigned int seed, int most_iterations,
               const std::function<void(const Run&)>& after = [](const Run&) {})
{
  Run r;
  r.time = seconds([&] { method.prepare(mesh, seed); });
  while(r.iterations < most_iterations)
  {
    bool moved = false;
    r.time += seconds([&] { moved = method.iterate(); });
    if(!moved)
      break;
    ++r.iterations;
    after(r);
  }
  mesh.is_regular();
  return r;
}

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_METHODS_METHOD_H
