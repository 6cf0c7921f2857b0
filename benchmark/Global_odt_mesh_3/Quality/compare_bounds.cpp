// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What a sliver bound of 10, 20, ..., 50 degrees leads to: the smallest dihedral angle and the numbers of cells below each
// of them, and the process CPU time relative to that of the default call. A line where the angle is smaller, or a step of
// the removal that both bounds go for leaves more cells, than in a line before, is marked.
//
//   compare_bounds [seed, default 0] [name of an input]
//
// Environment: CGAL_DATA_DIR, the directory of CGAL's data.

#include "benchmark_inputs.h"
#include "cpu_seconds.h"

#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

using namespace inputs;

static const std::vector<double> bounds = { 10, 20, 30, 40, 50 };

static void print(const std::string& what, const CGAL::Mesh_quality_report_3& r, double time, double reference)
{
  std::printf("  %-10s %6.2f ", what.c_str(), r.smallest_angle);
  for(const auto& below : r.cells_below)
    std::printf(" %6zu", below.second);
  std::printf("  %.4f  %5.2f  %6.2f s  %5.2f", r.mean_radius_ratio, r.smallest_facet_angle, time, time / reference);
}

// What the bounds before have led to at the best.
class Best
{
public:
  bool is_better_than(const CGAL::Mesh_quality_report_3& r) const
  {
    bool is_better = r.smallest_angle < smallest_angle_ - 1e-6;
    for(std::size_t n = 0; n < cells_below_.size(); ++n)
      is_better |= r.cells_below[first_step + n].second > cells_below_[n];
    return is_better;
  }

  // Adds bounds[number].
  void add(const CGAL::Mesh_quality_report_3& r, std::size_t number)
  {
    smallest_angle_ = (std::max)(smallest_angle_, r.smallest_angle);
    for(std::size_t n = 0; n < cells_below_.size(); ++n)
      cells_below_[n] = (std::min)(cells_below_[n], r.cells_below[first_step + n].second);
    if(number >= first_step)
      cells_below_.push_back(r.cells_below[number].second);
  }

private:
  static constexpr std::size_t first_step = 1;    // that of 20 degrees; cells below less are not counted in the removal

  double smallest_angle_ = 0;
  std::vector<std::size_t> cells_below_;          // bounds[first_step] and so on, up to the last bound
};

template <class C3t3, class Domain>
void compare(const char* name, const C3t3& input, const Domain& domain, unsigned int seed)
{
  std::printf("\n%s: %zu vertices, %zu cells\n  %-10s %6s ", name, std::size_t(input.triangulation().number_of_vertices()),
              std::size_t(input.number_of_cells_in_complex()), "bound", "angle");
  for(double b : bounds)
    std::printf("    <%2.0f", b);
  std::printf("  %-6s  %-5s  %8s  %s\n", "3r/R", "facet", "CPU", "over the default call's");
  double reference = 1;
  {
    C3t3 c3t3(input);
    reference = seconds([&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::random_seed(seed)); });
    print("default", CGAL::mesh_quality_report_3(c3t3, bounds), reference, reference);
    std::puts("");
  }
  Best best;
  for(std::size_t n = 0; n < bounds.size(); ++n)
  {
    C3t3 c3t3(input);
    const double time = seconds([&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::random_seed(seed),
                                                                params::sliver_bound = bounds[n]); });
    const CGAL::Mesh_quality_report_3 r = CGAL::mesh_quality_report_3(c3t3, bounds);
    print(std::to_string(static_cast<int>(bounds[n])), r, time, reference);
    std::puts(best.is_better_than(r) ? "  worse than before" : "");
    std::fflush(stdout);
    best.add(r, n);
  }
}

int main(int argc, char* argv[])
{
  const unsigned int seed = argc > 1 ? std::atoi(argv[1]) : 0;
  const std::string only = argc > 2 ? argv[2] : "";
  const auto compare_on = [seed](const char* name, const auto& input, const auto& domain) { compare(name, input, domain, seed); };
  for_each_input(compare_on, only);
  for_each_coarse_part(compare_on, only);
  return EXIT_SUCCESS;
}
