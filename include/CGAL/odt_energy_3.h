// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_ODT_ENERGY_3_H
#define CGAL_ODT_ENERGY_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/Requirements.h>

#include <CGAL/disable_warnings.h>

#include <CGAL/Density_quadratures_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Field_density_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Make_density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/door/Named_parameters.h>
#include <CGAL/Global_odt_mesh_3/internal/door/User_fields_3.h>
#include <CGAL/Global_odt_mesh_3/internal/energy/Reference_energy_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {

namespace Global_odt_mesh_3::internal {

// What odt_energy_3() reads.
typedef Parameter_list<tags::sizing_field, internal_np::density_t, internal_np::quadrature_t> Energy_parameters;

// The cells of a complex by the numbers of their vertices. A cell has the density of its vertex of the lowest number, which is
// one of the highest dimension.
template <class C3t3>
struct Numbered_cells_3
{
  typedef typename C3t3::Vertex_handle Vertex_handle;

  explicit Numbered_cells_3(const C3t3& c3t3)
  {
    std::map<Vertex_handle, int> numbers;
    for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
      for(int i = 0; i < 4; ++i)
        numbers[c->vertex(i)] = 0;
    // The order of handles differs from run to run.
    for(auto v = c3t3.triangulation().finite_vertices_begin(); v != c3t3.triangulation().finite_vertices_end(); ++v)
      if(numbers.count(v) != 0)
        vertices.push_back(v);
    std::stable_sort(vertices.begin(), vertices.end(), [](Vertex_handle u, Vertex_handle v)
                     { return u->in_dimension() > v->in_dimension(); });
    for(Vertex_handle v : vertices)
    {
      numbers[v] = static_cast<int>(sites.size());
      sites.push_back(weighted_site(c3t3.triangulation().point(v)));
    }
    for(auto c = c3t3.cells_in_complex_begin(); c != c3t3.cells_in_complex_end(); ++c)
      cells.push_back({{ numbers[c->vertex(0)], numbers[c->vertex(1)], numbers[c->vertex(2)], numbers[c->vertex(3)] }});
  }

  // Sums the energies of all cells; `moments` gives the moments of the density in a cell.
  template <class Moments>
  double energy(const Moments& moments) const
  {
    double sum = 0;
    for(const Cell_vertices& v : cells)
      sum += cell_energy(sites, v, moments(v));
    return sum;
  }

  std::vector<Vertex_handle> vertices;
  std::vector<Site> sites;
  std::vector<Cell_vertices> cells;
};

// The rule is null if the energy is to be computed as exactly as possible.
template <class C3t3, class Rule>
double odt_energy(const C3t3& c3t3, const User_fields_3<C3t3>& fields, const Rule* rule)
{
  fields.check();
  const Quadrature_maker make_quadrature = rule != nullptr ? quadrature_maker(*rule) : make_usual_quadrature;
  const Numbered_cells_3<C3t3> mesh(c3t3);
  const auto uniform = [](const Cell_vertices&) { return linear_density_moments({{ 1, 1, 1, 1 }}); };
  if(!fields)
    return mesh.energy(uniform);
  const auto vertex = [&mesh](int v) { return mesh.vertices[static_cast<std::size_t>(v)]; };
  const User_field_3 field = fields.of_mesh(vertex, [&](const Vertex_stratum& s) { return vertex(s.number)->index(); });
  const auto value = [&](int v, const Site& s) { return field.value({ v, vertex(v)->in_dimension(), 0 }, s); };
  Field_density_3 density(field.meaning, value, mesh.sites, field.polynomial);
  const double unit = density.unit_density();
  if constexpr (std::is_same<Rule, Adaptive_cubature_3>::value)
    if(rule != nullptr || density.polynomial() == nullptr)
      return unit * reference_energy(mesh.sites, mesh.cells, density, rule != nullptr ? *rule : Adaptive_cubature_3{ 1e-8 });
  const std::unique_ptr<Density_quadrature_3> quadrature = make_quadrature(density, mesh.sites);
  if(quadrature == nullptr)
    return unit * mesh.energy(uniform);
  return unit * mesh.energy([&](const Cell_vertices& v) { return quadrature->moments(0, v.data(), mesh.sites.data()); });
}

} // namespace Global_odt_mesh_3::internal

/*!
\ingroup PkgGlobalOdtMesh3Functions

computes the energy of optimal Delaunay triangulations of a mesh complex. It is
\f$ E^\rho_{ODT} = \sum_\tau \int_\tau \rho\,(f_I - \mathbf{x}^2) \f$ (equation (2.5) of \cgalCite{cgal:cwlls-rodt-14})
with the density that the named parameters stand for, which is 1 without any. On weighted vertices, as on features,
\f$ f_I \f$ interpolates \f$ \mathbf{x}^2 \f$ minus the weight.

\tparam C3T3 a model of the concept `MeshComplex_3InTriangulation_3`
\tparam NamedParameters a sequence of named parameters

\param c3t3 the mesh
\param np an optional sequence of named parameters among the ones listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{sizing_field}
    \cgalParamDescription{the size \f$ \mu \f$ that stands for the density \f$ 1/\mu^5 \f$; as for
                          `odt_optimize_mesh_3()`}
    \cgalParamType{a model of `MeshDomainField_3`, or a number}
    \cgalParamPrecondition{all sizes are positive and finite; not together with `density`}
    \cgalParamDefault{none}
  \cgalParamNEnd
  \cgalParamNBegin{density}
    \cgalParamDescription{the density \f$ \rho \f$; as for `odt_optimize_mesh_3()`}
    \cgalParamType{a model of `MeshDensity_3`}
    \cgalParamPrecondition{all densities are positive and finite; not together with `sizing_field`}
    \cgalParamDefault{1}
  \cgalParamNEnd
  \cgalParamNBegin{quadrature}
    \cgalParamDescription{how the density is integrated over cells}
    \cgalParamType{`CGAL::Linear_density_rule_3`, `CGAL::Four_point_rule_3`, `CGAL::Fifteen_point_rule_3` or
                   `CGAL::Adaptive_cubature_3`}
    \cgalParamDefault{`CGAL::Adaptive_cubature_3` with a tolerance of \f$ 10^{-8} \f$; exact integrals for
                      `CGAL::Quadratic_density_3`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return the energy, in the unit of length to the power of five times that of the density

\sa `odt_optimize_mesh_3()`
\sa `mesh_quality_report_3()`
*/
template <class C3T3, class... NamedParameters>
double odt_energy_3(const C3T3& c3t3, const NamedParameters&... np)
{
  namespace odt = Global_odt_mesh_3::internal;
  const odt::Named_arguments<odt::Energy_parameters, NamedParameters...> arguments(np...);
  odt::User_fields_3<C3T3> fields;
  fields.read(arguments);
  if constexpr (std::decay_t<decltype(arguments)>::template has<internal_np::quadrature_t>)
    return odt::odt_energy(c3t3, fields, &std::cref(arguments.template get<internal_np::quadrature_t>()).get());
  else
    return odt::odt_energy(c3t3, fields, static_cast<const Adaptive_cubature_3*>(nullptr));
}

} // namespace CGAL

#include <CGAL/enable_warnings.h>

#endif // CGAL_ODT_ENERGY_3_H
