// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_TEST_MESH_DOMAINS_H
#define GLOBAL_ODT_MESH_3_TEST_MESH_DOMAINS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/ImageIO.h>
#include <CGAL/Image_3.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_polyhedron_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <sstream>
#include <string>

// Small meshes of all kinds of domains. Only two types of complex occur, for the
// sake of compile time: labeled domains (implicit functions and images) and
// polyhedral domains with features. For the same sake, what makes the meshes is compiled once, in mesh_domains.cpp.
namespace domains {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::FT FT;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Sphere_3 Sphere_3;
namespace params = CGAL::parameters;

// The macro is that of CGAL's examples.
#ifdef CGAL_CONCURRENT_MESH_3
typedef CGAL::Parallel_tag Concurrency_tag;
#else
typedef CGAL::Sequential_tag Concurrency_tag;
#endif

typedef CGAL::Labeled_mesh_domain_3<Kernel> Labeled_domain;
typedef CGAL::Mesh_triangulation_3<Labeled_domain, CGAL::Default, Concurrency_tag>::type Labeled_triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Labeled_triangulation> Labeled_c3t3;
typedef CGAL::Mesh_criteria_3<Labeled_triangulation> Labeled_criteria;

typedef CGAL::Mesh_polyhedron_3<Kernel>::type Polyhedron;
typedef CGAL::Polyhedral_mesh_domain_with_features_3<Kernel> Polyhedral_domain;
typedef CGAL::Mesh_triangulation_3<Polyhedral_domain, CGAL::Default, Concurrency_tag>::type Polyhedral_triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<
  Polyhedral_triangulation, Polyhedral_domain::Corner_index, Polyhedral_domain::Curve_index> Polyhedral_c3t3;
typedef CGAL::Mesh_criteria_3<Polyhedral_triangulation> Polyhedral_criteria;

inline FT squared(const Point_3& p) { return p.x() * p.x() + p.y() * p.y() + p.z() * p.z(); }

// A domain of labels 1, 2, ... in the ball of radius 2; 0 is outside.
inline Labeled_domain labeled(std::function<int(const Point_3&)> labels)
{
  return Labeled_domain(labels, Sphere_3(CGAL::ORIGIN, 4.));
}

inline Labeled_domain sphere()
{
  return labeled([](const Point_3& p) { return squared(p) < 1 ? 1 : 0; });
}

inline Labeled_domain torus()
{
  return labeled([](const Point_3& p)
  {
    const FT ring = std::sqrt(p.x() * p.x() + p.y() * p.y()) - 1;
    return ring * ring + p.z() * p.z() < 0.16 ? 1 : 0;
  });
}

// Two halves of a ball and a ball around the middle of their interface: three
// subdomains meeting along a curve.
inline Labeled_domain three_subdomains()
{
  return labeled([](const Point_3& p)
  {
    const FT r = squared(p);
    return r >= 1 ? 0 : r < 0.16 ? 3 : p.z() > 0.013 ? 1 : 2;
  });
}

// Hardly thicker than one cell.
inline Labeled_domain thin_plate()
{
  return labeled([](const Point_3& p)
  {
    return std::abs(p.x()) < 1 && std::abs(p.y()) < 0.9 && std::abs(p.z()) < 0.07 ? 1 : 0;
  });
}

Labeled_c3t3 mesh(const Labeled_domain& domain, double size);

// Cells are five times as large at the center as on the unit sphere.
Labeled_c3t3 graded_mesh(const Labeled_domain& domain, double smallest);

// Of the unit ball. The vertices on the sphere lie on rings, so that cells between two rings are flat up to rounding; those
// on the first rings do not move.
Labeled_c3t3 mesh_of_rings(const Labeled_domain& domain, int fixed_rings);

// An image of n^3 voxels in the cube [0, 1]^3, filled by f(x, y, z).
// ImageIO is in namespace CGAL in the latest versions.
template <class Word, class Kind, class Sign, class F>
CGAL::Image_3 image(int n, Kind kind, Sign sign, const F& f)
{
  using namespace CGAL;
  _image* im = _createImage(n, n, n, 1, 1. / (n - 1), 1. / (n - 1), 1. / (n - 1), sizeof(Word), kind, sign);
  Word* word = static_cast<Word*>(im->data);
  for(int k = 0; k < n; ++k)
    for(int j = 0; j < n; ++j)
      for(int i = 0; i < n; ++i)
        *word++ = static_cast<Word>(f(i / double(n - 1), j / double(n - 1), k / double(n - 1)));
  return CGAL::Image_3(im);
}

// Three labels: a ball cut by a plane, and a smaller ball inside.
inline CGAL::Image_3 labeled_image()
{
  using namespace CGAL;
  return image<unsigned char>(32, WK_FIXED, SGN_UNSIGNED, [](double x, double y, double z)
  {
    const double r = (x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5) + (z - 0.5) * (z - 0.5);
    return r > 0.16 ? 0 : r < 0.02 ? 3 : x < 0.52 ? 1 : 2;
  });
}

inline CGAL::Image_3 gray_image()
{
  using namespace CGAL;
  return image<float>(32, WK_FLOAT, SGN_SIGNED, [](double x, double y, double z)
  {
    return 1 - 4 * ((x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5) + 1.7 * (z - 0.5) * (z - 0.5));
  });
}

inline Labeled_domain labeled_image_domain(const CGAL::Image_3& image)
{
  return Labeled_domain::create_labeled_image_mesh_domain(image);
}

inline Labeled_domain gray_image_domain(const CGAL::Image_3& image)
{
  return Labeled_domain::create_gray_image_mesh_domain(image, params::iso_value = 0.5, params::value_outside = 0.);
}

// A box with a corner cut away: sharp edges, reflex ones among them.
inline Polyhedron notched_box()
{
  std::istringstream in(
    "OFF\n14 24 0\n"
    "0 0 0\n2 0 0\n2 2 0\n0 2 0\n0 0 2\n2 0 2\n0 2 2\n"      // 0-6: the box without (2,2,2)
    "2 1 2\n1 1 2\n1 2 2\n2 1 1\n1 1 1\n1 2 1\n2 2 1\n"      // 7-13: the notch
    "3 0 2 1\n3 0 3 2\n"
    "3 0 1 5\n3 0 5 4\n"
    "3 0 4 6\n3 0 6 3\n"
    "3 4 5 7\n3 4 7 8\n3 4 8 9\n3 4 9 6\n"
    "3 1 2 13\n3 1 13 10\n3 1 10 7\n3 1 7 5\n"
    "3 3 6 9\n3 3 9 12\n3 3 12 13\n3 3 13 2\n"
    "3 8 7 10\n3 8 10 11\n"
    "3 8 11 12\n3 8 12 9\n"
    "3 11 10 13\n3 11 13 12\n");
  Polyhedron p;
  in >> p;
  return p;
}

// On features, edges are as long as other cells are large unless a size of their own is given.
Polyhedral_c3t3 mesh(const Polyhedral_domain& domain, double size, bool with_features, double edge_size = 0);

} // namespace domains

#endif // GLOBAL_ODT_MESH_3_TEST_MESH_DOMAINS_H
