#!/usr/bin/env bash
# Downloads the headers of the CGAL of another Debian suite, without touching the
# system's package sources, and prints the directory of its CGALConfig.cmake.
#
#   fetch_cgal.sh suite directory
#
# Exit code 2: the suite cannot be reached.
set -euo pipefail
if [ $# -ne 2 ]; then
  echo "usage: $0 suite directory" >&2
  exit 1
fi
suite=$1
mkdir -p "$2"
dir=$(cd "$2" && pwd)

# The mirrors of the system's own sources, of whatever format; those of another
# archive than Debian's fail the test of the signature below.
release=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
mirrors=$(apt-get indextargets --format '$(RELEASE) $(COMPONENT) $(REPO_URI)' 'Created-By: Packages' \
          | awk -v release="$release" '$2 == "main" && ($1 == release || $1 ~ /^(oldstable|stable|testing|unstable|sid)$/) && !seen[$3]++ { print $3 }')

# fetch MIRROR: the package into $dir
fetch() {
  rm -rf "$dir/lists" "$dir/cache"
  mkdir -p "$dir/lists/partial" "$dir/cache/archives/partial"
  echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $1 $suite main" > "$dir/sources.list"
  local apt=(-o Dir::Etc::sourcelist="$dir/sources.list" -o Dir::Etc::sourceparts=-
             -o Dir::State::lists="$dir/lists" -o Dir::Cache="$dir/cache"
             -o APT::Sandbox::User=root -o APT::Get::AllowUnauthenticated=false
             -o Acquire::Languages=none -o Acquire::Retries=2 -o Acquire::http::Timeout=30)
  apt-get "${apt[@]}" update -qq >&2 \
    && (cd "$dir" && rm -f libcgal-dev_*.deb && apt-get "${apt[@]}" download -qq "libcgal-dev/$suite" >&2)
}

fetched=no
for mirror in $mirrors; do
  if fetch "$mirror"; then
    fetched=yes
    break
  fi
done
rm -rf "$dir/lists" "$dir/cache"
if [ $fetched = no ]; then
  echo "the suite $suite cannot be reached" >&2
  exit 2
fi
rm -rf "$dir/root"
dpkg-deb -x "$dir"/libcgal-dev_*.deb "$dir/root"
config=$(find "$dir/root" -name CGALConfig.cmake | head -n 1)
if [ -z "$config" ]; then
  echo "no CGALConfig.cmake in the package of $suite" >&2
  exit 1
fi
dirname "$config"
