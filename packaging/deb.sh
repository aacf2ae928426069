#!/bin/sh
# Builds the Debian packages hogelscope, hogelscope-window, libhogelscope-dev and
# python3-hogelscope into build/release/packages.
set -eu
here=$(dirname "$0")
"$here/build.sh" hogelscope_installed
cd "$here/.."
rm -rf build/release/packages/*.deb
umask 022
(cd build/release && cpack -G DEB >packages.log 2>&1) || {
  cat build/release/packages.log >&2
  exit 1
}
rm -rf build/release/packages/_CPack_Packages
ls build/release/packages/*.deb
