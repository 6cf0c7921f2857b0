// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The mathematics of vertices that move on surfaces: tangential gradients of both energies
// against finite differences, the CVT energy against closed forms and sampling, flips
// of surface edges, and the guard of the topology of boundaries.

#include "load_triangulation_3.h"
#include "check.h"

#include <CGAL/Global_odt_mesh_3/internal/geometry/Vertex_tuples.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Limited_memory_bfgs.h>
#include <CGAL/Global_odt_mesh_3/internal/optimization/Odt_objective_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Boundary_complex_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Exchangeable_boundary_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Surface_cvt_objective_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace CGAL::Global_odt_mesh_3::internal;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Regular_triangulation_3<Kernel> Regular;
typedef Vector_3 Vector;

// The derivative of the objective when one vertex moves along a tangent, against its gradient
// and what is known to be left out of it. Rejected, the trial leaves no trace.
template <class Objective>
static double gradient_error(Objective& objective, int v, const Vector_3& tangent, double h,
                             const Vector_3& left_out = Vector_3())
{
  const double expected = tangent.dot(vector_at(objective.gradient(), v) + left_out);
  const Eigen::VectorXd x = objective.point(), g = objective.gradient(), d = objective.diagonal();
  const double value_at_x = objective.value();
  double value[2];
  for(int side = 0; side < 2; ++side)
  {
    Eigen::VectorXd y = x;
    set_vector(y, v, vector_at(x, v) + (side == 0 ? h : -h) * tangent);
    check::that(objective.evaluate(y), "a small step is not feasible");
    value[side] = objective.value();
    objective.reject();
    check::that(objective.value() == value_at_x && objective.point() == x && objective.gradient() == g
                && objective.diagonal() == d, "a rejected trial leaves a trace");
  }
  return std::abs((value[0] - value[1]) / (2 * h) - expected);
}

static Vector_3 some_tangent(const Vector& n, std::mt19937& random)
{
  std::normal_distribution<double> g;
  const Vector d(g(random), g(random), g(random));
  return (d - n.dot(d) * n).normalized();
}

// The gradient of the ODT energy is that for a domain that does not change, as vertices stay on its
// surface. The polyhedron of the cells changes nevertheless when a vertex of a curved surface moves,
// by which the energy gains, for each facet of area A and outer normal n at vertex i,
//   integral of (f_I - x^2) lambda_i n = A n ((l_ij^2 + l_ik^2) / 30 + l_jk^2 / 60).
static std::vector<Vector_3> gain_of_polyhedron(const Moving_triangulation_3& mesh)
{
  std::vector<Vector_3> gain(mesh.sites.size(), Vector_3());
  const auto point = [&](int v) { return Vector_3(mesh.sites[v].x, mesh.sites[v].y, mesh.sites[v].z); };
  for(int c = 0; c < mesh.topology.number_of_cell_slots(); ++c)
    for(int f = 0; mesh.topology.is_alive(c) && f < 4; ++f)
    {
      const Half_facet s(c, f);
      if(!mesh.topology.neighbor(s).is_side())
        continue;
      const std::array<int, 3> t = mesh.topology.facet(s);
      Vector_3 area = (point(t[1]) - point(t[0])).cross(point(t[2]) - point(t[0])) / 2;
      if(area.dot(point(mesh.topology.vertex(s)) - point(t[0])) > 0)
        area = -area;
      for(int i = 0; i < 3; ++i)
      {
        const Vector_3 p = point(t[i]), q = point(t[(i + 1) % 3]), r = point(t[(i + 2) % 3]);
        gain[t[i]] += area * (((p - q).squared_length() + (p - r).squared_length()) / 30 + (q - r).squared_length() / 60);
      }
    }
  return gain;
}

static Boundary_complex_3 hull(const Moving_triangulation_3& mesh)
{
  std::vector<Boundary_facet> facets;
  for(int n = 0; n < mesh.topology.number_of_constrained_facets(); ++n)
    for(int side = 0; side < 2; ++side)
    {
      const Half_facet s = mesh.topology.constrained_half_facet(n, side);
      if(!s.is_none())
        facets.push_back({ mesh.topology.facet(s), {{ 0, 1 }}, 0 });
    }
  return Boundary_complex_3(facets, mesh.sites.size());
}

// The ODT energy of points in a convex body, of which those on the hull move in tangential planes, perhaps with
// that of the CVT of its surface.
static void odt_energy(const char* name, const std::vector<Vector>& on_surface, const std::vector<Vector>& inside,
                       const std::function<Vector(const Site&)>& normal, double surface_weight, std::mt19937& random)
{
  std::vector<Regular::Weighted_point> points;
  for(const auto* set : { &on_surface, &inside })
    for(const Vector& p : *set)
      points.emplace_back(Kernel::Point_3(p[0], p[1], p[2]), 0);
  Regular tr(points.begin(), points.end());
  Moving_triangulation_3 mesh = load_triangulation_3(tr);
  mesh.number_of_movable_vertices = static_cast<int>(mesh.sites.size());
  std::vector<Tangential_motion> motions;
  for(int v = mesh.number_of_interior_vertices; v < mesh.number_of_movable_vertices; ++v)
  {
    const Vector n = normal(mesh.sites[v]);
    motions.push_back({ n, n.dot(n) > 0 ? 0.1 : 0., mesh.sites[v] });
  }
  Surface_cvt_term_3 cvt(mesh.number_of_interior_vertices, static_cast<int>(motions.size()), surface_weight, Surface_density());
  cvt.follow(hull(mesh), mesh.sites);
  Odt_objective_3 objective(mesh, motions, surface_weight > 0 ? Odt_objective_3::Term(std::ref(cvt)) : Odt_objective_3::Term());
  const double stiffness = Odt_objective_3(mesh, motions).diagonal().sum();
  check::that(std::abs(objective.diagonal().sum() - (1 + surface_weight) * stiffness) < 1e-9 * stiffness, name,
              ": the energies are not in the ratio of ", surface_weight);
  check::that(objective.is_feasible(), name, ": not feasible");
  const double scale = objective.gradient().cwiseAbs().maxCoeff();
  const std::vector<Vector_3> gain = gain_of_polyhedron(mesh);
  int tested = 0;
  for(int v = mesh.number_of_interior_vertices; v < mesh.number_of_movable_vertices; ++v)
  {
    const Tangential_motion& m = motions[v - mesh.number_of_interior_vertices];
    const Vector_3 g = vector_at(objective.gradient(), v);
    if(m.is_at_rest())
    {
      check::that(g.length() == 0, name, ": a vertex at rest has a gradient");
      continue;
    }
    check::that(std::abs(g.dot(m.normal)) < 1e-12 * scale, name,
                ": the gradient is not tangential");
    const double error = gradient_error(objective, v, some_tangent(m.normal, random), 1e-6, gain[v]);
    check::that(error < 1e-6 * scale, name, ": tangential gradient off by ", error, " of ", scale);
    ++tested;
  }
  check::that(tested > 20, name, ": only ", tested, " vertices on the surface");

  // A long step ends at the rim of the disk, in the plane.
  Eigen::VectorXd far = objective.point() - 1e3 * objective.gradient() / scale;
  objective.evaluate(far);
  for(int v = mesh.number_of_interior_vertices; v < mesh.number_of_movable_vertices; ++v)
  {
    const Tangential_motion& m = motions[v - mesh.number_of_interior_vertices];
    const Site& s = mesh.sites[v];
    const Vector way = position(s) - position(m.center);
    check::that(way.length() <= m.radius * (1 + 1e-9) && std::abs(way.dot(m.normal)) < 1e-9, name,
                ": a vertex left its disk");
  }
  objective.reject();
}

static void odt_energy_on_sphere_and_plane()
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> u(-1, 1);
  std::vector<Vector> surface, inside;
  const double golden = 3.14159265358979 * (3 - std::sqrt(5.));
  for(int n = 0; n < 120; ++n)
  {
    const double z = 1 - (2 * n + 1) / 120., r = std::sqrt(1 - z * z);
    surface.push_back(Vector(r * std::cos(golden * n), r * std::sin(golden * n), z));
  }
  while(inside.size() < 150)
  {
    const Vector p{ u(random), u(random), u(random) };
    if(p.dot(p) < 0.7)
      inside.push_back(p);
  }
  odt_energy("sphere", surface, inside, [](const Site& s) { return position(s); }, 0, random);

  // The faces of a cube, jittered in their planes; edges and corners rest.
  surface.clear();
  for(Vector& p : inside)
    p *= 0.9;
  const int grid = 5;
  for(int i = 0; i <= grid; ++i)
    for(int j = 0; j <= grid; ++j)
      for(int k = 0; k <= grid; ++k)
      {
        const int at[] = { i, j, k };
        Vector p;
        int faces = 0;
        for(int a = 0; a < 3; ++a)
          faces += at[a] % grid == 0;
        for(int a = 0; a < 3; ++a)
          p[a] = 2. * at[a] / grid - 1 + (faces == 1 && at[a] % grid != 0 ? 0.05 * u(random) : 0);
        if(faces > 0)
          surface.push_back(p);
      }
  const auto normal = [](const Site& s)
  {
    const Vector n(double(std::abs(s.x) == 1) * s.x, double(std::abs(s.y) == 1) * s.y, double(std::abs(s.z) == 1) * s.z);
    return n.dot(n) == 1 ? n : Vector(0, 0, 0);
  };
  odt_energy("plane", surface, inside, normal, 0, random);
  // On planes, there is no more to the gradient of the CVT's energy.
  odt_energy("plane with CVT", surface, inside, normal, 3, random);
}

// A square cut into triangles of a jittered grid, whose rim rests.
struct Square
{
  static constexpr int grid = 9;
  std::vector<Site> sites;
  std::vector<Boundary_facet> facets;
  std::vector<Tangential_motion> motions;       // of the first vertices

  explicit Square(double jitter)
  {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> u(-1, 1);
    std::vector<int> number((grid + 1) * (grid + 1));
    for(int rim = 0; rim < 2; ++rim)
      for(int i = 0; i <= grid; ++i)
        for(int j = 0; j <= grid; ++j)
        {
          const bool on_rim = i % grid == 0 || j % grid == 0;
          if(on_rim != (rim == 1))
            continue;
          const double f = on_rim ? 0 : jitter / grid;
          number[i * (grid + 1) + j] = static_cast<int>(sites.size());
          sites.push_back({ i / double(grid) + f * u(random), j / double(grid) + f * u(random), 0, 0 });
          if(!on_rim)
            motions.push_back({ Vector(0, 0, 1), 0.5, sites.back() });
        }
    const auto v = [&](int i, int j) { return number[i * (grid + 1) + j]; };
    for(int i = 0; i < grid; ++i)
      for(int j = 0; j < grid; ++j)
      {
        // Every other facet is given from its other side.
        facets.push_back({ {{ v(i, j), v(i + 1, j), v(i + 1, j + 1) }}, {{ 0, 1 }}, 0 });
        facets.push_back({ {{ v(i, j), v(i, j + 1), v(i + 1, j + 1) }}, {{ 1, 0 }}, 0 });
      }
  }

  Surface_cvt_objective_3 objective(const Surface_cvt_objective_3::Density& density)
  {
    return Surface_cvt_objective_3(Boundary_complex_3(facets, sites.size()), sites, 0, motions, density);
  }
};

static double angle(const Site& apex, const Site& a, const Site& b)
{
  const Vector_3 p(a.x - apex.x, a.y - apex.y, a.z - apex.z), q(b.x - apex.x, b.y - apex.y, b.z - apex.z);
  return std::atan2(p.cross(q).length(), p.dot(q));
}

static void cvt_energy()
{
  // A lattice of equilateral triangles has hexagons of twice a triangle's area A as cells,
  // with 5 (2 A)^2 / (18 sqrt 3) each.
  const double h = std::sqrt(3.) / 2, area = h / 2;
  const std::vector<Site> lattice = { { 0, 0, 0, 0 }, { 1, 0, 0, 0 }, { 0.5, h, 0, 0 } };
  const Surface_cvt_contribution_3 equilateral({{ 0, 1, 2 }}, lattice, {{ 1, 1, 1 }});
  const double cell = 5 * 4 * area * area / (18 * std::sqrt(3.));
  check::that(std::abs(2 * equilateral.energy - cell) < 1e-14, "energy of a lattice ", 2 * equilateral.energy, ", not ", cell);
  for(double m : equilateral.mass)
    check::that(std::abs(m - area / 3) < 1e-15, "parts of an equilateral triangle differ");

  // The closed form for a density of one is what is summed up for any density.
  std::mt19937 random(3);
  std::uniform_real_distribution<double> u(-1, 1);
  for(int n = 0; n < 100; ++n)
  {
    std::vector<Site> sites;
    for(int k = 0; k < 3; ++k)
      sites.push_back({ u(random), u(random), u(random), 0 });
    const Surface_cvt_contribution_3 c({{ 0, 1, 2 }}, sites), d({{ 0, 1, 2 }}, sites, {{ 1, 1, 1 }});
    const double scale = std::abs(c.energy) + c.gradient[0].length() + c.gradient[1].length() + c.gradient[2].length();
    check::that(std::abs(c.energy - d.energy) < 1e-10 * scale, "energies of a facet differ");
    for(int k = 0; k < 3; ++k)
      check::that((c.gradient[k] - d.gradient[k]).length() < 1e-10 * scale && std::abs(c.mass[k] - d.mass[k]) < 1e-10 * scale,
                  "gradients or masses of a facet differ");
  }

  const auto linear = [](double x, double y) { return 1 + 3 * x + 2 * y; };
  for(bool is_graded : { false, true })
  {
    const std::string name = is_graded ? "CVT with density" : "CVT";
    Square square(0.35);
    const auto density = [&](int, const Site& s) { return linear(s.x, s.y); };
    Surface_cvt_objective_3 objective = square.objective(is_graded ? Surface_cvt_objective_3::Density(density)
                                                                   : Surface_cvt_objective_3::Density());
    // The integral of the density times the squared distance from the closest vertex, sampled.
    const int samples = 400;
    double sum = 0;
    for(int i = 0; i < samples; ++i)
      for(int j = 0; j < samples; ++j)
      {
        const double x = (i + 0.5) / samples, y = (j + 0.5) / samples;
        double closest = std::numeric_limits<double>::max();
        for(const Site& s : square.sites)
          closest = (std::min)(closest, (s.x - x) * (s.x - x) + (s.y - y) * (s.y - y));
        sum += closest * (is_graded ? linear(x, y) : 1) / (samples * samples);
      }
    check::that(std::abs(objective.value() - sum) < 1e-3 * sum, name, ": energy ", objective.value(), ", sampled ", sum);

    // All flipped edges considered, the surface is Delaunay and covers the square once.
    const Surface_triangulation_3& surface = objective.surface();
    double covered = 0;
    std::map<std::pair<int, int>, double> opposite;
    for(int f = 0; f < surface.number_of_facets(); ++f)
    {
      const std::array<int, 3>& t = surface.vertices(f);
      const Site &a = square.sites[t[0]], &b = square.sites[t[1]], &c = square.sites[t[2]];
      covered += ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
      for(int k = 0; k < 3; ++k)
        opposite[std::minmax(t[(k + 1) % 3], t[(k + 2) % 3])]
          += angle(square.sites[t[k]], square.sites[t[(k + 1) % 3]], square.sites[t[(k + 2) % 3]]);
    }
    check::that(std::abs(std::abs(covered) - 1) < 1e-12, name, ": facets cover ", covered);
    for(const auto& e : opposite)
      check::that(e.second < 3.14159266, name, ": an edge is not Delaunay");

    const double scale = objective.gradient().cwiseAbs().maxCoeff();
    for(int v = 0; v < static_cast<int>(square.motions.size()); ++v)
    {
      const double error = gradient_error(objective, v, some_tangent(Vector(0, 0, 1), random), 1e-6);
      check::that(error < 1e-6 * scale, name, ": gradient off by ", error, " of ", scale);
    }

    const double before = objective.value();
    Limited_memory_bfgs minimizer;
    for(int n = 0; n < 200 && minimizer.iterate(objective) == Limited_memory_bfgs::STEP_TAKEN; ++n);
    check::that(objective.value() < before, name, ": the energy does not fall");
    check::that(objective.gradient().cwiseAbs().maxCoeff() < 1e-4 * scale, name, ": gradient ",
                objective.gradient().cwiseAbs().maxCoeff(), " left of ", scale);
    if(!is_graded)
    {
      const double optimum = 5 / (18 * std::sqrt(3.)) / (Square::grid * Square::grid);
      check::that(objective.value() > 0.8 * optimum && objective.value() < 1.1 * optimum, name, ": energy ",
                  objective.value(), ", of hexagons ", optimum);
    }
  }
}

// A surface inside a subdomain becomes Delaunay whichever sides its facets are seen from, and no facet is there twice.
static void surface_inside_a_subdomain(std::mt19937& random)
{
  constexpr int size = 20;
  std::uniform_real_distribution<double> u(-0.2, 0.2);
  std::vector<Site> sites;
  std::vector<Boundary_facet> facets;
  const auto add = [&](int a, int b, int c)
  {
    if(random() % 2 == 0)
      std::swap(b, c);
    facets.push_back({ {{ a, b, c }}, {{ 1, 1 }}, 0 });
  };
  for(int i = 0; i <= size; ++i)
    for(int j = 0; j <= size; ++j)
    {
      sites.push_back({ i + u(random), j + 0.8 * i + u(random), 0, 0 });
      const int v = static_cast<int>(sites.size()) - 1, below = v - size - 1;
      if(i == 0 || j == 0)
        continue;
      add(below - 1, below, v);
      add(below - 1, v, v - 1);
    }
  Surface_triangulation_3 surface{ Boundary_complex_3(facets, sites.size()) };
  surface.make_delaunay(sites);
  std::map<std::array<int, 2>, std::vector<double> > angles;      // opposite to edges
  std::set<Triple> triangles;
  for(int f = 0; f < surface.number_of_facets(); ++f)
  {
    const std::array<int, 3>& t = surface.vertices(f);
    triangles.insert(sorted(t));
    for(int k = 0; k < 3; ++k)
      angles[sorted(std::array<int, 2>{{ t[(k + 1) % 3], t[(k + 2) % 3] }})].push_back(
        angle(sites[t[k]], sites[t[(k + 1) % 3]], sites[t[(k + 2) % 3]]));
  }
  check::that(triangles.size() == facets.size(), facets.size() - triangles.size(), " of ", facets.size(), " facets are there twice");
  for(const auto& a : angles)
    check::that(a.second.size() <= 2 && (a.second.size() < 2 || a.second[0] + a.second[1] < std::acos(-1.) + 1e-6),
                "edge ", a.first[0], " ", a.first[1], " has ", a.second.size(), " facets, or is not Delaunay");
}

// A sphere of triangles around the axis through two poles: vertices 0 and 1 and a ring.
static std::vector<Boundary_facet> double_cone(int ring, int first, int south, int north)
{
  std::vector<Boundary_facet> facets;
  for(int n = 0; n < ring; ++n)
  {
    const int a = first + n, b = first + (n + 1) % ring;
    facets.push_back({ {{ a, b, north }}, {{ 0, 1 }}, 0 });
    facets.push_back({ {{ b, a, south }}, {{ 0, 1 }}, 0 });
  }
  return facets;
}

static void topology_guard()
{
  const std::size_t vertices = 20;
  const std::vector<Boundary_facet> one = double_cone(6, 2, 0, 1), other = double_cone(4, 12, 10, 11);
  std::vector<Boundary_facet> both = one;
  both.insert(both.end(), other.begin(), other.end());
  const Boundary_complex_3 before(both, vertices);
  check::that(before.junctions().empty(), "a closed surface has no junctions");
  check::that(before.facets_and_components().at(0) == std::make_pair(both.size(), std::size_t(2)), "facets or components miscounted");
  check::that(topology_changes(before, before).empty(), "a complex differs from itself");
  for(int v : { 0, 1, 2, 11, 15 })
    check::that(before.number_of_umbrellas(v) == 1 && before.umbrella(v, 0).is_disk, "vertex ", v, " is not inside a disk");
  check::that(!before.has_facets(9), "vertex 9 is on no surface");

  const auto differs = [&](const char* what, const std::vector<Boundary_facet>& facets, const std::set<int>& at_least)
  {
    const std::set<int> found = topology_changes(before, Boundary_complex_3(facets, vertices));
    check::that(!found.empty(), what, ": not noticed");
    for(int v : at_least)
      check::that(found.count(v) > 0, what, ": vertex ", v, " not noticed");
  };
  {
    // Edge (2, 3) between the two poles' facets becomes (0, 1), which the other facets go around.
    std::vector<Boundary_facet> flipped = both;
    flipped[0].vertices = {{ 2, 0, 1 }};
    flipped[1].vertices = {{ 0, 3, 1 }};
    const Boundary_complex_3 after(flipped, vertices);
    check::that(topology_changes(before, after).empty(), "a flip changes no topology");
    check::that(exchanged_facets(before, after).size() == 4, "a flip exchanges two facets for two");
  }
  {
    std::vector<Boundary_facet> hole(both.begin() + 1, both.end());
    differs("hole", hole, { 1, 2, 3 });
  }
  {
    std::vector<Boundary_facet> patch = both;
    patch[0].patch = 1;
    differs("other patch", patch, { 1, 2, 3 });
  }
  {
    std::vector<Boundary_facet> label = both;
    label[0].labels = {{ 0, 2 }};
    differs("other subdomain", label, { 1, 2, 3 });
  }
  {
    // Two facets opened and the holes joined by a tube: no junction, but one component and a handle.
    std::vector<Boundary_facet> tube(both.begin() + 1, both.end() - 1);
    const std::array<int, 3> a = both.front().vertices, b = both.back().vertices;
    for(int k = 0; k < 3; ++k)
    {
      const int l = (k + 1) % 3;
      tube.push_back({ {{ a[k], a[l], b[(3 - k) % 3] }}, {{ 0, 1 }}, 0 });
      tube.push_back({ {{ a[l], b[(3 - l) % 3], b[(3 - k) % 3] }}, {{ 0, 1 }}, 0 });
    }
    differs("two components joined by a tube", tube, std::set<int>(a.begin(), a.end()));
  }
  {
    // A pole of one surface where the other has its own: they touch in a vertex.
    std::vector<Boundary_facet> touching = both;
    for(Boundary_facet& f : touching)
      for(int& v : f.vertices)
        v = v == 11 ? 1 : v;
    differs("touching in a vertex", touching, { 1 });
  }
  {
    // Between the poles is an edge where two other surfaces meet: the flip that was harmless touches them along it.
    std::vector<Boundary_facet> wings = { { {{ 0, 1, 17 }}, {{ 0, 1 }}, 3 }, { {{ 1, 0, 18 }}, {{ 0, 1 }}, 4 } };
    std::vector<Boundary_facet> pinched = wings;
    wings.insert(wings.end(), one.begin(), one.end());
    pinched.insert(pinched.end(), one.begin(), one.end());
    pinched[2].vertices = {{ 2, 0, 1 }};
    pinched[3].vertices = {{ 0, 3, 1 }};
    const Boundary_complex_3 apart(wings, vertices), touching(pinched, vertices);
    const std::set<int> poles = { 0, 1 };
    check::that(topology_changes(apart, touching) == poles, "touching along a junction: not noticed");

    Exchangeable_boundary_3 boundary(apart);
    const auto number = [&boundary](const Boundary_facet& f) { return boundary.find(sorted(f.vertices)); };
    const auto exchanged = [](const Boundary_facet& f)
    { return Exchangeable_boundary_3::Facet{ sorted(f.vertices), sorted(f.labels), f.patch }; };
    check::that(!boundary.keeps_topology({ number(wings[2]), number(wings[3]) }, { exchanged(pinched[2]), exchanged(pinched[3]) }),
                "an exchange of facets that touch along a junction is permitted");
    Exchangeable_boundary_3 alone(Boundary_complex_3(one, vertices));
    const auto number_alone = [&alone](const Boundary_facet& f) { return alone.find(sorted(f.vertices)); };
    check::that(alone.keeps_topology({ number_alone(one[0]), number_alone(one[1]) }, { exchanged(pinched[2]), exchanged(pinched[3]) }),
                "an exchange of facets for the two others is not permitted");
  }
}

// Facets whose vertices are on one line or at one place add nothing, and make nothing infinite.
static void facets_without_area()
{
  const std::vector<Site> sites = { { 0, 0, 0, 0 }, { 1, 0, 0, 0 }, { 2, 0, 0, 0 }, { 1, 1, 0, 0 }, { 1, 1, 0, 0 } };
  const Boundary_facet flat = { {{ 0, 1, 2 }}, {{ 0, 1 }}, 0 };
  const Boundary_facet whole = { {{ 0, 3, 1 }}, {{ 0, 1 }}, 0 };
  const auto boundary = [&](std::vector<Boundary_facet> facets) { return Boundary_complex_3(std::move(facets), sites.size(), Thread_policy()); };
  for(bool has_densities : { false, true })
  {
    const std::vector<double> densities = has_densities ? std::vector<double>(sites.size(), 2.) : std::vector<double>();
    const auto energy = [&](const std::vector<Boundary_facet>& facets, Eigen::VectorXd& gradient)
    {
      Eigen::VectorXd diagonal = gradient = Eigen::VectorXd::Zero(3 * sites.size());
      return Surface_cvt_energy_3().compute(Surface_triangulation_3(boundary(facets)), sites, densities, 0, gradient, diagonal);
    };
    Eigen::VectorXd gradient, gradient_of_whole;
    check::that(energy({ flat }, gradient) == 0 && gradient.isZero(0), "a flat facet has energy");
    const double expected = energy({ whole }, gradient_of_whole);
    check::that(expected > 0 && energy({ whole, flat }, gradient) == expected && gradient == gradient_of_whole,
                "a flat facet changes the energy of others");
  }
  Surface_cvt_term_3 term(0, static_cast<int>(sites.size()), 1, Surface_density());
  term.follow(boundary({ flat }), sites);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(3 * sites.size()), diagonal = Eigen::VectorXd::Ones(3 * sites.size());
  const double energy = term(sites, gradient, diagonal);
  check::that(std::isfinite(energy) && gradient.allFinite() && diagonal.allFinite(), "surfaces without area have no weight");
}

int main()
{
  facets_without_area();
  odt_energy_on_sphere_and_plane();
  cvt_energy();
  topology_guard();
  std::mt19937 random(6);
  surface_inside_a_subdomain(random);
  return check::result();
}
