#!/bin/sh
# build.sh [TARGET...]: installs the Debian packages that are missing, configures and builds into
# build/release.
# try.sh and check.sh begin with it.
set -eu
cd "$(dirname "$0")/.."

packaging/install.sh packaging/packages.txt
[ -f build/release/build.ninja ] || cmake --preset release >/dev/null
[ $# -eq 0 ] || set -- --target "$@"
cmake --build --preset release "$@"
