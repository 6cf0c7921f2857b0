// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The default call, with domains that are safe for threads, on meshes of growing size that are made for them, as tables in Markdown,
// each call in a process of its own.
//
//   scale threads|stages directory [most vertices, default 100000]
//
// "threads" compares one thread with two, and both with CGAL's own optimizer on the same mesh, on meshes of up to so many vertices:
// wall-clock and CPU time, the part of it that is outside of loops which threads share, memory beside the mesh, and quality. All
// coordinates of ours have to be the same on one and two threads, or the program fails. "stages" says how many microseconds a vertex each stage
// takes on one thread. Meshes are kept in the directory from run to run. Environment: CGAL_DATA_DIR, the directory of CGAL's data.

#include "Markdown_table.h"
#include "benchmark_inputs.h"
#include "cpu_seconds.h"
#include "measured_call.h"
#include "odt_of_mesh_3.h"

#include <CGAL/IO/File_binary_mesh_3.h>
#include <CGAL/Real_timer.h>
#include <CGAL/odt_optimize_mesh_3.h>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

#include <boost/functional/hash.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace inputs;
namespace odt = CGAL::Global_odt_mesh_3::internal;

#ifdef CGAL_LINKED_WITH_TBB
typedef CGAL::Parallel_tag Concurrency_tag;
#else
typedef CGAL::Sequential_tag Concurrency_tag;
#endif

// The peak of the memory that the process has, in bytes, since the last call of forget_peak(), as Linux counts it.
static double peak_memory()
{
  std::ifstream status("/proc/self/status");
  for(std::string word; status >> word; )
    if(word == "VmHWM:" && status >> word)
      return 1024 * std::atof(word.c_str());
  return 0;
}

static void forget_peak() { std::ofstream("/proc/self/clear_refs") << 5; }

template <class C3t3>
std::size_t hash_of_coordinates(const C3t3& c3t3)
{
  std::size_t hash = 0;
  const typename C3t3::Triangulation& tr = c3t3.triangulation();
  for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
  {
    const Point_3& p = tr.point(v).point();
    for(double x : { p.x(), p.y(), p.z() })
      boost::hash_combine(hash, x);
  }
  return hash;
}

// The mesh as one for threads, which all runs share: CGAL's mesher makes another one each time that it uses threads.
template <class C3t3, class Make>
void load(C3t3& c3t3, const std::string& file, const Make& make)
{
  std::ifstream kept(file, std::ios::binary);
  if(!file.empty() && CGAL::IO::load_binary_file(kept, c3t3))
    return;
  std::stringstream stream;
  CGAL::IO::save_binary_file(stream, make());
  if(!file.empty())
    std::ofstream(file, std::ios::binary) << stream.str();
  if(!CGAL::IO::load_binary_file(stream, c3t3))
    throw std::runtime_error("the mesh cannot be loaded");
}

// Of a call.
struct Scaled_run
{
  Measured_mesh mesh;
  std::array<double, odt::Stage_clock::NUMBER_OF_STAGES> stages{};      // wall-clock seconds
  double memory = 0;                                                    // beside the mesh, bytes a vertex
  std::size_t hash = 0;
};

template <class C3t3, class Domain>
void run_ours(C3t3& c3t3, const Domain& domain, Scaled_run& run)
{
  typedef CGAL::Mesh_3::Null_global_optimizer_visitor<C3t3> Visitor;
  Visitor visitor;
  odt::Odt_parameters parameters;
  parameters.domain_is_thread_safe = true;
  odt::Odt_mesh_optimizer_3<C3t3, Domain, Visitor> optimizer(c3t3, domain, odt::Odt_task::OPTIMIZE, parameters, visitor);
  optimizer();
  for(int n = 0; n < odt::Stage_clock::NUMBER_OF_STAGES; ++n)
    run.stages[static_cast<std::size_t>(n)] = optimizer.clock().seconds(n);
}

template <class C3t3, class Domain>
Scaled_run run(C3t3& c3t3, const Domain& domain, bool is_ours)
{
  Scaled_run run;
  forget_peak();
  const double memory = peak_memory();
  CGAL::Real_timer timer;
  timer.start();
  const double cpu = seconds([&] { is_ours ? run_ours(c3t3, domain, run) : odt_of_mesh_3(c3t3, domain); });
  timer.stop();
  const double peak = peak_memory();
  run.mesh = measured(c3t3);
  run.mesh.cpu = cpu;
  run.mesh.wall = timer.time();
  run.memory = (peak - memory) / run.mesh.vertices;
  run.hash = hash_of_coordinates(c3t3);
  return run;
}

// From the sizes of the meshes of 18,000 vertices.
static Scaled_run run(const std::string& name, int vertices, int threads, bool is_ours, const std::string& directory)
{
#ifdef CGAL_LINKED_WITH_TBB
  tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
#endif
  const double finer = std::cbrt(vertices / 18000.);
  const std::string file = directory + "/" + name + "_" + std::to_string(vertices) + ".binary";
  if(name == "elephant")
  {
    typedef CGAL::Mesh_triangulation_3<Polyhedral_domain, CGAL::Default, Concurrency_tag>::type Triangulation;
    typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Polyhedral_domain::Corner_index,
                                                    Polyhedral_domain::Curve_index> C3t3;
    const Polyhedron elephant = read_polyhedron(CGAL::data_file_path("meshes/elephant.off"));
    const Polyhedral_domain domain(elephant);
    C3t3 c3t3;
    load(c3t3, file, [&] { return polyhedral_mesh(domain, 0.0102 / finer, false, 1 / 6.); });
    return run(c3t3, domain, is_ours);
  }
  typedef CGAL::Mesh_triangulation_3<Labeled_domain, CGAL::Default, Concurrency_tag>::type Triangulation;
  typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> C3t3;
  const Labeled_domain domain = sphere_domain();
  C3t3 c3t3;
  load(c3t3, file, [&] { return name == "graded sphere" ? graded_sphere(domain, 0.0378 / finer) : sphere(domain, 0.0572 / finer); });
  return run(c3t3, domain, is_ours);
}

// A process must not have used threads before it is divided.
static Scaled_run run_alone(const std::string& name, int vertices, int threads, bool is_ours, const std::string& directory)
{
  const Scaled_run result = in_process_of_its_own<Scaled_run>([&] { return run(name, vertices, threads, is_ours, directory); });
  if(result.mesh.vertices == 0)
    throw std::runtime_error("a call has failed");
  return result;
}

// The sizes of meshes, more or less.
static const std::array<int, 4> sizes = {{ 18000, 100000, 300000, 1000000 }};

static std::string thousands(double vertices) { return ", " + std::to_string(std::lround(vertices / 1000)) + ",000 vertices"; }

static Markdown_table compare_threads(const std::string& directory, int most)
{
  Markdown_table table({ "mesh", "method" },
                       { { "mean 3r/R", 4, Better::HIGH }, { "smallest dihedral angle (degrees)", 1, Better::HIGH },
                         { "CPU time (s)", 1, Better::LOW }, { "wall time on one thread (s)", 1, Better::LOW },
                         { "on two threads (s)", 1, Better::LOW },
                         { "memory beside the mesh (kB a vertex)", 1, Better::NEITHER } });
  for(const char* name : { "sphere", "elephant", "graded sphere" })
    for(int vertices : sizes)
    {
      // Others than the sphere are slow to be made.
      if(vertices > most || (vertices > 100000 && name != std::string("sphere")))
        break;
      for(bool is_ours : { false, true })
      {
        // On the largest, CGAL's takes a quarter of an hour.
        if(!is_ours && vertices > 300000)
          continue;
        const Scaled_run one = run_alone(name, vertices, 1, is_ours, directory), two = run_alone(name, vertices, 2, is_ours, directory);
        if(is_ours && one.hash != two.hash)
          throw std::runtime_error("two threads lead to other coordinates than one");
        const Measured_mesh& m = one.mesh;
        table.add({ name + thousands(m.vertices), is_ours ? "this package" : "CGAL's odt" },
                  { m.radius_ratio, m.smallest_angle, m.cpu, m.wall, two.mesh.wall, two.memory / 1000 });
      }
    }
  return table;
}

static Markdown_table list_stages(const std::string& directory, int most)
{
  std::vector<Scaled_run> runs;
  std::vector<Column> columns;
  for(int vertices : sizes)
    if(vertices <= most)
    {
      runs.push_back(run_alone("sphere", vertices, 1, true, directory));
      columns.push_back({ "sphere" + thousands(runs.back().mesh.vertices) + " (microseconds a vertex)", 1, Better::NEITHER });
    }
  columns.push_back({ "ten million vertices, extrapolated (minutes)", 1, Better::NEITHER });
  Markdown_table table({ "stage" }, columns);
  const auto add = [&](const std::string& stage, const auto& seconds)
  {
    std::vector<double> values;
    for(const Scaled_run& r : runs)
      values.push_back(1e6 * seconds(r) / r.mesh.vertices);
    values.push_back(values.back() * 10 / 60);
    table.add({ stage }, values);
  };
  for(std::size_t n = 0; n < odt::Stage_clock::NUMBER_OF_STAGES; ++n)
    add(odt::Stage_clock::name(static_cast<int>(n)), [n](const Scaled_run& r) { return r.stages[n]; });
  add("all", [](const Scaled_run& r) { return r.mesh.wall; });
  return table;
}

int main(int argc, char* argv[])
{
  const std::string what = argc > 2 ? argv[1] : "";
  if(what != "threads" && what != "stages")
  {
    std::cerr << "usage: " << argv[0] << " threads|stages directory [most vertices, default 100000]" << std::endl;
    return EXIT_FAILURE;
  }
  const int most = argc > 3 ? std::atoi(argv[3]) : 100000;
  std::cout << (what == "threads" ? compare_threads : list_stages)(argv[2], most);
  return EXIT_SUCCESS;
}
