/*!
\ingroup PkgGlobalOdtMesh3Concepts
\cgalConcept

The concept `MeshDensity_3` describes the type of the named parameter `density` of `CGAL::odt_optimize_mesh_3()`,
`CGAL::remesh_boundary_mesh_3()`, and `CGAL::odt_energy_3()`: a positive function of points, large where cells are small. Cells of size
\f$ \mu \f$ result from the density \f$ \rho = 1/\mu^5 \f$. Only ratios of densities matter.

A function object or a lambda of the signature `FT(const Point_3&)` is a model. It is copied; `std::cref()` avoids that.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Spline_grid_field_3<Kernel>}
\cgalHasModels{CGAL::Quadratic_density_3<Kernel>}
\cgalHasModelsEnd

\sa `MeshDomainField_3`
*/
class MeshDensity_3
{
public:
  /// A number type that converts to `double`.
  typedef unspecified_type FT;

  /// The bare point type of the mesh.
  typedef unspecified_type Point_3;

  /// Returns the density at `p`, which is in the domain or close to its boundary. The value must be positive and finite.
  /// It may depend on `p` alone. It is called by one thread at a time.
  FT operator()(const Point_3& p) const;
};
