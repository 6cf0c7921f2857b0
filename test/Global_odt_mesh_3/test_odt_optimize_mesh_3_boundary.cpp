// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// On difficult boundaries - thin, touching, branching, sharp, strongly bent - and with
// domains that fail or throw, odt_optimize_mesh_3() and remesh_boundary_mesh_3() keep
// what they promise.

#include "kept_facets.h"
#include "mesh_contract.h"
#include "mesh_domains.h"
#include "opened_complex.h"

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_updater_3.h>
#include <CGAL/Global_odt_mesh_3/internal/complex/Surface_centers_3.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Mesh_domain_view_3.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Mesh_optimization_report_3.h>
#include <CGAL/Mesh_quality_report_3.h>
#include <CGAL/Random.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/number_type_config.h>
#include <CGAL/odt_optimize_mesh_3.h>
#include <CGAL/remesh_boundary_mesh_3.h>
#include <CGAL/tags.h>
#include <CGAL/version.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#if CGAL_VERSION_NR < 1060000000
#  include <boost/optional.hpp>
#else
#  include <optional>
#endif

namespace params = CGAL::parameters;
using domains::FT;
using domains::Point_3;

// How far points of surfaces are from them, over the size of the mesh.
static constexpr double surface = 4e-3;

// Gives the optimized and the remeshed mesh.
template <class C3t3, class Domain>
std::array<C3t3, 2> test(const std::string& name, const C3t3& input, const Domain& domain, double facet_angle = 30,
                         double share_of_layer = 0.03)
{
  const Mesh_contract<C3t3, Domain> contract(input, domain, name);
  std::array<C3t3, 2> results{{ input, input }};
  CGAL::odt_optimize_mesh_3(results[0], domain);
  contract.check_moved(results[0], surface, facet_angle, share_of_layer);
  CGAL::remesh_boundary_mesh_3(results[1], domain);
  contract.check_moved(results[1], surface, facet_angle, share_of_layer);

  const double before = CGAL::mesh_quality_report_3(input).mean_radius_ratio;
  const double after = CGAL::mesh_quality_report_3(results[0]).mean_radius_ratio;
  check::that(after >= before, name, ": mean radius ratio ", before, " -> ", after);
  std::cout << name << ": " << input.triangulation().number_of_vertices() << " vertices, "
            << contract.number_of_interior_vertices() << " inside, mean radius ratio " << before << " -> " << after
            << std::endl;
  return results;
}


// Nearly all vertices are on two sheets that are closer than the facets are large: no vertex
// may be projected to the other sheet.
static void plate()
{
  for(double half : { 0.07, 0.06, 0.05 })
  {
    const domains::Labeled_domain domain = domains::labeled([half](const Point_3& p)
    { return std::abs(p.x()) < 1 && std::abs(p.y()) < 0.9 && std::abs(p.z()) < half ? 1 : 0; });
    const domains::Labeled_c3t3 mesh = domains::mesh(domain, 0.2);
    std::ostringstream name;
    name << "plate of thickness " << 2 * half;
    test(name.str(), mesh, domain);
  }
}

// Where the mesh is too coarse for the surface, dual lines of facets may miss it. In the end, all facets have centers.
static void facets_without_centers()
{
  const domains::Labeled_domain domain = domains::labeled([](const Point_3& p)
  { return std::abs(p.x()) < 0.9 && std::abs(p.y()) < 0.8 && std::abs(p.z()) < 0.05 ? 1 : 0; });
  const double size = 0.5;
  const domains::Labeled_criteria criteria(params::facet_angle = 20, params::facet_size = size,
                                           params::facet_distance = size / 3, params::cell_radius_edge_ratio = 3,
                                           params::cell_size = size);
  CGAL::get_default_random() = CGAL::Random(7);
  domains::Labeled_c3t3 c3t3
    = CGAL::make_mesh_3<domains::Labeled_c3t3>(domain, criteria, params::no_exude(), params::no_perturb());
  const Mesh_contract<domains::Labeled_c3t3, domains::Labeled_domain> contract(c3t3, domain, "coarse plate");
  CGAL::odt_optimize_mesh_3(c3t3, domain);
  // The mesh has a sixtieth of the plate's volume, so that its volume means little.
  contract.check_moved(c3t3, 1e-2, 30, 0.15);
}

// Surfaces closer than the mesh size, or crossing, are to be neither joined nor parted.
static void touching()
{
  for(int label : { 2, 1 })
    for(double gap : { 0.003, 0., -0.01 })
    {
      const domains::Labeled_domain domain = domains::labeled([gap, label](const Point_3& p)
      {
        const Point_3 from_center(p.x(), p.y(), p.z() - 0.5 - gap);
        return domains::squared(from_center) < 0.25 ? label
               : p.z() < 0 && p.z() > -0.4 && std::abs(p.x()) < 0.8 && std::abs(p.y()) < 0.7 ? 1 : 0;
      });
      std::ostringstream name;
      name << "ball and slab of labels " << label << " and 1, gap " << gap;
      test(name.str(), domains::mesh(domain, 0.16), domain);
    }
}

// Where three subdomains meet in a curve, and where four and eight meet in a point, patches keep their junctions.
static void junctions()
{
  const auto in_ball = [](const std::function<int(const Point_3&)>& label)
  { return domains::labeled([label](const Point_3& p) { return domains::squared(p) < 1 ? label(p) : 0; }); };
  const domains::Labeled_domain
    sectors = in_ball([](const Point_3& p) { return p.x() > 0.01 ? 1 : p.y() > 0.02 ? 2 : 3; }),
    four = in_ball([](const Point_3& p) { return p.z() > 0.013 ? 4 : p.x() > 0.01 ? 1 : p.y() > 0.02 ? 2 : 3; }),
    octants = in_ball([](const Point_3& p)
                      { return 1 + (p.x() > 0.01 ? 1 : 0) + (p.y() > 0.02 ? 2 : 0) + (p.z() > 0.013 ? 4 : 0); });
  test("three sectors of a ball", domains::mesh(sectors, 0.25), sectors);
  test("four parts of a ball", domains::mesh(four, 0.25), four);
  test("octants of a ball", domains::mesh(octants, 0.25), octants, 24);       // where eight parts meet, facets may lose a degree
}

// A box with a tiny notch in one corner.
static domains::Polyhedron slightly_notched_box()
{
  domains::Polyhedron box = domains::notched_box();
  const auto outward = [](FT x) { return x == 1 ? FT(1.8) : x; };
  for(auto p = box.points_begin(); p != box.points_end(); ++p)
    *p = Point_3(outward(p->x()), outward(p->y()), outward(p->z()));
  return box;
}

// Two faces at an angle of 14 degrees.
static domains::Polyhedron wedge()
{
  std::istringstream in("OFF\n6 8 0\n"
                        "0 0 0\n2 0 0\n2 0 0.5\n0 1.5 0\n2 1.5 0\n2 1.5 0.5\n"
                        "3 0 1 2\n3 3 5 4\n3 0 3 4\n3 0 4 1\n3 1 4 5\n3 1 5 2\n3 0 2 5\n3 0 5 3\n");
  domains::Polyhedron p;
  in >> p;
  return p;
}

// Vertices that slide near touching protecting balls must not hide, nor be hidden by them.
static void features()
{
  const auto test_features = [](const char* name, const domains::Polyhedron& polyhedron, double size, double share_of_layer)
  {
    domains::Polyhedral_domain domain(polyhedron);
    domain.detect_features();
    const domains::Polyhedral_c3t3 mesh = domains::mesh(domain, size, true);
    check::that(mesh.number_of_edges_in_complex() > 0, name, ": no features");
    test(name, mesh, domain, 30, share_of_layer);
  };
  test_features("notched box with features", domains::notched_box(), 0.3, 1e-9);
  test_features("slightly notched box with features", slightly_notched_box(), 0.4, 1e-9);
  // Some cells along the thin edge are outside, for the mesher and after.
  test_features("wedge with features", wedge(), 0.2, 1e-3);
}

// The unit sphere, of many triangles.
static domains::Polyhedron sphere()
{
  constexpr int rings = 24, sectors = 48;
  std::ostringstream points, facets;
  points << "0 0 1\n";
  for(int r = 1; r < rings; ++r)
    for(int s = 0; s < sectors; ++s)
    {
      const double a = CGAL_PI * r / rings, b = 2 * CGAL_PI * s / sectors;
      points << std::sin(a) * std::cos(b) << ' ' << std::sin(a) * std::sin(b) << ' ' << std::cos(a) << '\n';
    }
  points << "0 0 -1\n";
  const int last = 1 + (rings - 1) * sectors;
  for(int s = 0; s < sectors; ++s)
  {
    const int next = (s + 1) % sectors;
    facets << "3 0 " << 1 + s << ' ' << 1 + next << "\n3 " << last << ' ' << last - sectors + next << ' ' << last - sectors + s << '\n';
    for(int first = 1; first + sectors < last; first += sectors)
      facets << "3 " << first + s << ' ' << first + sectors + s << ' ' << first + next << "\n3 " << first + next << ' '
             << first + sectors + s << ' ' << first + sectors + next << '\n';
  }
  std::istringstream in("OFF\n" + std::to_string(last + 1) + " " + std::to_string(2 * sectors * (rings - 1)) + " 0\n" + points.str()
                        + facets.str());
  domains::Polyhedron p;
  in >> p;
  return p;
}

// Facets that are not of slivers are no farther from the surface than the farthest of the input, or than they may be.
static void distances()
{
  const domains::Polyhedral_domain domain(sphere());
  const domains::Polyhedral_c3t3 input = domains::mesh(domain, 0.4, false);
  const double farthest_of_input = kept_facets::farthest_centroid(input, domain);
  const double angle = CGAL::mesh_quality_report_3(input).smallest_angle;
  for(double share : { 0., 0.5, 1.2, 2. })
    for(unsigned int seed = 0; seed < 3; ++seed)
    {
      const double distance = share * farthest_of_input, bound = (std::max)(farthest_of_input, distance) + 1e-12;
      const std::string name = "polyhedral sphere, facet_distance " + std::to_string(distance) + ", seed " + std::to_string(seed);
      domains::Polyhedral_c3t3 c3t3(input);
      CGAL::Mesh_optimization_report_3<domains::Polyhedral_c3t3> report;
      CGAL::odt_optimize_mesh_3(c3t3, domain, params::facet_distance = distance, params::random_seed(seed),
                                params::optimization_report = std::ref(report));
      const double farthest = kept_facets::farthest_centroid(c3t3, domain), angle_now = CGAL::mesh_quality_report_3(c3t3).smallest_angle;
      std::cout << name << ": farthest facet " << farthest_of_input << " -> " << farthest << ", smallest angle " << angle << " -> " << angle_now
                << std::endl;
      check::that(report.is_changed(), name, ": unchanged");
      check::that(angle_now > 20 && farthest <= bound, name, ": a facet is ", farthest, " from the surface, and not ", bound);
      check::that(std::abs(report.farthest_facet - farthest) <= 1e-12, name, ": the report says ", report.farthest_facet, ", not ", farthest);
      check::that(angle_now >= (std::min)(angle, 30.), name, ": the smallest angle falls from ", angle, " to ", angle_now);
      check::that(kept_facets::is_regular(c3t3.triangulation()), name, ": no regular triangulation");
    }
}

// Strong curvature over few vertices, and edges and corners that are no features: tangential
// planes lead far from the surface. Volumes depend on where the few vertices are.
static void bent()
{
  const domains::Labeled_domain
    cylinder = domains::labeled([](const Point_3& p)
                                { return p.x() * p.x() + p.y() * p.y() < 0.06 && std::abs(p.z()) < 1.1 ? 1 : 0; }),
    tetrahedron = domains::labeled([](const Point_3& p)
    {
      const FT x = p.x(), y = p.y(), z = p.z();
      return (std::max)({ x + y + z, x - y - z, -x + y - z, -x - y + z }) < 0.6 ? 1 : 0;
    });
  test("cylinder", domains::mesh(cylinder, 0.3), cylinder);
  test("tetrahedron", domains::mesh(tetrahedron, 0.35), tetrahedron);
}

// That of the concept depends on the version of CGAL.
#if CGAL_VERSION_NR < 1060000000
template <class T> using Optional = boost::optional<T>;
#else
template <class T> using Optional = std::optional<T>;
#endif

// What an analytic domain was asked, and where it fails.
struct Questions
{
  enum Kind { IS_IN_DOMAIN, DO_INTERSECT_SURFACE, CONSTRUCT_INTERSECTION };
  std::array<long, 3> asked{};
  std::array<long, 3> throws_at{{ -1, -1, -1 }};
  long misses_of_dozen = 0;   // so many intersections in a row are missed, as the first may be tried again
  double blind_radius = 0;    // around the point where no intersection is found

  void ask(Kind kind)
  {
    if(asked[kind]++ == throws_at[kind])
      throw std::runtime_error("the domain fails");
  }
};

// A ball in an ellipsoid, as the concept MeshDomain_3 has it and no more: there is no AABB
// tree, and indices of patches can be compared for equality only. Other than those of
// labeled domains, its segments intersect also where both ends are on one side.
class Ellipsoid_domain
{
public:
  typedef domains::Kernel R;
  typedef R::FT FT;
  typedef R::Point_3 Point_3;
  typedef R::Vector_3 Vector_3;
  typedef R::Segment_3 Segment_3;
  typedef R::Ray_3 Ray_3;
  typedef R::Line_3 Line_3;
  typedef CGAL::Tag_false Has_features;

  struct Surface_patch_index
  {
    int quadric = -1;
    bool operator==(const Surface_patch_index& other) const { return quadric == other.quadric; }
    bool operator!=(const Surface_patch_index& other) const { return quadric != other.quadric; }
    friend std::ostream& operator<<(std::ostream& out, const Surface_patch_index& i) { return out << i.quadric; }
  };
  // The order and the way from subdomains are for the contract.
  struct Index
  {
    int dimension = 0, number = 0;
    Index() = default;
    explicit Index(int subdomain) : Index(3, subdomain) {}
    Index(int dimension, int number) : dimension(dimension), number(number) {}
    bool operator==(const Index& i) const { return dimension == i.dimension && number == i.number; }
    bool operator<(const Index& i) const { return std::tie(dimension, number) < std::tie(i.dimension, i.number); }
  };
  typedef int Subdomain_index;
  typedef Optional<Subdomain_index> Subdomain;
  typedef Optional<Surface_patch_index> Surface_patch;
  typedef std::tuple<Point_3, Index, int> Intersection;

  struct Construct_initial_points
  {
    const Ellipsoid_domain& domain;

    // Along a spiral on each surface.
    template <class OutputIterator>
    OutputIterator operator()(OutputIterator points, int n = 24) const
    {
      for(int k = 0; k < n; ++k)
      {
        const int quadric = k % 2;
        const double z = (2 * k + 1.) / n - 1, r = std::sqrt(1 - z * z);
        const std::array<double, 3>& axes = domain.axes[quadric];
        const Point_3 p(axes[0] * r * std::cos(2.4 * k), axes[1] * r * std::sin(2.4 * k), axes[2] * z);
        *points++ = std::make_pair(p, Index(2, quadric));
      }
      return points;
    }
  };

  struct Is_in_domain
  {
    const Ellipsoid_domain& domain;

    Subdomain operator()(const Point_3& p) const
    {
      domain.questions.ask(Questions::IS_IN_DOMAIN);
      const int around = (domain.equation(0, p - CGAL::ORIGIN) < 1) + (domain.equation(1, p - CGAL::ORIGIN) < 1);
      return around == 0 ? Subdomain() : Subdomain(around);     // 2 is the ball
    }
  };

  struct Do_intersect_surface
  {
    const Ellipsoid_domain& domain;

    template <class Query>
    Surface_patch operator()(const Query& query) const
    {
      domain.questions.ask(Questions::DO_INTERSECT_SURFACE);
      const Intersection i = domain.intersection(query);
      return std::get<2>(i) == 0 ? Surface_patch() : Surface_patch(domain.surface_patch_index(std::get<1>(i)));
    }
  };

  struct Construct_intersection
  {
    const Ellipsoid_domain& domain;

    template <class Query>
    Intersection operator()(const Query& query) const
    {
      Questions& questions = domain.questions;
      questions.ask(Questions::CONSTRUCT_INTERSECTION);
      const Intersection found = domain.intersection(query);
      const bool is_missed = questions.asked[Questions::CONSTRUCT_INTERSECTION] % 12 < questions.misses_of_dozen
                             || CGAL::squared_distance(std::get<0>(found), Point_3(1, 0, 0)) < CGAL::square(questions.blind_radius);
      return is_missed ? Intersection() : found;
    }
  };

  Construct_initial_points construct_initial_points_object() const { return { *this }; }
  Is_in_domain is_in_domain_object() const { return { *this }; }
  Do_intersect_surface do_intersect_surface_object() const { return { *this }; }
  Construct_intersection construct_intersection_object() const { return { *this }; }

  Index index_from_surface_patch_index(const Surface_patch_index& i) const { return { 2, i.quadric }; }
  Index index_from_subdomain_index(const Subdomain_index& i) const { return { 3, i }; }
  Surface_patch_index surface_patch_index(const Index& i) const { return { i.number }; }
  Subdomain_index subdomain_index(const Index& i) const { return i.number; }
  CGAL::Bbox_3 bbox() const { return CGAL::Bbox_3(-1, -0.8, -0.7, 1, 0.8, 0.7); }

  mutable Questions questions;

private:
  // 1 on the surface.
  FT equation(int quadric, const Vector_3& v) const { return product(quadric, v, v); }

  FT product(int quadric, const Vector_3& v, const Vector_3& w) const
  {
    FT sum = 0;
    for(int k = 0; k < 3; ++k)
      sum += v[k] * w[k] / CGAL::square(axes[quadric][k]);
    return sum;
  }

  Intersection intersection(const Segment_3& s) const { return intersection(s.source(), s.to_vector(), 0, 1); }
  Intersection intersection(const Ray_3& r) const { return intersection(r.source(), r.to_vector(), 0, infinity); }
  Intersection intersection(const Line_3& l) const
  {
    return intersection(l.point(), l.to_vector(), -infinity, infinity);
  }

  // The first of the points p + t v with t from `lo` to `hi`.
  Intersection intersection(const Point_3& p, const Vector_3& v, FT lo, FT hi) const
  {
    Intersection first;
    for(int quadric : { 0, 1 })
    {
      const FT a = product(quadric, v, v), b = product(quadric, v, p - CGAL::ORIGIN),
               c = equation(quadric, p - CGAL::ORIGIN) - 1, discriminant = b * b - a * c;
      if(a == 0 || discriminant < 0)
        continue;
      for(FT t : { (-b - std::sqrt(discriminant)) / a, (-b + std::sqrt(discriminant)) / a })
        if(lo <= t && t <= hi)
        {
          hi = t;
          first = Intersection(p + t * v, Index(2, quadric), 2);
        }
    }
    return first;
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::array<std::array<double, 3>, 2> axes{{ {{ 1, 0.8, 0.7 }}, {{ 0.35, 0.35, 0.35 }} }};
};

typedef CGAL::Mesh_triangulation_3<Ellipsoid_domain>::type Ellipsoid_triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Ellipsoid_triangulation> Ellipsoid_c3t3;

// The ball has few facets.

static Ellipsoid_c3t3 mesh(const Ellipsoid_domain& domain, double size)
{
  CGAL::Mesh_criteria_3<Ellipsoid_triangulation> criteria(
    params::facet_angle = 25, params::facet_size = size, params::facet_distance = size / 4,
    params::cell_radius_edge_ratio = 2.5, params::cell_size = size);
  return CGAL::make_mesh_3<Ellipsoid_c3t3>(domain, criteria, params::no_exude(), params::no_perturb());
}

static std::set<Point_3> surface_points(const Ellipsoid_c3t3& c3t3)
{
  std::set<Point_3> points;
  const auto& tr = c3t3.triangulation();
  for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
    if(v->in_dimension() == 2)
      points.insert(v->point().point());
  return points;
}

// Vertices whose way to the surface is not found stay on it where they are.
static void missed_intersections(const Ellipsoid_domain& domain, const Ellipsoid_c3t3& input)
{
  for(long misses : { 1, 4, 12 })
  {
    domain.questions = Questions();
    domain.questions.misses_of_dozen = misses;
    const auto results = test(std::to_string(misses) + " of 12 intersections missed", input, domain);
    check::that(domain.questions.asked[Questions::CONSTRUCT_INTERSECTION] >= 12, "no intersection was missed");
    domain.questions = Questions();
    for(const Ellipsoid_c3t3& c3t3 : results)
      check::that(misses < 12 || surface_points(c3t3) == surface_points(input), "vertices moved off a surface not found");
  }
}

namespace odt = CGAL::Global_odt_mesh_3::internal;

// A complex, and a candidate of which no vertex has moved.
struct Candidate_at_rest
  : odt::Opened_complex<Ellipsoid_c3t3, Ellipsoid_domain>
{
  std::unique_ptr<odt::Complex_candidate_3> candidate;

  Candidate_at_rest(const Ellipsoid_domain& of, const Ellipsoid_c3t3& from)
    : Opened_complex(from, of, true)
  {
    const odt::Complex_snapshot_3& snapshot = complex.snapshot();
    candidate = std::make_unique<odt::Complex_candidate_3>(snapshot, snapshot.sites(), true, true, odt::Thread_policy());
    candidate->build(nullptr);
  }
};

// If something is wrong although all vertices are at home, those at it or else around it go to their places in the input; and
// the candidate is beyond repair only when that has been done to all around.
static void homes_are_given_up(const Ellipsoid_domain& domain, const Ellipsoid_c3t3& input)
{
  Candidate_at_rest at_rest(domain, input);
  odt::Complex_candidate_3& candidate = *at_rest.candidate;
  const std::array<int, 3> facet = candidate.snapshot.boundary.complex().facets().front().vertices;
  const auto reported = [&]
  {
    odt::Defect_report_3 report(candidate);
    report.revert(facet);
    check::that(!report.is_clean(), "nothing is wrong");
    check::that(report.is_beyond_repair() == report.offending_vertices().empty(), "vertices go back that need not");
    return report.offending_vertices();
  };
  check::that(reported().empty(), "vertices that are where they were in the input go back");

  // As if the snapshot were not the input: all are at home, and none is where it was in the input.
  const auto move = [&](int v) { candidate.sites[v].x += 1e-3; };
  for(int v = 0; v < candidate.numbering.number_of_movable_vertices; ++v)
  {
    move(v);
    candidate.revert_sites[v] = candidate.sites[v];
  }
  std::set<int> vertices(facet.begin(), facet.end());
  check::that(reported() == vertices, "others than those of the facet go to the input first");
  // What is not at home goes first.
  move(facet[1]);
  check::that(reported() == std::set<int>{ facet[1] }, "a vertex that is at home goes back before one that is not");
  candidate.sites[facet[1]] = candidate.revert_sites[facet[1]];
  int times = 0;
  for(std::set<int> next; !(next = reported()).empty(); ++times)
    for(int v : next)
    {
      check::that(candidate.is_reverted(v) && !candidate.is_at_input(v), "a vertex goes to the input twice");
      candidate.revert_to_input(v);
      candidate.sites[v] = candidate.revert_sites[v];
      check::that(candidate.is_reverted(v) && candidate.is_at_input(v), "a home that is given up is not in the input");
    }
  check::that(1 < times && times < 10, "rings of vertices go to the input ", times, " times");
}

// A facet for which the domain finds no surface center has none, until it does.
static void missed_surface_centers(const Ellipsoid_domain& domain, const Ellipsoid_c3t3& input)
{
  Candidate_at_rest at_rest(domain, input);
  const odt::Complex_snapshot_3& snapshot = at_rest.complex.snapshot();
  // One between finite cells.
  const odt::Labelled_triangulation_3& tr = snapshot.triangulation;
  const odt::Surface_center_search_3 search(tr, at_rest.domain);
  const std::vector<odt::Half_facet> facets = odt::find_boundary_facets(snapshot, odt::Thread_policy());
  const auto is_inside = [&](odt::Half_facet f) { return !tr.is_infinite(f.cell()) && !tr.is_infinite(tr.mirror(f).cell()); };
  const std::size_t facet = std::find_if(facets.begin(), facets.end(), is_inside) - facets.begin();
  check::that(facet < facets.size(), "there is no facet between finite cells");
  const auto& vertices = snapshot.boundary.complex().facets()[facet].vertices;
  for(long misses : { 12, 0 })
  {
    domain.questions = Questions();
    domain.questions.misses_of_dozen = misses;
    odt::Complex_candidate_3::Surface_center center = snapshot.centers[facet];
    center.is_exact = true;
    search.search(facets[facet], vertices, center);
    check::that(center.is_exact == (misses == 0), "a surface center that is missed is found, or one that is not missed is not");
    check::that(domain.questions.asked[Questions::CONSTRUCT_INTERSECTION] > 0, "the domain is not asked for a surface center");
  }
  domain.questions = Questions();
}

// Where the domain finds no surface centers, no facets come; vertices are inserted everywhere else.
static void blind_spot(const Ellipsoid_domain& domain, const Ellipsoid_c3t3& input)
{
  const auto vertices_by_radius = [&](double blind_radius)
  {
    Mesh_contract<Ellipsoid_c3t3, Ellipsoid_domain> contract(input, domain, "blind spot");
    contract.permit(true, true);
    Ellipsoid_c3t3 c3t3(input);
    domain.questions.blind_radius = blind_radius;
    CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_insert_vertices = true, params::do_remove_vertices = true,
                              params::sizing_field = 0.1, params::number_of_rounds = 0);
    domain.questions = Questions();
    contract.check_moved(c3t3, surface, 15, 0.3);
    return c3t3.triangulation().number_of_vertices();
  };
  const std::size_t all = vertices_by_radius(0), some = vertices_by_radius(0.2);
  std::cout << "vertices " << input.triangulation().number_of_vertices() << " -> " << all << ", with a blind spot " << some << std::endl;
  check::that(5 * some > 4 * all, "a blind spot leaves ", some, " of ", all, " vertices");
}

// Whatever the domain was asked when it threw, the mesh is as before.
static void exceptions(const Ellipsoid_domain& domain, const Ellipsoid_c3t3& input)
{
  const Mesh_contract<Ellipsoid_c3t3, Ellipsoid_domain> contract(input, domain, "exceptions");
  const auto call = [&](bool remeshes, Ellipsoid_c3t3& c3t3)
  {
    if(remeshes)
      CGAL::remesh_boundary_mesh_3(c3t3, domain);
    else
      CGAL::odt_optimize_mesh_3(c3t3, domain);
  };
  for(bool remeshes : { false, true })
  {
    domain.questions = Questions();
    Ellipsoid_c3t3 complete(input);
    call(remeshes, complete);
    const std::array<long, 3> asked = domain.questions.asked;
    check::that(asked[0] > 0 && asked[2] > 0, "the domain was not asked");
    for(int kind = 0; kind < 3; ++kind)
    {
      // Where Mesh_3 no longer asks the predicate, neither do we.
      if(asked[kind] == 0)
        continue;
      for(long n : { 0L, asked[kind] / 3, asked[kind] - 1 })
      {
        Ellipsoid_c3t3 c3t3(input);
        bool thrown = false;
        domain.questions = Questions();
        domain.questions.throws_at[kind] = n;
        try { call(remeshes, c3t3); }
        catch(const std::runtime_error&) { thrown = true; }
        domain.questions = Questions();
        check::that(thrown, "the domain did not throw at question ", n, " of kind ", kind);
        contract.check_untouched(c3t3);
      }
    }
  }
}

// Where a point is projected, out of reach, onto another patch, or by a domain that misses all
// intersections, it stays where it is.
template <class Domain>
static void projection(const char* name, const Domain& domain, const Point_3& from, const Point_3& expected,
                       double tolerance)
{
  typedef odt::Vector_3 Vector;
  odt::Mesh_domain_view_3<Domain> view(domain);
  const double distance = std::sqrt(CGAL::squared_distance(from, expected));
  const Vector start(from.x(), from.y(), from.z());
  const Vector normal = (start - Vector(expected.x(), expected.y(), expected.z())) / distance;
  Vector p = start;
  int found;
  check::that(view.intersect(p, normal, 2 * distance, found), name, ": no surface found");
  check::that(found == odt::Domain_view_3::other_patch, name, ": a patch that no mesh has is known");
  typedef typename CGAL::Kernel_traits<Point_3>::Kernel::Segment_3 Segment_3;
  const Vector beyond = start - 2 * distance * normal;
  const auto intersection = domain.construct_intersection_object()(Segment_3(from, Point_3(beyond[0], beyond[1], beyond[2])));
  const int patch = view.number_patch(domain.surface_patch_index(std::get<1>(intersection)));
  p = start;
  check::that(view.intersect(p, normal, 2 * distance, found) && found == patch, name, ": another patch");
  const auto project = [&](double reach, int onto)
  {
    p = start;
    return view.project(p, normal, reach, onto);
  };
  check::that(project(2 * distance, patch), name, ": not projected");
  check::that(CGAL::squared_distance(Point_3(p[0], p[1], p[2]), expected) <= tolerance * tolerance, name,
              ": projected to ", p[0], ' ', p[1], ' ', p[2]);
  check::that(!project(0.9 * distance, patch) && p == start, name, ": projected out of reach");
  check::that(!project(2 * distance, view.number_patch(typename Domain::Surface_patch_index())) && p == start, name,
              ": projected onto another patch");
  // Between the dual points of cospherical cells, there is no segment that a domain could be asked for.
  const Vector on_surface(expected.x(), expected.y(), expected.z());
  p = on_surface;
  check::that(!view.intersect(p, normal, 0, found) && p == on_surface, name, ": a point is taken for a segment");
}

static void projection()
{
  projection("implicit", domains::sphere(), Point_3(0.63, 0, 0.84), Point_3(0.6, 0, 0.8), 5e-3);
  const CGAL::Image_3 grays = domains::gray_image();
  const double radius = std::sqrt(0.125);
  projection("gray image", domains::gray_image_domain(grays), Point_3(0.53 + radius, 0.5, 0.5),
             Point_3(0.5 + radius, 0.5, 0.5), 1e-2);
  const CGAL::Image_3 labels = domains::labeled_image();
  projection("labeled image", domains::labeled_image_domain(labels), Point_3(0.5, 0.5, 0.95), Point_3(0.5, 0.5, 0.9), 0.04);
  const domains::Polyhedron box = domains::notched_box();
  projection("polyhedron", domains::Polyhedral_domain(box), Point_3(0.7, 0.6, -0.1), Point_3(0.7, 0.6, 0), 1e-15);
  const Ellipsoid_domain ellipsoid;
  projection("ellipsoid", ellipsoid, Point_3(0.5, 0, 0), Point_3(0.35, 0, 0), 1e-12);
  ellipsoid.questions.misses_of_dozen = 12;
  odt::Mesh_domain_view_3<Ellipsoid_domain> view(ellipsoid);
  odt::Vector_3 p(0.5, 0, 0);
  check::that(!view.project(p, odt::Vector_3(1, 0, 0), 0.3, view.number_patch({ 1 })) && p[0] == 0.5, "projected although all intersections are missed");
}

// The smallest angle of all facets of the boundary, and the mean over them of their smallest.
static std::pair<double, double> facet_angles(const domains::Labeled_c3t3& c3t3)
{
  double smallest = 180, sum = 0;
  for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
  {
    double angle = 180;
    for(int k = 0; k < 3; ++k)
    {
      const auto point = [&](int i) { return f->first->vertex((f->second + 1 + (k + i) % 3) % 4)->point().point(); };
      angle = (std::min)(angle, CGAL::to_double(CGAL::approximate_angle(point(1), point(0), point(2))));
    }
    smallest = (std::min)(smallest, angle);
    sum += angle;
  }
  return { smallest, sum / c3t3.number_of_facets_in_complex() };
}

// Triangles become better, the more so the more they count, and none becomes bad.
static void triangles()
{
  const domains::Labeled_domain domain = domains::sphere();
  const domains::Labeled_c3t3 input = domains::mesh(domain, 0.15);
  const std::pair<double, double> before = facet_angles(input);
  double mean = before.second;
  for(double weight : { 0., 1.2, 10. })
  {
    domains::Labeled_c3t3 c3t3(input);
    if(weight == 1.2)
      CGAL::odt_optimize_mesh_3(c3t3, domain);
    else
      CGAL::odt_optimize_mesh_3(c3t3, domain, params::surface_weight = weight);
    const std::pair<double, double> after = facet_angles(c3t3);
    check::that(after.first >= (std::min)(30., before.first) - 1e-9, "smallest angle of facets ", before.first, " -> ", after.first);
    check::that(after.second > mean, "mean angle of facets ", mean, " -> ", after.second, " with weight ", weight);
    check::that(weight == 0 || after.second > 51, "mean angle of facets ", after.second, " with weight ", weight);
    mean = after.second;
  }
}

int main()
{
  triangles();
  projection();
  plate();
  facets_without_centers();
  touching();
  junctions();
  features();
  distances();
  bent();
  const Ellipsoid_domain domain;
  const Ellipsoid_c3t3 c3t3 = mesh(domain, 0.2);
  test("ellipsoid", c3t3, domain);
  missed_intersections(domain, c3t3);
  missed_surface_centers(domain, c3t3);
  blind_spot(domain, mesh(domain, 0.3));
  homes_are_given_up(domain, c3t3);
  exceptions(domain, mesh(domain, 0.3));
  return check::result();
}
