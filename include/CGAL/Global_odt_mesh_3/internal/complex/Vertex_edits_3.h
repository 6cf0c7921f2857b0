// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_VERTEX_EDITS_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_VERTEX_EDITS_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Candidate_checks_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_updater_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Editable_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Labelled_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Snapshot_tabulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Surface_centers_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Vertex_cavity_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Vertex_trial_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vector_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Mesh_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/User_field_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/sizing/Size_criteria_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Exchangeable_boundary_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// A vertex that is to be inserted, and where it belongs.
struct New_vertex_3
{
  Vector_3 point;
  int dimension;                // 2 on a surface, 3 inside
  int place;                    // the patch or the subdomain
  Vector_3 normal = {};      // of the surface
};

// The middle of an edge of a cell, put onto the surface if the edge is on one; none if several surfaces meet there.
inline std::optional<New_vertex_3> middle_of_edge(const Editable_complex_3& complex, int u, int v, int c)
{
  constexpr double farthest_projection = 0.25;              // over the edge
  const std::vector<Site>& sites = complex.sites;
  const double length = (position(sites[v]) - position(sites[u])).length();
  Vector_3 p = (position(sites[u]) + position(sites[v])) / 2;
  const std::vector<Exchangeable_boundary_3::Facet> facets = complex.boundary.around(u, v);
  // All cells around an edge off the boundary are in one subdomain.
  if(facets.empty() && complex.is_inside(c))
    return New_vertex_3{ p, 3, complex.triangulation.label(c) };
  if(facets.size() != 2 || facets[0].patch != facets[1].patch || facets[0].labels != facets[1].labels
     || facets[0].patch == Boundary_facet::no_patch)
    return std::nullopt;
  const auto normal = [&](const Exchangeable_boundary_3::Facet& f) { return Facet_dual_3(f.vertices, sites).normal; };
  Vector_3 n = normal(facets[0]), m = normal(facets[1]);
  n += n.dot(m) < 0 ? Vector_3(-m) : m;
  n = n.normalized();
  if(!complex.domain.project(p, n, farthest_projection * length, facets[0].patch))
    return std::nullopt;
  return New_vertex_3{ p, 2, facets[0].patch, n };
}

// Inserts vertices into a copy of a snapshot, or removes movable ones. Inside, that leaves the boundary as it is; on a surface, it
// replaces the facets of a disk of one patch. No vertex is inserted into a protecting ball.
class Vertex_edits_3
{
public:
  // Surfaces get vertices only if the boundary moves. The complex is full at `most_vertices`. If `coarsening` divides the number of
  // vertices, volumes may change more. Facets around inserted vertices need to have a share of the bound on angles.
  Vertex_edits_3(Complex_updater_3& updater, int most_vertices, double coarsening = 1, double share_of_facet_angles = 1)
    : most_vertices_(most_vertices)
    , numbering_(std::make_shared<Vertex_numbering_3>(*updater.snapshot().numbering))
    , complex_(updater.edit(*numbering_))
    , trial_(complex_)
    , most_of_volume_((std::min)(usual_most_of_volume + most_of_volume_of_coarsening * (coarsening - 1), most_of_volume_ever))
  {
    complex_.share_of_facet_angles = share_of_facet_angles;
  }

  Vertex_edits_3(const Vertex_edits_3&) = delete;
  Vertex_edits_3& operator=(const Vertex_edits_3&) = delete;

  const Editable_complex_3& complex() const { return complex_; }
  Vertex_trial_3& trial() { return trial_; }

  // The next inserted vertex gets this number.
  int number_of_vertices() const { return static_cast<int>(complex().sites.size()); }
  int number_of_visible_vertices() const { return number_of_vertices() - number_of_removed_; }
  // Whether no more vertices may be inserted.
  bool is_full() const { return number_of_visible_vertices() >= most_vertices_; }
  bool has_too_many_vertices() const { return number_of_visible_vertices() > most_vertices_; }
  bool has_changed() const { return !places_.empty() || number_of_removed_ > 0; }

  // Inserts the vertex, near a cell, if it has at least this distance from all others, whatever that does to angles of cells; whether
  // it has been inserted, as the last vertex.
  bool insert(const New_vertex_3& vertex, double least_distance, int start)
  {
    begin(vertex, start);
    return end(trial_.fits(least_distance));
  }

  // Removes a movable vertex if that is permitted, whatever that does to angles; whether it has been removed.
  bool remove(int v)
  {
    measure_volumes();
    return end_removal(trial_.start(v) && trial_.may_leave() && keeps_volumes(v));
  }

  // The change of the sum of the deficits if the vertex were inserted, or infinity if it may not be inserted, if an angle gets
  // smaller than all before, or if the change is not less than `most`. If the change is less and `stays`, the vertex is inserted.
  double insert_for_angles(const New_vertex_3& vertex, double most, int start, bool stays)
  {
    begin(vertex, start);
    const double change = trial_.move(complex().sites.back(), most);
    return end(stays && change < most) || !stays ? change : infinity;
  }

  // The change of the sum of the deficits if a movable vertex were removed; it is removed if `leaves`.
  double remove_for_angles(int v, double most, bool leaves)
  {
    measure_volumes();
    const double change = trial_.start(v) ? trial_.leave(most) : infinity;
    return change < most && keeps_volumes(v) && (!leaves || end_removal(true)) ? change : infinity;
  }

  // The stratum of the last inserted vertex.
  Vertex_stratum stratum_of_last() const { return { -1, numbering_->dimensions.back(), places_.back() }; }

  // The edges of the cells that the last removal created.
  std::vector<std::array<int, 2> > new_edges() const
  {
    std::vector<Quadruple> cells;
    for(const Vertex_cavity_3::Cell* c : trial_.cavity().new_cells())
      if(c->label != Domain_view_3::outside)
        cells.push_back(c->vertices);
    return edges_of(cells);
  }

  // The complex as a table, with inserted vertices after those of the input; nothing if the domain finds no surface center for a
  // facet.
  std::optional<Mesh_table_3> table()
  {
    Complex_snapshot_3 refined;
    std::vector<int> numbers;
    std::vector<Site> sites;
    refined.numbering = keep_visible(numbers, sites);
    const auto renumber = [&numbers](auto& vertices)
    {
      for(int& v : vertices)
        v = numbers[v];
    };
    const std::vector<Editable_complex_3::Found_facet> found = complex_.find_boundary();
    std::vector<Boundary_facet> facets;
    for(const auto& f : found)
    {
      facets.push_back(f.of_boundary);
      renumber(facets.back().vertices);
    }
    refined.boundary = Boundary_geometry_3(
      std::make_shared<const Boundary_complex_3>(std::move(facets), sites.size(), complex().threads), sites);
    for(std::size_t n = 0; n < found.size(); ++n)
    {
      const Triple& t = refined.boundary.complex().facets()[n].vertices;
      refined.centers.push_back(center(found[n], estimated_surface_center(t, refined.boundary, sites)));
      if(!refined.centers.back().is_exact)
        return std::nullopt;
    }
    refined.number_facets();
    complex_.triangulation.renumber(numbers, sites);
    refined.triangulation = std::move(complex_.triangulation);
    Mesh_table_3 table = Snapshot_tabulation_3(std::move(refined), complex().threads)();
    table.inserted = places_;
    return table;
  }

private:
  static constexpr double infinity = (std::numeric_limits<double>::infinity)();
  // The bounds on changes of a subdomain's volume; without them, thin layers lose much of their volume.
  static constexpr double usual_most_of_volume = 0.003, most_of_volume_of_coarsening = 0.1, most_of_volume_ever = 0.3;

  // Measures the volumes of subdomains before the first removal.
  void measure_volumes()
  {
    if(volume_.empty())
      for(int c : complex().triangulation.cells())
        if(complex().is_inside(c))
          volume_[complex().triangulation.label(c)] += volume(complex().triangulation.vertices(c));
  }

  // Whether all volumes stay within their bounds if the vertex is removed.
  bool keeps_volumes(int v)
  {
    if(!numbering_->is_on_boundary(v))
      return true;
    const std::map<int, double> changes = changes_of_volume();
    return std::all_of(changes.begin(), changes.end(), [this](const std::pair<const int, double>& c)
    {
      const auto before = change_of_volume_.find(c.first);
      const double change = c.second + (before == change_of_volume_.end() ? 0 : before->second);
      const auto whole = volume_.find(c.first);
      return whole != volume_.end() && std::abs(change) <= most_of_volume_ * whole->second;
    });
  }

  double volume(const Quadruple& q) const
  {
    const std::vector<Site>& s = complex().sites;
    return Cell_products(s[q[0]], s[q[1]], s[q[2]], s[q[3]]).determinant / 6;
  }

  // The changes of the subdomains' volumes, by label, with the cells that are tried.
  std::map<int, double> changes_of_volume() const
  {
    std::map<int, double> changes;
    const auto add = [&](const std::vector<Vertex_cavity_3::Cell*>& cells, double sign)
    {
      for(const Vertex_cavity_3::Cell* c : cells)
        if(c->label != Domain_view_3::outside)
          changes[c->label] += sign * volume(c->vertices);
    };
    add(trial_.cavity().old_cells(), -1);
    add(trial_.cavity().new_cells(), 1);
    return changes;
  }

  void begin(const New_vertex_3& vertex, int start)
  {
    const int v = add(vertex);
    trial_.start_new(v, vertex.dimension == 2 ? vertex.place : int(Boundary_facet::no_patch), start);
  }

  // Whether the vertex is accepted, which also depends on the domain; if not, it is taken out again.
  bool end(bool is_permitted)
  {
    const bool is_accepted = is_permitted && trial_.accept();
    if(!is_accepted)
      remove_last();
    return is_accepted;
  }

  bool end_removal(bool is_permitted)
  {
    if(!is_permitted || !trial_.accept())
      return false;
    for(const auto& c : changes_of_volume())
      change_of_volume_[c.first] += c.second;
    ++number_of_removed_;
    return true;
  }

  int add(const New_vertex_3& vertex)
  {
    const Site s = site_at(vertex.point, 0);
    numbering_->input_numbers.push_back(numbering_->number_in_table + static_cast<int>(places_.size()));
    numbering_->input_sites.push_back(s);
    numbering_->dimensions.push_back(vertex.dimension);
    numbering_->subdomain.push_back(vertex.dimension == 3 ? vertex.place : int(Vertex_numbering_3::no_subdomain));
    places_.push_back(vertex.place);
    return complex_.add_vertex(s);
  }

  void remove_last()
  {
    numbering_->input_numbers.pop_back();
    numbering_->input_sites.pop_back();
    numbering_->dimensions.pop_back();
    numbering_->subdomain.pop_back();
    places_.pop_back();
    complex_.remove_last_vertex();
  }

  // The numbering and the sites without removed vertices, whose new number is -1.
  std::shared_ptr<const Vertex_numbering_3> keep_visible(std::vector<int>& numbers, std::vector<Site>& sites) const
  {
    const auto kept = std::make_shared<Vertex_numbering_3>();
    kept->input = numbering_->input;
    kept->first_inserted = numbering_->first_inserted;
    kept->number_in_table = numbering_->number_in_table + static_cast<int>(places_.size());
    for(int v = 0; v < number_of_vertices(); ++v)
    {
      const bool is_visible = complex().triangulation.is_visible(v);
      numbers.push_back(is_visible ? static_cast<int>(sites.size()) : -1);
      if(!is_visible)
        continue;
      kept->input_numbers.push_back(numbering_->input_numbers[v]);
      kept->input_sites.push_back(numbering_->input_sites[v]);
      kept->dimensions.push_back(numbering_->dimensions[v]);
      kept->subdomain.push_back(numbering_->subdomain[v]);
      sites.push_back(complex().sites[v]);
    }
    for(const auto& c : numbering_->input_boundary_cells.entries())
    {
      Vertex_numbering_3::Input_cell cell = c.second;
      for(int& v : cell.vertices)
        v = numbers[v];
      if(*std::min_element(cell.vertices.begin(), cell.vertices.end()) >= 0)
        kept->input_boundary_cells.insert(sorted(cell.vertices), cell);
    }
    for(const auto& f : numbering_->kept_facets.entries())
      kept->kept_facets.insert(sorted(Triple{{ numbers[f.first[0]], numbers[f.first[1]], numbers[f.first[2]] }}), f.second);
    for(const auto& c : numbering_->kept_cells.entries())
    {
      const Quadruple& q = c.first;
      kept->kept_cells.insert(sorted(Quadruple{{ numbers[q[0]], numbers[q[1]], numbers[q[2]], numbers[q[3]] }}), c.second);
    }
    return kept;
  }

  // The surface center of a facet: that of the snapshot, unless it is off the dual segment, or else one that is searched for or,
  // failing that, the one with which the facet was accepted.
  Complex_snapshot_3::Surface_center center(const Editable_complex_3::Found_facet& f, const Vector_3& expected) const
  {
    const Surface_center_search_3 search(complex().triangulation, complex().domain);
    const Triple& t = f.of_boundary.vertices;
    const int n = complex().snapshot.facet_number(f.key);
    Complex_snapshot_3::Surface_center known, found;
    if(n >= 0)
      known = complex().snapshot.centers[n];
    else if(const auto accepted = complex().centers.find(f.key); accepted != complex().centers.end())
      known = accepted->second;
    if(n >= 0 && known.is_exact && (!complex_.boundary_moves || search.is_between_subdomains(f.facet, t, known)))
      return known;
    found.point = expected;
    search.search(f.facet, t, found);
    return found.is_exact ? found : known;
  }

  int most_vertices_;
  std::shared_ptr<Vertex_numbering_3> numbering_;
  Editable_complex_3 complex_;
  Vertex_trial_3 trial_;
  std::vector<int> places_;                 // of inserted vertices
  int number_of_removed_ = 0;
  double most_of_volume_;                   // the share by which removals may change a subdomain's volume
  std::map<int, double> volume_, change_of_volume_;         // of subdomains: before removals, and their changes by these
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_VERTEX_EDITS_3_H
