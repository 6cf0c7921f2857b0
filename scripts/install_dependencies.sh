#!/usr/bin/env bash
# Installs what is needed to build examples, tests and benchmarks on Debian, if
# it is not there yet.
set -euo pipefail

packages="g++ cmake make ccache libcgal-dev libcgal-demo libeigen3-dev libtbb-dev libgmp-dev libmpfr-dev
          libboost-dev libboost-program-options-dev zlib1g-dev libbenchmark-dev gnuplot-nox"
missing=""
for package in $packages; do
  dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q "ok installed" || missing="$missing $package"
done
[ -z "$missing" ] && exit 0

echo "installing:$missing"
sudo=""
[ "$(id -u)" -eq 0 ] || sudo=sudo
$sudo apt-get update -qq
# shellcheck disable=SC2086
DEBIAN_FRONTEND=noninteractive $sudo apt-get install -y -qq --no-install-recommends $missing > /dev/null
