#!/usr/bin/env bash
# Prints, in one line, what numbers come from: commit, date, CGAL, compiler, and machine.
set -euo pipefail
cd "$(dirname "$0")/.."
compiler=${CXX:-c++}
cgal=$(printf '#include <CGAL/version.h>\nCGAL_VERSION_STR\n' | "$compiler" -E -P -x c++ - | tail -n 1 | tr -d '"')
# Tables and pictures may be new ones that are not committed yet; what makes them should not.
changes=$(git status --porcelain -- include benchmark cmake examples test scripts 2> /dev/null || true)
echo "Commit $(git rev-parse --short HEAD 2> /dev/null || echo unknown)${changes:+ with changes}, $(date -u +%Y-%m-%d)," \
     "CGAL ${cgal:-unknown}, $("$compiler" --version | head -n 1), $(sed -n 's/^model name.*: //p' /proc/cpuinfo | head -n 1)," \
     "$(nproc) cores"
