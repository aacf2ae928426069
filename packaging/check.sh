#!/bin/sh
# Checks the style, builds Hogelscope, runs all its tests and checks its Debian packages.
set -eu
cd "$(dirname "$0")/.."
packaging/install.sh packaging/style-packages.txt
packaging/style.sh
packaging/build.sh
ctest --preset release
packaging/deb.sh
packaging/check_files.sh
