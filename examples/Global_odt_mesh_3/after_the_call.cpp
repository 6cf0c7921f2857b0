// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// What follows a call: values at the vertices are carried over to the new mesh, the vertices and facets of each patch are
// collected, and the mesh is written with them: after_the_call.inp for Abaqus and CalculiX, after_the_call.vtk for ParaView.
//
//   after_the_call [surface.off [size relative to the bounding box]]

#include "read_surface.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_optimization_report_3.h>
#include <CGAL/Mesh_polyhedron_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_with_features_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/odt_optimize_mesh_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Exact_predicates_inexact_constructions_kernel K;
typedef CGAL::Mesh_polyhedron_3<K>::type Polyhedron;
typedef CGAL::Polyhedral_mesh_domain_with_features_3<K> Domain;
typedef CGAL::Mesh_triangulation_3<Domain>::type Tr;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Tr, Domain::Corner_index, Domain::Curve_index> C3t3;
typedef CGAL::Mesh_criteria_3<Tr> Criteria;
namespace params = CGAL::parameters;

typedef std::map<Tr::Vertex_handle, double> Nodal_values;

// The values at the vertices of a mesh, interpolated linearly in its cells.
class Nodal_field
{
public:
  // Both have to outlive the field.
  Nodal_field(const C3t3& c3t3, const Nodal_values& values)
    : c3t3_(c3t3)
    , values_(values)
  {}

  double operator()(const K::Point_3& p)
  {
    // The search for the next point begins where the last one has ended.
    located_ = c3t3_.triangulation().locate(Tr::Point(p), located_);
    const Tr::Cell_handle c = c3t3_.is_in_complex(located_) ? located_ : cell_beside(located_, p);
    std::array<double, 4> weights = coordinates(c, p);
    double sum = 0;
    for(double& w : weights)
      sum += (w = (std::max)(w, 0.));
    double value = 0;
    for(int i = 0; i < 4; ++i)
      value += weights[static_cast<std::size_t>(i)] / sum * values_.at(c->vertex(i));
    return value;
  }

private:
  // The barycentric coordinates of a point. Some are negative if the point is outside of the cell.
  static std::array<double, 4> coordinates(Tr::Cell_handle c, const K::Point_3& p)
  {
    std::array<double, 4> result;
    for(int i = 0; i < 4; ++i)
    {
      const auto q = [&](int j) { return i == j ? p : c->vertex(j)->point().point(); };
      result[static_cast<std::size_t>(i)] = CGAL::volume(q(0), q(1), q(2), q(3));
    }
    const double volume = result[0] + result[1] + result[2] + result[3];
    for(double& x : result)
      x /= volume;
    return result;
  }

  // A vertex on a curved surface may lie a little outside of the old mesh. Of the old cells at the vertices of the cell that
  // contains it, this is the one that it is the least outside of.
  Tr::Cell_handle cell_beside(Tr::Cell_handle located, const K::Point_3& p) const
  {
    const Tr& tr = c3t3_.triangulation();
    std::vector<Tr::Cell_handle> cells;
    for(int i = 0; i < 4; ++i)
      if(!tr.is_infinite(located->vertex(i)))
        tr.finite_incident_cells(located->vertex(i), std::back_inserter(cells));
    Tr::Cell_handle best;
    double most = 0;
    for(Tr::Cell_handle c : cells)
      if(c3t3_.is_in_complex(c))
      {
        const auto x = coordinates(c, p);
        const double least = *std::min_element(x.begin(), x.end());
        if(best == Tr::Cell_handle() || least > most)
        {
          best = c;
          most = least;
        }
      }
    return best;
  }

  const C3t3& c3t3_;
  const Nodal_values& values_;
  Tr::Cell_handle located_;
};

// The vertices, cells, and facets of a complex by number, from 1 on, and those of each patch.
struct Numbered_mesh
{
  explicit Numbered_mesh(const C3t3& c3t3)
  {
    for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
    {
      cells.push_back(c);
      cell_numbers[c] = cells.size();
      for(int i = 0; i < 4; ++i)
        if(vertex_numbers.emplace(c->vertex(i), vertices.size() + 1).second)
          vertices.push_back(c->vertex(i));
    }
    for(auto f = c3t3.facets_in_complex_begin(); f != c3t3.facets_in_complex_end(); ++f)
    {
      // A facet has a cell on each side, of which one may be outside.
      const C3t3::Facet facet = c3t3.is_in_complex(f->first) ? *f : c3t3.triangulation().mirror_facet(*f);
      Patch& patch = patches[c3t3.surface_patch_index(*f)];
      patch.facets.push_back(facet);
      for(int k = 1; k < 4; ++k)
        patch.vertices.insert(vertex_numbers.at(facet.first->vertex((facet.second + k) % 4)));
    }
  }

  struct Patch
  {
    std::vector<C3t3::Facet> facets;
    std::set<std::size_t> vertices;   // those on curves are in several patches
  };

  std::vector<Tr::Vertex_handle> vertices;
  std::map<Tr::Vertex_handle, std::size_t> vertex_numbers;
  std::vector<Tr::Cell_handle> cells;
  std::map<Tr::Cell_handle, std::size_t> cell_numbers;
  std::map<C3t3::Surface_patch_index, Patch> patches;
};

// Each subdomain is a set of elements, and each patch a set of nodes and a surface, of faces of elements.
inline bool write_abaqus(const C3t3& c3t3, const Numbered_mesh& mesh, const Nodal_values& values, const std::string& name)
{
  std::ofstream out(name);
  out.precision(12);   // CalculiX reads twenty characters of a number
  out << "*NODE, NSET=ALL\n";
  for(std::size_t n = 0; n < mesh.vertices.size(); ++n)
  {
    const K::Point_3& p = mesh.vertices[n]->point().point();
    out << n + 1 << ", " << p.x() << ", " << p.y() << ", " << p.z() << '\n';
  }
  std::map<C3t3::Subdomain_index, std::vector<Tr::Cell_handle> > subdomains;
  for(Tr::Cell_handle c : mesh.cells)
    subdomains[c3t3.subdomain_index(c)].push_back(c);
  for(const auto& subdomain : subdomains)
  {
    out << "*ELEMENT, TYPE=C3D4, ELSET=SUBDOMAIN_" << subdomain.first << '\n';
    for(Tr::Cell_handle c : subdomain.second)
    {
      out << mesh.cell_numbers.at(c);
      for(int i = 0; i < 4; ++i)
        out << ", " << mesh.vertex_numbers.at(c->vertex(i));
      out << '\n';
    }
  }
  for(const auto& patch : mesh.patches)
  {
    out << "*NSET, NSET=NODES_" << patch.first << '\n';
    for(std::size_t n : patch.second.vertices)
      out << n << ",\n";
    out << "*SURFACE, NAME=SURFACE_" << patch.first << '\n';
    // The face opposite to a vertex, as Abaqus numbers it.
    const char* const faces[] = { "S3", "S4", "S2", "S1" };
    for(const C3t3::Facet& f : patch.second.facets)
      out << mesh.cell_numbers.at(f.first) << ", " << faces[f.second] << '\n';
  }
  out << "*INITIAL CONDITIONS, TYPE=TEMPERATURE\n";
  for(std::size_t n = 0; n < mesh.vertices.size(); ++n)
    out << n + 1 << ", " << values.at(mesh.vertices[n]) << '\n';
  return bool(out.flush());
}

inline bool write_vtk(const C3t3& c3t3, const Numbered_mesh& mesh, const Nodal_values& values, const std::string& name)
{
  std::ofstream out(name);
  out.precision(17);
  out << "# vtk DataFile Version 3.0\nmesh with temperatures\nASCII\nDATASET UNSTRUCTURED_GRID\n"
      << "POINTS " << mesh.vertices.size() << " double\n";
  for(Tr::Vertex_handle v : mesh.vertices)
    out << v->point().point() << '\n';
  out << "CELLS " << mesh.cells.size() << ' ' << 5 * mesh.cells.size() << '\n';
  for(Tr::Cell_handle c : mesh.cells)
  {
    out << 4;
    for(int i = 0; i < 4; ++i)
      out << ' ' << mesh.vertex_numbers.at(c->vertex(i)) - 1;
    out << '\n';
  }
  out << "CELL_TYPES " << mesh.cells.size() << '\n';
  for(std::size_t n = 0; n < mesh.cells.size(); ++n)
    out << "10\n";
  out << "CELL_DATA " << mesh.cells.size() << "\nSCALARS subdomain int 1\nLOOKUP_TABLE default\n";
  for(Tr::Cell_handle c : mesh.cells)
    out << c3t3.subdomain_index(c) << '\n';
  out << "POINT_DATA " << mesh.vertices.size() << "\nSCALARS temperature double 1\nLOOKUP_TABLE default\n";
  for(Tr::Vertex_handle v : mesh.vertices)
    out << values.at(v) << '\n';
  return bool(out.flush());
}

// What a simulation might have computed on the old mesh; the size is that of the domain.
inline double temperature(const K::Point_3& p, double size)
{
  return 300 + 40 * std::sin(5 * p.x() / size) * std::cos(3 * p.y() / size) + 10 * p.z() / size;
}

int main(int argc, char* argv[])
{
  const double relative_size = argc > 2 ? std::atof(argv[2]) : 0.03;
  if(!(relative_size > 0 && relative_size < 1))
  {
    std::cerr << "the relative size must be between 0 and 1\n";
    return EXIT_FAILURE;
  }
  Polyhedron polyhedron;
  if(!read_surface(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/fandisk.off"), polyhedron))
    return EXIT_FAILURE;
  Domain domain(polyhedron);
  domain.detect_features();
  const CGAL::Bbox_3 box = domain.bbox();
  const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span()), size = relative_size * diagonal;
  const Criteria criteria(params::edge_size = size, params::facet_angle = 25, params::facet_size = size,
                          params::facet_distance = size / 10, params::cell_radius_edge_ratio = 3, params::cell_size = size);
  const C3t3 before = CGAL::make_mesh_3<C3t3>(domain, criteria, params::no_perturb(), params::no_exude());
  Nodal_values values;
  const Tr& tr = before.triangulation();
  for(auto v = tr.finite_vertices_begin(); v != tr.finite_vertices_end(); ++v)
    values[v] = temperature(v->point().point(), diagonal);

  // A copy is optimized, so that the old mesh and its values are still there.
  C3t3 c3t3(before);
  CGAL::Mesh_optimization_report_3<C3t3> report;
  CGAL::odt_optimize_mesh_3(c3t3, domain, params::do_insert_vertices = true, params::optimization_report = std::ref(report));
  std::cout << report;

  const Numbered_mesh mesh(c3t3);
  Nodal_field field(before, values);
  Nodal_values new_values;
  double largest_error = 0;
  for(Tr::Vertex_handle v : mesh.vertices)
  {
    const K::Point_3& p = v->point().point();
    new_values[v] = field(p);
    largest_error = (std::max)(largest_error, std::abs(new_values[v] - temperature(p, diagonal)));
  }
  std::cout << "temperatures carried over to within " << largest_error << " degrees\n";
  for(const auto& patch : mesh.patches)
    std::cout << "patch " << patch.first << ": " << patch.second.facets.size() << " facets, "
              << patch.second.vertices.size() << " vertices\n";
  if(!write_abaqus(c3t3, mesh, new_values, "after_the_call.inp") || !write_vtk(c3t3, mesh, new_values, "after_the_call.vtk"))
  {
    std::cerr << "files cannot be written\n";
    return EXIT_FAILURE;
  }
  std::cout << "mesh: after_the_call.inp, after_the_call.vtk\n";
  return largest_error < 5 ? EXIT_SUCCESS : EXIT_FAILURE;
}
