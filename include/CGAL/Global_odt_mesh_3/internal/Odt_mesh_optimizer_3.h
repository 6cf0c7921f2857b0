// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ODT_MESH_OPTIMIZER_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ODT_MESH_OPTIMIZER_3_H

#include <CGAL/Global_odt_mesh_3/internal/Iteration_control.h>
#include <CGAL/Global_odt_mesh_3/internal/Odt_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/Round_plan.h>
#include <CGAL/Global_odt_mesh_3/internal/User_fields_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Density_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Make_density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Convergence_monitor.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Global_search.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Tangential_motion.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/C3t3_bridge_3.h>
#include <CGAL/Global_odt_mesh_3/internal/sizing/Input_density_3.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Sliver_stage_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Surface_cvt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Cell_order.h>

#include <CGAL/Mesh_optimization_return_code.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

template <class Visitor, class = void>
struct Wants_slivers : std::false_type {};

template <class Visitor>
struct Wants_slivers<Visitor, std::void_t<decltype(std::declval<Visitor&>().after_sliver_removal(std::size_t()))> >
  : std::true_type {};

// Algorithms 1 and 2 of the paper on a c3t3, with vertices that also move on surfaces.
//
// While the boundary moves, the facets between subdomains are constrained facets of the flat
// triangulation. After some iterations, the exact triangulation and its restriction to the
// domain are built anew, which brings other constrained facets; that is a round. In the first rounds, the
// surfaces go toward a centroidal Voronoi tessellation (section 5.1), which leads to a lower
// minimum in the next, where all vertices search globally, and in the last, where they go to
// the minimum. Then the boundary rests, the interior converges, and slivers are removed.
template <class C3t3, class Mesh_domain, class Visitor>
class Odt_mesh_optimizer_3
{
public:
  Odt_mesh_optimizer_3(C3t3& c3t3, const Mesh_domain& domain, const Odt_parameters& parameters, Visitor& visitor,
                       const User_fields_3<C3t3>& fields = User_fields_3<C3t3>())
    : c3t3_(c3t3)
    , domain_(domain)
    , parameters_(parameters)
    , visitor_(visitor)
    , fields_(fields)
    , control_(parameters, visitor)
  {}

  Mesh_optimization_return_code operator()()
  {
    if(parameters_.optimize_boundary)
      for(Care care : { SWIFT, CAREFUL })
        if(run(care))
          return code_;
    return !parameters_.remesh_boundary && run(BOUNDARY_FIXED) ? code_ : CANT_IMPROVE_ANYMORE;
  }

  // Of all attempts.
  const Oracle_statistics& oracle_statistics() const { return oracle_statistics_; }
  std::size_t number_of_surface_vertices() const
  {
    return mesh_.number_of_movable_vertices - mesh_.number_of_interior_vertices;
  }

private:
  typedef C3t3_bridge_3<C3t3, Mesh_domain> Bridge;
  typedef typename Bridge::Complex Complex;
  typedef typename Bridge::Update Update;

  static constexpr int most_tries_of_last_round = 3;
  static constexpr double least_gain_of_round = 2e-4;     // of the energy, relatively
  static constexpr double longest_way_in_round = 0.3;     // of a surface vertex, over its shortest edge on the surface
  static constexpr double share_of_rounds = 0.8;          // of the progress that is reported
  // Of the time, which the stages may not exceed if there is a limit.
  static constexpr double share_of_remeshing = 0.2, share_of_search = 0.65;

  // In swift rounds, surface vertices follow tangential planes and are only now
  // and then projected to the surface, and cells are rarely looked up in the domain. That is
  // nothing for rough surfaces, or if no valid complex comes out of it in the end; then every
  // round is made with care.
  enum Care { SWIFT, CAREFUL, BOUNDARY_FIXED };

  // False if no valid complex could be made; the c3t3 is untouched then.
  bool run(Care care)
  {
    Bridge bridge(c3t3_, domain_);
    const bool is_done = run(bridge, care);
    oracle_statistics_ += bridge.oracle_statistics();
    return is_done;
  }

  bool run(Bridge& bridge, Care care)
  {
    care_ = care;
    bridge.load(mesh_, care != BOUNDARY_FIXED);
    code_ = parameters_.do_freeze && !parameters_.remesh_boundary ? ALL_VERTICES_FROZEN : CONVERGENCE_REACHED;
    if(mesh_.number_of_movable_vertices == 0)
      return true;
    if(care == SWIFT && bridge.is_rough())
      return false;
    const Round_plan plan(parameters_, number_of_surface_vertices() > 0, care == CAREFUL);
    control_.start(plan.usual_most_iterations());

    const std::unique_ptr<Density_3> density = make_density(bridge);
    const std::unique_ptr<Density_quadrature_3> quadrature = make_quadrature(*density);
    density_ = surface_density_ = nullptr;
    mesh_.quadrature = quadrature.get();
    if(!density->is_uniform())
      surface_density_ = [&density](int v, const Site& s) { return density->on_surface(v, s); };
    if(!density->is_uniform() && quadrature == nullptr)
    {
      density_ = [&density](int v, const Site& s) { return density->in_volume(v, s); };
      for(std::size_t v = 0; v < mesh_.sites.size(); ++v)
        mesh_.density.push_back(density_(static_cast<int>(v), mesh_.sites[v]));
    }
    std::size_t slivers = 0;
    if(!make_rounds(bridge, plan))
      return false;
    if(removes_slivers())
    {
      Sliver_stage_3<Bridge> stage(bridge, parameters_, care == CAREFUL);
      stage.remove_from_complex(mesh_, [this] { return control_.has_time(); }, [this] { return control_.may_go_on(); });
      slivers = stage.number_of_slivers(mesh_);
      if(slivers > 0 && control_.goes_on())
        code_ = CANT_IMPROVE_ANYMORE;
      if(slivers > 0 && !control_.goes_on())
        code_ = control_.code();
    }
    bridge.commit();
    if constexpr (Wants_slivers<Visitor>::value)
      visitor_.after_sliver_removal(slivers);
    visitor_.after_rebuild_restricted_delaunay();
    return true;
  }

  std::unique_ptr<Density_3> make_density(const Bridge& bridge) const
  {
    if(fields_)
      return fields_.make_density(mesh_.sites, [&bridge](int v) { return bridge.input_vertex(v); });
    return std::make_unique<Input_density_3>(mesh_);
  }

  // Null for the linear one, which the triangulation knows itself. The density of the input is what it is
  // at vertices, but a field may vary between them.
  std::unique_ptr<Density_quadrature_3> make_quadrature(Density_3& density) const
  {
    return density.is_uniform() && !fields_ ? nullptr : make_density_quadrature_3(parameters_.quadrature, density);
  }

  // Also if the iterations are used up, but not if the time is.
  bool removes_slivers() const
  {
    return parameters_.sliver_bound > 0 && !parameters_.remesh_boundary
           && (control_.goes_on() || control_.code() != TIME_LIMIT_REACHED);
  }

  // The rounds of the plan, the last stage as long as it pays. False if they lead to no valid complex.
  bool make_rounds(Bridge& bridge, Round_plan plan)
  {
    Global_search search(parameters_.annealing_schedule, parameters_.random_seed, minimizer_parameters());
    int tries = most_tries_of_last_round;
    double energy = (std::numeric_limits<double>::max)();
    Round_plan::Stage previous = plan.stage();
    for(;;)
    {
      const Round_plan::Stage stage = plan.stage();
      if(stage != previous)
        energy = (std::numeric_limits<double>::max)();
      previous = stage;
      const double reached = make_round(bridge, search, plan);
      const bool pays = !plan.stops_without_gain() || reached < (1 - least_gain_of_round) * energy;
      energy = reached;
      plan.advance();
      if(stage == Round_plan::REMESH && !parameters_.remesh_boundary && control_.elapsed() > share_of_remeshing)
        plan.skip(Round_plan::REMESH);
      if(stage == Round_plan::SEARCH && control_.elapsed() > share_of_search)
        plan.skip(Round_plan::SEARCH);

      const bool is_last = !control_.goes_on() || !pays || plan.is_done();
      if(is_last && !conclude(bridge, pays))
        return false;
      if(is_last && is_untouched(bridge))
        return true;
      if(!is_last && number_of_surface_vertices() == 0)
        continue;
      const bool is_stored = store(bridge, is_last);
      // A round that leads nowhere is lost.
      bridge.reload(mesh_);
      if(!is_last)
        continue;
      if(is_stored)
        return true;
      if(care_ != SWIFT || !control_.goes_on() || --tries == 0)
        return false;
      // One on the way, and another last one.
      plan.add(Round_plan::MINIMIZE);
      plan.add(Round_plan::MINIMIZE);
    }
  }

  // Gives the energy that is reached.
  double make_round(Bridge& bridge, Global_search& search, const Round_plan& plan)
  {
    {
      Odt_objective_3 objective(mesh_, density_,
                                tangential_motions(bridge.complex(), plan.stage() != Round_plan::REMESH));
      if(plan.stage() == Round_plan::SEARCH)
        search_round(search, objective, plan);
      else
        minimize(objective, plan);
      if(plan.stage() != Round_plan::REMESH)
        return objective.value();
    }
    return remesh_surfaces(bridge.complex(), plan);
  }

  // Whether no vertex has moved since the input.
  bool is_untouched(const Bridge& bridge) const
  {
    return !bridge.complex().has_changed()
           && std::equal(mesh_.sites.begin(), mesh_.sites.begin() + mesh_.number_of_movable_vertices,
                         bridge.complex().sites.begin(),
                         [](const Site& a, const Site& b) { return a.x == b.x && a.y == b.y && a.z == b.z; });
  }

  void search_round(Global_search& search, Odt_objective_3& objective, const Round_plan& plan)
  {
    if(plan.search_progress(0) == 0)
      search_begin_ = control_.elapsed();
    const Moving_triangulation_3 before = mesh_;
    Cell_order order(mesh_);
    search.begin_round(objective);
    for(int n = 0; n < plan.iterations(); ++n)
    {
      // The noise fades away within the time that there is.
      const double time = (control_.elapsed() - search_begin_) / (share_of_search - search_begin_);
      const double done = (std::max)(plan.search_progress(n), time);
      if(done >= 1 || !begin_iteration(plan) || !search.iterate(objective, done))
        break;
      end_iteration(order);
    }
    if(!search.accepts(objective))
    {
      mesh_ = before;
      objective.start();
    }
  }

  void minimize(Odt_objective_3& objective, const Round_plan& plan)
  {
    Limited_memory_bfgs minimizer(minimizer_parameters());
    Cell_order order(mesh_);
    for(int n = 0; n < plan.iterations() && begin_iteration(plan); ++n)
    {
      if(minimizer.iterate(objective) == Limited_memory_bfgs::NO_STEP_FOUND)
        break;
      end_iteration(order);
    }
  }

  // A round of the restricted CVT of the surfaces (section 5.1 of the paper); the interior follows
  // in the next. Gives the energy that is reached.
  double remesh_surfaces(const Complex& complex, const Round_plan& plan)
  {
    Surface_cvt_objective_3 objective(complex.boundary, mesh_.sites, mesh_.number_of_interior_vertices,
                                      tangential_motions(complex, true), surface_density_);
    Limited_memory_bfgs minimizer(minimizer_parameters());
    for(int n = 0; n < Round_plan::iterations_on_surface && control_.goes_on() && begin_iteration(plan); ++n)
    {
      if(minimizer.iterate(objective) == Limited_memory_bfgs::NO_STEP_FOUND)
        break;
      control_.end_iteration();
    }
    return objective.value();
  }

  // After the last round: the interior goes to its minimum, or to where the parameters say, and
  // slivers are removed. False if the flat triangulation is beyond repair.
  bool conclude(Bridge& bridge, bool pays)
  {
    if(parameters_.remesh_boundary)
    {
      if(pays)
        code_ = MAX_ITERATION_NUMBER_REACHED;
    }
    else if(control_.goes_on() && !minimize_interior())
      return false;
    if(!control_.goes_on())
      code_ = control_.code();
    if(removes_slivers())
      Sliver_stage_3<Bridge>(bridge, parameters_, care_ == CAREFUL)
        .remove_from(mesh_, [this] { return control_.has_time(); });
    return true;
  }

  bool minimize_interior()
  {
    Odt_objective_3 objective(mesh_, density_);
    if(!objective.is_feasible())
      return false;
    Limited_memory_bfgs minimizer(minimizer_parameters());
    Convergence_monitor monitor(parameters_.freeze_bound, parameters_.do_freeze);
    Cell_order order(mesh_);
    for(const double reported = control_.reported(); ; )
    {
      const double displacement = monitor.measure(mesh_, objective);
      const double progress = monitor.progress(displacement, parameters_.convergence);
      if(parameters_.do_freeze && objective.number_of_frozen_vertices() == mesh_.number_of_movable_vertices)
        code_ = ALL_VERTICES_FROZEN;
      else if(displacement < parameters_.convergence)
        code_ = CONVERGENCE_REACHED;
      else if(!control_.begin_iteration(reported + (1 - reported) * progress))
        break;
      else if(minimizer.iterate(objective) == Limited_memory_bfgs::NO_STEP_FOUND)
        code_ = CANT_IMPROVE_ANYMORE;
      else
      {
        end_iteration(order);
        continue;
      }
      break;
    }
    return true;
  }

  bool store(Bridge& bridge, bool is_last)
  {
    // The closest point of a polyhedral surface is cheap.
    const bool boundary_moves = number_of_surface_vertices() > 0;
    const bool projects = is_last || care_ == CAREFUL || Has_aabb_tree<Mesh_domain>::value;
    const typename Update::Evidence evidence
      = care_ == CAREFUL ? Update::ORACLE : is_last ? Update::GOOD_EVIDENCE : Update::SOME_EVIDENCE;
    return bridge.store(mesh_, Update{ boundary_moves, boundary_moves && projects, evidence, is_last });
  }

  std::vector<Tangential_motion> tangential_motions(const Complex& complex, bool moves) const
  {
    std::vector<Tangential_motion> motions;
    for(int v = mesh_.number_of_interior_vertices; v < mesh_.number_of_movable_vertices; ++v)
    {
      const Boundary_umbrella& umbrella = complex.boundary.umbrella(v, 0);
      motions.push_back({ umbrella.normal, moves && umbrella.is_smooth ? longest_way_in_round * umbrella.shortest_edge : 0.,
                          mesh_.sites[v] });
    }
    return motions;
  }

  Limited_memory_bfgs_parameters minimizer_parameters() const
  {
    Limited_memory_bfgs_parameters p;
    if(mesh_.density_mode() != Moving_triangulation_3::UNIFORM)
      p.memory = 15;
    // (4.6) is not the derivative of the interpolated energy (4.1), so that (4.1) cannot be asked
    // to fall. The same is true of the rule of four points.
    if(mesh_.density_mode() == Moving_triangulation_3::LINEAR
       || std::holds_alternative<Four_point_rule_3>(parameters_.quadrature))
      p.energy_tolerance = 1e-3;
    return p;
  }

  bool begin_iteration(const Round_plan& plan)
  {
    const double done = double(control_.number_of_iterations()) / plan.number_of_iterations();
    return control_.begin_iteration(share_of_rounds * (std::min)(1., done));
  }

  void end_iteration(Cell_order& order)
  {
    control_.end_iteration();
    order.maintain(mesh_);
  }

  C3t3& c3t3_;
  const Mesh_domain& domain_;
  const Odt_parameters& parameters_;
  Visitor& visitor_;
  User_fields_3<C3t3> fields_;
  Iteration_control<Visitor> control_;
  Moving_triangulation_3 mesh_;
  Odt_objective_3::Density density_;
  Surface_cvt_objective_3::Density surface_density_;
  Care care_ = SWIFT;
  Mesh_optimization_return_code code_ = CANT_IMPROVE_ANYMORE;
  Oracle_statistics oracle_statistics_;
  double search_begin_ = 0;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ODT_MESH_OPTIMIZER_3_H
