// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The default call, with domains that are safe for threads, on meshes of growing size that are made for them: wall-clock
// and CPU time for each vertex, the share of each stage and how much of it is in loops that threads share, memory beside
// the mesh, quality, and a hash of all coordinates, which must not depend on the number of threads.
//
//   scale sphere|elephant|graded [vertices, about; default 18000] [threads, default 1] [what, default ours]
//         [directory where meshes are kept from run to run]
//
// `what` is "ours" or "cgal", which is CGAL's own optimizer on the same mesh with the same number of threads.
// Environment: CGAL_DATA_DIR, the directory of CGAL's data.

#include "benchmark_inputs.h"
#include "cpu_seconds.h"
#include "odt_of_mesh_3.h"

#include <CGAL/IO/File_binary_mesh_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Real_timer.h>
#include <CGAL/odt_optimize_mesh_3.h>

#ifdef CGAL_LINKED_WITH_TBB
#  include <tbb/global_control.h>
#endif

#include <boost/functional/hash.hpp>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

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

static void print_stages(const odt::Stage_clock& clock)
{
  odt::Stage_clock::Seconds total;
  for(int n = 0; n < odt::Stage_clock::NUMBER_OF_STAGES; ++n)
  {
    total.all += clock.seconds(n).all;
    total.in_loops += clock.seconds(n).in_loops;
  }
  const auto print = [&total](const char* name, const odt::Stage_clock::Seconds& s)
  {
    std::printf("  %-16s %8.2f s %5.1f %%   outside of loops for threads %8.2f s %5.1f %%\n", name, s.all,
                100 * s.all / total.all, s.all - s.in_loops, 100 * (s.all - s.in_loops) / total.all);
  };
  for(int n = 0; n < odt::Stage_clock::NUMBER_OF_STAGES; ++n)
    print(odt::Stage_clock::name(n), clock.seconds(n));
  print("all", total);
}

template <class C3t3, class Domain>
void run_ours(C3t3& c3t3, const Domain& domain)
{
  typedef CGAL::Mesh_3::Null_global_optimizer_visitor<C3t3> Visitor;
  Visitor visitor;
  odt::Odt_parameters parameters;
  parameters.domain_is_thread_safe = true;
  odt::Odt_mesh_optimizer_3<C3t3, Domain, Visitor> optimizer(c3t3, domain, odt::Odt_task::OPTIMIZE, parameters, visitor);
  optimizer();
  print_stages(optimizer.clock());
}

template <class C3t3, class Domain>
void measure(C3t3& c3t3, const Domain& domain, const std::string& what)
{
  const std::size_t vertices = c3t3.triangulation().number_of_vertices();
  std::printf("%zu vertices, %zu cells\n", vertices, std::size_t(c3t3.number_of_cells_in_complex()));
  forget_peak();
  const double memory = peak_memory();
  CGAL::Real_timer timer;
  timer.start();
  const double cpu = seconds([&] { what == "cgal" ? odt_of_mesh_3(c3t3, domain) : run_ours(c3t3, domain); });
  timer.stop();
  const double peak = peak_memory();
  const CGAL::Mesh_quality_report_3 q = CGAL::mesh_quality_report_3(c3t3, { 10, 20, 30, 40 });
  std::printf("  wall %.2f s, CPU %.2f s, %.1f microseconds a vertex; memory beside the mesh %.2f kB a vertex\n", timer.time(),
              cpu, 1e6 * cpu / vertices, (peak - memory) / 1000 / vertices);
  std::printf("  angles %.2f - %.2f, mean 3r/R %.4f, cells below 20, 30, 40: %zu %zu %zu\n", q.smallest_angle, q.largest_angle,
              q.mean_radius_ratio, q.cells_below[1].second, q.cells_below[2].second, q.cells_below[3].second);
  std::printf("  hash %016zx\n", hash_of_coordinates(c3t3));
}

int main(int argc, char* argv[])
{
  const std::string name = argc > 1 ? argv[1] : "sphere";
  const double vertices = argc > 2 ? std::atof(argv[2]) : 18000;
  const int threads = argc > 3 ? std::atoi(argv[3]) : 1;
  const std::string what = argc > 4 ? argv[4] : "ours";
  const std::string file = argc > 5 ? std::string(argv[5]) + "/" + name + "_" + std::to_string(int(vertices)) + ".binary" : "";
#ifdef CGAL_LINKED_WITH_TBB
  tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
#endif
  std::printf("%s, %d threads, %s\n", name.c_str(), threads, what.c_str());
  // From the sizes of the meshes of 18,000 vertices.
  const double finer = std::cbrt(vertices / 18000);
  if(name == "elephant")
  {
    typedef CGAL::Mesh_triangulation_3<Polyhedral_domain, CGAL::Default, Concurrency_tag>::type Triangulation;
    typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Polyhedral_domain::Corner_index,
                                                    Polyhedral_domain::Curve_index> C3t3;
    const Polyhedron elephant = read_polyhedron(CGAL::data_file_path("meshes/elephant.off"));
    const Polyhedral_domain domain(elephant);
    C3t3 c3t3;
    load(c3t3, file, [&] { return polyhedral_mesh(domain, 0.0102 / finer, false, 1 / 6.); });
    measure(c3t3, domain, what);
  }
  else
  {
    typedef CGAL::Mesh_triangulation_3<Labeled_domain, CGAL::Default, Concurrency_tag>::type Triangulation;
    typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> C3t3;
    const Labeled_domain domain = sphere_domain();
    C3t3 c3t3;
    load(c3t3, file, [&] { return name == "graded" ? graded_sphere(domain, 0.0378 / finer) : sphere(domain, 0.0572 / finer); });
    measure(c3t3, domain, what);
  }
  return EXIT_SUCCESS;
}
