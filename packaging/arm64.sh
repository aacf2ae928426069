#!/bin/sh
# arm64.sh [MIRROR]: builds the program and the mesh plugin for arm64, and runs the tests of core and
# of the scenes there: in a Debian 12 of its own (mmdebstrap, as root, 10 to 20 minutes on two
# processors and 7 GB in TMPDIR), with a cross compiler, warnings being errors, and QEMU's user mode.
# Run by hand before a release. Installs Debian's mmdebstrap.
set -eu
cd "$(dirname "$0")/.."
echo mmdebstrap | packaging/install.sh /dev/stdin
source=$PWD
mirror=${1:-http://deb.debian.org/debian}

TMPDIR=$(mktemp -d "${TMPDIR:-/tmp}/arm64.XXXXXX")
export TMPDIR
trap 'rm -rf "$TMPDIR"' EXIT
root=$TMPDIR/root
# What runs while building is amd64's.
mmdebstrap --quiet --variant=apt bookworm "$root" "$mirror" --include \
  "cmake g++-aarch64-linux-gnu ninja-build pkg-config qemu-user qt6-base-dev-tools qt6-l10n-tools"
# What is linked is arm64's, and is only extracted, beside it: apt would not install libvtk9-dev
# without an arm64 Python, whose scripts would have to run. What both have stays amd64's.
mmdebstrap --quiet --variant=extract --architectures=arm64 bookworm - "$mirror" \
  --include "$(grep -e '-dev$' -e '^openimageio-tools$' packaging/packages.txt | tr '\n' ' ')" |
  tar -x -C "$root" --skip-old-files --keep-directory-symlink --exclude=./dev
# As the scripts of packages would have linked them.
for library in blas lapack; do
  ln -s "$library/lib$library.so.3" "$root/usr/lib/aarch64-linux-gnu"
done
# tests/scenes calls it.
printf '#!/bin/sh\nexec qemu-aarch64 /usr/bin/idiff "$@"\n' >"$root/usr/local/bin/idiff"
chmod +x "$root/usr/local/bin/idiff"

mkdir "$root/source"
# shellcheck disable=SC2016  # expanded inside
inside() { unshare --mount --pid --fork sh -c 'mount -t proc proc "$0/proc" &&
  mount -o bind,ro "$1" "$0/source" && shift && exec chroot "$0" "$@"' "$root" "$source" \
  env -i PATH=/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 HOME=/root "$@"; }
quietly() { "$@" >"$TMPDIR/log" 2>&1 || { cat "$TMPDIR/log" >&2; exit 1; }; }

quietly inside env PKG_CONFIG_LIBDIR=/usr/lib/aarch64-linux-gnu/pkgconfig:/usr/share/pkgconfig \
  cmake --preset release -S /source -B /build -D CMAKE_SYSTEM_NAME=Linux \
  -D CMAKE_SYSTEM_PROCESSOR=aarch64 -D CMAKE_C_COMPILER=aarch64-linux-gnu-gcc \
  -D CMAKE_CXX_COMPILER=aarch64-linux-gnu-g++ -D CMAKE_CROSSCOMPILING_EMULATOR=qemu-aarch64 \
  -D CMAKE_DISABLE_FIND_PACKAGE_Python3=ON -D CMAKE_DISABLE_FIND_PACKAGE_pybind11=ON
quietly inside cmake --build /build --target tests/core/all hogelscope hogelscope_plugin_mesh
times >"$TMPDIR/before"

status=0
inside env QTEST_FUNCTION_TIMEOUT=1700000 ctest --test-dir /build --parallel "$(nproc)" \
  --timeout 1800 --output-on-failure --no-tests=error --tests-regex '^(core|scenes)\.' || status=1

# Once more, also what Embree traced, which the tests let differ a little.
# shellcheck disable=SC2016  # expanded inside
inside sh -c 'cd /source/tests/scenes && for picture in */*.png; do
  idiff "$picture" "/build/tests/scenes/$picture" >/dev/null || echo "differs: $picture"
done' >"$TMPDIR/different"
cat "$TMPDIR/different"
echo "pictures: $(find tests/scenes -name '*.png' | wc -l), different: $(wc -l <"$TMPDIR/different")"
times >"$TMPDIR/after"
echo "processor time, user and system: $(tail -n 1 "$TMPDIR/before") before the tests," \
  "$(tail -n 1 "$TMPDIR/after") in all"
exit "$status"
