#!/bin/sh
# Checks the style, builds Hogelscope and runs all its tests.
set -eu
cd "$(dirname "$0")/.."
packaging/install.sh packaging/style-packages.txt
packaging/style.sh
packaging/build.sh
ctest --preset release
