// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A command that improves the tetrahedra in a file of Medit, which Gmsh, Netgen, and many other programs write. There is no
// domain but the mesh itself. What it can be told is in optimize_mesh_options.h.
//
//   optimize_mesh in.mesh out.mesh --insert --sliver-bound 20

#include "complex_of_medit_mesh.h"
#include "medit_mesh.h"
#include "optimize_mesh_options.h"
#include "print_summary.h"
#include "terminal_progress.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/output_to_vtu.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_optimization_report_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Tetrahedral_mesh_domain_3.h>
#include <CGAL/exceptions.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/property_map.h>
#include <CGAL/remove_slivers_mesh_3.h>

#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;

// All indices are numbers. A triangulation takes no more than that from a domain.
struct Indices
{
  typedef K R;
  typedef int Subdomain_index;
  typedef int Surface_patch_index;
  typedef int Curve_index;
  typedef int Corner_index;
  typedef int Index;
  typedef CGAL::Tag_true Has_features;
};

typedef CGAL::Mesh_triangulation_3<Indices>::type Tr;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Tr> C3t3;
typedef CGAL::Tetrahedral_mesh_domain_3<C3t3> Domain;
typedef CGAL::Mesh_optimization_report_3<C3t3> Report;
namespace params = CGAL::parameters;

enum Exit_status { IMPROVED, UNCHANGED, NOT_GOOD };

// Tells the complex of the vertices that go.
struct Removal_visitor
{
  Complex_of_medit_mesh<C3t3>& complex;

  void before_vertex_removal(Tr::Vertex_handle v) { complex.before_vertex_removal(v); }
  void after_compute_moves() {}
  void after_move_points() {}
  void after_rebuild_restricted_delaunay() {}
  void end_of_iteration(int) {}
};

inline void optimize(C3t3& c3t3, Complex_of_medit_mesh<C3t3>& complex, const Optimize_mesh_options& options, Report& report)
{
  const Domain domain(c3t3);
  std::set<Tr::Vertex_handle> required = complex.required_vertices();
  const CGAL::Boolean_property_map<std::set<Tr::Vertex_handle> > is_required(required);
  std::set<Tr::Facet> facets = complex.required_facets();
  const CGAL::Boolean_property_map<std::set<Tr::Facet> > is_required_facet(facets);
  Removal_visitor visitor = { complex };
  Terminal_progress progress;
  progress.is_terminal = progress.is_terminal && !options.is_quiet;
  const auto call = [&](const auto&... more)
  {
    CGAL::odt_optimize_mesh_3(c3t3, domain, params::time_limit = options.time_limit,
                              params::sliver_bound = options.sliver_bound,
                              params::optimize_boundary = !options.fixes_boundary,
                              params::facet_distance = options.facet_distance,
                              params::do_insert_vertices = options.do_insert, params::do_remove_vertices = options.do_remove,
                              params::domain_is_thread_safe = true, params::random_seed(options.seed),
                              params::vertex_is_constrained_map(is_required),
                              params::facet_is_constrained_map(is_required_facet), params::callback(std::ref(progress)),
                              params::visitor(std::ref(visitor)), params::optimization_report = std::ref(report), more...);
  };
  if(options.only_slivers)
    CGAL::remove_slivers_mesh_3(c3t3, domain, params::time_limit = options.time_limit,
                                params::sliver_bound = options.sliver_bound,
                                params::optimize_boundary = !options.fixes_boundary,
                                params::facet_distance = options.facet_distance,
                                params::domain_is_thread_safe = true, params::random_seed(options.seed),
                                params::vertex_is_constrained_map(is_required),
                                params::facet_is_constrained_map(is_required_facet), params::callback(std::ref(progress)),
                                params::optimization_report = std::ref(report));
  else if(options.number_of_vertices > 0 && options.size > 0)
    call(params::number_of_vertices = options.number_of_vertices, params::sizing_field = options.size);
  else if(options.number_of_vertices > 0)
    call(params::number_of_vertices = options.number_of_vertices);
  else if(options.size > 0)
    call(params::sizing_field = options.size);
  else
    call();
  progress(1);
}

inline void write(const Complex_of_medit_mesh<C3t3>& complex, const C3t3& c3t3, const std::string& name)
{
  std::ofstream out(name, std::ios::binary);
  if(name.size() > 4 && name.compare(name.size() - 4, 4, ".vtu") == 0)
    CGAL::IO::output_to_vtu(out, c3t3);
  else
    Medit_writer{ out }(complex.to_medit());
  if(!out.flush())
    throw std::runtime_error("cannot be written");
}

// The first line of the report, and what may help.
inline void print_reason(const Report& report, const Optimize_mesh_options& options)
{
  std::ostringstream s;
  s << report;
  std::cerr << s.str().substr(0, s.str().find('\n'));
  const bool may_split = !options.do_insert && !options.fixes_boundary;
  std::cerr << (report.reason == Report::NO_VALID_MESH && may_split ? "; --insert splits edges that are in the way\n" : "\n");
}

inline Exit_status run(const Optimize_mesh_options& options)
{
  std::string file = options.in;
  try
  {
    std::ifstream in(file, std::ios::binary);
    if(!in)
      throw std::runtime_error("cannot be opened");
    Medit_mesh mesh = Medit_reader(in)();
    if(options.ignores_edges)
      mesh.clear_edges();
    C3t3 c3t3;
    Complex_of_medit_mesh<C3t3> complex(mesh, c3t3, options.feature_angle);
    if(!options.is_quiet && complex.number_of_lost_triangles() + complex.number_of_lost_edges() > 0)
      std::cerr << "warning: " << complex.number_of_lost_triangles() << " triangles and " << complex.number_of_lost_edges()
                << " edges divide nothing, or are in no tetrahedron, and are left out\n";
    const CGAL::Mesh_quality_report_3 before = CGAL::mesh_quality_report_3(c3t3, { 10, 20, 30 });
    CGAL::Real_timer timer;
    timer.start();
    Report report;
    optimize(c3t3, complex, options, report);
    timer.stop();
    file = options.out;
    write(complex, c3t3, file);
    if(!options.is_quiet)
      print_summary(before, CGAL::mesh_quality_report_3(c3t3, { 10, 20, 30 }), report, timer.time());
    if(report.is_changed())
      return IMPROVED;
    print_reason(report, options);
    return UNCHANGED;
  }
  catch(const CGAL::Failure_exception& e)
  {
    std::cerr << file << ": " << e.message() << '\n';
  }
  catch(const std::exception& e)
  {
    std::cerr << file << ": " << e.what() << '\n';
  }
  return NOT_GOOD;
}

int main(int argc, char* argv[])
{
  try
  {
    const Optimize_mesh_options options(std::vector<std::string>(argv + 1, argv + argc));
    if(!options.wants_help)
      return run(options);
    std::cout << Optimize_mesh_options::help;
    return IMPROVED;
  }
  catch(const std::exception& e)
  {
    std::cerr << "optimize_mesh: " << e.what() << '\n';
    return NOT_GOOD;
  }
}
