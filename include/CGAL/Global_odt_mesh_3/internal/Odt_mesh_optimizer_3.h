// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ODT_MESH_OPTIMIZER_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ODT_MESH_OPTIMIZER_3_H

#include <CGAL/Global_odt_mesh_3/internal/C3t3_bridge_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Input_density_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Limited_memory_bfgs.h>
#include <CGAL/Global_odt_mesh_3/internal/Momentum_annealing.h>
#include <CGAL/Global_odt_mesh_3/internal/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Odt_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/Sliver_removal_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Surface_cvt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/Tangential_motion.h>

#include <CGAL/Mesh_optimization_return_code.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Algorithm 1 of the paper on a c3t3, with vertices that also move on surfaces.
//
// While the boundary moves, the facets between subdomains are walls of the flat
// triangulation. After some iterations, the exact triangulation and its restriction to the
// domain are built anew, which brings other walls; that is a round. In the first rounds, the
// surfaces go toward a centroidal Voronoi tessellation (section 5.1), which leads to a lower
// minimum in the next, where all vertices move together. In the end the boundary rests and
// the interior goes on to its minimum.
template <class C3t3, class Mesh_domain, class Visitor>
class Odt_mesh_optimizer_3
{
public:
  Odt_mesh_optimizer_3(C3t3& c3t3, const Mesh_domain& domain,
                       const Odt_parameters& parameters, Visitor& visitor)
    : c3t3_(c3t3)
    , domain_(domain)
    , parameters_(parameters)
    , visitor_(visitor)
  {}

  Mesh_optimization_return_code operator()()
  {
    timer_.start();
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

  // As CGAL's optimizers, which bound the number of iterations even if the user
  // does not.
  static constexpr int usual_most_iterations = 1000;
  static constexpr std::size_t iterations_between_compactions = 50;
  static constexpr int iterations_to_freeze = 6;

  static constexpr int iterations_in_round = 20;
  static constexpr int rounds_of_remeshing = 4;
  static constexpr int iterations_per_round_of_remeshing = 60;    // of the user's, so that most remain
  static constexpr int iterations_inside_while_remeshing = 10;
  static constexpr int most_rounds_of_minimizer = 12;
  static constexpr int careful_rounds_of_minimizer = 2;
  static constexpr int most_tries_of_last_round = 3;
  static constexpr double least_gain_of_round = 2e-4;     // of the energy, relatively
  static constexpr double longest_way_in_round = 0.3;     // of a surface vertex, over its shortest edge on the surface
  static constexpr int most_sliver_rounds = 5;
  static constexpr double share_of_rounds = 0.6;          // of the progress that is reported

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
    bridge.load(mesh_, care != BOUNDARY_FIXED);
    number_of_iterations_ = 0;
    still_.clear();
    code_ = parameters_.do_freeze && !parameters_.remesh_boundary ? ALL_VERTICES_FROZEN : CONVERGENCE_REACHED;
    if(mesh_.number_of_movable_vertices == 0)
      return true;
    if(care == SWIFT && bridge.is_rough())
      return false;

    Input_density_3 input_density(mesh_);
    is_graded_ = !input_density.is_uniform();
    density_ = surface_density_ = nullptr;
    if(is_graded_)
    {
      mesh_.density.resize(mesh_.sites.size());
      for(std::size_t v = 0; v < mesh_.sites.size(); ++v)
        mesh_.density[v] = input_density.density(input_density.sizes()[v]);
      density_ = [&input_density](int v, const Site& s)
                 { return input_density.density(input_density.size(v, s)); };
      surface_density_ = [&input_density, this](int v, const Site& s)
                         { return input_density.surface_density(v < mesh_.number_of_movable_vertices
                                                                  ? input_density.size(v, s)
                                                                  : input_density.sizes()[v]); };
    }
    if(!make_rounds(bridge, care))
      return false;
    if(goes_on_ && !parameters_.remesh_boundary)
    {
      const int before = number_of_iterations_;
      if(!minimize_interior())
        return false;
      if(!remove_slivers(bridge, care, number_of_iterations_ > before))
        return false;
    }
    bridge.commit();
    visitor_.after_rebuild_restricted_delaunay();
    return true;
  }

  // What the vertices do in a round: those of surfaces go toward a restricted CVT while the interior
  // goes to its minimum; all of them search globally; or all of them go to the minimum.
  enum Stage { REMESH, SEARCH, MINIMIZE };

  // Rounds of these stages, the last as long as they pay. False if they lead to no valid complex.
  // Whether the time and the iterations permit to go on is in goes_on_.
  bool make_rounds(Bridge& bridge, Care care)
  {
    const bool boundary_moves = number_of_surface_vertices() > 0;
    const bool only_remeshes = parameters_.remesh_boundary;
    // Steps on a rough surface hide what is gained, so that the number of rounds is given.
    const int minimizer_rounds = care == CAREFUL ? careful_rounds_of_minimizer : most_rounds_of_minimizer;
    const int remesh_rounds = !boundary_moves ? 0 : only_remeshes ? rounds_of_remeshing + minimizer_rounds
                              : (std::min)(rounds_of_remeshing, most_iterations() / iterations_per_round_of_remeshing);
    const int search_rounds = only_remeshes ? 0 : static_cast<int>(parameters_.number_of_rounds);
    int rounds = remesh_rounds + search_rounds
                 + (boundary_moves && !only_remeshes ? minimizer_rounds : 0);
    int tries = most_tries_of_last_round;
    Momentum_annealing annealing(parameters_.random_seed);
    double energy = (std::numeric_limits<double>::max)();
    Stage previous = REMESH;
    bool is_last = false;
    goes_on_ = true;
    for(int round = 0, round_of_stage = 0; round < rounds && !is_last; ++round, ++round_of_stage)
    {
      const Stage stage = round < remesh_rounds ? REMESH : round < remesh_rounds + search_rounds ? SEARCH : MINIMIZE;
      if(stage != previous)
      {
        energy = (std::numeric_limits<double>::max)();
        round_of_stage = 0;
        previous = stage;
      }
      Odt_objective_3 objective(mesh_, density_, tangential_motions(bridge.complex(), stage != REMESH));
      if(!objective.is_feasible())
        return false;
      Limited_memory_bfgs minimizer(minimizer_parameters());
      annealing.start(objective);
      const int iterations = stage == REMESH ? iterations_inside_while_remeshing : iterations_in_round;
      for(int n = 0; n < iterations; ++n)
      {
        const double in_round = n / double(iterations);
        goes_on_ = begin_iteration(share_of_rounds * (round + in_round) / rounds);
        if(!goes_on_)
          break;
        if(stage == SEARCH)
          annealing.iterate(objective, (round_of_stage + in_round) / search_rounds);
        else if(minimizer.iterate(objective) == Limited_memory_bfgs::NO_STEP_FOUND)
          break;
        end_iteration();
      }
      const double reached = stage == REMESH ? remesh_surfaces(bridge.complex()) : objective.value();
      const bool pays = stage == SEARCH || (stage == REMESH && !only_remeshes) || care == CAREFUL
                        || reached < (1 - least_gain_of_round) * energy;
      is_last = !goes_on_ || !pays || round + 1 == rounds;
      if(only_remeshes && goes_on_ && pays && is_last)
        code_ = MAX_ITERATION_NUMBER_REACHED;
      energy = reached;
      if(!boundary_moves && goes_on_)
        continue;
      // The closest point of a polyhedral surface is cheap.
      const bool projects = is_last || care == CAREFUL || Has_aabb_tree<Mesh_domain>::value;
      const typename Update::Evidence evidence
        = care == CAREFUL ? Update::ORACLE : is_last ? Update::GOOD_EVIDENCE : Update::SOME_EVIDENCE;
      const Update mode = { boundary_moves, boundary_moves && projects, evidence, is_last };
      const bool is_stored = bridge.store(mesh_, mode);
      if(!is_stored && is_last && care == SWIFT)
      {
        if(!goes_on_ || --tries == 0)
          return false;
        is_last = false;
        ++rounds;
      }
      // A round that leads nowhere is lost.
      bridge.reload(mesh_);
    }
    return true;
  }

  // A round of the restricted CVT of the surfaces (section 5.1 of the paper); the interior follows
  // in the next. Gives the energy that is reached.
  double remesh_surfaces(const Complex& complex)
  {
    Surface_cvt_objective_3 objective(complex.boundary, mesh_.sites, mesh_.number_of_interior_vertices,
                                      tangential_motions(complex, true), surface_density_);
    Limited_memory_bfgs minimizer(minimizer_parameters());
    for(int n = 0; goes_on_ && n < iterations_in_round; ++n)
    {
      goes_on_ = begin_iteration(0);
      if(!goes_on_ || minimizer.iterate(objective) == Limited_memory_bfgs::NO_STEP_FOUND)
        break;
      end_iteration();
    }
    return objective.value();
  }

  std::vector<Tangential_motion> tangential_motions(const Complex& complex, bool moves) const
  {
    std::vector<Tangential_motion> motions;
    for(int v = mesh_.number_of_interior_vertices; v < mesh_.number_of_movable_vertices; ++v)
    {
      const Boundary_fan& fan = complex.boundary.fan(v, 0);
      motions.push_back({ fan.normal, moves && fan.is_smooth ? longest_way_in_round * fan.shortest_edge : 0.,
                          mesh_.sites[v] });
    }
    return motions;
  }

  Limited_memory_bfgs_parameters minimizer_parameters() const
  {
    Limited_memory_bfgs_parameters p;
    if(is_graded_)
    {
      // (4.6) is not the derivative of the interpolated energy (4.1), so that
      // (4.1) cannot be asked to fall.
      p.memory = 15;
      p.energy_tolerance = 1e-3;
    }
    return p;
  }

  // Takes the interior to its minimum, or to where the parameters say; false if
  // the flat triangulation is beyond repair.
  bool minimize_interior()
  {
    Odt_objective_3 objective(mesh_, density_);
    if(!objective.is_feasible())
      return false;
    Limited_memory_bfgs minimizer(minimizer_parameters());
    const double reported = fraction_;
    for(;;)
    {
      const double displacement = compute_displacements(objective);
      if(parameters_.do_freeze && objective.number_of_frozen_vertices() == mesh_.number_of_movable_vertices)
        code_ = ALL_VERTICES_FROZEN;
      else if(displacement < parameters_.convergence)
        code_ = CONVERGENCE_REACHED;
      else if(!begin_iteration(reported + (1 - reported) * progress_of(displacement)))
        break;
      else if(minimizer.iterate(objective) == Limited_memory_bfgs::NO_STEP_FOUND)
        code_ = CANT_IMPROVE_ANYMORE;
      else
      {
        end_iteration();
        continue;
      }
      break;
    }
    return true;
  }

  bool remove_slivers(Bridge& bridge, Care care, bool has_moved)
  {
    const typename Update::Evidence evidence = care == CAREFUL ? Update::ORACLE : Update::GOOD_EVIDENCE;
    for(int round = 0; ; ++round)
    {
      bool surface_moves = false;
      if(parameters_.sliver_bound > 0 && round < most_sliver_rounds)
      {
        std::vector<Site> before = mesh_.sites;
        const Complex& complex = bridge.complex();
        Sliver_removal_3 removal(mesh_, parameters_.sliver_bound + 2, parameters_.random_seed + round, [&](int v, Site& s)
        {
          const Boundary_fan& fan = complex.boundary.fan(v, 0);
          if(!fan.is_smooth && care != CAREFUL)
            return false;
          const Site& o = mesh_.sites[v];
          const double h = fan.normal[0] * (s.x - o.x) + fan.normal[1] * (s.y - o.y) + fan.normal[2] * (s.z - o.z);
          s = { s.x - h * fan.normal[0], s.y - h * fan.normal[1], s.z - h * fan.normal[2], s.weight };
          return bridge.put_on_surface(v, s);
        });
        for(int pass = 0; pass < 12; ++pass)
        {
          const std::size_t n = removal.pass();
          if(n == 0)
            break;
        }
        has_moved = has_moved || removal.moves > 0;
        for(int v = mesh_.number_of_interior_vertices; v < mesh_.number_of_movable_vertices && !surface_moves; ++v)
          surface_moves = mesh_.squared_distance(before[v], mesh_.sites[v]) > 0;
      }
      if(!has_moved)
        return true;
      const bool stored = bridge.store(mesh_, Update{ surface_moves, surface_moves, evidence, true });
      if(!stored && round == 0)
        return false;
      if(!stored || round == most_sliver_rounds)
        return true;
      has_moved = false;
      bridge.reload(mesh_);
    }
  }

  int most_iterations() const
  {
    const std::size_t most = parameters_.max_iteration_number;
    return most == 0 ? usual_most_iterations
                     : static_cast<int>((std::min)(most, std::size_t((std::numeric_limits<int>::max)())));
  }

  // False, with the reason in code_, if there is to be no further iteration.
  bool begin_iteration(double progress)
  {
    if(number_of_iterations_ >= most_iterations())
    {
      code_ = MAX_ITERATION_NUMBER_REACHED;
      return false;
    }
    if((parameters_.time_limit > 0 && timer_.time() > parameters_.time_limit)
       || !report_progress(progress, double(number_of_iterations_) / most_iterations()))
    {
      code_ = TIME_LIMIT_REACHED;
      return false;
    }
    visitor_.after_compute_moves();
    return true;
  }

  void end_iteration()
  {
    visitor_.after_move_points();
    visitor_.end_of_iteration(number_of_iterations_);
    ++number_of_iterations_;
    if(number_of_iterations_ % iterations_between_compactions == 0)
    {
      mesh_.topology.compact();
      mesh_.keep();
    }
  }

  // The displacement of a vertex is the length of the AVV move (2.3), |g|/D,
  // over its shortest edge. Freezes the vertices that are below freeze_bound for
  // some iterations and returns the mean of the largest displacements, one in five hundred.
  double compute_displacements(Odt_objective_3& objective)
  {
    const int n = mesh_.number_of_interior_vertices;
    if(n == 0)
      return 0;
    mesh_.shortest_edges(shortest_edge_);
    displacement_.resize(n);
    still_.resize(n, 0);
    const Eigen::VectorXd& g = objective.gradient();
    const Eigen::VectorXd& d = objective.diagonal();
    for(int v = 0; v < n; ++v)
    {
      displacement_[v] = g.segment<3>(3 * v).norm() / (d[3 * v] * shortest_edge_[v]);
      // A vertex may come to rest for a moment while those around it still move.
      still_[v] = displacement_[v] < parameters_.freeze_bound ? still_[v] + 1 : 0;
      if(parameters_.do_freeze && still_[v] == iterations_to_freeze)
        objective.freeze(v);
    }
    const std::size_t count = (std::max)(std::size_t(1), static_cast<std::size_t>(n) / 500);
    std::nth_element(displacement_.begin(), displacement_.begin() + (count - 1), displacement_.end(),
                     std::greater<double>());
    return std::accumulate(displacement_.begin(), displacement_.begin() + count, 0.) / double(count);
  }

  // In orders of magnitude.
  double progress_of(double displacement)
  {
    first_displacement_ = (std::max)(first_displacement_, displacement);
    if(!(parameters_.convergence > 0 && first_displacement_ > parameters_.convergence && displacement > 0))
      return 0;
    return std::log(first_displacement_ / displacement) / std::log(first_displacement_ / parameters_.convergence);
  }

  // The fraction done is the largest of those of the work, the iterations and the time.
  bool report_progress(double work, double iterations)
  {
    if(!parameters_.callback)
      return true;
    double fraction = (std::max)(work, iterations);
    if(parameters_.time_limit > 0)
      fraction = (std::max)(fraction, timer_.time() / parameters_.time_limit);
    fraction_ = (std::max)(fraction_, (std::min)(1., fraction));
    return parameters_.callback(fraction_);
  }

  C3t3& c3t3_;
  const Mesh_domain& domain_;
  const Odt_parameters& parameters_;
  Visitor& visitor_;
  Real_timer timer_;
  Moving_triangulation_3 mesh_;
  Odt_objective_3::Density density_;
  Surface_cvt_objective_3::Density surface_density_;
  bool is_graded_ = false;
  Mesh_optimization_return_code code_ = CANT_IMPROVE_ANYMORE;
  Oracle_statistics oracle_statistics_;
  std::vector<double> displacement_, shortest_edge_;
  std::vector<int> still_;
  int number_of_iterations_ = 0;
  bool goes_on_ = true;
  double first_displacement_ = 0;
  double fraction_ = 0;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_ODT_MESH_OPTIMIZER_3_H
