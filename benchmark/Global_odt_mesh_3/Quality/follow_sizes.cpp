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
// Prints a table in Markdown: the standard deviation of log(mean edge length around a vertex / size wanted there), the ratio of the
// largest mean edge length to the smallest, the quality, and the time, as means of the seeds, and the smallest angle of all. Environment:
// CGAL_DATA_DIR, the directory of CGAL's data.

#include "Markdown_table.h"
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

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using namespace inputs;

// Of some meshes.
class Mean_of_meshes
{
public:
  template <class C3t3, class Size>
  void add(const C3t3& c3t3, const Size& size, double cpu)
  {
    const CGAL::Mesh_quality_report_3 r = CGAL::mesh_quality_report_3(c3t3);
    const Realized_sizes sizes(c3t3, size);
    ++number_;
    deviation_ += sizes.deviation;
    ratio_ += sizes.ratio;
    radius_ratio_ += r.mean_radius_ratio;
    smallest_angle_ = (std::min)(smallest_angle_, r.smallest_angle);
    cpu_ += cpu;
  }

  std::vector<double> values() const
  { return { deviation_ / number_, ratio_ / number_, radius_ratio_ / number_, smallest_angle_, cpu_ / number_ }; }

private:
  double number_ = 0, deviation_ = 0, ratio_ = 0, radius_ratio_ = 0, smallest_angle_ = 180, cpu_ = 0;
};

template <class C3t3, class Size>
void record_figure_13(Paper_record& record, const std::string& name, const std::string& what, const C3t3& input,
                      const C3t3& c3t3, const Size& size)
{
  const Realized_sizes before(input, size), after(c3t3, size);
  record.rows("13", name + ", " + what,
              { { "deviation of log(size / wanted) before", "-", text("%.4f", before.deviation) },
                { "deviation of log(size / wanted) after", "-", text("%.4f", after.deviation) },
                { "slope of log(size) over log(wanted)", "-", text("%.3f", after.slope) }, { "ratio of sizes", "-", text("%.1f", after.ratio) } });
  record.claim("13", after.deviation < before.deviation && std::abs(after.slope - 1) < 0.05,
               name + ", " + what + ": sizes follow those wanted more closely");
  record.draw_cutaways("figure_13_" + name, [&](const std::string& file) { draw_before_and_after(input, c3t3, file); });
}

template <class C3t3, class Domain, class Size>
void compare(const char* name, const C3t3& input, const Domain& domain, const Size& size, unsigned int seeds, double tolerance,
             Paper_record& record, Markdown_table& table)
{
  {
    Mean_of_meshes mean;
    mean.add(input, size, Markdown_table::none);
    table.add({ name, "input" }, mean.values(), false);
  }
  {
    C3t3 c3t3(input);
    const double time = seconds([&] { odt_of_mesh_3(c3t3, domain); });
    Mean_of_meshes mean;
    mean.add(c3t3, size, time);
    table.add({ name, "CGAL's odt" }, mean.values());
  }
  const auto optimize = [&](const char* what, const auto&... parameters)
  {
    Mean_of_meshes mean;
    for(unsigned int seed = 1; seed <= seeds; ++seed)
    {
      C3t3 c3t3(input);
      const double time = seconds([&] { CGAL::odt_optimize_mesh_3(c3t3, domain, params::random_seed(seed), parameters...); });
      mean.add(c3t3, size, time);
      if(seed == 1)
        record_figure_13(record, name, what, input, c3t3, size);
      Mesh_contract<C3t3, Domain>(input, domain, std::string(name) + ", " + what).check_moved(c3t3, tolerance);
    }
    table.add({ name, what }, mean.values());
  };
  optimize("default call");
  optimize("with `sizing_field`", params::sizing_field = size);
}

int main(int argc, char* argv[])
{
  const unsigned int seeds = argc > 1 ? std::atoi(argv[1]) : 3;
  Paper_record record(argc > 2 ? argv[2] : "");
  Markdown_table table({ "mesh", "method" },
                       { { "deviation of log(edge / size)", 3, Better::LOW }, { "largest edge over smallest", 1, Better::NEITHER },
                         { "mean 3r/R", 4, Better::HIGH }, { "smallest dihedral angle (degrees)", 1, Better::HIGH },
                         { "CPU time (s)", 1, Better::LOW } });
  {
    const Labeled_domain domain = sphere_domain();
    const double smallest = 0.0392;
    compare("sphere", graded_sphere(domain, smallest), domain, Graded_sphere_size{ smallest }, seeds, 4e-3,
            record, table);
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
                                                           params::no_features()), domain, size, seeds, 4e-3, record,
            table);
  }
  std::cout << table;
  return record.result() == EXIT_SUCCESS ? check::result() : record.result();
}
