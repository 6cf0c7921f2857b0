#!/usr/bin/env bash
# Makes the tree of headers of a release that contains this package: those of a CGAL, with ours in the place of files of the same
# names, and, from CGAL 5.6 on, our named parameters declared as CGAL declares them. Then it builds and runs two examples with it.
#
#   check_merge.sh "directory with CGAL's include/" "build directory"
set -euo pipefail
if [ $# -ne 2 ]; then
  sed -n '2,5s/^# \{0,1\}//p' "$0" >&2
  exit 2
fi
cgal=$(cd "$1" && pwd)
mkdir -p "$2"
build=$(cd "$2" && pwd)
cd "$(dirname "$0")/.."
tree=$build/include
rm -rf "$tree"
mkdir "$tree"
cp -r "$cgal/CGAL" "$tree"

# What a merge replaces is what the manual says, and nothing else.
replaced=$(cd include && find CGAL -type f -exec sh -c 'for f; do [ ! -e "$0/$f" ] || echo "$f"; done' "$tree" {} +)
if [ "$replaced" != CGAL/odt_optimize_mesh_3.h ]; then
  echo "a merge replaces: $replaced" >&2
  exit 1
fi
cp -r include/CGAL "$tree"

interface=$tree/CGAL/STL_Extension/internal/parameters_interface.h
if grep -q CGAL_add_named_parameter_with_compatibility "$interface"; then
  {
    echo "#ifndef CGAL_NAMED_PARAMETERS_OF_GLOBAL_ODT_MESH_3"
    echo "#define CGAL_NAMED_PARAMETERS_OF_GLOBAL_ODT_MESH_3"
    echo "#endif"
    sed -n 's/^inline constexpr Global_odt_parameter<internal_np::\([a-z_]*\)_t> .*/\1/p' \
        include/CGAL/Global_odt_mesh_3/internal/door/Named_parameters.h \
      | while IFS= read -r name; do
          grep -qE "[ (,]${name}_t *," "$interface" \
            || echo "CGAL_add_named_parameter_with_compatibility(${name}_t, $name, $name)"
        done
  } >> "$interface"
fi

eigen=$(dirname "$(find /usr/include /usr/local/include -path '*/Eigen/Core' -print -quit)")/..
flags=(-std=c++17 -O1 -frounding-math -DCGAL_GLOBAL_ODT_MESH_3_COMPILED_CORE "-I$tree" -isystem "$eigen")
compiler=${CXX:-c++}
examples=(optimize_implicit_mesh optimize_with_density)
for program in cmake/Global_odt_mesh_3_core "${examples[@]/#/examples/Global_odt_mesh_3/}"; do
  echo "$program"
done | xargs -P "${JOBS:-2}" -I PROGRAM sh -c 'program=$1 build=$2; shift 2; exec "$@" -c "$program.cpp" -o "$build/$(basename "$program").o"' \
                                              sh PROGRAM "$build" "$compiler" "${flags[@]}"
for example in "${examples[@]}"; do
  "$compiler" "$build/$example.o" "$build/Global_odt_mesh_3_core.o" -o "$build/$example" -lmpfr -lgmp
  (cd "$build" && "./$example" > "$example.log") || { cat "$build/$example.log"; exit 1; }
  echo "$example: well"
done
