#!/usr/bin/env bash
# Installs what is missing, builds and runs the main example: a mesh of the
# elephant, or of the closed surface given, optimized, with its quality report,
# meshes, and a picture of before and after. That of the elephant is the picture
# of the manual, in doc/Global_odt_mesh_3/fig.
#
#   run_main_example.sh [surface.off [size relative to the bounding box]]
set -euo pipefail
surface=""
if [ $# -gt 0 ]; then
  [ -f "$1" ] || { echo "there is no file $1" >&2; exit 1; }
  surface=$(realpath "$1")
fi
cd "$(dirname "$0")/.."
scripts/install_dependencies.sh
build=$PWD/build-example
results=$build/results
# What an earlier run has left is no result of this one.
rm -rf "$results"
mkdir -p "$results"
data=$(scripts/extract_data.sh "$build")
cmake -S . -B "$build" -DCMAKE_BUILD_TYPE=Release -DGLOBAL_ODT_MESH_3_BUILD_EXAMPLES=ON \
      -DCMAKE_CXX_COMPILER_LAUNCHER=ccache ${data:+-DCGAL_DATA_DIR="$data"} > "$build/configure.log" 2>&1 \
  || { cat "$build/configure.log"; exit 1; }
cmake --build "$build" --target optimize_polyhedral_mesh
cd "$results"
[ -z "$data" ] || export CGAL_DATA_DIR=$data
"$build/examples/Global_odt_mesh_3/optimize_polyhedral_mesh" ${surface:+"$surface"} ${2:+"$2"} | tee report.txt \
  || { mv report.txt failed.txt; exit 1; }
echo "report, meshes, and picture are in $PWD:"
ls
