// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CELL_LABELS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CELL_LABELS_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Defect_report_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Chunked_loops.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Labels the cells of a candidate, and reports those that no label fits.
//
// A cell with an interior vertex has the label of that vertex's subdomain, and its dual point must be there. A cell with all
// vertices on the boundary gets the label of the subdomain that contains its dual point. The domain is asked about cells at the
// boundary and, in a final candidate, about all others, too: details that the samples miss leave holes without boundary facets.
class Cell_labels_3
{
public:
  Cell_labels_3(Complex_candidate_3& candidate, const Domain_view_3& domain)
    : candidate_(candidate)
    , triangulation_(candidate.triangulation)
    , domain_(domain)
  {}

  Defect_report_3 label_cells()
  {
    Defect_report_3 report(candidate_);
    const std::vector<int>& cells = triangulation_.cells();
    const auto find_cells_in_question = [&](int n, std::vector<int>& found)
    {
      const bool is_labelled = triangulation_.has_flag(cells[n], IS_LABELLED) || label_by_vertices(cells[n]);
      if(!is_labelled || triangulation_.has_flag(cells[n], MAY_HAVE_BOUNDARY_FACETS))
        found.push_back(n);
    };
    const std::vector<int> in_question
      = collect_in_chunks(static_cast<int>(cells.size()), candidate_.threads, find_cells_in_question);
    typedef std::pair<int, Findings> Unlabelled_cell;
    const auto label_where_clear = [&](int n, std::vector<Unlabelled_cell>& found)
    {
      const int c = cells[in_question[n]];
      if(triangulation_.has_flag(c, IS_LABELLED))
        return;
      const Findings findings = examine(c);
      if(!label_if_domain_agrees(c, findings))
        found.emplace_back(c, findings);
    };
    for(const Unlabelled_cell& d : domain_.collect<Unlabelled_cell>(in_question.size(), label_where_clear))
      label_or_report(d.first, d.second, report);
    if(domain_.has_cells_of_mesh())
      leave_out_flat_cells(in_question);
    collect_cells_at_boundary(in_question);
    return report;
  }

private:
  // What is known of a cell: the common label of its vertices off the boundary, if any, or whether these have several labels, and
  // the label of its dual point.
  struct Findings
  {
    bool has_several_labels = false;
    int label = no_subdomain, label_of_dual = no_subdomain;
  };

  // The dual point of a cell is accurate to nine digits if six times its volume exceeds this, over the cube of the longest edge at
  // a vertex.
  static constexpr double certain_volume = 1e-6;
  static constexpr double flattest = 1e-3;            // how thick a flat cell is at most for its width: thin layers have thicker cells
  static constexpr int no_subdomain = Complex_snapshot_3::no_subdomain;
  static_assert(no_subdomain == int(Boundary_geometry_3::no_label), "no label");

  bool is_on_boundary(int v) const { return candidate_.numbering.is_on_boundary(v); }

  // Resets the flags of a cell, and labels it if its vertices determine the label; whether it has done so.
  bool label_by_vertices(int c) const
  {
    triangulation_.clear_flags(c);
    const Quadruple& q = triangulation_.vertices(c);
    const bool is_infinite = std::find(q.begin(), q.end(), -1) != q.end();
    const auto on_boundary
      = is_infinite ? 0 : std::count_if(q.begin(), q.end(), [this](int v) { return is_on_boundary(v); });
    if(on_boundary >= 3)
      triangulation_.set_flag(c, MAY_HAVE_BOUNDARY_FACETS);
    const bool is_in_question = on_boundary > 0 || (!is_infinite && candidate_.is_final);
    int label;
    if(is_in_question || !candidate_.numbering.find_label(q, label))
      return false;
    triangulation_.set_label(c, label);
    triangulation_.set_flag(c, IS_LABELLED);
    return true;
  }

  Findings examine(int c) const
  {
    Findings found;
    const Quadruple& q = triangulation_.vertices(c);
    found.has_several_labels = !candidate_.numbering.find_label(q, found.label);
    if(found.has_several_labels)
      return found;
    const bool is_boundary_cell = found.label == no_subdomain;
    if(is_boundary_cell)
      found.label_of_dual = known_label_of_dual(q);
    if(found.label_of_dual != no_subdomain)
      return found;
    found.label_of_dual = domain_.label(triangulation_.dual_point(c));
    if(domain_.has_cells_of_mesh() && (is_boundary_cell ? !may_flip(c) : found.label_of_dual != found.label))
      found.label_of_dual = domain_.label(internal::centroid(triangulation_.cell_sites(c)));
    return found;
  }

  // Labels a cell if the domain agrees; otherwise leaves it unchanged.
  bool label_if_domain_agrees(int c, const Findings& found) const
  {
    const bool is_boundary_cell = found.label == no_subdomain;
    if(found.has_several_labels || (!is_boundary_cell && found.label != found.label_of_dual))
      return false;
    triangulation_.set_label(c, found.label_of_dual);
    triangulation_.set_flag(c, IS_LABELLED);
    return true;
  }

  // Flat cells beside cells outside are outside, too: they would be slivers that stay if their vertices are on features.
  void leave_out_flat_cells(const std::vector<int>& numbers) const
  {
    const double thickness = rounding_of_coordinates(candidate_.sites);
    const auto label = [this](int c) { return triangulation_.label(c); };
    const auto is_in_question = [&](int c)
    { return label(c) != Domain_view_3::outside && triangulation_.has_flag(c, MAY_HAVE_BOUNDARY_FACETS) && is_flat(c, thickness)
             && known_label_of_dual(triangulation_.vertices(c)) == no_subdomain; };
    std::vector<int> cells;
    for(int n : numbers)
      if(const int c = triangulation_.cells()[n]; is_in_question(c))
        cells.push_back(c);
    while(!cells.empty())
    {
      const int c = cells.back();
      cells.pop_back();
      const Quadruple around = {{ triangulation_.neighbor(c, 0), triangulation_.neighbor(c, 1), triangulation_.neighbor(c, 2),
                                  triangulation_.neighbor(c, 3) }};
      if(std::none_of(around.begin(), around.end(), [&](int d) { return label(d) == Domain_view_3::outside; }))
        continue;
      triangulation_.set_label(c, Domain_view_3::outside);
      std::copy_if(around.begin(), around.end(), std::back_inserter(cells), is_in_question);
    }
  }

  // Whether all vertices of a cell are on the boundary and, but for the rounding of coordinates, in one plane.
  bool is_flat(int c, double thickness) const
  {
    const Quadruple& q = triangulation_.vertices(c);
    if(!std::all_of(q.begin(), q.end(), [this](int v) { return v >= 0 && is_on_boundary(v); }))
      return false;
    const Cell_facets_3 facets(triangulation_.cell_sites(c));
    const double area = *std::max_element(facets.area.begin(), facets.area.end());
    return products(q).determinant <= (std::min)(thickness, flattest * std::sqrt(area)) * area;
  }

  // Reports a cell whose vertices have come too close to the boundary.
  void label_or_report(int c, const Findings& found, Defect_report_3& report)
  {
    const Quadruple& q = triangulation_.vertices(c);
    triangulation_.set_label(c, found.label);
    // A label that was wrong in the input may stay so.
    if(!found.has_several_labels && candidate_.has_way_back && is_input_cell(q))
      triangulation_.set_flag(c, IS_LABELLED);
    else
      report.revert_or_retreat(q, found.has_several_labels ? centroid(sorted(q)) : dual_point(sorted(q)));
  }

  // Whether the cell is one of the snapshot, with its vertices where they were in the input.
  bool is_input_cell(const Quadruple& q) const
  { return candidate_.numbering.are_at_input(q, candidate_.sites) && candidate_.snapshot.triangulation.find_cell(q) >= 0; }

  // The dual point, computed with the vertices in this order.
  Vector_3 dual_point(const Quadruple& q) const { return position(candidate_.sites[q[0]]) + products(q).to_dual(); }

  // The centroid of the finite vertices.
  Vector_3 centroid(const Quadruple& q) const
  {
    const double number = double(std::count_if(q.begin(), q.end(), [](int v) { return v >= 0; }));
    Vector_3 result;
    for(int v : q)
      if(v >= 0)
        result += position(candidate_.sites[v]) / number;
    return result;
  }

  // Collects those of the cells with these numbers that may have boundary facets.
  void collect_cells_at_boundary(const std::vector<int>& numbers)
  {
    candidate_.cells_at_boundary.clear();
    for(int n : numbers)
      if(const int c = triangulation_.cells()[n]; triangulation_.has_flag(c, MAY_HAVE_BOUNDARY_FACETS))
        candidate_.cells_at_boundary.push_back(c);
  }

  // The label of the dual point of a cell with all vertices on the boundary, or no_subdomain if the domain has to be asked. An
  // unchanged cell may be so flat that, by rounding, its dual point depends on the order of its vertices, which may differ from
  // that in the snapshot. A cell of the input gets its original order when the snapshot is written; others keep their labels only
  // if the boundary has to stay.
  int known_label_of_dual(const Quadruple& q) const
  {
    if(!candidate_.is_unchanged(q))
      return no_subdomain;
    const Complex_snapshot_3& snapshot = candidate_.snapshot;
    if(domain_.has_cells_of_mesh() || (snapshot.has_labels_of_domain && is_dual_point_certain(q)))
      return snapshot.label_of_cell(q);
    if(const Vertex_numbering_3::Input_cell* const c = candidate_.numbering.input_cell(q, candidate_.sites))
      return c->label;
    return snapshot.has_labels_of_domain && !candidate_.boundary_moves() ? snapshot.label_of_cell(q) : no_subdomain;
  }

  // Whether the boundary may exchange two facets of the cell for the other two. For a cell that does not have exactly two boundary
  // facets, whether one of its vertices may move.
  bool may_flip(int c) const
  {
    if(!candidate_.boundary_moves() || !candidate_.has_way_back)
      return false;
    const Quadruple& q = triangulation_.vertices(c);
    const Complex_snapshot_3& snapshot = candidate_.snapshot;
    std::vector<int> off_boundary, on_boundary;
    for(int i = 0; i < 4; ++i)
      (snapshot.facet_number(triangulation_.facet_vertices(Half_facet(c, i))) < 0 ? off_boundary : on_boundary).push_back(i);
    if(on_boundary.size() != 2)
      return std::any_of(q.begin(), q.end(), [this](int v) { return candidate_.numbering.is_movable(v); });
    const auto [u, v] = std::minmax(q[off_boundary[0]], q[off_boundary[1]]);
    return !snapshot.boundary.complex().is_junction(u, v);
  }

  bool is_dual_point_certain(const Quadruple& q) const
  {
    const Cell_products t = products(q);
    return std::abs(t.determinant) > certain_volume * t.cubed_length();
  }

  Cell_products products(const Quadruple& q) const
  {
    const std::vector<Site>& sites = candidate_.sites;
    return Cell_products(sites[q[0]], sites[q[1]], sites[q[2]], sites[q[3]]);
  }

  Complex_candidate_3& candidate_;
  Labelled_triangulation_3& triangulation_;
  const Domain_view_3& domain_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_CELL_LABELS_3_H
