#!/usr/bin/env bash
# Installs what is needed to build examples, tests and benchmarks on Debian, if
# it is not there yet, and the programs named, if they are to be had.
#
#   install_dependencies.sh [program ...]
set -euo pipefail
sudo=""
[ "$(id -u)" -eq 0 ] || sudo=sudo

# add_packages PACKAGE...
add_packages() {
  $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@" > /dev/null
}

packages="g++ clang cmake make ccache libcgal-dev libcgal-demo libeigen3-dev libtbb-dev libgmp-dev libmpfr-dev
          libboost-dev zlib1g-dev gnuplot-nox"
missing=""
for package in $packages; do
  dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q "ok installed" || missing="$missing $package"
done
if [ -n "$missing" ]; then
  if ! command -v apt-get > /dev/null; then
    echo "this is no Debian; install what corresponds to:$missing" >&2
    exit 1
  fi
  echo "installing:$missing"
  # What matters is whether the packages can be installed, not whether every source answers.
  $sudo apt-get update -qq || true
  # shellcheck disable=SC2086
  add_packages $missing
fi
for program in "$@"; do
  command -v "$program" > /dev/null || add_packages "$program" 2> /dev/null || echo "$program cannot be installed"
done
