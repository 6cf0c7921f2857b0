// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "check.h"
#include "mesh_contract.h"
#include "mesh_domains.h"
#include "opened_complex.h"

#include <CGAL/Global_odt_mesh_3/internal/complex/Candidate_checks_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_updater_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Exact_sliver_removal_3.h>

#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace CGAL::Global_odt_mesh_3::internal;
using domains::Labeled_c3t3;
using domains::Labeled_domain;
using domains::Polyhedral_c3t3;
using domains::Polyhedral_domain;

// The cells with their subdomains and the boundary facets, named by vertices, and the positions.
struct Contents
{
  std::set<std::pair<std::array<int, 4>, int> > cells;
  std::set<std::pair<std::array<int, 3>, std::array<int, 3> > > facets;
  std::vector<double> coordinates;

  explicit Contents(const Exact_relocation_3& trial)
  {
    const Editable_complex_3& complex = trial.complex();
    for(auto c : complex.triangulation().all_cell_handles())
      cells.insert({ sorted(complex.numbers(c)), c->label() });
    for(const Exchangeable_boundary_3::Facet& f : complex.boundary.facets())
      facets.insert({ f.vertices, {{ f.labels[0], f.labels[1], f.patch }} });
    for(const Site& s : complex.sites)
      coordinates.insert(coordinates.end(), { s.x, s.y, s.z, s.weight });
  }

  bool operator==(const Contents& o) const
  {
    return cells == o.cells && facets == o.facets && coordinates == o.coordinates;
  }
};

// A trial that is rejected leaves everything as it was; what it has said before, it says again.
template <class C3t3, class Domain>
void rejected_trials(const std::string& name, const C3t3& c3t3, const Domain& domain, bool moves_surfaces)
{
  Opened_complex<C3t3, Domain> setting(c3t3, domain, Boundary_motion::BY_NORMALS);
  auto trial = setting.complex.make_trial();
  const int step = Sliver_steps::last(40);
  trial.set_goal(Sliver_steps::angles[step], step);
  const Contents before(trial);
  Random_source random(5);
  int detached = 0, on_surface = 0, permitted = 0, refused = 0, other = 0;
  for(const auto& q : trial.slivers(Sliver_steps::angles[step]))
    for(int v : trial.movable_vertices(q))
    {
      if(detached == 400)
        break;
      ++detached;
      on_surface += setting.complex.snapshot().numbering->is_on_boundary(v);
      const Site from = trial.site(v);
      trial.detach(v);
      for(int n = 0; n < 4; ++n)
      {
        Site s = site_at(position(from) + 0.3 * trial.mean_edge_length() * random.uniform() * random.direction(), from.weight);
        if(!trial.place(s))
          continue;
        const double most = (std::numeric_limits<double>::infinity)(), change = trial.move(s, most);
        ++(std::isfinite(change) ? permitted : refused);
        other += change != trial.move(s, most);
      }
      trial.reject();
      if(detached % 50 == 0)
        check::that(Contents(trial) == before, name, ": a rejected trial leaves a trace");
    }
  std::cout << name << ": " << detached << " vertices detached, " << on_surface << " of surfaces, " << permitted
            << " places permitted, " << refused << " refused" << std::endl;
  check::that(Contents(trial) == before, name, ": rejected trials leave a trace");
  check::that(other == 0, name, ": ", other, " trials end otherwise a second time");
  check::that(detached > 50 && permitted > 0 && refused > 0 && (on_surface > 0) == moves_surfaces, name, ": the test is too weak");
}

// Slivers are removed, and what comes out is a mesh as good as the one before in all other respects.
template <class C3t3, class Domain>
void removal(const std::string& name, const C3t3& c3t3, const Domain& domain, Boundary_motion motion, int step,
             double most_left)
{
  const double bound = Sliver_steps::angles[step];
  const Mesh_contract<C3t3, Domain> contract(c3t3, domain, name);
  std::vector<C3t3> results;
  for(int run = 0; run < 2; ++run)
  {
    Opened_complex<C3t3, Domain> setting(c3t3, domain, motion);
    auto trial = setting.complex.make_trial();
    const std::size_t before = trial.slivers(bound).size();
    Exact_sliver_removal_3::Failures failures;
    Exact_sliver_removal_3 removal(trial, failures, 1);
    removal.climb(step, 1000000, [] { return true; });
    const std::size_t after = trial.slivers(bound).size();
    std::cout << name << ": " << before << " -> " << after << " cells below " << bound << " degrees by "
              << removal.number_of_moves() << " moves, " << removal.number_of_tries() << " tries" << std::endl;
    check::that(before > 5 && removal.number_of_moves() > 0, name, ": there was nothing to do");
    check::that(double(after) <= most_left * double(before), name, ": ", after, " of ", before, " slivers remain");
    const Contents reached(trial);
    check::that(setting.complex.adopt(trial), name, ": the complex does not adopt the trials");
    auto next = setting.complex.make_trial();
    check::that(Contents(next) == reached, name, ": the complex is not what trials have led to");
    check::that(setting.complex.adopt(next), name, ": the complex does not adopt trials that move nothing");
    results.push_back(setting.write());
  }
  if(motion == Boundary_motion::NONE)
    contract.check(results[0]);
  else
    contract.check_moved(results[0], 1e-2);
  typedef Mesh_contract<C3t3, Domain> Contract;
  check::that(Contract::points(results[0]) == Contract::points(results[1]), name, ": not deterministic");
}

// The smallest angle rises far beyond that of the input, and no step gets more cells below it.
template <class C3t3, class Domain>
void smallest_angle(const std::string& name, const C3t3& c3t3, const Domain& domain, double wanted)
{
  Opened_complex<C3t3, Domain> setting(c3t3, domain, Boundary_motion::BY_NORMALS);
  auto trial = setting.complex.make_trial();
  Exact_sliver_removal_3::Failures failures;
  Exact_sliver_removal_3 removal(trial, failures, 1);
  const int step = Sliver_steps::last(30);
  std::vector<std::size_t> before;
  for(int s = 0; s < step; ++s)
    before.push_back(trial.slivers(Sliver_steps::angles[s]).size());
  removal.raise_smallest_angle(step, 35, 1000000, [] { return true; });
  double smallest = 90;
  for(const auto& q : trial.slivers(35))
    smallest = (std::min)(smallest, trial.smallest_angle(q));
  std::cout << name << ": smallest angle " << smallest << " after " << removal.number_of_tries() << " tries" << std::endl;
  check::that(smallest >= wanted, name, ": smallest angle ", smallest);
  for(int s = 0; s < step; ++s)
  {
    const std::size_t after = trial.slivers(Sliver_steps::angles[s]).size();
    check::that(after <= before[s], name, ": ", after, " cells below ", Sliver_steps::angles[s], ", before ", before[s]);
  }
}

// Where three subdomains meet, vertices move, and the edges on that line remain edges between the same vertices.
static void junction_moves()
{
  const Labeled_domain domain = domains::labeled([](const domains::Point_3& p)
    { return domains::squared(p) >= 1 ? 0 : p.x() > 0.01 ? 1 : p.y() > 0.02 ? 2 : 3; });
  const Labeled_c3t3 c3t3 = domains::mesh(domain, 0.25);
  Opened_complex<Labeled_c3t3, Labeled_domain> setting(c3t3, domain, Boundary_motion::BY_NORMALS);
  auto trial = setting.complex.make_trial();
  const double bound = 50;
  trial.set_goal(bound, 0);
  Random_source random(3);
  const auto is_on_junction = [&trial](int v)
  {
    std::set<std::array<int, 2> > labels;
    for(int n : trial.complex().boundary.around(v))
      labels.insert(trial.complex().boundary.facet(n).labels);
    return labels.size() == 3;
  };
  int moved = 0, detached = 0;
  for(const auto& q : trial.slivers(bound))
    for(int v : trial.movable_vertices(q))
    {
      if(!is_on_junction(v))
        continue;
      ++detached;
      const Site from = trial.site(v);
      trial.detach(v);
      Site s = site_at(position(from) + 0.1 * trial.mean_edge_length() * random.uniform() * random.direction(), from.weight);
      if(trial.place(s) && std::isfinite(trial.move(s, (std::numeric_limits<double>::infinity)())))
      {
        trial.accept();
        ++moved;
        check::that(is_on_junction(v), "a vertex leaves the line where three subdomains meet");
      }
      else
        trial.reject();
    }
  std::cout << "junction: " << moved << " of " << detached << " moves" << std::endl;
  check::that(moved > 0 && setting.complex.adopt(trial), "no vertex where three subdomains meet moves");
  Mesh_contract<Labeled_c3t3, Labeled_domain>(c3t3, domain, "junction").check_moved(setting.write(), 1e-2);
}

// Vertices stay where the domain has put them, if the complex permits: it is asked again, and answers otherwise, only for those
// whose places have not been kept.
static void kept_places()
{
  const Labeled_domain domain = domains::sphere();
  const Labeled_c3t3 c3t3 = domains::mesh(domain, 0.2);
  Opened_complex<Labeled_c3t3, Labeled_domain> setting(c3t3, domain, Boundary_motion::BY_NORMALS);
  const auto numbering = setting.complex.snapshot().numbering;
  std::vector<Site> target = setting.complex.snapshot().sites;
  Random_source random(7);
  const auto is_kept = [](int v) { return v % 2 == 0; };
  for(int v = numbering->number_of_interior_vertices; v < numbering->number_of_movable_vertices; ++v)
  {
    Site s = site_at(position(target[v]) + 0.002 * random.direction(), target[v].weight);
    if(!setting.complex.put_on_surface(v, s))
      continue;
    target[v] = s;
    if(is_kept(v))
      setting.complex.keep_on_surface(v, s);
  }
  check::that(setting.complex.advance(target, true).has_value(), "the complex does not go on");
  std::array<std::size_t, 2> same = {}, all = {};         // of those that are not kept, and those that are
  for(int v = numbering->number_of_interior_vertices; v < numbering->number_of_movable_vertices; ++v)
  {
    ++all[is_kept(v)];
    same[is_kept(v)] += same_place(setting.complex.snapshot().sites[v], target[v]);
  }
  std::cout << "kept places: " << same[1] << " of " << all[1] << " vertices stay there, " << same[0] << " of " << all[0]
            << " others" << std::endl;
  check::that(100 * same[1] >= 97 * all[1], "vertices leave the places that they have got");
  check::that(all[1] > 50 && 2 * same[0] < all[0], "the test is too weak");
}

// Nothing is done without tries or time, and the tries are no more than wanted, but for the last vertices.
template <class C3t3, class Domain>
void limits(const C3t3& c3t3, const Domain& domain)
{
  Opened_complex<C3t3, Domain> setting(c3t3, domain, Boundary_motion::BY_NORMALS);
  auto trial = setting.complex.make_trial();
  const Contents before(trial);
  Exact_sliver_removal_3::Failures failures;
  Exact_sliver_removal_3 without_tries(trial, failures, 1), without_time(trial, failures, 1);
  const int step = Sliver_steps::last(30);
  without_tries.climb(step, 0, [] { return true; });
  without_time.climb(step, 1000000, [] { return false; });
  check::that(without_tries.number_of_moves() == 0 && without_time.number_of_moves() == 0 && Contents(trial) == before,
              "something is done without tries or without time");
  Exact_sliver_removal_3 few(trial, failures, 1);
  few.climb(Sliver_steps::number - 1, 2000, [] { return true; });
  const Exact_sliver_removal_parameters p;
  check::that(few.number_of_tries() <= 2000 + 10 * (p.tries_of_detachment + p.tries_per_vertex), few.number_of_tries(), " tries");
}

// What facets may be is decided by the first mesh, also if a later one is worse.
static void bounds_stay(const Polyhedral_c3t3& c3t3, const Polyhedral_domain& domain)
{
  Opened_complex<Polyhedral_c3t3, Polyhedral_domain> setting(c3t3, domain, Boundary_motion::BY_NORMALS);
  Complex_snapshot_3 worse = setting.complex.snapshot();
  for(Site& s : worse.sites)
    s.z *= 0.1;
  Facet_bounds_3 of_worse(setting.domain);
  of_worse.measure(worse);
  const double angle = setting.bounds.smallest_angle();
  setting.bounds.measure(worse);
  int far = 0;
  for(const Boundary_facet& f : worse.boundary.complex().facets())
  {
    const Eigen::Vector3d c = centroid(f.vertices, worse.sites);
    far += !setting.bounds.is_close(c);
    check::that(of_worse.is_close(c), "the bounds are not those of the first mesh");
  }
  check::that(far > 0 && setting.bounds.smallest_angle() == angle && of_worse.smallest_angle() < angle,
              "a later mesh makes bounds wider");
}

// A box with a wavy surface inside that does not separate subdomains.
static void make_box_with_surface(domains::Polyhedron& box, domains::Polyhedron& surface)
{
  std::istringstream("OFF\n8 12 0\n-1 -1 -1\n1 -1 -1\n1 1 -1\n-1 1 -1\n-1 -1 1\n1 -1 1\n1 1 1\n-1 1 1\n"
                     "3 0 2 1\n3 0 3 2\n3 4 5 6\n3 4 6 7\n3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n"
                     "3 3 0 4\n3 3 4 7\n") >> box;
  const int n = 20;
  std::ostringstream off;
  off << "OFF\n" << (n + 1) * (n + 1) << " " << 2 * n * n << " 0\n";
  for(int i = 0; i <= n; ++i)
    for(int j = 0; j <= n; ++j)
      off << 1.2 * i / n - 0.6 << " " << 1.2 * j / n - 0.6 << " " << 0.05 * std::sin(6. * i / n) << "\n";
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
    {
      const int v = (n + 1) * i + j;
      off << "3 " << v << " " << v + n + 1 << " " << v + n + 2 << "\n3 " << v << " " << v + n + 2 << " " << v + 1 << "\n";
    }
  std::istringstream(off.str()) >> surface;
}

int main()
{
  {
    const Labeled_domain domain = domains::sphere();
    const Labeled_c3t3 c3t3 = domains::mesh(domain, 0.2);
    rejected_trials("sphere", c3t3, domain, true);
    removal("sphere", c3t3, domain, Boundary_motion::BY_NORMALS, 1, 0);
    removal("sphere with its surface fixed", c3t3, domain, Boundary_motion::NONE, 0, 0.2);
    limits(c3t3, domain);
    smallest_angle("sphere", c3t3, domain, 25);
  }
  kept_places();
  junction_moves();
  {
    const Labeled_domain domain = domains::three_subdomains();
    const Labeled_c3t3 c3t3 = domains::mesh(domain, 0.2);
    rejected_trials("three subdomains", c3t3, domain, true);
    removal("three subdomains", c3t3, domain, Boundary_motion::BY_DOMAIN, 1, 0.1);
  }
  {
    Polyhedral_domain domain(domains::notched_box());
    domain.detect_features();
    const Polyhedral_c3t3 c3t3 = domains::mesh(domain, 0.3, true);
    rejected_trials("box with features", c3t3, domain, true);
    removal("box with features", c3t3, domain, Boundary_motion::BY_NORMALS, 0, 0.1);
    bounds_stay(c3t3, domain);
  }
  {
    domains::Polyhedron box, surface;
    make_box_with_surface(box, surface);
    Polyhedral_domain domain(surface, box);
    domain.detect_features();
    const Polyhedral_c3t3 c3t3 = domains::mesh(domain, 0.2, true);
    rejected_trials("box with a surface inside", c3t3, domain, true);
    removal("box with a surface inside", c3t3, domain, Boundary_motion::BY_NORMALS, 0, 0.1);
  }
  return check::result();
}
