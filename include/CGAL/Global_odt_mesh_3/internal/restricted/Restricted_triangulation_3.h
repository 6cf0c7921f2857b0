// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_TRIANGULATION_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_TRIANGULATION_3_H

#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Boundary_extraction_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Boundary_fidelity_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Boundary_peeling_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Boundary_preservation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Cell_labels_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Cell_mending_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Domain_oracle_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Guilty_vertices_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_draft_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Restricted_update.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Surface_centers_3.h>
#include <CGAL/Global_odt_mesh_3/internal/restricted/Surface_projection_3.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// A complex as the restriction of CGAL's exact regular triangulation to the
// domain, and the way from one state of it to the next.
//
// update() builds the triangulation of new positions, labels it, and compares
// with the state before. Vertices that alter the topology of the boundary, pierce
// it, get hidden, or leave a cell of their subdomain with its dual point in
// another, go back toward where they were, until all is well.
template <class Triangulation, class Mesh_domain>
class Restricted_triangulation_3
{
public:
  typedef Restricted_complex_3<Triangulation, Mesh_domain> Complex;
  typedef Restricted_update Update;

  explicit Restricted_triangulation_3(const Mesh_domain& domain)
    : oracle_(domain)
    , draft_(complex_)
    , guilty_(draft_)
    , projection_(complex_, draft_, oracle_)
    , mending_(complex_, draft_, guilty_)
    , labels_(complex_, draft_, oracle_, guilty_, mending_)
    , extraction_(complex_, draft_, oracle_)
    , preservation_(complex_, draft_, guilty_)
    , fidelity_(complex_, draft_, oracle_, guilty_)
    , peeling_(complex_, draft_, extraction_, preservation_, fidelity_)
    , centers_(complex_, draft_, oracle_, guilty_, mending_)
  {}

  // The parts refer to each other.
  Restricted_triangulation_3(const Restricted_triangulation_3&) = delete;
  Restricted_triangulation_3& operator=(const Restricted_triangulation_3&) = delete;

  const Complex& complex() const { return complex_; }
  Complex& complex() { return complex_; }

  const Oracle_statistics& oracle_statistics() const { return oracle_.statistics(); }

  bool is_rough() { return projection_.is_rough(); }
  bool put_on_surface(int v, Site& s) { return projection_.put_on_surface(v, s); }
  bool is_close_to_surface(const std::array<double, 3>& point) { return fidelity_.is_close(point); }
  void measure_fidelity() { fidelity_.measure_input(); }

  // Goes to new positions of the movable vertices, as far as possible. False if
  // nothing could be done; the state is as before then, and if anything throws.
  bool update(const std::vector<Site>& target, const Update& mode)
  {
    draft_.start(target, mode);
    guilty_.start();
    projection_.start();
    labels_.start();
    centers_.start();
    fidelity_.start();
    if(mode.boundary_moves)
      projection_.project_all();
    draft_.build();
    for(int attempt = 0; attempt < most_attempts; ++attempt)
    {
      guilty_.clear();
      check();
      if(guilty_.is_empty())
      {
        draft_.accept();
        projection_.accept();
        return true;
      }
      if(guilty_.is_hopeless() || !send_back(attempt))
        break;
    }
    draft_.discard();
    return false;
  }

private:
  static constexpr int most_attempts = 40;
  static constexpr int patient_attempts = 10;

  // Finds what is wrong with the draft.
  void check()
  {
    if(!draft_.numbered.is_complete())
    {
      blame_hidden_vertices();
      return;
    }
    labels_.label_cells();
    if(!guilty_.is_empty())
      return;
    extraction_.find_candidates();
    extraction_.find_boundary();
    if(draft_.mode.boundary_moves)
      preservation_.check_topology();
    else
      preservation_.check_facets_stay();
    if(!guilty_.is_empty())
      return;
    if(draft_.mode.boundary_moves)
      peeling_.peel();
    centers_.find_surface_centers();
    if(draft_.mode.boundary_moves && guilty_.is_empty())
      fidelity_.check_fidelity();
  }

  void blame_hidden_vertices()
  {
    for(int v = 0; v < static_cast<int>(draft_.numbered.number_of_vertices()); ++v)
      if(!draft_.numbered.is_visible(v))
        guilty_.blame({ v });
    if(guilty_.offenders().empty())
      guilty_.give_up();
  }

  // Moves the offenders toward where they were, and home if that does not help.
  bool send_back(int attempt)
  {
    push();
    if(attempt >= patient_attempts)
      for(int ring = patient_attempts; ring <= attempt; ring += 3)
        guilty_.grow_offenders();
    const bool rebuild = guilty_.offenders().size() > draft_.sites.size() / 20 || !draft_.numbered.is_complete();
    for(int v : guilty_.offenders())
    {
      if(!draft_.is_movable(v) || draft_.is_home(v))
        continue;
      if(!send_back(v, attempt))
        return false;
      if(!rebuild)
        draft_.move(v);
    }
    if(rebuild)
      draft_.build();
    else
      for(const auto& p : guilty_.pushes())
        draft_.move(p.first);
    centers_.forget_facets_of(guilty_);
    fidelity_.forget_facets_of(guilty_);
    draft_.measure();
    return true;
  }

  void push()
  {
    for(const auto& p : guilty_.pushes())
    {
      if(guilty_.is_offender(p.first))
        continue;
      Site& s = draft_.sites[p.first];
      s = { s.x + p.second[0], s.y + p.second[1], s.z + p.second[2], s.weight };
    }
  }

  bool send_back(int v, int attempt)
  {
    const bool on_surface = v >= complex_.number_of_interior_vertices;
    // On the way, few attempts matter more than long ways.
    const bool is_patient = attempt < patient_attempts && !(on_surface && draft_.mode.evidence == Update::SOME_EVIDENCE);
    const bool halfway = is_patient && guilty_.add_strike(v) < (on_surface ? 1 : 2);
    Site& s = draft_.sites[v];
    const Site& home = complex_.sites[v];
    s = halfway ? Site{ (s.x + home.x) / 2, (s.y + home.y) / 2, (s.z + home.z) / 2, home.weight } : home;
    return !on_surface || projection_.return_to_surface(v, halfway);
  }

  Domain_oracle_3<Mesh_domain> oracle_;
  Complex complex_;
  Restricted_draft_3<Triangulation, Mesh_domain> draft_;
  Guilty_vertices_3<Triangulation, Mesh_domain> guilty_;
  Surface_projection_3<Triangulation, Mesh_domain> projection_;
  Cell_mending_3<Triangulation, Mesh_domain> mending_;
  Cell_labels_3<Triangulation, Mesh_domain> labels_;
  Boundary_extraction_3<Triangulation, Mesh_domain> extraction_;
  Boundary_preservation_3<Triangulation, Mesh_domain> preservation_;
  Boundary_fidelity_3<Triangulation, Mesh_domain> fidelity_;
  Boundary_peeling_3<Triangulation, Mesh_domain> peeling_;
  Surface_centers_3<Triangulation, Mesh_domain> centers_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_RESTRICTED_RESTRICTED_TRIANGULATION_3_H
