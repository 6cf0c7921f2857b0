#!/usr/bin/env bash
# Builds and runs what the paper shows, figure by figure, and collects rows "paper / here" in one table,
# with pictures beside it.
#
#   reproduce_paper.sh [--quick] [--output directory, default build-paper] [figure ...]
#
# Figures are 3, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, and table1 and table2; without any, all. Those
# that one program makes come together. --quick runs small meshes and few seeds, without 8, 13 and 15. The exit status says
# whether what the paper claims holds. TetGen, Gmsh and Netgen are installed if they are to be had; else their rows say that
# they are not there.
set -euo pipefail
cd "$(dirname "$0")/.."
quick=0
output=build-paper
figures=()
while [ $# -gt 0 ]; do
  case $1 in
    --quick) quick=1 ;;
    --output) output=$2; shift ;;
    [0-9]* | table1 | table2) figures+=("$1") ;;
    *) sed -n '2,10s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
  esac
  shift
done
if [ ${#figures[@]} -eq 0 ]; then
  figures=(3 6 9 11 12 14 17 19 table1 table2)
  [ $quick -eq 1 ] || figures+=(8 13 15)
fi

scripts/install_dependencies.sh tetgen gmsh netgen

# The program of a figure.
program() {
  case $1 in
    3 | 10 | 18) echo optimize_in_plane ;;
    6 | 7) echo minimize_in_cube ;;
    8) echo graded_cube ;;
    9) echo newton_in_ball ;;
    11) echo search_in_cube ;;
    12 | 14 | 15 | 16 | 17 | 21 | table2) echo improve_models ;;
    13) echo follow_sizes ;;
    19 | 20) echo compare_with_cvt ;;
    table1) echo solve_poisson ;;
    *) echo "there is no figure $1" >&2; return 1 ;;
  esac
}

# Its arguments, with "@" for the directory of what it writes; the first of each pair is for quick runs.
arguments() {
  local set
  case $1 in
    3 | 10 | 18) set=("1 400 20 @" "3 1000 100 @") ;;
    6 | 7) set=("3 4000 @" "200 18083 @") ;;
    8) set=("1 800 100 @" "3 4000 1200 @") ;;
    9) set=("1 20 @" "3 50 @") ;;
    11) set=("1 1 0 rows 4000 @" "3 1 0 rows 18083 @") ;;
    12) set=("12 2.5 @" "12 1 @") ;;
    13) set=("1 @" "1 @") ;;
    14) set=("14 2 @" "14 1 @") ;;
    15) set=("15 3 @" "15 1 @") ;;
    16 | 17) set=("17 4 @" "17 1 @") ;;
    19 | 20) set=("1 2000 @" "3 10000 @") ;;
    21 | table2) set=("2 2 @" "2 1 @") ;;
    table1) set=("1 3 2000 @" "5 3 10000 @") ;;
  esac
  echo "${set[1 - quick]}"
}

mkdir -p "$output"
output=$(cd "$output" && pwd)
data=$(scripts/extract_data.sh "$output")
cmake -S . -B "$output/build" -DCMAKE_BUILD_TYPE=Release -DGLOBAL_ODT_MESH_3_BUILD_BENCHMARKS=ON \
      -DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DCGAL_DATA_DIR="$data" > "$output/configure.log" 2>&1 \
  || { cat "$output/configure.log"; exit 1; }
# The targets of one makefile are built one after another, hence a process for each, after the library that all link.
cmake --build "$output/build" --target core_for_benchmarks
for f in "${figures[@]}"; do program "$f"; done | sort -u \
  | xargs -P "${JOBS:-2}" -I '{}' cmake --build "$output/build" --target '{}'

export CGAL_DATA_DIR=$data
table=$output/paper.md
{
  echo "$(scripts/describe_machine.sh)$([ $quick -eq 0 ] || echo ', quick run')"
  echo
  echo "| figure | what | paper | here |"
  echo "|---|---|---:|---:|"
} > "$table"
status=0
done_runs=""
for f in "${figures[@]}"; do
  run="$(program "$f") $(arguments "$f")"
  case $done_runs in *"<$run>"*) continue ;; esac
  done_runs="$done_runs<$run>"
  directory=$output/figure_$f
  rm -rf "$directory"
  mkdir -p "$directory"
  echo "=== figure $f: ${run/@/$directory} ==="
  begin=$SECONDS
  # shellcheck disable=SC2046
  "$output/build/benchmark/Global_odt_mesh_3/$(program "$f")" $(arguments "$f" | sed "s|@|$directory|") > "$directory/log.txt" 2>&1 \
    || { status=1; echo "figure $f: a claim of the paper does not hold, or the program failed; see $directory/log.txt"; }
  echo "$((SECONDS - begin)) s"
  [ ! -f "$directory/rows.md" ] || cat "$directory/rows.md" >> "$table"
done
cat "$table"
echo "the table is $table; pictures:"
find "$output" -path "$output/build" -prune -o -name '*.png' -print
exit $status
