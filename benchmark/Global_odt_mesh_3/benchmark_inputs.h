// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef GLOBAL_ODT_MESH_3_BENCHMARK_INPUTS_H
#define GLOBAL_ODT_MESH_3_BENCHMARK_INPUTS_H

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Image_3.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_polyhedron_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/Random.h>
#include <CGAL/make_mesh_3.h>

#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>

// The meshes that the optimizers are measured on: those of the paper's kind, at
// the size of 4,000 to 18,000 vertices.
namespace inputs {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::FT FT;
typedef Kernel::Point_3 Point_3;
typedef Kernel::Sphere_3 Sphere_3;
namespace params = CGAL::parameters;

typedef CGAL::Labeled_mesh_domain_3<Kernel> Labeled_domain;
typedef CGAL::Mesh_triangulation_3<Labeled_domain>::type Labeled_triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Labeled_triangulation> Labeled_c3t3;

typedef CGAL::Mesh_polyhedron_3<Kernel>::type Polyhedron;
typedef CGAL::Polyhedral_mesh_domain_with_features_3<Kernel> Polyhedral_domain;
typedef CGAL::Mesh_triangulation_3<Polyhedral_domain>::type Polyhedral_triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<
  Polyhedral_triangulation, Polyhedral_domain::Corner_index, Polyhedral_domain::Curve_index> Polyhedral_c3t3;

// The same mesh, whatever has been made before.
template <class C3t3, class Domain, class Criteria, class... Options>
C3t3 reproducible_mesh(const Domain& domain, const Criteria& criteria, const Options&... options)
{
  CGAL::get_default_random() = CGAL::Random(0);
  return CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_exude(), params::no_perturb(), options...);
}

inline Labeled_domain sphere_domain()
{
  return Labeled_domain::create_implicit_mesh_domain(
    [](const Point_3& p) { return p.x() * p.x() + p.y() * p.y() + p.z() * p.z() - 1; },
    Sphere_3(CGAL::ORIGIN, 2.));
}

inline Labeled_c3t3 sphere(const Labeled_domain& domain, double size)
{
  typedef CGAL::Mesh_criteria_3<Labeled_triangulation> Criteria;
  Criteria criteria(params::facet_angle = 30, params::facet_size = size,
                    params::facet_distance = size / 8, params::cell_radius_edge_ratio = 2,
                    params::cell_size = size);
  return reproducible_mesh<Labeled_c3t3>(domain, criteria);
}

// Cell sizes grow linearly from the surface to five times as much at the center.
struct Graded_sphere_size
{
  typedef inputs::FT FT;
  typedef inputs::Point_3 Point_3;
  typedef Labeled_domain::Index Index;

  FT smallest;
  FT operator()(const Point_3& p, const int, const Index&) const
  {
    const FT depth = 1 - std::sqrt(p.x() * p.x() + p.y() * p.y() + p.z() * p.z());
    return smallest * (1 + 4 * (std::max)(FT(0), depth));
  }
};

inline Labeled_c3t3 graded_sphere(const Labeled_domain& domain, double smallest)
{
  typedef CGAL::Mesh_criteria_3<Labeled_triangulation> Criteria;
  Criteria criteria(params::facet_angle = 30, params::facet_size = smallest,
                    params::facet_distance = smallest / 8, params::cell_radius_edge_ratio = 2,
                    params::cell_size = Graded_sphere_size{ smallest });
  return reproducible_mesh<Labeled_c3t3>(domain, criteria);
}

// Of CGAL's data directory.
inline CGAL::Image_3 read_image(const std::string& name)
{
  const std::string file = CGAL::data_file_path("images/" + name);
  CGAL::Image_3 image;
  if(!image.read(file.c_str()))
    throw std::runtime_error("cannot read the image " + file);
  return image;
}

inline Labeled_domain image_domain(const CGAL::Image_3& image)
{
  return Labeled_domain::create_labeled_image_mesh_domain(image);
}

inline Labeled_c3t3 image_mesh(const Labeled_domain& domain, double facet_size, double cell_size)
{
  typedef CGAL::Mesh_criteria_3<Labeled_triangulation> Criteria;
  Criteria criteria(params::facet_angle = 30, params::facet_size = facet_size,
                    params::facet_distance = facet_size / 4, params::cell_radius_edge_ratio = 3,
                    params::cell_size = cell_size);
  return reproducible_mesh<Labeled_c3t3>(domain, criteria);
}

inline Polyhedron read_polyhedron(const std::string& file)
{
  Polyhedron polyhedron;
  std::ifstream in(file);
  if(!(in >> polyhedron) || polyhedron.empty())
    throw std::runtime_error("cannot read the surface " + file);
  return polyhedron;
}

// Of the bounding box.
inline double diagonal(const Polyhedral_domain& domain)
{
  const CGAL::Bbox_3 b = domain.bbox();
  return std::sqrt(CGAL::square(b.xmax() - b.xmin()) + CGAL::square(b.ymax() - b.ymin()) + CGAL::square(b.zmax() - b.zmin()));
}

// Sizes are relative to the diagonal, the distance to the surface to the size.
inline Polyhedral_c3t3 polyhedral_mesh(const Polyhedral_domain& domain, double relative_size,
                                       bool with_features, double relative_distance = 0.125)
{
  typedef CGAL::Mesh_criteria_3<Polyhedral_triangulation> Criteria;
  const double size = relative_size * diagonal(domain);
  Criteria criteria(params::edge_size = size, params::facet_angle = 25, params::facet_size = size,
                    params::facet_distance = relative_distance * size, params::cell_radius_edge_ratio = 3,
                    params::cell_size = size);
  if(with_features)
    return reproducible_mesh<Polyhedral_c3t3>(domain, criteria);
  return reproducible_mesh<Polyhedral_c3t3>(domain, criteria, params::no_features());
}

// Calls f(name, mesh, domain) for a model of CGAL's data directory whose features are kept.
template <class Function>
void for_model_with_features(const Function& f, const char* name, const std::string& model, double relative_size)
{
  const Polyhedron polyhedron = read_polyhedron(CGAL::data_file_path("meshes/" + model + ".off"));
  Polyhedral_domain domain(polyhedron);
  domain.detect_features();
  f(name, polyhedral_mesh(domain, relative_size, true), domain);
}

// Calls f(name, mesh, domain) for each of them, or for the one of that name, with the models in CGAL's data directory.
template <class Function>
void for_each_input(const Function& f, const std::string& only = "")
{
  const auto is_wanted = [&only](const char* name) { return only.empty() || only == name; };
  // Each with a domain of its own, as those draw random numbers, too.
  const auto with_sphere = [&](const char* name, double size, const auto& make)
  {
    const Labeled_domain domain = sphere_domain();
    if(is_wanted(name))
      f(name, make(domain, size), domain);
  };
  with_sphere("sphere", 0.0572, sphere);
  with_sphere("coarse sphere", 0.096, sphere);
  with_sphere("graded sphere", 0.0392, graded_sphere);
  if(is_wanted("elephant"))
  {
    const Polyhedron elephant = read_polyhedron(CGAL::data_file_path("meshes/elephant.off"));
    const Polyhedral_domain domain(elephant);
    f("elephant", polyhedral_mesh(domain, 0.0102, false, 1 / 6.), domain);
  }
  if(is_wanted("fandisk"))
    for_model_with_features(f, "fandisk", "fandisk", 0.0158);
  if(is_wanted("liver"))
  {
    const CGAL::Image_3 image = read_image("liver.inr.gz");
    const Labeled_domain domain = image_domain(image);
    f("liver", image_mesh(domain, 4.4, 5.6), domain);
  }
}

// The same for parts with features whose cells are so large that less than a quarter of the vertices is in the
// interior and can move at will.
template <class Function>
void for_each_coarse_part(const Function& f, const std::string& only = "")
{
  struct Part
  {
    const char *name, *model;
    double relative_size;
  };
  for(const Part& part : { Part{ "coarse cross", "cross", 0.06 }, Part{ "coarse fandisk", "fandisk", 0.04 },
                           Part{ "coarse joint", "joint", 0.05 }, Part{ "coarse anchor", "anchor", 0.04 },
                           Part{ "coarse spool", "spool", 0.04 } })
    if(only.empty() || only == part.name)
      for_model_with_features(f, part.name, part.model, part.relative_size);
}

} // namespace inputs

#endif // GLOBAL_ODT_MESH_3_BENCHMARK_INPUTS_H
