#!/usr/bin/env bash
# Downloads the headers of the CGAL of another Debian suite, without touching the
# system's package sources, and prints the directory of its CGALConfig.cmake.
#
#   fetch_cgal.sh suite directory
#
# Exit code 2: the suite cannot be reached.
set -euo pipefail
suite=$1
mkdir -p "$2"
dir=$(cd "$2" && pwd)

# The mirror is that of the system's own sources.
mirror=$(cat /etc/apt/sources.list /etc/apt/sources.list.d/*.list /etc/apt/sources.list.d/*.sources 2>/dev/null \
         | grep -v '^#' | grep -Eo '(https?|file)://[^ ]*/debian/?( |$)' | head -n 1 | tr -d ' ' || true)
if [ -z "$mirror" ]; then
  echo "no Debian mirror among the package sources" >&2
  exit 2
fi
mkdir -p "$dir/lists/partial" "$dir/cache/archives/partial"
echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $mirror $suite main" > "$dir/sources.list"
apt=(-o Dir::Etc::sourcelist="$dir/sources.list" -o Dir::Etc::sourceparts=-
     -o Dir::State::lists="$dir/lists" -o Dir::Cache="$dir/cache"
     -o APT::Sandbox::User=root -o Acquire::Retries=2)
if ! apt-get "${apt[@]}" update -qq >&2 \
   || ! (cd "$dir" && apt-get "${apt[@]}" download -qq "libcgal-dev/$suite" >&2); then
  echo "the suite $suite cannot be reached" >&2
  exit 2
fi
package=$(ls -t "$dir"/libcgal-dev_*.deb | head -n 1)
rm -rf "$dir/root"
dpkg-deb -x "$package" "$dir/root"
rm -rf "$dir/lists" "$dir/cache"
dirname "$(find "$dir/root" -name CGALConfig.cmake | head -n 1)"
