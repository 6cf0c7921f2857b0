#!/usr/bin/env bash
# Runs run_tests.sh with all versions of CGAL, and then the paper's experiments on small meshes, and two of Mesh_3's own examples.
#
#   [JOBS=n] [BUILD=directory] run_all_tests.sh
set -euo pipefail
cd "$(dirname "$0")/.."
export BUILD=${BUILD:-build-tests} JOBS=${JOBS:-2}
status=0
scripts/run_tests.sh system trixie testing || status=1
echo "=== a quick run of the paper's experiments ==="
scripts/reproduce_paper.sh --quick --output "$BUILD/paper" || status=1
echo "=== examples of Mesh_3 ==="
scripts/run_examples_of_mesh_3.sh --output "$BUILD/mesh-3-examples" mesh_implicit_sphere mesh_optimization_lloyd_example || status=1
exit $status
