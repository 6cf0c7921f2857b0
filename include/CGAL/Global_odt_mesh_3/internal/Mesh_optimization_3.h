// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_OPTIMIZATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_OPTIMIZATION_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Iteration_control.h>
#include <CGAL/Global_odt_mesh_3/internal/Mesh_adaptation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Mesh_changes_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Odt_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/Optimization_attempt_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Candidate_checks_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_updater_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Conforming_refinement_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Defect_report_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Labelled_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Snapshot_reader_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Snapshot_tabulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Optimization_visitor.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/User_field_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/sizing/Size_criteria_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <CGAL/assertions.h>
#include <CGAL/Mesh_optimization_report_3.h>
#include <CGAL/Mesh_optimization_return_code.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// All that one call does to a mesh: one optimization, or several with vertices inserted or removed before each of them.
class Mesh_optimization_3
{
public:
  // Keeps references to its arguments.
  Mesh_optimization_3(const Domain_view_3& domain, const Odt_parameters& parameters, const User_field_3& field,
                      Optimization_visitor& visitor, const Thread_policy& threads)
    : domain_(domain)
    , parameters_(parameters)
    , field_(field)
    , visitor_(visitor)
    , threads_(threads)
    , control_(parameters, visitor)
    , bounds_(domain, parameters.facet_distance)
  {}

  Mesh_optimization_return_code run(User_mesh_view_3& mesh, Odt_task task)
  {
    const std::map<int, double> volumes_before = visitor_.summary != nullptr ? volumes(mesh.read(threads_)) : std::map<int, double>();
    const auto adapt_or_optimize = [&]
    { return parameters_.do_insert_vertices || parameters_.do_remove_vertices ? adapt_and_optimize(mesh, task) : optimize(mesh, task); };
    const bool may_release = release_cells(mesh);
    std::optional<Outcome> outcome = adapt_or_optimize();
    if(may_release && !mesh.is_changed() && !control_.is_stopped())
    {
      mesh.release(kept_cells(mesh.read(threads_)));
      outcome = adapt_or_optimize();
    }
    const std::size_t slivers = parameters_.sliver_bound > 0 ? mesh.number_of_slivers(parameters_.sliver_bound) : 0;
    if(visitor_.summary != nullptr)
      complete_summary(mesh, volumes_before, *visitor_.summary);
    visitor_.after_sliver_removal(slivers);
    visitor_.after_rebuild_restricted_delaunay();
    if(!outcome)
      return CANT_IMPROVE_ANYMORE;
    return slivers > 0 ? outcome->with_slivers : outcome->without_slivers;
  }

private:
  typedef Mesh_optimization_summary_3 Summary;

  // The return code, depending on whether slivers are left below the bound.
  struct Outcome
  {
    Mesh_optimization_return_code without_slivers, with_slivers;
  };

  static constexpr unsigned int most_adaptations = 3;
  static constexpr int most_releases = 4, edges_of_question = 100;
  // The steps whose angles must not get worse when cells that are too large are split: in the end, no more angles may fall below 30
  // degrees. Without this limit, splitting makes angles much smaller.
  static constexpr int step_on_the_way = 1, last_step = 3;

  // Optimizes with a moving boundary or, if that leads to no valid complex or to a worse one, with a fixed one. No outcome if there
  // is no valid complex; the mesh then stays as it was.
  std::optional<Outcome> optimize(Mesh_view_3& mesh, Odt_task task)
  {
    std::optional<Outcome> outcome;
    bool may_be_regular = true;
    if(parameters_.optimize_boundary)
    {
      outcome = attempt(mesh, task, true, &may_be_regular);
      if(!may_be_regular)
        outcome = optimize_regular(mesh, task, may_be_regular);
    }
    // If vertices are inserted or removed, further steps follow this one.
    const bool is_last = !parameters_.do_insert_vertices && !parameters_.do_remove_vertices && !control_.is_stopped();
    const bool is_in_vain = may_be_regular && (!outcome || (is_refused_ && is_last));
    if(is_in_vain && task != Odt_task::REMESH_BOUNDARY)
      if(const std::optional<Outcome> other = attempt(mesh, task, false))
        return other;
    return outcome;
  }

  // Optimizes a mesh that can be made regular only while its surface vertices stay: those that need a weight for that remain fixed,
  // and the others move. If there is no such mesh either, moves may still lead to a valid complex.
  std::optional<Outcome> optimize_regular(Mesh_view_3& mesh, Odt_task task, bool& is_regular)
  {
    Tabulated_mesh_3 regular(mesh, threads_);
    const Sliver_census_3 slivers = Optimization_attempt_3::slivers_of_input(regular.table(), domain_);
    CGAL_assertion(regular.table().inserted.empty());
    is_regular = make_regular(regular, false);
    if(!is_regular)
      return attempt(mesh, task, true);
    regular.return_to({ regular.table() });
    const std::optional<Outcome> outcome = attempt(regular, task, true);
    if(!outcome || !regular.is_changed())
      return outcome;
    const bool may_be_worse = task == Odt_task::REMESH_BOUNDARY || this->may_be_worse();
    const bool is_cut_short = parameters_.do_remove_slivers && control_.is_stopped();
    if(!Optimization_attempt_3::is_acceptable(regular.table(), slivers, parameters_, may_be_worse, is_cut_short))
    {
      reason_ = is_cut_short ? Summary::OUT_OF_TIME : Summary::SMALLER_ANGLES;
      return std::nullopt;
    }
    mesh.write(regular.table());
    return outcome;
  }

  // False if the mesh cannot be made regular, or is regular already.
  bool make_regular(Tabulated_mesh_3& mesh, bool boundary_moves)
  {
    Moving_triangulation_3 indexed;
    Complex_updater_3 complex(domain_, bounds_, boundary_moves, threads_);
    complex.start(Snapshot_reader_3(mesh, threads_).read(indexed, boundary_moves));
    if(!complex.make_regular() || complex.snapshot().is_input)
      return false;
    mesh.write(Snapshot_tabulation_3(complex.take_snapshot(), threads_)());
    return true;
  }

  // If `has_way_back` is given, nothing is done where vertices would have no regular mesh to go back to.
  std::optional<Outcome> attempt(Mesh_view_3& mesh, Odt_task task, bool boundary_moves, bool* has_way_back = nullptr)
  {
    Optimization_attempt_3 attempt(mesh, domain_, bounds_, task, parameters_, field_, control_, threads_, boundary_moves);
    const bool is_made = attempt.run(has_way_back != nullptr);
    const bool is_committed = is_made && attempt.commit(task == Odt_task::REMESH_BOUNDARY || may_be_worse());
    if(has_way_back != nullptr)
      *has_way_back = attempt.has_way_back();
    const Summary::Reason reason = !is_made ? Summary::NO_VALID_MESH : control_.is_stopped() ? Summary::OUT_OF_TIME : attempt.reason();
    // An attempt with nothing to do tells less than the reason why another one failed.
    if(reason != Summary::NOTHING_TO_DO)
      reason_ = reason;
    if(!is_made)
    {
      visitor_.obstacles = attempt.obstacles();
      return std::nullopt;
    }
    is_refused_ = !is_committed;
    if(!is_committed)
      return incomplete();
    return Outcome{ attempt.code(0), attempt.code(1) };
  }

  // The outcome if time ran out or the mesh stays as it was.
  Outcome incomplete() const
  {
    const Mesh_optimization_return_code code = control_.is_stopped() ? TIME_LIMIT_REACHED : CANT_IMPROVE_ANYMORE;
    return { code, code };
  }

  // Whether cells may have smaller angles than those of the input, since the user wants other sizes or keeps slivers.
  bool may_be_worse() const { return !parameters_.do_remove_slivers || field_ || parameters_.number_of_vertices > 0; }

  // In a deformed mesh, releases cells that the user wants to keep but that are not in the regular triangulation of the vertices at
  // their present positions, and cells around vertices that prevent a valid complex. True if some kept cells are left.
  bool release_cells(User_mesh_view_3& mesh)
  {
    if(!mesh.keeps_cells())
      return false;
    const Mesh_table_3 table = mesh.read(threads_);
    std::vector<Quadruple> kept = kept_cells(table);
    if(kept.empty() || !is_deformed(table, threads_))
      return false;
    Labelled_triangulation_3 regular;
    regular.build(table.sites);
    const auto release_others = [&](const auto& stays)
    {
      kept.erase(std::remove_if(kept.begin(), kept.end(), stays), kept.end());
      mesh.release(kept);
    };
    release_others([&](const Quadruple& q) { return regular.find_cell(q) >= 0; });
    for(int n = 0; n < most_releases; ++n)
    {
      Facet_bounds_3 bounds(domain_, parameters_.facet_distance);
      Moving_triangulation_3 indexed;
      Complex_updater_3 complex(domain_, bounds, parameters_.optimize_boundary, threads_);
      Snapshot_reader_3 reader(mesh, threads_);
      kept = kept_cells(reader.table());
      complex.start(reader.read(indexed, parameters_.optimize_boundary));
      if(kept.empty() || complex.make_regular())
        return !kept.empty();
      Vertex_rings_3 region(regular, complex.obstacles());
      for(int ring = 0; ring < n; ++ring)
        region.grow();
      const std::set<int> around(region.vertices().begin(), region.vertices().end());
      release_others([&](const Quadruple& q)
                     { return std::none_of(q.begin(), q.end(), [&](int v) { return around.count(v) > 0; }); });
    }
    return true;
  }

  static std::vector<Quadruple> kept_cells(const Mesh_table_3& table)
  {
    std::vector<Quadruple> kept;
    for(const Mesh_table_3::Cell& c : table.cells)
      if(c.is_kept)
        kept.push_back(c.vertices);
    return kept;
  }

  // Inserts and removes vertices for the wanted sizes before all vertices move, and then in cells that are too large and at the
  // slivers that are left.
  std::optional<Outcome> adapt_and_optimize(User_mesh_view_3& mesh, Odt_task task)
  {
    Tabulated_mesh_3 adapted(mesh, threads_);
    control_.has_read(0);
    const auto is_inside = [](const Mesh_table_3::Cell& c) { return c.label != Domain_view_3::outside; };
    if(std::none_of(adapted.table().cells.begin(), adapted.table().cells.end(), is_inside))
      return optimize(mesh, task);
    Sliver_census_3 slivers = Optimization_attempt_3::slivers_of_input(adapted.table(), domain_);
    const std::optional<Size_criteria_3> criteria = size_criteria(adapted.table());
    const auto may_go_on = [this] { return control_.may_go_on(); };
    // With a number of vertices, only ratios of sizes matter.
    if(field_ && field_.meaning == User_field_3::SIZE && parameters_.number_of_vertices == 0)
      conform(adapted, true);
    if(!adapt_sizes(adapted) && conform(adapted, false))
    {
      slivers.is_of_moved_mesh = true;
      adapt_sizes(adapted);
    }
    if(adapted.is_changed())
      control_.note_work();
    std::optional<Outcome> outcome = optimize(adapted, task);
    if(!outcome)
      return outcome;
    const int last_step_of_edits = Sliver_steps::last(parameters_.wanted_angle());
    for(unsigned int n = 0; n < most_adaptations && parameters_.do_remove_slivers && !control_.is_stopped(); ++n)
    {
      Tabulated_mesh_3::State before = adapted.state();
      const bool is_refined = refine(adapted, criteria, step_on_the_way, n);
      if(!adaptation(adapted).edit_slivers(last_step_of_edits, parameters_.random_seed + n, may_go_on) && !is_refined)
        break;
      if(!optimize(adapted, Odt_task::REMOVE_SLIVERS))
      {
        adapted.return_to(std::move(before));
        break;
      }
    }
    for(unsigned int n = 0; n < most_adaptations && !control_.is_stopped() && refine(adapted, criteria, last_step, n); ++n)
      control_.may_go_on();
    return conclude(mesh, adapted, slivers, *outcome);
  }

  // Inserts and removes vertices for the wanted sizes. False if the mesh is not regular and cannot be made so.
  bool adapt_sizes(Tabulated_mesh_3& mesh)
  {
    int questions = 0;
    return adaptation(mesh).adapt_sizes(field_, [&] { return may_treat_edge(questions); });
  }

  // There are many edges, so the control is asked only once in a while.
  bool may_treat_edge(int& questions) { return questions++ % edges_of_question != 0 || control_.may_move(); }

  // Inserts vertices on the boundary where the mesh cannot be made regular without them, or where edges are too long for the wanted
  // sizes. False if that is not permitted or does not help.
  bool conform(Tabulated_mesh_3& mesh, bool to_sizes)
  {
    if(!parameters_.do_insert_vertices || !parameters_.optimize_boundary || !domain_.has_cells_of_mesh())
      return false;
    Conforming_refinement_3 refinement(mesh.table());
    const int most_vertices = Mesh_adaptation_3::most_vertices(parameters_, mesh);
    const auto wanted = [size = Mesh_adaptation_3::size_of(field_)](const Vertex_stratum& v, const Site& s)
    { return Mesh_adaptation_3::edge_over_size * size(v, s); };
    int questions = 0;
    if(to_sizes && !refinement.split_long_edges(wanted, most_vertices, [&] { return may_treat_edge(questions); }))
      return false;
    if(!refinement.run(most_vertices, [&] { return control_.may_move(); }))
      return false;
    Tabulated_mesh_3::State before = mesh.state();
    mesh.return_to({ refinement.take_table() });
    bounds_.forget();
    if(make_regular(mesh, true))
      return true;
    mesh.return_to(std::move(before));
    bounds_.forget();
    return false;
  }

  // Writes the adapted mesh, unless it is worse than the input.
  Outcome conclude(User_mesh_view_3& mesh, const Tabulated_mesh_3& adapted, const Sliver_census_3& slivers, Outcome outcome)
  {
    if(control_.is_stopped())
      outcome = incomplete();
    else if(!has_wanted_number(adapted))
      outcome = { CANT_IMPROVE_ANYMORE, CANT_IMPROVE_ANYMORE };
    const bool is_cut_short = parameters_.do_remove_slivers && control_.is_stopped();
    if(!Optimization_attempt_3::is_acceptable(adapted.table(), slivers, parameters_, may_be_worse(), is_cut_short))
    {
      reason_ = is_cut_short ? Summary::OUT_OF_TIME : Summary::SMALLER_ANGLES;
      return incomplete();
    }
    if(adapted.is_changed())
      mesh.write(adapted.table());
    if(visitor_.summary != nullptr)
      count_vertices(adapted, *visitor_.summary);
    return outcome;
  }

  static void count_vertices(const Tabulated_mesh_3& mesh, Summary& summary)
  {
    const std::vector<int>& dimensions = mesh.table().dimensions;
    const auto removed = std::count(dimensions.begin(), dimensions.begin() + mesh.number_of_input_vertices(), int(Mesh_table_3::removed));
    summary.number_of_removed_vertices = static_cast<std::size_t>(removed);
    summary.number_of_inserted_vertices = static_cast<std::size_t>(mesh.number_of_vertices() + removed - mesh.number_of_input_vertices());
  }

  void complete_summary(User_mesh_view_3& mesh, const std::map<int, double>& volumes_before, Summary& summary) const
  {
    summary.reason = mesh.is_changed() ? Summary::CHANGED : reason_;
    summary.sliver_bound = parameters_.sliver_bound > 0 ? parameters_.sliver_bound : Sliver_steps::angles[1];
    summary.number_of_slivers = mesh.number_of_slivers(summary.sliver_bound);
    summary.number_of_iterations = static_cast<std::size_t>(control_.number_of_all_iterations());
    const Mesh_table_3 table = mesh.read(threads_);
    summary.largest_volume_change = largest_change(volumes_before, volumes(table));
    summary.farthest_facet = farthest_facet(table, domain_);
  }

  // Whether the mesh has the number of vertices the user wants, within 1 % or two vertices. Without such a number, whether it has
  // fewer than the most permitted; reaching that limit means too few for the sizes.
  bool has_wanted_number(const Tabulated_mesh_3& mesh) const
  {
    const double wanted = double(parameters_.number_of_vertices), tolerance = (std::max)(2., 0.01 * wanted);
    return wanted > 0 ? std::abs(mesh.number_of_vertices() - wanted) <= tolerance
                      : mesh.number_of_vertices() < Mesh_adaptation_3::most_vertices(parameters_, mesh);
  }

  // The size criteria that cells and facets must satisfy in the end, if vertices may be inserted: those of the size field or of the
  // input.
  std::optional<Size_criteria_3> size_criteria(const Mesh_table_3& input) const
  {
    const bool has_other_sizes = parameters_.number_of_vertices > 0 || (field_ && field_.meaning == User_field_3::DENSITY);
    return parameters_.do_insert_vertices && !has_other_sizes ? std::make_optional<Size_criteria_3>(input, field_) : std::nullopt;
  }

  // Inserts vertices into cells and facets that are too large; true if the mesh changes.
  bool refine(Tabulated_mesh_3& mesh, const std::optional<Size_criteria_3>& criteria, int step, unsigned int n)
  {
    if(!criteria)
      return false;
    const std::vector<Size_criteria_3::Violation> violations = criteria->violations(mesh.table());
    return !violations.empty()
           && adaptation(mesh).refine(violations, step, parameters_.random_seed + n, [this] { return control_.may_go_on(); });
  }

  Mesh_adaptation_3 adaptation(Tabulated_mesh_3& mesh)
  {
    return Mesh_adaptation_3(mesh, domain_, bounds_, parameters_, threads_);
  }

  const Domain_view_3& domain_;
  const Odt_parameters& parameters_;
  const User_field_3& field_;
  Optimization_visitor& visitor_;
  Thread_policy threads_;
  Iteration_control control_;
  Facet_bounds_3 bounds_;
  bool is_refused_ = false;                               // the result of the last attempt
  Summary::Reason reason_ = Summary::NOTHING_TO_DO;       // if the mesh is not changed
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_OPTIMIZATION_3_H
