// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The fields of sizes that the package offers: splines on grids, and local feature sizes.

#include "check.h"
#include "mesh_domains.h"
#include "realized_sizes.h"

#include <CGAL/Local_feature_size_field_3.h>
#include <CGAL/Spline_grid_field_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace domains;
namespace odt = CGAL::Global_odt_mesh_3::internal;

typedef Kernel::Vector_3 Vector_3;
typedef CGAL::Spline_grid_field_3<Kernel> Spline;
typedef CGAL::Local_feature_size_field_3<Labeled_domain> Lfs_field;
typedef CGAL::Local_feature_size_parameters_3 Lfs_parameters;
typedef Labeled_domain::Index Index;

static const CGAL::Bbox_3 box(-1, 2, 0.5, 1, 2.5, 3.5);

static Point_3 random_point(std::mt19937& random, const CGAL::Bbox_3& b)
{
  std::uniform_real_distribution<double> u(0, 1);
  const double x = u(random), y = u(random), z = u(random);
  return Point_3(b.xmin() + x * (b.xmax() - b.xmin()), b.ymin() + y * (b.ymax() - b.ymin()),
                 b.zmin() + z * (b.zmax() - b.zmin()));
}

static std::vector<double> random_values(std::mt19937& random, std::size_t n)
{
  std::uniform_real_distribution<double> u(-1, 1);
  std::vector<double> values(n);
  for(double& v : values)
    v = u(random);
  return values;
}

static void near(double a, double b, double tolerance, const char* what)
{
  check::that(std::abs(a - b) <= tolerance, what, ": ", a, " and ", b);
}

static void near(const Vector_3& a, const Vector_3& b, double tolerance, const char* what)
{
  check::that((a - b).squared_length() <= tolerance * tolerance, what, ": ", a, " and ", b);
}

// Protects the reproduction of polynomials, near the ends of lines, too.
static void polynomials(std::mt19937& random)
{
  for(int n = 0; n < 64; ++n)
  {
    const int a = n % 4, b = n / 4 % 4, c = n / 16;
    const auto power = [](double x, int e) { return e < 0 ? 0 : std::pow(x, e); };
    const auto f = [&](const Point_3& p) { return power(p.x(), a) * power(p.y(), b) * power(p.z(), c); };
    const Spline spline(box, 5, 6, 9, f);
    for(int k = 0; k < 50; ++k)
    {
      const Point_3 p = random_point(random, box);
      near(spline(p), f(p), 1e-11, "polynomial");
      near(spline.gradient(p), Vector_3(a * power(p.x(), a - 1) * power(p.y(), b) * power(p.z(), c),
                                        b * power(p.x(), a) * power(p.y(), b - 1) * power(p.z(), c),
                                        c * power(p.x(), a) * power(p.y(), b) * power(p.z(), c - 1)),
           1e-9, "gradient of a polynomial");
    }
  }
}

// Protects the order of values in a range, and their interpolation.
static void interpolation(std::mt19937& random)
{
  const int nx = 5, ny = 7, nz = 6;
  const std::vector<double> values = random_values(random, nx * ny * nz);
  const Spline spline(box, nx, ny, nz, values);
  std::size_t n = 0;
  const Spline by_function(box, nx, ny, nz, [&](const Point_3&) { return values[n++]; });
  for(int k = 0; k < nz; ++k)
    for(int j = 0; j < ny; ++j)
      for(int i = 0; i < nx; ++i)
      {
        const Point_3 p(box.xmin() + i * box.x_span() / (nx - 1), box.ymin() + j * box.y_span() / (ny - 1),
                        box.zmin() + k * box.z_span() / (nz - 1));
        near(spline(p), values[i + nx * (j + ny * k)], 1e-13, "value at a node");
        near(by_function(p), spline(p), 1e-13, "values of a function, and in a range");
      }
  check::that(spline.bbox() == box, "the box is another one");
}

// Protects the order of the error, 4 for values and 3 for gradients.
static void convergence(std::mt19937& random)
{
  const auto f = [](const Point_3& p) { return std::exp(std::sin(p.x()) + 0.5 * p.y() * std::cos(p.z())); };
  const auto gradient = [&f](const Point_3& p)
  {
    return f(p) * Vector_3(std::cos(p.x()), 0.5 * std::cos(p.z()), -0.5 * p.y() * std::sin(p.z()));
  };
  std::vector<Point_3> points;
  for(int k = 0; k < 2000; ++k)
    points.push_back(random_point(random, box));
  std::array<check::Largest, 2> before;
  for(int n : { 17, 33, 65 })
  {
    const Spline spline(box, n, n, n, f);
    std::array<check::Largest, 2> error;
    for(const Point_3& p : points)
    {
      error[0].add(std::abs(spline(p) - f(p)));
      error[1].add(std::sqrt((spline.gradient(p) - gradient(p)).squared_length()));
    }
    std::cout << "  " << n << " nodes: error " << error[0] << ", of the gradient " << error[1] << std::endl;
    check::that(before[0] == 0 || before[0] / error[0] > 13, "the error falls by ", before[0] / error[0], ", not 16");
    check::that(before[1] == 0 || before[1] / error[1] > 6.5, "its gradient falls by ", before[1] / error[1], ", not 8");
    before = error;
  }
}

// Protects C2 across the faces of grid cells, and the gradient everywhere.
static void smoothness(std::mt19937& random)
{
  const int n = 8;
  const CGAL::Bbox_3 unit_steps(0, 0, 0, n - 1, n - 1, n - 1), inner(1, 1, 1, n - 2, n - 2, n - 2);
  const Spline spline(unit_steps, n, n, n, random_values(random, n * n * n));
  const double e = 1e-5;
  for(int k = 0; k < 300; ++k)
  {
    const Point_3 p = random_point(random, inner);
    const int axis = k % 3;
    const Vector_3 step(axis == 0 ? e : 0, axis == 1 ? e : 0, axis == 2 ? e : 0);
    near(spline.gradient(p)[axis], (spline(p + step) - spline(p - step)) / (2 * e), 1e-7, "gradient by differences");

    double c[3] = { p.x(), p.y(), p.z() };
    c[axis] = std::round(c[axis]);
    const Point_3 q(c[0], c[1], c[2]);
    near(spline(q + step), spline(q - step), 1e-3, "C0");
    near(spline.gradient(q + step), spline.gradient(q - step), 1e-2, "C1");
    near((spline.gradient(q + step) - spline.gradient(q)) / e, (spline.gradient(q) - spline.gradient(q - step)) / e,
         1e-2, "C2");
  }
}

// Protects queries outside of the box, of infinite points, too.
static void outside(std::mt19937& random)
{
  const Spline spline(box, 6, 5, 7, random_values(random, 6 * 5 * 7));
  const CGAL::Bbox_3 around(-4, -1, -2, 4, 5, 6);
  for(int k = 0; k < 500; ++k)
  {
    const Point_3 p = random_point(random, around);
    const Point_3 closest((std::min)((std::max)(p.x(), box.xmin()), box.xmax()),
                          (std::min)((std::max)(p.y(), box.ymin()), box.ymax()),
                          (std::min)((std::max)(p.z(), box.zmin()), box.zmax()));
    near(spline(p), spline(closest), 1e-12, "value outside");
    const Vector_3 g = spline.gradient(closest);
    near(spline.gradient(p), Vector_3(p.x() == closest.x() ? g.x() : 0, p.y() == closest.y() ? g.y() : 0,
                                      p.z() == closest.z() ? g.z() : 0), 1e-11, "gradient outside");
  }
  const double infinity = std::numeric_limits<double>::infinity();
  near(spline(Point_3(infinity, 0, -infinity)), spline(Point_3(box.xmax(), box.ymin(), box.zmin())), 1e-12,
       "infinite point");
}

// Protects users from bad grids and parameters: a precondition says what is wrong.
static void refusals()
{
  const CGAL::Failure_behaviour behaviour = CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
  const CGAL::Failure_function handler = CGAL::set_error_handler(
    [](const char*, const char*, const char*, int, const char*) {});
  const auto refuses = [](const std::string& what, const std::function<void()>& call)
  {
    bool named = false;
    try { call(); }
    catch(const CGAL::Precondition_exception& e)
    {
      named = e.message().find(what) != std::string::npos;
    }
    check::that(named, "no precondition says: ", what);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto one = [](const Point_3&) { return 1.; };
  const std::vector<double> values(125, 1);
  refuses("5 nodes along x", [&] { Spline(box, 4, 5, 5, one); });
  refuses("5 nodes along y", [&] { Spline(box, 5, 0, 5, one); });
  refuses("5 nodes along z", [&] { Spline(box, 5, 5, -5, one); });
  refuses("along x", [&] { Spline(CGAL::Bbox_3(), 5, 5, 5, one); });
  refuses("along x", [&] { Spline(CGAL::Bbox_3(nan, 0, 0, 1, 1, 1), 5, 5, 5, one); });
  refuses("along y", [&] { Spline(CGAL::Bbox_3(0, 1, 0, 1, 1, 1), 5, 5, 5, one); });
  refuses("along z", [&] { Spline(CGAL::Bbox_3(0, 0, 0, 1, 1, infinity), 5, 5, 5, one); });
  refuses("number of values", [&] { Spline(box, 5, 5, 6, values); });
  refuses("number of values", [&] { Spline(box, 5, 5, 5, std::vector<double>()); });
  for(double bad : { nan, infinity })
  {
    std::vector<double> some = values;
    some[77] = bad;
    refuses("not finite", [&] { Spline(box, 5, 5, 5, some); });
    refuses("not finite", [&] { Spline(box, 5, 5, 5, [bad](const Point_3& p) { return p.x() > 0 ? bad : 1; }); });
  }

  const std::vector<Point_3> points = { Point_3(0, 0, 0), Point_3(1, 0, 0) };
  const auto refuses_parameter = [&](const char* name, double Lfs_parameters::* member, double bad)
  {
    Lfs_parameters p;
    p.*member = bad;
    refuses(name, [&] { Lfs_field::from_points(points, p); });
  };
  for(double bad : { -1., nan, infinity })
  {
    refuses_parameter("size_factor", &Lfs_parameters::size_factor, bad);
    refuses_parameter("gradation", &Lfs_parameters::gradation, bad);
    refuses_parameter("smallest_size", &Lfs_parameters::smallest_size, bad);
    refuses_parameter("largest_size", &Lfs_parameters::largest_size, bad);
    refuses_parameter("sample_spacing", &Lfs_parameters::sample_spacing, bad);
  }
  refuses_parameter("size_factor", &Lfs_parameters::size_factor, 0);
  refuses("largest_size", [&]
  {
    Lfs_parameters p;
    p.smallest_size = 2;
    p.largest_size = 1;
    Lfs_field::from_points(points, p);
  });
  refuses("no samples", [] { Lfs_field::from_points(std::vector<Point_3>()); });
  refuses("sample is not finite", [&] { Lfs_field::from_points(std::vector<Point_3>{ Point_3(0, nan, 0) }); });
  refuses("same point", [&] { Lfs_field::from_points(std::vector<Point_3>{ points[0], points[0] }); });
  CGAL::set_error_handler(handler);
  CGAL::set_error_behaviour(behaviour);
}

// Samples of a torus around the z-axis, of radii 1 and `tube`, about `spacing` apart.
static std::vector<Point_3> torus_samples(std::mt19937& random, double tube, double spacing)
{
  std::uniform_real_distribution<double> u(-0.3, 0.3);
  std::vector<Point_3> samples;
  const int around_tube = static_cast<int>(2 * CGAL_PI * tube / spacing);
  for(int j = 0; j < around_tube; ++j)
  {
    const double ring = 1 + tube * std::cos(2 * CGAL_PI * j / around_tube);
    const int around_axis = static_cast<int>(2 * CGAL_PI * ring / spacing);
    for(int i = 0; i < around_axis; ++i)
    {
      const double a = 2 * CGAL_PI * (i + u(random)) / around_axis, b = 2 * CGAL_PI * (j + u(random)) / around_tube;
      const double r = 1 + tube * std::cos(b);
      samples.emplace_back(r * std::cos(a), r * std::sin(a), tube * std::sin(b));
    }
  }
  return samples;
}

static std::vector<double> feature_sizes(const std::vector<Point_3>& samples)
{
  return odt::Boundary_poles_3(samples).distances(samples);
}

// Protects local feature sizes where the inner and where the outer medial axis is closer, on the convex hull and off it.
static void torus_poles(std::mt19937& random)
{
  for(double tube : { 0.4, 0.6 })
  {
    const std::vector<Point_3> samples = torus_samples(random, tube, 0.06);
    const std::vector<double> lfs = feature_sizes(samples);
    check::Largest worst;
    for(std::size_t n = 0; n < samples.size(); ++n)
    {
      const double known = (std::min)(tube, std::hypot(samples[n].x(), samples[n].y()));
      worst.add(std::abs(lfs[n] / known - 1));
    }
    std::cout << "  torus of " << samples.size() << " samples: local feature size within " << 100 * worst << " %"
              << std::endl;
    check::that(worst < 0.02, "local feature size of a torus: off by ", worst);
  }
}

// Protects the choice of poles: noise and flat cells at the surface are no features.
static void noisy_sphere_poles(std::mt19937& random)
{
  std::uniform_real_distribution<double> noise(-0.003, 0.003);
  std::vector<Point_3> samples;
  const int number = 4000;
  for(int n = 0; n < number; ++n)
  {
    const double z = (2 * n + 1.) / number - 1, a = CGAL_PI * (3 - std::sqrt(5.)) * n, r = std::sqrt(1 - z * z);
    samples.push_back(CGAL::ORIGIN + (1 + noise(random)) * Vector_3(r * std::cos(a), r * std::sin(a), z));
  }
  const std::vector<double> lfs = feature_sizes(samples);
  const double smallest = *std::min_element(lfs.begin(), lfs.end()), largest = *std::max_element(lfs.begin(), lfs.end());
  std::cout << "  noisy sphere: local feature sizes " << smallest << " to " << largest << std::endl;
  check::that(smallest > 0.85 && largest < 1.05, "local feature sizes of a noisy sphere");
}

// Protects samples on planes and in lattices, where all cells at the surface are degenerate.
static void parallel_planes_poles()
{
  const double distance = 0.4;
  const int n = 30;
  std::vector<Point_3> samples, middle;
  for(int k = 0; k < 2; ++k)
    for(int j = 0; j <= n; ++j)
      for(int i = 0; i <= n; ++i)
      {
        samples.emplace_back(2. * i / n, 2. * j / n, k * distance);
        if(std::abs(2 * i - n) < n / 2 && std::abs(2 * j - n) < n / 2)
          middle.push_back(samples.back());
      }
  for(double d : odt::Boundary_poles_3(samples).distances(middle))
    near(d, distance / 2, 0.02 * distance, "local feature size between planes");
}

// Protects the search, and that samples which it leaves out do not matter.
static void envelope(std::mt19937& random)
{
  const CGAL::Bbox_3 unit(0, 0, 0, 1, 1, 1), around(-1, -1, -1, 2, 2, 2);
  std::uniform_real_distribution<double> u(0.01, 0.3);
  std::vector<Point_3> samples;
  std::vector<double> sizes;
  for(int n = 0; n < 500; ++n)
  {
    samples.push_back(random_point(random, unit));
    sizes.push_back(u(random));
  }
  for(double gradation : { 0., 1e-200, 1e-9, 0.1, 1., 10. })
    for(double largest : { 0.005, 0.05, 0.5 })
    {
      const odt::Size_envelope_3 envelope(samples, sizes, gradation, largest);
      for(int k = 0; k < 200; ++k)
      {
        const Point_3 p = random_point(random, around);
        double least = largest;
        for(std::size_t n = 0; n < samples.size(); ++n)
          least = (std::min)(least, std::sqrt(sizes[n] * sizes[n]
                                              + gradation * gradation * CGAL::squared_distance(p, samples[n])));
        near(envelope(p.x(), p.y(), p.z()), least, 1e-12 * least, "the envelope, and the minimum over all samples");
      }
    }
}

// Protects bounds and gradation of the field, and what is derived when nothing is given.
static void bounds_and_gradation(std::mt19937& random)
{
  const std::vector<Point_3> samples = torus_samples(random, 0.4, 0.08);
  const CGAL::Bbox_3 around(-3, -3, -3, 3, 3, 3);
  for(double gradation : { 0., 0.3, 1. })
  {
    Lfs_parameters p;
    p.gradation = gradation;
    const Lfs_field field = Lfs_field::from_points(samples, p);
    p = field.parameters();
    check::that(0 < p.smallest_size && p.smallest_size < p.largest_size && p.sample_spacing > 0, "no derived lengths");
    for(int k = 0; k < 2000; ++k)
    {
      const Point_3 a = random_point(random, around), b = k % 2 == 0 ? random_point(random, around)
                                                                     : a + 1e-3 * (random_point(random, around) - a);
      const double size_a = field(a, 3, Index()), size_b = field(b, 2, Index());
      check::that(size_a >= p.smallest_size && size_a <= p.largest_size, "size ", size_a, " is out of bounds");
      check::that(std::abs(size_a - size_b) <= gradation * std::sqrt(CGAL::squared_distance(a, b)) + 1e-12,
                  "gradation ", gradation, " is exceeded");
    }
    near(field(Point_3(1.4, 0, 0), 2, Index()), (std::min)(0.2, p.largest_size), 0.02, "size at the surface");
  }
  Lfs_parameters one_bound;
  one_bound.smallest_size = 5;
  near(Lfs_field::from_points(samples, one_bound)(samples[0], 2, Index()), 5, 0, "a large smallest size");
  one_bound.smallest_size = 0;
  one_bound.largest_size = 1e-3;
  near(Lfs_field::from_points(samples, one_bound)(samples[0], 2, Index()), 1e-3, 0, "a small largest size");
}

// Protects independence of where the domain is and of the unit of length.
static void covariance(std::mt19937& random)
{
  const std::vector<Point_3> samples = torus_samples(random, 0.4, 0.1);
  const Lfs_field field = Lfs_field::from_points(samples);
  const CGAL::Bbox_3 around(-2, -2, -2, 2, 2, 2);
  for(double scale : { 1., 1e-6, 1e6 })
  {
    const auto move = [scale](const Point_3& p)
    { return Point_3(scale * (p.x() + 10), scale * (p.y() - 20), scale * (p.z() + 30)); };
    std::vector<Point_3> moved;
    for(const Point_3& p : samples)
      moved.push_back(move(p));
    const Lfs_field moved_field = Lfs_field::from_points(moved);
    for(int k = 0; k < 300; ++k)
    {
      const Point_3 p = random_point(random, around);
      near(moved_field(move(p), 3, Index()) / scale, field(p, 3, Index()), 1e-6, "field of moved and scaled samples");
    }
  }
}

// A ring whose tube is thick on one side and thin on the other.
static Labeled_domain uneven_ring()
{
  return labeled([](const Point_3& p)
  {
    const double tube = 0.3 + 0.15 * std::cos(std::atan2(p.y(), p.x()));
    const double ring = std::hypot(p.x(), p.y()) - 1;
    return ring * ring + p.z() * p.z() < tube * tube ? 1 : 0;
  });
}

// Meshes with a field of sizes, optimizes with the same one, and compares the sizes of cells with those wanted.
template <class Field>
static Labeled_c3t3 realize(const char* name, const Labeled_domain& domain, const Field& field)
{
  const Labeled_criteria criteria(params::facet_angle = 25, params::facet_size = field, params::facet_distance = 0.02,
                                  params::cell_radius_edge_ratio = 2.5, params::cell_size = field);
  const Labeled_c3t3 input = CGAL::make_mesh_3<Labeled_c3t3>(domain, criteria, params::no_exude(), params::no_perturb());
  const Realized_sizes before(input, field);
  constexpr unsigned int seeds = 3;
  struct { double slope = 0, deviation = 0; } after;       // means over seeds
  Labeled_c3t3 c3t3;
  for(unsigned int seed = 0; seed < seeds; ++seed)
  {
    c3t3 = input;
    CGAL::odt_optimize_mesh_3(c3t3, domain, params::sizing_field = field, params::random_seed(seed));
    const Realized_sizes sizes(c3t3, field);
    after.slope += sizes.slope / seeds;
    after.deviation += sizes.deviation / seeds;
  }
  std::cout << "  " << name << ": " << c3t3.triangulation().number_of_vertices() << " vertices, slope of sizes "
            << before.slope << " -> " << after.slope << ", deviation " << before.deviation << " -> " << after.deviation << std::endl;
  check::that(after.slope > 0.8 && after.slope < 1.2, name, ": the sizes are not those wanted");
  check::that(after.deviation < before.deviation && after.deviation < 0.13, name, ": the optimizer does not follow the field");
  return c3t3;
}

// Protects the use as sizes of the mesh and of the optimizer, which must agree, by way of each constructor.
static void mesh_and_optimize()
{
  const Labeled_domain domain = uneven_ring();
  Lfs_parameters parameters;
  parameters.size_factor = 0.4;
  parameters.sample_spacing = 0.06;
  const Lfs_field field(domain, parameters);
  const double thin = field(Point_3(-1.15, 0, 0), 2, Index()), thick = field(Point_3(1.45, 0, 0), 2, Index());
  std::cout << "  sizes at the surface of the ring: " << thin << " and " << thick << std::endl;
  near(thin, 0.4 * 0.15, 0.012, "size where the ring is thin");
  near(thick, 0.4 * 0.45, 0.03, "size where the ring is thick");
  const Labeled_c3t3 c3t3 = realize("local feature size", domain, field);

  const Lfs_field again = Lfs_field::from_mesh(c3t3, parameters);
  near(again(Point_3(-1.15, 0, 0), 2, Index()), thin, 0.012, "size of the field from a mesh");

  static_assert(CGAL::Mesh_3::Is_mesh_domain_field_3<Labeled_triangulation, Spline>::value, "not a field");
  const Spline spline(domain.bbox(), 61, 61, 61, [&](const Point_3& p) { return field(p, 3, Index()); });
  realize("spline", domain, spline);
  Labeled_c3t3 by_density = c3t3;
  CGAL::odt_optimize_mesh_3(by_density, domain, params::number_of_rounds = 0, params::density(
    Spline(domain.bbox(), 61, 61, 61, [&](const Point_3& p) { return std::pow(field(p, 3, Index()) / thick, -5); })));
}

int main()
{
  const unsigned int seed = 5;
  std::cout << "seed " << seed << std::endl;
  std::mt19937 random(seed);
  polynomials(random);
  interpolation(random);
  convergence(random);
  smoothness(random);
  outside(random);
  refusals();
  torus_poles(random);
  noisy_sphere_poles(random);
  parallel_planes_poles();
  envelope(random);
  bounds_and_gradation(random);
  covariance(random);
  mesh_and_optimize();
  return check::result();
}
