// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_ATTEMPT_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_ATTEMPT_3_H

#include <CGAL/Global_odt_mesh_3/internal/Iteration_control.h>
#include <CGAL/Global_odt_mesh_3/internal/Mesh_density_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Odt_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/Round_plan.h>
#include <CGAL/Global_odt_mesh_3/internal/User_fields_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Convergence_monitor.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Global_search.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Minimizer_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Boundary_motion.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/C3t3_reader_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/C3t3_writer_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Surface_roughness_3.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Sliver_stage_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Surface_cvt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Surface_cvt_term_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Surface_motions_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Cell_order.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <CGAL/Mesh_optimization_return_code.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Algorithms 1 and 2 of the paper on a c3t3, with vertices that also move on surfaces.
//
// While the boundary moves, the facets between subdomains are constrained in the flat
// triangulation. After some iterations, the exact triangulation and its restriction to the
// domain are built anew, which brings other facets; that is a round. In the first, the
// surfaces go toward a centroidal Voronoi tessellation (section 5.1). In the next, all vertices
// search globally, and in the last they go to the minimum, of an energy of which that tessellation's
// is a term. Then the boundary rests, the interior converges, and slivers are removed.
template <class C3t3, class Mesh_domain, class Visitor>
class Optimization_attempt_3
{
public:
  // Refers to its arguments; the c3t3 stays as it is until commit().
  Optimization_attempt_3(C3t3& c3t3, const Mesh_domain& domain, Odt_task task, const Odt_parameters& parameters,
                         const User_fields_3<C3t3>& fields, Iteration_control<Visitor>& control, Boundary_motion motion)
    : c3t3_(c3t3)
    , parameters_(parameters)
    , fields_(fields)
    , control_(control)
    , complex_(domain, motion, static_cast<bool>(fields))    // to sizes that the input does not have
  {
    complex_.start(C3t3_reader_3<C3t3, Domain>(c3t3, complex_.domain()).read(mesh_, motion != Boundary_motion::NONE));
    plan_ = std::make_unique<Round_plan>(task, parameters, boundary_moves(), motion == Boundary_motion::BY_DOMAIN);
    code_ = parameters_.do_freeze && plan_->optimizes() ? ALL_VERTICES_FROZEN : CONVERGENCE_REACHED;
  }

  // The mesh refers to the quadrature.
  Optimization_attempt_3(const Optimization_attempt_3&) = delete;
  Optimization_attempt_3& operator=(const Optimization_attempt_3&) = delete;

  // False if no valid complex could be made.
  bool run()
  {
    if(mesh_.number_of_movable_vertices == 0)
      return true;
    if(complex_.motion() == Boundary_motion::BY_NORMALS && is_surface_rough(complex_.state(), complex_.domain()))
      return false;
    control_.start(plan_->usual_most_iterations());
    if(plan_->is_done())
      return remove_slivers();
    prepare_energies();
    return make_rounds();
  }

  void commit()
  {
    if(!complex_.state().is_input())
      C3t3_writer_3<C3t3, Domain>(complex_.take_state(), complex_.domain()).write(c3t3_);
  }

  Mesh_optimization_return_code code() const { return code_; }
  std::size_t number_of_slivers() const { return number_of_slivers_; }
  const Oracle_statistics& oracle_statistics() const { return complex_.domain().statistics(); }
  int number_of_surface_vertices() const
  {
    return mesh_.number_of_movable_vertices - mesh_.number_of_interior_vertices;
  }

private:
  typedef typename C3t3::Triangulation Triangulation;
  typedef Restricted_complex_3<Triangulation, Mesh_domain> Complex;
  typedef typename Complex::Domain Domain;

  static constexpr int most_tries_of_last_round = 3;
  static constexpr double least_gain_of_round = 2e-4;     // of the energy, relatively
  static constexpr double longest_way_in_round = 0.3;     // of a surface vertex, over its shortest edge on the surface
  static constexpr double share_of_rounds = 0.8;          // of the progress that is reported
  static constexpr std::size_t iterations_for_a_check = 20, cells_in_iteration_for_a_try = 180;     // of like cost
  static constexpr std::size_t fewest_tries = 5000, fewest_tries_for_a_cell = 2;          // what slivers need as a rule

  bool boundary_moves() const { return number_of_surface_vertices() > 0; }

  void prepare_energies()
  {
    const auto& vertices = complex_.state().numbering->input_vertices;
    density_.prepare(mesh_, fields_, parameters_.quadrature, [&vertices](int v) { return vertices[v]; });
    surface_term_ = std::make_unique<Surface_cvt_term_3>(
      mesh_.number_of_interior_vertices, number_of_surface_vertices(), parameters_.surface_weight, density_.on_surface());
  }

  // The rounds of the plan, the last stage as long as it pays, and what follows. False if they lead to no valid
  // complex.
  bool make_rounds()
  {
    Global_search search(parameters_.annealing_schedule, parameters_.random_seed, minimizer_parameters(mesh_.quadrature()));
    int tries = most_tries_of_last_round;
    double energy = (std::numeric_limits<double>::max)();
    Round_plan::Stage previous = plan_->stage();
    for(;;)
    {
      const Round_plan::Stage stage = plan_->stage();
      if(stage != previous)
        energy = (std::numeric_limits<double>::max)();
      previous = stage;
      const double before = std::exchange(energy, make_round(search));
      const bool pays = !plan_->stops_without_gain() || energy < (1 - least_gain_of_round) * before;
      plan_->advance();
      if(control_.elapsed() > plan_->end_of_time(stage))
        plan_->skip(stage);
      if(control_.goes_on() && pays && !plan_->is_done())
      {
        if(boundary_moves())
          store_round();
        continue;
      }
      if(conclude(pays))
        return true;
      if(complex_.motion() != Boundary_motion::BY_NORMALS || !control_.goes_on() || --tries == 0)
        return false;
      // One on the way, and another last one.
      complex_.flatten(mesh_);
      plan_->add(Round_plan::MINIMIZE, 2);
    }
  }

  // On the way, surface vertices follow tangential planes, and cells are rarely looked up in the domain. A
  // round that leads to no valid complex is lost.
  void store_round()
  {
    complex_.advance(mesh_, false);
    complex_.flatten(mesh_);
  }

  // Gives the energy that is reached.
  double make_round(Global_search& search)
  {
    {
      const bool surfaces_move = plan_->stage() != Round_plan::REMESH;
      Odt_objective_3 objective(mesh_, surface_motions(surfaces_move), surface_term(surfaces_move));
      if(plan_->stage() == Round_plan::SEARCH)
        search_round(search, objective);
      else
        minimize(objective);
      if(surfaces_move)
        return objective.value();
    }
    return remesh_surfaces();
  }

  void search_round(Global_search& search, Odt_objective_3& objective)
  {
    if(plan_->search_progress(0) == 0)
      search_begin_ = control_.elapsed();
    const auto progress = [this](int n)
    {
      // The noise fades away within the time that there is.
      const double time = control_.progress_between(search_begin_, plan_->end_of_time(Round_plan::SEARCH));
      return (std::max)(plan_->search_progress(n), time);
    };
    Cell_order order(mesh_);
    search.make_round(objective, plan_->iterations(), progress, [this] { return begin_iteration(); },
                      [this, &order] { end_iteration(order); });
  }

  void minimize(Odt_objective_3& objective)
  {
    Limited_memory_bfgs minimizer(minimizer_parameters(mesh_.quadrature()));
    Cell_order order(mesh_);
    bool goes_down = true;
    for(int n = 0; n < plan_->iterations() && goes_down && begin_iteration(); ++n)
    {
      goes_down = minimizer.iterate(objective) == Limited_memory_bfgs::STEP_TAKEN;
      end_iteration(order);
    }
  }

  // A round of the restricted CVT of the surfaces (section 5.1 of the paper); the interior follows
  // in the next. Gives the energy that is reached.
  double remesh_surfaces()
  {
    Surface_cvt_objective_3 objective(complex_.state().boundary.complex(), mesh_.sites, mesh_.number_of_interior_vertices,
                                      surface_motions(true), density_.on_surface());
    Limited_memory_bfgs minimizer(minimizer_parameters(mesh_.quadrature()));
    bool goes_down = control_.goes_on();
    for(int n = 0; n < Round_plan::iterations_on_surface && goes_down && begin_iteration(); ++n)
    {
      goes_down = minimizer.iterate(objective) == Limited_memory_bfgs::STEP_TAKEN;
      control_.end_iteration();
    }
    return objective.value();
  }

  // After the last round: the interior goes to its minimum, or to where the parameters say, slivers are removed,
  // and the complex gets its final state. False if no valid one can be made.
  bool conclude(bool pays)
  {
    if(!plan_->optimizes())
    {
      if(pays)
        code_ = MAX_ITERATION_NUMBER_REACHED;
    }
    else if(control_.goes_on() && !minimize_interior())
      return false;
    if(!control_.goes_on())
      code_ = control_.code();
    return removes_slivers() ? remove_slivers() : is_untouched() || complex_.advance(mesh_, true).has_value();
  }

  // Also if the iterations are used up, but not if the time is.
  bool removes_slivers() const
  {
    return parameters_.do_remove_slivers && plan_->removes_slivers()
           && (control_.goes_on() || control_.code() != TIME_LIMIT_REACHED);
  }

  bool remove_slivers()
  {
    Sliver_stage_3<Complex> stage(complex_, mesh_, parameters_.sliver_bound, parameters_.random_seed,
                                  most_tries_for_slivers());
    if(!stage.run([this] { return control_.has_time(); }, [this] { return control_.may_go_on(); }))
      return false;
    number_of_slivers_ = stage.number_of_slivers();
    if(!control_.goes_on())
      code_ = control_.code();
    else if(number_of_slivers_ > 0)
      code_ = CANT_IMPROVE_ANYMORE;
    return true;
  }

  // Tries of single vertices, for a share of what the stages before have taken; after few iterations, for what
  // slivers need as a rule.
  std::size_t most_tries_for_slivers() const
  {
    const int iterations = plan_->optimizes() ? control_.number_of_iterations() : plan_->number_of_iterations();
    const std::size_t work = iterations + iterations_for_a_check * complex_.number_of_checks();
    const std::size_t cells = mesh_.topology.number_of_cells();
    return (std::max)(work * cells / cells_in_iteration_for_a_try, fewest_tries + fewest_tries_for_a_cell * cells);
  }

  bool minimize_interior()
  {
    Odt_objective_3 objective(mesh_);
    if(!objective.is_feasible())
      return false;
    Limited_memory_bfgs minimizer(minimizer_parameters(mesh_.quadrature()));
    Convergence_monitor monitor(parameters_.freeze_bound, parameters_.do_freeze);
    Cell_order order(mesh_);
    for(const double reported = control_.reported(); ; end_iteration(order))
    {
      const double displacement = monitor.measure(mesh_, objective);
      const double progress = monitor.progress(displacement, parameters_.convergence);
      if(parameters_.do_freeze && objective.number_of_frozen_vertices() == mesh_.number_of_movable_vertices)
        code_ = ALL_VERTICES_FROZEN;
      else if(displacement < parameters_.convergence)
        code_ = CONVERGENCE_REACHED;
      else if(!control_.begin_iteration(reported + (1 - reported) * progress))
        return true;
      else if(minimizer.iterate(objective) == Limited_memory_bfgs::NO_STEP_FOUND)
        code_ = CANT_IMPROVE_ANYMORE;
      else
        continue;
      return true;
    }
  }

  // Whether no vertex has moved since the input.
  bool is_untouched() const { return complex_.state().is_input() && complex_.state().has_positions(mesh_.sites); }

  // Of no length if surface vertices are to stay.
  std::vector<Tangential_motion> surface_motions(bool moves) const
  {
    return tangential_motions(mesh_, complex_.state().boundary, moves ? longest_way_in_round : 0);
  }

  // None if surface vertices are to stay.
  Odt_objective_3::Term surface_term(bool moves)
  {
    if(!moves || !boundary_moves() || !(parameters_.surface_weight > 0))
      return Odt_objective_3::Term();
    surface_term_->follow(complex_.state().boundary.complex(), mesh_.sites);
    return std::ref(*surface_term_);
  }

  bool begin_iteration()
  {
    const double done = double(control_.number_of_iterations()) / plan_->number_of_iterations();
    return control_.begin_iteration(share_of_rounds * (std::min)(1., done));
  }

  void end_iteration(Cell_order& order)
  {
    control_.end_iteration();
    order.maintain(mesh_);
  }

  C3t3& c3t3_;
  const Odt_parameters& parameters_;
  const User_fields_3<C3t3>& fields_;
  Iteration_control<Visitor>& control_;
  Complex complex_;
  Moving_triangulation_3 mesh_;
  std::unique_ptr<Round_plan> plan_;
  Mesh_density_3 density_;
  std::unique_ptr<Surface_cvt_term_3> surface_term_;
  double search_begin_ = 0;                 // in fractions of the time
  std::size_t number_of_slivers_ = 0;
  Mesh_optimization_return_code code_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_ATTEMPT_3_H
