// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What it gives to move vertices on surfaces, and in which way, beside CGAL's own optimizer, on the
// same meshes in one run, in process CPU time, as a table in Markdown:
//   - the boundary fixed,
//   - the boundary remeshed by restricted CVT, then the interior with the boundary fixed
//     (the way of the paper, section 5.1),
//   - some remeshing, then all vertices together,
//   - the same after the boundary has been remeshed to the end,
//   - the same with rounds of global search.
// Slivers are not removed. Facets farther from the surface than in the input are those whose circumcenter is farther from the surface than
// that of any facet of the input.
//
//   move_boundary [rounds of search, default 10] [name of an input]
//
// Environment: CGAL_DATA_DIR, the directory of CGAL's data.

#include "Markdown_table.h"
#include "benchmark_inputs.h"
#include "cpu_seconds.h"
#include "odt_of_mesh_3.h"

#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/number_utils.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/squared_distance_3.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using namespace inputs;
namespace odt = CGAL::Global_odt_mesh_3::internal;

struct Cost
{
  double seconds = 0;
  std::size_t questions = 0, projections = 0, surface_vertices = 0;
};

// Counts what the domain is asked.
template <class Domain>
class Counting_view
  : public odt::Mesh_domain_view_3<Domain>
{
  typedef odt::Mesh_domain_view_3<Domain> Base;

public:
  typedef typename Base::Vector Vector;

  Counting_view(const Domain& domain, Cost& cost) : Base(domain), cost_(cost) {}

  int label(const Vector& p) const override
  {
    ++cost_.questions;
    return Base::label(p);
  }

protected:
  bool find_intersection(const Vector& from, const Vector& to, Vector& p, int& patch) const override
  {
    ++cost_.questions;
    return Base::find_intersection(from, to, p, patch);
  }

  Vector closest_point(const Vector& p, int& patch) const override
  {
    ++cost_.projections;
    return Base::closest_point(p, patch);
  }

private:
  Cost& cost_;
};

template <class C3t3, class Domain>
void run(C3t3& c3t3, const Domain& domain, const odt::Odt_parameters& parameters, Cost& cost,
         odt::Odt_task task = odt::Odt_task::OPTIMIZE)
{
  Counting_view<Domain> view(domain, cost);
  odt::C3t3_view_3<C3t3, Domain> mesh(c3t3, view);
  odt::Optimization_visitor visitor;
  cost.seconds += seconds([&] { optimize_mesh(mesh, view, task, parameters, odt::User_field_3(), visitor, odt::Thread_policy()); });
  const auto& tr = c3t3.triangulation();
  cost.surface_vertices = std::count_if(tr.finite_vertices_begin(), tr.finite_vertices_end(),
                                        [](const auto& v) { return v.in_dimension() == 2; });
}

// The squares of the distances that the criterion `facet_distance` bounds: of circumcenters from the surface.
template <class C3t3>
std::vector<double> squared_facet_distances(const C3t3& c3t3)
{
  const auto& tr = c3t3.triangulation();
  const auto circumcenter = tr.geom_traits().construct_weighted_circumcenter_3_object();
  std::vector<double> distances;
  for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
  {
    const auto point = [&](int i) { return tr.point(f->first, (f->second + i) & 3); };
    distances.push_back(CGAL::to_double(CGAL::squared_distance(circumcenter(point(1), point(2), point(3)),
                                                               f->first->get_facet_surface_center(f->second))));
  }
  return distances;
}

template <class C3t3, class Domain>
void compare(const char* name, const C3t3& input, const Domain& domain, int search_rounds, Markdown_table& table)
{
  const double volume = CGAL::mesh_quality_report_3(input).total().volume;
  const std::vector<double> before = squared_facet_distances(input);
  const double farthest = *std::max_element(before.begin(), before.end());
  const auto add = [&](const std::string& what, const C3t3& c3t3, const Cost& cost, bool is_compared = true)
  {
    const CGAL::Mesh_quality_report_3 r = CGAL::mesh_quality_report_3(c3t3);
    const double vertices = double(cost.surface_vertices), none = Markdown_table::none;
    const std::vector<double> distances = squared_facet_distances(c3t3);
    const auto beyond = std::count_if(distances.begin(), distances.end(), [=](double d) { return d > farthest; });
    table.add({ name, what }, { r.mean_radius_ratio, r.mean_facet_angle, 100 * (r.total().volume / volume - 1),
                                100 * double(beyond) / double(distances.size()),
                                vertices > 0 ? double(cost.questions) / vertices : none,
                                vertices > 0 ? double(cost.projections) / vertices : none, is_compared ? cost.seconds : none },
              is_compared);
  };
  add("input", input, Cost(), false);
  {
    C3t3 c3t3(input);
    Cost cost;
    cost.seconds = seconds([&] { odt_of_mesh_3(c3t3, domain); });
    add("CGAL's odt", c3t3, cost);
  }
  odt::Odt_parameters together;
  together.number_of_rounds = 0;
  together.do_remove_slivers = false;
  odt::Odt_parameters fixed = together, searching = together;
  fixed.optimize_boundary = false;
  searching.number_of_rounds = search_rounds;
  // Goes on from `c3t3`, at that cost, and adds the result.
  const auto measure = [&](const std::string& what, C3t3 c3t3, const odt::Odt_parameters& parameters, Cost cost = Cost())
  {
    run(c3t3, domain, parameters, cost);
    add(what, c3t3, cost);
  };
  measure("boundary fixed", input, fixed);
  {
    C3t3 remeshed(input);
    Cost cost;
    run(remeshed, domain, together, cost, odt::Odt_task::REMESH_BOUNDARY);
    measure("remeshed, then fixed", remeshed, fixed, cost);
    measure("remeshed, then together", remeshed, together, cost);
  }
  measure("together", input, together);
  measure("together, " + std::to_string(search_rounds) + " rounds of search", input, searching);
}

int main(int argc, char* argv[])
{
  const int search_rounds = argc > 1 ? std::atoi(argv[1]) : 10;
  Markdown_table table({ "mesh", "boundary" },
                       { { "mean 3r/R", 4, Better::HIGH }, { "mean of the smallest angles of facets (degrees)", 1, Better::HIGH },
                         { "change of volume (%)", 2, Better::NEITHER },
                         { "facets farther from the surface than in the input (%)", 1, Better::LOW }, { "domain queries a surface vertex", 1, Better::NEITHER },
                         { "closest points a surface vertex", 1, Better::NEITHER }, { "CPU time (s)", 1, Better::LOW } });
  for_each_input([&](const char* name, const auto& input, const auto& domain) { compare(name, input, domain, search_rounds, table); },
                 argc > 2 ? argv[2] : "");
  std::cout << table;
  return EXIT_SUCCESS;
}
