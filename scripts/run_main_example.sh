#!/usr/bin/env bash
# Installs what is missing, builds and runs the main example: a mesh of the
# elephant, or of the closed surface given, optimized, with its quality report
# and pictures before and after.
#
#   run_main_example.sh [surface.off [size relative to the bounding box]]
set -euo pipefail
surface=""
[ $# -eq 0 ] || surface=$(realpath "$1")
cd "$(dirname "$0")/.."
scripts/install_dependencies.sh
build=build-example
mkdir -p "$build"
data=$(scripts/extract_data.sh "$build")
cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Release -DGLOBAL_ODT_MESH_3_BUILD_EXAMPLES=ON \
      -DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DCGAL_DATA_DIR="$data" > "$build/configure.log" 2>&1 \
  || { cat "$build/configure.log"; exit 1; }
cmake --build "$build" --target optimize_polyhedral_mesh
mkdir -p "$build/results"
cd "$build/results"
program=../examples/Global_odt_mesh_3/optimize_polyhedral_mesh
export CGAL_DATA_DIR=$data
"$program" ${surface:+"$surface"} ${2:+"$2"} | tee report.txt
echo "report, meshes and picture are in $PWD:"
ls
