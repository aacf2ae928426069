#!/bin/sh
# Builds Hogelscope and runs all its tests.
set -eu
here=$(dirname "$0")
"$here/build.sh"
cd "$here/.."
ctest --preset release
