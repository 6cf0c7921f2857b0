// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_CELL_LABELS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_CELL_LABELS_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_products_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Cell_knowledge.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Cell_mending_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Domain_oracle_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Guilty_vertices_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_draft_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_update.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// Labels the cells of a draft.
//
// Where a vertex has no boundary facet, its subdomain is the label. A cell with all
// vertices on the boundary is labelled by the side on which its dual point lies, as seen
// from its vertices where these agree and see it clearly, and else as the domain says.
template <class Triangulation, class Mesh_domain>
class Cell_labels_3
{
public:
  typedef Restricted_draft_3<Triangulation, Mesh_domain> Draft;
  typedef typename Draft::Complex Complex;
  typedef Domain_oracle_3<Mesh_domain> Oracle;
  typedef Guilty_vertices_3<Triangulation, Mesh_domain> Guilty_vertices;
  typedef Cell_mending_3<Triangulation, Mesh_domain> Cell_mending;

  Cell_labels_3(Complex& complex, Draft& draft, Oracle& oracle, Guilty_vertices& guilty, Cell_mending& mending)
    : complex_(complex)
    , draft_(draft)
    , oracle_(oracle)
    , guilty_(guilty)
    , mending_(mending)
  {}

  // For a new draft.
  void start()
  {
    doubted_.assign(complex_.sites.size(), false);
    has_doubts_ = false;
  }

  // Once more as long as normals are found not to tell sides.
  void label_cells()
  {
    do
    {
      guilty_.clear();
      has_new_doubts_ = false;
      label_unsettled_cells();
    }
    while(has_new_doubts_);
  }

private:
  typedef typename Draft::Quadruple Quadruple;
  typedef typename Draft::Cell_handle Cell_handle;
  typedef std::array<double, 3> Vector;

  static constexpr double good_margin = 0.3, some_margin = 0.05;
  static constexpr int no_subdomain = Complex::no_subdomain;

  bool is_on_boundary(int v) const { return complex_.is_on_boundary(v); }

  void label_unsettled_cells()
  {
    Triangulation& tr = draft_.numbered.triangulation();
    draft_.boundary_cells.clear();
    for(auto c = tr.all_cells_begin(); c != tr.all_cells_end(); ++c)
    {
      if(!is_settled(c))
      {
        forget(Cell_handle(c));
        label_cell(c);
      }
      if(knows(Cell_handle(c), IS_BOUNDARY_CELL))
        draft_.boundary_cells.emplace_back(c, complex_.labels.number(c->subdomain_index()));
    }
  }

  bool is_settled(Cell_handle c) const
  {
    if(!knows(c, IS_SETTLED) || !has_doubts_ || knows(c, IS_FROM_ORACLE) || draft_.triangulation().is_infinite(c))
      return knows(c, IS_SETTLED);
    const Quadruple q = draft_.numbers(c);
    return std::none_of(q.begin(), q.end(), [this](int v) { return doubted_[v]; });
  }

  void label_cell(Cell_handle c)
  {
    const Triangulation& tr = draft_.triangulation();
    Quadruple q;
    int label = no_subdomain;
    for(int i = 0; i < 4; ++i)
    {
      q[i] = tr.is_infinite(c->vertex(i)) ? -1 : draft_.numbered.number(c->vertex(i));
      const int l = q[i] < 0 ? complex_.outside() : complex_.subdomain[q[i]];
      if(l == no_subdomain || l == label)
        continue;
      if(label != no_subdomain)
      {
        guilty_.blame(q);
        return;
      }
      label = l;
    }
    if(tr.is_infinite(c))
      label = complex_.outside();
    else if(label == no_subdomain)
    {
      label = label_of_boundary_cell(c, q);
      note(c, IS_BOUNDARY_CELL);
    }
    else if(std::any_of(q.begin(), q.end(), [this](int v) { return is_on_boundary(v); })
            && dual_label(c, q) != label && !mending_.is_excused(q))
    {
      mending_.mend_cell(q, label);
      c->set_subdomain_index(complex_.labels.value(label));
      return;
    }
    c->set_subdomain_index(complex_.labels.value(label));
    note(c, IS_SETTLED);
  }

  int label_of_boundary_cell(Cell_handle c, const Quadruple& q)
  {
    if(draft_.are_home(q))
    {
      const int label = complex_.label_of_boundary_cell(q);
      if(label != no_subdomain)
        return label;
    }
    return draft_.mode.boundary_moves ? dual_label(c, q) : label_from_oracle(c);
  }

  // The subdomain in which the dual point of the cell lies: as the normals at its
  // vertices tell, or as the domain says. The domain is asked where the normals are not
  // clear; where it contradicts them nevertheless, they are not believed any more.
  int dual_label(Cell_handle c, const Quadruple& q)
  {
    const Restricted_update::Evidence evidence = draft_.mode.evidence;
    const double margin = evidence == Restricted_update::SOME_EVIDENCE ? some_margin : good_margin;
    const bool is_doubtful = evidence == Restricted_update::ORACLE
      || std::any_of(q.begin(), q.end(), [this](int v) { return is_on_boundary(v) && doubted_[v]; });
    const int seen = is_doubtful ? int(no_subdomain) : label_seen_from_boundary(q, margin);
    if(seen != no_subdomain)
      return seen;
    const int label = label_from_oracle(c);
    note(c, IS_FROM_ORACLE);
    if(evidence == Restricted_update::GOOD_EVIDENCE)
    {
      const int expected = label_seen_from_boundary(q, margin / 2);
      if(expected != no_subdomain && expected != label)
        doubt(q);
    }
    return label;
  }

  int label_from_oracle(Cell_handle c)
  {
    return complex_.labels.number(oracle_.subdomain(draft_.triangulation().dual(c)));
  }

  void doubt(const Quadruple& q)
  {
    for(int v : q)
      if(is_on_boundary(v) && !doubted_[v])
        doubted_[v] = has_doubts_ = has_new_doubts_ = true;
  }

  // The label of the dual point if all vertices on the boundary agree about it.
  int label_seen_from_boundary(const Quadruple& q, double margin) const
  {
    const std::vector<Site>& sites = draft_.sites;
    const Site& origin = sites[q[0]];
    const Cell_products t(origin, sites[q[1]], sites[q[2]], sites[q[3]]);
    const double f = 1 / (2 * t.determinant);
    const Vector dual = {{ f * t.nx, f * t.ny, f * t.nz }};       // from the first vertex
    int label = no_subdomain;
    for(int v : q)
    {
      if(!is_on_boundary(v))
        continue;
      const Site& s = sites[v];
      const int l = draft_.measured_boundary.label_toward(
        v, {{ dual[0] - (s.x - origin.x), dual[1] - (s.y - origin.y), dual[2] - (s.z - origin.z) }}, margin);
      if(l == no_subdomain || (label != no_subdomain && l != label))
        return no_subdomain;
      label = l;
    }
    return label;
  }

  Complex& complex_;
  Draft& draft_;
  Oracle& oracle_;
  Guilty_vertices& guilty_;
  Cell_mending& mending_;
  std::vector<char> doubted_;               // vertices whose normals do not tell sides
  bool has_doubts_ = false, has_new_doubts_ = false;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_CELL_LABELS_3_H
