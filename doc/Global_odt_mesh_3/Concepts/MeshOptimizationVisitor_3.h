/*!
\ingroup PkgGlobalOdtMesh3Concepts
\cgalConcept

The concept `MeshOptimizationVisitor_3` describes the type of the named parameter `visitor` of `CGAL::odt_optimize_mesh_3()`,
`CGAL::remesh_boundary_mesh_3()`, and `CGAL::remove_slivers_mesh_3()`. A visitor is told of the stages of the optimization, by the
thread that called the function. An exception that it throws leaves the mesh as it was before the call.

A visitor is copied; `std::ref()` avoids that, and keeps its state.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Mesh_3::Null_global_optimizer_visitor<C3T3>}
\cgalHasModelsEnd
*/
class MeshOptimizationVisitor_3
{
public:
  /// Called in each iteration when the gradient is known.
  void after_compute_moves();

  /// Called in each iteration when the vertices have moved.
  void after_move_points();

  /// Called at the end of each iteration with its number, beginning with 0. A search in blocks reports ten iterations at once.
  void end_of_iteration(int iteration_number);

  /// Called once, when the mesh is final.
  void after_rebuild_restricted_delaunay();

  /// Called before `after_rebuild_restricted_delaunay()` with the number of cells that are left below the `sliver_bound`, which is
  /// zero if there is no bound. This member function is optional.
  void after_sliver_removal(std::size_t number_of_slivers);
};
