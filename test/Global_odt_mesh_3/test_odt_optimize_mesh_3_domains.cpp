// Copyright (c) 2026 The Global_odt_mesh_3 authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// On every kind of domain, whatever the mesh, odt_optimize_mesh_3() returns a
// valid complex with the boundary of the input, and better cells.

#include "mesh_contract.h"
#include "mesh_domains.h"
#include "realized_sizes.h"

#include <CGAL/Density_quadratures_3.h>
#include <CGAL/Quadratic_density_3.h>
#include <CGAL/Random.h>
#include <CGAL/odt_energy_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace params = CGAL::parameters;

// The mean over the cells of 3 r / R is the measure that ODT improves.
template <class C3t3>
double mean_radius_ratio(const C3t3& c3t3)
{
  typedef domains::Point_3 Point_3;
  double sum = 0;
  for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
  {
    Point_3 p[4];
    for(int i = 0; i < 4; ++i)
      p[i] = c3t3.triangulation().point(c, i).point();
    double area = 0;
    for(int i = 0; i < 4; ++i)
      area += std::sqrt(CGAL::squared_area(p[(i + 1) % 4], p[(i + 2) % 4], p[(i + 3) % 4]));
    sum += 9 * std::abs(CGAL::volume(p[0], p[1], p[2], p[3])) / area
           / std::sqrt(CGAL::squared_radius(p[0], p[1], p[2], p[3]));
  }
  return sum / double(c3t3.number_of_cells_in_complex());
}

// What a surface permits: by which ratio the volumes of a subdomain and of all may change,
// and how far its own points are from it, over the size of the mesh.
struct Tolerance
{
  double subdomain, all, surface;
};

template <class C3t3, class Domain>
void test(const std::string& name, const C3t3& input, const Domain& domain, const Tolerance& t, bool improves = true)
{
  std::cout << name << ": " << input.triangulation().number_of_vertices() << " vertices" << std::endl;
  const Mesh_contract<C3t3, Domain> contract(input, domain, name);
  const double before = mean_radius_ratio(input);
  const auto check_improved = [&](const C3t3& c3t3)
  {
    const double after = mean_radius_ratio(c3t3);
    std::cout << "  mean 3r/R " << before << " -> " << after << std::endl;
    check::that(!improves || after > before + 0.005, name, ": not improved");
    check::that(!improves || Mesh_contract<C3t3, Domain>::points(c3t3) != Mesh_contract<C3t3, Domain>::points(input),
                name, ": nothing moved");
  };

  C3t3 c3t3(input);
  CGAL::odt_optimize_mesh_3(c3t3, domain);
  contract.check_moved(c3t3, t.subdomain, t.all, t.surface);
  check_improved(c3t3);

  C3t3 fixed(input);
  CGAL::odt_optimize_mesh_3(fixed, domain, params::optimize_boundary = false);
  contract.check(fixed);
  check_improved(fixed);

  // To the end, without freezing.
  C3t3 converged(input);
  CGAL::odt_optimize_mesh_3(converged, domain, params::optimize_boundary(false), params::do_freeze = false,
                            params::convergence = 0, params::max_iteration_number = 200);
  contract.check(converged);

  C3t3 searched(input);
  CGAL::odt_optimize_mesh_3(searched, domain, params::number_of_rounds = 4);
  contract.check_moved(searched, t.subdomain, t.all, t.surface);
  check_improved(searched);

  // Bit for bit the same, and again on the result.
  C3t3 again(input);
  CGAL::odt_optimize_mesh_3(again, domain);
  check::that((Mesh_contract<C3t3, Domain>::points(again) == Mesh_contract<C3t3, Domain>::points(c3t3)),
              name, ": not deterministic");
  CGAL::odt_optimize_mesh_3(again, domain);
  contract.check_moved(again, 2 * t.subdomain, 2 * t.all, t.surface);
}

// Mean edge length between vertices of the interior, by distance from the center.
static std::vector<std::pair<double, int> > edge_length_profile(const domains::Labeled_c3t3& c3t3)
{
  std::vector<std::pair<double, int> > bins(5, { 0., 0 });
  const auto& tr = c3t3.triangulation();
  for(auto e = tr.finite_edges_begin(); e != tr.finite_edges_end(); ++e)
  {
    const auto u = e->first->vertex(e->second), v = e->first->vertex(e->third);
    if(u->in_dimension() != 3 || v->in_dimension() != 3)
      continue;
    const domains::Point_3 m = CGAL::midpoint(u->point().point(), v->point().point());
    auto& bin = bins[(std::min)(4, static_cast<int>(5 * std::sqrt(domains::squared(m))))];
    bin.first += std::sqrt(CGAL::squared_distance(u->point().point(), v->point().point()));
    ++bin.second;
  }
  for(auto& bin : bins)
    bin.first /= (std::max)(1, bin.second);
  return bins;
}

// A uniform mesh is taken for uniform, and a graded one keeps its sizes, however
// long the minimizer runs.
static void grading(const domains::Labeled_domain& domain)
{
  using namespace domains;
  namespace odt = CGAL::Global_odt_mesh_3::internal;
  Labeled_c3t3 uniform = mesh(domain, 0.2), graded = graded_mesh(domain, 0.05);
  const auto is_uniform = [&domain](const Labeled_c3t3& c3t3)
  {
    odt::Numbered_domain_3<Labeled_triangulation, Labeled_domain> numbered(domain);
    odt::Moving_triangulation_3 flat;
    odt::C3t3_reader_3<Labeled_c3t3, decltype(numbered)>(c3t3, numbered).read(flat, true);
    return odt::Input_density_3(flat).is_uniform();
  };
  check::that(is_uniform(uniform), "a uniform mesh is not taken for uniform");
  check::that(!is_uniform(graded), "a graded mesh is taken for uniform");

  const auto before = edge_length_profile(graded);
  const auto check_sizes = [&](const char* name, const auto& quadrature)
  {
    Labeled_c3t3 c3t3(graded);
    CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_freeze = false, params::convergence = 0,
                              params::max_iteration_number = 150, params::quadrature = quadrature);
    const auto after = edge_length_profile(c3t3);
    for(std::size_t n = 0; n < before.size(); ++n)
    {
      if(before[n].second < 50)
        continue;
      std::cout << "  " << name << ": edge length in bin " << n << ": " << before[n].first << " -> " << after[n].first << std::endl;
      check::that(std::abs(after[n].first / before[n].first - 1) < 0.1, name, ": sizes in bin ", n, " changed");
    }
  };
  check_sizes("linear rule", CGAL::Linear_density_rule_3());
  check_sizes("4 points", CGAL::Four_point_rule_3());
}

// Small at the south pole, three times as large at the north pole.
struct Size_by_latitude
{
  typedef domains::FT FT;
  typedef domains::Point_3 Point_3;
  typedef domains::Labeled_domain::Index Index;

  FT operator()(const Point_3& p, int dimension, const Index&) const
  {
    check::that(dimension == 2 || dimension == 3, "the field is asked for a vertex in dimension ", dimension);
    return (std::max)(0.5, 2 + p.z());
  }
};

// From a uniform mesh, vertices go where the sizes want them, or the density that amounts to the
// same; a number asks for a uniform mesh.
static void wanted_sizes(const domains::Labeled_domain& domain)
{
  using namespace domains;
  typedef Mesh_contract<Labeled_c3t3, Labeled_domain> Contract;
  const Labeled_c3t3 input = mesh(domain, 0.16);
  const Contract contract(input, domain, "wanted sizes");
  const Size_by_latitude size;
  const auto optimized = [&](const auto&... np)
  {
    Labeled_c3t3 c3t3(input);
    CGAL::odt_optimize_mesh_3(c3t3, domain, np...);
    contract.check_moved(c3t3, 0.05, 0.05, 0.02);
    return c3t3;
  };
  const Labeled_c3t3 usual = optimized(params::random_seed(0));
  const Labeled_c3t3 sized = optimized(params::sizing_field = size);
  const Labeled_c3t3 dense = optimized(params::density([&](const Point_3& p)
                                       { return std::pow(size(p, 3, Labeled_domain::Index()), -5) / 1000; }));
  const auto slope_of_sizes = [&size](const Labeled_c3t3& c3t3) { return Realized_sizes(c3t3, size, 3).slope; };
  const double before = slope_of_sizes(usual), after = slope_of_sizes(sized);
  const double by_density = slope_of_sizes(dense);
  std::cout << "  slope of sizes: " << before << " -> " << after << ", by density " << by_density << std::endl;
  check::that(std::abs(before) < 0.1, "a uniform mesh is graded");
  check::that(after > 0.5 && after < 1.2, "the sizes are not those wanted");
  check::that(std::abs(after - by_density) < 0.05, "a density leads to other sizes than the sizes that it stands for");
  check::that(Contract::points(optimized(params::sizing_field = 0.3)) == Contract::points(usual),
              "a number leads elsewhere than a uniform mesh");

  // Rules of more points lead to the same sizes, and polynomials, integrated exactly, to the energy of a rule that is exact for
  // them. The search goes other ways each time.
  const Labeled_c3t3 finer = optimized(params::quadrature = CGAL::Four_point_rule_3(), params::sizing_field = size);
  check::that(std::abs(slope_of_sizes(finer) - after) < 0.1, "a rule of four points leads to other sizes");
  const auto quadratic = CGAL::Quadratic_density_3<Kernel>::squared_distance(Point_3(0.3, 0, 0));
  const double exact = CGAL::odt_energy_3(optimized(params::density(quadratic)), params::density(quadratic));
  const double sampled = CGAL::odt_energy_3(optimized(params::quadrature(CGAL::Fifteen_point_rule_3()), params::density(quadratic)),
                                            params::density(quadratic));
  const double ignored = CGAL::odt_energy_3(usual, params::density(quadratic));
  std::cout << "  energy for a quadratic density: uniform " << ignored << ", exact " << exact << ", 15 points " << sampled << std::endl;
  check::that(exact < 0.95 * ignored && std::abs(exact / sampled - 1) < 0.01, "exact integrals lead elsewhere than good ones");

  // A field that is passed by reference is not copied.
  int questions = 0;
  const auto counting = [&questions](const Point_3&, int, const Labeled_domain::Index&) { ++questions; return 1.; };
  optimized(params::sizing_field = std::cref(counting));
  check::that(questions > 0, "a field passed by reference is not asked");
}

// Of holes that are smaller than cells, the mesher finds those with a dual point in them. No vertex may move so that there
// are more.
static void holes()
{
  using namespace domains;
  const int number_of_holes = 300;
  const double radius = 0.04, size = 0.3;
  for(unsigned int seed : { 2, 3 })
  {
    CGAL::Random random(seed);
    std::vector<Point_3> centers;
    for(int n = 0; n < number_of_holes; ++n)
    {
      const double x = random.get_double(-1, 1), y = random.get_double(-1, 1), z = random.get_double(-1, 1);
      centers.emplace_back(x, y, z);
    }
    const Labeled_domain domain = labeled([centers, radius](const Point_3& p)
    {
      const auto is_around = [&](const Point_3& c) { return CGAL::squared_distance(p, c) < radius * radius; };
      return squared(p) < 1 && std::none_of(centers.begin(), centers.end(), is_around) ? 1 : 0;
    });
    CGAL::get_default_random() = CGAL::Random(seed);
    const Labeled_c3t3 input = mesh(domain, size);
    const Mesh_contract<Labeled_c3t3, Labeled_domain> contract(input, domain, "holes, seed " + std::to_string(seed));
    Labeled_c3t3 c3t3(input);
    CGAL::odt_optimize_mesh_3(c3t3, domain);
    contract.check_moved(c3t3, 0.3, 0.3, 1e-2);
    c3t3 = input;
    CGAL::odt_optimize_mesh_3(c3t3, domain, params::optimize_boundary = false);
    contract.check(c3t3);
  }
}

int main()
{
  using namespace domains;
  // The meshes are coarse. Sharp edges that are no features are cut.
  const Tolerance smooth = { 0.02, 0.005, 4e-3 }, edged = { 0.05, 0.05, 4e-3 };
  const Tolerance rough = { 0.02, 0.008, 4e-3 };      // where the surface is that of voxels
  {
    const Labeled_domain domain = sphere();
    test("sphere", mesh(domain, 0.2), domain, smooth);
    test("graded sphere", graded_mesh(domain, 0.1), domain, smooth);
    grading(domain);
    wanted_sizes(domain);
  }
  {
    const Labeled_domain domain = torus();
    test("torus", mesh(domain, 0.15), domain, smooth);
  }
  {
    const Labeled_domain domain = three_subdomains();
    test("three subdomains", mesh(domain, 0.2), domain, smooth);
  }
  {
    const Labeled_domain domain = thin_plate();
    test("thin plate", mesh(domain, 0.15), domain, edged, false);
  }
  {
    const CGAL::Image_3 image = labeled_image();
    const Labeled_domain domain = labeled_image_domain(image);
    test("labeled image", mesh(domain, 0.08), domain, edged);
  }
  {
    const CGAL::Image_3 image = gray_image();
    const Labeled_domain domain = gray_image_domain(image);
    test("gray image", mesh(domain, 0.08), domain, rough);
  }
  {
    const Polyhedron box = notched_box();
    Polyhedral_domain domain(box);
    test("polyhedron", mesh(domain, 0.3, false), domain, edged);
    domain.detect_features();
    test("polyhedron with features", mesh(domain, 0.25, true), domain, smooth);
  }
  holes();
  return check::result();
}
