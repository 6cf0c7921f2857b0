// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The default call, with and without the removal of slivers, beside what CGAL reaches with odt, perturb and exude on
// the same meshes, in one run, in CPU time, and each in a process of its own; then with CGAL's perturb and exude after it,
// and with a higher sliver bound. CGAL's functions know of no seed: for each, they do the same once more, and only the
// time differs.
//
//   compare_qualities [number of seeds, default 3] [rounds with the higher bound, default 6] [name of an input]
//
// Environment: CGAL_DATA_DIR, the directory of CGAL's data.

#include "benchmark_inputs.h"
#include "cpu_seconds.h"
#include "odt_of_mesh_3.h"
#include "process_of_its_own.h"

#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/exude_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/perturb_mesh_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>
#include <vector>

using namespace inputs;

typedef std::function<double(const Point_3&)> Size;

// The median of the lengths of edges over the sizes wanted, for each subdomain.
template <class C3t3>
std::map<int, double> median_edges(const C3t3& c3t3, const Size& size)
{
  std::map<int, std::vector<double> > lengths;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    for(int i = 0; i < 3; ++i)
      for(int j = i + 1; j < 4; ++j)
      {
        const Point_3 p = c->vertex(i)->point().point(), q = c->vertex(j)->point().point();
        lengths[static_cast<int>(c->subdomain_index())].push_back(std::sqrt(CGAL::squared_distance(p, q))
                                                                  / size(CGAL::midpoint(p, q)));
      }
  std::map<int, double> medians;
  for(auto& l : lengths)
  {
    std::nth_element(l.second.begin(), l.second.begin() + l.second.size() / 2, l.second.end());
    medians[l.first] = l.second[l.second.size() / 2];
  }
  return medians;
}

// A table of the meshes that come from one input.
template <class C3t3>
class Table
{
public:
  Table(const char* name, const C3t3& input, const Size& size)
    : size_(size)
    , volume_(CGAL::mesh_quality_report_3(input).total().volume)
    , medians_(median_edges(input, size))
  {
    std::size_t interior = 0;
    for(auto v = input.triangulation().finite_vertices_begin(); v != input.triangulation().finite_vertices_end(); ++v)
      interior += input.in_dimension(v) == 3;
    const std::size_t vertices = input.triangulation().number_of_vertices();
    std::printf("\n%s: %zu vertices, %.0f %% of them in the interior\n  %-30s %-7s %-16s %4s %5s  %-12s  %-9s %-7s %8s  %s\n", name,
                vertices, 100. * double(interior) / double(vertices), "", "3r/R", "dihedral", "<10", "<20", "facets, mean",
                "volume", "size", "CPU", "over CGAL's odt");
    print("input", input, 0);
  }

  // The time that the others are relative to.
  void set_reference(double time) { reference_ = time; }

  void print(const std::string& what, const C3t3& c3t3, double time) const
  {
    const CGAL::Mesh_quality_report_3 r = CGAL::mesh_quality_report_3(c3t3, { 10, 20 });
    double change = 0;
    for(const auto& m : median_edges(c3t3, size_))
      change = (std::max)(change, std::abs(m.second / medians_.at(m.first) - 1));
    std::printf("  %-30s %.4f  %6.2f - %6.2f  %4zu %5zu  %5.2f, %5.2f  %+.3f %%  %5.1f %%  %6.2f s  %5.2f\n", what.c_str(),
                r.mean_radius_ratio, r.smallest_angle, r.largest_angle, r.cells_below[0].second, r.cells_below[1].second,
                r.smallest_facet_angle, r.mean_facet_angle, 100 * (r.total().volume / volume_ - 1), 100 * change, time,
                time / reference_);
    std::fflush(stdout);
  }

private:
  Size size_;
  double volume_, reference_ = 1;
  std::map<int, double> medians_;
};

// Perturbs and exudes a mesh that took so long.
template <class C3t3, class Domain>
void perturb_and_exude(const Table<C3t3>& table, C3t3& c3t3, const Domain& domain, double time)
{
  time += seconds([&] { CGAL::perturb_mesh_3(c3t3, domain, params::sliver_bound = 20); });
  table.print("  then perturb(20)", c3t3, time);
  time += seconds([&] { CGAL::exude_mesh_3(c3t3); });
  table.print("  then exude", c3t3, time);
}

template <class C3t3, class Domain>
void compare(const char* name, const C3t3& input, const Domain& domain, const Size& size, unsigned int seeds,
             std::size_t more_rounds)
{
  Table<C3t3> table(name, input, size);
  // Gives the time.
  const auto call = [&](const std::string& what, bool is_reference, bool goes_on, const auto& optimize)
  {
    return in_process_of_its_own<double>([&]
    {
      C3t3 c3t3(input);
      const double time = seconds([&] { optimize(c3t3); });
      if(is_reference)
        table.set_reference(time);
      table.print(what, c3t3, time);
      if(goes_on)
        perturb_and_exude(table, c3t3, domain, time);
      return time;
    });
  };
  for(unsigned int seed = 1; seed <= seeds; ++seed)
  {
    const std::string suffix = ", seed " + std::to_string(seed);
    const auto call_ours = [&](const std::string& what, bool goes_on, const auto&... parameters)
    {
      call(what + suffix, false, goes_on, [&](C3t3& c3t3)
           { CGAL::odt_optimize_mesh_3(c3t3, domain, params::random_seed(seed), parameters...); });
    };
    table.set_reference(call("CGAL's odt", true, true, [&](C3t3& c3t3) { odt_of_mesh_3(c3t3, domain); }));
    call_ours("slivers left", false, params::do_remove_slivers = false);
    call_ours("default", true);
    call_ours("bound 35, " + std::to_string(more_rounds) + " rounds", false, params::number_of_rounds = more_rounds,
              params::sliver_bound = 35);
  }
}

int main(int argc, char* argv[])
{
  const unsigned int seeds = argc > 1 ? std::atoi(argv[1]) : 3;
  const std::size_t more_rounds = argc > 2 ? std::atoi(argv[2]) : 6;
  const std::string only = argc > 3 ? argv[3] : "";
  const auto compare_on = [&](const char* name, const auto& input, const auto& domain)
  {
    Size size = [](const Point_3&) { return 1.; };
    if(std::string(name) == "graded sphere")
      size = [](const Point_3& p) { return Graded_sphere_size{ 1 }(p, 3, 0); };
    compare(name, input, domain, size, seeds, more_rounds);
  };
  for_each_input(compare_on, only);
  for_each_coarse_part(compare_on, only);
  return EXIT_SUCCESS;
}
