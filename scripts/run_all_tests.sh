#!/usr/bin/env bash
# Runs run_tests.sh, and then what takes longer: the contract's tests with the CGAL of Debian 13 and of Debian testing, two examples
# in a tree of headers as a release of CGAL that contains the package has it, the paper's
# experiments on small meshes, and two of Mesh_3's own examples.
#
#   [JOBS=n] run_all_tests.sh [build directory]
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build-tests}
jobs=${JOBS:-2}
status=0
scripts/run_tests.sh "$build" || status=1
for suite in testing trixie; do
  code=0
  cgal=$(scripts/fetch_cgal.sh "$suite" "$build/$suite-cgal") || code=$?
  case $code in
    0)
      CGAL_DIR=$cgal scripts/run_tests.sh "$build" "$suite" || status=1
      if [ "$suite" = testing ]; then
        echo "=== a release of CGAL that contains the package ==="
        JOBS=$jobs scripts/check_merge.sh "${cgal%/lib/*}/include" "$build/merge" || status=1
      fi ;;
    2) echo "=== $suite cannot be reached: its CGAL is not tested ===" ;;
    *) status=1 ;;
  esac
done
echo "=== a quick run of the paper's experiments ==="
JOBS=$jobs scripts/reproduce_paper.sh --quick --output "$build/paper" || status=1
echo "=== examples of Mesh_3 ==="
JOBS=$jobs scripts/run_examples_of_mesh_3.sh --output "$build/mesh-3-examples" mesh_implicit_sphere mesh_optimization_lloyd_example || status=1
exit $status
