// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The formulas for energy and gradient: closed forms, finite differences,
// invariance, and orthogonality of the weighted circumcenter.

#include "check.h"

#include <CGAL/Global_odt_mesh_3/internal/energy/Odt_cell_energies_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Cell_geometry_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <Eigen/Dense>

#include <array>
#include <cmath>
#include <functional>
#include <iostream>
#include <random>

using namespace CGAL::Global_odt_mesh_3::internal;

typedef std::array<Site, 4> Cell;
typedef std::array<double, 4> Densities;

static Cell_energy uniform(const Cell& s)
{
  return uniform_odt_energy(Cell_products(s[0], s[1], s[2], s[3]), s[0], s[1], s[2], s[3]);
}

static Cell_energy graded(const Cell& s, const Densities& rho)
{
  return odt_energy(Cell_products(s[0], s[1], s[2], s[3]), s[0], s[1], s[2], s[3], linear_density_moments(rho));
}

static double squared_length(const Site& a, const Site& b)
{
  return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z);
}

static void near(double a, double b, double tolerance, const char* what)
{
  check::that(std::abs(a - b) <= tolerance * (std::max)({ 1e-300, std::abs(a), std::abs(b) }),
              what, ": ", a, " and ", b);
}

static Cell random_cell(std::mt19937& random, bool weighted)
{
  std::uniform_real_distribution<double> u(0, 1);
  for(;;)
  {
    Cell s;
    for(Site& p : s)
      p = { u(random), u(random), u(random), weighted ? 0.1 * u(random) : 0 };
    if(Cell_products(s[0], s[1], s[2], s[3]).determinant > 0.05)
      return s;
  }
}

// Corner of the unit cube: E = |t|/20 * sum of squared edge lengths.
static void closed_forms()
{
  const Cell corner = {{ { 0, 0, 0, 0 }, { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 } }};
  const Cell_energy e = uniform(corner);
  near(e.energy, 1. / 6 / 20 * 9, 1e-14, "energy of the cube's corner");
  // The circumcenter is (1/2, 1/2, 1/2): g_0 = |t|/2 (x_0 - c).
  near(e.gradient[0].x, -1. / 24, 1e-14, "gradient at the cube's corner");
  near(e.gradient[1].x, 1. / 24, 1e-14, "gradient at a neighbor of the cube's corner");
  near(e.gradient[1].y, -1. / 24, 1e-14, "gradient at a neighbor of the cube's corner");
  for(const Site_gradient& g : e.gradient)
    near(g.diagonal, 1. / 12, 1e-14, "D of the cube's corner");

  const double a = 1 / std::sqrt(8.);
  const Cell regular = {{ { a, a, a, 0 }, { a, -a, -a, 0 }, { -a, a, -a, 0 }, { -a, -a, a, 0 } }};
  const double volume = Cell_products(regular[0], regular[1], regular[2], regular[3]).determinant / 6;
  near(std::abs(volume), std::sqrt(2.) / 12, 1e-14, "volume of the regular tetrahedron of edge 1");
  near(uniform(regular).energy, volume * 6 / 20, 1e-14, "energy of the regular tetrahedron");
}

// The energy is the integral of f_I - |x|^2, here by its exact value at the
// points of a rule of degree 3 for f_I, and of degree 2 in the weights.
static void against_integral(std::mt19937& random)
{
  for(int n = 0; n < 20; ++n)
  {
    const Cell s = random_cell(random, true);
    const Densities rho = {{ 1, 2, 0.5, 3 }};
    const double volume = Cell_products(s[0], s[1], s[2], s[3]).determinant / 6;
    // A rule exact for cubics: weight -4/5 at the centroid, 9/20 at the points
    // with coordinates (1/2, 1/6, 1/6, 1/6).
    const auto integrate = [&](const std::function<double(const Densities&)>& f)
    {
      double sum = -0.8 * f({{ 0.25, 0.25, 0.25, 0.25 }});
      for(int i = 0; i < 4; ++i)
      {
        Densities l = {{ 1. / 6, 1. / 6, 1. / 6, 1. / 6 }};
        l[i] = 0.5;
        sum += 0.45 * f(l);
      }
      return volume * sum;
    };
    const auto error = [&](const Densities& l)
    {
      double lifted = 0, x = 0, y = 0, z = 0;
      for(int i = 0; i < 4; ++i)
      {
        lifted += l[i] * (s[i].x * s[i].x + s[i].y * s[i].y + s[i].z * s[i].z - s[i].weight);
        x += l[i] * s[i].x; y += l[i] * s[i].y; z += l[i] * s[i].z;
      }
      return lifted - x * x - y * y - z * z;
    };
    near(uniform(s).energy, integrate(error), 1e-11, "uniform energy and its integral");
    near(graded(s, rho).energy, integrate([&](const Densities& l)
         { return error(l) * (l[0] * rho[0] + l[1] * rho[1] + l[2] * rho[2] + l[3] * rho[3]); }),
         1e-11, "graded energy and its integral");
    const Cell_energy u = uniform(s), one = graded(s, {{ 1, 1, 1, 1 }});
    near(u.energy, one.energy, 1e-12, "density 1");
    for(int i = 0; i < 4; ++i)
    {
      near(u.gradient[i].x, one.gradient[i].x, 1e-11, "gradient for density 1");
      near(u.gradient[i].diagonal, one.gradient[i].diagonal, 1e-12, "D for density 1");
    }
  }
}

// (4.6) is |t|/10 (x_i - c)(R + rho_i), c having the same power to all four.
static void weighted_circumcenter(std::mt19937& random)
{
  for(int n = 0; n < 20; ++n)
  {
    const Cell s = random_cell(random, true);
    const Densities rho = {{ 1, 2, 0.5, 3 }};
    Eigen::Matrix3d A;
    Eigen::Vector3d b;
    for(int i = 1; i < 4; ++i)
    {
      A.row(i - 1) << s[i].x - s[0].x, s[i].y - s[0].y, s[i].z - s[0].z;
      b[i - 1] = (squared_length(s[i], s[0]) - s[i].weight + s[0].weight) / 2;
    }
    const Eigen::Vector3d c = A.partialPivLu().solve(b) + Eigen::Vector3d(s[0].x, s[0].y, s[0].z);
    const Cell_products t(s[0], s[1], s[2], s[3]);
    const Cell_energy e = graded(s, rho);
    const double R = 6.5;
    for(int i = 0; i < 4; ++i)
    {
      const double f = t.determinant / 60 * (R + rho[i]);
      near(e.gradient[i].x, f * (s[i].x - c.x()), 1e-9, "gradient and circumcenter, x");
      near(e.gradient[i].y, f * (s[i].y - c.y()), 1e-9, "gradient and circumcenter, y");
      near(e.gradient[i].z, f * (s[i].z - c.z()), 1e-9, "gradient and circumcenter, z");
      near(e.gradient[i].diagonal, f, 1e-12, "D");
    }
    // A point on the orthogonal sphere has power 0, the center a negative one.
    const double r = std::sqrt(squared_length(s[0], { c.x(), c.y(), c.z(), 0 }) - s[0].weight);
    if(r > 0)
    {
      const double scale = t.determinant * r * r;
      check::that(std::abs(t.power(s[0], { c.x() + r, c.y(), c.z(), 0 })) < 1e-9 * scale, "power on the sphere");
      near(t.power(s[0], { c.x(), c.y(), c.z(), 0 }), -scale, 1e-9, "power of the center");
    }
  }
}

// Around an interior vertex the sum of the gradients is the derivative of the
// sum of the energies, as the terms of the moving boundaries cancel.
static void finite_differences(std::mt19937& random, bool weighted)
{
  std::uniform_real_distribution<double> u(-0.1, 0.1);
  for(int n = 0; n < 20; ++n)
  {
    // An octahedron around the vertex.
    std::array<Site, 6> link = {{ { 1, 0, 0, 0 }, { -1, 0, 0, 0 }, { 0, 1, 0, 0 },
                                  { 0, -1, 0, 0 }, { 0, 0, 1, 0 }, { 0, 0, -1, 0 } }};
    for(Site& s : link)
    {
      s.x += u(random); s.y += u(random); s.z += u(random);
      s.weight = weighted ? 0.1 + u(random) : 0;
    }
    const Site center = { u(random), u(random), u(random), 0 };
    const auto star = [&](const Site& p)
    {
      double energy = 0;
      Site_gradient g = { 0, 0, 0, 0 };
      for(int k = 0; k < 8; ++k)
      {
        const int a = k & 1, b = 2 + (k >> 1 & 1), c = 4 + (k >> 2 & 1);
        const bool odd = ((k & 1) + (k >> 1 & 1) + (k >> 2 & 1)) % 2 != 0;
        const Cell s = {{ p, link[odd ? b : a], link[odd ? a : b], link[c] }};
        const Cell_energy e = uniform(s);
        check::that(Cell_products(s[0], s[1], s[2], s[3]).determinant > 0, "the star is inverted");
        energy += e.energy;
        g += e.gradient[0];
      }
      return std::make_pair(energy, g);
    };
    const Site_gradient g = star(center).second;
    const double h = 1e-4;
    near(1 + g.x, 1 + (star({ center.x + h, center.y, center.z, 0 }).first
                       - star({ center.x - h, center.y, center.z, 0 }).first) / (2 * h), 1e-9, "dE/dx");
    near(1 + g.y, 1 + (star({ center.x, center.y + h, center.z, 0 }).first
                       - star({ center.x, center.y - h, center.z, 0 }).first) / (2 * h), 1e-9, "dE/dy");
    near(1 + g.z, 1 + (star({ center.x, center.y, center.z + h, 0 }).first
                       - star({ center.x, center.y, center.z - h, 0 }).first) / (2 * h), 1e-9, "dE/dz");
  }
}

static void invariance(std::mt19937& random)
{
  const Densities rho = {{ 1, 2, 0.5, 3 }};
  for(int n = 0; n < 20; ++n)
  {
    const Cell s = random_cell(random, true);
    const Cell_energy e = graded(s, rho);

    // Coordinates that translation by 1e6 keeps to 1e-10.
    Cell far = s;
    for(Site& p : far)
    {
      p.x += 1e6; p.y -= 1e6; p.z += 2e6;
    }
    const Cell_energy t = graded(far, rho);
    near(t.energy, e.energy, 1e-7, "translation, energy");

    const Eigen::Matrix3d rotation = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    Cell rotated = s;
    for(int i = 0; i < 4; ++i)
    {
      const Eigen::Vector3d p = rotation * Eigen::Vector3d(s[i].x, s[i].y, s[i].z);
      rotated[i] = { p.x(), p.y(), p.z(), s[i].weight };
    }
    const Cell_energy r = graded(rotated, rho);
    near(r.energy, e.energy, 1e-12, "rotation, energy");

    const double scale = 1e-3;
    Cell scaled = s;
    for(Site& p : scaled)
      p = { scale * p.x, scale * p.y, scale * p.z, scale * scale * p.weight };
    const Cell_energy c = graded(scaled, rho);
    near(c.energy, std::pow(scale, 5) * e.energy, 1e-12, "scaling, energy");

    for(int i = 0; i < 4; ++i)
    {
      const Eigen::Vector3d g(e.gradient[i].x, e.gradient[i].y, e.gradient[i].z);
      const auto compare = [&](const Site_gradient& h, const Eigen::Vector3d& wanted, double tolerance, const char* what)
      { check::that((Eigen::Vector3d(h.x, h.y, h.z) - wanted).norm() <= tolerance * wanted.norm(), what); };
      compare(t.gradient[i], g, 1e-6, "translation, gradient");
      compare(r.gradient[i], rotation * g, 1e-11, "rotation, gradient");
      compare(c.gradient[i], std::pow(scale, 4) * g, 1e-11, "scaling, gradient");
    }
  }
}

int main()
{
  const unsigned int seed = 7;
  std::cout << "seed " << seed << std::endl;
  std::mt19937 random(seed);
  closed_forms();
  against_integral(random);
  weighted_circumcenter(random);
  finite_differences(random, false);
  finite_differences(random, true);
  invariance(random);
  return check::result();
}
