// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What CGAL's optimizers, Tetrahedral Remeshing, this package, and, where they are installed, other mesh generators make of
// six domains: vertices, dihedral angles, cells below 20 degrees, the mean of 3r/R, the smallest angle of a facet, the largest
// change of a subdomain's volume, and the CPU time, as a table in Markdown; in another, readme.md, CGAL's odt, perturb and exude beside
// this package.
//
// CGAL's functions begin with the same mesh of make_mesh_3(), whose time is that of the first row alone. TetGen and Gmsh fill
// the boundary of that mesh, which they keep, where there is one subdomain. Their sizes are such that about as many vertices
// come out, and their time is that of one run.
//
//   compare_tools directory [name of an input]
//
// Files for the other programs and readme.md go to the directory, and a picture for each input, time_and_quality_<name>.png, in which our
// calls with 0, 1, 2, 4, 8, and 20 rounds are joined by a line. Environment: CGAL_DATA_DIR, the directory of CGAL's data.

#include "Markdown_table.h"
#include "benchmark_inputs.h"
#include "cpu_seconds.h"
#include "odt_of_mesh_3.h"
#include "paper_record.h"
#include "peer_meshers.h"
#include "subdomain_measures.h"
#include "synthetic_images.h"

#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/tetrahedral_remeshing.h>

#include <boost/algorithm/string/erase.hpp>

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace inputs;

struct Row
{
  std::size_t vertices = 0, below_20 = 0;
  double smallest_angle = 180, largest_angle = 0, radius_ratio = 0, facet_angle = 60;
  std::map<int, double> volumes;          // of the subdomains
};

template <class C3t3>
Row row_of(const C3t3& c3t3)
{
  const CGAL::Mesh_quality_report_3 q = CGAL::mesh_quality_report_3(c3t3, { 20 });
  Row row;
  row.vertices = q.number_of_vertices;
  row.below_20 = q.cells_below[0].second;
  row.smallest_angle = q.smallest_angle;
  row.largest_angle = q.largest_angle;
  row.radius_ratio = q.mean_radius_ratio;
  row.facet_angle = q.smallest_facet_angle;
  for(const auto& v : volumes(c3t3))
    row.volumes[static_cast<int>(v.first)] = v.second;
  return row;
}

// Of a mesh with one subdomain.
static Row row_of(const Tetrahedral_mesh& mesh, int subdomain)
{
  namespace odt = CGAL::Global_odt_mesh_3::internal;
  const auto site = [&mesh](int v) { return odt::site_at(odt::coordinates(mesh.points[v]), 0); };
  Row row;
  row.vertices = mesh.points.size();
  row.radius_ratio = mesh.mean_radius_ratio();
  for(const std::array<int, 4>& c : mesh.cells)
  {
    const odt::Cell_shape_3 shape(site(c[0]), site(c[1]), site(c[2]), site(c[3]));
    const auto extremes = std::minmax_element(shape.angles.begin(), shape.angles.end());
    row.smallest_angle = (std::min)(row.smallest_angle, *extremes.first);
    row.largest_angle = (std::max)(row.largest_angle, *extremes.second);
    row.below_20 += *extremes.first < 20;
  }
  row.volumes[subdomain] = mesh.volume();
  std::vector<odt::Site> sites;
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
    sites.push_back(site(static_cast<int>(v)));
  for(const std::array<int, 3>& f : boundary_facets(mesh))
    row.facet_angle = (std::min)(row.facet_angle, odt::smallest_angle_of_facet(f, sites));
  return row;
}

template <class C3t3>
Tetrahedral_mesh tetrahedral_mesh(const C3t3& c3t3)
{
  Tetrahedral_mesh mesh;
  std::map<typename C3t3::Vertex_handle, int> number;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
  {
    mesh.cells.emplace_back();
    for(int i = 0; i < 4; ++i)
    {
      const auto v = number.emplace(c->vertex(i), static_cast<int>(mesh.points.size()));
      if(v.second)
      {
        const Point_3 p = c->vertex(i)->point().point();
        mesh.points.emplace_back(p.x(), p.y(), p.z());
      }
      mesh.cells.back()[i] = v.first->second;
    }
  }
  return mesh;
}

template <class C3t3>
double mean_edge(const C3t3& c3t3)
{
  double sum = 0;
  std::size_t edges = 0;
  const auto& tr = c3t3.triangulation();
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    for(int i = 0; i < 3; ++i)
      for(int j = i + 1; j < 4; ++j, ++edges)
        sum += std::sqrt(tr.segment(c, i, j).squared_length());
  return sum / double(edges);
}

typedef std::pair<Row, double> Timed_row;

// What comes of it all.
struct Tables
{
  Markdown_table tools{ { "mesh", "tool" },
                        { { "vertices", 0, Better::NEITHER }, { "smallest dihedral angle (degrees)", 1, Better::HIGH },
                          { "largest dihedral angle (degrees)", 1, Better::LOW }, { "cells below 20 degrees", 0, Better::LOW },
                          { "mean 3r/R", 3, Better::HIGH }, { "smallest angle of a facet (degrees)", 1, Better::HIGH },
                          { "change of volume (%)", 2, Better::NEITHER }, { "CPU time (s)", 1, Better::NEITHER } } };
  Markdown_table readme{ { "mesh", "method" },
                         { { "vertices", 0, Better::NEITHER }, { "smallest dihedral angle (degrees)", 1, Better::HIGH },
                           { "mean radius ratio 3r/R", 3, Better::HIGH }, { "CPU time (s)", 1, Better::LOW } } };

  void add(const std::string& mesh, const std::string& tool, const Timed_row& result, const Row& input)
  {
    const Row& row = result.first;
    double change = 0;
    for(const auto& v : input.volumes)
    {
      const auto now = row.volumes.find(v.first);
      change = (std::max)(change, std::abs((now == row.volumes.end() ? 0 : now->second) / v.second - 1));
    }
    tools.add({ mesh, tool }, { double(row.vertices), row.smallest_angle, row.largest_angle, double(row.below_20), row.radius_ratio,
                                row.facet_angle, 100 * change, result.second }, &row != &input);     // the input is as it is
  }
};

// The CPU time of the processes that have been waited for.
static double seconds_of_children()
{
  rusage usage;
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

// Other mesh generators, for a domain of one piece.
static void compare_peers(const std::string& title, const Tetrahedral_mesh& mesh, const Row& input, const std::string& directory,
                          Tables& tables)
{
  for(const Peer_mesher& peer : peer_meshers(mesh, directory))
  {
    std::map<std::size_t, double> cpu;        // by the number of vertices
    Peer_mesher timed = peer;
    timed.run = [&](double size)
    {
      const double before = seconds_of_children();
      Tetrahedral_mesh result = peer.run(size);
      cpu[result.points.size()] = seconds_of_children() - before;
      return result;
    };
    const Tetrahedral_mesh result = mesh_of_size(timed, mesh.points.size(), std::cbrt(mesh.volume() / double(mesh.points.size())));
    if(result.cells.empty())
      std::cerr << peer.name << " is not there, or makes no mesh" << std::endl;
    else
      tables.add(title, peer.name, { row_of(result, input.volumes.begin()->first), cpu[result.points.size()] }, input);
  }
}

template <class C3t3, class Domain>
void compare(const std::string& name, const std::string& title, const std::string& directory, const Domain& domain,
             const std::function<C3t3()>& make, Tables& tables)
{
  C3t3 input;
  const double making = seconds([&] { input = make(); });
  const Timed_row made(row_of(input), making);
  const Row& of_input = made.first;
  tables.add(title, "`make_mesh_3()`", made, of_input);
  const Paper_record record(directory);
  const std::string picture = "time_and_quality_" + name;
  std::ofstream points = record.data(picture);
  std::vector<std::string> titles;
  const auto run = [&](const std::function<void(C3t3&)>& optimize)
  {
    C3t3 c3t3(input);
    CGAL::get_default_random() = CGAL::Random(0);
    const double cpu = seconds([&] { optimize(c3t3); });
    const Row row = row_of(c3t3);
    points << cpu << ' ' << row.radius_ratio << '\n';
    return Timed_row(row, cpu);
  };
  const auto row = [&](const char* what, bool is_in_readme, const std::function<void(C3t3&)>& optimize)
  {
    const Timed_row result = run(optimize);
    tables.add(title, what, result, of_input);
    if(is_in_readme)
      tables.readme.add({ title, what }, { double(result.first.vertices), result.first.smallest_angle, result.first.radius_ratio,
                                           result.second });
    titles.push_back(what);
    boost::erase_all(titles.back(), "`");       // which would be a command of gnuplot
    points << "\n\n";
  };
  row("CGAL's lloyd", false, [&](C3t3& c3t3) { CGAL::lloyd_optimize_mesh_3(c3t3, domain); });
  row("CGAL's odt", false, [&](C3t3& c3t3) { odt_of_mesh_3(c3t3, domain); });
  row("CGAL's odt, perturb, exude", true, [&](C3t3& c3t3)
  {
    odt_of_mesh_3(c3t3, domain);
    CGAL::perturb_mesh_3(c3t3, domain, params::sliver_bound = 20);
    CGAL::exude_mesh_3(c3t3);
  });
  const double length = mean_edge(input);
  row("Tetrahedral Remeshing", false, [&](C3t3& c3t3)
  {
    CGAL::tetrahedral_isotropic_remeshing(c3t3, length, params::number_of_iterations(3));
  });
  row("this package", true, [&](C3t3& c3t3) { CGAL::odt_optimize_mesh_3(c3t3, domain); });
  // On smooth domains, insertion changes next to nothing.
  row("this package, `do_insert_vertices`", name != "sphere" && name != "elephant", [&](C3t3& c3t3)
  {
    CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_insert_vertices(true));
  });
  for(std::size_t rounds : { 0, 1, 2, 4, 8, 20 })
    run([&](C3t3& c3t3) { CGAL::odt_optimize_mesh_3(c3t3, domain, params::number_of_rounds(rounds)); });
  points.close();
  std::string plots = Paper_record::plot("1:2", titles, "points pt 7 ps 1.5");
  plots.pop_back();
  record.draw(picture, "set termoption noenhanced\nset logscale x\nset xlabel 'CPU s' offset 0,0.5\nset title 'mean 3r/R, " + name + "'\n"
              "set xtics (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50)\nset autoscale xfix\nset key below Left reverse samplen 2 maxcols 2\n"
              "set offsets graph 0.1, graph 0.1, graph 0.1, graph 0.1\n" + plots
              + ", data index " + std::to_string(titles.size()) + " using 1:2 with linespoints lw 2 title 'this package, 0 to 20 rounds'\n",
              900, 480);
  if(of_input.volumes.size() == 1)
    compare_peers(title, tetrahedral_mesh(input), of_input, directory, tables);
}

int main(int argc, char* argv[])
{
  if(argc < 2)
  {
    std::fprintf(stderr, "usage: %s directory [name of an input]\n", argv[0]);
    return EXIT_FAILURE;
  }
  const std::string directory = argv[1], only = argc > 2 ? argv[2] : "";
  Tables tables;
  const auto is_wanted = [&](const char* name) { return only.empty() || only == name; };
  const auto compare_model = [&](const char* name, const char* title, double relative_size, bool with_features)
  {
    if(!is_wanted(name))
      return;
    const Polyhedron polyhedron = read_polyhedron(CGAL::data_file_path(std::string("meshes/") + name + ".off"));
    Polyhedral_domain domain(polyhedron);
    if(with_features)
      domain.detect_features();
    compare<Polyhedral_c3t3>(name, title, directory, domain, [&] { return polyhedral_mesh(domain, relative_size, with_features); },
                             tables);
  };
  const auto compare_labels = [&](const char* name, const char* title, const Labeled_domain& domain,
                                  const std::function<Labeled_c3t3()>& make)
  {
    compare<Labeled_c3t3>(name, title, directory, domain, make, tables);
  };
  const auto compare_image = [&](const char* name, const char* title, const CGAL::Image_3& image, double facet_size, double cell_size)
  {
    const Labeled_domain domain = image_domain(image);
    compare_labels(name, title, domain, [&] { return image_mesh(domain, facet_size, cell_size); });
  };
  if(is_wanted("sphere"))
  {
    const Labeled_domain domain = sphere_domain();
    compare_labels("sphere", "ball", domain, [&] { return sphere(domain, 0.096); });
  }
  compare_model("elephant", "elephant", 0.02, false);
  compare_model("fandisk", "CAD part (fandisk)", 0.03, true);
  compare_model("anchor", "CAD part (anchor)", 0.03, true);
  if(is_wanted("liver"))
    compare_image("liver", "image of a liver", read_image("liver.inr.gz"), 6, 8);
  if(is_wanted("polycrystal"))
    compare_image("polycrystal", "image of a polycrystal", synthetic_images::polycrystal(80, 20), 4, 5);
  std::cout << tables.tools;
  std::ofstream(directory + "/readme.md") << tables.readme;
  return EXIT_SUCCESS;
}
