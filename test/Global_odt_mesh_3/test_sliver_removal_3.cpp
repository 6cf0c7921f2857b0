// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Trials of vertices and the removal of slivers: the deficit of angles is what it says, trials leave no trace, the triangulation is
// regular whatever moves, comes, or goes, and in the end no cell that could be helped is a sliver.

#include "check.h"
#include "mesh_contract.h"
#include "mesh_domains.h"
#include "labelled_triangulation_checks.h"
#include "opened_complex.h"

#include <CGAL/Global_odt_mesh_3/internal/complex/Candidate_checks_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_updater_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Editable_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Vertex_cavity_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Vertex_trial_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Labelled_triangulation_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Angle_deficit_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Random_source.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/slivers/Sliver_removal_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <limits>
#include <random>
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

typedef std::array<Site, 4> Tetrahedron;

static double deficit(const Tetrahedron& t, double bound)
{
  return Angle_deficit_3(bound)(t);
}

static double determinant(const Tetrahedron& t)
{
  return (position(t[1]) - position(t[0])).cross(position(t[2]) - position(t[0])).dot(position(t[3]) - position(t[0]));
}

// The deficit is the sum of the squares of what the six angles lack, a function of the shape of
// the cell alone, and nothing where nothing is missing.
static void angle_deficit(std::mt19937& random)
{
  std::uniform_real_distribution<double> u(-1, 1);
  int with_deficit = 0, without = 0, slivers = 0;
  for(int n = 0; n < 2000; ++n)
  {
    Tetrahedron t;
    for(int i = 0; i < 4; ++i)
      t[i] = { u(random), u(random), u(random), 0 };
    if(n % 4 == 1)        // a sliver: a quadrangle that is not quite flat
    {
      const double height = std::pow(10, 4 * u(random) - 5);
      for(int i = 0; i < 4; ++i)
        t[i] = { std::cos(1.57 * i + 0.2 * u(random)), std::sin(1.57 * i + 0.2 * u(random)), height * u(random), 0 };
    }
    if(n % 4 == 2)        // a short edge
      t[1] = { t[0].x + 1e-3 * u(random), t[0].y + 1e-3 * u(random), t[0].z + 1e-3 * u(random), 0 };
    const Cell_shape_3 shape(t[0], t[1], t[2], t[3]);
    for(double bound : { 20., 65., 110. })
    {
      double expected = 0;
      for(double angle : shape.angles)
        expected += angle < bound ? (bound - angle) * (bound - angle) : 0;
      const double found = deficit(t, bound);
      // The angle of a flat cell is as far off as the cosine rounds.
      const double rounding = 1e-3 * bound;
      check::that(std::abs(found - expected) <= rounding, "the deficit of a cell is ", found, ", not ", expected);
      (found > 0 ? with_deficit : without) += 1;
      slivers += n % 4 == 1 && found > 3 * 19 * 19;

      std::array<int, 4> order = {{ 0, 1, 2, 3 }};
      do
      {
        const Tetrahedron permuted = {{ t[order[0]], t[order[1]], t[order[2]], t[order[3]] }};
        check::that(std::abs(deficit(permuted, bound) - found) <= rounding, "the order of the vertices matters");
      }
      while(std::next_permutation(order.begin(), order.end()));
      Tetrahedron elsewhere = t;
      for(Site& s : elsewhere)
        s = { 1024 * s.x + 100, 1024 * s.y - 30, 1024 * s.z + 7, 5 };
      check::that(std::abs(deficit(elsewhere, bound) - found) <= rounding, "position, scale or weight matters");
    }
  }
  check::that(with_deficit > 1000 && without > 100 && slivers > 100, "not all kinds of cells tried: ", with_deficit, ' ',
              without, ' ', slivers);
  const Tetrahedron regular = {{ { 1, 1, 1, 0 }, { 1, -1, -1, 0 }, { -1, 1, -1, 0 }, { -1, -1, 1, 0 } }};
  const double angle = std::acos(1 / 3.) * 180 / CGAL_PI;
  check::that(deficit(regular, angle - 1e-6) == 0, "a regular cell lacks something");
  check::that(std::abs(deficit(regular, angle + 1) - 6) < 1e-9, "a regular cell does not lack one degree six times");
}

// The gradient of each angle that lacks something is what differences say, and that of all vertices together is
// zero, since a translation changes no angle.
static void angle_gradients(std::mt19937& random)
{
  std::uniform_real_distribution<double> u(-1, 1);
  const Angle_deficit_3 angle_deficit(179);
  check::Largest largest_error, largest_sum;
  int tried = 0;
  while(tried < 200)
  {
    Tetrahedron t;
    for(Site& s : t)
      s = { u(random), u(random), u(random), 0 };
    const Cell_shape_3 shape(t[0], t[1], t[2], t[3]);
    if(*std::min_element(shape.angles.begin(), shape.angles.end()) < 5 || !(determinant(t) > 0))
      continue;
    ++tried;
    const auto lacks = [&](const Tetrahedron& moved)
    {
      std::vector<double> result;
      angle_deficit.for_each_lack(moved, [&](double lack) { result.push_back(lack); });
      return result;
    };
    std::vector<Vector_3> sum(6, Vector_3());
    for(int m = 0; m < 4; ++m)
    {
      std::vector<Vector_3> gradient;
      angle_deficit.for_each_gradient(t, m, [&](double, const Vector_3& g) { gradient.push_back(g); });
      check::that(gradient.size() == 6, "only ", gradient.size(), " angles have gradients");
      const Vector_3 direction = Vector_3(u(random), u(random), u(random)).normalized();
      const double h = 1e-6;
      Tetrahedron forward = t, backward = t;
      forward[m] = site_at(position(t[m]) + h * direction, 0);
      backward[m] = site_at(position(t[m]) - h * direction, 0);
      const std::vector<double> after = lacks(forward), before = lacks(backward);
      for(std::size_t n = 0; n < 6; ++n)
      {
        sum[n] += gradient[n];
        const double difference = (before[n] - after[n]) / (2 * h);
        largest_error.add(std::abs(gradient[n].dot(direction) - difference) / (1 + gradient[n].length()));
      }
    }
    for(const Vector_3& s : sum)
      largest_sum.add(s.length());
  }
  std::cout << "gradients of angles are off by " << largest_error << ", of translations by " << largest_sum << std::endl;
  check::that(largest_error < 1e-5 && largest_sum < 1e-8, "gradients of angles are wrong");
}

// The cells with their subdomains and the boundary facets, named by vertices, and the positions.
struct Contents
{
  std::set<std::pair<std::array<int, 4>, int> > cells;
  std::set<std::pair<std::array<int, 3>, std::array<int, 3> > > facets;
  std::vector<double> coordinates;

  explicit Contents(const Editable_complex_3& complex)
  {
    for(int c : complex.triangulation.cells())
      cells.insert({ sorted(complex.triangulation.vertices(c)), complex.triangulation.label(c) });
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

// A cell in whose sphere the site is, or an infinite one.
static int conflicting_cell(const Labelled_triangulation_3& tr, const Site& s)
{
  std::vector<Site> sites = tr.sites();
  sites.push_back(s);
  const Trial_predicates_3 predicates(sites);
  for(int c : tr.cells())
    if(predicates.is_in_conflict(predicates.sphere(tr.vertices(c)), static_cast<int>(sites.size()) - 1))
      return c;
  return tr.cells().front();
}

// Vertices move, come, and go at random, and the triangulation is always that of its sites, also where these are on lines, planes,
// and spheres together: those of a lattice, or half as far apart, and some with weights.
static void cavities(bool is_lattice, unsigned int seed)
{
  Random_source random(seed);
  constexpr int number = 600, side = 9;
  const auto random_site = [&]
  {
    const auto x = [&] { return is_lattice ? std::floor(2 * side * random.uniform()) / 2 : side * random.uniform(); };
    const double a = x(), b = x(), c = x();
    return Site{ a, b, c, 0 };
  };
  std::vector<Site> sites(number);
  for(int v = 0; v < number; ++v)
  {
    sites[v] = is_lattice ? Site{ double(v % side), double(v / side % side), double(v / side / side), 0 } : random_site();
    sites[v].weight = v % 10 != 0 ? 0 : is_lattice ? 0.1 : 1e-6;
  }
  Labelled_triangulation_3 tr;
  tr.build(sites);
  check::that(tr.is_complete(), "some vertices are hidden from the beginning");
  Vertex_cavity_3 cavity(tr);
  std::array<int, 3> done = {}, refused = {};
  for(int n = 0; n < 600; ++n)
  {
    const int v = static_cast<int>(random.uniform() * number), what = tr.is_visible(v) ? n % 2 : 2;
    Site to = random_site();
    if(what == 0)
    {
      Vector_3 by = position(to) - position(tr.sites()[v]);
      for(int i = 0; i < 3; ++i)
        by[i] = (std::max)(-1., (std::min)(1., std::round(by[i])));
      to = site_at(position(tr.sites()[v]) + by * (is_lattice ? 0.5 : 0.3 * random.uniform()), 0);
    }
    bool is_found;
    if(what == 2)
    {
      tr.set_site(v, to);
      cavity.start_new(v, conflicting_cell(tr, to));
      is_found = cavity.find_cells(to);
    }
    else if(tr.sites()[v].weight != 0)
      continue;
    else
      is_found = cavity.start(v) && (what == 1 ? cavity.find_cells_without() : cavity.find_cells(to));
    ++(is_found ? done : refused)[what];
    if(!is_found)
      continue;
    cavity.replace(tr);
    check::that(tr.is_visible(v) == (what != 1), "a vertex has no cells, or too many");
    if(n % 20 == 0)
      check::that(is_regular_triangulation_of_cgal(tr), "seed ", seed, ", change ", n, ": not the regular triangulation");
  }
  std::cout << (is_lattice ? "lattice" : "random sites") << ", seed " << seed << ": " << done[0] << " moves, " << done[1]
            << " removals, " << done[2] << " insertions; refused " << refused[0] << ", " << refused[1] << ", " << refused[2]
            << std::endl;
  check::that(done[0] > 50 && done[1] > 50 && done[2] > 50 && refused[1] == 0, "the test is too weak");
}

// A trial leaves everything as it was; what it has said before, it says again.
template <class C3t3, class Domain>
void trials(const std::string& name, const C3t3& c3t3, const Domain& domain, bool moves_surfaces)
{
  Opened_complex<C3t3, Domain> setting(c3t3, domain, true);
  Editable_complex_3 complex = setting.complex.edit();
  Vertex_trial_3 trial(complex);
  const int step = Sliver_steps::last(40);
  trial.set_goal(Sliver_goal(Sliver_steps::angles[step], step));
  const Contents before(complex);
  Random_source random(5);
  int tried = 0, on_surface = 0, permitted = 0, refused = 0, other = 0;
  for(const Sliver_3& sliver : complex.slivers(Sliver_steps::angles[step]))
    for(int v : trial.movable_vertices(sliver.vertices))
    {
      if(tried == 400 || !trial.start(v))
        break;
      ++tried;
      on_surface += complex.numbering.is_on_boundary(v);
      for(int n = 0; n < 4; ++n)
      {
        const Site from = trial.from();
        Site s = site_at(position(from) + 0.3 * trial.mean_edge_length() * random.uniform() * random.direction(), from.weight);
        const double most = (std::numeric_limits<double>::infinity)(), change = trial.move_near(s, most);
        ++(std::isfinite(change) ? permitted : refused);
        const double again = std::isfinite(change) ? trial.move(s, most) : change;
        other += again != change && !(std::abs(again - change) <= 1e-9 * (1 + std::abs(change)));
      }
      if(tried % 50 == 0)
        check::that(Contents(complex) == before, name, ": a trial leaves a trace");
    }
  std::cout << name << ": " << tried << " vertices tried, " << on_surface << " of surfaces, " << permitted
            << " places permitted, " << refused << " refused" << std::endl;
  check::that(Contents(complex) == before, name, ": trials leave a trace");
  check::that(other == 0, name, ": ", other, " trials end otherwise a second time");
  check::that(tried > 50 && permitted > 0 && refused > 0 && (on_surface > 0) == moves_surfaces, name, ": the test is too weak");
}

// Slivers are removed, and what comes out is a mesh as good as the one before in all other respects.
template <class C3t3, class Domain>
void removal(const std::string& name, const C3t3& c3t3, const Domain& domain, bool boundary_moves, int step,
             double most_left)
{
  const double bound = Sliver_steps::angles[step];
  const Mesh_contract<C3t3, Domain> contract(c3t3, domain, name);
  std::vector<C3t3> results;
  for(int run = 0; run < 2; ++run)
  {
    Opened_complex<C3t3, Domain> setting(c3t3, domain, boundary_moves);
    Editable_complex_3 complex = setting.complex.edit();
    Sliver_removal_3 removal(complex, step, 1);
    const std::size_t before = removal.number_of_slivers();
    removal.raise_angles(1000000, [] { return true; });
    const std::size_t after = complex.slivers(bound).size();
    check::that(after == removal.number_of_slivers(), name, ": not all slivers are known");
    std::cout << name << ": " << before << " -> " << after << " cells below " << bound << " degrees by "
              << removal.number_of_moves() << " moves, " << removal.number_of_tries() << " tries" << std::endl;
    check::that(before > 5 && removal.number_of_moves() > 0, name, ": there was nothing to do");
    check::that(double(after) <= most_left * double(before), name, ": ", after, " of ", before, " slivers remain");
    check::that(is_regular_triangulation_of_cgal(complex.triangulation), name, ": the triangulation is not regular");
    const Contents reached(complex);
    check::that(setting.complex.adopt(complex), name, ": the complex does not adopt the trials");
    Editable_complex_3 next = setting.complex.edit();
    check::that(Contents(next) == reached, name, ": the complex is not what trials have led to");
    check::that(setting.complex.adopt(next), name, ": the complex does not adopt trials that move nothing");
    results.push_back(setting.write());
  }
  if(boundary_moves)
    contract.check_moved(results[0], 1e-2);
  else
    contract.check(results[0]);
  typedef Mesh_contract<C3t3, Domain> Contract;
  check::that(Contract::points(results[0]) == Contract::points(results[1]), name, ": not deterministic");
}

// The smallest angle rises far beyond that of the input, and no step gets more cells below it.
template <class C3t3, class Domain>
void smallest_angle(const std::string& name, const C3t3& c3t3, const Domain& domain, double wanted)
{
  Opened_complex<C3t3, Domain> setting(c3t3, domain, true);
  Editable_complex_3 complex = setting.complex.edit();
  const int step = Sliver_steps::last(35);
  std::vector<std::size_t> before;
  for(int s = 0; s < step; ++s)
    before.push_back(complex.slivers(Sliver_steps::angles[s]).size());
  Sliver_removal_3 removal(complex, step, 1);
  removal.raise_smallest_angle(1000000, [] { return true; });
  const std::vector<Sliver_3> left = complex.slivers(Sliver_steps::angles[step]);
  const double smallest = left.empty() ? Sliver_steps::angles[step] : left.front().angle;
  std::cout << name << ": smallest angle " << smallest << " after " << removal.number_of_tries() << " tries" << std::endl;
  check::that(smallest >= wanted, name, ": smallest angle ", smallest);
  for(int s = 0; s < step; ++s)
  {
    const std::size_t after = complex.slivers(Sliver_steps::angles[s]).size();
    check::that(after <= before[s], name, ": ", after, " cells below ", Sliver_steps::angles[s], ", before ", before[s]);
  }
}

// Where three subdomains meet, vertices move, and the edges on that line remain edges between the same vertices.
static void junction_moves()
{
  const Labeled_domain domain = domains::labeled([](const domains::Point_3& p)
    { return domains::squared(p) >= 1 ? 0 : p.x() > 0.01 ? 1 : p.y() > 0.02 ? 2 : 3; });
  const Labeled_c3t3 c3t3 = domains::mesh(domain, 0.25);
  Opened_complex<Labeled_c3t3, Labeled_domain> setting(c3t3, domain, true);
  Editable_complex_3 complex = setting.complex.edit();
  Vertex_trial_3 trial(complex);
  const double bound = 50;
  trial.set_goal(Sliver_goal(bound, 0));
  Random_source random(3);
  const auto is_on_junction = [&complex](int v)
  {
    std::set<std::array<int, 2> > labels;
    for(int n : complex.boundary.around(v))
      labels.insert(complex.boundary.facet(n).labels);
    return labels.size() == 3;
  };
  int moved = 0, tried = 0;
  for(const Sliver_3& sliver : complex.slivers(bound))
    for(int v : trial.movable_vertices(sliver.vertices))
    {
      if(!is_on_junction(v) || !trial.start(v))
        continue;
      ++tried;
      const Site from = trial.from();
      Site s = site_at(position(from) + 0.1 * trial.mean_edge_length() * random.uniform() * random.direction(), from.weight);
      if(!std::isfinite(trial.move_near(s, (std::numeric_limits<double>::infinity)())) || !trial.accept())
        continue;
      ++moved;
      check::that(is_on_junction(v), "a vertex leaves the line where three subdomains meet");
    }
  std::cout << "junction: " << moved << " of " << tried << " moves" << std::endl;
  check::that(moved > 0 && setting.complex.adopt(complex), "no vertex where three subdomains meet moves");
  Mesh_contract<Labeled_c3t3, Labeled_domain>(c3t3, domain, "junction").check_moved(setting.write(), 1e-2);
}

// Nothing is done without tries or time, and the tries are no more than wanted, but for the last cells.
template <class C3t3, class Domain>
void limits(const C3t3& c3t3, const Domain& domain)
{
  Opened_complex<C3t3, Domain> setting(c3t3, domain, true);
  Editable_complex_3 complex = setting.complex.edit();
  const Contents before(complex);
  const int step = Sliver_steps::last(30);
  Sliver_removal_3 without_tries(complex, step, 1), without_time(complex, step, 1);
  without_tries.raise_angles(0, [] { return true; });
  without_time.raise_angles(1000000, [] { return false; });
  check::that(without_tries.number_of_moves() == 0 && without_time.number_of_moves() == 0 && Contents(complex) == before,
              "something is done without tries or without time");
  Sliver_removal_3 few(complex, Sliver_steps::number - 1, 1);
  few.raise_angles(2000, [] { return true; });
  const Sliver_removal_parameters p;
  const std::size_t most_for_a_cell = 4 * (p.tries_of_start + p.tries_per_vertex);
  check::that(few.number_of_tries() <= 2000 + 32 * most_for_a_cell, few.number_of_tries(), " tries");
}

// What facets may be is decided by the first mesh, also if a later one is worse.
static void bounds_stay(const Polyhedral_c3t3& c3t3, const Polyhedral_domain& domain)
{
  Opened_complex<Polyhedral_c3t3, Polyhedral_domain> setting(c3t3, domain, true);
  Complex_snapshot_3 worse = setting.complex.snapshot();
  for(int v = 0; v < static_cast<int>(worse.sites().size()); ++v)
  {
    Site s = worse.sites()[v];
    s.z *= 0.1;
    worse.triangulation.set_site(v, s);
  }
  Facet_bounds_3 of_worse(setting.domain);
  of_worse.measure(worse);
  const double angle = setting.bounds.smallest_angle();
  setting.bounds.measure(worse);
  int far = 0;
  for(const Boundary_facet& f : worse.boundary.complex().facets())
  {
    const Vector_3 c = centroid(f.vertices, worse.sites());
    far += !setting.bounds.is_close(f.vertices, *worse.numbering, c);
    check::that(of_worse.is_close(f.vertices, *worse.numbering, c), "the bounds are not those of the first mesh");
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
  const unsigned int seed = 11;
  std::cout << "seed " << seed << std::endl;
  std::mt19937 random(seed);
  angle_deficit(random);
  angle_gradients(random);
  {
    const Labeled_domain domain = domains::sphere();
    const Labeled_c3t3 c3t3 = domains::mesh(domain, 0.2);
    for(unsigned int seed = 0; seed < 3; ++seed)
      for(bool is_lattice : { false, true })
        cavities(is_lattice, seed);
    trials("sphere", c3t3, domain, true);
    removal("sphere", c3t3, domain, true, 1, 0);
    removal("sphere with its surface fixed", c3t3, domain, false, 0, 0.2);
    limits(c3t3, domain);
    smallest_angle("sphere", c3t3, domain, 25);
  }
  junction_moves();
  {
    const Labeled_domain domain = domains::three_subdomains();
    const Labeled_c3t3 c3t3 = domains::mesh(domain, 0.2);
    trials("three subdomains", c3t3, domain, true);
    removal("three subdomains", c3t3, domain, true, 1, 0.1);
  }
  {
    Polyhedral_domain domain(domains::notched_box());
    domain.detect_features();
    const Polyhedral_c3t3 c3t3 = domains::mesh(domain, 0.3, true);
    trials("box with features", c3t3, domain, true);
    removal("box with features", c3t3, domain, true, 0, 0.1);
    bounds_stay(c3t3, domain);
  }
  {
    domains::Polyhedron box, surface;
    make_box_with_surface(box, surface);
    Polyhedral_domain domain(surface, box);
    domain.detect_features();
    const Polyhedral_c3t3 c3t3 = domains::mesh(domain, 0.2, true);
    trials("box with a surface inside", c3t3, domain, true);
    removal("box with a surface inside", c3t3, domain, true, 0, 0.1);
  }
  return check::result();
}
