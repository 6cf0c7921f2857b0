#!/usr/bin/env bash
# Headers include only those of their own folder and of folders before it, so that data flows one way, and
# stay short: no internal file has more than 450 lines after its license, and no function more than 40.
#
#   check_architecture.sh "internal directory"
set -euo pipefail
counter=$(cd "$(dirname "$0")/../../scripts" && pwd)/count_lines_of_code.sh
cd "$1"
status=0

most_lines=14140
lines=$("$counter" ../../..)
if [ "$lines" -gt $most_lines ]; then
  echo "the headers have $lines lines of code: which of them can go?"
  status=1
fi

# Beside each other: geometry and parallel. Only the door, which comes last, knows the types of the user.
rank() {
  case $1 in
    geometry | parallel) echo 0 ;; interface) echo 1 ;; density) echo 2 ;; energy) echo 3 ;; triangulation) echo 4 ;;
    sizing) echo 5 ;; optimization) echo 6 ;; surface) echo 7 ;; blocks) echo 8 ;; complex) echo 9 ;; slivers) echo 10 ;;
    .) echo 11 ;; door) echo 12 ;; *) echo unknown ;;
  esac
}

while IFS= read -r file; do
  folder=$(dirname "${file#./}")
  while IFS= read -r included; do
    other=$(dirname "$included")
    # Checked parameters occur everywhere, as assertions do.
    if [ "$included" != Parameter_check.h ] && [ "$folder" != "$other" ] && ! [ "$(rank "$other")" -lt "$(rank "$folder")" ]; then
      echo "$file includes $included"
      status=1
    fi
  done < <(sed -n 's|^#include <CGAL/Global_odt_mesh_3/internal/\(.*\)>|\1|p' "$file")
  lines=$(sed "1,/^$/d" "$file" | wc -l)
  if [ "$lines" -gt 450 ]; then
    echo "$file has $lines lines"
    status=1
  fi
done < <(find . -name '*.h')

# The order in which operands and arguments are evaluated is up to the compiler.
if grep -rnE 'random[a-z_]*(\.|->)[a-z_]+\([^;=]*random[a-z_]*(\.|->)[a-z_]+\(' --include='*.h' .; then
  echo "an expression draws two random numbers"
  status=1
fi

# Braces on lines of their own, at most one level deep, that do not follow the head of a class or namespace.
find . -name '*.h' -exec awk '
  FNR == 1 { inside = 0; previous = "" }
  !inside && /^ ? ?{$/ && previous !~ /^ *(namespace|class|struct|enum|: (private|public))/ {
    inside = 1; begin = FNR; indent = $0; sub(/{$/, "", indent); name = previous
  }
  inside && index($0, indent "}") == 1 {
    if(FNR - begin - 1 > 40) { print FILENAME ": " FNR - begin - 1 " lines in " name; long = 1 }
    inside = 0
  }
  { previous = $0 }
  END { exit long }' {} + || status=1
exit $status
