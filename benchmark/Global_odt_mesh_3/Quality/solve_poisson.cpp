// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Table 1 of the paper: linear finite elements for Poisson's equation in the cube [-1, 1]^3 on the meshes of different
// methods, with about the same number of vertices in all and on the boundary. Beside the paper's u = xyz, which is harmonic,
// so that a structured grid is exact at its vertices, stands a product of cosines.
//
//   solve_poisson [number of sizes, default 5 [number of seeds, default 3 [most vertices, default 10000
//                 [directory for rows, pictures and what other programs write, default the current one]]]]
//
// Sizes are halved from the largest on. Other programs are TetGen, Gmsh and Netgen, as far as they are there.

#include "Poisson_problem.h"
#include "Tetrahedral_mesh.h"
#include "methods/Averaging.h"
#include "methods/Global_search_method.h"
#include "methods/Quasi_newton.h"
#include "paper_record.h"
#include "peer_meshers.h"
#include "random_points.h"

#include <CGAL/Annealing_schedules_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <vector>

using namespace CGAL::Global_odt_mesh_3::internal;

static const double half_pi = 1.5707963267948966;

static std::array<Poisson_problem, 2> problems()
{
  typedef Eigen::Vector3d Vector;
  const Poisson_problem paper = { "xyz", [](const Vector& p) { return p.prod(); },
                                  [](const Vector& p) { return Vector(p[1] * p[2], p[2] * p[0], p[0] * p[1]); },
                                  [](const Vector&) { return 0.; } };
  const auto wave = [](const Vector& p) { return (half_pi * p).array().cos().prod(); };
  const Poisson_problem cosines = { "cosines", wave, [](const Vector& p)
  {
    const Vector c = (half_pi * p).array().cos(), s = (half_pi * p).array().sin();
    return Vector(-half_pi * s[0] * c[1] * c[2], -half_pi * c[0] * s[1] * c[2], -half_pi * c[0] * c[1] * s[2]);
  }, [wave](const Vector& p) { return 3 * half_pi * half_pi * wave(p); } };
  return {{ paper, cosines }};
}

// The mean over seeds of what one method gives at one size.
struct Mean_errors
{
  double vertices = 0, boundary_vertices = 0, radius_ratio = 0;
  std::array<double, 2> l2 = {{ 0, 0 }}, h1 = {{ 0, 0 }}, iterations = {{ 0, 0 }};
  int number = 0;

  void add(const Tetrahedral_mesh& mesh)
  {
    const auto insert = [this](double& mean, double x) { mean += (x - mean) / number; };
    ++number;
    insert(vertices, double(mesh.points.size()));
    insert(boundary_vertices, double(mesh.number_of_boundary_vertices()));
    insert(radius_ratio, mesh.mean_radius_ratio());
    const std::array<Poisson_problem, 2> all = problems();
    for(std::size_t n = 0; n < all.size(); ++n)
    {
      const Finite_element_errors e = solve(all[n], mesh);
      insert(l2[n], e.l2);
      insert(h1[n], e.h1);
      insert(iterations[n], e.iterations);
    }
  }
};

// Errors[method], from the largest size to the smallest.
typedef std::map<std::string, std::vector<Mean_errors> > Errors;

// What a method, made with these arguments, makes of the cube.
template <class M, class... Arguments>
Tetrahedral_mesh run_on(const Moving_triangulation_3& cube, unsigned int seed, int iterations, const Arguments&... arguments)
{
  Moving_triangulation_3 mesh = cube;
  M method(arguments...);
  run(method, mesh, seed, iterations);
  return tetrahedral_mesh(mesh);
}

static const char *const ours = "ours", *const structured = "structured";

// All methods on one size, which is added to their errors.
static void measure(std::size_t vertices, unsigned int seeds, const std::string& directory, std::vector<std::string>& names,
                    Errors& errors)
{
  std::map<std::string, Mean_errors> all;
  const auto add = [&](const std::string& name, const Tetrahedral_mesh& mesh)
  {
    if(std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
    all[name].add(mesh);
  };
  add(structured, structured_mesh(static_cast<int>(std::lround(std::cbrt(double(vertices)))) - 1));
  for(unsigned int seed = 1; seed <= seeds; ++seed)
  {
    const Moving_triangulation_3 cube = random_cube(seed, vertices, Cube_surface::SHIFTED_ROWS);
    if(seed == 1)
    {
      std::vector<Peer_mesher> peers = peer_meshers(tetrahedral_mesh(cube), directory);
      peers.push_back(netgen_in_cube(directory));
      for(const Peer_mesher& peer : peers)
      {
        const Tetrahedral_mesh mesh = mesh_of_size(peer, vertices, 2 * std::cbrt(1.4 / double(vertices)));
        if(!mesh.cells.empty())
          add(peer.name, mesh);
      }
    }
    add("AVV", run_on<Averaging>(cube, seed, 499, Energy::ODT));
    add("L-BFGS", run_on<Quasi_newton>(cube, seed, 300, Energy::ODT));
    add("Algorithm 2", run_on<Global_search_method>(cube, seed, 100, Energy::ODT, CGAL::Metropolis_annealing_schedule()));
    add(ours, run_on<Global_search_method>(cube, seed, 100, Energy::ODT, CGAL::Momentum_annealing_schedule()));
  }
  for(const auto& a : all)
    errors[a.first].push_back(a.second);
  std::fprintf(stderr, "%zu vertices\n", vertices);
}

// The order in the length of edges between the largest and the smallest size.
static double order(const std::vector<Mean_errors>& e, const std::array<double, 2> Mean_errors::* what, int problem)
{
  return 3 * std::log((e.back().*what)[problem] / (e.front().*what)[problem]) / std::log(e.front().vertices / e.back().vertices);
}

// Times the power of the number of vertices that makes it independent of that: what other programs make has not exactly as many.
static double scaled(const Mean_errors& e, const std::array<double, 2> Mean_errors::* what, int problem)
{
  return (e.*what)[problem] * std::pow(e.vertices, what == &Mean_errors::l2 ? 2 / 3. : 1 / 3.);
}

static double mean_scaled(const std::vector<Mean_errors>& all, const std::array<double, 2> Mean_errors::* what, int problem)
{
  double sum = 0;
  for(const Mean_errors& e : all)
    sum += scaled(e, what, problem);
  return sum / double(all.size());
}

static void record_table(Paper_record& record, const std::vector<std::string>& names, const Errors& errors)
{
  for(const std::string& name : names)
  {
    const std::vector<Mean_errors>& e = errors.at(name);
    const Mean_errors& largest = e.front();
    record.rows("Table 1", name + ", largest mesh",
                { { "vertices", "-", text("%.0f", largest.vertices) }, { "vertices on the boundary", "-", text("%.0f", largest.boundary_vertices) },
                  { "mean 3r/R", "-", text("%.4f", largest.radius_ratio) } });
    for(int n = 0; n < 2; ++n)
    {
      const std::string of = name + ", " + problems()[n].name;
      record.rows("Table 1", of, { { "L2 error times N^(2/3)", "-", text("%.2f", mean_scaled(e, &Mean_errors::l2, n)) },
                                   { "H1 error times N^(1/3)", "-", text("%.2f", mean_scaled(e, &Mean_errors::h1, n)) },
                                   { "L2 error on the largest mesh", "-", text("%.2e", largest.l2[n]) },
                                   { "H1 error on the largest mesh", "-", text("%.2e", largest.h1[n]) },
                                   { "iterations of conjugate gradients there", "-", text("%.0f", largest.iterations[n]) } });
      if(e.size() > 1)
        record.rows("Table 1", of, { { "order in L2", "-", text("%.2f", order(e, &Mean_errors::l2, n)) },
                                     { "order in H1", "-", text("%.2f", order(e, &Mean_errors::h1, n)) } });
    }
  }
  for(const char* peer : { "TetGen", "Gmsh, Delaunay", "Gmsh, HXT", "Netgen" })
    if(errors.count(peer) == 0)
      record.row("Table 1", peer, "-", "the program is not there, or failed");
  for(int n = 0; n < 2; ++n)
    for(const auto what : { &Mean_errors::l2, &Mean_errors::h1 })
    {
      const std::string norm = problems()[n].name + (what == &Mean_errors::l2 ? ", L2" : ", H1");
      const double error = mean_scaled(errors.at(ours), what, n);
      const bool is_close = std::all_of(names.begin(), names.end(), [&](const std::string& name)
                                        { return mean_scaled(errors.at(name), what, n) > 0.99 * error; });
      record.claim("Table 1", is_close, norm + ": no method is below the default call by more than 1 %");
    }
}

static void draw_table(const Paper_record& record, const std::vector<std::string>& names, const Errors& errors)
{
  std::ofstream out = record.data("table_1");
  std::string commands = "set logscale xy\nset xrange [400:20000]\nunset key\nset xlabel 'vertices'\nset multiplot layout 1,2\n";
  // Both have the same key, for which there is room in the second.
  for(int n = 0; n < 2; ++n)
    commands += std::string(n == 0 ? "" : "set key left bottom\n") + "set title 'L2 error, " + problems()[n].name + "'\n"
                + Paper_record::plot(text("1:%d", 2 + n), names, "linespoints");
  for(const std::string& name : names)
  {
    for(const Mean_errors& e : errors.at(name))
      out << e.vertices << ' ' << e.l2[0] << ' ' << e.l2[1] << '\n';
    out << "\n\n";
  }
  out.close();
  record.draw("table_1", commands + "unset multiplot\n", 1200, 600);
}

int main(int argc, char* argv[])
{
  const int sizes = argc > 1 ? std::atoi(argv[1]) : 5;
  const unsigned int seeds = argc > 2 ? std::atoi(argv[2]) : 3;
  const double most_vertices = argc > 3 ? std::atof(argv[3]) : 10000;
  const std::string directory = argc > 4 ? argv[4] : ".";
  Paper_record record(argc > 4 ? directory : "");
  std::vector<std::string> names;
  Errors errors;
  for(int n = 0; n < sizes; ++n)
    measure(static_cast<std::size_t>(most_vertices / std::pow(2., n)), seeds, directory, names, errors);
  record_table(record, names, errors);
  if(record.has_directory())
    draw_table(record, names, errors);
  return record.result();
}
