#!/usr/bin/env bash
# Files that have to agree do: each program is listed by CMake, each example is in the manual and its index, each public header
# begins as it should, each source has its license, and each page of the manual refers to figures that are there.
#
#   check_package.sh "package directory"
set -euo pipefail
cd "$1"
status=0

# complain MESSAGE...
complain() {
  echo "$*"
  status=1
}

for folder in examples test benchmark; do
  lists=$folder/Global_odt_mesh_3/CMakeLists.txt
  while IFS= read -r program; do
    grep -qE "(^|[(/ ])$(basename "$program" .cpp)([.) ]|$)" "$lists" || complain "$program is not in $lists"
  done < <(find "$folder/Global_odt_mesh_3" -name '*.cpp')
done

for example in examples/Global_odt_mesh_3/*.cpp; do
  name=Global_odt_mesh_3/$(basename "$example")
  grep -q "^.example $name$" doc/Global_odt_mesh_3/examples.txt || complain "$name is not in examples.txt"
  grep -q "^.cgalExample{$name}$" doc/Global_odt_mesh_3/*.txt || complain "$name is not shown in the manual"
done

for header in include/CGAL/*.h; do
  for included in CGAL/license/Mesh_3.h CGAL/Global_odt_mesh_3/internal/Requirements.h; do
    grep -q "^#include <$included>$" "$header" || complain "$header does not include $included"
  done
done

while IFS= read -r source; do
  head -n 4 "$source" | grep -q "SPDX-License-Identifier: GPL-3.0-or-later" || complain "$source has no license"
done < <(find include examples test benchmark -name '*.h' -o -name '*.cpp')

while IFS= read -r figure; do
  [ -f "doc/Global_odt_mesh_3/fig/$figure" ] || complain "there is no figure $figure"
done < <(grep -ohE '[A-Za-z0-9_]+\.(png|svg|jpg)' doc/Global_odt_mesh_3/*.txt README.md | sort -u)

exit $status
