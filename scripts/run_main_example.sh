#!/usr/bin/env bash
# Installs what is missing, builds and runs the main example: a mesh of the
# elephant, or of the closed surface given, optimized, with a summary, meshes,
# and pictures. One of the elephant's pictures is that of the manual, in
# doc/Global_odt_mesh_3/fig.
#
#   run_main_example.sh [--histograms] [surface.off [size relative to the bounding box]]
#
# With --histograms, it prints whole quality reports.
set -euo pipefail
options=()
if [ "${1:-}" = --histograms ]; then
  options=(--histograms)
  shift
fi
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
echo "compiling, which takes some minutes"
cmake --build "$build" --target optimize_polyhedral_mesh > "$build/build.log" 2>&1 || { tail -n 50 "$build/build.log"; exit 1; }
cd "$results"
[ -z "$data" ] || export CGAL_DATA_DIR=$data
"$build/examples/Global_odt_mesh_3/optimize_polyhedral_mesh" "${options[@]}" ${surface:+"$surface"} ${2:+"$2"} > report.txt \
  || { cat report.txt; mv report.txt failed.txt; exit 1; }
grep -vE '^(mesh|picture): ' report.txt
echo
echo "In $results:"
show() { if [ -f "$1" ]; then printf '  %-47s %s\n' "$1${3:+, $3}" "$2"; fi; }
show optimized.png "the mesh cut open, before and after, with histograms"
show optimized_whole.png "the whole mesh, and cut open"
show optimized_before.vtu "for ParaView" optimized_after.vtu
show optimized_before.mesh "for Gmsh or Medit" optimized_after.mesh
show report.txt "the figures above"
