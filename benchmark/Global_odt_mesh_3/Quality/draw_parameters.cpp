// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What parameters do to the mesh of a CAD part, as pictures of it from the same place: parameters.png in the current directory. Inside,
// the color tells the smallest dihedral angle of a cell.
// Environment: CGAL_DATA_DIR, the directory of CGAL's data.

#include "benchmark_inputs.h"
#include "mesh_picture.h"

#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iomanip>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace inputs;

typedef std::pair<std::string, std::function<void(Polyhedral_c3t3&)> > Call;

static std::string title(const std::string& name, const Polyhedral_c3t3& c3t3)
{
  const CGAL::Mesh_quality_report_3 q = CGAL::mesh_quality_report_3(c3t3);
  std::ostringstream out;
  out << name << "\\n" << q.number_of_vertices << " vertices, " << std::fixed << std::setprecision(1) << q.smallest_angle
      << "°, " << std::setprecision(3) << q.mean_radius_ratio;
  return out.str();
}

// From red over yellow to green, for angles from 0 to 60 degrees.
static std::vector<mesh_picture::Polygon> colored_by_angle(std::vector<mesh_picture::Polygon> facets)
{
  for(mesh_picture::Polygon& f : facets)
    if(f.is_cut)
    {
      const double t = (std::min)(f.angle / 30, 2.);
      f.color = mesh_picture::shaded(t < 1 ? mesh_picture::Rgb{{ 215, 50 + 190 * t, 40 + 100 * t }}
                                           : mesh_picture::Rgb{{ 215 - 150 * (t - 1), 240 - 60 * (t - 1), 140 - 20 * (t - 1) }}, f.light);
    }
  return facets;
}

int main()
{
  constexpr double relative_size = 0.03;
  Polyhedral_domain domain(read_polyhedron(CGAL::data_file_path("meshes/fandisk.off")));
  domain.detect_features();
  const Polyhedral_c3t3 input = polyhedral_mesh(domain, relative_size, true);
  const CGAL::Bbox_3 box = domain.bbox();
  const double size = relative_size * std::hypot(box.x_span(), box.y_span(), box.z_span());
  const std::size_t vertices = input.triangulation().number_of_vertices();
  const auto call = [&domain](Polyhedral_c3t3& c3t3, const auto&... np) { CGAL::odt_optimize_mesh_3(c3t3, domain, np...); };
  const std::vector<Call> calls = {
    { "input", [](Polyhedral_c3t3&) {} },
    { "default", [&](Polyhedral_c3t3& c) { call(c); } },
    { "number_of_rounds = 0", [&](Polyhedral_c3t3& c) { call(c, params::number_of_rounds = 0); } },
    { "number_of_rounds = 20", [&](Polyhedral_c3t3& c) { call(c, params::number_of_rounds = 20); } },
    { "do_remove_slivers = false", [&](Polyhedral_c3t3& c) { call(c, params::do_remove_slivers = false); } },
    { "sliver_bound = 40", [&](Polyhedral_c3t3& c) { call(c, params::sliver_bound = 40); } },
    { "surface_weight = 0", [&](Polyhedral_c3t3& c) { call(c, params::surface_weight = 0); } },
    { "surface_weight = 10", [&](Polyhedral_c3t3& c) { call(c, params::surface_weight = 10); } },
    { "optimize_boundary = false", [&](Polyhedral_c3t3& c) { call(c, params::optimize_boundary = false); } },
    { "do_insert_vertices", [&](Polyhedral_c3t3& c) { call(c, params::do_insert_vertices = true); } },
    { "insertion and removal, sizing_field", [&](Polyhedral_c3t3& c)
      { call(c, params::do_insert_vertices = true, params::do_remove_vertices = true, params::sizing_field = 0.7 * size); } },
    { "insertion and removal, number_of_vertices", [&](Polyhedral_c3t3& c)
      { call(c, params::do_insert_vertices = true, params::do_remove_vertices = true, params::number_of_vertices = vertices / 2); } } };

  using namespace mesh_picture;
  const Window w = best_window(Cutaway<Polyhedral_c3t3>(input).visible_facets(), 1);
  const int columns = 3, rows = (static_cast<int>(calls.size()) + columns - 1) / columns, width = 420, height = 290;
  std::ofstream script = begin_script("noenhanced size " + std::to_string(columns * width) + ',' + std::to_string(rows * height)
                                      + " font 'sans,13'", "parameters", w, 0.56);
  std::vector<std::string> files;
  for(std::size_t n = 0; n < calls.size(); ++n)
  {
    Polyhedral_c3t3 c3t3(input);
    calls[n].second(c3t3);
    files.push_back("parameters_" + std::to_string(n) + ".dat");
    write_facets(colored_by_angle(Cutaway<Polyhedral_c3t3>(c3t3).visible_facets()), w, files.back());
    const int column = static_cast<int>(n) % columns, row = static_cast<int>(n) / columns;
    const double left = double(column) / columns, top = 1 - (row + 50. / height) / rows;
    script << "set lmargin at screen " << left << "; set rmargin at screen " << left + 1. / columns << "; set tmargin at screen " << top
           << "; set bmargin at screen " << top - 235. / height / rows << "\nset title \"" << title(calls[n].first, c3t3)
           << "\" offset 0,-0.5\n" << plot_facets(files.back());
  }
  script << "unset multiplot\n";
  script.close();
  draw("parameters", files);
  return EXIT_SUCCESS;
}
