// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The default call beside what CGAL reaches with odt and perturb on the same meshes, in one run and in
// process CPU time; then with a higher sliver bound; then with CGAL's perturb and exude after it.
//
//   compare_qualities [number of seeds, default 3] [rounds with the higher bound, default 6] [name of an input]
//
// Environment: CGAL_DATA_DIR, the directory of CGAL's data.

#include "benchmark_inputs.h"
#include "cpu_seconds.h"
#include "odt_of_mesh_3.h"

#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/exude_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/perturb_mesh_3.h>

#include <algorithm>
#include <cmath>
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

template <class C3t3>
void print(const std::string& what, const C3t3& c3t3, const C3t3& input, const Size& size, double time, double reference_time)
{
  const CGAL::Mesh_quality_report_3 r = CGAL::mesh_quality_report_3(c3t3, { 10, 20 });
  const double volume = CGAL::mesh_quality_report_3(input, { 10 }).total().volume;
  double change = 0;
  const std::map<int, double> before = median_edges(input, size), after = median_edges(c3t3, size);
  for(const auto& m : before)
    change = (std::max)(change, std::abs(after.at(m.first) / m.second - 1));
  std::printf("  %-26s %.4f  %6.2f - %6.2f  %4zu %5zu  %+.3f %%  %5.1f %%  %6.2f s  %5.2f\n", what.c_str(), r.mean_radius_ratio,
              r.smallest_angle, r.largest_angle, r.cells_below[0].second, r.cells_below[1].second,
              100 * (r.total().volume / volume - 1), 100 * change, time, time / reference_time);
  std::fflush(stdout);
}

template <class C3t3, class Domain>
void compare(const char* name, const C3t3& input, const Domain& domain, const Size& size, unsigned int seeds,
             std::size_t more_rounds)
{
  std::printf("\n%s: %zu vertices\n  %-26s %-7s %-16s %4s %5s  %-9s %-7s %8s  %s\n", name,
              std::size_t(input.triangulation().number_of_vertices()), "", "3r/R", "dihedral", "<10", "<20", "volume", "size",
              "CPU", "over CGAL's odt");
  double reference = 1;
  {
    C3t3 c3t3(input);
    reference = seconds([&] { odt_of_mesh_3(c3t3, domain); });
    print("CGAL's odt", c3t3, input, size, reference, reference);
    const double time = seconds([&] { CGAL::perturb_mesh_3(c3t3, domain, params::sliver_bound = 20); });
    print("CGAL's odt, perturb(20)", c3t3, input, size, reference + time, reference);
  }
  for(unsigned int seed = 1; seed <= seeds; ++seed)
  {
    C3t3 c3t3(input);
    const double time = seconds([&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::random_seed(seed)); });
    print("default, seed " + std::to_string(seed), c3t3, input, size, time, reference);
  }
  for(unsigned int seed = 1; seed <= seeds; ++seed)
  {
    C3t3 c3t3(input);
    const double time = seconds([&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::random_seed(seed),
                                                                params::number_of_rounds = more_rounds,
                                                                params::sliver_bound = 35); });
    print("bound 35, seed " + std::to_string(seed), c3t3, input, size, time, reference);
    if(seed > 1)
      continue;
    const double perturbing = seconds([&] { CGAL::perturb_mesh_3(c3t3, domain, params::sliver_bound = 20); });
    print("  then perturb(20)", c3t3, input, size, perturbing, reference);
    const double exuding = seconds([&] { CGAL::exude_mesh_3(c3t3, params::sliver_bound = 20); });
    print("  then exude(20)", c3t3, input, size, exuding, reference);
  }
}

int main(int argc, char* argv[])
{
  const unsigned int seeds = argc > 1 ? std::atoi(argv[1]) : 3;
  const std::size_t more_rounds = argc > 2 ? std::atoi(argv[2]) : 6;
  const std::string only = argc > 3 ? argv[3] : "";
  for_each_input([&](const char* name, const auto& input, const auto& domain)
  {
    Size size = [](const Point_3&) { return 1.; };
    if(std::string(name) == "graded sphere")
      size = [](const Point_3& p) { return Graded_sphere_size{ 1 }(p, 3, 0); };
    if(only.empty() || only == name)
      compare(name, input, domain, size, seeds, more_rounds);
  });
  return EXIT_SUCCESS;
}
