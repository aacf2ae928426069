#!/bin/sh
# check_deb.sh [MIRROR]: builds the Debian packages and tries them in a bare Debian 12 (mmdebstrap, as
# root, about 4 minutes and 1.2 GB in /tmp): installs, renders, compares with the build tree's picture,
# removes. Run by hand before a release; check.sh has what is quick. Needs Debian's mmdebstrap and
# devscripts.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/.."
mirror=${1:-$(sed -n 's/^deb \(\[[^]]*\] \)\?\([^ ]*\) bookworm main.*/\2/p; s/^URIs: \([^ ]*\).*/\1/p' \
  /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null | head -1)}

packaging/deb.sh
packaging/check_files.sh
packages=$PWD/build/release/packages

work=$(mktemp -d /tmp/check_deb.XXXXXX)
trap 'rm -rf "$work"' EXIT
for package in "$packages"/*.deb; do dpkg-deb -x "$package" "$work/files"; done
# Not judged: control flow, which any object of a library without it switches off.
find "$work/files" -type f \( -path '*/bin/*' -o -name '*.so*' \) -print0 |
  xargs -0 hardening-check --nocfprotection >"$work/hardening" || {
  cat "$work/hardening" >&2
  exit 1
}

root=$work/root
mmdebstrap --quiet --variant=apt bookworm "$root" "$mirror"
# With a /proc that goes away with the command.
inside() { unshare --mount --pid --fork sh -c 'mount -t proc proc "$0/proc" && exec chroot "$0" "$@"' \
  "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 HOME=/root \
  DEBIAN_FRONTEND=noninteractive "$@"; }
cp /etc/resolv.conf "$root/etc/resolv.conf" 2>/dev/null || true
mkdir "$root/debs"
cp "$packages"/*.deb "$root/debs"
listed() { (cd "$root" && find etc usr opt srv var/lib -xdev ! -path 'var/lib/dpkg/*' \
  ! -path 'var/lib/apt/*' | sort); }
listed >"$work/before"

inside sh -c 'apt-get update -qq && apt-get install -y -qq --no-install-recommends /debs/hogelscope_*.deb' \
  >"$work/apt.log" 2>&1 || { cat "$work/apt.log" >&2; exit 1; }
inside hogelscope --version
inside hogelscope --render --quiet --session /usr/share/hogelscope/samples/table1.hogelscope \
  --output /out
inside hogelscope --render --quiet --session /usr/share/hogelscope/samples/room.hogelscope \
  --output /room
# Loads the codecs.
inside hogelscope --render --quiet --session /usr/share/hogelscope/samples/table1.hogelscope \
  --states 'Fig 4' --format tif --output /codecs
inside hogelscope --plugins
inside hogelscope --plugins | grep -q '^mesh .*/usr/lib/.*hogelscope/plugins-1/mesh$'
build/release/bin/hogelscope --render --quiet --session data/table1.json --output "$work/out"
build/release/bin/hogelscope --render --quiet --session data/room.json --output "$work/room"
diff -r "$work/out" "$root/out"
diff -r "$work/room" "$root/room"
echo "$(find "$work/out" "$work/room" -type f | wc -l) pictures are equal to the build tree's"

installed=hogelscope
if ls "$packages"/python3-hogelscope_*.deb >/dev/null 2>&1; then
  installed="$installed python3-hogelscope python3-vtk9"
  inside sh -c 'apt-get install -y -qq --no-install-recommends /debs/python3-hogelscope_*.deb python3-vtk9' \
    >"$work/apt.log" 2>&1 || { cat "$work/apt.log" >&2; exit 1; }
  cp tests/install/vtk_view.py "$root/vtk_view.py"
  inside python3 /vtk_view.py /usr/share/hogelscope/samples/table1.hogelscope 'Fig 4' '/out/Fig 4.png'
  if [ -d "$root/usr/lib/python3/dist-packages/hogelscope" ]; then
    cp tests/install/ten_lines.py "$root/ten_lines.py"
    inside python3 /ten_lines.py /usr/share/hogelscope/samples/table1.hogelscope
    inside hogelscope --generate scene --session /usr/share/hogelscope/samples/table1.hogelscope \
      --set 'display.hogels=[8,8]' --quiet --output /scene.jpg
    inside python3 -c 'import hogelscope
hogelscope.open("/scene.jpg", "hogels", display={"hogels": [8, 8], "directions": [20, 20]}).array()'
  fi
fi

inside sh -c "apt-get purge -y -qq $installed && apt-get autoremove --purge -y -qq" \
  >"$work/apt.log" 2>&1 || { cat "$work/apt.log" >&2; exit 1; }
listed >"$work/after"
if comm -13 "$work/before" "$work/after" | grep -i hogel; then
  echo "check_deb.sh: apt purge leaves these files" >&2
  exit 1
fi
if inside dpkg-query -W -f='${Package}\n' | grep -i hogel; then exit 1; fi
echo "All is installed, runs, and is gone after apt purge."
