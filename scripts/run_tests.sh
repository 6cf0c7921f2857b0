#!/usr/bin/env bash
# Installs what is missing, builds and runs the tests: all with the system's
# CGAL, along with the examples, those of the contract also with the CGAL of Debian 13 and of Debian
# testing. Then repeats the paper's experiments on small meshes, and runs two of Mesh_3's own examples.
#
#   [JOBS=n] run_tests.sh [build directory]
#
# A compiler needs up to 4 GB, hence two jobs at a time if nothing else is said.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/install_dependencies.sh
build=${1:-build-tests}
jobs=${JOBS:-2}
mkdir -p "$build"
data=$(scripts/extract_data.sh "$build")
status=0

# run NAME LABEL [cmake options]
run() {
  local name=$1 label=$2
  shift 2
  echo "=== tests with the CGAL of $name ==="
  # Tests and examples take longer to compile than to run, hence -O1.
  cmake -S . -B "$build/$name" -DCMAKE_BUILD_TYPE=Release -DGLOBAL_ODT_MESH_3_BUILD_TESTS=ON \
        -DGLOBAL_ODT_MESH_3_CONTRACT_TESTS_ONLY="$([ -n "$label" ] && echo ON || echo OFF)" \
        -DGLOBAL_ODT_MESH_3_BUILD_EXAMPLES="$([ -n "$label" ] && echo OFF || echo ON)" \
        -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" \
        -DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DCGAL_DATA_DIR="$data" "$@" > "$build/$name.log" 2>&1 \
    || { cat "$build/$name.log"; status=1; return; }
  cmake --build "$build/$name" -j"$jobs" || { status=1; return; }
  # Not the tests that compile, which CGAL adds for each program.
  (cd "$build/$name" && ctest -j"$jobs" -R '^test_' --output-on-failure) || status=1
}

for suite in testing trixie; do
  code=0
  cgal=$(scripts/fetch_cgal.sh "$suite" "$build/$suite-cgal") || code=$?
  case $code in
    0) run "$suite" contract -DCGAL_DIR="$cgal" ;;
    2) echo "=== $suite cannot be reached: its CGAL is not tested ===" ;;
    *) status=1 ;;
  esac
done
run system ""
echo "=== a quick run of the paper's experiments ==="
JOBS=$jobs scripts/reproduce_paper.sh --quick --output "$build/paper" || status=1
echo "=== examples of Mesh_3 ==="
JOBS=$jobs scripts/run_examples_of_mesh_3.sh --output "$build/mesh-3-examples" mesh_implicit_sphere mesh_optimization_lloyd_example || status=1
exit $status
