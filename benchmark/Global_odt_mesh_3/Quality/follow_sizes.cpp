// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Figure 13 of the paper: how closely the cells follow the sizes that are wanted, beside what CGAL's odt does with the same
// meshes, in one run and in process CPU time: a sphere graded 5:1, and an elephant graded 20:1 by its local feature size. Of each
// result it is checked that what is promised of the complex is kept.
//
//   follow_sizes [number of seeds, default 3 [directory for rows and pictures]]
//
// Printed are the standard deviation of log(mean edge length around a vertex / size wanted there), the slope of one logarithm over
// the other, and the ratio of the largest mean edge length to the smallest. Environment: CGAL_DATA_DIR, the
// directory of CGAL's data.

#include "benchmark_inputs.h"
#include "cpu_seconds.h"
#include "mesh_contract.h"
#include "mesh_picture.h"
#include "odt_of_mesh_3.h"
#include "paper_record.h"
#include "realized_sizes.h"

#include <CGAL/Local_feature_size_field_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

using namespace inputs;

template <class C3t3, class Size>
void print(const std::string& what, const C3t3& c3t3, const Size& size, double time, double reference)
{
  const CGAL::Mesh_quality_report_3 r = CGAL::mesh_quality_report_3(c3t3, { 10, 15, 20 });
  const Realized_sizes sizes(c3t3, size);
  std::printf("  %-22s %.4f  %6.2f - %6.2f  %4zu %4zu %5zu   %.4f  %6.3f  %5.1f  %7.2f s  %5.2f\n", what.c_str(),
              r.mean_radius_ratio, r.smallest_angle, r.largest_angle, r.cells_below[0].second, r.cells_below[1].second,
              r.cells_below[2].second, sizes.deviation, sizes.slope, sizes.ratio, time, time / reference);
  std::fflush(stdout);
}

template <class C3t3, class Size>
void record_figure_13(Paper_record& record, const std::string& name, const std::string& what, const C3t3& input,
                      const C3t3& c3t3, const Size& size)
{
  const Realized_sizes before(input, size), after(c3t3, size);
  record.row("13", name + ", " + what + ": deviation of log(size / wanted) before and after, slope, ratio of sizes", "-",
             text("%.4f, %.4f; %.3f; %.1f", before.deviation, after.deviation, after.slope, after.ratio));
  record.claim("13", after.deviation < before.deviation && std::abs(after.slope - 1) < 0.05,
               name + ", " + what + ": sizes follow those wanted more closely");
  record.draw_cutaways("figure_13_" + name, [&](const std::string& file) { draw_before_and_after(input, c3t3, file); });
}

template <class C3t3, class Domain, class Size>
void compare(const char* name, const C3t3& input, const Domain& domain, const Size& size, unsigned int seeds, double tolerance,
             Paper_record& record)
{
  std::printf("\n%s: %zu vertices\n  %-22s %-7s %-16s %4s %4s %5s   %-7s %6s  %6s %9s  %s\n", name,
              std::size_t(input.triangulation().number_of_vertices()), "", "3r/R", "dihedral", "<10", "<15", "<20", "std log",
              "slope", "ratio", "CPU", "over CGAL's odt");
  print("input", input, size, 0, 1);
  double reference = 1;
  {
    C3t3 c3t3(input);
    reference = seconds([&] { odt_of_mesh_3(c3t3, domain); });
    print("CGAL's odt", c3t3, size, reference, reference);
  }
  const auto optimize = [&](const char* what, unsigned int seed, const auto&... parameters)
  {
    C3t3 c3t3(input);
    const double time = seconds([&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::random_seed(seed), parameters...); });
    print(std::string(what) + ", seed " + std::to_string(seed), c3t3, size, time, reference);
    if(seed == 1)
      record_figure_13(record, name, what, input, c3t3, size);
    Mesh_contract<C3t3, Domain>(input, domain, std::string(name) + ", " + what).check_moved(c3t3, tolerance);
  };
  for(unsigned int seed = 1; seed <= seeds; ++seed)
    optimize("default", seed);
  for(unsigned int seed = 1; seed <= seeds; ++seed)
    optimize("sizing_field", seed, params::sizing_field = size);
}

int main(int argc, char* argv[])
{
  const unsigned int seeds = argc > 1 ? std::atoi(argv[1]) : 3;
  Paper_record record(argc > 2 ? argv[2] : "");
  {
    const Labeled_domain domain = sphere_domain();
    const double smallest = 0.0392;
    compare("sphere", graded_sphere(domain, smallest), domain, Graded_sphere_size{ smallest }, seeds, 4e-3,
            record);
  }
  {
    typedef CGAL::Mesh_criteria_3<Polyhedral_triangulation> Criteria;
    const Polyhedron elephant = read_polyhedron(CGAL::data_file_path("meshes/elephant.off"));
    const Polyhedral_domain domain(elephant);
    const CGAL::Bbox_3 b = domain.bbox();
    const double diagonal = std::hypot(b.x_span(), b.y_span(), b.z_span());
    CGAL::Local_feature_size_parameters_3 parameters;
    parameters.size_factor = 0.4;
    parameters.gradation = 0.45;
    parameters.sample_spacing = 0.005 * diagonal;
    parameters.smallest_size = 0.002 * diagonal;
    parameters.largest_size = 20 * parameters.smallest_size;
    const CGAL::Local_feature_size_field_3<Polyhedral_domain> size(domain, parameters);
    const Criteria criteria(params::facet_angle = 25, params::facet_size = size,
                            params::facet_distance = 0.002 * diagonal, params::cell_radius_edge_ratio = 2,
                            params::cell_size = size);
    compare("elephant", CGAL::make_mesh_3<Polyhedral_c3t3>(domain, criteria, params::no_exude(), params::no_perturb(),
                                                           params::no_features()), domain, size, seeds, 4e-3, record);
  }
  return record.result() == EXIT_SUCCESS ? check::result() : record.result();
}
