#!/usr/bin/env bash
# Makes the tables and pictures of the manual and of README.md from the commit that is checked out: those in
# doc/Global_odt_mesh_3/results and doc/Global_odt_mesh_3/fig, and what is between "<!-- results -->" and
# "<!-- end of results -->" in README.md.
#
#   renew_figures.sh [--large] [--paper] [--quick] [--runs N] [--output DIRECTORY] [PART ...]
#
# Parts, all of which are made if none is named:
#   provenance quality tools files threads large sizes quadrature boundary search insertion robustness periodic
#   parameter_number_of_rounds parameter_sliver_bound parameter_surface_weight parameter_insertion parameter_sizing_field
#   parameter_number_of_vertices parameter_time_limit pictures
# --large goes on to meshes of 271,000 and 891,000 vertices, --paper adds the experiments of the paper, and --runs is the number of
# random runs, 100 without it. --quick tries everything with small settings, and leaves tables and pictures in the directory, which is
# build-figures if none is named. What a part that fails has not made stays as it was, and the others go on. Nothing else should run
# meanwhile.
set -euo pipefail
cd "$(dirname "$0")/.."
parts=(provenance quality tools files threads large sizes quadrature boundary search insertion robustness periodic
       parameter_number_of_rounds parameter_sliver_bound parameter_surface_weight parameter_insertion parameter_sizing_field
       parameter_number_of_vertices parameter_time_limit pictures)
most_vertices=100000
quick=0
runs=100
output="build-figures"
paper=()
wanted=()
while [ $# -gt 0 ]; do
  case $1 in
    --large) most_vertices=1000000 ;;
    --paper) paper=(paper) ;;
    --quick) quick=1 ;;
    --runs) runs=$2; shift ;;
    --output) output=$2; shift ;;
    *)
      case " ${parts[*]} " in
        *" $1 "*) wanted+=("$1") ;;
        *) sed -n '2,17s/^# \{0,1\}//p' "$0" >&2; exit 2 ;;
      esac ;;
  esac
  shift
done
[ ${#wanted[@]} -gt 0 ] || wanted=("${parts[@]}")
mkdir -p "$output"
output=$(cd "$output" && pwd)
results=$PWD/doc/Global_odt_mesh_3/results
figures=$PWD/doc/Global_odt_mesh_3/fig
readme=$PWD/README.md
if [ $quick -eq 1 ]; then
  results=$output/results
  figures=$output/fig
  readme=$output/README.md
  cp README.md "$readme"
fi
mkdir -p "$results" "$figures"
# Two parts share large meshes, which take longer to be made than to be optimized.
rm -rf "$output/meshes"
mkdir "$output/meshes"

scripts/install_dependencies.sh tetgen gmsh
CGAL_DATA_DIR=${CGAL_DATA_DIR:-$(scripts/extract_data.sh "$output")}
export CGAL_DATA_DIR
[ -d "$CGAL_DATA_DIR/meshes" ] || { echo "CGAL's data is not there; CGAL_DATA_DIR says where it is" >&2; exit 1; }
build=$output/build

# configure DIRECTORY OPTION...
configure() {
  cmake -S . -B "$1" -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DCGAL_DATA_DIR="$CGAL_DATA_DIR" "${@:2}" \
    > "$1.log" 2>&1 || { cat "$1.log"; return 1; }
}

# compile TARGET...: one after another.
compile() {
  cmake --build "$build" --target "$@" > "$output/compile.log" 2>&1 || { tail -n 50 "$output/compile.log"; return 1; }
}

# choose USUAL QUICK: the setting of this run.
choose() {
  if [ "$quick" -eq 1 ]; then echo "$2"; else echo "$1"; fi
}

# programs PART: those that make it.
programs() {
  case $1 in
    quality) echo compare_qualities ;;
    tools) echo compare_tools ;;
    files) echo optimize_mesh ;;
    threads | large) echo scale ;;
    sizes) echo follow_sizes ;;
    quadrature) echo graded_cube ;;
    boundary) echo move_boundary ;;
    search) echo search_in_cube ;;
    insertion) echo insert_vertices ;;
    periodic) echo compare_periodic ;;
    parameter_*) echo vary_parameters ;;
    pictures) printf '%s\n' optimize_polyhedral_mesh remesh_boundary optimize_graded_mesh optimize_mesh_with_features \
                             optimize_labeled_image_mesh optimize_periodic_mesh draw_parameters ;;
  esac
}

# table PART ARGUMENT...: what its program prints. Empty arguments are none.
table() {
  local name=$1 program argument arguments=()
  program=$(programs "$1")
  for argument in "${@:2}"; do [ -z "$argument" ] || arguments+=("$argument"); done
  compile "$program"
  "$build/benchmark/Global_odt_mesh_3/$program" "${arguments[@]}" > "$output/$name.md" 2> "$output/$name.log" \
    || { tail "$output/$name.log"; return 1; }
  mv "$output/$name.md" "$results/$name.md"
}

# picture NAME PROGRAM FILE ARGUMENT...: the one that an example or a benchmark writes to that file.
picture() {
  local program=$build/examples/Global_odt_mesh_3/$2
  compile "$2"
  [ -x "$program" ] || program=$build/benchmark/Global_odt_mesh_3/$2
  rm -rf "${output:?}/$1"
  mkdir "$output/$1"
  (cd "$output/$1" && "$program" "${@:4}" > log.txt) || { tail "$output/$1/log.txt"; return 1; }
  cp "$output/$1/$3" "$figures/$1.png"
}

make_tools() {
  local directory=$output/tools
  rm -rf "$directory"
  mkdir "$directory"
  table tools "$directory" "$(choose '' sphere)"
  mv "$directory/readme.md" "$results/readme.md"
  cp "$directory/time_and_quality_sphere.png" "$figures/"
  [ "$quick" -eq 1 ] || cp "$directory/time_and_quality_elephant.png" "$figures/"
  if grep -qx '<!-- results -->' "$readme" && grep -qx '<!-- end of results -->' "$readme"; then
    { echo; cat "$results/readme.md"; echo; } > "$directory/between.md"
    sed -i -e '/^<!-- results -->$/,/^<!-- end of results -->$/{//!d}' -e "/^<!-- results -->\$/r $directory/between.md" "$readme"
  else
    echo "$readme has no lines <!-- results --> and <!-- end of results -->, and stays as it is"
  fi
}

# Gmsh and Netgen, as far as their modules for the Python of the system are there.
make_files() {
  scripts/install_dependencies.sh python3-gmsh python3-netgen netgen-doc
  compile optimize_mesh
  /usr/bin/python3 scripts/compare_on_files.py "$build/examples/Global_odt_mesh_3/optimize_mesh" "$output/files" \
    > "$output/files.md" 2> "$output/files.log" || { tail "$output/files.log"; return 1; }
  mv "$output/files.md" "$results/"
}

# With the assertions of CGAL, hence apart from what is measured. Runs that are not well are a result.
make_robustness() {
  local directory=$output/robustness
  rm -rf "$directory"
  mkdir "$directory"
  configure "$build-with-assertions" -DGLOBAL_ODT_MESH_3_BUILD_BENCHMARKS=ON -DCMAKE_CXX_FLAGS_RELEASE=-O2
  cmake --build "$build-with-assertions" --target random_runs > "$output/compile.log" 2>&1 \
    || { tail -n 50 "$output/compile.log"; return 1; }
  "$build-with-assertions/benchmark/Global_odt_mesh_3/random_runs" "$directory/runs" both "$(choose "$runs" 4)" 1 "$(nproc)" \
    > "$directory/table.md" || echo "some runs are not well; see $directory"
  [ -s "$directory/table.md" ]
  mv "$directory/table.md" "$results/robustness.md"
}

make_pictures() {
  # What scripts/run_main_example.sh draws.
  picture elephant_before_after optimize_polyhedral_mesh optimized.png
  picture boundary_before_after remesh_boundary remeshed_boundary.png
  picture density_before_after optimize_graded_mesh graded.png
  picture cad_part_before_after optimize_mesh_with_features features.png "$CGAL_DATA_DIR/meshes/couplingdown.off" 0.03
  picture tissues_before_after optimize_labeled_image_mesh labeled_image.png
  picture periodic_before_after optimize_periodic_mesh periodic.png
  picture parameters draw_parameters parameters.png
}

make_paper() {
  local figure made options=(--output "$output/paper")
  [ "$quick" -eq 0 ] || options+=(--quick)
  scripts/reproduce_paper.sh "${options[@]}"
  cp "$output/paper/paper.md" "$results/"
  for figure in doc/Global_odt_mesh_3/fig/paper_*.png; do
    figure=$(basename "$figure")
    made=$(find "$output/paper" -name "${figure#paper_}" | head -n 1)
    if [ -n "$made" ]; then cp "$made" "$figures/$figure"; else echo "there is no new $figure"; fi
  done
}

make_part() {
  case $1 in
    provenance)
      scripts/describe_machine.sh > "$output/provenance.md"
      mv "$output/provenance.md" "$results/" ;;
    quality) table quality "$(choose 5 2)" "$(choose '' 'coarse cross')" ;;
    tools) make_tools ;;
    files) make_files ;;
    threads) table threads threads "$output/meshes" "$(choose "$most_vertices" 18000)" ;;
    large) table large stages "$output/meshes" "$(choose "$most_vertices" 18000)" ;;
    sizes) table sizes "$(choose 3 1)" ;;
    quadrature) table quadrature "$(choose 3 1)" "$(choose 4000 800)" "$(choose 1200 100)" ;;
    boundary) table boundary "$(choose 10 1)" "$(choose '' 'coarse sphere')" ;;
    search) table search "$(choose 3 1)" 1 0 rows "$(choose 18083 4000)" ;;
    insertion) table insertion "$(choose '' joint)" ;;
    robustness) make_robustness ;;
    periodic) table periodic "$(choose '' 0.12)" ;;
    parameter_*) table "$1" "${1#parameter_}" ;;
    pictures) make_pictures ;;
    paper) make_paper ;;
  esac
}

# What takes the most is compiled at once, after the libraries that all link; a part whose program cannot be compiled says why.
configure "$build" -DGLOBAL_ODT_MESH_3_BUILD_BENCHMARKS=ON -DGLOBAL_ODT_MESH_3_BUILD_EXAMPLES=ON
compile core_for_benchmarks core_for_examples
begin=$SECONDS
for part in "${wanted[@]}"; do programs "$part"; done | sort -u \
  | xargs -P "${JOBS:-2}" -I '{}' cmake --build "$build" --target '{}' > "$output/compile.log" 2>&1 || true
echo "compiled in $((SECONDS - begin)) s"

status=0
for part in "${wanted[@]}" "${paper[@]}"; do
  echo "=== $part ==="
  begin=$SECONDS
  # In a process of its own, the first command that fails is the last, which it would not be in a condition.
  set +e
  (set -e; make_part "$part")
  code=$?
  set -e
  [ $code -eq 0 ] || { status=1; echo "$part has failed; what it has not made is as it was"; }
  echo "$((SECONDS - begin)) s"
done
exit $status
