// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_BLOCKS_BLOCK_ANNEALING_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_BLOCKS_BLOCK_ANNEALING_3_H

#include <CGAL/Annealing_schedules_3.h>
#include <CGAL/Global_odt_mesh_3/internal/blocks/Mesh_blocks_3.h>
#include <CGAL/Global_odt_mesh_3/internal/blocks/Mesh_partition_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Momentum_annealing.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Tangential_motion.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Surface_cvt_term_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Momentum annealing of a large mesh, a few steps at a time in each of its blocks, which fit the caches and which
// threads work on at the same time. The next steps are made in other blocks.
class Block_annealing_3
{
public:
  // In one partition. They are so many more as there are vertices that rest, at seams, in each of them.
  static constexpr int iterations_in_block = 10, steps_in_block = 11;

  // That is worth the trouble. It depends on the mesh alone, so that the result does not depend on the threads.
  static int usual_number_of_blocks(std::size_t number_of_vertices)
  {
    return (std::max)(1, static_cast<int>(number_of_vertices / vertices_of_block));
  }

  Block_annealing_3(Moving_triangulation_3& mesh, int number_of_blocks, unsigned int seed, const Momentum_annealing_schedule& schedule,
                    const Thread_policy& threads)
    : mesh_(mesh)
    , number_of_blocks_(number_of_blocks)
    , random_(seed)
    , schedule_(schedule)
    , threads_(threads)
  {}

  // To be called when the vertices have got other neighbors or motions. The term, of which the energy has been asked for, is
  // null if there is none.
  void start(std::vector<Tangential_motion> motions, Surface_cvt_term_3* term)
  {
    motions_ = std::move(motions);
    term_ = term;
    velocity_ = Eigen::VectorXd::Zero(3 * mesh_.number_of_movable_vertices);
    mesh_.mean_edge_lengths(edge_length_);
  }

  // One step for each fraction of all steps in `done`. No block is begun once may_go_on(), which is asked in the
  // calling thread only, says no.
  template <class May_go_on>
  void iterate(const std::vector<double>& done, const May_go_on& may_go_on)
  {
    const Mesh_partition_3 partition(mesh_, number_of_blocks_, Random_source(random_.seed()), threads_);
    Mesh_blocks_3 blocks(mesh_, partition, threads_);
    if(mesh_.quadrature() != nullptr)
      mesh_.quadrature()->update(mesh_.sites, mesh_.number_of_movable_vertices, threads_);
    if(term_ != nullptr)
      term_->prepare_parts(mesh_.sites);
    std::vector<unsigned int> seeds(number_of_blocks_);
    for(unsigned int& seed : seeds)
      seed = random_.seed();
    const std::thread::id caller = std::this_thread::get_id();
    std::atomic<bool> stops(false);
    threads_.for_each_chunk(number_of_blocks_, [&](int n)
    {
      if(std::this_thread::get_id() == caller && !may_go_on())
        stops = true;
      Moving_triangulation_3 part;
      blocks.load(n, part);
      if(!stops && !anneal(part, blocks, n, seeds[n], done))
        blocks.load(n, part);
      blocks.store(n, part);
    });
    blocks.assemble();
  }

private:
  static constexpr int vertices_of_block = 20000;

  // False if the block cannot be made regular as it is, whereupon it has to be loaded again.
  bool anneal(Moving_triangulation_3& part, const Mesh_blocks_3& blocks, int n, unsigned int seed,
              const std::vector<double>& done)
  {
    const std::vector<int>& vertices = blocks.vertices(n);
    const int movable = part.number_of_movable_vertices, interior = part.number_of_interior_vertices;
    std::unique_ptr<Density_quadrature_3> quadrature;
    if(mesh_.quadrature() != nullptr)
      quadrature = mesh_.quadrature()->part(vertices);
    part.set_quadrature(quadrature.get());
    std::vector<Tangential_motion> motions;
    for(int v = interior; v < movable; ++v)
      motions.push_back(motions_[vertices[v] - mesh_.number_of_interior_vertices]);
    std::optional<Surface_cvt_term_3> term;
    if(term_ != nullptr)
      term.emplace(term_->part(vertices, interior, movable - interior, [&](int v) { return blocks.number(n, v); }));
    Odt_objective_3 objective(part, std::move(motions), term ? Odt_objective_3::Term(std::ref(*term)) : Odt_objective_3::Term());
    if(!objective.is_feasible())
      return false;
    Eigen::VectorXd velocity(3 * movable);
    std::vector<double> lengths;
    for(int v = 0; v < movable; ++v)
    {
      velocity.segment<3>(3 * v) = velocity_.segment<3>(3 * vertices[v]);
      lengths.push_back(edge_length_[vertices[v]]);
    }
    Momentum_annealing annealing(seed, schedule_);
    annealing.start(std::move(velocity), std::move(lengths));
    for(double fraction : done)
      annealing.iterate(objective, fraction);
    for(int v = 0; v < movable; ++v)
      velocity_.segment<3>(3 * vertices[v]) = annealing.velocity().segment<3>(3 * v);
    part.set_quadrature(nullptr);
    return true;
  }

  Moving_triangulation_3& mesh_;
  int number_of_blocks_;
  Random_source random_;
  Momentum_annealing_schedule schedule_;
  Thread_policy threads_;
  std::vector<Tangential_motion> motions_;
  Surface_cvt_term_3* term_ = nullptr;
  Eigen::VectorXd velocity_;
  std::vector<double> edge_length_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_BLOCKS_BLOCK_ANNEALING_3_H
