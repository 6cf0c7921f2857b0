// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The quality report against closed forms, and its independence of where the
// mesh is and how it is turned; for cells and for facets.

#include "check.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Mesh_triangulation_3.h>

#include <array>
#include <cmath>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Mesh_triangulation_3<CGAL::Labeled_mesh_domain_3<Kernel> >::type Triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Triangulation> C3t3;
typedef CGAL::Mesh_criteria_3<Triangulation> Criteria;

// The triangulation of the points, all cells in subdomain 1.
static C3t3 complex(const std::vector<Point_3>& points)
{
  C3t3 c3t3;
  for(const Point_3& p : points)
    c3t3.triangulation().insert(Triangulation::Weighted_point(p));
  for(auto c = c3t3.triangulation().finite_cells_begin(); c != c3t3.triangulation().finite_cells_end(); ++c)
    c3t3.add_to_complex(c, 1);
  return c3t3;
}

static void close_to(double a, double b, double tolerance, const char* what)
{
  check::that(std::abs(a - b) <= tolerance, what, ": ", a, ", not ", b);
}

// With all facets of the convex hull.
static C3t3 with_facets(const std::vector<Point_3>& points)
{
  C3t3 c3t3 = complex(points);
  const Triangulation& triangulation = c3t3.triangulation();
  for(auto f = triangulation.finite_facets_begin(); f != triangulation.finite_facets_end(); ++f)
    if(triangulation.is_infinite(f->first) || triangulation.is_infinite(f->first->neighbor(f->second)))
      c3t3.add_to_complex(*f, C3t3::Surface_patch_index(0, 1));
  return c3t3;
}

template <std::size_t number_of_bins>
static std::size_t sum(const std::array<std::size_t, number_of_bins>& bins)
{
  std::size_t n = 0;
  for(std::size_t b : bins)
    n += b;
  return n;
}

// Facets that are not equilateral are bad, and all cells.
struct Equilateral_criteria
{
  struct Cells
  {
    bool operator()(const C3t3::Triangulation&, C3t3::Cell_handle) const { return true; }
  };

  struct Facets
  {
    bool operator()(const C3t3::Triangulation& tr, const C3t3::Facet& f) const
    {
      const auto p = [&](int k) { return tr.point(f.first, (f.second + k) % 4).point(); };
      const double a = CGAL::squared_distance(p(1), p(2)), b = CGAL::squared_distance(p(2), p(3)), c = CGAL::squared_distance(p(3), p(1));
      return a != b || b != c;
    }
  };

  Cells cell_criteria_object() const { return Cells(); }
  Facets facet_criteria_object() const { return Facets(); }
};

// Indices that can only be compared for equality, as the concept asks, and such that print alike.
struct Index
{
  int n;
  bool operator==(const Index& o) const { return n == o.n; }
};

struct Tissue : Index {};

static std::ostream& operator<<(std::ostream& out, const Tissue&) { return out << "tissue"; }

template <class Subdomain>
struct Complex_with_indices : C3t3
{
  typedef Subdomain Subdomain_index;

  using C3t3::C3t3;

  Subdomain_index subdomain_index(Cell_handle c) const { return Subdomain{ { C3t3::subdomain_index(c) } }; }
};

struct Unprintable : Index {};

// The cells of a cube that is in three subdomains, the second with two cells.
template <class Subdomain>
static CGAL::Mesh_quality_report_3 report_of_three()
{
  Complex_with_indices<Subdomain> c3t3;
  for(int i = 0; i < 8; ++i)
    c3t3.triangulation().insert(Triangulation::Weighted_point(Point_3(i & 1, i >> 1 & 1, i >> 2 & 1)));
  int n = 0;
  for(auto c = c3t3.triangulation().finite_cells_begin(); c != c3t3.triangulation().finite_cells_end() && n < 4; ++c, ++n)
    c3t3.add_to_complex(c, 1 + (n + 1) / 2);
  return CGAL::mesh_quality_report_3(c3t3);
}

int main()
{
  const double degree = 180 / CGAL_PI;
  {
    const auto r = CGAL::mesh_quality_report_3(complex({ { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } }));
    const double angle = std::acos(1. / 3) * degree;
    close_to(r.smallest_angle, angle, 1e-10, "smallest angle of the regular tetrahedron");
    close_to(r.largest_angle, angle, 1e-10, "largest angle of the regular tetrahedron");
    close_to(r.mean_radius_ratio, 1, 1e-12, "radius ratio of the regular tetrahedron");
    close_to(r.total().volume, 8. / 3, 1e-12, "volume of the regular tetrahedron of edge sqrt(8)");
    close_to(r.total().energy, 8. / 3 * 48 / 20, 1e-12, "energy of the regular tetrahedron");
    check::that(r.angles[70] == 6 && sum(r.angles) == 6, "histogram of the regular tetrahedron");
    check::that(r.cells_below.back().second == 0, "the regular tetrahedron counts as bad");
  }
  const std::vector<Point_3> corner = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  {
    const auto r = CGAL::mesh_quality_report_3(complex(corner), { 50, 60 });
    close_to(r.largest_angle, 90, 1e-10, "largest angle of the cube's corner");
    close_to(r.smallest_angle, std::acos(1 / std::sqrt(3.)) * degree, 1e-10, "smallest angle of the cube's corner");
    // r = 1 / (3 + sqrt(3)), R = sqrt(3) / 2.
    close_to(r.mean_radius_ratio, 3 / (3 + std::sqrt(3.)) / (std::sqrt(3.) / 2), 1e-12, "radius ratio of the cube's corner");
    check::that(r.cells_below.size() == 2 && r.cells_below[0].second == 0 && r.cells_below[1].second == 1,
                "cells below 50 and 60 degrees");
  }
  {
    // The angles between the facets are 90 degrees three times, at the axes, and 54.7 at the other edges.
    const std::vector<double> bounds = { 50, 60, 95 };
    const auto closed = CGAL::mesh_quality_report_3(with_facets(corner), bounds);
    C3t3 c3t3 = complex(corner);
    const auto add = [&c3t3](const Point_3& opposite)
    {
      const auto c = c3t3.cells_in_complex_begin();
      for(int i = 0; i < 4; ++i)
        if(c->vertex(i)->point().point() == opposite)
          c3t3.add_to_complex(c, i, C3t3::Surface_patch_index(0, 1));
    };
    add(corner[1]);
    const auto one = CGAL::mesh_quality_report_3(c3t3, bounds);
    add(corner[2]);
    const auto two = CGAL::mesh_quality_report_3(c3t3, bounds);
    const auto numbers = [](const CGAL::Mesh_quality_report_3& r)
    {
      std::vector<std::size_t> result;
      for(const auto& b : r.cells_below_at_boundary)
        result.push_back(b.second);
      return result;
    };
    typedef std::vector<std::size_t> Numbers;
    check::that(numbers(closed) == Numbers{ 0, 1, 1 } && numbers(one) == Numbers{ 0, 0, 0 } && numbers(two) == Numbers{ 0, 0, 1 },
                "cells with a small angle between two facets");
    std::ostringstream with, without;
    with << two;
    without << one;
    check::that(with.str().find("of these, between two facets of the complex  50: 0  60: 0  95: 1\n") != std::string::npos
                && without.str().find("of these") == std::string::npos, "the report of sharp edges");
  }
  {
    // Four points near a great circle: nearly flat.
    const double h = 1e-9;
    const auto r = CGAL::mesh_quality_report_3(complex({ { 1, 0, h }, { -1, 0, h }, { 0, 1, -h }, { 0, -1, -h } }));
    check::that(r.number_of_cells == 1 && r.smallest_angle < 1e-6 && r.largest_angle > 180 - 1e-6
                && r.mean_radius_ratio < 1e-7, "sliver");
    check::that(r.angles[0] == 4 && r.angles[179] == 2, "histogram of the sliver");
  }
  {
    // The same far away and turned.
    std::vector<Point_3> moved;
    const double c = std::cos(0.7), s = std::sin(0.7);
    for(const Point_3& p : corner)
      moved.emplace_back(c * p.x() - s * p.y() + 1e4, s * p.x() + c * p.y() - 2e4, p.z() + 3e4);
    const auto r = CGAL::mesh_quality_report_3(complex(corner)), t = CGAL::mesh_quality_report_3(complex(moved));
    close_to(t.smallest_angle, r.smallest_angle, 1e-8, "turned, smallest angle");
    close_to(t.mean_radius_ratio, r.mean_radius_ratio, 1e-9, "turned, radius ratio");
    close_to(t.total().energy, r.total().energy, 1e-9, "turned, energy");
  }
  {
    const auto r = CGAL::mesh_quality_report_3(with_facets({ { 1, 1, 1 }, { 1, -1, -1 }, { -1, 1, -1 }, { -1, -1, 1 } }));
    close_to(r.smallest_facet_angle, 60, 1e-10, "smallest angle of equilateral facets");
    close_to(r.largest_facet_angle, 60, 1e-10, "largest smallest angle of equilateral facets");
    close_to(r.mean_facet_angle, 60, 1e-10, "mean angle of equilateral facets");
    check::that(r.number_of_facets == 4 && r.facet_angles[59] + r.facet_angles[58] == 4 && sum(r.facet_angles) == 4,
                "histogram of equilateral facets");
  }
  {
    // Three right-angled facets with two angles of 45 degrees each, and an equilateral one.
    const auto r = CGAL::mesh_quality_report_3(with_facets(corner));
    close_to(r.smallest_facet_angle, 45, 1e-10, "smallest angle of the facets of the cube's corner");
    close_to(r.largest_facet_angle, 60, 1e-10, "largest smallest angle of the facets of the cube's corner");
    close_to(r.mean_facet_angle, (3 * 45 + 60) / 4., 1e-10, "mean angle of the facets of the cube's corner");
  }
  {
    // Facets with legs of 1 and a, b or c: the tangents of their smallest angles are the ratios of legs.
    const auto r = CGAL::mesh_quality_report_3(with_facets({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 2, 0 }, { 0, 0, 4 } }));
    const double oblique = std::atan2(std::sqrt(4. + 16. + 64.), 16.) * degree;    // the normal is (8, 4, 2)
    close_to(r.smallest_facet_angle, std::atan(1 / 4.) * degree, 1e-10, "smallest angle of facets with legs");
    close_to(r.mean_facet_angle, (2 * std::atan(1 / 2.) * degree + std::atan(1 / 4.) * degree + oblique) / 4, 1e-10,
             "mean angle of facets with legs");
    check::that(r.facet_angles[14] == 1 && r.facet_angles[26] == 2 && sum(r.facet_angles) == 4, "histogram of facets with legs");
  }
  {
    // A needle of a facet, far away.
    const double h = 1e-9;
    const auto r = CGAL::mesh_quality_report_3(with_facets({ { 0, 0, 8 }, { h, 0, 8 }, { 0, 4, 8 }, { 0, 0, 11 } }));
    close_to(r.smallest_facet_angle, h / 4 * degree, 1e-15 * degree, "smallest angle of needles");
    check::that(r.facet_angles[0] >= 2, "histogram of needles");
  }
  {
    const auto r = CGAL::mesh_quality_report_3(complex(corner));
    check::that(r.number_of_facets == 0 && r.mean_facet_angle == 0 && sum(r.facet_angles) == 0, "facets that are not in the complex");
    std::ostringstream without, with;
    without << r;
    with << CGAL::mesh_quality_report_3(with_facets(corner));
    check::that(without.str().find("angle of a facet") == std::string::npos
                && without.str().find("each facet") == std::string::npos, "a report without facets prints some");
    check::that(with.str().find("smallest angle of a facet 45.00 - 60.00 degrees, mean 48.75\n") != std::string::npos
                && with.str().find("     45 -   50        3 ####") != std::string::npos, "the report of facets");
  }
  {
    std::vector<Point_3> cube;
    for(int i = 0; i < 8; ++i)
      cube.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
    const auto r = CGAL::mesh_quality_report_3(complex(cube));
    close_to(r.total().volume, 1, 1e-14, "volume of the cube");
    check::that(sum(r.angles) == 6 * r.number_of_cells && r.number_of_cells >= 5, "six angles a cell");
    std::ostringstream out;
    out << r;
    check::that(out.str().find("mean") != std::string::npos && out.str().find("degrees") != std::string::npos,
                "the printed report");
  }
  {
    const C3t3 c3t3 = with_facets(corner);
    const auto r = CGAL::mesh_quality_report_3(c3t3, Equilateral_criteria(), { 20 });
    check::that(r.bad_cells_and_facets && r.bad_cells_and_facets->first == 1 && r.bad_cells_and_facets->second == 3,
                "cells and facets that break criteria");
    std::ostringstream out;
    out << r;
    check::that(out.str().find("beyond the criteria 1 cells, 3 facets\n") != std::string::npos, "the report of criteria");
    check::that(!CGAL::mesh_quality_report_3(c3t3, std::vector<double>{ 20 }).bad_cells_and_facets, "criteria that are not given");
  }
  {
    // Criteria that are not set have no number.
    const C3t3 c3t3 = with_facets(corner);
    for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
      f->first->set_facet_surface_center(f->second, Point_3(5, 5, 5));
    const Criteria by_size(CGAL::parameters::facet_angle = 1, CGAL::parameters::facet_size = 0.1, CGAL::parameters::cell_size = 0.1),
      by_angle(CGAL::parameters::facet_angle = 50), by_ratio(CGAL::parameters::cell_radius_edge_ratio = 0.5, CGAL::parameters::cell_size = 10);
    const auto size = CGAL::mesh_quality_report_3(c3t3, by_size), angle = CGAL::mesh_quality_report_3(c3t3, by_angle),
      ratio = CGAL::mesh_quality_report_3(c3t3, by_ratio);
    typedef std::vector<std::size_t> Counts;
    check::that(size.bad_cells_by_criterion == Counts{ 1 } && size.bad_facets_by_criterion == Counts{ 0, 4 }, "cells and facets by size");
    check::that(angle.bad_cells_by_criterion.empty() && angle.bad_facets_by_criterion == Counts{ 3 }, "facets by angle");
    check::that(ratio.bad_cells_by_criterion == Counts{ 0, 1 } && ratio.bad_facets_by_criterion.empty(), "cells by radius-edge ratio");
    std::ostringstream out;
    out << size;
    check::that(out.str().find("beyond the criteria 1 cells, 4 facets (0 + 4)\n") != std::string::npos, "the report by criterion");
  }
  {
    const auto unprintable = report_of_three<Unprintable>(), alike = report_of_three<Tissue>();
    const std::vector<std::string> numbers = { "1", "2", "3" }, names = { "tissue", "tissue (2)", "tissue (3)" };
    for(std::size_t n = 0; n < 3; ++n)
    {
      const std::size_t cells = n == 1 ? 2 : 1;
      check::that(unprintable.subdomains.count(numbers[n]) == 1 && unprintable.subdomains.at(numbers[n]).number_of_cells == cells,
                  "a subdomain whose index cannot be printed");
      check::that(alike.subdomains.count(names[n]) == 1 && alike.subdomains.at(names[n]).number_of_cells == cells,
                  "subdomains whose indices print alike");
    }
    check::that(alike.total().number_of_cells == 4 && unprintable.total().number_of_cells == 4, "the sum over all subdomains");
  }
  check::that(CGAL::mesh_quality_report_3(C3t3()).number_of_cells == 0, "empty complex");
  return check::result();
}
