// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_BLOCKS_BLOCK_ANNEALING_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_BLOCKS_BLOCK_ANNEALING_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Annealing_schedules_3.h>
#include <CGAL/Global_odt_mesh_3/internal/blocks/Mesh_blocks_3.h>
#include <CGAL/Global_odt_mesh_3/internal/blocks/Mesh_partition_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/energy/Odt_cell_energies_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Annealing.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Surface_cvt_objective_3.h>
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

namespace CGAL::Global_odt_mesh_3::internal {

// Momentum annealing of a large mesh, a few steps at a time in each of its blocks, which fit the caches and which
// threads work on at the same time. The next steps are made in other blocks.
class Block_annealing_3
{
public:
  // Steps for each partition. One more than the iterations that they count as, since vertices at the seams of the partition do not move.
  static constexpr int iterations_in_block = 10, steps_in_block = 11;

  // The number of blocks that pays. It depends on the mesh alone, so that the result does not depend on the threads; but numbers of
  // threads that are powers of two should have as many blocks each.
  static int usual_number_of_blocks(std::size_t number_of_vertices)
  {
    const int number = (std::max)(1, static_cast<int>(number_of_vertices / vertices_of_block));
    int unit = 1;
    while(6 * unit <= number)
      unit *= 2;
    return number / unit * unit;
  }

  Block_annealing_3(Moving_triangulation_3& mesh, int number_of_blocks, unsigned int seed,
                    const Momentum_annealing_schedule& schedule, const Thread_policy& threads)
    : mesh_(mesh)
    , number_of_blocks_(number_of_blocks)
    , random_(seed)
    , schedule_(schedule)
    , threads_(threads)
  {}

  // This has to be called when the vertices have got other neighbors or motions. The term, whose energy has been computed before,
  // is null if there is none.
  void start(std::vector<Tangential_motion> motions, Surface_cvt_term_3* term)
  {
    motions_ = std::move(motions);
    term_ = term;
    velocity_ = Eigen::VectorXd::Zero(3 * mesh_.number_of_movable_vertices);
    if(mesh_.quadrature() != nullptr)
      mesh_.quadrature()->update(mesh_.sites, mesh_.number_of_movable_vertices, threads_);
    threads_.run_both([this] { mesh_.mean_edge_lengths(edge_length_); }, [this] { mesh_.is_regular(); });
    gradient_.resize(mesh_.sites.size());
    mesh_.for_each_gradient([this](int v, const Site_gradient& g) { gradient_[v] = g; });
    mesh_.release_gradient();
  }

  // Makes one step for each fraction of all steps in `done`. No block is begun once may_go_on() returns false, which is
  // called in the calling thread only.
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
    std::vector<std::vector<Site_gradient> > gradient_at_seams(number_of_blocks_);
    const std::thread::id caller = std::this_thread::get_id();
    std::atomic<bool> stops(false);
    std::atomic<int> number_of_begun(0);
    const std::vector<int> order = partition.largest_first();
    // Each thread takes the largest block that is left, whatever the number that it gets.
    threads_.for_each_chunk(number_of_blocks_, [&](int)
    {
      const int n = order[number_of_begun++];
      if(std::this_thread::get_id() == caller && !threads_.call_isolated(may_go_on))
        stops = true;
      Moving_triangulation_3 part;
      blocks.load(n, part);
      if(!stops)
        anneal(part, blocks, n, seeds[n], done, gradient_at_seams[n]);
      blocks.store(n, part);
    });
    if(!stops)
      add_gradients(blocks, gradient_at_seams);
    blocks.assemble();
  }

private:
  static constexpr int vertices_of_block = 10000;

  // What the block adds to the gradients of vertices that it does not own goes into `at_seams`.
  void anneal(Moving_triangulation_3& part, const Mesh_blocks_3& blocks, int n, unsigned int seed,
              const std::vector<double>& done, std::vector<Site_gradient>& at_seams)
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
    Odt_objective_3 objective(part, std::move(motions), term ? Odt_objective_3::Term(std::ref(*term)) : Odt_objective_3::Term(),
                              [&](int v) { return gradient_[vertices[v]]; });
    Eigen::VectorXd velocity(3 * movable);
    std::vector<double> lengths;
    for(int v = 0; v < movable; ++v)
    {
      set_vector(velocity, v, vector_at(velocity_, vertices[v]));
      lengths.push_back(edge_length_[vertices[v]]);
    }
    Momentum_annealing annealing(seed, schedule_);
    annealing.start(std::move(velocity), std::move(lengths));
    bool is_taken = false;
    for(double fraction : done)
      is_taken = annealing.iterate(objective, fraction);
    if(!is_taken)           // the gradient is lost
      part.is_regular();
    for(int v = 0; v < movable; ++v)
      set_vector(velocity_, vertices[v], vector_at(annealing.velocity(), v));
    at_seams.resize(vertices.size() - blocks.number_of_own_vertices(n));
    part.for_each_gradient([&](int v, const Site_gradient& g)
    {
      (v < blocks.number_of_own_vertices(n) ? gradient_[vertices[v]] : at_seams[v - blocks.number_of_own_vertices(n)]) = g;
    });
    part.set_quadrature(nullptr);
  }

  // Adds the gradients of the vertices that no block owns.
  void add_gradients(const Mesh_blocks_3& blocks, const std::vector<std::vector<Site_gradient> >& at_seams)
  {
    const auto for_each = [&](const auto& f)
    {
      for(int n = 0; n < number_of_blocks_; ++n)
        for(std::size_t k = 0; k < at_seams[n].size(); ++k)
          f(gradient_[blocks.vertices(n)[blocks.number_of_own_vertices(n) + k]], at_seams[n][k]);
    };
    for_each([](Site_gradient& sum, const Site_gradient&) { sum = Site_gradient{ 0, 0, 0, 0 }; });
    for_each([](Site_gradient& sum, const Site_gradient& g) { sum += g; });
  }

  Moving_triangulation_3& mesh_;
  int number_of_blocks_;
  Random_source random_;
  Momentum_annealing_schedule schedule_;
  Thread_policy threads_;
  std::vector<Tangential_motion> motions_;
  Surface_cvt_term_3* term_ = nullptr;
  Eigen::VectorXd velocity_;
  std::vector<Site_gradient> gradient_;     // where the block begins, up to facets at seams that are not regular
  std::vector<double> edge_length_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_BLOCKS_BLOCK_ANNEALING_3_H
