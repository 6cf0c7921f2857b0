// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_COMPLEX_UPDATER_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_COMPLEX_UPDATER_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Boundary_extraction_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Candidate_checks_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Candidate_repair_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Cell_labels_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_candidate_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Defect_report_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Editable_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Labelled_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Snapshot_tabulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Surface_centers_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/Domain_view_3.h>
#include <CGAL/Global_odt_mesh_3/internal/parallel/Thread_policy.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <cstddef>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Global_odt_mesh_3::internal {

// Takes a complex from one valid snapshot to the next.
//
// advance() makes a candidate for new positions and checks it. Vertices go back toward where they were if they change the topology
// of the boundary, pierce it, get hidden, leave a cell of their subdomain with its dual point in another one, make a facet too thin
// or too far from the surface, or replace a kept cell. Once all is well, the candidate replaces the snapshot; otherwise, or if
// anything throws, the snapshot is unchanged.
class Complex_updater_3
{
public:
  // Keeps references to the domain and the bounds.
  Complex_updater_3(const Domain_view_3& domain, Facet_bounds_3& bounds, bool boundary_moves,
                    const Thread_policy& threads = Thread_policy())
    : domain_(domain)
    , boundary_moves_(boundary_moves)
    , threads_(threads)
    , bounds_(bounds)
  {}

  Complex_updater_3(const Complex_updater_3&) = delete;
  Complex_updater_3& operator=(const Complex_updater_3&) = delete;

  void start(Complex_snapshot_3 input)
  {
    snapshot_ = std::move(input);
    if(boundary_moves_ && !snapshot_.sites().empty())
      bounds_.measure(snapshot_);
  }

  const Complex_snapshot_3& snapshot() const { return snapshot_; }
  // To be called last; the updater has no snapshot afterwards.
  Complex_snapshot_3 take_snapshot() { return std::move(snapshot_); }
  const Domain_view_3& domain() const { return domain_; }

  // Loads the snapshot into a mesh.
  void load_into(Moving_triangulation_3& mesh) const
  {
    const Stage_clock::In_stage in_stage(threads_.clock(), Stage_clock::INDEX);
    index_snapshot(snapshot_, threads_, mesh);
  }

  // Makes the complex regular, so that vertices can be tried, inserted, and removed, and have a way back: an input such as a file
  // with rounded coordinates or a deformed mesh need not be regular. False if that is impossible.
  bool make_regular()
  {
    return !snapshot_.is_input || is_regular(snapshot_.triangulation, threads_)
           || advance(snapshot_.sites(), nullptr, true, false) || advance(snapshot_.sites(), true);
  }

  // A copy of the complex for trials of single vertices.
  Editable_complex_3 edit() const { return edit(*snapshot_.numbering); }

  // A copy with another numbering, to which vertices are to be added.
  Editable_complex_3 edit(const Vertex_numbering_3& numbering) const
  {
    return Editable_complex_3(snapshot_, numbering, domain_, bounds_, boundary_moves_, threads_);
  }

  // Adopts the result of trials that started from this snapshot, and ends them. False if that is impossible; the snapshot is then
  // unchanged.
  bool adopt(Editable_complex_3& trials)
  {
    if(snapshot_.has_positions(trials.sites))
      return true;
    Complex_candidate_3 candidate(snapshot_, trials.sites, true, true, threads_);
    trials.give(candidate);
    if(!complete_trials(candidate))
      return false;
    snapshot_ = candidate.finish();
    return true;
  }

  // The vertices of the defects that prevent a valid complex, by their numbers in the input.
  const std::set<int>& obstacles() const { return obstacles_; }

  // How often a candidate took most of its cells from a mesh.
  std::size_t number_of_transfers() const { return number_of_transfers_; }

  // Moves the vertices to new positions as far as possible; false if nothing can be done. In a final snapshot, all vertices are on
  // their surfaces, and all boundary facets have surface centers.
  bool advance(const std::vector<Site>& target, bool is_final)
  {
    return advance(target, nullptr, is_final, true);
  }

  // Advances to the positions of a mesh that is regular as far as its constraints permit, which is faster.
  bool advance(const Moving_triangulation_3& mesh, bool is_final)
  {
    return advance(mesh.sites, &mesh, is_final, true);
  }

private:
  static constexpr int most_attempts = 40;
  // After so many attempts, a valid complex matters more than the shape of facets.
  static constexpr int attempts_at_good_facets = 10;
  static constexpr int attempts_at_retreat = 24;
  // The effort permitted over all attempts, beyond one per vertex, counted in vertices without a way back. With this limit, a mesh
  // that is regular nowhere takes no longer than others.
  static constexpr std::size_t least_effort = 1000;

  // Without a mesh, no cells are transferred.
  void build(Complex_candidate_3& candidate, const Moving_triangulation_3* mesh)
  {
    const Stage_clock::In_stage in_stage(threads_.clock(), Stage_clock::TRIANGULATE);
    number_of_transfers_ += candidate.build(mesh);
  }

  // Without a way back to the snapshot, the new one takes the place of the input.
  bool advance(const std::vector<Site>& target, const Moving_triangulation_3* mesh, bool is_final, bool has_way_back)
  {
    const Stage_clock::In_stage in_stage(threads_.clock(), Stage_clock::CHECK);
    Complex_candidate_3 candidate(snapshot_, target, is_final, has_way_back, threads_);
    if(!complete(candidate, mesh))
      return false;
    snapshot_ = candidate.finish();
    is_made_regular_ = is_made_regular_ || !has_way_back;
    if(!has_way_back)
      snapshot_.numbering = std::make_shared<Vertex_numbering_3>(snapshot_.numbering->with_input_at(snapshot_.sites()));
    return true;
  }

  // Whether the candidate can be made valid, perhaps with some vertices moved elsewhere or back.
  bool complete(Complex_candidate_3& candidate, const Moving_triangulation_3* mesh)
  {
    put_on_surfaces(candidate, domain_);
    build(candidate, mesh);
    Candidate_repair_3 repair(candidate, domain_, [&] { build(candidate, nullptr); });
    std::size_t effort = 0;
    for(int attempt = 0; attempt < most_attempts; ++attempt)
    {
      candidate.may_retreat = !candidate.has_way_back || (is_made_regular_ && attempt < attempts_at_retreat);
      const Defect_report_3 report = check(candidate, attempt < attempts_at_good_facets);
      if(report.is_clean())
        return true;
      note_obstacles(report);
      effort += report.weights().size() + report.obstacles().size()
                + (candidate.has_way_back ? 0 : report.offending_vertices().size() + report.retreats().size());
      if(effort > candidate.sites.size() + least_effort)
        return false;
      if(!repair.apply(report, attempt))
        return false;
    }
    return false;
  }

  void note_obstacles(const Defect_report_3& report)
  {
    obstacles_.clear();
    for(const std::set<int>& vertices : { report.offending_vertices(), report.obstacles() })
      for(int v : vertices)
        if(v >= 0)
          obstacles_.insert(snapshot_.numbering->input_numbers[v]);
    for(const auto& r : report.retreats())
      obstacles_.insert(snapshot_.numbering->input_numbers[r.first]);
  }

  // Whether a candidate made by trials is valid.
  bool complete_trials(Complex_candidate_3& candidate)
  {
    return topology_changes(candidate).empty() && Surface_centers_3(candidate, domain_).find_surface_centers().is_clean()
           && bounds_.check_distances(candidate).is_clean();
  }

  // Completes the candidate, and reports all its defects. Thin facets are reported only if `wants_good_facets`.
  Defect_report_3 check(Complex_candidate_3& candidate, bool wants_good_facets)
  {
    if(!candidate.triangulation.is_complete())
      return hidden_vertices(candidate);
    Defect_report_3 report = Cell_labels_3(candidate, domain_).label_cells();
    Boundary_extraction_3 extraction(candidate, domain_);
    extraction.find_boundary();
    report.add(check_kept_cells(candidate));
    report.add(check_facets_stay(candidate));
    if(candidate.boundary_moves())
      report.add(check_topology(candidate));
    report.add(Surface_centers_3(candidate, domain_).find_surface_centers());
    if(!candidate.boundary_moves())
      return report;
    report.add(bounds_.check_distances(candidate));
    if(wants_good_facets)
      bounds_.check_angles(candidate, report);
    return report;
  }

  static Defect_report_3 hidden_vertices(const Complex_candidate_3& candidate)
  {
    Defect_report_3 report(candidate);
    for(int v = 0; v < candidate.numbering.number_of_vertices(); ++v)
      if(!candidate.triangulation.is_visible(v))
        report.revert(std::vector<int>(1, v));
    if(report.offending_vertices().empty())
      report.give_up();
    return report;
  }

  const Domain_view_3& domain_;
  bool boundary_moves_;
  Thread_policy threads_;
  Facet_bounds_3& bounds_;
  Complex_snapshot_3 snapshot_;
  bool is_made_regular_ = false;
  std::size_t number_of_transfers_ = 0;
  std::set<int> obstacles_;
};

} // namespace CGAL::Global_odt_mesh_3::internal

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_COMPLEX_COMPLEX_UPDATER_3_H
