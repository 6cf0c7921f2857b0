// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_ROUNDS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_ROUNDS_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Iteration_control.h>
#include <CGAL/Global_odt_mesh_3/internal/Odt_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/Round_plan.h>
#include <CGAL/Global_odt_mesh_3/internal/blocks/Block_annealing_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Field_density_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Make_density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/User_field_3.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Global_search.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/sizing/Nodal_densities_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Surface_cvt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Surface_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Cell_order.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <CGAL/Mesh_optimization_return_code.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <numeric>
#include <variant>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Tells from the displacements of the interior vertices how far the minimization has come, as CGAL's optimizers do. The
// displacement of a vertex is the length of the AVV move (2.3), |g|/D, over its shortest edge.
class Convergence_monitor
{
public:
  // Vertices whose displacement stays below `freeze_bound` are frozen if `do_freeze`.
  Convergence_monitor(double freeze_bound, bool do_freeze)
    : freeze_bound_(freeze_bound)
    , do_freeze_(do_freeze)
  {}

  // The mean of the largest displacements, those of one vertex in five hundred.
  double measure(const Constrained_triangulation_3& mesh, Odt_objective_3& objective)
  {
    const int n = mesh.number_of_interior_vertices;
    if(n == 0)
      return 0;
    mesh.shortest_edges(shortest_edge_);
    displacement_.resize(n);
    still_.resize(n, 0);
    const Eigen::VectorXd& g = objective.gradient();
    const Eigen::VectorXd& d = objective.diagonal();
    for(int v = 0; v < n; ++v)
    {
      displacement_[v] = vector_at(g, v).length() / (d[3 * v] * shortest_edge_[v]);
      // A vertex may come to rest for a moment while those around it still move.
      still_[v] = displacement_[v] < freeze_bound_ ? still_[v] + 1 : 0;
      if(do_freeze_ && still_[v] == iterations_to_freeze)
        objective.freeze(v);
    }
    const std::size_t count = (std::max)(std::size_t(1), static_cast<std::size_t>(n) / 500);
    std::nth_element(displacement_.begin(), displacement_.begin() + (count - 1), displacement_.end(),
                     std::greater<double>());
    const double largest = std::accumulate(displacement_.begin(), displacement_.begin() + count, 0.) / double(count);
    first_ = (std::max)(first_, largest);
    return largest;
  }

  // The fraction of the way to `convergence`, in orders of magnitude.
  double progress(double displacement, double convergence) const
  {
    if(!(convergence > 0 && first_ > convergence && displacement > 0))
      return 0;
    return std::log(first_ / displacement) / std::log(first_ / convergence);
  }

private:
  static constexpr int iterations_to_freeze = 6;

  double freeze_bound_;
  bool do_freeze_;
  double first_ = 0;
  std::vector<double> displacement_, shortest_edge_;
  std::vector<int> still_;
};

// The density of a mesh for the energies of cells and surfaces: the user's or else that of the input.
class Mesh_density_3
{
public:
  Mesh_density_3() {}

  // The mesh keeps a reference to the quadrature.
  Mesh_density_3(const Mesh_density_3&) = delete;
  Mesh_density_3& operator=(const Mesh_density_3&) = delete;

  // Keeps references to the field and the numbering.
  void prepare(Moving_triangulation_3& mesh, const User_field_3& field, const Quadrature_maker& make_quadrature,
               const Vertex_numbering_3& numbering)
  {
    const auto in_input = [&field, &numbering](int v, const Site& s) { return field.value(numbering.stratum(v), s); };
    const auto is_on_feature = [](int dimension) { return dimension == 0 || dimension == 1; };
    const std::vector<int>& dimensions = numbering.dimensions;
    if(!field)
      density_ = std::make_unique<Input_density_3>(mesh);
    else
    {
      const bool gives_way
        = std::any_of(dimensions.begin(), dimensions.end(), is_on_feature) && !Input_density_3(mesh).is_uniform();
      density_ = std::make_unique<Field_density_3>(field.meaning, in_input, mesh.sites, field.polynomial);
      if(gives_way)
        density_ = std::make_unique<Field_near_features_3>(std::move(density_), mesh, [&](int v) { return is_on_feature(dimensions[v]); });
    }
    // The input's density is given at the vertices, but a field may vary between them.
    if(!density_->is_uniform() || field)
      quadrature_ = make_quadrature(*density_, mesh.sites);
    mesh.set_quadrature(quadrature_.get());
    if(!density_->is_uniform())
      on_surface_ = [this](int v, const Site& s) { return density_->on_surface(v, s); };
  }

  // The local size at a vertex, with a median of about one, if the energy of cells follows the density; or else 1.
  double size(int v, const Site& s) const
  {
    return density_->is_uniform() ? 1 : Density_3::size_of_density(density_->in_volume(v, s));
  }

  // The density on surfaces; empty if it is uniform.
  const Surface_density& on_surface() const { return on_surface_; }

private:
  std::unique_ptr<Density_3> density_;
  std::unique_ptr<Density_quadrature_3> quadrature_;
  Surface_density on_surface_;
};

// Runs the rounds of a plan on the indexed mesh, and the minimization after them.
class Optimization_rounds_3
{
public:
  // Keeps references to its arguments.
  Optimization_rounds_3(Moving_triangulation_3& mesh, const Round_plan& plan, const Odt_parameters& parameters,
                        const User_field_3& field, Iteration_control& control, const Thread_policy& threads,
                        const Vertex_numbering_3& numbering)
    : mesh_(mesh)
    , plan_(plan)
    , parameters_(parameters)
    , control_(control)
    , threads_(threads)
  {
    const auto in_stage = during(Stage_clock::DENSITY);
    density_.prepare(mesh_, field, parameters_.make_quadrature, numbering);
    minimizer_parameters_ = minimizer_parameters(mesh_.quadrature());
    surface_term_ = std::make_unique<Surface_cvt_term_3>(mesh_.number_of_interior_vertices, mesh_.number_of_surface_vertices(),
                                                         parameters_.surface_weight, density_.on_surface(), threads_);
    search_ = std::make_unique<Global_search>(parameters_.annealing_schedule, parameters_.random_seed, minimizer_parameters_,
                                              threads_);
    const int blocks = Block_annealing_3::usual_number_of_blocks(mesh_.sites.size());
    const auto* momentum = std::get_if<Momentum_annealing_schedule>(&parameters_.annealing_schedule);
    // Vertices have other numbers in a block, so a user's field cannot be evaluated there.
    if(momentum != nullptr && blocks > 1 && !field)
      search_in_blocks_ = std::make_unique<Block_annealing_3>(mesh_, blocks, parameters_.random_seed, *momentum, threads_);
  }

  // The local size at a vertex at its present position.
  double local_size(int v) const { return density_.size(v, mesh_.sites[v]); }

  // Makes the next round of the plan on these boundaries, and returns the energy reached.
  double make_round(const Boundary_geometry_3& boundary)
  {
    const auto in_stage = during(clocked_stages[plan_.stage()]);
    boundary_ = &boundary;
    if(plan_.stage() == Round_plan::REMESH)
    {
      {
        Odt_objective_3 objective(mesh_, surface_motions(false));
        minimize(objective, plan_.iterations());
      }
      return remesh_surfaces();
    }
    if(plan_.stage() == Round_plan::SEARCH && search_in_blocks_)
      search_round_in_blocks();
    Odt_objective_3 objective(mesh_, surface_motions(true), surface_term());
    if(plan_.stage() == Round_plan::MINIMIZE)
      minimize(objective, plan_.iterations());
    else if(!search_in_blocks_)
      search_round(objective);
    return objective.value();
  }

  // Minimizes the interior, or stops where the parameters say. `code` becomes the reason for the end, unless the user or the time
  // limit stops it. False if the mesh is not feasible.
  bool minimize_interior(Mesh_optimization_return_code& code)
  {
    const auto in_stage = during(Stage_clock::MINIMIZE);
    Odt_objective_3 objective(mesh_);
    if(!objective.is_feasible())
      return false;
    Limited_memory_bfgs minimizer(minimizer_parameters_, threads_);
    Convergence_monitor monitor(parameters_.freeze_bound, parameters_.do_freeze);
    Cell_order order(mesh_);
    for(const double reported = control_.reported(); ; end_iteration(order))
    {
      const double displacement = monitor.measure(mesh_, objective);
      const double progress = monitor.progress(displacement, parameters_.convergence);
      if(parameters_.do_freeze && objective.number_of_frozen_vertices() == mesh_.number_of_movable_vertices)
        code = ALL_VERTICES_FROZEN;
      else if(displacement < parameters_.convergence)
        code = CONVERGENCE_REACHED;
      else if(!control_.begin_iteration(reported + (1 - reported) * progress))
        return true;
      else if(minimizer.iterate(objective) == Limited_memory_bfgs::NO_STEP_FOUND)
        code = CANT_IMPROVE_ANYMORE;
      else
        continue;
      return true;
    }
  }

private:
  static constexpr double longest_way_in_round = 0.3;     // of a surface vertex, over its shortest edge on the surface
  static constexpr double share_of_rounds = 0.8;          // of the progress that is reported
  // The clock's stage for each stage of the plan.
  static constexpr std::array<Stage_clock::Stage, 3> clocked_stages = {{ Stage_clock::REMESH, Stage_clock::SEARCH, Stage_clock::MINIMIZE }};

  Stage_clock::In_stage during(Stage_clock::Stage stage) const { return Stage_clock::In_stage(threads_.clock(), stage); }

  // The fraction of the search that is done at iteration n of the round.
  double search_progress(double n) const
  {
    // The noise fades within the time available.
    const double time = control_.progress_between(search_begin_, plan_.end_of_time(Round_plan::SEARCH));
    return (std::max)(plan_.search_progress(n), time);
  }

  void begin_search_round()
  {
    if(plan_.search_progress(0) == 0)
      search_begin_ = control_.elapsed();
  }

  void search_round(Odt_objective_3& objective)
  {
    begin_search_round();
    Cell_order order(mesh_);
    search_->make_round(objective, plan_.iterations(), [this](int n) { return search_progress(n); },
                        [this] { return begin_iteration(); }, [this, &order] { end_iteration(order); });
  }

  void search_round_in_blocks()
  {
    begin_search_round();
    const Odt_objective_3::Term term = surface_term();
    if(term && !surface_term_->has_scale())
      Odt_objective_3(mesh_, surface_motions(true), term);
    search_in_blocks_->start(surface_motions(true), term ? surface_term_.get() : nullptr);
    for(int n = 0, iterations; n < plan_.iterations() && search_progress(n) < 1 && begin_iteration(); n += iterations)
    {
      iterations = (std::min)(int(Block_annealing_3::iterations_in_block), plan_.iterations() - n);
      const int steps = (iterations * Block_annealing_3::steps_in_block) / Block_annealing_3::iterations_in_block;
      std::vector<double> done;
      for(int k = 0; k < steps; ++k)
        done.push_back(search_progress(n + double(k) * iterations / steps));
      search_in_blocks_->iterate(done, [this, n] { return search_progress(n) < 1 && control_.may_go_on(); });
      control_.end_iteration();
      // Counts the iterations that were made along with the first.
      for(int k = 1; k < iterations && control_.goes_on() && begin_iteration(); ++k)
        control_.end_iteration();
      if(!control_.goes_on())
        return;
    }
  }

  template <class Objective>
  void minimize(Objective& objective, int most_iterations)
  {
    Limited_memory_bfgs minimizer(minimizer_parameters_, threads_);
    Cell_order order(mesh_);
    bool goes_down = true;
    for(int n = 0; n < most_iterations && goes_down && begin_iteration(); ++n)
    {
      goes_down = minimizer.iterate(objective) == Limited_memory_bfgs::STEP_TAKEN;
      end_iteration(order);
    }
  }

  // Makes a round of the restricted CVT of the surfaces (section 5.1 of the paper), and returns the energy reached; the interior
  // follows in the next round.
  double remesh_surfaces()
  {
    Surface_cvt_objective_3 objective(boundary_->complex(), mesh_.sites, mesh_.number_of_interior_vertices,
                                      surface_motions(true), density_.on_surface(), threads_);
    if(control_.goes_on())
      minimize(objective, Round_plan::iterations_on_surface);
    return objective.value();
  }

  // The tangential motions, of length zero unless surface vertices move.
  std::vector<Tangential_motion> surface_motions(bool moves) const
  {
    return tangential_motions(mesh_, *boundary_, moves ? longest_way_in_round : 0);
  }

  Odt_objective_3::Term surface_term()
  {
    if(mesh_.number_of_surface_vertices() == 0 || !(parameters_.surface_weight > 0))
      return Odt_objective_3::Term();
    surface_term_->follow(boundary_->complex(), mesh_.sites);
    return std::ref(*surface_term_);
  }

  bool begin_iteration()
  {
    const double done = double(control_.number_of_iterations()) / plan_.number_of_iterations();
    return control_.begin_iteration(share_of_rounds * (std::min)(1., done));
  }

  void end_iteration(Cell_order& order)
  {
    control_.end_iteration();
    order.maintain(mesh_);
  }

  Moving_triangulation_3& mesh_;
  const Round_plan& plan_;
  const Odt_parameters& parameters_;
  Iteration_control& control_;
  Thread_policy threads_;
  const Boundary_geometry_3* boundary_ = nullptr;         // of this round
  Mesh_density_3 density_;
  Limited_memory_bfgs_parameters minimizer_parameters_;
  std::unique_ptr<Surface_cvt_term_3> surface_term_;
  std::unique_ptr<Global_search> search_;
  std::unique_ptr<Block_annealing_3> search_in_blocks_;   // or null
  double search_begin_ = 0;                               // as a fraction of the time
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_ROUNDS_3_H
