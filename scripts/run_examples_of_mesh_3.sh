#!/usr/bin/env bash
# Builds and runs the examples of CGAL's own packages Mesh_3 and Periodic_3_mesh_3, as Debian ships them, three times: as
# they are; with the headers of this package first; and so with odt() added to the calls of make_mesh_3() of those that use no global optimizer.
#
#   run_examples_of_mesh_3.sh [--output directory, default build-mesh-3-examples] [example ...]
#
# Without any, all examples. With our headers, they have to write meshes with the same numbers of vertices, edges of features,
# corners, and the same subdomains and patches. (No more than that is the same each time the examples run as they are, since
# CGAL's perturbation depends on addresses. Of those that begin with random points, not even the numbers are, which is seen from
# a second run; and a mesh that is refined after odt() gets other vertices.) The exit status says whether that is so.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
output=build-mesh-3-examples
examples=()
while [ $# -gt 0 ]; do
  case $1 in
    --output) output=$2; shift ;;
    -*) sed -n '2,12s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
    *) examples+=("$1") ;;
  esac
  shift
done
scripts/install_dependencies.sh
mkdir -p "$output"
output=$(cd "$output" && pwd)
most_seconds=600
tar xzf /usr/share/doc/libcgal-dev/examples.tar.gz -C "$output" examples/Mesh_3 examples/Periodic_3_mesh_3
[ -d "$output/data/meshes" ] || tar xzf /usr/share/doc/libcgal-demo/data.tar.gz -C "$output"
export CGAL_DATA_DIR=$output/data

# The names of the examples in a directory.
names() { sed -n 's/.*create_single_source_cgal_program( *"\{0,1\}\([a-zA-Z0-9_]*\)\.cpp.*/\1/p; s/^ *"\([a-zA-Z0-9_]*\)\.cpp".*/\1/p' "$1/CMakeLists.txt" | grep -v '^implicit_functions$' | sort -u; }

# build VARIANT PACKAGE: all examples wanted, as far as they can be built.
build() {
  local directory=$output/$1/$2
  rm -rf "$directory"
  mkdir -p "$directory"
  cp -r "$output/examples/$2" "$directory/source"
  # Some call a global optimizer already.
  [ "$1" != odt ] || grep -LE 'odt|lloyd' "$directory"/source/*.cpp \
    | xargs sed -i -E 's/(make_(periodic_3_)?mesh_3<[A-Za-z0-9_]*>\([a-z_]*domain, *[a-z_]*criteria)/\1, CGAL::parameters::odt()/'
  local flags=""
  [ "$1" = plain ] || flags="-I$root/include"
  # They take longer to compile than to run, hence -O1.
  cmake -S "$directory/source" -B "$directory/build" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_FLAGS="$flags" \
        -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" -DCMAKE_CXX_COMPILER_LAUNCHER=ccache > "$directory/log.txt" 2>&1
  local name
  for name in $(names "$directory/source"); do
    ! is_wanted "$name" || echo "$name"
  done > "$directory/wanted.txt"
  # The targets of one makefile are built one after another, hence a process for each.
  xargs -r -P "${JOBS:-2}" -I '{}' cmake --build "$directory/build" --target '{}' < "$directory/wanted.txt" \
    >> "$directory/log.txt" 2>&1 || true
}

is_wanted() {
  [ ${#examples[@]} -eq 0 ] && return 0
  local e
  for e in "${examples[@]}"; do [ "$e" = "$1" ] && return 0; done
  return 1
}

# run VARIANT PACKAGE NAME [RUNS]: in a directory of its own.
run() {
  local directory=$output/$1/$2/${4:-runs}/$3
  rm -rf "$directory"
  mkdir -p "$directory"
  ln -s "$output/examples/$2/data" "$directory/data"
  (cd "$directory" && timeout "$most_seconds" "../../build/$3" > out.txt 2> err.txt < /dev/null)
}

# kept VARIANT PACKAGE NAME FILE: from what is the same in meshes, what has to be so in one of an example.
kept() {
  local plain=$output/plain/$2
  if { [ "$1" = odt ] && grep -q refine_ "$output/odt/$2/source/$3.cpp"; } \
     || ! diff <(invariants "$plain/runs/$3/$4") <(invariants "$plain/second_runs/$3/$4") > /dev/null
  then grep -vE '^(Vertices|Edges) '; else cat; fi
}

# What has to be the same for a mesh file, whatever the places of its vertices.
invariants() {
  awk '/^(Vertices|Edges|Corners|Triangles|Tetrahedra)$/ { what = $1; getline; count = $1; for(n = 0; n < count; ++n) { getline; label[what " " $NF] }
         if(what != "Triangles" && what != "Tetrahedra") print what, count }
       END { for(l in label) if(l ~ /^(Triangles|Tetrahedra)/) print l }' "$1" | sort
}

status=0
fail() { echo "FAILED: $1"; status=1; }

for package in Mesh_3 Periodic_3_mesh_3; do
  for variant in plain ours odt; do build $variant $package; done
  for name in $(cat "$output/plain/$package/wanted.txt"); do
    if [ ! -x "$output/plain/$package/build/$name" ]; then
      echo "$name: cannot be built"
      continue
    fi
    if ! run plain $package "$name" || ! run plain $package "$name" second_runs; then
      echo "$name: does not run"
      continue
    fi
    for variant in ours odt; do
      if [ ! -x "$output/$variant/$package/build/$name" ]; then
        fail "$name, $variant: cannot be built"
      elif ! run $variant $package "$name"; then
        fail "$name, $variant: does not run"
      else
        for file in "$output/plain/$package/runs/$name"/*.mesh; do
          [ -f "$file" ] || continue
          mesh=$(basename "$file")
          other=$output/$variant/$package/runs/$name/$mesh
          diff <(invariants "$file" | kept $variant $package "$name" "$mesh") \
               <(invariants "$other" | kept $variant $package "$name" "$mesh") \
            > /dev/null || fail "$name, $variant: $mesh has other vertices, features or labels"
        done
      fi
    done
    echo "$name: done"
  done
done
exit $status
