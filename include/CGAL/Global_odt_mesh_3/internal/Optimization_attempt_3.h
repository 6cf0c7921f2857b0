// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_ATTEMPT_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_ATTEMPT_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Iteration_control.h>
#include <CGAL/Global_odt_mesh_3/internal/Odt_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/Optimization_rounds_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Round_plan.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Candidate_checks_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_updater_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Defect_report_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Snapshot_reader_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Snapshot_tabulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/User_field_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/sizing/Size_criteria_3.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Sliver_removal_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <CGAL/Mesh_optimization_report_3.h>
#include <CGAL/Mesh_optimization_return_code.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Algorithms 1 and 2 of the paper, with vertices that also move on surfaces.
//
// While the boundary moves, the facets between subdomains are constrained in the flat triangulation. After some iterations, the
// exact triangulation and its restriction to the domain are rebuilt, which brings other facets; that is a round. In the first
// rounds, all vertices search globally; in the last ones, they go to the minimum of an energy that includes that of a centroidal
// Voronoi tessellation of the surfaces (section 5.1). Without a search, the surfaces first go toward that tessellation alone. Then
// the boundary rests, the interior converges, and slivers are removed.
class Optimization_attempt_3
{
public:
  // Keeps references to its arguments; the input is unchanged until commit().
  Optimization_attempt_3(Mesh_view_3& input, const Domain_view_3& domain, Facet_bounds_3& bounds, Odt_task task,
                         const Odt_parameters& parameters, const User_field_3& field, Iteration_control& control,
                         const Thread_policy& threads, bool boundary_moves)
    : input_(input)
    , parameters_(parameters)
    , field_(field)
    , control_(control)
    , threads_(threads)
    , complex_(domain, bounds, boundary_moves, threads)
  {
    const auto in_stage = during(Stage_clock::READ);
    const double begin = control.time();
    Snapshot_reader_3 reader(input, threads);
    slivers_of_input_ = slivers_of_input(reader.table(), domain);
    complex_.start(reader.read(mesh_, boundary_moves));
    control.has_read(begin);
    plan_ = std::make_unique<Round_plan>(task, parameters, number_of_surface_vertices() > 0);
    code_ = parameters_.do_freeze && plan_->optimizes() ? ALL_VERTICES_FROZEN : CONVERGENCE_REACHED;
  }

  // The rounds keep references to the mesh.
  Optimization_attempt_3(const Optimization_attempt_3&) = delete;
  Optimization_attempt_3& operator=(const Optimization_attempt_3&) = delete;

  // False if no valid complex can be made. If `needs_way_back`, that is checked before any vertex moves.
  bool run(bool needs_way_back)
  {
    if(mesh_.number_of_movable_vertices == 0)
      return true;
    control_.start(plan_->usual_most_iterations(), removes_slivers());
    // Vertices need a regular complex to go back to; without one, moves of the boundary may still lead to a valid complex.
    if(slivers_of_input_.is_of_deformed_mesh)
    {
      has_way_back_ = complex_.make_regular();
      if(has_way_back_)
        complex_.load_into(mesh_);
      else if(needs_way_back || !boundary_moves())
        return false;
    }
    if(plan_->is_done())
    {
      bound_sizes();
      return remove_slivers();
    }
    rounds_ = std::make_unique<Optimization_rounds_3>(mesh_, *plan_, parameters_, field_, control_, threads_,
                                                       *complex_.snapshot().numbering);
    bound_sizes();
    return make_rounds();
  }

  // To be called last, after which only the code remains. False if the mesh would be worse than the input, which then stays.
  bool commit(bool may_be_worse)
  {
    const auto in_stage = during(Stage_clock::WRITE);
    rounds_.reset();
    mesh_ = Moving_triangulation_3();
    if(complex_.snapshot().is_input)
      return true;
    const Mesh_table_3 table = Snapshot_tabulation_3(complex_.take_snapshot(), threads_)();
    if(!is_acceptable(table, slivers_of_input_, parameters_, may_be_worse, removes_slivers() && control_.is_stopped()))
    {
      const bool is_worse = !slivers(table).is_not_worse_than(slivers_of_input_, true);
      reason_ = is_worse ? Mesh_optimization_summary_3::SMALLER_ANGLES : Mesh_optimization_summary_3::LARGER_CELLS;
      return false;
    }
    input_.write(table);
    return true;
  }

  // Whether the mesh is regular or can be made so.
  bool has_way_back() const { return has_way_back_; }

  // Why the mesh stays as it was.
  Mesh_optimization_summary_3::Reason reason() const { return reason_; }

  // The vertices where no valid complex can be made, by their numbers in the input.
  std::vector<int> obstacles() const { return std::vector<int>(complex_.obstacles().begin(), complex_.obstacles().end()); }

  // The census of the cells that may change. Sorting makes the angles of an unchanged cell independent of the order of its
  // vertices.
  static Sliver_census_3 slivers(const Mesh_table_3& mesh)
  {
    Sliver_census_3 census;
    for(const Mesh_table_3::Cell& c : mesh.cells)
      if(c.label != Domain_view_3::outside && !c.is_kept)
        census.add(mesh.cell_sites(sorted(c.vertices)), c.label);
    return census;
  }

  static Sliver_census_3 slivers_of_input(const Mesh_table_3& mesh, const Domain_view_3& domain)
  {
    Sliver_census_3 census = slivers(mesh);
    census.is_of_deformed_mesh = is_deformed(mesh, domain.threads());
    census.is_of_moved_mesh = census.is_of_deformed_mesh && !domain.has_cells_of_mesh();
    return census;
  }

  // Even a mesh that may be worse must not have smaller angles if time ran out before slivers were removed.
  static bool is_acceptable(const Mesh_table_3& mesh, const Sliver_census_3& before, const Odt_parameters& parameters,
                            bool may_be_worse, bool is_cut_short)
  {
    if(may_be_worse && !is_cut_short)
      return true;
    const Sliver_census_3 after = slivers(mesh);
    return may_be_worse ? after.is_not_worse_than(before, false) : after.may_replace(before, parameters.sliver_bound);
  }

  // The return code if that many cells are left below the bound.
  Mesh_optimization_return_code code(std::size_t slivers) const
  {
    return slivers > 0 && removes_slivers() && control_.goes_on() ? CANT_IMPROVE_ANYMORE : code_;
  }

  int number_of_surface_vertices() const { return mesh_.number_of_surface_vertices(); }

private:
  static constexpr double least_gain_of_round = 2e-4;     // relative to the energy
  static constexpr int most_lost_rounds = 2;              // of a mesh that is not regular, and cannot be made so

  Stage_clock::In_stage during(Stage_clock::Stage stage) const { return Stage_clock::In_stage(threads_.clock(), stage); }

  std::function<double(int)> local_size() const { return [this](int v) { return rounds_ ? rounds_->local_size(v) : 1.; }; }

  // No cell needs to get larger than those of the mesh.
  void bound_sizes()
  {
    const bool has_sizes_of_mesh = !static_cast<bool>(field_) || plan_->is_done();
    largest_cells_ = std::make_unique<Largest_cells_3>(mesh_, complex_.snapshot().numbering->subdomain, local_size(), has_sizes_of_mesh);
  }

  bool boundary_moves() const { return number_of_surface_vertices() > 0; }

  // Makes the rounds of the plan, the last stage for as long as it pays, and concludes. False if they lead to no valid complex.
  bool make_rounds()
  {
    double energy = (std::numeric_limits<double>::max)();
    Round_plan::Stage previous = plan_->stage();
    for(;;)
    {
      const Round_plan::Stage stage = plan_->stage();
      if(stage != previous)
        energy = (std::numeric_limits<double>::max)();
      previous = stage;
      const double before = std::exchange(energy, rounds_->make_round(complex_.snapshot().boundary));
      // A user who cancels before any work is done does not have to wait.
      if(control_.is_canceled() && !control_.has_work())
      {
        code_ = control_.code();
        return true;
      }
      const bool pays = !plan_->stops_without_gain() || relative_rise(before, energy) < -least_gain_of_round;
      plan_->advance();
      while(!plan_->is_done() && control_.elapsed(boundary_moves()) > plan_->end_of_time(plan_->stage()))
        plan_->skip(plan_->stage());
      if(control_.goes_on() && pays && !plan_->is_done())
      {
        if(boundary_moves() && !store_round() && !has_way_back_ && ++lost_rounds_ == most_lost_rounds)
          return false;
        continue;
      }
      return conclude(pays);
    }
  }

  // A round that leads to no valid complex is lost.
  bool store_round()
  {
    const double begin = control_.time();
    const bool is_valid = complex_.advance(mesh_, false);
    complex_.load_into(mesh_);
    control_.has_rebuilt(begin);
    return is_valid;
  }

  // After the last round, minimizes the interior, or stops where the parameters say, takes the final snapshot of the complex, and
  // removes slivers. False if no valid complex can be made.
  bool conclude(bool pays)
  {
    if(!plan_->optimizes())
    {
      if(pays)
        code_ = MAX_ITERATION_NUMBER_REACHED;
    }
    else if(control_.goes_on() && !rounds_->minimize_interior(code_))
      return false;
    if(!control_.goes_on())
      code_ = control_.code();
    if(!complex_.snapshot().is_untouched_at(mesh_.sites) && !complex_.advance(mesh_, true))
      return false;
    return !removes_slivers() || remove_slivers();
  }

  bool removes_slivers() const { return parameters_.do_remove_slivers && plan_->removes_slivers(); }

  bool remove_slivers()
  {
    const auto in_stage = during(Stage_clock::REMOVE_SLIVERS);
    // Vertices can be tried only in a regular complex.
    if(control_.has_time() && !complex_.make_regular())
      return false;
    Circumradius_bound_3 size_bound;
    if(largest_cells_)
      size_bound = largest_cells_->bound(mesh_, local_size());
    Sliver_stage_3 stage(complex_, size_bound, parameters_.sliver_bound, parameters_.random_seed);
    const auto has_time = [this] { return control_.has_time(); };
    // If the user has ended the iterations, the first step still removes the slivers they leave, so that they are not in vain.
    bool may_begin = control_.is_canceled();
    stage.run(has_time, [&] { return control_.may_go_on() || (std::exchange(may_begin, false) && has_time()); });
    if(!control_.goes_on())
      code_ = control_.code();
    return true;
  }

  Mesh_view_3& input_;
  Sliver_census_3 slivers_of_input_;
  const Odt_parameters& parameters_;
  const User_field_3& field_;
  Iteration_control& control_;
  Thread_policy threads_;
  Complex_updater_3 complex_;
  Moving_triangulation_3 mesh_;
  std::unique_ptr<Round_plan> plan_;
  std::unique_ptr<Optimization_rounds_3> rounds_;
  std::unique_ptr<Largest_cells_3> largest_cells_;
  Mesh_optimization_return_code code_;
  bool has_way_back_ = true;
  int lost_rounds_ = 0;
  Mesh_optimization_summary_3::Reason reason_ = Mesh_optimization_summary_3::NOTHING_TO_DO;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_OPTIMIZATION_ATTEMPT_3_H
