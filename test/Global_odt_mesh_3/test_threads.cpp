// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// A mesh that is made for threads: the result does not depend on how many there are, and what the user gives is
// called from one only. What it throws comes out, and leaves the mesh.

#include "check.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/tags.h>

#include <tbb/global_control.h>

#include <cstddef>
#include <iostream>
#include <stdexcept>
#include <thread>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Labeled_mesh_domain_3<Kernel> Domain;
typedef CGAL::Mesh_triangulation_3<Domain, CGAL::Default, CGAL::Parallel_tag>::type Triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> C3t3;
typedef CGAL::Mesh_criteria_3<Triangulation> Criteria;
namespace params = CGAL::parameters;

static double squared(const Point_3& p) { return (p - CGAL::ORIGIN).squared_length(); }

static std::vector<double> coordinates(const C3t3& c3t3)
{
  std::vector<double> c;
  const Triangulation& tr = c3t3.triangulation();
  for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
  {
    const Point_3& p = tr.point(v).point();
    c.insert(c.end(), { p.x(), p.y(), p.z() });
  }
  return c;
}

// The thread that may call, and whether another one does.
struct Caller
{
  std::thread::id thread = std::this_thread::get_id();
  bool is_other = false;

  void check() { is_other = is_other || std::this_thread::get_id() != thread; }
};

// A graded density.
struct Density
{
  typedef Kernel::FT FT;
  Caller* caller;
  long* calls_left;

  FT operator()(const Point_3& p) const
  {
    caller->check();
    if(--*calls_left < 0)
      throw std::runtime_error("the density fails");
    return 1 + 20 * p.x() * p.x();
  }
};

static void same_for_all_threads(const C3t3& input, const Domain& domain)
{
  std::vector<double> expected;
  for(std::size_t threads : { 1, 2, 3, 8 })
  {
    tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    C3t3 c3t3 = input;
    CGAL::odt_optimize_mesh_3(c3t3, domain, params::number_of_rounds = 1);
    const std::vector<double> result = coordinates(c3t3);
    if(expected.empty())
      expected = result;
    check::that(result != coordinates(input), "nothing has moved");
    check::that(result == expected, threads, " threads lead elsewhere than one");
  }
}

static void users_are_called_from_one_thread(const C3t3& input, const Domain& domain, Caller& caller)
{
  tbb::global_control control(tbb::global_control::max_allowed_parallelism, 4);
  for(bool has_points_in_cells : { false, true })
  {
    C3t3 c3t3 = input;
    long calls = 1000000000;
    const Density density = { &caller, &calls };
    const auto optimize_with = [&](const auto& quadrature)
    {
      CGAL::odt_optimize_mesh_3(c3t3, domain, params::number_of_rounds = 0, params::density = density,
                                params::quadrature = quadrature, params::max_iteration_number = 20,
                                params::do_remove_slivers = false);
    };
    const auto optimize = [&]
    {
      has_points_in_cells ? optimize_with(CGAL::Four_point_rule_3()) : optimize_with(CGAL::Linear_density_rule_3());
    };
    optimize();
    check::that(!caller.is_other, "the density or the domain is called from another thread");
    // Again, so that it fails half way.
    const long needed = 1000000000 - calls;
    calls = needed / 2;
    c3t3 = input;
    const std::vector<double> before = coordinates(c3t3);
    bool has_thrown = false;
    try { optimize(); }
    catch(const std::runtime_error&) { has_thrown = true; }
    check::that(has_thrown, "the exception of the density is lost");
    check::that(coordinates(c3t3) == before && c3t3.is_valid(), "an exception has changed the mesh");
  }
}

int main()
{
  Caller caller;
  bool is_meshing = true;   // which is the business of CGAL's threads
  const auto label = [&](const Point_3& p)
  {
    if(!is_meshing)
      caller.check();
    return squared(p) < 1 ? 1 : 0;
  };
  const Domain domain(label, Kernel::Sphere_3(CGAL::ORIGIN, 4.));
  const Criteria criteria(params::facet_angle = 25, params::facet_size = 0.1, params::facet_distance = 0.01,
                          params::cell_radius_edge_ratio = 2, params::cell_size = 0.09);
  const C3t3 c3t3 = CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::no_exude());
  is_meshing = false;
  const std::size_t cells = c3t3.number_of_cells_in_complex();
  std::cout << cells << " cells" << std::endl;
  check::that(cells > 20000, "too few cells for several threads to have something to do");
  same_for_all_threads(c3t3, domain);
  users_are_called_from_one_thread(c3t3, domain, caller);
  return check::result();
}
