// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_TRIANGULATION_RESTORER_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_TRIANGULATION_RESTORER_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/For_each_in_chunks.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Cell_knowledge.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Numbered_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_state_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Gives a state that has lent its triangulation this one back, whatever has become of it, or another one. Symbolic perturbation makes
// the regular triangulation of weighted points unique; its cells are labelled, and boundary facets found, by their vertices.
class Triangulation_restorer_3
{
public:
  explicit Triangulation_restorer_3(Restricted_state_3& state)
    : state_(state)
  {}

  // Its vertices are at the sites.
  void operator()(std::unique_ptr<Numbered_triangulation_3> lent, const std::vector<Site>& sites, const Thread_policy& threads)
  {
    state_.facets.resize(state_.centers.size());
    state_.numbered = lent != nullptr ? std::move(lent) : std::make_unique<Numbered_triangulation_3>();
    if(!move_vertices(sites))
      build(threads);
    CGAL_assertion(state_.numbered->is_complete());
    label_cells(threads);
    state_.mark_facets();
  }

private:
  // The input is what it is, be it regular or not.
  void build(const Thread_policy& threads)
  {
    const Vertex_numbering_3& numbering = *state_.numbering;
    if(state_.is_input)
      state_.numbered->copy(numbering.input->read(threads), numbering.input_numbers, threads);
    else
      state_.numbered->build(state_.sites);
  }

  // False if that is not the way.
  bool move_vertices(const std::vector<Site>& sites)
  {
    if(state_.numbered->number_of_vertices() != sites.size() || sites.size() != state_.sites.size())
      return false;
    std::vector<int> moved;
    for(int v = 0; v < state_.numbering->number_of_vertices(); ++v)
      if(!same_place(sites[v], state_.sites[v]))
        moved.push_back(v);
    if(!state_.numbered->is_worth_moving(moved.size()) || (state_.is_input && !moved.empty()))
      return false;
    for(int v : moved)
      state_.numbered->move(v, state_.sites[v]);
    return state_.numbered->is_complete();
  }

  void label_cells(const Thread_policy& threads)
  {
    const std::vector<Cell_handle>& cells = state_.numbered->cells();
    for_each_in_chunks(static_cast<int>(cells.size()), threads, [&](int n) { label_cell(cells[n]); });
  }

  void label_cell(Cell_handle c)
  {
    forget(c);
    c->forget_facets();
    const Quadruple q = Numbered_triangulation_3::numbers(c);
    c->set_label(label(q));
    for(int i = 0; i < 4; ++i)
      find_facet(Facet(c, i), q);
  }

  int label(const Quadruple& q) const
  {
    if(*std::min_element(q.begin(), q.end()) < 0)
      return Domain_view_3::outside;
    for(int v : q)
      if(!state_.numbering->is_on_boundary(v))
        return state_.numbering->subdomain[v];
    const int of_state = state_.label_of_boundary_cell(q);
    CGAL_assertion(of_state != Restricted_state_3::no_subdomain);
    return of_state;
  }

  // If it is on the boundary, and seen from side 0.
  void find_facet(const Facet& f, const Quadruple& q)
  {
    for(int i = 1; i < 4; ++i)
      if(q[(f.second + i) % 4] < 0 || !state_.numbering->is_on_boundary(q[(f.second + i) % 4]))
        return;
    const Triple t = state_.numbered->vertices(f);
    const int n = state_.facet_number(t);
    if(n >= 0 && rotated(state_.boundary.complex().facets()[n].vertices) == t)
      state_.facets[n] = f;
  }

  Restricted_state_3& state_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_TRIANGULATION_RESTORER_3_H
