#!/bin/sh
# check_deb.sh [SUITE [MIRROR]]: does in a bare Debian (bookworm, trixie or forky) what the README tells
# newcomers to do. A user with sudo clones the last commit, and runs try.sh and check.sh. A second
# bare Debian gets the packages: renders, compares with tests/scenes, runs Python, builds programs
# and a plugin, removes it all. By hand before a release, as root: about half an hour on two idle
# cores, and 9 GB in /tmp. Installs Debian's mmdebstrap and devscripts.
set -eu
cd "$(dirname "$0")/.."
printf '%s\n' devscripts mmdebstrap | packaging/install.sh /dev/stdin
suite=${1:-bookworm}
mirror=${2:-http://deb.debian.org/debian}
[ -z "$(git status --porcelain)" ] || echo "check_deb.sh: what is not committed is not tried" >&2

work=$(mktemp -d /tmp/check_deb.XXXXXX)
trap 'rm -rf "$work"' EXIT

# bare FOLDER [PACKAGES]
bare() {
  # A mirror's copy of a suite that changes is soon out of date.
  mmdebstrap --quiet --variant=apt --aptopt='Acquire::Check-Valid-Until "false"' \
    ${2:+"--include=$2"} "$suite" "$1" "$mirror"
  cp /etc/resolv.conf "$1/etc/resolv.conf" 2>/dev/null || true
}
fail() { echo "check_deb.sh: $suite: $*" >&2; exit 1; }
# inside FOLDER COMMAND ...: as root there; what it mounts and starts goes away with it.
inside() {
  at=$1
  shift
  # shellcheck disable=SC2016  # words of the inner shell
  unshare --mount --pid --fork sh -c 'mount -t proc proc "$0/proc" &&
    mount -t devpts -o newinstance,ptmxmode=0666 devpts "$0/dev/pts" &&
    mount -t tmpfs tmpfs "$0/dev/shm" && exec chroot "$0" "$@"' \
    "$at" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 HOME=/root \
    DEBIAN_FRONTEND=noninteractive "$@"
}
# step NAME COMMAND ...: its output is shown where it fails.
step() {
  name=$1
  shift
  begin=$(date +%s)
  "$@" >"$work/log" 2>&1 </dev/null || {
    cat "$work/log"
    fail "$name failed"
  }
  echo "$suite: $name: $(($(date +%s) - begin)) s"
}

### What the README says, by a user.
built=$work/built
user=$built/home/maker
step "bare system" bare "$built" git,passwd,sudo
inside "$built" useradd --create-home --shell /bin/sh maker
echo 'maker ALL=(ALL) NOPASSWD: ALL' >"$built/etc/sudoers.d/maker"
git clone --quiet . "$user/hogelscope"
inside "$built" chown -R maker: /home/maker
as_maker() { inside "$built" su - maker -c "cd hogelscope && $1"; }
step try.sh as_maker ./packaging/try.sh
step check.sh as_maker ./packaging/check.sh
grep -E 'tests passed|tests failed|^style.sh|[0-9]+ - .*(Skipped|Failed)' "$work/log" || true
inside "$built" dpkg-query -W | wc -l | sed 's/$/ packages are installed/'
if inside "$built" apt-cache show python3-scikit-build-core >/dev/null 2>&1; then
  step "python packages" inside "$built" apt-get -y -qq --no-install-recommends install \
    python3-pip python3-scikit-build-core python3-venv
  as_maker 'python3 -m venv --system-site-packages ~/venv'
  step "pip install" as_maker '../venv/bin/pip install --no-build-isolation --no-index .'
  inside "$built" su - maker -c "venv/bin/python hogelscope/tests/install/ten_lines.py \
    hogelscope/data/table1.json"
fi
source=$user/hogelscope
packages=$source/build/release/packages

### The packages, on a machine with nothing else.
# Not judged: control flow, which any object of a library without it switches off, and fortified
# functions, of which GCC 14 leaves some plugins none; the test "hardening" reads the flags.
for package in "$packages"/*.deb; do dpkg-deb -x "$package" "$work/files"; done
find "$work/files" -type f \( -path '*/bin/*' -o -name '*.so*' \) -print0 |
  xargs -0 hardening-check --nocfprotection --nofortify >"$work/hardening" || {
  cat "$work/hardening" >&2
  fail "the packages are not hardened"
}
root=$work/root
step "another bare system" bare "$root"
mkdir "$root/debs" "$root/source"
cp "$packages"/*.deb "$root/debs"
git archive HEAD | tar -x -C "$root/source"
listed() { (cd "$root" && find etc usr opt srv var/lib -xdev ! -path 'var/lib/dpkg/*' \
  ! -path 'var/lib/apt/*' | sort); }
listed >"$work/before"
apt() { step "apt-get $*" inside "$root" apt-get -y -qq --no-install-recommends "$@"; }

deb() { echo /debs/"$(basename "$root"/debs/"$1"_*.deb)"; }

apt update
# Jobs alone, then the window.
apt install "$(deb hogelscope)"
if inside "$root" dpkg-query -W -f='${Package}\n' | grep -E '^lib(vtk|qt6widgets)'; then
  fail "the package hogelscope needs libraries of the window"
fi
inside "$root" hogelscope /usr/share/hogelscope/samples/table1.hogelscope 2>"$work/log" || true
grep -q 'package hogelscope-window' "$work/log" || fail "without its package the window: $(cat "$work/log")"
samples=/usr/share/hogelscope/samples
render() { inside "$1" "$2" --render --quiet --session "$3" --output "$4"; }
inside "$root" hogelscope --version
for sample in table1 room; do
  render "$root" hogelscope $samples/$sample.hogelscope /out/$sample
  render "$built" /home/maker/hogelscope/build/release/bin/hogelscope \
    /home/maker/hogelscope/data/$sample.json /out/$sample
done
diff -r "$built/out" "$root/out" || fail "the pictures are not the build tree's"
echo "$(find "$root/out" -type f | wc -l) pictures are equal to the build tree's"
# Loads the codecs.
inside "$root" hogelscope --render --quiet --session $samples/table1.hogelscope --states 'Fig 4' \
  --format tif --output /codecs
inside "$root" hogelscope --plugins | grep '^mesh .*/usr/lib/.*hogelscope/plugins-3/mesh$' ||
  fail "the plugin mesh is not found"
apt install "$(deb hogelscope-window)"
inside "$root" hogelscope 2>"$work/log" || true
grep -q 'no display server' "$work/log" || fail "the window: $(cat "$work/log")"

apt install "$(deb python3-hogelscope)" python3-vtk9
inside "$root" python3 /source/tests/install/vtk_view.py $samples/table1.hogelscope 'Fig 4' \
  '/out/table1/Fig 4.png'
inside "$root" python3 /source/tests/install/ten_lines.py $samples/table1.hogelscope
inside "$root" hogelscope --generate scene --session $samples/table1.hogelscope \
  --set 'display.hogels=[8,8]' --quiet --output /scene.jpg
inside "$root" python3 -c 'import hogelscope
hogelscope.open("/scene.jpg", "hogels", display={"hogels": [8, 8], "directions": [20, 20]}).array()'

apt install "$(deb libhogelscope-dev)" cmake g++ make
set -- cmake -D SOURCE=/source -D PREFIX=/usr -D PROGRAM=/usr/bin/hogelscope -D COMPILER=c++ \
  -D 'GENERATOR=Unix Makefiles'
step "programs in C++" inside "$root" "$@" -D WORK=/consumer \
  -P /source/tests/install/check_consumer.cmake
step "plugins" inside "$root" "$@" -D WORK=/plugins -P /source/tests/plugins/check_out_of_tree.cmake
for scene in "$root"/source/tests/scenes/*.json; do
  scene=$(basename "$scene" .json)
  tolerance=
  # Of Embree, as tests/scenes/CMakeLists.txt has it.
  [ "$scene" != live_room ] || tolerance='-fail;0.004;-failpercent;0.02;-hardfail;0.012;-warn;1'
  step "scene $scene" inside "$root" cmake -D PROGRAM=/usr/bin/hogelscope -D OUTPUT=/scenes/"$scene" \
    -D SESSION=/source/tests/scenes/"$scene".json -D REFERENCE=/source/tests/scenes/"$scene" \
    "-DTOLERANCE=$tolerance" -P /source/tests/scenes/compare.cmake
done

apt purge hogelscope hogelscope-window python3-hogelscope libhogelscope-dev
apt autoremove --purge
listed >"$work/after"
if comm -13 "$work/before" "$work/after" | grep -i hogel; then
  fail "apt purge leaves these files"
fi
if inside "$root" dpkg-query -W -f='${Package}\n' | grep -i hogel; then
  fail "apt purge leaves these packages"
fi
echo "All is installed, runs, and is gone after apt purge."
