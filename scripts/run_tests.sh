#!/usr/bin/env bash
# Installs what is missing; builds and runs the tests, and the examples on files that they refuse, with the CGAL of the system or those
# that are named: `trixie` and `testing` are those of Debian 13 and of Debian testing, with which the tests of the contract are
# run, and with the latter two examples in a tree of headers as a release of CGAL that contains the package has it. Where a suite
# of Debian cannot be reached, its CGAL is not tested.
#
#   [JOBS=n] [BUILD=directory] run_tests.sh [system] [trixie] [testing]
#
# A compiler needs up to 6 GB, hence two jobs at a time if nothing else is said.
set -euo pipefail
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- system
for suite; do
  case $suite in
    system | trixie | testing) ;;
    *) echo "no CGAL has the name $suite" >&2; exit 2 ;;
  esac
done
scripts/install_dependencies.sh
build=${BUILD:-build-tests}
export JOBS=${JOBS:-2}
mkdir -p "$build"
data=$(scripts/extract_data.sh "$build")

# GCC, unless told so, collects garbage all the time.
if ${CXX:-c++} -v 2>&1 | grep -q "^gcc version"; then
  export CXXFLAGS="${CXXFLAGS:-} --param ggc-min-heapsize=1000000"
fi

# run NAME OPTION...: with the CGAL of that name. Tests and examples take longer to compile than to run, hence -O1.
run() {
  local name=$1
  shift
  echo "=== tests with the CGAL of $name ==="
  cmake -S . -B "$build/$name" -DCMAKE_BUILD_TYPE=Release -DGLOBAL_ODT_MESH_3_BUILD_TESTS=ON -DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" \
        -DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DCGAL_DATA_DIR="$data" "$@" \
        > "$build/$name.log" 2>&1 || { cat "$build/$name.log"; return 1; }
  cmake --build "$build/$name" -j"$JOBS" || return 1
  # Not the tests that compile, which CGAL adds for each program.
  (cd "$build/$name" && ctest -j"$JOBS" -R '^test_' --output-on-failure)
}

status=0
for suite; do
  if [ "$suite" = system ]; then
    run system -DGLOBAL_ODT_MESH_3_BUILD_EXAMPLES=ON || status=1
    continue
  fi
  code=0
  cgal=$(scripts/fetch_cgal.sh "$suite" "$build/$suite-cgal") || code=$?
  case $code in
    0) ;;
    2) echo "=== $suite cannot be reached: its CGAL is not tested ==="; continue ;;
    *) status=1; continue ;;
  esac
  # Domains of all kinds with one version, calls of all kinds with the other.
  if [ "$suite" = trixie ]; then
    run "$suite" "-DCGAL_DIR=$cgal" "-DGLOBAL_ODT_MESH_3_CONTRACT_TESTS=domains" || status=1
  else
    run "$suite" "-DCGAL_DIR=$cgal" "-DGLOBAL_ODT_MESH_3_CONTRACT_TESTS=call|own_domain|periodic|preconditions|report|transaction" || status=1
    echo "=== a release of CGAL that contains the package ==="
    scripts/check_merge.sh "${cgal%/lib/*}/include" "$build/merge" || status=1
  fi
done
exit $status
