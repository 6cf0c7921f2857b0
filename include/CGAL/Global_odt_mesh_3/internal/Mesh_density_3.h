// Copyright (c) 2026 The Global ODT Mesh authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Global ODT Mesh authors

#ifndef CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_DENSITY_3_H
#define CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_DENSITY_3_H

#include <CGAL/license/Global_odt_mesh_3.h>

#include <CGAL/Global_odt_mesh_3/internal/complex/Complex_snapshot_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Density_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Field_density_3.h>
#include <CGAL/Global_odt_mesh_3/internal/density/Make_density_quadrature_3.h>
#include <CGAL/Global_odt_mesh_3/internal/geometry/Site.h>
#include <CGAL/Global_odt_mesh_3/internal/interface/User_field_3.h>
#include <CGAL/Global_odt_mesh_3/internal/sizing/Input_density_3.h>
#include <CGAL/Global_odt_mesh_3/internal/surface/Surface_cvt_energy_3.h>
#include <CGAL/Global_odt_mesh_3/internal/triangulation/Moving_triangulation_3.h>

#include <memory>

namespace CGAL {
namespace Global_odt_mesh_3 {
namespace internal {

// The density of a mesh, the user's or else that of its input, for the energies of cells and of surfaces.
class Mesh_density_3
{
public:
  Mesh_density_3() {}

  // The mesh refers to the quadrature.
  Mesh_density_3(const Mesh_density_3&) = delete;
  Mesh_density_3& operator=(const Mesh_density_3&) = delete;

  // Refers to the field and the numbering.
  void prepare(Moving_triangulation_3& mesh, const User_field_3& field, const Quadrature_choice& quadrature,
               const Vertex_numbering_3& numbering)
  {
    const auto in_input = [&field, &numbering](int v, const Site& s) { return field.value(numbering.stratum(v), s); };
    if(field)
      density_ = std::make_unique<Field_density_3>(field.meaning, in_input, mesh.sites, field.polynomial);
    else
      density_ = std::make_unique<Input_density_3>(mesh);
    // The density of the input is what it is at vertices, but a field may vary between them.
    if(!density_->is_uniform() || field)
      quadrature_ = make_density_quadrature_3(quadrature, *density_, mesh.sites);
    mesh.set_quadrature(quadrature_.get());
    if(!density_->is_uniform())
      on_surface_ = [this](int v, const Site& s) { return density_->on_surface(v, s); };
  }

  // The local size at a vertex, about one as a median, if the energy of cells follows the density.
  double size(int v, const Site& s) const
  {
    return density_->is_uniform() ? 1 : Density_3::size_of_density(density_->in_volume(v, s));
  }

  // Empty if it is uniform.
  const Surface_density& on_surface() const { return on_surface_; }

private:
  std::unique_ptr<Density_3> density_;
  std::unique_ptr<Density_quadrature_3> quadrature_;
  Surface_density on_surface_;
};

} // namespace internal
} // namespace Global_odt_mesh_3
} // namespace CGAL

#endif // CGAL_GLOBAL_ODT_MESH_3_INTERNAL_MESH_DENSITY_3_H
