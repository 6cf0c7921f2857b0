#!/usr/bin/env bash
# Installs what is missing, and builds and runs the tests and the examples with the system's CGAL.
#
#   [JOBS=n] run_tests.sh [build directory]
#   [JOBS=n] CGAL_DIR=... run_tests.sh "build directory" "name of that CGAL"
#
# The second builds and runs the tests of the contract with another CGAL. A compiler needs up to 4 GB, hence two jobs at a time if
# nothing else is said.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/install_dependencies.sh
build=${1:-build-tests}
name=${2:-system}
jobs=${JOBS:-2}
mkdir -p "$build"
data=$(scripts/extract_data.sh "$build")
if [ "$name" = system ]; then
  options=(-DGLOBAL_ODT_MESH_3_BUILD_EXAMPLES=ON)
else
  options=(-DGLOBAL_ODT_MESH_3_CONTRACT_TESTS_ONLY=ON "-DCGAL_DIR=$CGAL_DIR")
fi
echo "=== tests with the CGAL of $name ==="
# Tests and examples take longer to compile than to run, hence -O1; and GCC, unless told so, collects garbage all the time.
flags="-O1 -DNDEBUG"
if ${CXX:-c++} -v 2>&1 | grep -q "^gcc version"; then
  flags="$flags --param ggc-min-heapsize=1000000"
fi
cmake -S . -B "$build/$name" -DCMAKE_BUILD_TYPE=Release -DGLOBAL_ODT_MESH_3_BUILD_TESTS=ON "${options[@]}" \
      -DCMAKE_CXX_FLAGS_RELEASE="$flags" -DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DCGAL_DATA_DIR="$data" \
      > "$build/$name.log" 2>&1 || { cat "$build/$name.log"; exit 1; }
cmake --build "$build/$name" -j"$jobs"
# Not the tests that compile, which CGAL adds for each program.
cd "$build/$name"
ctest -j"$jobs" -R '^test_' --output-on-failure
