#!/usr/bin/env bash
# Unpacks meshes and images of CGAL's data package, as Debian ships it, below the
# directory given, and prints where they are. Prints nothing if there is none.
set -euo pipefail
target=$1/data
archive=/usr/share/doc/libcgal-demo/data.tar.gz
if [ ! -f "$target/meshes/spool.off" ] && [ -f "$archive" ]; then
  mkdir -p "$1"
  tar xzf "$archive" -C "$1" data/meshes data/images
fi
[ ! -d "$target" ] || (cd "$target" && pwd)
