// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_REMOVAL_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_REMOVAL_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/blocks/Mesh_partition_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Sliver_improvement_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Constrained_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Indexed_triangulation_3.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Removes the cells with dihedral angles below a bound by moving single vertices: each vertex of
// such a cell tries random positions around it, and the one that lowers the deficit of the angles
// most is transferred. That disturbs few vertices, so that the energy hardly rises. Where no vertex
// helps alone, all those of a cell are displaced at once, and stay so if that leads to less deficit.
//
// Large meshes are first treated in parts, on threads, with other seams each time: inside, and then at surfaces. What is left
// at the seams is treated as a whole.
class Sliver_removal_3
{
public:
  // Without a motion, vertices of the interior go anywhere, and those on surfaces stay. The threads that are given last may
  // ask for the motion of vertices on surfaces.
  Sliver_removal_3(Constrained_triangulation_3& mesh, double bound, unsigned int seed,
                   Vertex_motion_3* motion = nullptr,
                   const Sliver_removal_parameters& parameters = Sliver_removal_parameters(),
                   const Thread_policy& threads = Thread_policy(), const Thread_policy& threads_at_surfaces = Thread_policy())
    : mesh_(mesh)
    , parameters_(parameters)
    , threads_(threads)
    , threads_at_surfaces_(threads_at_surfaces)
    , surfaces_move_(motion != nullptr && mesh.number_of_surface_vertices() > 0)
    , random_(seed)
    , improvement_(mesh, bound, seed, motion, parameters, threads)
  {}

  std::size_t number_of_moves() const { return improvement_.number_of_moves(); }
  std::size_t number_of_surface_moves() const { return improvement_.number_of_surface_moves(); }

  // Of single vertices, whatever became of them.
  std::size_t number_of_tries() const { return improvement_.number_of_tries(); }

  // Until there are no such cells, nothing improves them any more, the tries are used up, or `may_go_on()`,
  // asked before each of them, on threads, says no.
  template <class Predicate>
  void run(const Predicate& may_go_on)
  {
    const int parts = static_cast<int>(mesh_.sites.size()) / parameters_.vertices_of_part;
    for(bool at_surfaces : { false, true })
      for(int n = 0; n < parameters_.partitions && parts > 1 && (!at_surfaces || surfaces_move_) && may_go_on(); ++n)
        improve_parts(parts, at_surfaces, may_go_on);
    int joint_tries = parameters_.most_joint_tries;
    do
      for(int n = 0; n < parameters_.most_passes && improvement_.improve(all_slivers(), may_go_on); ++n) {}
    while(displace_slivers(joint_tries, may_go_on));
  }

  void run() { run([] { return true; }); }

private:
  std::vector<int> all_slivers() const
  {
    return improvement_.sort(collect_in_chunks(mesh_.topology.number_of_cell_slots(), threads_,
                                               [this](int c, std::vector<int>& found)
    {
      if(improvement_.is_sliver(c))
        found.push_back(c);
    }));
  }

  // Each part gets a share of the tries for the slivers that it has, those at surfaces or only the others.
  template <class Predicate>
  void improve_parts(int number_of_parts, bool at_surfaces, const Predicate& may_go_on)
  {
    const Mesh_parts_3 parts(mesh_, number_of_parts, Random_source(random_.seed()), threads_);
    const std::vector<int> all = all_slivers();
    if(all.empty() || !improvement_.has_tries())
      return;
    std::vector<std::vector<int> > slivers(number_of_parts);
    for(int c : all)
      if(const int part = parts.part(mesh_.topology.cell(c)); part != Mesh_parts_3::none && (at_surfaces || is_inside(c)))
        slivers[part].push_back(c);
    const std::size_t tries_for_each = (parameters_.most_tries - improvement_.number_of_tries()) / all.size();
    std::vector<Indexed_triangulation_3> topologies = mesh_.topology.split(number_of_parts, parameters_.free_cells_of_part);
    improvement_.make_room();
    std::deque<Sliver_improvement_3> improvements;
    for(int n = 0; n < number_of_parts; ++n)
      improvements.emplace_back(improvement_, topologies[n], parts, n, at_surfaces, random_.seed(),
                                tries_for_each * slivers[n].size());
    const Thread_policy& threads = at_surfaces ? threads_at_surfaces_ : threads_;
    threads.for_each_chunk(number_of_parts, [&](int n) { improvements[n].improve_repeatedly(slivers[n], may_go_on); });
    mesh_.topology.join(topologies);
    for(const Sliver_improvement_3& part : improvements)
      improvement_.join(part);
  }

  bool is_inside(int c) const
  {
    const int* const v = mesh_.topology.vertices(c);
    return std::all_of(v, v + 4, [this](int w) { return w < mesh_.number_of_interior_vertices; });
  }

  // Whether something has been improved, within a number of tries.
  template <class Predicate>
  bool displace_slivers(int& joint_tries, const Predicate& may_go_on)
  {
    bool improved = false;
    for(int c : all_slivers())
      for(int n = 0; n < parameters_.joint_tries_per_sliver && improvement_.is_sliver(c); ++n)
      {
        if(!improvement_.has_tries() || --joint_tries < 0 || !may_go_on())
          return false;
        if(improvement_.displace_vertices(c, may_go_on))
          improved = true;
      }
    return improved;
  }

  Constrained_triangulation_3& mesh_;
  Sliver_removal_parameters parameters_;
  Thread_policy threads_, threads_at_surfaces_;
  bool surfaces_move_;
  Random_source random_;
  Sliver_improvement_3 improvement_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_SLIVERS_SLIVER_REMOVAL_3_H
