#!/bin/sh
# Checks the style, builds Hogelscope, runs its tests and checks its Debian packages. --all also
# runs the tests with the label slow, some of which take a minute.
set -eu
cd "$(dirname "$0")/.."
packaging/install.sh packaging/style-packages.txt
packaging/install.sh packaging/test-packages.txt
packaging/style.sh
packaging/build.sh
# Tests do not wait until each of their files is on the disk.
if [ "${1:-}" = --all ]; then
  eatmydata ctest --preset release
else
  eatmydata ctest --preset release -LE slow
fi
packaging/deb.sh
packaging/check_files.sh
