// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What the paper shows on models, on those of CGAL's data, by figure:
//   12      the energy of CGAL's odt (NODT) after each of its iterations, and where Algorithms 1 and 2 of the paper and the default
//           call of odt_optimize_mesh_3() end: the elephant, of two sizes
//   14, 15  CAD parts, and meshes of many cells: joint and fandisk; the armadillo, of two sizes
//   17      interleaved refinement and optimization, global ODT, both with CGAL's perturb_mesh_3(), Lloyd's method, and the
//           default call: the elephant
//   2       the seconds of each stage of NODT, Algorithms 1 and 2, and the default call on four sizes of the elephant (Table 2),
//           and those of CGAL's exact triangulation of the vertices (Figure 21)
//
//   improve_models 12|14|15|17|2 [factor on the sizes of cells, default 1 [directory for rows and pictures]]
//
// Times are of the process. Environment: CGAL_DATA_DIR, the directory of CGAL's data.

#include "benchmark_inputs.h"
#include "cpu_seconds.h"
#include "mesh_picture.h"
#include "odt_of_mesh_3.h"
#include "paper_record.h"

#include <CGAL/Annealing_schedules_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/lloyd_optimize_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/perturb_mesh_3.h>
#include <CGAL/refine_mesh_3.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

using namespace inputs;
namespace odt = CGAL::Global_odt_mesh_3::internal;

typedef Polyhedral_domain Domain;
typedef Polyhedral_c3t3 C3t3;
typedef CGAL::Mesh_criteria_3<Polyhedral_triangulation> Criteria;

// The size of the elephant's cells, relative to the diagonal of its bounding box.
static const double elephant_size = 0.0102, elephant_distance = 1 / 6.;

static CGAL::Mesh_quality_report_3 report(const C3t3& c3t3) { return CGAL::mesh_quality_report_3(c3t3, { 10, 20 }); }

// The uniform energy, without its dimension: the volume below the facets and the number of vertices differ. That of a lattice
// of body-centered cubes is .3969.
static double energy(const C3t3& c3t3)
{
  const CGAL::Mesh_quality_report_3 r = report(c3t3);
  return r.total().energy * std::pow(double(r.number_of_vertices), 2 / 3.) / std::pow(r.total().volume, 5 / 3.);
}

// What the paper's table shows of a mesh, in the order of its columns, and the time that it took.
typedef std::array<std::string, 7> Mesh_numbers;
static const Mesh_numbers unknown = {{ "-", "-", "-", "-", "-", "-", "-" }};

// The rows of those that are known.
static void record_numbers(Paper_record& record, const std::string& figure, const std::string& name, const Mesh_numbers& paper,
                           const Mesh_numbers& here)
{
  static const Mesh_numbers what = {{ "smallest angle (degrees)", "largest angle (degrees)", "smallest 3r/R", "mean 3r/R",
                                      "cells below 10 degrees", "cells below 20 degrees", "CPU time (s)" }};
  for(std::size_t n = 0; n < what.size(); ++n)
    if(paper[n] != unknown[n] || here[n] != unknown[n])
      record.row(figure, name + ": " + what[n], paper[n], here[n]);
}

static void record_mesh(Paper_record& record, const std::string& figure, const std::string& name, const Mesh_numbers& paper,
                        const C3t3& c3t3, double time)
{
  const CGAL::Mesh_quality_report_3 r = report(c3t3);
  record_numbers(record, figure, text("%s, %zu vertices", name.c_str(), r.number_of_vertices), paper,
                 {{ text("%.2f", r.smallest_angle), text("%.2f", r.largest_angle), text("%.2f", r.smallest_radius_ratio),
                    text("%.4f", r.mean_radius_ratio), text("%zu", r.cells_below[0].second), text("%zu", r.cells_below[1].second),
                    text("%.1f", time) }});
}

static void perturb(C3t3& c3t3, const Domain& domain)
{
  CGAL::perturb_mesh_3(c3t3, domain, params::sliver_bound = 20, params::time_limit = 120);
}

// The seconds of the stages of one call or several, as far as they are of this package.
class Stages
{
public:
  void run(C3t3& c3t3, const Domain& domain, odt::Odt_task task, const odt::Odt_parameters& parameters)
  {
    typedef CGAL::Mesh_3::Null_global_optimizer_visitor<C3t3> Visitor;
    Visitor visitor;
    odt::Odt_mesh_optimizer_3<C3t3, Domain, Visitor> optimizer(c3t3, domain, task, parameters, visitor);
    all_ += seconds([&] { optimizer(); });
    for(int s = 0; s < Clock::NUMBER_OF_STAGES; ++s)
      seconds_[s] += optimizer.clock().seconds(s);
  }

  double all() const { return all_; }

  std::vector<std::pair<std::string, double> > of_stages() const
  {
    return { { "remesh", seconds_[Clock::REMESH] }, { "search", seconds_[Clock::SEARCH] }, { "minimize", seconds_[Clock::MINIMIZE] },
             { "restrict", seconds_[Clock::TRIANGULATE] + seconds_[Clock::CHECK] + seconds_[Clock::INDEX] },
             { "slivers", seconds_[Clock::REMOVE_SLIVERS] },
             { "other", seconds_[Clock::READ] + seconds_[Clock::DENSITY] + seconds_[Clock::WRITE] + seconds_[Clock::OTHER] } };
  }

private:
  typedef odt::Stage_clock Clock;

  double all_ = 0;
  std::array<double, Clock::NUMBER_OF_STAGES> seconds_ = {};
};

// Algorithm 1 of the paper, or Algorithm 2 if there are rounds: the boundary is remeshed and fixed then.
static Stages run_algorithm(C3t3& c3t3, const Domain& domain, std::size_t rounds)
{
  odt::Odt_parameters parameters;
  Stages stages;
  stages.run(c3t3, domain, odt::Odt_task::REMESH_BOUNDARY, parameters);
  parameters.optimize_boundary = parameters.do_remove_slivers = parameters.do_freeze = false;
  parameters.convergence = 0;
  parameters.max_iteration_number = 700;
  parameters.number_of_rounds = rounds;
  parameters.annealing_schedule = CGAL::Metropolis_annealing_schedule();
  stages.run(c3t3, domain, odt::Odt_task::OPTIMIZE, parameters);
  return stages;
}

struct Energy_visitor
{
  const C3t3* c3t3;
  std::vector<double>* energies;

  void after_compute_moves() {}
  void after_move_points() {}
  void after_rebuild_restricted_delaunay() {}
  void end_of_iteration(int) { energies->push_back(energy(*c3t3)); }
};

static void figure_12(Paper_record& record, double factor)
{
  const Polyhedron elephant = read_polyhedron(CGAL::data_file_path("meshes/elephant.off"));
  const Domain domain(elephant);
  for(double size : { 1.6, 1. })
  {
    const C3t3 input = polyhedral_mesh(domain, size * factor * elephant_size, false, elephant_distance);
    const std::string name = text("elephant of %zu vertices", std::size_t(input.triangulation().number_of_vertices()));
    std::vector<double> energies = { energy(input) };
    C3t3 nodt(input), local(input), global(input), ours(input);
    odt_of_mesh_3(nodt, domain, 60, Energy_visitor{ &nodt, &energies });
    run_algorithm(local, domain, 0);
    run_algorithm(global, domain, 20);
    CGAL::odt_optimize_mesh_3(ours, domain);
    int rises = 0;
    for(std::size_t n = 1; n < energies.size(); ++n)
      rises += energies[n] > energies[n - 1];
    const double e[] = { energy(nodt), energy(local), energy(global), energy(ours) };
    const auto below = [&](int n) { return percent(100 * (e[n] / e[0] - 1)); };
    record.rows("12", name, { { "energy of NODT", "0.5436", text("%.4f", e[0]) }, { "energy of Algorithm 1 over NODT", "-1.64 %", below(1) },
                              { "energy of Algorithm 2 over NODT", "-3.83 %", below(2) }, { "energy of the default call over NODT", "-", below(3) },
                              { "iterations of NODT in which the energy rises", "some", text("%d of %zu", rises, energies.size() - 1) } });
    record.claim("12", e[0] > e[1] && e[1] > e[2], name + ": NODT is above Algorithm 1 above Algorithm 2");
    record.draw_histograms("figure_12_histograms", { { "NODT", report(nodt) }, { "Algorithm 1", report(local) },
                                                     { "Algorithm 2", report(global) }, { "default call", report(ours) } });
    if(!record.has_directory())
      continue;
    {
      std::ofstream out = record.data("figure_12");
      for(std::size_t n = 0; n < energies.size(); ++n)
        out << n << ' ' << energies[n] << '\n';
    }
    record.draw("figure_12", text("set xlabel 'iteration'\nset ylabel 'energy'\nset yrange [%f:%f]\n"
                                  "plot data with linespoints title 'NODT', %f title 'Algorithm 1', %f title 'Algorithm 2', "
                                  "%f title 'default call'\n",
                                  0.98 * e[3], 1.15 * e[0], e[1], e[2], e[3]), 700);
  }
}

static void figure_14(Paper_record& record, double factor)
{
  for(const auto& part : { std::make_pair("fandisk", 0.0158), std::make_pair("joint", 0.025) })
    for_model_with_features([&](const std::string& name, const C3t3& input, const Domain& domain)
    {
      C3t3 ours(input);
      const double time = seconds([&] { CGAL::odt_optimize_mesh_3(ours, domain); });
      record_mesh(record, "14", name + ", default call", {{ "17.6", "155.3", "-", "0.8868", "-", "-", "-" }}, ours, time);
      record.claim("14", report(ours).smallest_angle > 15 && report(ours).cells_below[0].second == 0,
                   name + " is left with no angle below 15 degrees");
      record.draw_cutaways("figure_14_" + name, [&](const std::string& file) { draw_before_and_after(input, ours, file); });
    }, part.first, part.first, factor * part.second);
}

static void figure_15(Paper_record& record, double factor)
{
  const Polyhedron armadillo = read_polyhedron(CGAL::data_file_path("meshes/armadillo.off"));
  const Domain domain(armadillo);
  for(double size : { 0.0067, 0.0043 })
  {
    const C3t3 input = polyhedral_mesh(domain, factor * size, false, 1 / 6.);
    C3t3 ours(input);
    const double time = seconds([&] { CGAL::odt_optimize_mesh_3(ours, domain); });
    const std::string name = text("armadillo of %zuk cells", std::size_t(ours.number_of_cells_in_complex()) / 1000);
    record_mesh(record, "15", name + " (in the paper 277k), default call", {{ "15.2", "157.5", "-", "0.8715", "-", "-", "-" }}, ours, time);
    record.claim("15", report(ours).smallest_angle > 15 && report(ours).mean_radius_ratio > 0.8715,
                 name + ": no angle below 15 degrees, and a mean 3r/R above that of the paper");
    record.draw_cutaways("figure_15", [&](const std::string& file) { draw_before_and_after(input, ours, file); });
  }
}

// Refinement in levels, each of which is optimized by CGAL's odt.
static C3t3 interleave(const Domain& domain, double size)
{
  const CGAL::Bbox_3 b = domain.bbox();
  C3t3 c3t3 = polyhedral_mesh(domain, 2 * size, false, elephant_distance / 2);
  odt_of_mesh_3(c3t3, domain);
  for(double level : { 1.5, 1.2, 1. })
  {
    const double s = level * size * std::hypot(b.x_span(), b.y_span(), b.z_span());
    const Criteria criteria(params::facet_angle = 25, params::facet_size = s,
                            params::facet_distance = elephant_distance / level * s, params::cell_radius_edge_ratio = 3,
                            params::cell_size = s);
    CGAL::refine_mesh_3(c3t3, domain, criteria, params::no_exude(), params::no_perturb(), params::no_odt(), params::no_lloyd());
    odt_of_mesh_3(c3t3, domain);
  }
  return c3t3;
}

static void figure_17(Paper_record& record, double factor)
{
  const Polyhedron elephant = read_polyhedron(CGAL::data_file_path("meshes/elephant.off"));
  const Domain domain(elephant);
  const double size = factor * elephant_size;
  const auto show = [&](const std::string& what, const Mesh_numbers& paper, const C3t3& c3t3, double time)
  {
    record_mesh(record, "17", what, paper, c3t3, time);
  };
  C3t3 mesh;
  double time = seconds([&] { mesh = interleave(domain, size); });
  const CGAL::Mesh_quality_report_3 interleaved = report(mesh);
  show("interleaved", {{ "0.78", "178.3", "0.02", "0.8818", "21", "214", "187" }}, mesh, time);
  time += seconds([&] { perturb(mesh, domain); });
  show("interleaved, perturbed", {{ "20.0", "150.8", "0.30", "0.8685", "0", "0", "272" }}, mesh, time);

  C3t3 input;
  const double time_of_input = seconds([&] { input = polyhedral_mesh(domain, size, false, elephant_distance); });
  show("refined to the same size at once", unknown, input, time_of_input);
  mesh = input;
  time = time_of_input + seconds([&] { odt_of_mesh_3(mesh, domain); });
  show("CGAL's odt", unknown, mesh, time);
  time += seconds([&] { perturb(mesh, domain); });
  show("CGAL's odt, perturbed", unknown, mesh, time);
  mesh = input;
  time = time_of_input + seconds([&]
  {
    CGAL::lloyd_optimize_mesh_3(mesh, domain, params::do_freeze = false, params::max_iteration_number = 60);
  });
  show("CGAL's Lloyd, 60 iterations", unknown, mesh, time);
  mesh = input;
  time = time_of_input + seconds([&] { run_algorithm(mesh, domain, 20); });
  const CGAL::Mesh_quality_report_3 global = report(mesh);
  show("global ODT (Algorithm 2)", {{ "0.71", "178.9", "0.01", "0.9110", "17", "115", "236" }}, mesh, time);
  time += seconds([&] { perturb(mesh, domain); });
  show("global ODT, perturbed", {{ "20.0", "151.5", "0.33", "0.9007", "0", "0", "287" }}, mesh, time);
  C3t3 ours(input);
  time = time_of_input + seconds([&] { CGAL::odt_optimize_mesh_3(ours, domain); });
  show("default call", unknown, ours, time);
  record_numbers(record, "17", "Stellar (not free, not run)", {{ "37.2", "139.2", "0.29", "0.7648", "-", "-", "447" }}, unknown);
  record_numbers(record, "17", "global ODT, Stellar (not free, not run)", {{ "41.4", "136.1", "0.30", "0.8630", "-", "-", "658" }}, unknown);
  record.claim("17", global.mean_radius_ratio > interleaved.mean_radius_ratio, "global ODT has a higher mean 3r/R than interleaving");
  record.claim("17", report(ours).mean_radius_ratio > global.mean_radius_ratio && report(ours).cells_below[1].second == 0,
               "the default call has a higher mean 3r/R than both and no cell below 20 degrees");
  record.draw_histograms("figure_17", { { "interleaved", interleaved }, { "global ODT", global }, { "default call", report(ours) } });
  record.draw_cutaways("figure_16", [&](const std::string& file) { draw_before_and_after(input, ours, file); });
}

static void table_2(Paper_record& record, double factor)
{
  const Polyhedron elephant = read_polyhedron(CGAL::data_file_path("meshes/elephant.off"));
  const Domain domain(elephant);
  std::vector<std::pair<double, double> > totals;
  for(double size : { 2., 1.6, 1.26, 1. })
  {
    C3t3 c3t3;
    const double meshing = seconds([&] { c3t3 = polyhedral_mesh(domain, factor * size * elephant_size, false, elephant_distance); });
    std::vector<Polyhedral_triangulation::Weighted_point> points;
    for(auto v = c3t3.triangulation().finite_vertices_begin(); v != c3t3.triangulation().finite_vertices_end(); ++v)
      points.push_back(c3t3.triangulation().point(v));
    const double triangulating = seconds([&] { Polyhedral_triangulation().insert(points.begin(), points.end()); });
    C3t3 nodt(c3t3), local(c3t3), global(c3t3);
    const double all_of_nodt = seconds([&] { odt_of_mesh_3(nodt, domain, 60); });
    Stages ours;
    ours.run(c3t3, domain, odt::Odt_task::OPTIMIZE, odt::Odt_parameters());
    const std::string name = text("elephant of %zu vertices", points.size());
    record.rows("Table 2", name, { { "CPU time of meshing (s)", "-", text("%.2f", meshing) },
                                   { "CPU time of 60 iterations of NODT (s)", "-", text("%.2f", all_of_nodt) } });
    const auto show = [&](const std::string& method, const Stages& stages)
    {
      record.row("Table 2", name + ", " + method + ": CPU time (s)", "-", text("%.2f", stages.all()));
      for(const auto& s : stages.of_stages())
        record.row("Table 2", name + ", " + method + ": of this, " + s.first, "-", text("%.2f", s.second));
    };
    show("Algorithm 1", run_algorithm(local, domain, 0));
    show("Algorithm 2", run_algorithm(global, domain, 20));
    show("the default call", ours);
    record.row("21", text("CPU seconds of CGAL's exact triangulation of %zu vertices", points.size()), "-",
               text("%.3f", triangulating));
    totals.emplace_back(double(points.size()), ours.all());
  }
  const double growth = std::log(totals.back().second / totals.front().second)
                      / std::log(totals.back().first / totals.front().first);
  record.row("Table 2", "exponent of the time over the number of vertices", "-", text("%.2f", growth));
  record.claim("Table 2", growth < 1.5, "the time grows not much faster than the number of vertices");
}

int main(int argc, char* argv[])
{
  const std::string figure = argc > 1 ? argv[1] : "17";
  const double factor = argc > 2 ? std::atof(argv[2]) : 1;
  Paper_record record(argc > 3 ? argv[3] : "");
  if(figure == "12")
    figure_12(record, factor);
  else if(figure == "14")
    figure_14(record, factor);
  else if(figure == "15")
    figure_15(record, factor);
  else if(figure == "17")
    figure_17(record, factor);
  else
    table_2(record, factor);
  return record.result();
}
