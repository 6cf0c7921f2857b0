// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_ADAPTATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_ADAPTATION_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Odt_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Candidate_checks_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_updater_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Size_adaptation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Snapshot_reader_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Vertex_edits_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Field_density_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/User_field_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/sizing/Size_criteria_3.h>
#include <CGAL/Global_odt_mesh_3/internal/sizing/Wanted_length_3.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Sliver_edits_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// The user's mesh as a table, between the stages of an optimization that makes the mesh regular or inserts vertices.
class Tabulated_mesh_3
  : public Mesh_view_3
{
public:
  struct State
  {
    Mesh_table_3 table;
    bool is_changed = false;                // since the mesh was read
  };

  Tabulated_mesh_3(Mesh_view_3& input, const Thread_policy& threads)
    : input_(input)
  {
    state_ = { input.read(threads) };
    number_of_input_vertices_ = static_cast<int>(table().sites.size());
  }

  // Also reads the feature edges.
  Tabulated_mesh_3(User_mesh_view_3& input, const Thread_policy& threads)
    : Tabulated_mesh_3(static_cast<Mesh_view_3&>(input), threads)
  {
    state_.table.feature_edges = input.feature_edges();
  }

  const Mesh_table_3& table() const { return state_.table; }
  int number_of_input_vertices() const { return number_of_input_vertices_; }
  int number_of_vertices() const
  {
    const std::vector<int>& dimensions = table().dimensions;
    return static_cast<int>(dimensions.size() - std::count(dimensions.begin(), dimensions.end(), int(Mesh_table_3::removed)));
  }
  const State& state() const { return state_; }
  bool is_changed() const { return state_.is_changed; }

  // Goes back to an earlier state.
  void return_to(State state) { state_ = std::move(state); }

  Mesh_table_3 read(const Thread_policy&) override { return table(); }

  int patch(int v) const override
  { return v < number_of_input_vertices_ ? input_.patch(v) : table().inserted[v - number_of_input_vertices_]; }

  bool is_fixed(int v) const override
  { return table().sites[v].weight != 0 || (v < number_of_input_vertices_ ? input_.is_fixed(v) : table().dimensions[v] < 2); }

  // Vertices inserted earlier keep their places in the table.
  void write(const Mesh_table_3& table) override
  {
    Mesh_table_3 next = table;
    next.inserted.insert(next.inserted.begin(), state_.table.inserted.begin(), state_.table.inserted.end());
    next.feature_edges = state_.table.feature_edges;
    next.facets.clear();
    for(const Mesh_table_3::Facet& f : table.facets)
    {
      Mesh_table_3::Facet mirror = f;
      mirror.cell = table.cells[f.cell].neighbors[f.index];
      mirror.index = table.mirror_index(f.cell, f.index);
      for(const Mesh_table_3::Facet& side : { f, mirror })
      {
        next.cells[side.cell].facets |= 1 << side.index;
        next.facets.push_back(side);
      }
    }
    std::sort(next.facets.begin(), next.facets.end(), [](const Mesh_table_3::Facet& a, const Mesh_table_3::Facet& b)
              { return std::make_pair(a.cell, a.index) < std::make_pair(b.cell, b.index); });
    // If the table lists both sides of a facet already, the duplicates are removed.
    next.facets.erase(std::unique(next.facets.begin(), next.facets.end(), [](const Mesh_table_3::Facet& a, const Mesh_table_3::Facet& b)
                                  { return a.cell == b.cell && a.index == b.index; }), next.facets.end());
    state_ = { std::move(next), true };
  }

private:
  Mesh_view_3& input_;
  State state_;
  int number_of_input_vertices_ = 0;
};

// Inserts vertices into a mesh or removes some, as a separate stage.
class Mesh_adaptation_3
{
public:
  // The ratio of edge length to size in meshes by Mesh_3, whose sizes bound circumradii.
  static constexpr double edge_over_size = 4 / 3.;

  // The largest number of vertices that a call may lead to: the number the user wants or else a multiple of the input's, so that a
  // field in wrong units does not exhaust the memory.
  static int most_vertices(const Odt_parameters& parameters, const Tabulated_mesh_3& mesh)
  {
    const std::size_t most = (std::max)(most_growth * mesh.number_of_input_vertices(), fewest_permitted);
    return static_cast<int>(parameters.number_of_vertices > 0 ? parameters.number_of_vertices : (std::min)(most, Odt_parameters::most_vertices));
  }

  // The wanted sizes; they have to be positive.
  static User_field_3::Function size_of(const User_field_3& field)
  {
    return [&field](const Vertex_stratum& v, const Site& s)
    {
      const double x = field.value(v, s);
      Field_density_3::check(field.meaning, field.polynomial.has_value(), s, x);
      return field.meaning == User_field_3::SIZE ? x : Density_3::size_of_density(x);
    };
  }

  // Keeps references to its arguments.
  Mesh_adaptation_3(Tabulated_mesh_3& mesh, const Domain_view_3& domain, Facet_bounds_3& bounds, const Odt_parameters& parameters,
                    const Thread_policy& threads)
    : mesh_(mesh)
    , parameters_(parameters)
    , bounds_(bounds)
    , complex_(domain, bounds, parameters.optimize_boundary, threads)
  {
    complex_.start(Snapshot_reader_3(mesh, threads).read(indexed_, parameters.optimize_boundary));
    is_editable_ = mesh.is_changed() || complex_.make_regular();
  }

  // Inserts or removes vertices where edges are too long or too short for the wanted sizes. False if the complex is not regular.
  template <class Predicate>
  bool adapt_sizes(const User_field_3& field, const Predicate& may_go_on)
  {
    if(!is_editable_)
      return false;
    const std::vector<int> number = numbers_of_table();
    std::vector<std::array<int, 2> > feature_edges;
    for(const Mesh_table_3::Feature_edge& e : mesh_.table().feature_edges)
      feature_edges.push_back({{ number[e.vertices[0]], number[e.vertices[1]] }});
    const bool wants_number = parameters_.number_of_vertices > 0;
    const bool has_sizes = field && field.meaning == User_field_3::SIZE;
    Wanted_length_3 wanted(indexed_, feature_edges, has_sizes || (field && wants_number) ? size_of(field) : User_field_3::Function(),
                           [this](int v) { return complex_.snapshot().numbering->stratum(v); },
                           has_sizes ? labels_between_subdomains(number) : Wanted_length_3::Labels(indexed_.sites.size()));
    const double number_before = double(indexed_.sites.size());
    Size_tolerance tolerance = of_sizes;
    if(wants_number)
    {
      tolerance.wants_number = true;
      wanted.scale(std::cbrt(wanted.number_of_vertices() / double(parameters_.number_of_vertices)));
    }
    else if(has_sizes)
      wanted.scale(edge_over_size);
    else
    {
      wanted.scale(longest_over_mean);
      tolerance = of_neighbors;
    }
    const double wanted_number = wants_number ? double(parameters_.number_of_vertices)
                               : has_sizes ? wanted.number_of_vertices() : number_before;
    const double coarsening = parameters_.do_remove_vertices ? (std::max)(1., number_before / wanted_number) : 1.;
    bounds_.permit_coarsening(coarsening);
    Vertex_edits_3 edits(complex_, most_vertices(parameters_, mesh_), coarsening, tolerance.share_of_facet_angles);
    Size_adaptation_3 adaptation(edits, wanted, tolerance);
    if(parameters_.do_remove_vertices)
      adaptation.remove_vertices(may_go_on);
    if(parameters_.do_insert_vertices)
      adaptation.insert_vertices(may_go_on);
    store(edits);
    return true;
  }

  // Inserts vertices into cells and facets that are too large, the worst first. True if the mesh changes.
  template <class Predicate>
  bool refine(const std::vector<Size_criteria_3::Violation>& violations, int step, unsigned int seed, const Predicate& may_go_on)
  {
    if(!is_editable_)
      return false;
    const std::vector<int> number = numbers_of_table();
    Vertex_edits_3 edits(complex_, most_vertices(parameters_, mesh_));
    Sliver_edits_3 insertion(edits, true, false, seed);
    for(Size_criteria_3::Violation v : violations)
    {
      if(edits.is_full() || !may_go_on())
        break;
      for(int& w : v.cell)
        w = number[w];
      insertion.split(v.cell, v.facet, step);
    }
    return store(edits);
  }

  // Inserts or removes vertices where that makes small dihedral angles larger. True if the mesh changes.
  template <class Predicate>
  bool edit_slivers(int step, unsigned int seed, const Predicate& may_go_on)
  {
    if(!is_editable_)
      return false;
    Vertex_edits_3 edits(complex_, most_vertices(parameters_, mesh_));
    Sliver_edits_3(edits, parameters_.do_insert_vertices, parameters_.do_remove_vertices, seed).run(step, may_go_on);
    return store(edits);
  }

private:
  static constexpr std::size_t most_growth = 10, fewest_permitted = 100000;
  // Without given sizes, only edges far from the mean length are changed; a smaller factor makes cells worse.
  static constexpr double longest_over_mean = 1.3;
  static constexpr Size_tolerance of_sizes = { 4 / 3., 0.6, 0.5 }, of_neighbors = { 1.7, 0.45, 1 };

  // For each vertex of the table, its number in the snapshot.
  std::vector<int> numbers_of_table() const
  {
    const std::vector<int>& in_table = complex_.snapshot().numbering->input_numbers;
    std::vector<int> number(mesh_.table().sites.size());
    for(std::size_t v = 0; v < in_table.size(); ++v)
      number[in_table[v]] = static_cast<int>(v);
    return number;
  }

  // For each boundary vertex of the snapshot, the sorted labels of the subdomains around it. `number` maps numbers in the table to
  // numbers in the snapshot.
  Wanted_length_3::Labels labels_between_subdomains(const std::vector<int>& number) const
  {
    const Vertex_numbering_3& numbering = *complex_.snapshot().numbering;
    Wanted_length_3::Labels labels(numbering.number_of_vertices());
    for(const Mesh_table_3::Cell& c : mesh_.table().cells)
      for(int v : c.vertices)
        if(c.label != Domain_view_3::outside && v >= 0 && numbering.is_on_boundary(number[v]))
          labels[number[v]].push_back(c.label);
    for(std::vector<int>& l : labels)
    {
      std::sort(l.begin(), l.end());
      l.erase(std::unique(l.begin(), l.end()), l.end());
    }
    return labels;
  }

  // Writes the edited complex to the mesh; false if nothing has changed.
  bool store(Vertex_edits_3& edits)
  {
    const std::optional<Mesh_table_3> table = edits.has_changed() ? edits.table() : std::nullopt;
    if(table)
      mesh_.write(*table);
    return table.has_value();
  }

  Tabulated_mesh_3& mesh_;
  const Odt_parameters& parameters_;
  Facet_bounds_3& bounds_;
  Moving_triangulation_3 indexed_;
  Complex_updater_3 complex_;
  bool is_editable_;                        // whether the complex is regular
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_ADAPTATION_3_H
