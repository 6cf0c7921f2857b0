#!/usr/bin/env bash
# Files that have to agree do: each program is listed by CMake, each example is in the manual and its index, each public header
# begins as it should, each source has its license, and each page of the manual refers to figures that are there. And what CGAL's
# scripts check of a branch that is to be merged: license headers, names of projects, permissions, and text files.
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

# For tests, examples are compiled together, but each includes what it names of what any of them includes. Kernels include Bbox_3.h.
headers=$(grep -hE '^#include <CGAL/' examples/Global_odt_mesh_3/*.{cpp,h} | grep -v Bbox_3 | sort -u)
for source in examples/Global_odt_mesh_3/*.{cpp,h}; do
  for name in $(grep -oE '\bCGAL::[A-Za-z0-9_]+' "$source" | sort -u); do
    line="#include <CGAL/${name#CGAL::}.h>"
    ! grep -qF "$line" <<< "$headers" || grep -qF "$line" "$source" || complain "$source names $name and does not include its header"
  done
done

for header in include/CGAL/*.h; do
  grep -q "^#include <CGAL/Global_odt_mesh_3/internal/Requirements.h>$" "$header" || complain "$header does not include Requirements.h"
done

while IFS= read -r header; do
  grep -q "^#include <CGAL/license/Global_odt_mesh_3.h>$" "$header" || complain "$header does not include the license header"
  for line in '^// [$]URL[$]$' '^// [$]Id[$]$' '^// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial$' '^// Author(s) '; do
    head -n 8 "$header" | grep -q "$line" || complain "$header does not begin as CGAL's headers do: $line"
  done
done < <(find include -name '*.h' ! -path '*/license/*')

# File systems that ignore case know one of two such names.
while IFS= read -r name; do
  complain "two headers differ by case only: $name"
done < <(find include -name '*.h' -exec basename {} \; | tr '[:upper:]' '[:lower:]' | sort | uniq -d)

for folder in test:Tests examples:Examples; do
  grep -qE "^project\( *Global_odt_mesh_3_${folder#*:} *\)" "${folder%:*}/Global_odt_mesh_3/CMakeLists.txt" \
    || complain "the project in ${folder%:*} has another name than CGAL wants"
done

texts=$(find include examples test benchmark doc package_info cmake scripts -type f ! -name '*.png' ! -name '*.svg')
# shellcheck disable=SC2086
for text in $(grep -lE '[[:blank:]]+$' $texts) $(grep -lP '\t|\r' $texts); do
  complain "$text has trailing blanks, tabs, or ends of lines of Windows"
done
while IFS= read -r file; do
  complain "$file is executable"
done < <(find include examples benchmark doc package_info cmake -type f -perm -u+x)

while IFS= read -r source; do
  head -n 8 "$source" | grep -q "SPDX-License-Identifier: GPL-3.0-or-later" || complain "$source has no license"
done < <(find include examples test benchmark -name '*.h' -o -name '*.cpp')

while IFS= read -r figure; do
  [ -f "doc/Global_odt_mesh_3/fig/$figure" ] || complain "there is no figure $figure"
done < <(grep -ohE '[A-Za-z0-9_]+\.(png|svg|jpg)' doc/Global_odt_mesh_3/*.txt README.md | sort -u)

exit $status
