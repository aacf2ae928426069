#!/bin/sh
# build.sh [TARGET]: installs the Debian packages that are missing, configures and builds into
# build/release.
# try.sh and check.sh begin with it.
set -eu
cd "$(dirname "$0")/.."

missing=
for package in $(grep -v '^#' packaging/packages.txt); do
  dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' ||
    missing="$missing $package"
done
if [ -n "$missing" ]; then
  as_root=
  [ "$(id -u)" -eq 0 ] || as_root=sudo
  echo "Installing:$missing"
  $as_root apt-get update -qq
  # shellcheck disable=SC2086  # one word a package
  $as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends $missing >/dev/null
fi

[ -f build/release/build.ninja ] || cmake --preset release >/dev/null
cmake --build --preset release ${1:+--target "$1"}
